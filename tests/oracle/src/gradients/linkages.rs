//! Machines of several bodies, closed as they are drawn.

use super::drawn::{Bar, Laid, Point, distance};
use super::single::until;
use super::{Known, Machine};
use crate::draw::Draw;

/// Formulations that a linkage is asked for in.
const FORMULATIONS: [&str; 3] = ["", "formulation: absolute;", "formulation: loops;"];

/// Start rates of the first body: none, zero, some; others follow by assembly.
fn rates(draw: &mut Draw) -> String {
    let omega = draw.number(-3.0, 3.0, &[0.0, 0.0, 1.0]);
    let lock = *draw.one_of(&["", ", locked"]);
    if draw.chance(0.5) { String::new() } else { format!(" start omega: {omega:?} rad/s{lock};") }
}

/// Two bars that hang from each other.
pub(super) fn double_pendulum(draw: &mut Draw) -> Machine {
    let (text, ..) = two_bars(draw, "", "");
    Machine { family: "double pendulum", text, until: until(draw), known: Known::Differences }
}

/// Double pendulum of which a condition sets a speed on the way.
pub(super) fn thrown(draw: &mut Draw) -> Machine {
    let after = draw.rounded(0.02, 0.2);
    let set = *draw.one_of(&[
        "two.omega = kick",
        "one.omega = kick",
        "two.omega = 0.5*two.omega",
        "two.omega = 0 rad/s",
    ]);
    let kick = draw.number(-3.0, 3.0, &[0.0, 1.0]);
    let items = format!("    when t > {after:?} s {{ {set}; }}\n");
    let (text, ..) = two_bars(draw, &format!("    param kick: rad/s = {kick:?} rad/s;\n"), &items);
    let until = draw.rounded(0.21, 0.8);
    Machine { family: "double pendulum, set", text, until, known: Known::Differences }
}

fn two_bars(draw: &mut Draw, parameters: &str, items: &str) -> (String, f64) {
    let laid = Laid::new(draw);
    let points: [Point; 3] = [
        [0.0, 0.0],
        [draw.number(-0.5, 0.5, &[0.0, 0.3, 1.0]), draw.number(-1.0, -0.2, &[-0.4, -1.0])],
        [draw.number(-1.0, 1.0, &[0.0, 0.3]), draw.number(-2.0, -1.2, &[-1.4, -2.0])],
    ];
    let [p, q, r] = points;
    let (one, two) = (distance(p, q), distance(q, r));
    let lock = draw.chance(0.5);
    let formulation = *draw.one_of(&FORMULATIONS[..2]);
    let rates = [rates(draw), rates(draw)];
    let bars = [
        Bar { name: "one", from: p, to: q, length: "l1", mass: "m1", locked: lock, more: &rates[0] },
        Bar {
            name: "two",
            from: q,
            to: r,
            length: "l2",
            mass: "m2",
            locked: draw.chance(0.5),
            more: &rates[1],
        },
    ]
    .map(|bar| bar.text(&laid))
    .concat();
    let text = format!(
        "pub Two {{
    {formulation}
    param l1: m = {one:?} m;
    param l2: m = {two:?} m;
    param m1: kg = 1 kg;
    param m2: kg = {:?} kg;
    param damping: N*m*s/rad = {:?} N*m*s/rad;
{parameters}    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m; }}
{bars}    revolute s(ground.o, one.a) {{ damping: damping; }}
    revolute e(one.b, two.a);
{items}    output one.angle, two.angle, two.omega, two.x;
    allow(W0002);
}}",
        draw.number(0.2, 2.0, &[1.0]),
        draw.number(0.01, 0.2, &[0.0]),
    );
    (text, one)
}

/// Points of a four-bar: its pivots and pins.
fn loop_of_four(draw: &mut Draw) -> [Point; 4] {
    let base = draw.number(0.8, 1.2, &[1.0]);
    [
        [0.0, 0.0],
        [draw.number(-0.1, 0.1, &[0.0, 0.0]), draw.number(0.25, 0.4, &[0.3])],
        [base + draw.number(0.05, 0.3, &[0.1, 0.0]), draw.number(0.45, 0.8, &[0.5, 0.3])],
        [base, 0.0],
    ]
}

/// A four-bar, drawn at rest or in motion.
pub(super) fn four_bar(draw: &mut Draw) -> Machine {
    let rates = rates(draw);
    let text = four_bar_with(draw, "", &rates, "");
    Machine { family: "four-bar", text, until: until(draw), known: Known::Differences }
}

