//! Both forms of the right-hand side of a tree, the dense one and elimination body by body, at the same states.
#![allow(clippy::unwrap_used, reason = "tests")]

use plm_cas::{Expr, algebra};

use super::charts;
use super::tree::augmented;
use crate::derive::derive;
use crate::diag::Diagnostics;
use crate::formulate::reduced::charts::Scheme;
use crate::formulate::reduced::charts::kinematics::kinematics;
use crate::formulate::reduced::joints::coordinates::Coordinates;
use crate::formulate::reduced::layout::Layout;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::front;
use crate::model::Model;
use crate::numeric;
use crate::token::Sources;

/// Reads the declaration of a tree and hands on its layout.
fn with_layout<T>(declaration: &str, then: impl FnOnce(Layout, &Motion, &Scheme) -> T) -> T {
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_text("scene", declaration);
    let mut model = front::read(&mut sources, &mut sink).model(&mut sink).unwrap();
    let mut graph = std::mem::take(&mut model.graph);
    graph.enter(|| laid_out(&model, then))
}

fn laid_out<T>(model: &Model, then: impl FnOnce(Layout, &Motion, &Scheme) -> T) -> T {
    let equations = derive(model);
    let coordinates = Coordinates::new(model).unwrap();
    let scheme = charts::schemes(model, &coordinates).unwrap().remove(0);
    let memory = Memory::new(&coordinates, (scheme.independent.len(), 0), &[]);
    let length = Expr::ONE;
    let motion = kinematics(model, &coordinates, &scheme, &memory, length);
    let (equations, lambda) = (&equations, &equations.lambda[..]);
    let layout = Layout { model, equations, coordinates: &coordinates, memory: &memory, length, lambda };
    then(layout, &motion, &scheme)
}

/// The largest difference of two forms over the largest acceleration, at so many random states.
fn difference(declaration: &str, states: u64) -> f64 {
    with_layout(declaration, |layout, motion, scheme| difference_at(layout, motion, scheme, states))
}

fn difference_at(mut layout: Layout, motion: &Motion, scheme: &Scheme, states: u64) -> f64 {
    let forms = layout.forms(motion, scheme);
    assert_eq!(forms.len(), 2);
    let Layout { model, .. } = layout;
    let defaults = numeric::defaults(model);
    let mut random = numeric::Random(1);
    let mut worst = 0.0_f64;
    for _ in 0..states {
        let mut values: Vec<(Expr, f64)> = defaults.clone();
        for &symbol in motion.value.iter().chain(&motion.rate) {
            values.push((symbol, 2.0 * random.unit()));
        }
        let [dense, articulated] = [&forms[0], &forms[1]].map(|form| {
            let roots: Vec<Expr> = form.rate.results.iter().map(|&(_, value)| value).collect();
            algebra::tape(&roots).eval(&values).unwrap()
        });
        let size = dense.iter().fold(0.0_f64, |size, a| size.max(a.abs()));
        for (a, b) in dense.iter().zip(&articulated) {
            worst = worst.max((a - b).abs() / size);
        }
    }
    worst
}

fn agree(declaration: &str) {
    let difference = difference(declaration, 50);
    println!("{difference:.1e}");
    assert!(difference < 1e-12, "{difference:.1e}");
}

#[test]
fn revolutes_in_a_tree() {
    agree(
        "Tree { gravity: 9.81 m/s^2;
        ground { port o: (0.1, -0.2) m; }
        body a { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; port r: (0.1, 0.3) m; }
        body b { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; port q: (0.2, 0.1) m; }
        body c { mass: 1 kg; inertia: 0.05 kg*m^2; port r: (-0.3, 0.05) m; }
        body d { mass: 0.3 kg; inertia: 0.02 kg*m^2; port q: (-0.2, 0) m; port s: (0.1, 0) m; }
        revolute first(ground.o, a.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
        revolute second(b.p, a.p) { stiffness: 2 N*m/rad; rest: 30 deg; }
        revolute third(a.r, c.r);
        revolute fourth(b.q, d.q);
        spring leash(c.r, d.s) { stiffness: 50 N/m; free_length: 0.4 m; } }",
    );
}

