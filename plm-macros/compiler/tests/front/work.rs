//! The front end runs inside rustc, unoptimised, for every user: what it costs.

use std::time::Instant;

use crate::support::{Values, assert_near, resolve};

/// S3 of the benchmark scenes: N bars of 1/N m and 1/N kg.
const CHAIN: &str = "pub Chain {
    gravity: 9.81 m/s^2;
    let n = 64;
    let span = 1/n*1 m;
    let mass = 1/n*1 kg;
    ground { port o: (0, 0) m; }
    repeat i in 0..64 {
        body bar[i] {
            mass: mass; inertia: mass*span^2/12;
            port a: (-span/2, 0); port b: (span/2, 0);
            start x: (i + 0.5)*span;
        }
    }
    revolute pin[0](ground.o, bar[0].a);
    repeat i in 1..64 { revolute pin[i](bar[i-1].b, bar[i].a); }
    repeat i in 0..64 { output pin[i].force; }
}";

#[test]
fn the_chain_of_64_resolves_in_time() {
    let start = Instant::now();
    let model = resolve(CHAIN);
    let taken = start.elapsed();
    println!("chain of 64: {taken:?}, {} nodes", model.graph.len());
    assert_eq!((model.bodies.len(), model.rows.len(), model.outputs.len()), (64, 128, 64));
    assert_eq!(model.rows[127].name, "pin[63].y");
    let values = Values::of(&model);
    assert_near(values.at(&model, model.bodies[5].mass), 1.0 / 64.0, "mass");
    assert_near(values.at(&model, model.bodies[5].inertia), 1.0 / 12.0 / 64_f64.powi(3), "inertia");
    assert_near(values.at(&model, model.bodies[63].start[0].value), 63.5 / 64.0, "start");
    // Wall-clock time on a busy machine: the figure is 100 ms, the bound leaves room for others at work.
    assert!(taken.as_millis() < 1000, "{taken:?}");
}
