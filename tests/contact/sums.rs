//! Bounds that read several reactions: guides that bear a moment, a drum that rubs in its pin, at its rope and under a shoe.

use plm::{Dop853, Mechanism as _};

use crate::near;
use crate::scene::Named as _;

macro_rules! drawers {
    ($name:ident, $formulation:ident) => {
        scene! {
            pub $name {
                // A guide whose two ends press: the force in the middle and the moment are borne by both.
                joint guide(a: frame, b: frame) {
                    pair: prismatic;
                    param length: m;
                    param mu: 1;
                    let along = dot(b.position - a.position, a.axis);
                    constraint normal: cross(b.position - a.position, a.axis) = 0;
                    constraint angle: a.angle - b.angle = 0;
                    let middle = reaction(normal)/2;
                    let moment = reaction(angle)/length;
                    friction rub: rate(along) within mu*(abs(middle + moment) + abs(middle - moment));
                    output first = middle + moment, second = middle - moment, drag = reaction(rub);
                }
                part pull(on: frame) {
                    input force: N = 0 N;
                    force on on: (force, 0 N);
                }
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                ground { port rail: (0, 0) m, axis: 0 deg; }
                body drawer { mass: 2 kg; inertia: 0.1 kg*m^2; port slot: (0, 0) m; port knob: (0, 0.5) m; }
                body jammed { mass: 2 kg; inertia: 0.1 kg*m^2; port slot: (0, 0) m; port knob: (0, 0.5) m; }
                guide slides(ground.rail, drawer.slot) { length: 0.4 m; mu: 0.2; }
                guide jams(ground.rail, jammed.slot) { length: 0.4 m; mu: 0.5; }
                pull first(drawer.knob) { force: 4 N/s*t; }
                pull second(jammed.knob) { force: 4 N/s*t; }
                output slides.first, slides.second, slides.drag, jams.drag;
            }
        }
    };
}

drawers!(InJoints, tree);
drawers!(InBodies, absolute);

/// A force F at the height h over a guide of the length L turns the drawer with F h, so that its ends carry W/2 + F h/L and W/2 - F h/L. With
/// both of one sign the friction is mu W, and 2 mu F h/L after the time at which one is zero. Where 2 mu h/L is above 1 no force moves it.
#[test]
fn a_drawer_slides_or_jams_by_the_height_of_its_knob() {
    let (mass, weight, mu, lever, growth) = (2.0, 2.0 * 9.81, 0.2, 0.5 / 0.4, 4.0);
    let breaks = mu * weight / growth;
    let turns = 0.5 * weight / lever / growth;
    let [cubed, squared] = [3, 2].map(|power| f64::powi(turns - breaks, power));
    let (place, speed) = (growth / (6.0 * mass) * cubed, growth / (2.0 * mass) * squared);
    let left = growth * (1.0 - 2.0 * mu * lever) / mass;
    for drawers in [InJoints::new(), InBodies::new()] {
        let mut sim = drawers.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.9 * breaks).unwrap();
        near(sim.state_of("drawer").x, 0.0, 0.0);
        near(sim.value_of("slides.drag"), -0.9 * mu * weight, 1e-11);
        sim.step_to(0.5 * (breaks + turns)).unwrap();
        near(sim.state_of("drawer").x, place / 8.0, 1e-11);
        near(sim.value_of("slides.drag"), -mu * weight, 1e-11);
        let time = 3.0;
        sim.step_to(time).unwrap();
        let since = time - turns;
        let x = place
            + speed * since
            + 0.5 * left * ((time.powi(3) - turns.powi(3)) / 3.0 - turns * turns * since);
        near(sim.state_of("drawer").x, x, 1e-11);
        near(sim.state_of("drawer").vx, speed + 0.5 * left * (time * time - turns * turns), 1e-11);
        let ends = [0.5 * weight + growth * time * lever, 0.5 * weight - growth * time * lever];
        let found = [sim.value_of("slides.first"), sim.value_of("slides.second")];
        let pairs = found.iter().map(|found| found.abs()).zip(ends.map(f64::abs));
        assert!(found[0] * found[1] < 0.0);
        near(found[0].abs().max(found[1].abs()), ends[0].abs().max(ends[1].abs()), 1e-10);
        near(pairs.map(|(a, b)| a - b).sum(), 0.0, 1e-10);
        near(sim.value_of("slides.drag"), -2.0 * mu * growth * time * lever, 1e-10);
        assert_eq!(sim.contact_stats().slips, 1);
        sim.step_to(60.0).unwrap();
        near(sim.state_of("jammed").x, 0.0, 0.0);
        near(sim.value_of("jams.drag"), -240.0, 1e-9);
    }
}

