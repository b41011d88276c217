//! Equations that are written: their form beside that of textbooks, and their numbers beside the compiled rate.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::fs;
use std::path::{Path, PathBuf};

use plm_cas::{Expr, Function, algebra};

use super::equation::{Side, equations};
use super::formula::{Formula, Writer};
use super::name::{Name, Names};
use crate::formulate::textbook;
use crate::numeric::{Random, defaults};
use crate::oracle::Oracle;
use crate::token::Sources;

const CASES: [&str; 3] = ["double_pendulum", "slider_crank", "governor"];

fn file(name: &str, ending: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/written").join(name).with_extension(ending)
}

fn oracle(text: &str) -> Oracle {
    let mut sources = Sources::new();
    sources.add_text("case.plm", text);
    let expansion = crate::analyse(&mut sources);
    let said: Vec<String> = expansion.diagnostics.sorted().iter().map(|one| one.render(&sources)).collect();
    expansion.oracle.unwrap_or_else(|| panic!("{}", said.join("\n")))
}

/// The double pendulum in absolute angles (as in H. Goldstein, Classical Mechanics, chapter 1, problem 22, for rods with mass), the
/// slider-crank with the multipliers of its wrist, and the governor of Watt with centrifugal forces.
#[test]
fn the_form_is_that_of_textbooks() {
    for name in CASES {
        let written = oracle(&fs::read_to_string(file(name, "plm")).unwrap()).written();
        for (ending, lines) in [("tex", &written.latex), ("mml", &written.mathml)] {
            let made = lines.join("\n") + "\n";
            if std::env::var_os("PLM_BLESS").is_some() {
                fs::write(file(name, ending), made).unwrap();
            } else {
                let known = fs::read_to_string(file(name, ending)).unwrap();
                assert!(made == known, "{name}.{ending}\n{made}\nPLM_BLESS=1 writes it anew");
            }
        }
    }
}

/// Term by term as the books have it, whatever the file beside says.
#[test]
fn the_double_pendulum_has_the_terms_of_the_books() {
    let written = oracle(&fs::read_to_string(file("double_pendulum", "plm")).unwrap()).written();
    let [first, second] = &written.latex[..] else { panic!("{written:?}") };
    for (line, terms) in [
        (
            first,
            [
                "\\left(I_{1} + \\frac{1}{4} m_{1} l_{1}^{2} + m_{2} l_{1}^{2}\\right) \\ddot{\\varphi}_{a}",
                " + \\frac{1}{2} m_{2} l_{1} l_{2} \\ddot{\\varphi}_{b} \\cos\\left(\\varphi_{a} - \\varphi_{b}\\right)",
                " + \\frac{1}{2} m_{2} l_{1} l_{2} \\dot{\\varphi}_{b}^{2} \\sin\\left(\\varphi_{a} - \\varphi_{b}\\right)",
                "\\cos \\varphi_{a} = 0",
            ],
        ),
        (
            second,
            [
                "\\frac{1}{2} m_{2} l_{1} l_{2} \\ddot{\\varphi}_{a} \\cos\\left(\\varphi_{a} - \\varphi_{b}\\right)",
                " + \\left(I_{2} + \\frac{1}{4} m_{2} l_{2}^{2}\\right) \\ddot{\\varphi}_{b}",
                " - \\frac{1}{2} m_{2} l_{1} l_{2} \\dot{\\varphi}_{a}^{2} \\sin\\left(\\varphi_{a} - \\varphi_{b}\\right)",
                " + \\frac{1}{2} m_{2} l_{2} g \\cos \\varphi_{b} = 0",
            ],
        ),
    ] {
        let mut from = 0;
        for term in terms {
            let at = line[from..].find(term).unwrap_or_else(|| panic!("{term}\nis not in\n{line}"));
            from += at + term.len();
        }
    }
}

/// Values of symbols at a state, and of the rest of the equations.
struct State<'a> {
    known: &'a dyn Fn(&Name) -> Option<f64>,
    /// The multiplier that is 1; all others are 0.
    multiplier: Option<&'a Name>,
}

