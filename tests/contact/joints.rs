//! Friction that the reactions of joints bound.

use plm::{Dop853, Fault, Mechanism as _};

use crate::declared::InThreePins;
use crate::machines::slider_crank;
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// An arm on a horizontal table, with friction in the pin that holds it.
    pub Arm {
        ground { port centre: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 0.5 kg*m^2; port centre: (-1, 0) m; start x: 1 m; start vy: 3 m/s; start omega: 3 rad/s; }
        revolute ring(ground.centre, arm.centre);
        friction rub: rate((1 m)*arm.angle) within 0.2*norm(ring.force);
        output drag = reaction(rub);
    }
}

/// The pin carries m r omega^2 inwards and m r alpha along the way, so that alpha = -k omega^2 with k = s/sqrt(1 - s^2), s = mu m r r'/J (r' the
/// radius of the pin, 1 m), J about the pin; and omega = omega_0/(1 + k omega_0 t).
#[test]
fn an_arm_is_braked_by_the_reaction_of_its_pin() {
    let mut sim = Arm::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(5.0).unwrap();
    let share = 0.2 / 1.5;
    let k: f64 = share / (1.0_f64 - share * share).sqrt();
    near(sim.state_of("arm").omega, 3.0 / (1.0 + 15.0 * k), 1e-10);
    near(sim.state_of("arm").angle, (1.0 + 15.0 * k).ln() / k, 1e-9);
    near(sim.value_of("drag"), -1.5 * k * sim.state_of("arm").omega.powi(2), 1e-10);
}

scene! {
    /// A block on a rail at 30°: both components of the rail's force are shares of one multiplier.
    pub Inclined {
        gravity: 9.81 m/s^2;
        ground { port rail: (0, 0) m, angle: 30 deg; }
        body block { mass: 2 kg; inertia: 0.01 kg*m^2; port shoe: (0, 0) m; }
        prismatic rail(ground.rail, block.shoe);
        friction rub: rate(rail.displacement) within 0.2*norm(rail.force) { static: 0.3*norm(rail.force); }
        output way = rail.displacement;
    }
}

#[test]
fn a_rail_at_an_angle_presses_by_its_normal_force() {
    let mut sim = Inclined::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(1.0).unwrap();
    let way = 0.5 * 9.81 * (0.5 - 0.2 * 0.75_f64.sqrt());
    near(sim.value_of("way"), -way, 1e-12);
}

slider_crank!(InCharts, loops, 30,
    friction rub: rate(slider.x) within mu*norm(rail.force);
    output drag = reaction(rub);
    output normal = norm(rail.force););
slider_crank!(InAbsolute, absolute, 30,
    friction rub: rate(slider.x) within mu*norm(rail.force);
    output drag = reaction(rub);
    output normal = norm(rail.force););
slider_crank!(WithoutFriction, loops, 30, output used = mu;);

/// Crank, drag, normal force, every 0.05 s.
fn course(mechanism: Scene) -> Result<Vec<[f64; 4]>, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(1e-11))?;
    let mut rows = Vec::new();
    for k in 1..=40 {
        sim.step_to(0.05 * f64::from(k))?;
        rows.push([
            sim.state_of("crank").angle,
            sim.state_of("crank").omega,
            sim.value_of("drag"),
            sim.value_of("normal"),
        ]);
    }
    Ok(rows)
}

#[test]
fn a_slider_crank_rubs_the_same_in_all_coordinates() {
    let [charts, absolute] = [InCharts::new(), InAbsolute::new()].map(|crank| course(crank).unwrap());
    for (one, other) in charts.iter().zip(&absolute) {
        near(one[2].abs(), 0.2 * one[3].abs(), 1e-9);
        for (one, other) in one.iter().zip(other) {
            near(*one, *other, 1e-7 * (1.0 + other.abs()));
        }
    }
}