scene! {
    /// A load on a drum, which rubs in its pin, under a shoe that lies on it, and by the stiffness of its rope.
    pub Hoist {
        part press(on: body) {
            input force: N = 0 N;
            force on on: (force, 0 N);
        }
        gravity: 9.81 m/s^2;
        param arm: m = 20 mm;
        ground { port o: (0, 0) m; }
        body drum { mass: 4 kg; inertia: 0.05 kg*m^2; port o: (0, 0) m; }
        body load { mass: 5 kg; inertia: 1 kg*m^2; start y: -1 m; }
        body shoe { mass: 3 kg; inertia: 1 kg*m^2; start y: 0.2 m; }
        revolute o(ground.o, drum.o);
        constraint level: load.angle = 0;
        constraint plumb: load.x = 0;
        constraint upright: shoe.angle = 0;
        constraint over: shoe.x = 0;
        constraint rope: load.y + 0.15*drum.angle*(1 m) = -1 m;
        press push(drum) { force: 400 N - 100 N/s*t; }
        unilateral lies: shoe.y - drum.y >= 0.2 m;
        friction rub: rate(drum.angle)
            within arm*norm(o.force) + (5 mm)*abs(reaction(rope)) + 0.2*(0.1 m)*reaction(lies);
        output carries = norm(o.force), tension = reaction(rope), push = reaction(lies), drag = reaction(rub);
    }
}

/// With what the pin carries, P = sqrt((M + w)^2 g^2 + F^2), and the tension m (g - r a): it turns when m g (r - s) is
/// c P + b w g, and then with (m g (r - s) - c P - b w g)/(J + m r (r - s)).
#[test]
fn a_drum_rubs_by_its_pin_its_rope_and_its_shoe() {
    let g = 9.81_f64;
    let (radius, stiff, arm, shoe) = (0.15, 0.005, 0.02, 0.2 * 0.1 * 3.0 * g);
    let down = 7.0 * g;
    let torque = 5.0 * g * (radius - stiff) - shoe;
    let inertia = 0.05 + 5.0 * radius * (radius - stiff);
    let carries = torque / arm;
    let turns = (400.0 - (carries * carries - down * down).sqrt()) / 100.0;
    // The integral of sqrt(A^2 + F^2) by F.
    let area = |f: f64| 0.5 * (f * f.hypot(down) + down * down * (f / down).asinh());
    let mut sim = Hoist::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(0.99 * turns).unwrap();
    near(sim.state_of("drum").angle, 0.0, 0.0);
    near(sim.value_of("drag").abs(), 5.0 * g * radius, 1e-11);
    let time = 6.0;
    sim.step_to(time).unwrap();
    let by_pin = arm * (area(400.0 - 100.0 * turns) - area(400.0 - 100.0 * time)) / 100.0;
    near(sim.state_of("drum").omega, (torque * (time - turns) - by_pin) / inertia, 1e-9);
    near(sim.value_of("carries"), 200.0_f64.hypot(down), 1e-9);
    near(sim.value_of("push"), 3.0 * g, 1e-9);
    let alpha = (torque - arm * sim.value_of("carries")) / inertia;
    near(sim.value_of("tension").abs(), 5.0 * (g - radius * alpha), 1e-9);
    near(
        sim.value_of("drag").abs(),
        arm * sim.value_of("carries") + stiff * sim.value_of("tension").abs() + shoe,
        1e-9,
    );
}
