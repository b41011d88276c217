//! Motions that are prescribed, with friction in every joint, beside inverse dynamics that are written apart.
//!
//! The kinematics are read from the run; forces follow from them by Newton's and Euler's equations. Where a joint does not move, its friction may
//! be anything within its bound, and the balance alone is compared.

mod four_bar;

use plm_dynamic::{Integrator, Mechanism};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Slower than this, m/s or rad/s, a joint may rest: which side its friction has is not compared.
const STILL: f64 = 1e-6;
const GRAVITY: f64 = 9.81;

/// A machine and its motion.
struct Machine {
    family: &'static str,
    /// The declaration, without its motion and formulation.
    text: String,
    /// The names of the outputs that are read.
    outputs: Vec<String>,
    /// How far the outputs are from the balance, as a fraction of the largest force.
    error: Balance,
}

/// How far outputs are from a balance of forces.
type Balance = Box<dyn Fn(&[f64]) -> f64>;

/// A machine, a motion, a method, one interval or many.
pub(crate) fn case(draw: &mut Draw) -> Case {
    let Machine { family, text, outputs, error } = match draw.below(3) {
        0 => rail(draw),
        1 => hinge(draw),
        _ => four_bar::machine(draw),
    };
    let (unit, scale) = if family == "rail" { ("m", 0.5) } else { ("rad", 1.2) };
    let (motion, kind) = motion(draw, unit, scale);
    // A four-bar in absolute coordinates takes minutes where its motion rests.
    let is_absolute = family != "four-bar" && draw.chance(0.3);
    let formulation = if is_absolute { "formulation: absolute;" } else { "" };
    let text = text.replace("MOTION", &motion).replace("FORMULATION", formulation);
    let intervals = if draw.chance(0.3) { 1 } else { 2 + draw.below(30) as u32 };
    let method = *draw.one_of(&[
        Integrator::Dop853(1e-9),
        Integrator::Dopri5(1e-8),
        Integrator::Rk4(1e-2),
        Integrator::RadauIia5(1e-8),
    ]);
    let verdict = run(&text, method, intervals, &outputs, &error)
        .unwrap_or_else(|error| Verdict::Wrong(format!("stopped: {error}")));
    let text = format!("{text}\n{method:?}, {intervals} of {END} s, {kind}");
    Case { family: format!("{family} {kind}"), text, verdict }
}

/// The end of a run, s.
const END: f64 = 2.0;

fn run(
    text: &str,
    method: Integrator,
    intervals: u32,
    outputs: &[String],
    error: &dyn Fn(&[f64]) -> f64,
) -> Result<Verdict, plm_dynamic::Error> {
    let mut run = Mechanism::from_text(text)?.start_with(method)?;
    let mut worst = (0.0, 0.0);
    for k in 0..=intervals {
        if k > 0 {
            run.step_to(END * f64::from(k) / f64::from(intervals))?;
        }
        let found: Vec<f64> = outputs.iter().map(|name| run.output(name)).collect::<Result<_, _>>()?;
        let error = error(&found);
        if error > worst.0 || error.is_nan() {
            worst = (error, run.time());
        }
    }
    let share = worst.0 / 1e-6;
    Ok(if share <= 1.0 {
        Verdict::Right(share)
    } else {
        Verdict::Wrong(format!("off by {:e} of the largest force at {} s", worst.0, worst.1))
    })
}

/// A prescribed motion, by tables most of the time, and its kind.
fn motion(draw: &mut Draw, unit: &str, scale: f64) -> (String, &'static str) {
    let place = |draw: &mut Draw| scale * draw.number(-1.0, 1.0, &[1.0, -1.0, 0.5]);
    let (a, b) = (place(draw), place(draw));
    let start = draw.number(0.05, 0.5, &[0.0, 0.0, 0.2]);
    let end = start + draw.number(0.2, 0.8, &[0.5, 0.25]);
    let table = |points: &[(f64, f64)]| {
        let points: Vec<String> = points.iter().map(|(t, y)| format!("({t:?} s, {y:?} {unit})")).collect();
        format!("smooth_table(t, {})", points.join(", "))
    };
    match draw.below(8) {
        0 => (table(&[(start, 0.0), (end, a)]), "one move"),
        1 => {
            let rest = draw.number(0.01, 0.4, &[0.0, 0.25]);
            let moves =
                [table(&[(start, 0.0), (end, a)]), table(&[(end + rest, 0.0), (end + rest + 0.4, b)])];
            (moves.join(" + "), "rest between")
        }
        2 => {
            let middle = 0.5 * (start + end);
            (table(&[(start, 0.0), (middle, a), (end, draw.number(-0.3, 0.3, &[0.0]) * scale)]), "reversal")
        }
        3 => {
            let rate = draw.number(0.5, 6.0, &[1.0, 3.0]);
            let phase = *draw.one_of(&["0", "90 deg", "180 deg", "37 deg"]);
            let sine = format!("{a:?} {unit}*(cos({rate:?} rad/s*t + {phase}) - cos({phase}))");
            (sine, "vibration")
        }
        4 => {
            (format!("{:?} {unit}/s*t", draw.number(-0.3, 0.3, &[0.0, 1e-3, 0.25]) * scale), "constant speed")
        }
        5 => (table(&[(0.0, 0.0), (1.0, 0.0)]), "rest"),
        6 => {
            let power = *draw.one_of(&["2", "3", "4", "5"]);
            let from = *draw.one_of(&["t/(1 s)", "max(t/(1 s) - 0.5, 0)"]);
            (format!("{:?} {unit}*({from})^{power}", 0.1 * a), "power")
        }
        _ => {
            let (half, whole) = (0.5 * (start + end), end + 0.3);
            (table(&[(start, 0.0), (half, 0.5 * a), (end, a), (whole, a + 0.3 * b)]), "many points")
        }
    }
}