scene! {
    /// A crank that turns against dry friction of its slider.
    pub Rubbing {
        param friction: N = 3 N;
        ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 0 deg; }
        body crank {
            mass: 1 kg; inertia: 0.04 kg*m^2;
            port o: (0, 0) m; port a: (0.1, 0) m;
            start angle: 0 deg, locked;
            start omega: 20 rad/s, locked;
        }
        body rod { mass: 0.5 kg; inertia: 0.004 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start x: 0.25 m; }
        body slider { mass: 2 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; start x: 0.4 m; }
        revolute o(ground.o, crank.o);
        revolute a(crank.a, rod.a);
        revolute b(rod.b, slider.b);
        prismatic rail(ground.rail, slider.b);
        friction rub: rate(slider.x) within friction;
    }
}

/// The energy falls by the friction times the way, also through dead centres, where the row has no direction.
#[test]
fn friction_of_a_slider_does_its_work_through_dead_centres() {
    let mut sim = Rubbing::new().start_with(Dop853::new(1e-11)).unwrap();
    let before = sim.kinetic_energy();
    for k in 1..=400 {
        sim.step_to(0.0025 * f64::from(k)).unwrap();
        let half_turns = (sim.state_of("crank").angle / core::f64::consts::PI).floor();
        let dead_centre = if half_turns % 2.0 == 0.0 { 0.4 } else { 0.2 };
        let way = 0.2 * half_turns + (sim.state_of("slider").x - dead_centre).abs();
        near(before - sim.kinetic_energy(), 3.0 * way, 1e-9);
    }
    assert!(sim.state_of("crank").angle > 15.0, "{:?}", sim.state_of("crank"));
}

/// Steps, evaluations and events of a second.
fn cost(mechanism: Scene) -> [f64; 3] {
    let mut sim = mechanism.with("mu", 0.05).start_with(Dop853::new(1e-9)).unwrap();
    sim.step_to(1.0).unwrap();
    assert!(sim.state_of("crank").angle > 25.0, "{:?}", sim.state_of("crank"));
    [sim.stats().steps, sim.stats().evaluations, sim.stats().switches].map(|count| count as f64)
}

/// Friction with a bound by a reaction costs a tenth of the steps more at most, and an event 60 evaluations, the step that it ends included.
#[test]
fn friction_in_a_slider_crank_costs_few_steps() {
    let [steps, evaluations, _] = cost(WithoutFriction::new());
    for [more_steps, more, events] in [InCharts::new(), InThreePins::new()].map(cost) {
        let each = (more - evaluations * more_steps / steps) / events;
        assert!(
            events >= 20.0 && more_steps <= 1.1 * steps && each <= 60.0,
            "{more_steps} {steps} {events} {each}"
        );
    }
}

macro_rules! pair_of_bars {
    ($name:ident, $($joint:tt)*) => {
        scene! {
            pub $name {
                gravity: 9.81 m/s^2;
                ground { port o: (0, 0) m; }
                body near {
                    mass: 1 kg; inertia: 0.02 kg*m^2;
                    port o: (0, 0.25) m; port p: (0, -0.25) m;
                    start angle: 80 deg, locked; start omega: 0 rad/s, locked;
                }
                body far {
                    mass: 1 kg; inertia: 0.02 kg*m^2; port p: (0, 0.25) m;
                    start angle: 80 deg;
                }
                revolute o(ground.o, near.o);
                $($joint)*
            }
        }
    };
}

pair_of_bars!(Sticking, revolute j(near.p, far.p); friction held: rate(far.angle - near.angle) within 1000 N*m;);
pair_of_bars!(Welded, weld j(near.p, far.p););

#[test]
fn a_joint_that_sticks_costs_the_steps_of_a_weld() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let mut welded = Welded::new().start_with(Dop853::new(tolerance)).unwrap();
        let mut sticking = Sticking::new().start_with(Dop853::new(tolerance)).unwrap();
        welded.step_to(3.0).unwrap();
        sticking.step_to(3.0).unwrap();
        near(sticking.state_of("far").angle, welded.state_of("far").angle, 1e3 * tolerance);
        let [more, steps] = [sticking.stats().steps, welded.stats().steps];
        assert!(more <= steps, "{tolerance}: {more} steps, {steps} of a weld");
        assert!((sticking.state_of("far").angle - sticking.state_of("near").angle).abs() < 1e-13);
    }
}
