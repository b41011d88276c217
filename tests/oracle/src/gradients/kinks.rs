//! Motions through kinks, to the boundary of a condition, and through a pose of two ways.

use super::{Known, Machine};
use crate::draw::Draw;

/// A bumper: a force that begins without a jump, written in the ways in which people write it.
pub(super) fn bumper(draw: &mut Draw) -> Machine {
    let place = draw.number(0.1, 0.8, &[0.5, 0.0, 0.0]);
    let speed = draw.number(0.5, 2.0, &[1.0]);
    let stiffness = draw.number(20.0, 400.0, &[100.0]);
    let force = *draw.one_of(&[
        "-max(k*(b.x - place), 0 N)",
        "-max(0 N, k*(b.x - place))",
        "min(-k*(b.x - place), 0 N)",
        "-k*abs(b.x - place)",
        "-(if b.x > place then k*(b.x - place) else 0 N)",
        "if b.x <= place then 0 N else -k*(b.x - place)",
        "-0.5*k*(b.x - place + abs(b.x - place))",
        "-max(k*(b.x - place), 0 N) - max(2*k*(b.x - 1.05*place), 0 N)",
    ]);
    let until = draw.rounded(0.6, 2.0);
    let text = format!(
        "pub Bumper {{
    param place: m = {place:?} m;
    param k: N/m = {stiffness:?} N/m;
    param speed: m/s = {speed:?} m/s;
    param mass: kg = 1 kg;
    ground {{ port o: (0, 0) m; }}
    body b {{
        mass: mass; inertia: 1 kg*m^2; port o: (0, 0) m;
        start x: 0 m, locked; start vx: speed, locked;
    }}
    prismatic r(ground.o, b.o) {{ drive: {force}; damping: {:?} N*s/m; }}
    output b.x, b.vx;
}}",
        draw.number(0.0, 1.0, &[0.0]),
    );
    Machine { family: "bumper", text, until, known: Known::Differences }
}

/// A body that is thrown to a ceiling: beyond, below, or exactly to it.
pub(super) fn ceiling(draw: &mut Draw) -> Machine {
    let speed = draw.number(1.0, 3.0, &[2.0, 1.0]);
    let exact = speed * speed / 20.0;
    let (top, known) = match draw.below(3) {
        0 => (exact, Known::Touches),
        1 => (0.9 * exact, Known::Differences),
        _ => (1.1 * exact, Known::Differences),
    };
    let law = *draw.one_of(&[
        "unilateral f: b.y <= top { restitution: 0.5; }",
        "when b.y > top { b.vy = -0.5*b.vy; }",
        "force push(b.o) { y: if b.y > top then -5 N else 0 N; }",
    ]);
    // The time is long enough for the touch, and too short for a second one.
    let until = 1.5 * speed / 10.0;
    let text = format!(
        "pub Ceiling {{
    param g: m/s^2 = 10 m/s^2;
    param speed: m/s = {speed:?} m/s;
    param top: m = {top:?} m;
    gravity: g*(0, -1);
    body b {{
        mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m;
        start y: 0 m, locked; start vy: speed, locked;
    }}
    {law}
    output b.y, b.vy;
    allow(W0002);
}}"
    );
    Machine { family: "thrown to a ceiling", text, until, known }
}

/// A parallelogram that goes through the pose in which it is flat. With other lengths it does not come there, or turns to another image.
pub(super) fn neutral(draw: &mut Draw) -> Machine {
    let short = draw.number(0.2, 0.5, &[0.3]);
    let long = draw.number(0.8, 1.2, &[1.0]);
    let omega = draw.number(3.0, 6.0, &[4.0]);
    let formulation = *draw.one_of(&["", "formulation: absolute;"]);
    let until = draw.rounded(1.2, 1.9) * std::f64::consts::FRAC_PI_2 / omega;
    let text = format!(
        "pub Neutral {{
    {formulation}
    param base: m = {long:?} m;
    param lk: m = {short:?} m;
    param lr: m = {long:?} m;
    param lq: m = {short:?} m;
    param mass: kg = 1 kg;
    param omega: rad/s = {omega:?} rad/s;
    ground {{ port o: (0, 0) m; port d: (base, 0 m); }}
    body k {{
        mass: mass; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (lk, 0 m);
        start angle: 90 deg, locked; start omega: omega, locked;
    }}
    body r {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (lr, 0 m); start y: {short:?} m; }}
    body q {{
        mass: 2 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (lq, 0 m);
        start x: {long:?} m; start angle: 90 deg;
    }}
    revolute jo(ground.o, k.a) {{ damping: 0.1 N*m*s/rad; }}
    revolute ja(k.b, r.a);
    revolute jb(r.b, q.b);
    revolute jd(ground.d, q.a);
    output k.angle, q.angle, q.omega;
}}"
    );
    Machine { family: "through a change point", text, until, known: Known::ChangePoint }
}