/// By how much a friction is off the law: its bound against the slip, or any force within where its joint rests.
fn friction_error(friction: f64, bound: f64, rate: f64) -> f64 {
    if rate.abs() > STILL {
        (friction + rate.signum() * bound).abs()
    } else {
        (friction.abs() - bound).max(0.0)
    }
}

/// A block on a rail: `drive = m a + F sign v + c v - m g.x`.
fn rail(draw: &mut Draw) -> Machine {
    let mass = draw.number(0.1, 5.0, &[1.0]);
    let seal = draw.number(0.1, 20.0, &[1.0]);
    let damping = draw.number(0.0, 5.0, &[0.0]);
    let turn = draw.number(-180.0, 180.0, &[0.0, 90.0, 180.0, 37.0]);
    let text = format!(
        "pub Rail {{
    FORMULATION
    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m, axis: {turn:?} deg; }}
    body block {{ mass: {mass:?} kg; inertia: 1 kg*m^2; port p: (0, 0) m; start angle: {turn:?} deg; }}
    prismatic rail(ground.o, block.p) {{ seal_friction: {seal:?} N; damping: {damping:?} N*s/m; }}
    constraint motor: rail.displacement = MOTION;
    output v = rail.speed, a = rail.acceleration, drive = -reaction(motor), rail.friction_force;
}}"
    );
    let slope = turn.to_radians().sin();
    let error = move |of: &[f64]| {
        let &[v, a, drive, friction] = of else { return f64::NAN };
        let balance = drive + friction - damping * v - mass * GRAVITY * slope - mass * a;
        let size = mass * (a.abs() + GRAVITY) + seal;
        (balance.abs() + friction_error(friction, seal, v)) / size
    };
    let outputs = ["v", "a", "drive", "rail.friction_force"].map(str::to_owned).to_vec();
    Machine { family: "rail", text, outputs, error: Box::new(error) }
}

/// A lever on a pin that rubs by its reaction.
fn hinge(draw: &mut Draw) -> Machine {
    let mass = draw.number(0.1, 5.0, &[1.0]);
    let arm = draw.number(0.02, 0.5, &[0.1]);
    let inertia = mass * arm * arm * draw.number(0.2, 2.0, &[1.0 / 3.0]);
    let friction = draw.number(0.05, 0.6, &[0.1, 0.3]);
    let radius = draw.number(0.005, 0.02, &[0.01]);
    let text = format!(
        "pub Hinge {{
    FORMULATION
    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m; }}
    body lever {{ mass: {mass:?} kg; inertia: {inertia:?} kg*m^2; port p: ({:?}, 0) m; }}
    revolute pin(ground.o, lever.p) {{ friction: {friction:?}; pin_diameter: {:?} m; }}
    constraint motor: lever.angle = MOTION;
    output lever.angle, lever.omega, lever.alpha, drive = -reaction(motor), pin.friction_torque;
}}",
        -arm,
        2.0 * radius
    );
    let error = move |of: &[f64]| {
        let &[angle, omega, alpha, drive, rubbed] = of else { return f64::NAN };
        let (sin, cos) = angle.sin_cos();
        // The force of the pin is m (a_G - g).
        let x = mass * arm * (-alpha * sin - omega * omega * cos);
        let y = mass * (arm * (alpha * cos - omega * omega * sin) + GRAVITY);
        // The pin is at -arm (cos, sin) from the centre.
        let about_g = arm * (sin * x - cos * y);
        let balance = drive + rubbed + about_g - inertia * alpha;
        let size = mass * arm * GRAVITY + inertia * alpha.abs() + friction * radius * x.hypot(y);
        (balance.abs() + friction_error(rubbed, friction * radius * x.hypot(y), omega)) / size
    };
    let outputs = ["lever.angle", "lever.omega", "lever.alpha", "drive", "pin.friction_torque"]
        .map(str::to_owned)
        .to_vec();
    Machine { family: "hinge", text, outputs, error: Box::new(error) }
}
