//! Equilibria of running simulations: with their inputs, at their time, with methods of choice.

use plm::{Cause, Mechanism as _, Moment as _, RadauIia5, Rk4, Stabilise, StartAuto, stabilise};

use crate::scene::{Given as _, Named as _};
use crate::stabilise::value;

scene! {
    /// A block of 2 kg on a spring of 100 N/m, with a load and a jet that helps where it is low.
    pub Loaded {
        gravity: 9.81 m/s^2;
        input load: N = 0 N;
        ground { port o: (0, 0) m, axis: 90 deg; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m, angle: 90 deg; }
        prismatic rail(ground.o, block.o) { stiffness: 100 N/m; damping: 20 N/(m/s); }
        force push(block.o) { y: load + (if t < 5 s then 0 N else 10 N); }
        // Below -0.5 m it jumps: a side that is held.
        force jet(block.o) { y: if block.y < -0.5 m then 30 N else 0 N; }
    }
}

const WEIGHT: f64 = 2.0 * 9.81;

#[test]
fn inputs_are_those_of_the_simulation() {
    let mechanism = Loaded::new();
    let declared = mechanism.stabilise().unwrap().balanced().unwrap();
    let mut sim = mechanism.start().unwrap();
    assert!((value(&declared, "block.y") + WEIGHT / 100.0).abs() < 1e-9);
    for load in [7.0, -20.0, -70.0] {
        sim.set_input("load", load);
        let found = stabilise(&sim).unwrap().balanced().unwrap();
        // Where the block is low the jet pushes as well.
        let free = (load - WEIGHT) / 100.0;
        let height = if free < -0.5 { free + 0.3 } else { free };
        assert!((value(&found, "block.y") - height).abs() < 1e-9, "{found}");
        // It rests there, with every method and with the input that it was looked for with.
        let mut explicit = found.clone().start().unwrap();
        let mut stiff = found.clone().start_with(RadauIia5::new(1e-8)).unwrap();
        assert_eq!((explicit.input_of("load"), stiff.input_of("load")), (load, load));
        explicit.step(1.0).unwrap();
        stiff.step(1.0).unwrap();
        for block in [explicit.state_of("block"), stiff.state_of("block")] {
            assert!((block.y - height).abs() < 1e-9 && block.vy.abs() < 1e-9, "{block:?}");
        }
    }
}

/// Sources are those of the time at which the simulation is.
#[test]
fn the_time_is_that_of_the_simulation() {
    let mut sim = Loaded::new().start_with(Rk4::new(1e-3)).unwrap();
    sim.step_to(6.0).unwrap();
    let found = stabilise(&sim).unwrap().balanced().unwrap();
    assert!((value(&found, "block.y") - (10.0 - WEIGHT) / 100.0).abs() < 1e-9, "{found}");
    let mut again = found.start_with(Rk4::new(1e-3)).unwrap();
    assert_eq!(again.time(), 6.0);
    let before = again.state_of("block").y;
    again.step(1.0).unwrap();
    assert!((again.state_of("block").y - before).abs() < 1e-9);
    // A state of a run is looked at like a simulation; what moves is at rest in the equilibrium.
    let moving = sim.at(6.1).unwrap();
    assert!((value(&stabilise(&moving).unwrap(), "block.y") - before).abs() < 1e-9);
}

scene! {
    /// A load on a spring that somebody has mistyped: 1 N/m for 1 N/mm.
    pub Soft {
        param stiffness: N/m = 1 N/m;
        ground { port a: (0, 0) m; port b: (0.5, 0) m; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        prismatic rail(ground.a, block.o) { stiffness: stiffness; }
        force pull(block.o) { x: 20 N; }
    }
}

#[test]
fn an_equilibrium_that_is_far_off_is_told() {
    let found = Soft::new().stabilise().unwrap().balanced().unwrap();
    let far = found.far().unwrap();
    assert_eq!(far.name, "block.x");
    assert!((far.moved - 20.0).abs() < 1e-9);
    let told = "far from the start: block.x moved by 20.0000 m, and the mechanism is ";
    assert!(found.to_string().lines().any(|line| line.starts_with(told)), "{found}");
    let stiff = Soft::new().with("stiffness", 1000.0).stabilise().unwrap();
    assert!(stiff.far().is_none() && !stiff.to_string().contains("far from"), "{stiff}");
}

#[test]
fn a_chosen_method_switches_where_the_method_does() {
    let mechanism = Loaded::new();
    let mut auto = mechanism.start_auto().unwrap();
    let choice = *auto.method().choice();
    assert!(!choice.stiff);
    let mut explicit = mechanism.start_with(plm::Dop853::new(1e-8)).unwrap();
    for sim_load in [-100.0, 0.0] {
        auto.set_input("load", sim_load);
        explicit.set_input("load", sim_load);
        auto.step(1.5).unwrap();
        explicit.step(1.5).unwrap();
    }
    assert_eq!((auto.state_of("block"), auto.stats()), (explicit.state_of("block"), explicit.stats()));
    assert!(auto.stats().switches > 1);
    auto.reset().unwrap();
    assert_eq!((auto.time(), auto.method().choice()), (0.0, &choice));
    assert!(matches!(auto.at(-1.0).unwrap_err().cause, Cause::Interval { .. }));
}
