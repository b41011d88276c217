//! Friction, contact, nonlinear inputs, and what cannot be moved.

use plm::Moment;
use plm::inverse::{Inverse, NotNamed, Target, Unsolved};

use super::{near, set, started};

#[test]
fn a_slide_that_slips_and_one_that_sticks() {
    let rail = |speed: &str| {
        started(&format!(
            "pub Rail {{
                gravity: 9.81 m/s^2;
                input push: N = 0;
                ground {{ port rail: (0, 0) m; }}
                body block {{ mass: 2 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; start vx: {speed}, locked; }}
                prismatic rail(ground.rail, block.shoe) {{ friction: 0.3; drive: push; damping: 4 N*s/m; }}
            }}"
        ))
    };
    let slips = rail("-1.5 m/s");
    let inverse = Inverse::new(slips.state().mechanism(), ["block.x"], ["push"]).unwrap();
    let [push] = inverse.inputs(&slips, [2.0]).unwrap();
    near(push, 2.0 * 2.0 - 4.0 * 1.5 - 0.3 * 2.0 * 9.81, 1e-12);
    // From rest it slides the way that it is accelerated.
    let sticks = rail("0 m/s");
    for acceleration in [2.0, -2.0_f64] {
        let [push] = inverse.inputs(&sticks, [acceleration]).unwrap();
        near(push, 2.0 * acceleration + acceleration.signum() * 0.3 * 2.0 * 9.81, 1e-12);
    }
}

/// A wheel of radius 0.5 m that rolls: m + I/r^2 resists, and the floor grips with at most 0.5 m g.
#[test]
fn a_wheel_that_rolls_on_a_floor() {
    let sim = started(
        "pub Rolls {
            gravity: 9.81 m/s^2;
            input pull: N = 0;
            input lift: N = 0;
            ground { port o: (0, 0) m; }
            body wheel { mass: 2 kg; inertia: 0.3 kg*m^2; port hub: (0, 0) m; start x: 0.1 m; start y: 0.5 m; }
            force spring(wheel.hub) { x: pull - (40 N/m)*wheel.x; y: lift; }
            unilateral floor: wheel.y >= 0.5 m;
            friction grip: rate(wheel.x + (0.5 m)*wheel.angle) within 0.5*reaction(floor);
            output drag = reaction(grip);
        }",
    );
    let mechanism = *sim.state().mechanism();
    let resistance = 2.0 + 0.3 / 0.25;
    let inverse = Inverse::new(&mechanism, ["wheel.x"], ["pull"]).unwrap();
    near(inverse.inputs(&sim, [5.0]).unwrap()[0], 40.0 * 0.1 + resistance * 5.0, 1e-12);
    // The grip gives I/r^2 a, at most 0.5 m g: up to 8.175 m/s^2.
    near(inverse.inputs(&sim, [8.17]).unwrap()[0], 4.0 + resistance * 8.17, 1e-12);
    // Beyond it slips, and is pulled back by all of the grip.
    near(inverse.inputs(&sim, [8.18]).unwrap()[0], 4.0 + 2.0 * 8.18 + 0.5 * 2.0 * 9.81, 1e-12);
    let drag = Inverse::new(&mechanism, [Target::Value("drag")], ["pull"]).unwrap();
    let [pull] = drag.inputs(&sim, [-1.2]).unwrap();
    near(pull - 4.0, 1.2 * resistance * 0.25 / 0.3, 1e-12);
    // On the floor nothing lifts the wheel, and the floor does not pull.
    let lift = Inverse::new(&mechanism, ["wheel.y"], ["lift"]).unwrap();
    assert_eq!(lift.inputs(&sim, [1.0]).unwrap_err(), Unsolved::Unmoved { time: 0.0, target: "wheel.y" });
    let both = Inverse::new(&mechanism, ["wheel.x", "wheel.y"], ["pull", "lift"]).unwrap();
    let refused = both.inputs(&sim, [1.0, 1.0]).unwrap_err();
    assert_eq!(refused, Unsolved::Unmoved { time: 0.0, target: "wheel.y" });
}

