//! Emitted code against the interpreter of the compiler: the same operations in the same order, so the same bits.

use plm::runtime::charts::{ContinuationData, OfLoops};
use plm::{Mechanism, Moment};
use plm_compiler::compile;
use plm_compiler::token::Sources;

/// Declares a mechanism twice: for rustc, and as text for the interpreter.
macro_rules! twice {
    ($module:ident, $($declaration:tt)*) => {
        mod $module {
            plm::mechanism! { $($declaration)* }
            pub(super) const TEXT: &str = stringify!($($declaration)*);
        }
    };
}

// Every function of the language, parameters, inputs, states, all joints.
twice! { everything,
    pub Everything {
        gravity: 9.81 m/s^2;
        param length: m = 0.7 m;
        param stiff: N/m = 300 N/m;
        input push: N = 3 N;
        let wave = sin(2 rad/s * t) + abs(cos(t * 1 rad/s)) + sqrt(1 + exp(-t / 1 s));
        state level: Pa = 2 bar;
        rate level = (1e5 Pa - level) / 0.3 s;
        ground { port o: (0, 0) m; port slot: (1, 0.2) m, axis: 20 deg; }
        body crank {
            mass: 2 kg; inertia: 0.05 kg*m^2;
            centre: (0.1, 0.02) m;
            port o: (0, 0) m; port tip: (length, 0);
            start angle: 30 deg, locked; start omega: 1.5 rad/s, locked;
        }
        body arm {
            mass: 1 kg; inertia: 0.02 kg*m^2;
            port a: (-0.4, 0) m, angle: 15 deg; port b: (0.4, 0.1) m;
            start x: 1 m; start y: 0.4 m; start angle: -20 deg;
        }
        body shoe { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port s: (0.05, 0) m; start x: 1.4 m; start y: 0.3 m; start angle: -5 deg; }
        revolute hinge(ground.o, crank.o) { stiffness: 3 N*m/rad; damping: 0.2 N*m*s/rad; }
        revolute elbow(crank.tip, arm.a);
        pin_slot slide(ground.slot, arm.b) { stiffness: 40 N/m; damping: 2 N*s/m; }
        prismatic rail(arm.a, shoe.s) { stiffness: stiff; damping: 5 N*s/m; free_length: 0.8 m; }
        force pull(shoe.a) { x: push * wave; y: if level < 1.5 bar then 1 N else -2 N; torque: 0.1 N*m; axes: body; }
        output hinge.force, elbow.force, crank.angle in deg, level in bar;
    }
}

twice! { four_bar,
    pub FourBar {
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s, locked; }
        body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: 30 deg; }
        body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
        revolute drive(ground.a, crank.a);
        revolute crank_coupler(crank.b, coupler.b);
        revolute coupler_rocker(coupler.c, rocker.c);
        revolute pivot(ground.d, rocker.d);
        output drive.force;
    }
}

/// Continuation data of a formulation with loops, number by number.
fn numbers<M: ContinuationData<f64>, Q>(of_loops: &OfLoops<M, Q>) -> Vec<f64> {
    let OfLoops::InChart { continuation, .. } = of_loops else { return Vec::new() };
    let reaches = continuation
        .coordinates()
        .iter()
        .chain([&continuation.time()])
        .flat_map(|at| [at.last, at.reach])
        .collect();
    let angles = continuation.angles().iter().flat_map(|at| [at.angle, at.cos, at.sin]).collect();
    let iterated = continuation.iterated().iter().flat_map(|at| [at.value, at.rate, at.bend]).collect();
    [reaches, angles, continuation.determinants().to_vec(), iterated].concat()
}

/// Steps a mechanism and compares its rate with the interpreter's at every state on the way.
/// `remembered` reads what a formulation with loops remembers.
fn compare<M: Mechanism<S = f64>>(mechanism: M, text: &str, remembered: impl Fn(&M::U) -> Vec<f64>) {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let expansion = compile(&mut sources);
    let problems: Vec<String> =
        expansion.diagnostics.iter().map(|problem| problem.render(&sources)).collect();
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    let oracle = expansion.oracle.unwrap();
    let mut sim = mechanism.start().unwrap();
    for _ in 0..20 {
        let (state, mut dx) = (*sim.state(), *sim.state().x());
        let health = mechanism.rate(state.time(), &state.held(), state.x(), &mut dx);
        let states = oracle.reduced_states().unwrap_or(oracle.states());
        let mut x: Vec<f64> = (0..states).map(|k| plm::runtime::Vector::at(state.x(), k)).collect();
        x.extend(remembered(&state.held()));
        let expected = oracle.rate(state.time(), &x).unwrap_or_else(|| oracle.dynamics(state.time(), &x));
        for k in 0..states {
            let found = plm::runtime::Vector::at(&dx, k);
            assert_eq!(found.to_bits(), expected[k].to_bits(), "dx[{k}]: {found} {}", expected[k]);
        }
        let expected = if expected.len() > states { expected[expected.len() - 1] } else { 1.0 };
        assert_eq!(health.0.to_bits(), expected.to_bits());
        sim.step(0.02).unwrap();
    }
}

#[test]
fn everything_is_computed_as_the_interpreter_does() {
    compare(everything::Everything::new(), everything::TEXT, |held| numbers(&held.of_loops));
}

// The same without the loop that the slot closes: joint coordinates.
twice! { tree,
    pub Tree {
        gravity: 9.81 m/s^2;
        param length: m = 0.7 m;
        input push: N = 3 N;
        state level: Pa = 2 bar;
        rate level = (1e5 Pa - level) / 0.3 s;
        ground { port o: (0, 0) m; }
        body crank {
            mass: 2 kg; inertia: 0.05 kg*m^2;
            centre: (0.1, 0.02) m;
            port o: (0, 0) m; port tip: (length, 0);
            start angle: 30 deg, locked; start omega: 1.5 rad/s, locked;
        }
        body arm {
            mass: 1 kg; inertia: 0.02 kg*m^2;
            port a: (-0.4, 0) m, angle: 15 deg; port b: (0.4, 0.1) m;
            start angle: -20 deg, locked;
        }
        body shoe { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port s: (0.05, 0) m; start x: 1.4 m; }
        revolute hinge(ground.o, crank.o) { stiffness: 3 N*m/rad; damping: 0.2 N*m*s/rad; }
        revolute elbow(crank.tip, arm.a);
        prismatic rail(arm.a, shoe.s) { stiffness: 300 N/m; damping: 5 N*s/m; free_length: 0.8 m; }
        force pull(shoe.a) { x: push; y: if level < 1.5 bar then 1 N else -2 N; torque: 0.1 N*m; axes: body; }
        output hinge.force, rail.torque, level in bar;
    }
}

#[test]
fn a_tree_is_computed_as_the_interpreter_does() {
    compare(tree::Tree::new(), tree::TEXT, |_| Vec::new());
}

#[test]
fn four_bar_is_computed_as_the_interpreter_does() {
    compare(four_bar::FourBar::new(), four_bar::TEXT, |held| numbers(&held.of_loops));
}

#[test]
fn the_same_declaration_gives_the_same_bytes() {
    let emit = || {
        let mut sources = Sources::new();
        sources.add_text("declaration", everything::TEXT);
        compile(&mut sources).code.unwrap().text()
    };
    assert_eq!(emit(), emit());
}
