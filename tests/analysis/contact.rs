//! Friction and unilateral contact: the linear system of the modes held, and equilibria that rest on rows.

use plm::runtime::linalg::Dense;
use plm::runtime::{Linear as _, Rate, Vector as _};
use plm::{
    Cause, Dop853, Equilibrium, Linearisation, Mechanism as _, Moment as _, Sim, Stabilise, Support,
    linearise, stabilise,
};

use crate::declared::{Feet, Ladder, Slope, wheel};
use crate::scene::{Given as _, Named as _, Scene};

/// The eigenvalues that are not zero.
fn frequencies(system: &Linearisation) -> Vec<f64> {
    let modes = system.modes();
    assert!(modes.iter().all(|mode| mode.eigenvalue.re.abs() < 1e-9), "{system}");
    modes.iter().map(|mode| mode.frequency).filter(|frequency| *frequency > 1e-6).collect()
}

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}");
}

/// Where it grips it rolls, with m + I/r^2; where it slips its friction is known, and it swings with m alone.
#[test]
fn a_wheel_rolls_or_slips() {
    macro_rules! in_formulation {
        ($module:ident) => {{
            let scene = wheel::$module::Scene::new();
            let rolls = linearise(&scene.start().unwrap()).unwrap();
            let inertia = 2.0 + 0.3 / 0.25;
            assert_eq!(rolls.a.shape(), (2, 2));
            for frequency in frequencies(&rolls) {
                near(frequency, f64::sqrt(40.0 / inertia), 1e-9);
            }
            // Of a pull the grip takes I/r^2 of m + I/r^2.
            near(rolls.d[(1, 0)], -0.3 / 0.25 / inertia, 1e-12);

            let scene = scene.with("mu", 0.05);
            let mut sim = scene.start().unwrap();
            sim.step_to(0.1).unwrap();
            let slips = linearise(&sim).unwrap();
            assert_eq!(slips.a.shape(), (4, 4));
            let found = frequencies(&slips);
            assert_eq!(found.len(), 2);
            for frequency in found {
                near(frequency, f64::sqrt(40.0 / 2.0), 1e-9);
            }
            assert_eq!(slips.d[(1, 0)], 0.0);

            let scene = scene.with_start("wheel.y", 0.6);
            assert_eq!(linearise(&scene.start().unwrap()).unwrap().a.nrows(), 6);
        }};
    }
    in_formulation!(least);
    in_formulation!(absolute);
}

in_both_formulations!(ladder {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body ladder {
        mass: 3 kg;
        inertia: 1 kg*m^2;
        port top: (0, 1) m;
        port foot: (0, -1) m;
        start angle: 25 deg, locked;
        start x: sin(25 deg)*(1 m), locked;
        start y: cos(25 deg)*(1 m), locked;
    }
    body bob { mass: 1 kg; inertia: 0.1 kg*m^2; port pin: (0, 0.4) m; start angle: -10 deg; start x: 0.4 m; start y: 1.4 m; }
    revolute hinge(ladder.top, bob.pin);
    unilateral wall: ladder.top.x >= 0 m;
    unilateral floor: ladder.foot.y >= 0 m;
    friction slide: rate(ladder.foot.x) within 0.2*reaction(floor);
    friction climb: rate(ladder.top.y) within 0.3*reaction(wall);
    friction rub: rate(bob.angle - ladder.angle) within 0.2*(0.05 m)*norm(hinge.force);
});

/// Derivatives of the rates beside differences, in the modes held; with pushes, slips and a bound by the load of a pin.
#[test]
fn derivatives_are_those_of_the_rates() {
    fn differs(sim: &Sim<Scene, Dop853<Scene>>, coordinates: usize) -> f64 {
        let (mechanism, held, time, x) =
            (sim.state().mechanism(), sim.state().held(), sim.state().time(), *sim.state().x());
        let mut matrix = <<Scene as Rate>::X as Dense<f64>>::zeros();
        assert!(mechanism.jacobian(time, &held, &x, &mut matrix, None).is_good());
        // The room after the coordinates is nobody's.
        let used = || [0, Scene::NQ].into_iter().flat_map(|first| first..first + coordinates);
        let mut worst = 0.0_f64;
        for column in used() {
            let h = 1e-6;
            let [low, high] = [-h, h].map(|h| {
                let (mut moved, mut rate) = (x, x);
                moved.set(column, x.at(column) + h);
                Rate::rate(mechanism, time, &held, &moved, &mut rate);
                rate
            });
            for row in used() {
                let slope = (high.at(row) - low.at(row)) / (2.0 * h);
                let exact = <Scene as Rate>::X::entry(&matrix, row, column);
                worst = worst.max((slope - exact).abs() / (1.0 + exact.abs()));
            }
        }
        worst
    }
    let mut least = ladder::least::Scene::new().start().unwrap();
    let mut absolute = ladder::absolute::Scene::new().start().unwrap();
    for until in [0.05, 0.2, 0.4, 0.6] {
        least.step_to(until).unwrap();
        absolute.step_to(until).unwrap();
        println!("{:?}", least.contacts().collect::<Vec<_>>());
        // Differences of that length leave 1e-8 of the largest terms.
        assert!(
            differs(&least, 4) < 1e-6 && differs(&absolute, 6) < 1e-6,
            "{until}: {} {}",
            differs(&least, 4),
            differs(&absolute, 6)
        );
    }
}

