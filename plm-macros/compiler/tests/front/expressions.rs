//! Expressions and units.

use std::f64::consts::PI;

use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::token::Sources;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use crate::support::{Values, assert_near, evaluate, output, resolve};

#[test]
fn units_are_what_they_stand_for() {
    let cases = [
        ("1 N*m/(rev/min)", 60.0 / (2.0 * PI)),
        ("20 L/min", 20e-3 / 60.0),
        ("0.01 kg*m^2", 0.01),
        ("180 deg", PI),
        ("1000 rev/min", 1000.0 * 2.0 * PI / 60.0),
        ("100 N*m/deg", 100.0 * 180.0 / PI),
        ("4000 N/(m/s)", 4000.0),
        ("17000 bar", 1.7e9),
        ("51 cP", 0.051),
        ("3 h", 10800.0),
        ("5 ms", 0.005),
        ("2 kN/mm", 2e6),
        ("1 kg*m/s^2", 1.0),
        ("1 m*s^-2", 1.0),
        ("7.5 kW", 7500.0),
        ("(1, 2) cm + (0.5, 0) m", 0.51),
    ];
    for (text, expected) in cases {
        let expr = if text.starts_with('(') { format!("({text}).x") } else { text.to_string() };
        assert_near(evaluate(&expr), expected, text);
    }
}

/// The cases of architecture.md, section 1: where the unit ends and the expression goes on.
#[test]
fn the_unit_ends_where_it_must() {
    let model = resolve(
        "pub P {
            param area: m^2 = 2 m^2;
            param a: m = 3 m; param b: m = 4 m;
            repeat i in 0..2 { body bar[i] { mass: 1 kg; inertia: 1 kg*m^2; start x: 2 m; } }
            output pressure = 10 N/area;
            output minimum = 2 m*min(a, b);
            output half = 1/2 s;
            output group = 6 N/(m/s);
            output product = 6 N/(a + b);
            output element = 6 N/bar[0].x;
            output power = 2 m^2;
            output parenthesis = (2*a)*b;
        }",
    );
    let mut values = Values::of(&model);
    values.pose(&model, "bar[0]", [2.0, 0.0, 0.0]);
    let cases = [
        ("pressure", 5.0),
        ("minimum", 6.0),
        ("half", 0.5),
        ("group", 6.0),
        ("product", 6.0 / 7.0),
        ("element", 3.0),
        ("power", 2.0),
        ("parenthesis", 24.0),
    ];
    for (name, expected) in cases {
        assert_near(output(&model, &values, name)[0], expected, name);
    }
    assert_eq!(model.outputs[2].unit.text, "1/s");
    assert_eq!(model.outputs[3].unit.text, "N/(m/s)");
}

#[test]
fn operators_bind_as_they_should() {
    let cases = [
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2^3^2", 512.0),
        ("1 + 2*3", 7.0),
        ("1 - 2 - 3", -4.0),
        ("12/3/2", 2.0),
        ("2*-3", -6.0),
        ("- -3", 3.0),
        ("(1 + 2)*3", 9.0),
        ("if 1 < 2 then 3 else 4", 3.0),
        ("if 1 > 2 or 1 <= 1 then 3 else 4", 3.0),
        ("if not 1 < 2 and 1 < 2 then 3 else 4", 4.0),
        ("if n > 4 and n < 6 then 1 else 0", 1.0),
        ("if n >= 5 and not n < 5 then 1 else 0", 1.0),
        ("if n <= 4 or n > 5 then 1 else 0", 0.0),
        ("if n < 0 then 1 else if n < 10 then 2 else 3", 2.0),
    ];
    for (text, expected) in cases {
        assert_near(evaluate(text), expected, text);
    }
}