impl State<'_> {
    fn side(&self, terms: &Side) -> f64 {
        terms.iter().map(|(minus, term)| if *minus { -self.value(term) } else { self.value(term) }).sum()
    }

    fn value(&self, formula: &Formula) -> f64 {
        match formula {
            Formula::Number(text) => text.parse().unwrap(),
            Formula::Name(name) if name.base == "lambda" => {
                f64::from(u8::from(self.multiplier == Some(name)))
            }
            Formula::Name(name) if name.base == "pi" => std::f64::consts::PI,
            Formula::Name(name) => (self.known)(name).unwrap_or_else(|| panic!("{name:?}")),
            Formula::Sum(terms) => self.side(terms),
            Formula::Product(factors) => factors.iter().map(|factor| self.value(factor)).product(),
            Formula::Fraction(above, below) => self.value(above) / self.value(below),
            Formula::Power(base, power) => self.value(base).powi(i32::try_from(*power).unwrap()),
            Formula::Call(function, arguments) => {
                let values: Vec<f64> = arguments.iter().map(|argument| self.value(argument)).collect();
                match (function, &values[..]) {
                    (Function::Sin, [x]) => x.sin(),
                    (Function::Cos, [x]) => x.cos(),
                    (Function::Sqrt, [x]) => x.sqrt(),
                    (Function::Abs, [x]) => x.abs(),
                    _ => panic!("{function}"),
                }
            }
            other => panic!("{other:?}"),
        }
    }
}

/// The largest part of an equation that is left, over the size of its terms, with the accelerations of the compiled equations: of
/// equations of motion what no multipliers account for, of constraints their values.
fn left_over(text: &str) -> f64 {
    let oracle = oracle(text);
    let start = oracle.assembled();
    let q: Vec<f64> = start.bodies.iter().flat_map(|body| body.pose).collect();
    let v: Vec<f64> = start.bodies.iter().flat_map(|body| body.velocity).collect();
    let rate = oracle.dynamics(0.0, &[&q[..], &v].concat());
    let a = &rate[q.len()..2 * q.len()];
    let mut graph = oracle.graph.borrow_mut();
    graph.enter(|| {
        let (model, own) = (&oracle.model, &oracle.equations);
        let all = textbook(model, own);
        let names = Names::new(model, &all);
        let lines = equations(model, own, &all, &Writer::new(&names));
        let along: Vec<(Expr, Expr)> = (own.q.iter().copied().zip(own.v.iter().copied()))
            .chain(own.v.iter().copied().zip(own.a.iter().copied()))
            .chain([(model.time, Expr::ONE)])
            .collect();
        let first = algebra::directionals(&all.of_pose, &along);
        let second = algebra::directionals(&first, &along);
        let mut values = defaults(model);
        values.push((model.time, 0.0));
        for (symbols, numbers) in [(&own.q, &q[..]), (&own.v, &v), (&own.a, a)] {
            values.extend(symbols.iter().copied().zip(numbers.iter().copied()));
        }
        let moved = [&all.of_pose, &first, &second].map(|of| algebra::tape(of).eval(&values).unwrap());
        let mut known: Vec<(Name, f64)> =
            values.iter().map(|&(symbol, value)| (names.of(symbol), value)).collect();
        for (k, &value) in all.value.iter().enumerate() {
            known.retain(|(own, _)| (0..3).all(|dots| *own != names.of(value).dotted(dots)));
            known.extend((0..3).map(|dots| (names.of(value).dotted(dots), moved[dots][k])));
        }
        let known = |name: &Name| known.iter().find(|(own, _)| own == name).map(|(_, value)| *value);
        worst(&lines, all.rows.len(), &known)
    })
}

fn worst(lines: &[[Side; 2]], count: usize, known: &dyn Fn(&Name) -> Option<f64>) -> f64 {
    let mut multipliers: Vec<Name> = Vec::new();
    lines.iter().flatten().flatten().for_each(|(_, formula)| collect(formula, &mut multipliers));
    let residuals = |multiplier: Option<&Name>| -> Vec<f64> {
        let state = State { known, multiplier };
        lines.iter().map(|[left, right]| state.side(left) - state.side(right)).collect()
    };
    let still = residuals(None);
    let size = |[left, right]: &[Side; 2]| -> f64 {
        let state = State { known, multiplier: None };
        left.iter().chain(right).map(|(_, term)| state.value(term).abs()).sum::<f64>()
    };
    let scale = lines[..count].iter().map(size).fold(1e-3, f64::max);
    // What is orthogonal to the columns of the multipliers, by Gram and Schmidt.
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let without = |mut vector: Vec<f64>, basis: &[Vec<f64>]| {
        for own in basis.iter().chain(basis) {
            let part = dot(&vector, own);
            vector.iter_mut().zip(own).for_each(|(value, own)| *value -= part * own);
        }
        vector
    };
    for multiplier in &multipliers {
        let column: Vec<f64> =
            residuals(Some(multiplier)).iter().zip(&still).map(|(a, b)| a - b).take(count).collect();
        let left = without(column, &basis);
        let length = dot(&left, &left).sqrt();
        if length > 1e-9 {
            basis.push(left.iter().map(|value| value / length).collect());
        }
    }
    let motion = without(still[..count].to_vec(), &basis);
    let of_motion = motion.iter().fold(0.0_f64, |worst, value| worst.max(value.abs() / scale));
    still[count..].iter().fold(of_motion, |worst, value| worst.max(value.abs()))
}

