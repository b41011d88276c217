//! Scenes that took time without bound, or stopped although they could go on: masses that strike each other and go on side by side, light
//! pulleys, directions of what is at rest, stairs by fixed steps.

use std::time::Instant;

use plm_dynamic::{Error, Integrator, Mechanism, Run};

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// No case takes so long in a build without optimisation, s: they take a tenth of it at most.
const LONGEST: f64 = 30.0;
/// A step, made or refused, for each event, and for each period of the motion.
const STEPS: [f64; 2] = [20.0, 400.0];

/// A scene with its text and what is known of it.
struct Scene {
    family: &'static str,
    text: String,
    method: Integrator,
    end: f64,
    judge: Judge,
}

type Judge = Box<dyn Fn(&Run) -> Result<Verdict, Error>>;

pub(crate) fn case(draw: &mut Draw) -> Case {
    let scene = match draw.below(5) {
        0 => masses(draw),
        1 => cradle(draw),
        2 => pulley(draw),
        3 => direction(draw),
        _ => stairs(draw),
    };
    let begin = Instant::now();
    let verdict = judged(&scene).unwrap_or_else(|error| Verdict::Wrong(format!("stopped: {error}")));
    let took = begin.elapsed().as_secs_f64();
    let verdict = if took > LONGEST { Verdict::Wrong(format!("took {took:.0} s")) } else { verdict };
    let text = format!("{}\n{:?} to {} s", scene.text, scene.method, scene.end);
    Case { family: scene.family.to_owned(), text, verdict }
}

fn judged(scene: &Scene) -> Result<Verdict, Error> {
    let mut run = Mechanism::from_text(&scene.text)?.start_with(scene.method)?;
    run.step_to(scene.end)?;
    let (stats, [of_events, of_time]) = (run.stats(), STEPS);
    let made = (stats.steps + stats.rejected) as f64;
    let allowed = of_events * stats.switches as f64 + of_time * (1.0 + scene.end);
    let is_fixed = matches!(scene.method, Integrator::Rk4(_));
    if made > allowed && !is_fixed {
        return Ok(Verdict::Wrong(format!("{made} steps for {} events", stats.switches)));
    }
    (scene.judge)(&run)
}

fn method(draw: &mut Draw) -> Integrator {
    *draw.one_of(&[Integrator::Dop853(1e-9), Integrator::Dop853(1e-6), Integrator::Vern9(1e-9)])
}

/// How far two numbers are apart, over a bound.
fn compared(what: &str, found: f64, expected: f64, bound: f64) -> Verdict {
    let share = (found - expected).abs() / bound;
    if share <= 1.0 {
        Verdict::Right(share)
    } else {
        Verdict::Wrong(format!("{what} = {found}, expected {expected}"))
    }
}

/// Masses on springs of one frequency, of which the first strikes the row of the others: their centre swings as if nothing struck, and the
/// energy does not grow.
fn masses(draw: &mut Draw) -> Scene {
    let count = 2 + draw.below(3);
    let square = draw.number(1.0, 100.0, &[1.0, 10.0, 10.0]);
    let equal = draw.chance(0.5);
    let masses: Vec<f64> =
        (0..count).map(|_| if equal { 1.0 } else { draw.number(0.2, 5.0, &[1.0, 2.0]) }).collect();
    let restitution = draw.number(0.0, 0.95, &[0.0, 0.3, 0.5, 0.8]);
    let first = draw.number(-1.0, -0.05, &[-0.5]);
    let gap = draw.number(0.0, 0.05, &[0.0, 0.0]);
    let law = *draw.one_of(&["poisson", "newton", "sequential"]);
    let mut text = format!("pub Masses {{ allow(W0002); impacts: {law}; ground {{ port o: (0, 0) m; }}\n");
    let mut sum = 0.0;
    for (k, mass) in masses.iter().enumerate() {
        let x = if k == 0 { first } else { gap * k as f64 };
        let stiffness = square * mass;
        sum += mass * x;
        text += &format!(
            "body b{k} {{ mass: {mass:?} kg; inertia: 1 kg*m^2; port p: (0, 0) m; start x: {x:?} m, locked; }}
            prismatic r{k}(ground.o, b{k}.p) {{ stiffness: {stiffness:?} N/m; }}\n"
        );
        if k > 0 {
            let before = k - 1;
            text +=
                &format!("unilateral u{k}: b{k}.x - b{before}.x >= 0 {{ restitution: {restitution:?}; }}\n");
        }
    }
    text += "}";
    let end = draw.rounded(5.0, 60.0) / square.sqrt();
    let expected = sum * (square.sqrt() * end).cos();
    let judge: Judge = Box::new(move |run| {
        let (mut found, mut energy, mut before) = (0.0, 0.0, f64::NEG_INFINITY);
        for (k, mass) in masses.iter().enumerate() {
            let body = run.body(&format!("b{k}"))?;
            found += mass * body.x;
            energy += 0.5 * mass * (body.vx * body.vx + square * body.x * body.x);
            if body.x < before - 1e-8 {
                return Ok(Verdict::Wrong(format!("b{k} is {} m within its neighbour", before - body.x)));
            }
            before = body.x;
        }
        let rest =
            masses.iter().enumerate().skip(1).map(|(k, mass)| mass * (gap * k as f64).powi(2)).sum::<f64>();
        let most = 0.5 * square * (masses[0] * first * first + rest);
        if energy > most * (1.0 + 1e-3) {
            return Ok(Verdict::Wrong(format!("{energy} J of {most} J")));
        }
        Ok(compared("the sum of m x", found, expected, 1e-2 * first.abs()))
    });
    Scene { family: "masses", text, method: method(draw), end, judge }
}

