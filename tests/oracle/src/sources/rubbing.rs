//! Scenes of contact for sources: crates that bounce and rub, pins, slides and slots that rub and strike their stops, and what sampled
//! controllers do beside them. Half of the numbers are special.

use crate::draw::Draw;

/// The text of a scene.
pub(super) fn scene(draw: &mut Draw) -> String {
    let body = match draw.below(5) {
        0 => crate_on_slope(draw),
        1 => rows_by_hand(draw),
        2 => pins(draw),
        3 => slider_crank(draw),
        _ => two_weights(draw),
    };
    let law = *draw.one_of(&["", "impacts: newton;", "impacts: sequential;", "impacts: poisson;"]);
    format!(
        "pub Rubbing {{\n    allow(W0001, W0002, W0004, W0006, W0007);\n    gravity: 9.81 m/s^2;\n    {law}\n{body}}}\n"
    )
}

fn coefficient(draw: &mut Draw) -> f64 {
    draw.number(0.05, 1.5, &[0.0, 0.1, 0.5, 1.0])
}

/// A coefficient while a row sticks, for one while it slips.
fn static_of(draw: &mut Draw, kinetic: f64) -> f64 {
    if draw.chance(0.5) { kinetic } else { kinetic * 1.25 }
}

fn restitution(draw: &mut Draw) -> f64 {
    draw.number(0.05, 0.95, &[0.0, 0.5, 1.0])
}

/// A polygon on a line: on it, above it, or leaning on a corner.
fn crate_on_slope(draw: &mut Draw) -> String {
    let slope = draw.number(-40.0, 40.0, &[0.0, 30.0, 90.0]);
    let (height, width) = (draw.number(0.05, 0.4, &[0.1, 0.2]), draw.number(0.05, 0.3, &[0.1]));
    let above = draw.number(0.001, 0.2, &[0.0]);
    let angle = slope + draw.number(-60.0, 60.0, &[0.0, 45.0]);
    let far = height + above + if (angle - slope).abs() > 0.0 { width + 0.2 } else { 0.0 };
    let (e, mu) = (restitution(draw), coefficient(draw));
    let (vx, omega) = (draw.number(-2.0, 2.0, &[0.0, 1.0]), draw.number(-5.0, 5.0, &[0.0]));
    format!(
        "    ground {{ port slope: (0, 0) m, axis: {slope} deg; }}
    body crate {{
        mass: 2 kg; inertia: 0.05 kg*m^2; port middle: (0, 0) m;
        start x: -{far}*sin({slope} deg)*1 m; start y: {far}*cos({slope} deg)*1 m; start angle: {angle} deg;
        start vx: {vx} m/s; start omega: {omega} rad/s;
    }}
    polygon_on_line feet(ground.slope, crate.middle) {{
        corners: (-{width}, -{height}), ({width}, -{height}), ({width}, {height}), (-{width}, {height}) m;
        friction: {mu}; restitution: {e};
    }}
    output feet.push, feet.drag;\n"
    )
}

/// Gaps and frictions of a body as rows, with static bounds, and a controller that counts.
fn rows_by_hand(draw: &mut Draw) -> String {
    let (mu, e) = (coefficient(draw), restitution(draw));
    let (at_rest, other) = (static_of(draw, mu), coefficient(draw));
    let height = draw.number(0.001, 0.3, &[0.0, 0.1]);
    let (vx, push) = (draw.number(-2.0, 2.0, &[0.0, 1.0]), draw.number(-30.0, 30.0, &[0.0]));
    let period = draw.number(0.02, 0.2, &[0.05]);
    let controlled = draw.chance(0.5);
    let force = if controlled { "kick" } else { "push" };
    let control = if controlled {
        format!(
            "    discrete kick: N = 0 N;\n    discrete due: s = {period} s;\n    \
             when t > due {{ kick = push - 20 N*s/m*(body.vx); due = due + {period} s; }}\n"
        )
    } else {
        String::new()
    };
    format!(
        "    ground {{ port o: (0, 0) m; }}
    input push: N = {push} N;
    body body {{
        mass: 1 kg; inertia: 0.01 kg*m^2; port left: (-0.1, 0) m; port right: (0.1, 0) m;
        start x: 0 m; start y: {height} m; start angle: 0 deg; start vx: {vx} m/s;
    }}
    force pull(body.left) {{ x: {force}; }}
    unilateral left: body.left.y >= 0 m {{ restitution: {e}; }}
    unilateral right: body.right.y >= 0 m {{ restitution: {e}; }}
    friction rub: rate(body.left.x) within {mu}*reaction(left) {{ static: {at_rest}*reaction(left); }}
    friction drag: rate(body.right.x) within {other}*reaction(right);
{control}    output a = reaction(left), b = reaction(right), c = reaction(rub), body.vx;\n"
    )
}