#[test]
fn functions_are_the_ones_of_mathematics() {
    let cases = [
        ("abs(-a)", 3.0),
        ("sign(-b)", -1.0),
        ("floor(-n/2)", -3.0),
        ("floor(n)", 5.0),
        ("mod(-a, b)", 1.0),
        ("mod(n, 5)", 0.0),
        ("min(a, b, 1 m)", 1.0),
        ("max(a, b, 1 m)", 4.0),
        ("clamp(n, 0, 3)", 3.0),
        ("sqrt(a^2 + b^2)", 5.0),
        ("exp(1)", std::f64::consts::E),
        ("ln(n)", 5.0_f64.ln()),
        ("sin(30 deg)", 0.5),
        ("cos(1/n*5*60 deg)", 0.5),
        ("tan(45 deg)", 1.0),
        ("asin(1)", PI / 2.0),
        ("acos(n/10)", PI / 3.0),
        ("atan2(a, -a)", 0.75 * PI),
        ("dot((a, b), (1, 2))", 11.0),
        ("cross((a, b), (1, 2))", 2.0),
        ("norm((a, b))", 5.0),
        ("turn((a, b), 90 deg).x", -4.0),
        ("turn((a, b), 90 deg).y", 3.0),
        ("sin(a/b)", 0.75_f64.sin()),
    ];
    for (text, expected) in cases {
        assert_near(evaluate(text), expected, text);
    }
}

/// Izz of the manual's appendix 1, for 12 kg and lengths of 3 m and 4 m, worked out by hand.
#[test]
fn moments_of_inertia_are_those_of_the_appendix() {
    let cases = [
        ("rod(12 kg, a)", 9.0),
        ("disc(12 kg, a)", 54.0),
        ("hollow_cylinder(12 kg, a, b)", 150.0),
        ("thin_cylinder(12 kg, a)", 108.0),
        ("plate(12 kg, a, b)", 25.0),
        ("sphere(12 kg, a)", 43.2),
        ("thin_sphere(12 kg, a)", 72.0),
        ("rod(12 kg, 50 cm) + 12 kg*a^2", 108.25),
        // A disc is a hollow cylinder without a hole, and a thin cylinder is one without a wall.
        ("disc(12 kg, a) - hollow_cylinder(12 kg, 0, a)", 0.0),
        ("thin_cylinder(12 kg, a) - hollow_cylinder(12 kg, a, a)", 0.0),
    ];
    for (text, expected) in cases {
        assert_near(evaluate(text), expected, text);
    }
}

/// The two cases of the manual's coordinate calculator, section 4.8, and back again.
#[test]
fn points_go_from_relative_to_absolute_axes_and_back() {
    let cases = [
        ("to_absolute((0.2, 0.1) m, (1, 0.5) m, 30 deg).x", 1.123_205_080_756_887_6),
        ("to_absolute((0.2, 0.1) m, (1, 0.5) m, 30 deg).y", 0.686_602_540_378_443_8),
        ("to_relative((1.5, 0.75) m, (1, 0.5) m, 30 deg).x", 0.558_012_701_892_219_3),
        ("to_relative((1.5, 0.75) m, (1, 0.5) m, 30 deg).y", -0.033_493_649_053_890_295),
        ("to_relative(to_absolute((a, b), (b, a), 1 rad), (b, a), 1 rad).x", 3.0),
        ("to_relative(to_absolute((a, b), (b, a), 1 rad), (b, a), 1 rad).y", 4.0),
        ("to_absolute((a, b), (0, 0), 90 deg).x", -4.0),
    ];
    for (text, expected) in cases {
        assert_near(evaluate(text), expected, text);
    }
}

#[test]
fn tables_interpolate_and_hold_their_ends() {
    let table = |x: &str| format!("table({x}, (1 m, 10 N), (3 m, 20 N), (4 m, 0))");
    let cases = [
        ("0.5 m", 10.0),
        ("1 m", 10.0),
        ("2 m", 15.0),
        ("a", 20.0),
        ("3.5 m", 10.0),
        ("b", 0.0),
        ("9 m", 0.0),
    ];
    for (x, expected) in cases {
        assert_near(evaluate(&table(x)), expected, x);
    }
}

/// Between two points of one value the spline has the slopes 1 and -1 by symmetry, and its middle is 1 + 1/4; a difference of two
/// tables rests there.
#[test]
fn smooth_tables_swing_between_points_of_one_value_and_their_sums_rest() {
    let table = |x: &str| format!("smooth_table({x}, (0 m, 0 N), (1 m, 1 N), (2 m, 1 N), (3 m, 0 N))");
    let sum = |x: &str| {
        format!("smooth_table({x}, (0 m, 0 N), (1 m, 1 N)) - smooth_table({x}, (2 m, 0 N), (3 m, 1 N))")
    };
    for (x, swings, rests) in
        [("1 m", 1.0, 1.0), ("1.5 m", 1.25, 1.0), ("1.25 m", 1.1875, 1.0), ("9 m", 0.0, 0.0)]
    {
        assert_near(evaluate(&table(x)), swings, x);
        assert_near(evaluate(&sum(x)), rests, x);
    }
}

