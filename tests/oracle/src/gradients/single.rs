//! Machines of one body.

use super::drawn::Laid;
use super::{Known, Machine};
use crate::draw::Draw;

/// A bar that hangs, or stands aslant, in one hinge: its place is drawn, or left to assembly.
pub(super) fn hanging(draw: &mut Draw) -> Machine {
    let length = draw.number(0.3, 2.0, &[1.0, 0.5]);
    let laid = Laid::new(draw);
    let [x, y] = laid.point([0.0, -length]);
    let angle = if draw.chance(0.5) { 0.0 } else { laid.turned() };
    let (x, y) = if angle == 0.0 { (0.0, -length) } else { (x, y) };
    let (mirrored_x, mirrored_y) = (angle.sin() * length, -angle.cos() * length);
    let (x, y) =
        if (x - mirrored_x).hypot(y - mirrored_y) < 1e-9 { (x, y) } else { (mirrored_x, mirrored_y) };
    let lock = *draw.one_of(&["", ", locked"]);
    let omega = draw.number(-2.0, 2.0, &[0.0]);
    let speeds = if draw.chance(0.3) {
        String::new()
    } else {
        let (vx, vy) = (-omega * y, omega * x);
        format!("start omega: {omega:?} rad/s; start vx: {vx:?} m/s; start vy: {vy:?} m/s;")
    };
    let text = format!(
        "pub Hanging {{
    param length: m = {length:?} m;
    param mass: kg = 1 kg;
    param g: m/s^2 = 9.81 m/s^2;
    gravity: g;
    ground {{ port o: (0, 0) m; }}
    body b {{
        mass: mass; inertia: 0.1 kg*m^2; port o: (0 m, length);
        start x: {x:?} m; start y: {y:?} m; start angle: {angle:?} rad{lock};
        {speeds}
    }}
    revolute h(ground.o, b.o) {{ damping: 0.1 N*m*s/rad; }}
    output b.angle, b.x, b.omega;
}}"
    );
    // Steps are as long as values let them be: where nothing moves, derivatives are as exact as one long step.
    let until = if omega == 0.0 { *draw.one_of(&[0.0, 1e-3, 0.1]) } else { until(draw) };
    Machine { family: "hanging bar", text, until, known: Known::Differences }
}

/// A cart on a rail whose starts are parameters, numbers and expressions of both, with a state beside it.
pub(super) fn cart(draw: &mut Draw) -> Machine {
    let place = draw.number(-1.0, 1.0, &[0.0, 0.5]);
    let speed = draw.number(-1.0, 1.0, &[0.0, 1.0]);
    let charge = draw.number(0.0, 1.0, &[0.0, 1.0]);
    let start_x = *draw.one_of(&["place", "2*place", "0 m"]);
    let start_vx = *draw.one_of(&["speed", "speed + 2 m/s", "-speed", "0 m/s"]);
    let lock = *draw.one_of(&["", ", locked"]);
    let text = format!(
        "pub Cart {{
    param place: m = {place:?} m;
    param speed: m/s = {speed:?} m/s;
    param charge: 1 = {charge:?};
    param k: N/m = 20 N/m;
    param mass: kg = 2 kg;
    ground {{ port o: (0, 0) m; }}
    body c {{
        mass: mass; inertia: 1 kg*m^2; port o: (0, 0) m;
        start x: {start_x}{lock}; start vx: {start_vx}{lock};
    }}
    prismatic rail(ground.o, c.o) {{ stiffness: k; }}
    state q: 1 = charge;
    rate q = -q/(1 s) + c.vx/(1 m);
    output c.x, c.vx, q;
}}"
    );
    Machine { family: "starts by parameters", text, until: until(draw), known: Known::Differences }
}

/// The time at which results are read, s: at once, soon, later.
pub(super) fn until(draw: &mut Draw) -> f64 {
    draw.number(0.05, 0.8, &[0.0, 1e-3, 0.1])
}
