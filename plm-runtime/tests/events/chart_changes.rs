//! Which chart is held where, and when it is looked at again: a bead on a circle, by one of its coordinates.

use plm_runtime::charts::{
    self, Charted, ContinuationData, OfLoops, Reach, are_calm, are_short, crossed, enter, full, hold,
    is_calm, is_free, look, pose, update,
};
use plm_runtime::held::{Held, Loops};
use plm_runtime::{Cause, Constraints, Events, Health, Labels, Rate, Step};

/// A bead on the circle of radius 1 m: by its y in chart 0, by its x in chart 1. The measure of a chart is the size of the other
/// coordinate.
#[derive(Clone, Copy, Debug)]
struct Bead {
    /// By this factor all measures are less.
    poorer: f64,
}

/// How far the bead may move without a look, m.
const REACH: f64 = 0.01;
/// How long it may go without one, s.
const WHILE: f64 = 0.3;

/// The area is the other coordinate.
type Continuation = charts::Continuation<f64, 1, 0, 1, 0>;
type Bound = Held<(), (), [i32; 0], OfLoops<Continuation, [f64; 2]>>;

fn continuation(coordinate: f64, t: f64, other: f64) -> Continuation {
    let coordinates = [Reach { last: coordinate, reach: REACH }];
    Continuation {
        coordinates,
        time: Reach { last: t, reach: WHILE },
        determinants: [other],
        ..Continuation::nothing()
    }
}

fn in_chart(chart: usize, continuation: Continuation) -> Bound {
    Held {
        input: (),
        switches: (),
        turns: [],
        of_loops: OfLoops::InChart { chart, continuation },
        contact: (),
    }
}

/// The chart and what is remembered.
fn within(held: &Bound) -> (usize, Continuation) {
    match held.of_loops {
        OfLoops::InChart { chart, continuation } => (chart, continuation),
        OfLoops::Free { .. } => panic!("no chart: {held:?}"),
    }
}

fn chart(held: &Bound) -> Option<usize> {
    Loops::<f64>::chart(&held.of_loops)
}

impl Rate for Bead {
    type S = f64;
    type X = [f64; 3];
    type U = Bound;
    const NQ: usize = 1;

    fn rate(&self, _t: f64, _u: &Bound, _x: &[f64; 3], _dx: &mut [f64; 3]) -> Health<f64> {
        Health::perfect()
    }
}

impl Constraints for Bead {}

impl Events for Bead {
    type G = [f64; 0];
}

impl Labels for Bead {}

impl Charted for Bead {
    type Input = ();
    type Switches = ();
    type Turns = [i32; 0];
    type Contact = ();
    type Continuation = Continuation;
    type Q = [f64; 2];
    const CHARTS: charts::Charts = charts::Charts {
        count: 2,
        revolutions: &[],
        is_loose: false,
        turning: &[],
        found: &[],
        iterated: &[],
        closing: &[&["ring"], &["hoop"]],
    };

    fn pose(&self, _t: f64, held: &Bound, x: &[f64; 3]) -> ([f64; 2], [f64; 2], f64) {
        let (chart, continuation) = match held.of_loops {
            OfLoops::InChart { chart, continuation } => (chart, continuation),
            OfLoops::Free { q, v } => return (q, v, 0.0),
        };
        let square = 1.0 - x[0] * x[0];
        let other = square.sqrt().copysign(continuation.determinants[0]);
        let (mut q, mut v) = ([other, x[0]], [-x[0] * x[1] / other, x[1]]);
        if chart == 1 {
            (q, v) = ([q[1], q[0]], [v[1], v[0]]);
        }
        (q, v, self.poorer * self.poorer * square)
    }
    fn continuation(&self, t: f64, held: &Bound, x: &[f64; 3]) -> (Continuation, f64) {
        let (q, _, measure) = self.pose(t, held, x);
        (continuation(x[0], t, q[within(held).0]), measure)
    }
    fn continuation_at(&self, chart: usize, t: f64, q: &[f64; 2], _v: &[f64; 2]) -> (Continuation, f64) {
        (continuation(q[1 - chart], t, q[chart]), (self.poorer * q[chart]).powi(2))
    }
    fn to_chart(&self, chart: usize, _t: f64, q: &[f64; 2], v: &[f64; 2], x: &mut [f64; 3]) {
        (x[0], x[1]) = (q[1 - chart], v[1 - chart]);
    }
}

