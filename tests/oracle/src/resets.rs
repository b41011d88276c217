//! A ball that a `when` throws back, beside its parabolas.

use plm_dynamic::{Integrator, Mechanism};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// A height, a share of the speed that is kept, a method, one interval or many.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let height = draw.number(0.05, 4.0, &[0.5, 1.0, 2.0]);
    let bounce = draw.number(0.1, 1.0, &[0.5, 1.0]);
    let end = draw.rounded(0.2, 2.0);
    let intervals = if draw.chance(0.5) { 1 } else { 2 + draw.below(100) as u32 };
    let method =
        *draw.one_of(&[Integrator::Dop853(1e-9), Integrator::Rk4(1e-3), Integrator::RadauIia5(1e-9)]);
    let text = format!(
        "pub Ball {{
    gravity: 9.81 m/s^2;
    body ball {{ mass: 1 kg; inertia: 1 kg*m^2; start y: {height:?} m, locked; }}
    when ball.y < 0 m {{ ball.vy = -{bounce:?}*ball.vy; }}
    output ball.y, ball.vy;
    allow(W0002);
}}"
    );
    let verdict = run(&text, method, end, intervals).map_or_else(
        |error| Verdict::Stopped(error.to_string()),
        |y| compared(y, closed_form(height, bounce, end)),
    );
    Case {
        family: format!("{method:?}"),
        text: format!("{text}\n{method:?}, {intervals} of {end} s"),
        verdict,
    }
}

fn run(text: &str, method: Integrator, end: f64, intervals: u32) -> Result<f64, plm_dynamic::Error> {
    let mut run = Mechanism::from_text(text)?.start_with(method)?;
    for k in 1..=intervals {
        run.step_to(end * f64::from(k) / f64::from(intervals))?;
    }
    run.output("ball.y")
}

fn compared(y: f64, expected: Option<f64>) -> Verdict {
    let Some(expected) = expected else { return Verdict::Undecided("impacts accumulate".to_owned()) };
    let error = (y - expected).abs() / 1e-5;
    if error <= 1.0 { Verdict::Right(error) } else { Verdict::Wrong(format!("y = {y}, expected {expected}")) }
}

/// The height at a time; none where the impacts have accumulated before it.
fn closed_form(height: f64, bounce: f64, end: f64) -> Option<f64> {
    let g = 9.81;
    let mut from = (2.0 * height / g).sqrt();
    if end <= from {
        return Some(height - g * end * end / 2.0);
    }
    let mut speed = bounce * g * from;
    for _ in 0..1000 {
        let flight = 2.0 * speed / g;
        if end <= from + flight {
            let t = end - from;
            return Some(speed * t - g * t * t / 2.0);
        }
        from += flight;
        speed *= bounce;
    }
    None
}