/// Pendula that touch, of one length: no friction, so that there always are pushes; the energy does not grow.
fn cradle(draw: &mut Draw) -> Scene {
    let count = 2 + draw.below(3);
    let restitution = draw.number(0.0, 1.0, &[0.0, 0.5, 0.8, 1.0]);
    let angle = draw.number(-1.0, -0.1, &[-0.5]);
    let raised = if draw.chance(0.3) { 2.min(count - 1) } else { 1 };
    let inertia = draw.number(1e-9, 0.1, &[1e-9]);
    let mut ports = String::new();
    let mut items = String::new();
    for k in 0..count {
        ports += &format!("port p{k}: ({:?}, 1) m; ", 0.1 * k as f64);
        // Those that are raised hang in parallel, and so they touch or are a little apart.
        let start = if k < raised { angle } else { 0.0 };
        items += &format!(
            "body b{k} {{ mass: 1 kg; inertia: {inertia:?} kg*m^2; port h: (0, 1) m; port c: (0, 0) m; start angle: {start:?} rad, locked; }}
            revolute j{k}(ground.p{k}, b{k}.h);\n"
        );
        if k > 0 {
            let before = k - 1;
            items += &format!(
                "circle_on_circle u{before}(b{before}.c, b{k}.c) {{ radius_a: 0.05 m; radius_b: 0.05 m; restitution: {restitution:?}; }}\n"
            );
        }
    }
    // Two that hang in parallel at an angle are nearer than below each other.
    let raised_overlap = raised > 1;
    if raised_overlap {
        items = items.replace("radius_a: 0.05 m; radius_b: 0.05 m", "radius_a: 0.04 m; radius_b: 0.04 m");
    }
    let text = format!("pub Cradle {{ gravity: 9.81 m/s^2; ground {{ {ports} }}\n{items}}}");
    let end = draw.rounded(2.0, 15.0);
    let judge: Judge = Box::new(move |run| {
        let mut energy = 0.0;
        for k in 0..count {
            let body = run.body(&format!("b{k}"))?;
            let speed = body.vx * body.vx + body.vy * body.vy;
            energy += 0.5 * (speed + inertia * body.omega * body.omega) + 9.81 * (1.0 - body.angle.cos());
        }
        let most = raised as f64 * 9.81 * (1.0 - angle.cos());
        if energy > most * (1.0 + 1e-4) {
            return Ok(Verdict::Wrong(format!("{energy} J of {most} J")));
        }
        Ok(Verdict::Right(energy / most))
    });
    Scene { family: "cradle", text, method: method(draw), end, judge }
}

/// A movable pulley that may be light, between two ropes: all accelerations are constant.
fn pulley(draw: &mut Draw) -> Scene {
    let wheel = draw.number(1e-3, 1.0, &[1e-12, 1e-9, 1e-6, 1e-3]);
    let [m1, m2, m3] = [3.0, 1.0, 2.0].map(|usual| draw.number(0.5 * usual, 1.5 * usual, &[usual]));
    let text = format!(
        "pub Atwood {{
    gravity: 9.81 m/s^2;
    ground {{ port left: (-0.1, 2) m; port right: (0.1, 2) m; port rail: (0.1, 0) m, axis: 90 deg; }}
    sliding_mass m1() {{ mass: {m1:?} kg; x: -0.1 m; angle: 90 deg; start: 1 m; }}
    body wheel {{ mass: {wheel:?} kg; inertia: 1e-12 kg*m^2; port top: (0, 0) m; port l: (-0.05, 0) m; port r: (0.05, 0) m; port c: (0, 0) m, angle: 90 deg; start x: 0.1 m; start y: 1.2 m, locked; }}
    prismatic guide(ground.rail, wheel.c);
    sliding_mass m2() {{ mass: {m2:?} kg; x: 0.05 m; angle: 90 deg; start: 0.5 m; }}
    sliding_mass m3() {{ mass: {m3:?} kg; x: 0.15 m; angle: 90 deg; start: 0.6 m; }}
    rope upper() {{ length: 1.8 m; }}
    fall u1(upper.end, m1.frame, ground.left);
    fall u2(upper.end, wheel.top, ground.right);
    rope lower() {{ length: 1.3 m; }}
    fall l1(lower.end, m2.frame, wheel.l);
    fall l2(lower.end, m3.frame, wheel.r);
    output y1 = m1.frame.position.y, upper.tension;
}}"
    );
    let both = 2.0 * m2 * m3 / (m2 + m3);
    let of_wheel = 9.81 * (m1 - 2.0 * both - wheel) / (m1 + 2.0 * both + wheel);
    // The rate is rounded by as much as eps/m: closer tolerances ask for steps that are shorter than the motion needs.
    let method =
        *draw.one_of(&[Integrator::Dop853(1e-6), Integrator::Rk4(1e-2), Integrator::RadauIia5(1e-6)]);
    let end = 0.1;
    let judge: Judge = Box::new(move |run| {
        // Rounding of the terms of D, which are as large as 1/m of the wheel, times the time squared.
        let bound = 2e-6 + 1e-15 / wheel * end * end;
        Ok(compared("y1", run.output("y1")?, 1.0 - 0.5 * of_wheel * end * end, bound))
    });
    Scene { family: "pulley", text, method, end, judge }
}