/// A state at 2 rad/s, with one of first order that is 5.
fn entered(poorer: f64, degrees: f64) -> (Bead, Bound, [f64; 3]) {
    let (bead, mut held, mut x) = (Bead { poorer }, in_chart(0, Continuation::nothing()), [0.0, 0.0, 5.0]);
    let (q, v) = on_circle(degrees);
    enter(&bead, 0.0, &mut held, (&q, &v), &mut x);
    (bead, held, x)
}

fn on_circle(degrees: f64) -> ([f64; 2], [f64; 2]) {
    let (sin, cos) = degrees.to_radians().sin_cos();
    ([cos, sin], [-2.0 * sin, 2.0 * cos])
}

/// Is it where it was put, and as fast? A few roundings, over a measure above 0.2.
fn is_at(bead: Bead, (held, x): (&Bound, &[f64; 3]), degrees: f64) {
    let (q, v) = on_circle(degrees);
    let state: [f64; 5] = full(&bead, 0.0, held, x);
    for (found, wanted) in state.into_iter().zip([q[0], q[1], v[0], v[1], 5.0]) {
        assert!((found - wanted).abs() < 1e-14, "{degrees} deg, {held:?}: {state:?}");
    }
}

#[test]
fn the_first_chart_is_entered_unless_it_is_flat() {
    // 0.3 = cos 72.54 deg.
    for (degrees, chart) in
        [(10.0, 0), (72.4, 0), (72.7, 1), (90.0, 1), (107.3, 1), (107.6, 0), (200.0, 0), (-89.0, 1)]
    {
        let (bead, held, x) = entered(1.0, degrees);
        assert_eq!(within(&held).0, chart, "{degrees} deg");
        is_at(bead, (&held, &x), degrees);
    }
    // The least of a good chart is 0.03.
    for (poorer, free) in [(0.031, false), (0.029, true)] {
        let (bead, held, x) = entered(poorer, 90.0);
        assert_eq!(is_free::<Bead>(&held), free, "{poorer}");
        is_at(bead, (&held, &x), 90.0);
    }
}

#[test]
fn a_state_within_its_box_is_calm() {
    let (bead, held, x) = entered(1.0, 30.0);
    for (part, calm) in [(0.0, true), (0.9, true), (-0.9, true), (1.1, false), (-1.1, false)] {
        let moved = [x[0] + part * REACH, x[1], x[2]];
        let expected = (calm, f64::from(u8::from(calm)));
        assert_eq!(both_calm(bead, 0.0, &held, &moved), expected, "{part} of the reach");
        assert_eq!(both_calm(bead, part * WHILE, &held, &x), expected, "{part} of the time");
        assert!((in_step(bead, &held, 0.1, [&x, &moved]) - part.abs()).abs() < 1e-12, "{part} of the reach");
    }
    let (chart, mut continuation) = within(&held);
    continuation.coordinates[0].reach = 0.031;
    let wide = in_chart(chart, continuation);
    // A box of a thirtieth of what is typical is not tight.
    assert_eq!(in_step(bead, &wide, 0.1, [&x, &[x[0] + 0.04, x[1], x[2]]]), 0.0);
}

/// A coordinate of constant acceleration that ends where it began, or beyond: it has gone v^2/(2 a) until it turned back.
#[test]
fn a_coordinate_that_turns_back_has_gone_there_and_back() {
    let (bead, held, x) = entered(1.0, 30.0);
    let ends = |v0: f64, v1: f64, dt: f64| [[x[0], v0, x[2]], [x[0] + 0.5 * (v0 + v1) * dt, v1, x[2]]];
    for (v0, v1, dt) in [(1.0, -1.0, 0.01), (-1.0, 1.0, 0.01), (-0.5, 2.0, 0.01), (2.0, -0.5, 0.02)] {
        let [before, after] = ends(v0, v1, dt);
        let acceleration = (v1 - v0).abs() / dt;
        let way = v0.abs().max(v1.abs()).powi(2) / (2.0 * acceleration);
        let found = in_step(bead, &held, dt, [&before, &after]) * REACH;
        assert!((found - way).abs() < 1e-12, "{v0} to {v1}: {found}, {way}");
    }
    // One that comes to rest, or leaves it, has gone as far as its ends are apart.
    let [before, after] = ends(1.0, 0.0, 0.01);
    assert!((in_step(bead, &held, 0.01, [&before, &after]) * REACH - 0.005).abs() < 1e-12);
}

