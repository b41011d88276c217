//! Every scene on every rung that holds it: the same accelerations, the same motion, the same reactions.

use plm::runtime::Absolute;
use plm::{BodyState, Dop853, Moment, System};

/// A mechanism on the rung that is taken, and on rung 5.
macro_rules! on_both {
    ($test:ident, [$($body:ident),+], [$($output:ident),*], { $($item:tt)* }) => {
        mod $test {
            pub(super) mod least {
                plm::mechanism! { pub Scene { rung: tree; $($item)* } }
            }
            pub(super) mod absolute {
                plm::mechanism! { pub Scene { rung: absolute; $($item)* } }
            }
        }

        #[test]
        fn $test() {
            let (least, absolute) = ($test::least::Scene::new(), $test::absolute::Scene::new());
            let mut one = least.start_with(Dop853::new(1e-12)).unwrap();
            let mut other = absolute.start_with(Dop853::new(1e-12)).unwrap();
            for step in 0..=5 {
                let (state, reference) = (*one.state(), *other.state());
                $(close(concat!(stringify!($body), " moves"), values(state.$body()), values(reference.$body()), 1e-9);)+
                $(close(stringify!($output), state.$output(), reference.$output(), 1e-7);)*
                // The pose closes the joints to rounding.
                let q: Vec<f64> = [$(state.$body()),+].iter().flat_map(|body| [body.x, body.y, body.angle]).collect();
                let phi = absolute.phi(state.time(), q.as_slice().try_into().unwrap());
                assert!(phi.iter().all(|gap| gap.abs() < 64.0 * f64::EPSILON * 4.0), "{step}: {phi:?}");
                // At one state, accelerations by a difference quotient against those of rung 5.
                let x: Vec<f64> = on_rung_5(&[$(state.$body()),+]);
                let at = x.as_slice().try_into().unwrap();
                let mut expected = *reference.x();
                let _ = absolute.rate(state.time(), &reference.held(), &at, &mut expected);
                let (mut dx, h) = (*state.x(), 1e-6);
                let _ = least.rate(state.time(), &state.held(), state.x(), &mut dx);
                let beside = |h: f64| {
                    let mut x = *state.x();
                    for k in 0..x.len() {
                        x[k] += h * dx[k];
                    }
                    let mut moved = state;
                    moved.set(state.time() + h, &state.held(), &x);
                    [$(moved.$body()),+]
                };
                let (after, before) = (beside(h), beside(-h));
                for (k, (after, before)) in after.iter().zip(&before).enumerate() {
                    let [.., vx, vy, omega] = values(*after);
                    let [.., ux, uy, nu] = values(*before);
                    let offset = x.len() / 2 + 3 * k;
                    for (i, change) in [vx - ux, vy - uy, omega - nu].into_iter().enumerate() {
                        let (found, wanted) = (change / (2.0 * h), expected[offset + i]);
                        assert!((found - wanted).abs() < 1e-7 * (1.0 + wanted.abs()), "body {k}, {i}: {found} {wanted}");
                    }
                }
                one.step(0.1).unwrap();
                other.step(0.1).unwrap();
            }
        }
    };
}

/// `[q, v]` of the bodies: the state on rung 5 of a scene without first-order states.
fn on_rung_5(bodies: &[BodyState<f64>]) -> Vec<f64> {
    let poses = bodies.iter().flat_map(|body| [body.x, body.y, body.angle]);
    let speeds = bodies.iter().flat_map(|body| [body.vx, body.vy, body.omega]);
    poses.chain(speeds).collect()
}

fn values(body: BodyState<f64>) -> [f64; 6] {
    [body.x, body.y, body.angle, body.vx, body.vy, body.omega]
}

fn close<const N: usize>(what: &str, found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.iter().zip(&wanted) {
        assert!((found - wanted).abs() < tolerance * (1.0 + wanted.abs()), "{what}: {found} and {wanted}");
    }
}

on_both!(two_revolutes_off_the_axis, [arm, forearm], [elbow_force], {
    gravity: 9.81 m/s^2;
    ground { port o: (0.1, -0.2) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; start angle: 20 deg, locked; start omega: 2 rad/s, locked; }
    body forearm { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; start angle: -50 deg, locked; start omega: -1 rad/s, locked; }
    revolute shoulder(ground.o, arm.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
    revolute elbow(arm.p, forearm.p) { stiffness: 2 N*m/rad; rest: 30 deg; }
    output elbow.force;
});

on_both!(slides_on_turning_axes, [arm, shoe, tip], [rail_force, slot_force], {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port rail: (0.1, 0.3) m, angle: 25 deg; start angle: 40 deg, locked; start omega: 1 rad/s, locked; }
    body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0.05, -0.02) m, angle: 10 deg; port s: (0.1, 0.1) m, angle: -35 deg; start x: 0.6 m; start y: 0.6 m; start angle: 55 deg; start vx: 0.3 m/s; }
    body tip { mass: 0.5 kg; inertia: 0.01 kg*m^2; port p: (0.1, 0) m; start x: 0.9 m; start y: 0.7 m; start angle: 10 deg, locked; start omega: 2 rad/s, locked; }
    revolute hinge(arm.o, ground.o);
    prismatic rail(arm.rail, shoe.a) { stiffness: 200 N/m; damping: 3 N*s/m; free_length: 0.2 m; }
    pin_slot slot(shoe.s, tip.p) { stiffness: 150 N/m; rotary_damping: 0.05 N*m*s/rad; }
    output rail.force, slot.force;
});

on_both!(from_the_child_to_the_ground, [shoe, arm], [], {
    gravity: 9.81 m/s^2;
    ground { port a: (0.2, 0.1) m; }
    body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port rail: (0.05, 0.02) m, angle: 30 deg; port p: (0.2, 0) m; start angle: -30 deg; start x: 0.5 m; }
    body arm { mass: 0.5 kg; inertia: 0.02 kg*m^2; port p: (-0.3, 0) m; start angle: 10 deg, locked; }
    prismatic rail(shoe.rail, ground.a) { stiffness: 100 N/m; }
    pin_slot slot(arm.p, shoe.p) { stiffness: 80 N/m; }
});

on_both!(welded_and_free_bodies, [plate, block, bird], [seam_force], {
    gravity: 1.5 m/s^2;
    ground { port o: (0, 0) m; }
    body plate { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port w: (0.2, 0.1) m, angle: 15 deg; start angle: 10 deg, locked; start omega: 3 rad/s, locked; }
    body block { mass: 1 kg; inertia: 0.03 kg*m^2; port w: (-0.1, 0) m; port hook: (0.2, 0) m; start angle: 25 deg; start x: 0.7 m; }
    body bird { mass: 0.3 kg; inertia: 0.01 kg*m^2; port hook: (0.05, 0.02) m; start x: 1.5 m, locked; start y: 0.2 m, locked; start angle: 1 rad, locked; start vy: 1 m/s, locked; start omega: -4 rad/s, locked; }
    revolute hinge(ground.o, plate.o);
    weld seam(plate.w, block.w);
    spring leash(block.hook, bird.hook) { stiffness: 50 N/m; damping: 0.4 N*s/m; free_length: 0.4 m; }
    output seam.force;
});

on_both!(on_a_moving_pivot, [rod], [pin_force], {
    gravity: 9.81 m/s^2;
    ground { port p: (0.1 m * sin(7 rad/s * t), 0.05 m * cos(11 rad/s * t)); }
    body rod { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (0, 0.4) m; start angle: 35 deg, locked; }
    revolute pin(ground.p, rod.p);
    output pin.force;
});
