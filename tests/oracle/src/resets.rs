//! A point that a `when` throws back from a floor, beside its parabolas.
//!
//! Methods with dense output end at the impacts. Steps of equal length go beyond each by up to their length, d: its speed is larger by g d,
//! the next flight begins below the floor by v d, and so on. These are propagated to first order from flight to flight ([`Errors`]). What
//! flies lower than that is at the floor. It sinks there by less than g d/2 in each step that throws it back, by g d in one second.

use plm_dynamic::{Integrator, Mechanism};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

const G: f64 = 9.81;
/// The step of the explicit methods that have one, s, and of the implicit ones, which take longer.
const STEP: f64 = 2e-3;
const IMPLICIT_STEP: f64 = 5e-3;
/// A method with error control errs by less, in m.
const LEAST: f64 = 1e-5;
/// So near to the end of all flights, s, either is right: a place or a fault.
const NEAR: f64 = 1e-5;

/// Steps of equal length are followed for so long after it, s.
const LONGEST_REST: f64 = 0.2;

const METHODS: [Integrator; 9] = [
    Integrator::Dop853(1e-9),
    Integrator::Dopri5(1e-9),
    Integrator::Vern9(1e-9),
    Integrator::RadauIia5(1e-9),
    Integrator::Adams(1e-9),
    Integrator::Rk4(STEP),
    Integrator::SemiImplicitEuler(STEP),
    Integrator::Gauss2(IMPLICIT_STEP),
    Integrator::Ros34Pw2(IMPLICIT_STEP),
];

/// A point that is thrown back: where it starts above the floor, m, the share of the speed that it keeps, and when it is asked for, s.
struct Throw {
    height: f64,
    kept: f64,
    end: f64,
}

/// A height above a floor, a share of the speed that is kept, a way to write it, a method, one interval or many.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let mut throw = Throw {
        height: draw.number(0.05, 4.0, &[0.0, 0.5, 1.0, 2.0]),
        kept: draw.number(0.1, 1.0, &[0.5, 0.9, 1.0]),
        end: draw.rounded(0.2, 2.0),
    };
    let floor = draw.number(-2.0, 2.0, &[0.0, 0.0, 1.0]);
    let intervals = if draw.chance(0.5) { 1 } else { 2 + draw.below(100) as u32 };
    let method = *draw.one_of(&METHODS);
    if late(method).is_some() {
        throw.end = throw.end.min(throw.accumulates() + LONGEST_REST);
    }
    let (text, output) = declared(&throw, floor, draw.below(4));
    let verdict = match run(&text, output, method, (throw.end, intervals)) {
        Ok(y) => compared(y - floor, &throw, method),
        Err(error) => stopped(&error.to_string(), &throw, method),
    };
    Case {
        family: format!("{method:?}"),
        text: format!("{text}\n{method:?}, {intervals} of {} s", throw.end),
        verdict,
    }
}

/// The declaration, and the output that is its place.
fn declared(throw: &Throw, floor: f64, law: usize) -> (String, &'static str) {
    let Throw { height, kept, .. } = throw;
    let start = floor + height;
    let (items, output) = match law {
        0 | 1 => {
            let falls = if law == 0 { "" } else { " and ball.vy < 0 m/s" };
            let items = format!(
                "    gravity: 9.81 m/s^2;
    body ball {{ mass: 1 kg; inertia: 1 kg*m^2; start y: {start:?} m, locked; }}
    when ball.y < {floor:?} m{falls} {{ ball.vy = -{kept:?}*ball.vy; }}"
            );
            (items, "ball.y")
        }
        2 => {
            let items = format!(
                "    body dummy {{ mass: 1 kg; inertia: 1 kg*m^2; }}
    state y: m = {start:?} m;
    state w: m/s = 0 m/s;
    rate y = w;
    rate w = -9.81 m/s^2;
    when y < {floor:?} m {{ w = -{kept:?}*w; }}"
            );
            (items, "y")
        }
        _ => {
            let items = format!(
                "    gravity: 9.81 m/s^2*(-1, 0);
    ground {{ port foot: (0, 0) m; }}
    body block {{ mass: 1 kg; inertia: 1 kg*m^2; port sole: (0, 0) m; start x: {start:?} m, locked; }}
    prismatic track(ground.foot, block.sole);
    when track.displacement < {floor:?} m {{ block.vx = -{kept:?}*block.vx; }}"
            );
            (items, "track.displacement")
        }
    };
    (format!("pub Thrown {{\n{items}\n    output {output};\n    allow(W0002);\n}}"), output)
}

fn run(
    text: &str,
    output: &str,
    method: Integrator,
    (end, intervals): (f64, u32),
) -> Result<f64, plm_dynamic::Error> {
    let mut run = Mechanism::from_text(text)?.start_with(method)?;
    for k in 1..=intervals {
        run.step_to(end * f64::from(k) / f64::from(intervals))?;
    }
    run.output(output)
}