/// The part of a box that a step of this length crosses.
fn in_step(bead: Bead, held: &Bound, dt: f64, [before, x]: [&[f64; 3]; 2]) -> f64 {
    crossed(&Step { system: &bead, held, from: (0.0, before), to: (dt, x), health: 1.0 })
}

/// Whether there is nothing to look at, by the functions of one state and of several.
fn both_calm(bead: Bead, t: f64, held: &Bound, x: &[f64; 3]) -> (bool, f64) {
    let side_by_side = are_calm::<Bead, f64, _>(&bead.typical(), t, &held.of_loops, x);
    (is_calm(&bead, t, held, x), side_by_side)
}

#[test]
fn two_boxes_are_calm_where_neither_is_tight() {
    let (bead, held, x) = entered(1.0, 30.0);
    let (chart, mut continuation) = within(&held);
    for (reach, boxes) in [(0.01, 1.0), (0.0599, 1.0), (0.0601, 2.0), (0.1, 2.0)] {
        continuation.coordinates[0].reach = reach;
        let held = in_chart(chart, continuation);
        for (part, calm) in
            [(0.99, (true, 1.0)), (-0.99, (true, 1.0)), (1.01, (false, 0.0)), (-1.01, (false, 0.0))]
        {
            let moved = [x[0] + part * boxes * reach, x[1], x[2]];
            assert_eq!(both_calm(bead, 0.0, &held, &moved), calm, "{part} of {boxes} of {reach}");
        }
    }
}

#[test]
fn steps_in_tight_boxes_are_short_up_to_a_fifth() {
    let (bead, held, x) = entered(1.0, 30.0);
    let (chart, mut continuation) = within(&held);
    for (reach, part, short) in
        [(0.01, 0.19, 1.0), (0.01, 0.21, 0.0), (0.029, -0.21, 0.0), (0.031, 5.0, 1.0), (0.01, f64::NAN, 0.0)]
    {
        continuation.coordinates[0].reach = reach;
        let held = in_chart(chart, continuation);
        let moved = [x[0] + part * reach, x[1], x[2]];
        let found = are_short::<Bead, f64, _>(&bead.typical(), &held.of_loops, [&x, &moved]);
        assert_eq!(found, short, "{part} of {reach}");
    }
}

/// A look of several states does what `update` does, or nothing.
#[test]
fn looks_side_by_side_are_those_of_one_state() {
    let mut plain = 0;
    for degrees in [10.0, 30.0, 70.0, 72.7] {
        for boxes in [1.5, 6.9, 7.1, -3.0, f64::NAN] {
            for t in [0.01, 6.9 * WHILE, 7.1 * WHILE] {
                let (bead, held, mut x) = entered(1.0, degrees);
                x[0] += boxes * REACH;
                let (mut alone, mut moved) = (held, x);
                let accepted = update(&bead, t, &mut alone, &mut moved);
                let mut together = held;
                let (continuation, measure) = bead.continuation(t, &held, &x);
                let due = |due: f64, of_loops: &mut _| {
                    look::<Bead, f64, _>(of_loops, &x, (&continuation, measure), due)
                };
                assert_eq!(due(0.0, &mut together.of_loops), 0.0);
                assert_eq!(together, held);
                let found = due(1.0, &mut together.of_loops);
                let unmoved = accepted == Ok(plm_runtime::Updated::default());
                let far = measure > 0.3 * 0.3;
                assert_eq!(found == 1.0, unmoved && far, "{degrees} deg, {boxes} boxes, {t} s: {accepted:?}");
                assert_eq!(together, if found == 1.0 { alone } else { held });
                plain += usize::from(found == 1.0);
            }
        }
    }
    assert!((5..50).contains(&plain), "{plain}");
}

