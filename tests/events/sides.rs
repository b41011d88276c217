//! Conditions of a declaration: where forces jump, and times that are known.

use plm::{Cause, Dop853, Fault, Gauss, Mechanism as _, Method, Moment as _, RadauIia5, Rk4, Ros34Pw2};

use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A block that a constant force pushes back to the middle from either side: parabolas.
    pub Bang {
        param from: s = 0.3 s;
        param until: s = 0.7 s;
        ground { port o: (0, 0) m; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m; }
        body clock { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m; }
        prismatic rail(ground.o, block.o);
        prismatic other(ground.o, clock.o);
        force back(block.o) { x: if block.x < 0 m then 4 N else -2 N; }
        force pulse(clock.o) { x: if t < from then 0 N else if t < until then 3 N else 0 N; }
        // A spring that does not pull: a kink, at which nothing switches.
        force stop(clock.o) { x: if clock.x < 100 m then 0 N else -10 N/m*(clock.x - 100 m); }
    }
}

/// From 1 at rest under -1: 0 at sqrt(2) with the speed -sqrt(2); then under 2 it comes back after sqrt(2).
fn block(time: f64) -> f64 {
    let fall = 2.0_f64.sqrt();
    let period = 3.0 * fall;
    let t = time - (time / period).floor() * period;
    if t < fall {
        return 1.0 - 0.5 * t * t;
    }
    if t < 2.0 * fall {
        let since = t - fall;
        return -fall * since + since * since;
    }
    let since = t - 2.0 * fall;
    fall * since - 0.5 * since * since
}

#[test]
fn a_force_that_jumps_is_switched_where_it_jumps() {
    let mut sim = Bang::new().start_with(Dop853::new(1e-12)).unwrap();
    let mut worst = 0.0_f64;
    sim.run(20.0, 0.01, |state| worst = worst.max((state.state_of("block").x - block(state.time())).abs()))
        .unwrap();
    assert!(worst < 1e-10, "{worst:e}");
    // Up to 20 s it passes the middle at 1, 2, 4, 5, 7, 8, 10, 11, 13 and 14 times sqrt(2); and two instants.
    assert_eq!(sim.stats().switches, 10 + 2, "{:?}", sim.stats());
    assert!(sim.stats().evaluations < 2000, "{:?}", sim.stats());
}

#[test]
fn known_times_are_hit() {
    // 3 m/s^2 for 0.4 s: 1.2 m/s and 0.24 m, then on.
    let expected = 0.24 + 1.2 * (2.0 - 0.7);
    let mut sim = Bang::new().start_with(Dop853::new(1e-9)).unwrap();
    sim.step(2.0).unwrap();
    assert!((sim.state_of("clock").x - expected).abs() < 1e-13, "{}", sim.state_of("clock").x - expected);
    // Parameters move them; steps of fixed length hit them as well.
    let mechanism = Bang::new().with("from", 0.111).with("until", 0.511);
    let mut sim = mechanism.start_with(Rk4::new(0.04)).unwrap();
    sim.step(2.0).unwrap();
    let expected = 0.24 + 1.2 * (2.0 - 0.511);
    assert!((sim.state_of("clock").x - expected).abs() < 1e-13, "{}", sim.state_of("clock").x - expected);
}

/// Position of the clock of [`Bang`] after 2 s, less the known one, and the steps that it took.
fn off_after_two_seconds<W: Method<Scene>>(method: W) -> Result<(f64, u64), Fault> {
    // 3 m/s^2 from 0.111 to 0.511 s, times that no step of equal length meets by itself.
    let mechanism = Bang::new().with("from", 0.111).with("until", 0.511);
    let mut sim = mechanism.start_with(method)?;
    sim.step(2.0)?;
    // Both times, and the block in the middle at sqrt(2) s.
    assert_eq!(sim.stats().switches, 3, "{:?}", sim.stats());
    Ok(((sim.state_of("clock").x - (0.24 + 1.2 * (2.0 - 0.511))).abs(), sim.stats().steps))
}

#[test]
fn implicit_methods_hit_known_times() {
    let (off, steps) = off_after_two_seconds(RadauIia5::new(1e-9)).unwrap();
    assert!(off < 1e-9 && steps < 200, "{off:e} in {steps} steps");
    let (off, _) = off_after_two_seconds(Ros34Pw2::new(0.04)).unwrap();
    assert!(off < 1e-9, "{off:e}");
    let (off, _) = off_after_two_seconds(Gauss::<_, 2>::new(0.04)).unwrap();
    assert!(off < 1e-9, "{off:e}");
}