/// A pendulum of two rods with pins that rub, and stops.
fn pins(draw: &mut Draw) -> String {
    let (mu, e) = (coefficient(draw), restitution(draw));
    let at_rest = static_of(draw, mu);
    let seal = draw.number(0.01, 1.0, &[0.0, 0.1]);
    let angle = draw.number(-80.0, 80.0, &[0.0, 45.0]);
    let stop = draw.number(5.0, 60.0, &[30.0, 90.0]);
    format!(
        "    ground {{ port o: (0, 0) m; }}
    body arm {{ mass: 1 kg; inertia: rod(1 kg, 1 m); port a: (-0.5, 0) m; port b: (0.5, 0) m; start angle: {angle} deg; }}
    body rod {{ mass: 0.5 kg; inertia: rod(0.5 kg, 0.6 m); port a: (-0.3, 0) m; port b: (0.3, 0) m; start angle: {angle} deg; }}
    revolute shoulder(ground.o, arm.a) {{ friction: {mu}; static_friction: {at_rest}; pin_diameter: 40 mm; seal_friction: {seal} N*m; }}
    revolute elbow(arm.b, rod.a) {{ friction: {mu}; pin_diameter: 20 mm; lower_limit: -{stop} deg; upper_limit: {stop} deg; restitution: {e}; }}
    output shoulder.friction_torque, elbow.friction_torque, elbow.lower_limit_torque, shoulder.force;\n"
    )
}

/// A slider-crank whose slide and pins rub.
fn slider_crank(draw: &mut Draw) -> String {
    let mu = coefficient(draw);
    let at_rest = static_of(draw, mu);
    let angle = draw.number(10.0, 160.0, &[45.0, 90.0]);
    let torque = draw.number(-20.0, 20.0, &[0.0, 5.0]);
    let pin = *draw.one_of(&["", "friction: 0.1; pin_diameter: 20 mm;"]);
    format!(
        "    ground {{ port o: (0, 0) m; port rail: (0, 0) m; }}
    input torque: N*m = {torque} N*m;
    body crank {{ mass: 1 kg; inertia: rod(1 kg, 0.2 m); port a: (-0.1, 0) m; port b: (0.1, 0) m; start angle: {angle} deg; }}
    body rod {{ mass: 1 kg; inertia: rod(1 kg, 0.5 m); port a: (-0.25, 0) m; port b: (0.25, 0) m; start x: 0.3 m; }}
    body slide {{ mass: 2 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start x: 0.6 m; }}
    revolute main(ground.o, crank.a) {{ drive: torque; {pin} }}
    revolute big(crank.b, rod.a) {{ {pin} }}
    revolute small(rod.b, slide.a);
    prismatic guide(ground.rail, slide.a) {{ friction: {mu}; static_friction: {at_rest}; guide_length: 0.1 m; }}
    output guide.friction_force, guide.lost, main.force;\n"
    )
}

/// Two weights on slides above each other that strike and rub, with a row that exists on a condition.
fn two_weights(draw: &mut Draw) -> String {
    let (e, f) = (restitution(draw), restitution(draw));
    let (low, high) = (draw.number(0.01, 0.2, &[0.0, 0.1]), draw.number(0.3, 0.6, &[0.5]));
    let seal = draw.number(0.1, 5.0, &[0.0, 1.0]);
    let until = draw.number(0.05, 0.5, &[0.25]);
    let when = if draw.chance(0.5) { format!("when: t < {until} s;") } else { String::new() };
    format!(
        "    ground {{ port o: (0, 0) m, axis: 90 deg; }}
    body lower {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start y: {low} m; }}
    body upper {{ mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start y: {high} m; }}
    prismatic one(ground.o, lower.a) {{ lower_limit: 0 m; restitution: {e}; seal_friction: {seal} N; }}
    prismatic two(ground.o, upper.a);
    unilateral meet: upper.y - lower.y >= 0.1 m {{ restitution: {f}; {when} }}
    output one.friction_force, one.lower_limit_force, lower.y, upper.y;\n"
    )
}