/// Multipliers in a formula.
fn collect(formula: &Formula, into: &mut Vec<Name>) {
    match formula {
        Formula::Name(name) if name.base == "lambda" && !into.contains(name) => into.push(name.clone()),
        Formula::Sum(terms) => terms.iter().for_each(|(_, term)| collect(term, into)),
        Formula::Product(factors) => factors.iter().for_each(|factor| collect(factor, into)),
        Formula::Fraction(above, _) => collect(above, into),
        _ => {}
    }
}

/// Special and random states: angles of quarter turns, equal ones, at rest.
#[test]
fn the_numbers_are_those_of_the_compiled_rate() {
    let mut random = Random(52);
    for name in CASES {
        let text = fs::read_to_string(file(name, "plm")).unwrap();
        let special = [
            (0.0, 0.0, 0.0, 0.0),
            (90.0, 90.0, 1.0, 1.0),
            (30.0, 30.0, -2.0, 3.0),
            (-90.0, 0.0, 0.0, 5.0),
            (45.0, -135.0, 4.0, 0.0),
        ];
        let drawn = (0..40).map(|_| {
            let mut next = |size: f64| size * random.unit();
            (next(180.0), next(180.0), next(10.0), next(10.0))
        });
        let mut tried = 0;
        for (first, second, omega, other) in special.into_iter().chain(drawn) {
            let mut own = text.clone();
            for (from, to) in [
                ("start angle: 20 deg", format!("start angle: {first} deg")),
                ("start angle: -40 deg", format!("start angle: {second} deg")),
                ("start angle: 50 deg", format!("start angle: {first} deg")),
                // The arm of the governor hangs on one side.
                ("start angle: -50 deg", format!("start angle: {} deg", -45.0 + 0.2 * first)),
                ("start angle: -130 deg", format!("start angle: {} deg", -135.0 - 0.2 * first)),
                ("start omega: 1.5 rad/s", format!("start omega: {omega} rad/s")),
                ("start omega: 3 rad/s", format!("start omega: {omega} rad/s")),
                ("start omega: 0.7 rad/s", format!("start omega: {omega} rad/s")),
                ("start omega: -2.5 rad/s", format!("start omega: {other} rad/s")),
            ] {
                own = own.replace(from, &to);
            }
            let left = left_over(&own);
            // Rounding of the assembled pose, 1e-12 of the size of the scene, and of some hundred operations.
            assert!(
                left < 1e-9,
                "{name}: {left:.1e} at {first} deg, {second} deg, {omega} rad/s, {other} rad/s"
            );
            tried += 1;
        }
        assert_eq!(tried, 45);
    }
}

/// Prescribed motions, moving ground, sliders on turning arms, springs, free bodies.
#[test]
fn other_mechanisms_have_their_numbers_too() {
    let arm = "body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port rail: (0.1, 0.3) m, angle: 25 deg; \
               start angle: 33 deg, locked; start omega: 1.3 rad/s, locked; }";
    for (what, items) in [
        (
            "a slider on an arm",
            format!(
                "{arm} body shoe {{ mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0.05, -0.02) m, angle: 10 deg; \
            start vx: 0.4 m/s; }} ground {{ port o: (0, 0) m; }} revolute hinge(ground.o, arm.o) {{ stiffness: 3 N*m/rad; damping: 0.2 N*m*s; }} \
            prismatic rail(arm.rail, shoe.a) {{ stiffness: 200 N/m; damping: 3 N*s/m; free_length: 0.2 m; }}"
            ),
        ),
        (
            "a moving ground",
            format!(
                "{arm} ground {{ port o: (0.1 m * sin(7 rad/s * t), 0.05 m * cos(11 rad/s * t)); }} \
            revolute hinge(ground.o, arm.o);"
            ),
        ),
        (
            "a free body on a spring",
            format!(
                "{arm} ground {{ port o: (2, 1) m; }} \
            spring leash(ground.o, arm.o) {{ stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }}"
            ),
        ),
        (
            "a prescribed motion",
            format!(
                "{arm} body tip {{ mass: 1 kg; inertia: 0.1 kg*m^2; port p: (0.2, 0) m; start angle: 10 deg; }} \
            ground {{ port o: (0, 0) m; }} revolute hinge(ground.o, arm.o); revolute other(arm.rail, tip.p); \
            constraint ratio: tip.angle = 2*arm.angle + 1 rad/s*t - 56 deg;"
            ),
        ),
    ] {
        let text = format!("pub Case {{ gravity: 9.81 m/s^2; {items} }}");
        let left = left_over(&text);
        assert!(left < 1e-9, "{what}: {left:.1e}");
    }
}
