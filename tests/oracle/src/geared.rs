//! Geared five-bars whose crank alone is declared and locked: the gear gives the wheel, and two bars close the rest, or do not reach.

use plm_dynamic::{Error, Integrator, Mechanism, Run};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Angles agree to this, rad, and distances of pins, m.
const AGREE: f64 = 1e-8;
/// Bars that reach by less than this part of their length are nearly flat: nothing is asked of them.
const FLAT: f64 = 0.02;

pub(crate) fn case(draw: &mut Draw) -> Case {
    let base = draw.number(0.2, 0.8, &[0.4]);
    let crank = draw.number(0.1, 0.4, &[0.3]);
    let wheel = draw.number(0.1, 0.4, &[0.2]);
    let bars = [draw.number(0.3, 0.8, &[0.5]), draw.number(0.3, 0.8, &[0.5])];
    let ratio = draw.number(0.25, 4.0, &[0.5, 1.0, 2.0]);
    let angle = draw.number(-360.0, 360.0, &[0.0, 90.0, 180.0, 720.0]);
    let locked = draw.chance(0.5);
    let sense = *draw.one_of(&[1.0, -1.0]);
    let lock = if locked { ", locked" } else { "" };
    let given = match draw.below(3) {
        0 => String::new(),
        1 => format!("start angle: {:?} deg;", -sense * ratio * angle),
        _ => format!("start x: {base:?} m;"),
    };
    let text = format!(
        "pub Scene {{
    ground {{ port o: (0, 0) m; port p: ({base:?}, 0) m; }}
    body crank {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({crank:?}, 0) m; start angle: {angle:?} deg{lock}; }}
    body wheel {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({wheel:?}, 0) m; {given} }}
    body link {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({:?}, 0) m; }}
    body arm {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: ({:?}, 0) m; }}
    revolute j0(ground.o, crank.a);
    revolute j1(ground.p, wheel.a);
    revolute j2(crank.b, link.a);
    revolute j3(link.b, arm.b);
    revolute j4(wheel.b, arm.a);
    gear mesh(ground.o, crank.a, wheel.a) {{ radius_a: {:?} m; radius_b: {:?} m; }}
    output crank.angle;
    allow(W0001, W0011, W0010);
}}",
        bars[0],
        bars[1],
        0.1 * ratio,
        0.1 * sense
    );
    let turned = -sense * ratio * angle.to_radians();
    let pins = [
        [crank * angle.to_radians().cos(), crank * angle.to_radians().sin()],
        [base + wheel * turned.cos(), wheel * turned.sin()],
    ];
    let apart = (pins[1][0] - pins[0][0]).hypot(pins[1][1] - pins[0][1]);
    let reach = bars[0] + bars[1] - apart;
    let fold = apart - (bars[0] - bars[1]).abs();
    let margin = FLAT * (bars[0] + bars[1]);
    let found = start(&text);
    let verdict = match found {
        _ if reach.abs() < margin || fold.abs() < margin => Verdict::Undecided("nearly flat".to_owned()),
        Ok(run) if !locked => closed(&run, (sense * ratio, angle.to_radians()), None),
        Ok(run) if reach > 0.0 && fold > 0.0 => {
            closed(&run, (sense * ratio, angle.to_radians()), Some(turned))
        }
        Ok(_) => Verdict::Wrong(format!("the bars do not reach: {reach}, {fold}")),
        Err(error) if locked && (reach < 0.0 || fold < 0.0) => {
            let said = error.to_string();
            if said.contains("E0503") { Verdict::Stopped(said) } else { Verdict::Wrong(said) }
        }
        // A crank that is not locked turns to where the bars reach, if there is such a place.
        Err(error) if !locked && (reach < 0.0 || fold < 0.0) => Verdict::Undecided(error.to_string()),
        Err(error) => Verdict::Wrong(error.to_string()),
    };
    Case { family: if locked { "locked" } else { "free" }.to_owned(), text, verdict }
}

fn start(text: &str) -> Result<Run, Error> {
    Mechanism::from_text(text)?.start_with(Integrator::Rk4(1e-3))
}

/// The gear holds, and no body is wound by more than what is asked of it.
fn closed(run: &Run, (ratio, start): (f64, f64), expected: Option<f64>) -> Verdict {
    let angle = |name: &str| run.body(name).map_or(f64::NAN, |body| body.angle);
    let mesh = ratio * angle("crank") + angle("wheel");
    let worst =
        ["crank", "wheel", "link", "arm"].iter().fold(0.0_f64, |worst, name| worst.max(angle(name).abs()));
    let most = 2.5 * std::f64::consts::TAU + (1.0 + ratio.abs()) * start.abs();
    let is_off = |by: f64| by.is_nan() || by.abs() >= AGREE * worst.max(1.0);
    if is_off(mesh) {
        return Verdict::Wrong(format!("the gear is open by {mesh} rad"));
    }
    if worst > most {
        return Verdict::Wrong(format!("a body is turned to {worst} rad"));
    }
    match expected {
        Some(wheel) if is_off(angle("wheel") - wheel) => {
            Verdict::Wrong(format!("the wheel is at {}, expected {wheel}", angle("wheel")))
        }
        _ => Verdict::Right(mesh.abs() / AGREE),
    }
}