#[test]
fn exact_angles_stay_exact() {
    let model = resolve("pub P { param a: deg = 45 deg; output value = 45 deg; output c = cos(60 deg); }");
    let values = Values::of(&model);
    assert_eq!(values.get(model.params[0].symbol), std::f64::consts::FRAC_PI_4);
    assert_eq!(output(&model, &values, "c"), [0.5]);
}

#[test]
fn rates_are_total_derivatives() {
    let model = resolve(
        "pub P {
            body arm { mass: 1 kg; inertia: 1 kg*m^2; port tip: (2, 1) m; }
            output speed = rate(arm.x*t);
            output tip = rate(arm.tip.position);
            output also = arm.tip.velocity;
            output second = rate(arm.tip.velocity);
        }",
    );
    let mut values = Values::of(&model);
    values.scatter(&model, 7);
    values.set(model.time, 2.0);
    let body = &model.bodies[0];
    let (q, v, a) =
        (body.q.map(|s| values.get(s)), body.v.map(|s| values.get(s)), body.a.map(|s| values.get(s)));
    assert_near(output(&model, &values, "speed")[0], v[0] * 2.0 + q[0], "product rule");
    let (s, c) = q[2].sin_cos();
    let arm = [2.0 * c - s, 2.0 * s + c];
    for name in ["tip", "also"] {
        let tip = output(&model, &values, name);
        assert_near(tip[0], v[0] - v[2] * arm[1], name);
        assert_near(tip[1], v[1] + v[2] * arm[0], name);
    }
    // Acceleration of a point of a rigid body: tangential and centripetal parts.
    let second = output(&model, &values, "second");
    assert_near(second[0], a[0] - a[2] * arm[1] - v[2] * v[2] * arm[0], "x");
    assert_near(second[1], a[1] + a[2] * arm[0] - v[2] * v[2] * arm[1], "y");
}

/// Tokens with brackets that nobody sees in the place of braces.
fn hidden(stream: TokenStream) -> TokenStream {
    let hide = |tree| match tree {
        TokenTree::Group(group) => {
            let seen =
                if group.delimiter() == Delimiter::Brace { Delimiter::None } else { group.delimiter() };
            TokenTree::Group(Group::new(seen, hidden(group.stream())))
        }
        leaf => leaf,
    };
    stream.into_iter().map(hide).collect()
}

/// An expression of the length 3 and of what a `macro_rules!` would have captured, which stands in braces.
fn captured(expr: &str) -> Result<f64, String> {
    let items = format!("param a: m = 3 m; output value = {expr}; output other = a;");
    let mut stream: TokenStream = "pub P".parse().unwrap();
    let items = Group::new(Delimiter::Brace, hidden(items.parse().unwrap()));
    stream.extend([TokenTree::Group(items)]);
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_tokens("declaration", stream);
    let model = parse_and_resolve(&mut sources, &mut sink);
    if let Some(diagnostic) = sink.sorted().first() {
        return Err(diagnostic.message.clone());
    }
    let model = model.ok_or("no model")?;
    Ok(Values::of(&model).at(&model, model.outputs[0].components[0]))
}

#[test]
fn what_a_macro_captures_is_one_operand() {
    for (text, expected) in [
        ("2*{ 1 + 2 }", 6.0),
        ("2*{ { 3 } }^2", 18.0),
        ("{ 2 } m/{ a }", 2.0 / 3.0),
        ("1 - { 1 - 2 }", 2.0),
        ("{ -3 }^2", 9.0),
        ("{ 1 + 1 } m/a", 2.0 / 3.0),
        ("{ -2 } m + a", 1.0),
        ("{ { 1 + 2 } * 2 }", 6.0),
        ("({ 1/2 }, { 2/4 }).x", 0.5),
    ] {
        assert_near(captured(text).unwrap(), expected, text);
    }
    assert_eq!(captured("{ a + a } m"), Err("a unit after a length (m)".to_string()));
}