/// Pins and guides rub by their own reactions, which the torque changes: the torque that is found gives the acceleration that was wanted.
#[test]
fn a_linkage_that_rubs() {
    let mut sim = started(
        "pub Press {
            gravity: 9.81 m/s^2;
            input torque: N*m = 2 N*m;
            ground { port o: (0, 0) m; }
            body crank {
                mass: 2 kg; inertia: 0.01 kg*m^2; port o: (-0.03, 0) m; port pin: (0.07, 0) m;
                start angle: 0.4 rad, locked; start omega: 20 rad/s, locked;
            }
            body rod { mass: 1.2 kg; inertia: 0.01 kg*m^2; port pin: (-0.15, 0) m; port end: (0.25, 0) m; }
            body slider { mass: 3 kg; inertia: 0.01 kg*m^2; port end: (0, 0) m; start x: 0.5 m; }
            revolute main(ground.o, crank.o) { drive: torque; friction: 0.15; pin_diameter: 40 mm; }
            revolute pin(crank.pin, rod.pin) { friction: 0.1; pin_diameter: 30 mm; }
            revolute end(rod.end, slider.end);
            prismatic guide(ground.o, slider.end) { friction: 0.2; }
            output crank.alpha;
        }",
    );
    let inverse = Inverse::new(sim.state().mechanism(), ["crank.angle"], ["torque"]).unwrap();
    let mut rubbed = 0;
    for _ in 0..20 {
        sim.step(2e-3).unwrap();
        let alpha = |torque: f64| inverse.with_inputs(sim.state(), &[torque]).output(0).unwrap();
        // A friction that depends on the size of a reaction bends: no straight line.
        rubbed += u32::from((alpha(-30.0) - 2.0 * alpha(0.0) + alpha(30.0)).abs() > 1e-3);
        for wanted in [-300.0, 0.0, 150.0] {
            let [torque] = inverse.inputs(&sim, [wanted]).unwrap();
            near(alpha(torque), wanted, 1e-10);
        }
        near(inverse.inputs(&sim, [alpha(2.0)]).unwrap()[0], 2.0, 1e-9);
    }
    assert!(rubbed > 10, "{rubbed}");
}

#[test]
fn inputs_that_are_no_forces() {
    let mut sim = started(
        "pub Valve {
            input opening: 1 = 1;
            input heat: 1 = 0;
            input late: N = 0;
            ground { port rail: (0, 0) m; }
            body block { mass: 2 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; }
            state filling: N = 0 N;
            rate filling = (late - filling)/(0.1 s);
            prismatic rail(ground.rail, block.shoe) { drive: 3 N*opening^3 + 2 N*opening + filling + 1 N*exp(heat); }
            output speed = block.vx, filling;
        }",
    );
    let mechanism = *sim.state().mechanism();
    let inverse = Inverse::new(&mechanism, ["block.x"], ["opening"]).unwrap();
    let [opening] = inverse.inputs(&sim, [7.0]).unwrap();
    near(3.0 * opening.powi(3) + 2.0 * opening + 1.0, 14.0, 1e-12);
    // exp(heat) is positive: with an opening of 0 there is no negative force.
    set(&mut sim, "opening", 0.0);
    let heat = Inverse::new(&mechanism, ["block.x"], ["heat"]).unwrap();
    near(heat.inputs(&sim, [4.0]).unwrap()[0], 8.0_f64.ln(), 1e-12);
    let refused = heat.inputs(&sim, [-1.0]).unwrap_err();
    assert!(matches!(refused, Unsolved::NotConverged { target: "block.x", .. }), "{refused}");
    // A force after a lag moves the block later; the rate of the lag it moves at once.
    let late = Inverse::new(&mechanism, ["block.x"], ["late"]).unwrap();
    assert!(matches!(late.inputs(&sim, [1.0]).unwrap_err(), Unsolved::Unmoved { target: "block.x", .. }));
    let filling = Inverse::new(&mechanism, [Target::Rate("filling")], ["late"]).unwrap();
    near(filling.inputs(&sim, [30.0]).unwrap()[0], 3.0, 1e-12);
    let speed = Inverse::new(&mechanism, [Target::Rate("speed")], ["opening"]).unwrap();
    let found = speed.inputs(&sim, [7.0]).unwrap();
    near(found[0], opening, 1e-12);
}

#[test]
fn names_that_are_not_there() {
    let sim = started(
        "pub Pendulum {
            input torque: N*m = 0;
            ground { port o: (0, 0) m; }
            body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; }
            revolute hinge(ground.o, bob.pivot) { drive: torque; }
        }",
    );
    let mechanism = sim.state().mechanism();
    let wrong = Inverse::new(mechanism, ["bob.omega"], ["torque"]).unwrap_err();
    assert_eq!(wrong, NotNamed::Coordinate("bob.omega"));
    let wrong = Inverse::new(mechanism, [Target::Rate("omega")], ["torque"]).unwrap_err();
    assert_eq!(wrong, NotNamed::Observed("omega"));
    let wrong = Inverse::new(mechanism, ["bob.angle"], ["force"]).unwrap_err();
    assert_eq!(wrong.to_string(), "there is no input `force`");
}