#[test]
fn slides_either_way() {
    agree(
        "Slides { gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; port g: (0.3, 0.1) m, angle: 20 deg; }
        body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port rail: (0.1, 0.3) m, angle: 25 deg; }
        body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0.05, -0.02) m, angle: 10 deg; port s: (0.1, 0.1) m, angle: -35 deg; }
        body tip { mass: 0.5 kg; inertia: 0.01 kg*m^2; port p: (0.1, 0) m; port s: (0, 0.1) m, angle: 40 deg; }
        body last { mass: 0.4 kg; inertia: 0.01 kg*m^2; port p: (0.1, 0.05) m, angle: 15 deg; }
        body slow { mass: 0.4 kg; inertia: 0.01 kg*m^2; port g: (0.1, 0.05) m, angle: 15 deg; port p: (0.1, 0) m; }
        body swing { mass: 0.4 kg; inertia: 0.01 kg*m^2; port p: (0.1, -0.2) m, angle: 15 deg; }
        revolute hinge(arm.o, ground.o);
        prismatic rail(arm.rail, shoe.a) { stiffness: 200 N/m; damping: 3 N*s/m; free_length: 0.2 m; }
        pin_slot slot(shoe.s, tip.p) { stiffness: 150 N/m; }
        pin_slot back(last.p, tip.s);
        prismatic guide(slow.g, ground.g);
        pin_slot other(swing.p, slow.p); }",
    );
}

#[test]
fn welded_free_and_on_a_moving_pivot() {
    agree(
        "Others { gravity: 1.5 m/s^2;
        ground { port o: (0.1 m * sin(7 rad/s * t), 0.05 m * cos(11 rad/s * t)); port w: (1, 0) m; }
        body plate { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port w: (0.2, 0.1) m, angle: 15 deg; }
        body block { mass: 1 kg; inertia: 0.03 kg*m^2; port w: (-0.1, 0) m; port hook: (0.2, 0) m; }
        body bird { mass: 0.3 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; }
        body tail { mass: 0.1 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; }
        body stone { mass: 5 kg; inertia: 0.1 kg*m^2; port w: (0, 0) m; port p: (0.2, 0.1) m; }
        body bell { mass: 0.5 kg; inertia: 0.1 kg*m^2; port p: (0.1, 0) m; }
        revolute hinge(ground.o, plate.o);
        weld seam(plate.w, block.w);
        revolute flap(bird.hook, tail.hook);
        weld base(ground.w, stone.w);
        revolute clapper(bell.p, stone.p);
        spring leash(block.hook, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; } }",
    );
}

fn chain(bars: u32) -> String {
    format!(
        "Chain {{ gravity: 9.81 m/s^2;
        ground {{ port o: (0, 0) m; }}
        repeat i in 0..{bars} {{ body bar[i] {{ mass: 1 kg; inertia: 0.1 kg*m^2; port a: (-0.5, 0) m; port b: (0.5, 0) m; }} }}
        revolute pin[0](ground.o, bar[0].a);
        repeat i in 1..{bars} {{ revolute pin[i](bar[i-1].b, bar[i].a) {{ stiffness: 3 N*m/rad; }} }} }}"
    )
}

#[test]
fn a_chain() {
    agree(&chain(12));
}

/// With more bodies than sums along a tree are left as they are for.
#[test]
fn a_chain_that_carries_many_bodies() {
    let weights = "repeat i in 0..12 { repeat j in 0..5 {
        body weight[5*i + j] { mass: 0.1 kg + j*0.05 kg; inertia: 0.01 kg*m^2; port p: (0.1, -0.2) m; }
        weld seam[5*i + j](bar[i].b, weight[5*i + j].p); } } }";
    let bars = chain(12);
    agree(&format!("{} {weights}", bars.trim_end().trim_end_matches('}')));
}

/// Operations for the coefficients, products of a decomposition, and those of a solution, along a chain.
#[test]
fn implicit_methods_work_in_proportion_to_the_bodies() {
    let cost = |bars: u32| {
        with_layout(&chain(bars), |Layout { model, equations, .. }, motion, _| {
            let augmented = augmented::laid_out(model, equations, motion);
            let pivots = &augmented.pattern.pivots;
            let products = pivots.iter().map(|pivot| pivot.below.len() * (1 + pivot.right.len()));
            let coefficients = augmented.coefficients.tape().count().total();
            [coefficients, products.sum(), augmented.terms.len() + augmented.pattern.places.len()]
        })
    };
    let counts = [8, 16, 32].map(cost);
    println!("{counts:?}");
    for [few, some, many] in [0, 1, 2].map(|k| counts.map(|count| count[k])) {
        let (per_bar, later) = ((some - few) as f64 / 8.0, (many - some) as f64 / 16.0);
        assert!(
            (later / per_bar - 1.0).abs() < 0.02,
            "{few}, {some}, {many}: {per_bar} then {later} per bar"
        );
    }
}