#[test]
fn a_step_of_some_boxes_is_looked_at_and_a_longer_one_refused() {
    for (boxes, kept) in
        [(0.9, None), (1.1, Some(true)), (-6.9, Some(true)), (7.1, Some(false)), (-7.1, Some(false))]
    {
        for by_time in [false, true] {
            let (bead, mut held, mut x) = entered(1.0, 30.0);
            let before = within(&held).1;
            let t = if by_time { boxes * WHILE } else { 0.0 };
            x[0] += if by_time { 0.0 } else { boxes * REACH };
            let looked = continuation(x[0], t, (1.0 - x[0] * x[0]).sqrt());
            match (update(&bead, t, &mut held, &mut x), kept) {
                (Ok(accepted), None) => assert!(!accepted.moved && within(&held).1 == before, "{boxes}"),
                (Ok(accepted), Some(true)) => {
                    assert!(!accepted.moved && within(&held).1 == looked, "{boxes}: {held:?}");
                }
                (Err(fault), Some(false)) => {
                    assert!(
                        matches!(fault.cause, Cause::TurnedTooFar { .. }) && fault.part == "ring",
                        "{fault}"
                    );
                    assert_eq!(within(&held).1, before);
                }
                (found, _) => panic!("{boxes} boxes: {found:?}"),
            }
        }
    }
}

#[test]
fn what_cannot_be_closed_is_locked() {
    let (bead, mut held, mut x) = entered(1.0, 80.0);
    x[0] = 1.001;
    let fault = update(&bead, 0.1, &mut held, &mut x).unwrap_err();
    assert!(matches!(fault.cause, Cause::Locked) && fault.time == 0.1 && fault.part == "hoop", "{fault}");
}

/// The state in chart 0 at an angle, last looked at 1 degree before.
fn moved_to(poorer: f64, degrees: f64) -> (Bead, Bound, [f64; 3]) {
    let (bead, _, mut x) = entered(poorer, degrees);
    let ((q, v), (before, _)) = (on_circle(degrees), on_circle(degrees - 1.0));
    let held = in_chart(0, continuation(before[1], 0.0, before[0]));
    bead.to_chart(0, 0.0, &q, &v, &mut x);
    (bead, held, x)
}

#[test]
fn a_flat_chart_is_left_for_one_that_is_better_by_far() {
    for (poorer, degrees, wanted) in [
        (1.0, 30.0, Some(0)),
        (1.0, 72.0, Some(0)),
        (1.0, 74.0, Some(1)),
        // Flat, but the other one is not twice as good: tan 60 deg = 1.7, tan 65 deg = 2.1.
        (0.5, 60.0, Some(0)),
        (0.5, 65.0, Some(1)),
        // None is good: 0.03 is the least.
        (0.04, 45.0, None),
        (0.044, 45.0, Some(0)),
    ] {
        let (bead, mut held, mut x) = moved_to(poorer, degrees);
        let accepted = update(&bead, 2.0 * WHILE, &mut held, &mut x).unwrap();
        assert_eq!((chart(&held), accepted.moved), (wanted, wanted != Some(0)), "{poorer}, {degrees} deg");
        is_at(bead, (&held, &x), degrees);
    }
}

#[test]
fn without_a_chart_one_is_taken_that_is_clearly_good() {
    // 1.3 times 0.03 is 0.039.
    for (poorer, degrees, wanted) in [
        (1.0, 20.0, Some(0)),
        (1.0, 70.0, Some(1)),
        (0.038, 90.0, None),
        (0.04, 90.0, Some(1)),
        (0.04, 0.0, Some(0)),
    ] {
        let (q, v) = on_circle(degrees);
        let (bead, mut held, mut x) =
            (Bead { poorer }, in_chart(0, Continuation::nothing()), [1.0, 2.0, 3.0]);
        hold::<Bead, 5>(&mut held, &mut x, &[q[0], q[1], v[0], v[1], 5.0]);
        assert!(is_free::<Bead>(&held) && !is_calm(&bead, 0.0, &held, &x));
        assert_eq!(pose(&bead, 0.0, &held, &x), (q, v));
        let accepted = update(&bead, 0.0, &mut held, &mut x).unwrap();
        assert_eq!((chart(&held), accepted.moved), (wanted, wanted.is_some()), "{poorer}, {degrees} deg");
        is_at(bead, (&held, &x), degrees);
    }
}