/// By how much the impacts of a method may be late, s; none of one that ends its steps there. The semi-implicit Euler method errs by
/// -g h t/2 in a flight besides, which is an impact of half a step less.
fn late(method: Integrator) -> Option<f64> {
    match method {
        Integrator::Rk4(h) | Integrator::Gauss2(h) | Integrator::Ros34Pw2(h) => Some(h),
        Integrator::SemiImplicitEuler(h) => Some(2.0 * h),
        _ => None,
    }
}

fn stopped(why: &str, throw: &Throw, method: Integrator) -> Verdict {
    let is_zeno = why.contains("without end") && late(method).is_none();
    if is_zeno && throw.accumulates() <= throw.end + NEAR {
        Verdict::Stopped(why.to_owned())
    } else {
        Verdict::Wrong(why.to_owned())
    }
}

fn compared(y: f64, throw: &Throw, method: Integrator) -> Verdict {
    let (expected, bound) = match late(method) {
        Some(late) => throw.by_steps(late),
        None if throw.accumulates() <= throw.end - NEAR => {
            return Verdict::Wrong(format!("y = {y}, after the end of all flights"));
        }
        None => (throw.flown(|_, _| true).map_or(0.0, |flight| flight.place), LEAST),
    };
    let share = (y - expected).abs() / bound;
    if share <= 1.0 {
        Verdict::Right(share)
    } else {
        Verdict::Wrong(format!("y = {y}, expected {expected} to {bound:.1e} m"))
    }
}

/// The flight at a time.
struct Flight {
    /// When it began, s; after an impact of this speed, m/s, zero of the first.
    from: f64,
    struck: f64,
    /// Above the floor, m.
    place: f64,
}

/// First-order errors of steps that end up to `late` after each impact: of the speed of an impact, m/s, and of its time, s.
struct Errors {
    late: f64,
    speed: f64,
    time: f64,
}

impl Errors {
    /// After a flight that an impact of the speed `struck` begins: s' = e (v + g d) from the depth v d comes down with s + e g d - g d/e.
    fn fly(&mut self, kept: f64) {
        let Self { late, speed, time } = *self;
        self.time = time + late * (1.0 + 2.0 * kept + 1.0 / kept) + 2.0 * kept * speed / G;
        self.speed = kept * speed + G * late * (kept + 1.0 / kept);
    }

    /// Is a flight after an impact of this speed so high that these are small beside it?
    fn are_small(&self, struck: f64, kept: f64) -> bool {
        let leaves = kept * struck;
        10.0 * struck * self.late <= leaves * leaves / (2.0 * G) && 10.0 * self.speed <= struck
    }
}

impl Throw {
    /// When flights have become infinitely short, s.
    fn accumulates(&self) -> f64 {
        let fall = (2.0 * self.height / G).sqrt();
        if fall > 0.0 { fall * (1.0 + self.kept) / (1.0 - self.kept) } else { 0.0 }
    }

    /// The flight at the end, while each one that begins by an impact, of which number and speed are given, is one of those that are
    /// followed.
    fn flown(&self, mut follows: impl FnMut(u32, f64) -> bool) -> Option<Flight> {
        let Self { height, kept, end } = *self;
        let mut from = (2.0 * height / G).sqrt();
        if end <= from {
            return Some(Flight { from: 0.0, struck: 0.0, place: height - G * end * end / 2.0 });
        }
        let mut struck = G * from;
        for number in 0..10_000 {
            if !follows(number, struck) {
                return None;
            }
            let (leaves, t) = (kept * struck, end - from);
            let flight = 2.0 * leaves / G;
            if t <= flight {
                return Some(Flight { from, struck, place: leaves * t - G * t * t / 2.0 });
            }
            from += flight;
            struck = leaves;
        }
        None
    }

    /// The place by steps of equal length, and how far from it they may come, m.
    fn by_steps(&self, late: f64) -> (f64, f64) {
        let Self { kept, end, .. } = *self;
        let mut errors = Errors { late, speed: 0.0, time: 0.0 };
        let mut last = (2.0 * self.height / G).sqrt() * G;
        let flight = self.flown(|number, struck| {
            if number > 0 {
                errors.fly(kept);
            }
            last = struck;
            errors.are_small(struck, kept)
        });
        let Some(Flight { from, struck, place }) = flight else {
            // Twice as high as the first flight that is not followed, and as deep as it sinks.
            let highest = (kept * last + G * late).powi(2) / G;
            return (0.0, highest + 2.0 * last * late + G * late * end + LEAST);
        };
        if struck == 0.0 {
            return (place, G * late * end + LEAST);
        }
        let t = end - from;
        let first_order = struck * late + kept * (G * late + errors.speed) * t;
        errors.fly(kept);
        (place, 2.0 * (first_order + 2.0 * struck * (errors.time + late)) + LEAST)
    }
}