scene! {
    /// A spring so stiff that only an L-stable method steps over it, which a known time sets free.
    pub Release {
        ground { port o: (0, 0) m; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 1 m; }
        prismatic rail(ground.o, block.o);
        force hold(block.o) {
            x: if t < 0.37 s then -1e10 N/m*(block.x - 1 m) - 1e6 N*s/m*block.vx else 2 N;
        }
    }
}

#[test]
fn what_was_held_stiffly_starts_at_the_known_time() {
    let known = 1.0 + (1.0 - 0.37_f64).powi(2);
    let mut sim = Release::new().start_with(RadauIia5::new(1e-9)).unwrap();
    sim.step(1.0).unwrap();
    assert!(
        (sim.state_of("block").x - known).abs() < 1e-9,
        "{:e}, {:?}",
        sim.state_of("block").x - known,
        sim.stats()
    );
    assert!(sim.stats().switches == 1 && sim.stats().steps < 100, "{:?}", sim.stats());
    let mut sim = Release::new().start_with(Ros34Pw2::new(0.05)).unwrap();
    sim.step(1.0).unwrap();
    assert!((sim.state_of("block").x - known).abs() < 1e-9, "{:e}", sim.state_of("block").x - known);
}

/// In every formulation: a crank that is braked in one direction of its speed only, a jump in the torque.
macro_rules! braked {
    ($formulation:ident) => {
        mod $formulation {
            scene! {
                pub Braked {
                    formulation: $formulation;
                    gravity: 9.81 m/s^2;
                    ground { port a: (0, 0) m; port d: (1, 0) m; }
                    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; }
                    body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; start angle: 30 deg; }
                    body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0) m; start x: 1 m; start angle: 95 deg; }
                    state heat: J = 0 J;
                    rate heat = if rocker.angle < 80 deg then 2 W else 0 W;
                    revolute drive(ground.a, crank.a) { drive: if coupler.angle < 35 deg then 0.3 N*m else -0.2 N*m; }
                    revolute crank_coupler(crank.b, coupler.b);
                    revolute coupler_rocker(coupler.c, rocker.c);
                    revolute pivot(ground.d, rocker.d);
                    output heat;
                }
            }
        }
    };
}
braked!(loops);
braked!(absolute);

#[test]
fn both_formulations_switch_at_the_same_times() {
    let mut least = loops::Braked::new().start_with(Dop853::new(1e-12)).unwrap();
    let mut other = absolute::Braked::new().start_with(Dop853::new(1e-12)).unwrap();
    for _ in 0..10 {
        least.step(0.1).unwrap();
        other.step(0.1).unwrap();
        assert!((least.state_of("crank").angle - other.state_of("crank").angle).abs() < 1e-9);
        assert!(
            (least.value_of("heat") - other.value_of("heat")).abs() < 1e-9,
            "{} {}",
            least.value_of("heat"),
            other.value_of("heat")
        );
    }
    assert!(least.stats().switches >= 2);
    assert_eq!(least.stats().switches, other.stats().switches);
}

/// A stone that must not fall below -1 m, nor faster than a limit.
macro_rules! falling {
    ($name:ident, $formulation:ident) => {
        mod $name {
            scene! {
                pub Falling {
                    formulation: $formulation;
                    param limit: m/s = 100 m/s;
                    gravity: 2 m/s^2;
                    ground { port o: (0, 0) m, axis: 90 deg; }
                    body stone { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
                    prismatic rail(ground.o, stone.o);
                    require above: stone.y > -1 m and stone.vy >= -limit;
                }
            }
        }
    };
}
falling!(falling_by_tree, tree);
falling!(falling_by_rows, absolute);

#[test]
fn a_run_ends_where_a_requirement_does() {
    let fault = |time| Fault::of_part(time, "above", Cause::Required).to_string();
    let mut sim = falling_by_tree::Falling::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step(0.99).unwrap();
    let found = sim.step(1.0).unwrap_err();
    // y = -t^2.
    assert!((found.time - 1.0).abs() < 1e-12 && (sim.state_of("stone").y + 1.0).abs() < 1e-12, "{found}");
    assert_eq!(found.to_string(), fault(found.time));
    let mut sim = falling_by_rows::Falling::new().with("limit", 1.0).start().unwrap();
    let found = sim.step(2.0).unwrap_err();
    assert!((found.time - 0.5).abs() < 1e-9 && found.part == "above", "{found}");
    // Without dense output it is seen after the step.
    let mut sim = falling_by_tree::Falling::new().start_with(Rk4::new(0.3)).unwrap();
    let found = sim.step(3.0).unwrap_err();
    assert!((found.time - 1.2).abs() < 1e-12, "{found}");
}