fn support<M: Stabilise>(found: &Equilibrium<M>, name: &str) -> Support {
    found.supports.iter().find(|support| support.name == name).unwrap().clone()
}

fn value<M: Stabilise>(found: &Equilibrium<M>, name: &str) -> f64 {
    found.values.iter().find(|change| change.name == name).unwrap().value
}

#[track_caller]
fn gives<M: Stabilise>(found: &Equilibrium<M>, name: &str, (force, used): (f64, Option<f64>)) {
    let Support { force: found_force, used: found_used, .. } = support(found, name);
    near(found_force.unwrap(), force, 1e-9 * force.abs().max(1.0));
    assert_eq!(found_used.is_some(), used.is_some(), "{name}");
    near(found_used.unwrap_or_default(), used.unwrap_or_default(), 1e-9);
}

/// A block that hangs in the air is put down; friction holds it up to tan(tilt) = mu.
#[test]
fn a_block_rests_on_a_slope_by_friction() {
    let found = Slope::new().stabilise().unwrap().balanced().unwrap();
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    gives(&found, "plane", (19.62 * cos, None));
    gives(&found, "slip", (19.62 * sin, Some(sin / cos / 0.5)));
    assert!(found.to_string().contains("slip holds by 6.71044, 72.7940 % of its bound"), "{found}");
    let mut sim = found.start().unwrap();
    let before = sim.state_of("block").x;
    sim.step(10.0).unwrap();
    // Where the run begins the gap of rounding is closed.
    near(sim.state_of("block").x, before, 1e-13);
    // Where the run is, it rests.
    assert!(stabilise(&sim).unwrap().values[0].moved.abs() < 1e-13);

    let steep = Slope::new().with("tilt", 30_f64.to_radians());
    let fault = steep.stabilise().unwrap_err();
    assert_eq!((fault.part, fault.cause), ("slip", Cause::Slips));
}

/// The wall pushes by W tan(theta)/2, theta from the vertical, and the floor takes that by friction.
#[test]
fn a_ladder_leans_on_a_wall() {
    let found = Ladder::new().stabilise().unwrap().balanced().unwrap();
    let (weight, tan) = (3.0 * 9.81, 25_f64.to_radians().tan());
    gives(&found, "floor", (weight, None));
    gives(&found, "wall", (0.5 * weight * tan, None));
    gives(&found, "slide", (-0.5 * weight * tan, Some(0.5 * tan / 0.4)));
    near(value(&found, "ladder.angle"), 25_f64.to_radians(), 1e-12);
}

/// What is stretched too far for its friction comes to rest where it needs none; what is stretched less stays.
#[test]
fn a_wheel_on_a_spring_stays_where_its_grip_is_enough() {
    macro_rules! in_formulation {
        ($module:ident) => {{
            let scene = wheel::$module::Scene::new();
            let found = scene.stabilise().unwrap().balanced().unwrap();
            // It rolls: the grip holds no static force of a wheel that nothing turns.
            near(value(&found, "wheel.x"), 0.0, 1e-12);
            gives(&found, "grip", (0.0, Some(0.0)));
            gives(&found, "floor", (19.62, None));
            let found = scene.with_lock("wheel.angle", 0.0).stabilise().unwrap();
            near(value(&found, "wheel.x"), 0.1, 1e-12);
            gives(&found, "grip", (4.0, Some(4.0 / 9.81)));
            // The lock takes the torque.
            assert_eq!(found.residuals.len(), 1);
            near(found.residuals[0].value.abs(), 2.0, 1e-9);
        }};
    }
    in_formulation!(least);
    in_formulation!(absolute);
}

/// A stop carries the weight of an arm; of two feet the pushes are known, and how they share a friction is not.
#[test]
fn an_arm_rests_on_its_stop_and_a_table_on_its_feet() {
    let found = Feet::new().stabilise().unwrap().balanced().unwrap();
    near(value(&found, "arm.angle"), -30_f64.to_radians(), 1e-12);
    let names: Vec<&str> = found.supports.iter().map(|support| support.name).collect();
    assert_eq!(names, ["stop", "left", "right", "left_grip", "right_grip"]);
    assert!(found.supports.iter().all(|support| support.force.is_none()), "{found}");
    let mut sim = found.start().unwrap();
    sim.step(1.0).unwrap();
    assert!(sim.is_undetermined());
    assert_eq!((sim.state_of("arm").omega, sim.state_of("table").vx), (0.0, 0.0));
}