/// The direction of a place or of a velocity, of what rests, goes along an axis or through the origin.
fn direction(draw: &mut Draw) -> Scene {
    let [x, y, vx, vy] = [0; 4].map(|_| draw.number(-1.0, 1.0, &[0.0, 0.0, 1.0, -1.0]));
    let of_velocity = draw.chance(0.4);
    let (over, under) = if of_velocity { ("b.vy", "b.vx") } else { ("b.y", "b.x") };
    let limit = draw.number(-170.0, 170.0, &[40.0, 0.0, 90.0, -90.0]);
    let text = format!(
        "pub Direction {{ allow(W0002);
    body b {{ mass: 1 kg; inertia: 1 kg*m^2; start x: {x:?} m, locked; start y: {y:?} m, locked; start vx: {vx:?} m/s, locked; start vy: {vy:?} m/s, locked; }}
    discrete n: 1 = 0;
    when atan2({over}, {under}) < {limit:?} deg {{ n = n + 1; }}
    output n;
}}"
    );
    let end = draw.rounded(0.5, 2.0);
    let holds = move |t: f64| {
        let angle = if of_velocity { vy.atan2(vx) } else { (y + vy * t).atan2(x + vx * t) };
        angle.to_degrees() - limit
    };
    let judge: Judge = Box::new(move |run| {
        let sides: Vec<f64> = (0..=20_000).map(|k| holds(end * f64::from(k) / 20_000.0)).collect();
        let nearest = sides.iter().fold(f64::INFINITY, |nearest, side| nearest.min(side.abs()));
        let begins = sides.windows(2).filter(|pair| pair[0] >= 0.0 && pair[1] < 0.0).count();
        let is_still = sides.windows(2).all(|pair| pair[0] == pair[1]);
        if nearest < 1e-3 && begins == 0 && !is_still {
            return Ok(Verdict::Undecided("it touches its limit".to_owned()));
        }
        Ok(compared("n", run.output("n")?, begins as f64, 0.5))
    });
    Scene { family: "direction", text, method: Integrator::Dop853(1e-9), end, judge }
}

/// A pebble on stairs by fixed steps beside located events, until it may have come to an edge.
fn stairs(draw: &mut Draw) -> Scene {
    let restitution = draw.number(0.0, 0.7, &[0.0, 0.5]);
    let [height, speed] = [draw.number(0.2, 1.5, &[1.0]), draw.number(0.0, 1.5, &[0.0, 1.0])];
    let friction = draw.number(0.0, 0.6, &[0.0, 0.3]);
    let x = draw.number(-1.5, -0.1, &[-0.5]);
    let text = format!(
        "pub Stairs {{
    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m; }}
    body pebble {{ mass: 0.1 kg; inertia: 1e-5 kg*m^2; port p: (0, 0) m; start x: {x:?} m; start y: {height:?} m; start vx: {speed:?} m/s; }}
    point_on_polyline stairs(ground.o, pebble.p) {{
        vertices: (-2, 0), (0, 0), (0, -0.3), (0.4, -0.3), (0.4, -0.6), (5, -0.6) m;
        thickness: 0.2 m; restitution: {restitution:?}; friction: {friction:?};
    }}
}}"
    );
    let step = *draw.one_of(&[1e-3, 1e-3, 2e-4]);
    let end = draw.rounded(0.3, 1.5);
    let beside = text.clone();
    let judge: Judge = Box::new(move |run| {
        let mut located = Mechanism::from_text(&beside)?.start_with(Integrator::Dop853(1e-9))?;
        located.step_to(end)?;
        let [found, expected] = [run, &located].map(|run| run.body("pebble"));
        let (found, expected) = (found?, expected?);
        let is_near_edge = |x: f64| [0.0, 0.4].iter().any(|edge| (x - edge).abs() < 0.05);
        // Each bounce is late by up to a step, and after an edge bounces differ.
        if expected.x > -0.05 || found.x > -0.05 {
            let side = if is_near_edge(expected.x) { "at" } else { "after" };
            let is_out = found.y >= -0.61 && found.y <= height + 1e-9;
            return Ok(if is_out {
                Verdict::Undecided(format!("{side} an edge"))
            } else {
                Verdict::Wrong(format!("y = {}", found.y))
            });
        }
        Ok(compared("y", found.y, expected.y, 60.0 * step))
    });
    Scene { family: "stairs", text, method: Integrator::Rk4(step), end, judge }
}
