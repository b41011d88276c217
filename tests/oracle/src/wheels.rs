//! Belts, chains and gears all round the circle: turned and mirrored, with wheels that are drawn turned or upright, they start as drawn
//! and move as their image on the x axis.

use plm_dynamic::{Integrator, Mechanism, Run};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Numbers agree to this part of their size, which is 1 at least.
const AGREE: f64 = 1e-6;

/// How a wheel is drawn: its angle is left out, is 0, or is turned with the line of centres.
const DRAWN: [&str; 3] = ["left out", "upright", "turned"];

pub(crate) fn case(draw: &mut Draw) -> Case {
    let kind = *draw.one_of(&["elastic_belt", "chain", "slack", "gear", "teeth", "backlash", "ring", "belt"]);
    let (ra, rb) = (draw.number(0.02, 0.1, &[0.05]), draw.number(0.02, 0.2, &[0.05, 0.15]));
    let line = draw.number(-180.0, 360.0, &[0.0, 180.0, 90.0, -90.0, 37.0, 270.0]);
    let drawn = [*draw.one_of(&DRAWN), *draw.one_of(&DRAWN)];
    let placed = draw.chance(0.5);
    let mirrored = draw.chance(0.5);
    let on_arm = draw.chance(0.3);
    let torque = draw.number(0.5, 3.0, &[0.0, 1.0]);
    let machine = Machine { kind, ra, rb, on_arm, torque };
    let base = machine.text(0.0, ["left out"; 2], true, false);
    let text = machine.text(line, drawn, placed, mirrored);
    let verdict = match (run(&base), run(&text)) {
        (Ok(base), Ok(own)) => same(&base, &own, (mirrored, drawn, line)),
        (base, own) => {
            let said = |of: Result<Vec<Run>, String>| of.err().unwrap_or_else(|| "it runs".to_owned());
            Verdict::Wrong(format!("{}; its image: {}", said(own), said(base)))
        }
    };
    let text = format!("{text}\nwheels {}, {}; turned by {line:?} deg", drawn[0], drawn[1]);
    Case { family: kind.to_owned(), text, verdict }
}

struct Machine {
    kind: &'static str,
    ra: f64,
    rb: f64,
    on_arm: bool,
    torque: f64,
}

impl Machine {
    /// The wheels on a line of centres at an angle in deg.
    fn text(&self, line: f64, drawn: [&str; 2], placed: bool, mirrored: bool) -> String {
        let Machine { kind, ra, rb, on_arm, torque } = self;
        let apart = match *kind {
            "gear" | "teeth" | "backlash" => ra + rb,
            "ring" => (ra - rb).abs().max(0.01),
            _ => 0.5,
        };
        let (sin, cos) = line.to_radians().sin_cos();
        let (x, y) = (apart * cos, apart * sin);
        let angle = |drawn: &str| match drawn {
            "turned" => format!("start angle: {line:?} deg;"),
            "upright" => "start angle: 0 deg;".to_owned(),
            _ => String::new(),
        };
        let (a, b) = (angle(drawn[0]), angle(drawn[1]));
        let place = if placed { format!("start x: {x:?} m; start y: {y:?} m;") } else { String::new() };
        let torque = if mirrored { -torque } else { *torque };
        let use_of = match *kind {
            "elastic_belt" => format!(
                "elastic_belt drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; distance: {apart:?} m; stiffness: 2e4 N/m; damping: 20 N*s/m; preload: 200 N; }}"
            ),
            "chain" => format!("chain drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; }}"),
            "slack" => format!(
                "chain drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; slack: 1 mm; distance: {apart:?} m; }}"
            ),
            "teeth" => format!(
                "gear drive(HOLD, a.o, b.o) {{ module: 1 mm; teeth_a: {:?}; teeth_b: {:?}; }}",
                2e3 * ra,
                2e3 * rb
            ),
            "backlash" => format!(
                "gear drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; backlash: 0.2 mm; }}"
            ),
            "ring" => format!("gear drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {:?} m; }}", -rb),
            "belt" => format!(
                "belt drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; preload: 200 N; friction: 0.3; }}"
            ),
            _ => format!("gear drive(HOLD, a.o, b.o) {{ radius_a: {ra:?} m; radius_b: {rb:?} m; }}"),
        };
        // The arm, of zero angle as drawn, holds both bearings and rests on a spring as stiff as is turned.
        let (arm, hold, far) = if *on_arm {
            let arm = format!(
                "body arm {{ mass: 1 kg; inertia: 0.5 kg*m^2; port hub: (0, 0) m; port far: ({x:?}, {y:?}) m; start omega: {:?} rad/s, locked; }}
    revolute pivot(ground.o, arm.hub);",
                if mirrored { -0.5 } else { 0.5 }
            );
            (arm, "arm.hub", "arm.far")
        } else {
            (String::new(), "ground.o", "ground.p")
        };
        format!(
            "pub Wheels {{
    ground {{ port o: (0, 0) m; port p: ({x:?}, {y:?}) m; }}
    {arm}
    body a {{ mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; {a} }}
    body b {{ mass: 3 kg; inertia: 0.02 kg*m^2; port o: (0, 0) m; {place} {b} }}
    revolute one(ground.o, a.o) {{ drive: {torque:?} N*m; }}
    revolute two({far}, b.o) {{ damping: 0.01 N*m*s; }}
    {}
    output drive.torque_a, drive.torque_b;
    allow(W0001);
}}",
            use_of.replace("HOLD", hold)
        )
    }
}

fn run(text: &str) -> Result<Vec<Run>, String> {
    let said = |error: plm_dynamic::Error| error.to_string();
    let mechanism = Mechanism::from_text(text).map_err(|error| error.to_string())?;
    let mut run = mechanism.start_with(Integrator::Dop853(1e-9)).map_err(said)?;
    let mut found = vec![run.clone()];
    for time in [0.02, 0.2] {
        run.step_to(time).map_err(said)?;
        found.push(run.clone());
    }
    Ok(found)
}

/// The wheels turn as those of the image, from where they were drawn.
fn same(base: &[Run], own: &[Run], (mirrored, drawn, line): (bool, [&str; 2], f64)) -> Verdict {
    let sense = if mirrored { -1.0 } else { 1.0 };
    let mut worst = 0.0_f64;
    let mut said = String::new();
    let mut differ = |name: String, expected: f64, found: f64| {
        let off = (expected - found).abs() / AGREE / expected.abs().max(1.0);
        if off.is_nan() || off > worst {
            worst = off;
            said = format!("{name}: {found}, of the image {expected}");
        }
    };
    let angle = |runs: &[Run], k: usize, name: &str| {
        let of = |run: &Run| run.body(name).map_or(f64::NAN, |body| body.angle);
        of(&runs[k]) - of(&runs[0])
    };
    for (name, drawn) in ["a", "b"].into_iter().zip(drawn) {
        let expected = if drawn == "turned" { line.to_radians() } else { 0.0 };
        differ(format!("start of {name}"), expected, own[0].body(name).map_or(f64::NAN, |body| body.angle));
    }
    for k in 0..base.len() {
        let time = base[k].time();
        for name in ["a", "b"] {
            differ(format!("{name} turned at {time} s"), sense * angle(base, k, name), angle(own, k, name));
        }
        for name in ["drive.torque_a", "drive.torque_b"] {
            let of = |run: &Run| run.output(name).unwrap_or(f64::NAN);
            differ(format!("{name} at {time} s"), sense * of(&base[k]), of(&own[k]));
        }
    }
    if worst <= 1.0 { Verdict::Right(worst) } else { Verdict::Wrong(said) }
}