/// A four-bar whose crank is driven from its place.
pub(super) fn driven(draw: &mut Draw) -> Machine {
    let speed = draw.number(0.5, 3.0, &[1.0]);
    let parameters = format!("    param speed: rad/s = {speed:?} rad/s;\n");
    let text = four_bar_with(draw, &parameters, "", "speed*t");
    Machine { family: "four-bar, driven", text, until: until(draw), known: Known::Differences }
}

fn four_bar_with(draw: &mut Draw, parameters: &str, rates: &str, drive: &str) -> String {
    let laid = Laid::new(draw);
    let [o, a, b, d] = loop_of_four(draw);
    let lock = draw.chance(0.7);
    let formulation = if drive.is_empty() { *draw.one_of(&FORMULATIONS) } else { "formulation: absolute;" };
    let bars = [
        Bar {
            name: "k",
            from: o,
            to: a,
            length: "lk",
            mass: "mk",
            locked: lock && drive.is_empty(),
            more: rates,
        },
        Bar { name: "r", from: a, to: b, length: "lr", mass: "1 kg", locked: false, more: "" },
        Bar { name: "q", from: d, to: b, length: "lq", mass: "mq", locked: false, more: "" },
    ]
    .map(|bar| bar.text(&laid))
    .concat();
    let [dx, dy] = laid.point(d);
    let base = distance(o, d);
    let (cx, cy) = (dx / base, dy / base);
    let ([ax, ay], motor) = (laid.point(a), "    constraint motor: k.angle = ");
    let from = ay.atan2(ax);
    let motor = if drive.is_empty() { String::new() } else { format!("{motor}{from:?} rad + {drive};\n") };
    format!(
        "pub Four {{
    {formulation}
    param base: m = {base:?} m;
    param lk: m = {:?} m;
    param lr: m = {:?} m;
    param lq: m = {:?} m;
    param mk: kg = 1 kg;
    param mq: kg = 2 kg;
    param twist: N*m/rad = {:?} N*m/rad;
{parameters}    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m; port d: ({cx:?}*base, {cy:?}*base); }}
{bars}    revolute jo(ground.o, k.a);
    revolute ja(k.b, r.a);
    revolute jb(r.b, q.b) {{ damping: 0.1 N*m*s/rad; }}
    revolute jd(ground.d, q.a) {{ stiffness: twist; }}
{motor}    output k.angle, q.angle, r.angle, q.omega;
}}",
        distance(o, a),
        distance(a, b),
        distance(d, b),
        draw.number(0.1, 2.0, &[0.0, 1.0]),
    )
}

/// A slider-crank, its slider drawn in its place.
pub(super) fn slider_crank(draw: &mut Draw) -> Machine {
    let laid = Laid::new(draw);
    let (o, a) = ([0.0, 0.0], [draw.number(0.05, 0.15, &[0.0, 0.1]), draw.number(0.1, 0.3, &[0.1, 0.3])]);
    let b = [draw.number(0.6, 1.0, &[0.5, 0.8]), 0.0];
    let rates = rates(draw);
    let formulation = *draw.one_of(&FORMULATIONS);
    let bars = [
        Bar {
            name: "crank",
            from: o,
            to: a,
            length: "radius",
            mass: "mass",
            locked: draw.chance(0.6),
            more: &rates,
        },
        Bar { name: "rod", from: a, to: b, length: "rod_length", mass: "1 kg", locked: false, more: "" },
    ]
    .map(|bar| bar.text(&laid))
    .concat();
    let ([x, y], turned) = (laid.point(b), laid.turned());
    let text = format!(
        "pub Press {{
    {formulation}
    param radius: m = {:?} m;
    param rod_length: m = {:?} m;
    param mass: kg = 1 kg;
    param k: N/m = {:?} N/m;
    gravity: 9.81 m/s^2;
    ground {{ port o: (0, 0) m, axis: {turned:?} rad; }}
{bars}    body slider {{
        mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m;
        start x: {x:?} m; start y: {y:?} m; start angle: {turned:?} rad;
    }}
    revolute main(ground.o, crank.a);
    revolute pin(crank.b, rod.a);
    revolute end(rod.b, slider.a);
    prismatic guide(ground.o, slider.a) {{ stiffness: k; damping: 1 N*s/m; }}
    output crank.angle, slider.x, slider.y, crank.omega;
}}",
        distance(o, a),
        distance(a, b),
        draw.number(1.0, 50.0, &[0.0, 10.0]),
    );
    Machine { family: "slider-crank", text, until: until(draw), known: Known::Differences }
}
