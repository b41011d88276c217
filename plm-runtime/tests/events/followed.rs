//! Loops that are solved by iteration: an unknown that is not where its rates have taken it is another solution.

use plm_runtime::charts::{self, Charted, ContinuationData, Iterated, OfLoops, Reach, update};
use plm_runtime::{Cause, Constraints, Events, Fault, Health, Held, Labels, Rate};

/// A crank at the angle x turns a link to the angle 2 x, or, where the iteration is led astray, elsewhere.
#[derive(Clone, Copy, Debug)]
struct Link {
    /// How far from its solution the iteration ends, rad.
    astray: f64,
    /// The measure of the loop.
    measure: f64,
}

/// The crank is the coordinate, the link is followed.
type Continuation = charts::Continuation<f64, 1, 0, 1, 1>;
type Bound = Held<(), (), [i32; 0], OfLoops<Continuation, [f64; 1]>>;

fn held(continuation: Continuation) -> Bound {
    Held {
        input: (),
        switches: (),
        turns: [],
        of_loops: OfLoops::InChart { chart: 0, continuation },
        contact: (),
    }
}

/// The link as it is remembered.
fn link_of(held: &Bound) -> Iterated<f64> {
    match held.of_loops {
        OfLoops::InChart { continuation, .. } => continuation.iterated[0],
        OfLoops::Free { .. } => panic!("no chart: {held:?}"),
    }
}

impl Rate for Link {
    type S = f64;
    type X = [f64; 2];
    type U = Bound;
    const NQ: usize = 1;

    fn rate(&self, _t: f64, _u: &Self::U, x: &[f64; 2], dx: &mut [f64; 2]) -> Health<f64> {
        *dx = [x[1], 0.0];
        Health::perfect()
    }
}

impl Constraints for Link {}

impl Events for Link {
    type G = [f64; 0];
}

impl Labels for Link {}

impl Charted for Link {
    type Input = ();
    type Switches = ();
    type Turns = [i32; 0];
    type Contact = ();
    type Continuation = Continuation;
    type Q = [f64; 1];
    const CHARTS: charts::Charts = charts::Charts {
        count: 1,
        revolutions: &[],
        is_loose: false,
        turning: &[],
        found: &[],
        iterated: &["link"],
        closing: &[&["pin"]],
    };

    fn pose(&self, _t: f64, _held: &Self::U, x: &[f64; 2]) -> ([f64; 1], [f64; 1], f64) {
        ([x[0]], [x[1]], self.measure * self.measure)
    }
    fn continuation(&self, t: f64, _held: &Self::U, x: &[f64; 2]) -> (Continuation, f64) {
        // Nothing but the link limits how far it may go.
        let far = |last: f64| Reach { last, reach: 1e3 };
        let link = Iterated { value: 2.0 * x[0] + self.astray, rate: 2.0 * x[1], bend: 0.0 };
        let continuation = Continuation {
            coordinates: [far(x[0])],
            time: far(t),
            angles: [],
            determinants: [self.measure],
            iterated: [link],
        };
        (continuation, self.measure * self.measure)
    }
    fn continuation_at(&self, _chart: usize, t: f64, q: &[f64; 1], v: &[f64; 1]) -> (Continuation, f64) {
        self.continuation(t, &held(Continuation::nothing()), &[q[0], v[0]])
    }
    fn to_chart(&self, _chart: usize, _t: f64, q: &[f64; 1], v: &[f64; 1], x: &mut [f64; 2]) {
        *x = [q[0], v[0]];
    }
}

/// A step of 0.1 s at 3 rad/s whose iteration ends so far from its solution.
fn stepped(astray: f64, measure: f64) -> Result<Bound, Fault> {
    let mut x = [0.5, 3.0];
    let (continuation, _) =
        Link { astray: 0.0, measure }.continuation(0.0, &held(Continuation::nothing()), &x);
    let mut held = held(continuation);
    x[0] += 0.3;
    update(&Link { astray, measure }, 0.1, &mut held, &mut x)?;
    Ok(held)
}

#[test]
fn an_unknown_that_leaves_its_rates_is_refused() {
    for measure in [0.8, 0.4] {
        // Other solutions are at least about twice the measure away; a quarter of it is what may be off.
        for off in [0.0, 0.2, -0.2] {
            let held = stepped(off * measure, measure).unwrap();
            assert!((link_of(&held).value - (1.6 + off * measure)).abs() < 1e-15, "{measure}: {held:?}");
        }
        for off in [0.3, -0.3, 2.0, -2.0, f64::NAN] {
            let fault = stepped(off * measure, measure).unwrap_err();
            let expected = if off.is_nan() { "pin" } else { "link" };
            assert!(
                matches!(fault.cause, Cause::TurnedTooFar { .. } | Cause::Locked),
                "{measure}, {off}: {fault}"
            );
            assert_eq!((fault.part, fault.time), (expected, 0.1), "{measure}, {off}: {fault}");
        }
    }
}

/// From 3 to 3.6 rad/s within 0.1 s, the link at twice that: half its angular acceleration is 6 rad/s^2.
#[test]
fn the_rate_of_a_rate_is_remembered() {
    let link = Link { astray: 0.0, measure: 0.8 };
    let (continuation, _) = link.continuation(0.0, &held(Continuation::nothing()), &[0.5, 3.0]);
    let mut held = held(continuation);
    update(&link, 0.1, &mut held, &mut [0.83, 3.6]).unwrap();
    assert!((link_of(&held).bend - 6.0).abs() < 1e-13, "{held:?}");
}
