//! Every scene in every formulation that holds it: the same accelerations, the same motion, the same reactions.

use plm::runtime::charts::{Charted as _, OfLoops};
use plm::runtime::{Absolute as _, Vector as _};
use plm::{BodyState, Described as _, Dop853, Mechanism as _, Moment as _, Rate};

use crate::scene::{By as _, Named as _, Scene, State, numbers};

/// A mechanism in the formulation that is taken, and in absolute coordinates. With `compiled` rustc compiles the first one too.
macro_rules! on_both {
    ($test:ident, { $($item:tt)* }) => {
        mod $test {
            pub(super) mod least {
                scene! { pub Scene { formulation: loops; $($item)* } }
            }
            pub(super) mod absolute {
                scene! { pub Scene { formulation: absolute; $($item)* } }
            }
        }

        #[test]
        fn $test() {
            crate::formulations::moves_alike_on_both(&$test::least::Scene::new(), &$test::absolute::Scene::new());
        }
    };
    ($test:ident, compiled $compiled:ident, { $($item:tt)* }) => {
        mod $compiled {
            plm::mechanism! { pub Scene { formulation: loops; $($item)* } }
        }
        on_both!($test, { $($item)* });
    };
}

pub(crate) use on_both;

/// The same motion and the same outputs, joints that are closed, and at one state the same accelerations.
pub(crate) fn moves_alike_on_both(least: &Scene, absolute: &Scene) {
    let mut one = least.by(Dop853::new(1e-12)).unwrap();
    let mut other = absolute.by(Dop853::new(1e-12)).unwrap();
    for step in 0..=5 {
        let (state, reference) = (*one.state(), *other.state());
        all_move_alike(&state, &reference, 1e-9);
        let (outputs, wanted) = (state.outputs(), reference.outputs());
        assert_eq!(outputs.len(), wanted.len());
        for (output, wanted) in outputs.into_iter().zip(wanted) {
            close("outputs", [output], [wanted], 1e-7);
        }
        // The pose closes the joints to rounding.
        let at = absolute_state(&state.bodies());
        let phi = absolute.phi(state.time(), at.first_chunk().unwrap());
        assert!(phi.iter().all(|gap| gap.abs() < 64.0 * f64::EPSILON * 4.0), "{step}: {phi:?}");
        // At one state, accelerations by a difference quotient against those in absolute coordinates.
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
            moved.bodies()
        };
        let (after, before) = (beside(h), beside(-h));
        for (k, (after, before)) in after.iter().zip(&before).enumerate() {
            let [.., vx, vy, omega] = values(*after);
            let [.., ux, uy, nu] = values(*before);
            let offset = Scene::NQ + 3 * k;
            for (i, change) in [vx - ux, vy - uy, omega - nu].into_iter().enumerate() {
                let (found, wanted) = (change / (2.0 * h), expected[offset + i]);
                assert!(
                    (found - wanted).abs() < 1e-7 * (1.0 + wanted.abs()),
                    "body {k}, {i}: {found} {wanted}"
                );
            }
        }
        one.step(0.1).unwrap();
        other.step(0.1).unwrap();
    }
}

/// `[q, v]` of the bodies: the state in absolute coordinates of a scene without first-order states.
pub(crate) fn absolute_state(bodies: &[BodyState<f64>]) -> <Scene as Rate>::X {
    let poses: Vec<f64> = bodies.iter().flat_map(|body| [body.x, body.y, body.angle]).collect();
    let speeds: Vec<f64> = bodies.iter().flat_map(|body| [body.vx, body.vy, body.omega]).collect();
    numbers(&poses, &speeds)
}

pub(crate) fn values(body: BodyState<f64>) -> [f64; 6] {
    [body.x, body.y, body.angle, body.vx, body.vy, body.omega]
}

pub(crate) fn close<const N: usize>(what: &str, found: [f64; N], wanted: [f64; N], tolerance: f64) {
    for (found, wanted) in found.iter().zip(&wanted) {
        assert!((found - wanted).abs() < tolerance * (1.0 + wanted.abs()), "{what}: {found} and {wanted}");
    }
}

/// Every body, at two moments.
pub(crate) fn all_move_alike(found: &State, wanted: &State, tolerance: f64) {
    let (bodies, found, wanted) = (found.mechanism().tables().bodies, found.bodies(), wanted.bodies());
    assert!(bodies.len() == found.len() && bodies.len() == wanted.len());
    for (body, (found, wanted)) in bodies.iter().zip(found.into_iter().zip(wanted)) {
        close(body.name, values(found), values(wanted), tolerance);
    }
}

on_both!(two_revolutes_off_the_axis, {
    gravity: 9.81 m/s^2;
    ground { port o: (0.1, -0.2) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0.1) m; port p: (0.4, -0.2) m; start angle: 20 deg, locked; start omega: 2 rad/s, locked; }
    body forearm { mass: 1 kg; inertia: 0.05 kg*m^2; port p: (-0.3, 0.05) m; start angle: -50 deg, locked; start omega: -1 rad/s, locked; }
    revolute shoulder(ground.o, arm.o) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
    revolute elbow(arm.p, forearm.p) { stiffness: 2 N*m/rad; rest: 30 deg; }
    output elbow.force;
});

on_both!(slides_on_turning_axes, {
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

on_both!(from_the_child_to_the_ground, {
    gravity: 9.81 m/s^2;
    ground { port a: (0.2, 0.1) m; }
    body shoe { mass: 1 kg; inertia: 0.02 kg*m^2; port rail: (0.05, 0.02) m, angle: 30 deg; port p: (0.2, 0) m; start angle: -30 deg; start x: 0.5 m; }
    body arm { mass: 0.5 kg; inertia: 0.02 kg*m^2; port p: (-0.3, 0) m; start angle: 10 deg, locked; }
    prismatic rail(shoe.rail, ground.a) { stiffness: 100 N/m; }
    pin_slot slot(arm.p, shoe.p) { stiffness: 80 N/m; }
});

on_both!(welded_and_free_bodies, {
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

on_both!(on_a_moving_pivot, {
    gravity: 9.81 m/s^2;
    ground { port p: (0.1 m * sin(7 rad/s * t), 0.05 m * cos(11 rad/s * t)); }
    body rod { mass: 1 kg; inertia: 0.02 kg*m^2; port p: (0, 0.4) m; start angle: 35 deg, locked; }
    revolute pin(ground.p, rod.p);
    output pin.force;
});

on_both!(four_bar, {
    gravity: 9.81 m/s^2;
    ground { port a: (0.1, -0.1) m; port d: (1.1, 0) m; }
    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0.02) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 3 rad/s, locked; }
    body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0.1) m; port c: (0.45, 0) m; start angle: 30 deg; }
    body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0.1) m; start x: 1 m; start angle: 95 deg; }
    revolute drive(ground.a, crank.a);
    revolute elbow(crank.b, coupler.b) { stiffness: 2 N*m/rad; damping: 0.1 N*m*s/rad; }
    revolute knee(coupler.c, rocker.c);
    revolute pivot(ground.d, rocker.d) { stiffness: 1 N*m/rad; rest: 90 deg; }
    output drive.force, elbow.force;
});

// RRP: a slider in a guide that is off the axis and tilted.
on_both!(slider_crank, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; port guide: (0.1, 0.05) m, axis: 10 deg; }
    body crank { mass: 0.5 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port a: (0.1, 0) m; start angle: 40 deg, locked; start omega: 8 rad/s, locked; }
    body rod { mass: 0.8 kg; inertia: 0.03 kg*m^2; port a: (-0.3, 0) m; port b: (0.3, 0) m; start x: 0.4 m; start angle: -12 deg; }
    body piston { mass: 1.5 kg; inertia: 0.001 kg*m^2; port b: (0, 0.01) m; port g: (0.02, 0) m; start x: 0.7 m; start angle: 10 deg; }
    revolute main(ground.o, crank.o);
    revolute big_end(crank.a, rod.a);
    revolute small_end(rod.b, piston.b);
    prismatic guide(ground.guide, piston.g) { stiffness: 50 N/m; free_length: 0.5 m; damping: 2 N*s/m; }
    output guide.force;
});

// RPR: the slot of a quick-return mechanism.
on_both!(quick_return, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; port p: (0, -0.5) m; }
    body crank { mass: 0.5 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port a: (0.1, 0) m; start angle: 20 deg, locked; start omega: 5 rad/s, locked; }
    body lever { mass: 2 kg; inertia: 0.1 kg*m^2; port p: (-0.4, 0) m; port s: (-0.4, 0.02) m; start y: 0.4 m; start angle: 75 deg; }
    revolute main(ground.o, crank.o);
    revolute foot(ground.p, lever.p) { stiffness: 5 N*m/rad; rest: 90 deg; }
    pin_slot slot(lever.s, crank.a) { damping: 1 N*s/m; }
    output slot.force;
});

// PRP: an elliptic trammel.
on_both!(trammel, {
    gravity: 9.81 m/s^2;
    ground { port g: (0, 0) m; port h: (0, 0.1) m, axis: 80 deg; }
    body bar { mass: 1 kg; inertia: 0.05 kg*m^2; port a: (-0.4, 0) m; port b: (0.4, 0) m; start angle: 120 deg, locked; start x: 0.3 m; start y: 0.4 m; start omega: 1 rad/s, locked; }
    body across { mass: 0.2 kg; inertia: 0.001 kg*m^2; port a: (0, 0) m; start x: 0.4 m; }
    body along { mass: 0.3 kg; inertia: 0.001 kg*m^2; port b: (0, 0) m; start y: 0.7 m; start angle: 80 deg; }
    prismatic left(ground.g, across.a);
    prismatic right(ground.h, along.b) { damping: 1 N*s/m; }
    revolute first(across.a, bar.a);
    revolute second(along.b, bar.b);
    output left.force;
});

// Two freedoms and two loops that share a body, on a moving pivot.
on_both!(five_bar_with_a_strut, {
    gravity: 9.81 m/s^2;
    ground { port a: (0.02 m * sin(3 rad/s * t), 0 m); port b: (0.6, 0) m; port c: (-0.3, 0.1) m; }
    body left { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (-0.2, 0) m; port t: (0.2, 0) m; start angle: 100 deg, locked; start omega: 1 rad/s, locked; }
    body right { mass: 0.5 kg; inertia: 0.01 kg*m^2; port b: (-0.2, 0) m; port t: (0.2, 0) m; start x: 0.6 m; start angle: 60 deg, locked; start omega: -2 rad/s, locked; }
    body up { mass: 0.4 kg; inertia: 0.02 kg*m^2; port l: (-0.35, 0) m; port r: (0.35, 0) m; start x: 0.2 m; start y: 0.5 m; start angle: 30 deg; }
    body down { mass: 0.4 kg; inertia: 0.02 kg*m^2; port l: (-0.35, 0) m; port r: (0.35, 0) m; start x: 0.7 m; start y: 0.6 m; start angle: -40 deg; }
    body strut { mass: 0.3 kg; inertia: 0.01 kg*m^2; port c: (-0.25, 0) m; start x: -0.1 m; start y: 0.2 m; start angle: 60 deg; }
    revolute p1(ground.a, left.a);
    revolute p2(ground.b, right.b);
    revolute p3(left.t, up.l);
    revolute p4(right.t, down.r);
    revolute top(up.r, down.l) { damping: 0.05 N*m*s/rad; }
    revolute foot(ground.c, strut.c);
    pin_slot guide(strut.c, up.l);
    output top.force;
});

on_both!(a_geared_pair_of_arms, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port b: (0.6, 0) m; }
    body sun { mass: 0.5 kg; inertia: 0.01 kg*m^2; port a: (-0.2, 0) m; start angle: 30 deg, locked; start omega: 1 rad/s, locked; }
    body planet { mass: 0.7 kg; inertia: 0.02 kg*m^2; port b: (-0.1, 0.1) m; start x: 0.6 m; start angle: -60 deg; }
    revolute p1(ground.a, sun.a);
    revolute p2(ground.b, planet.b) { stiffness: 2 N*m/rad; }
    constraint gear: planet.angle + 2*sun.angle = 0;
});

on_both!(a_mass_on_the_rod_of_a_jack, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; port p: (0.3, -0.4) m; }
    body arm { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; port p: (0.1, 0.05) m; start angle: 20 deg, locked; start omega: 2 rad/s, locked; }
    revolute hinge(ground.o, arm.o);
    jack ram(ground.p, arm.p) { free_length: 0.2 m; drive: 30 N; }
    attached_mass piston(ram.slider) { mass: 7 kg; }
    output both = (piston.force, 0);
});

on_both!(a_mass_and_a_rotor_on_a_four_bar, {
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; port p: (0.3, -0.4) m; port d: (1, 0) m; }
    body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
    body coupler { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0.1) m; start angle: 20 deg; }
    body follower { mass: 1.5 kg; inertia: 0.05 kg*m^2; port d: (-0.3, 0) m; port c: (0.3, 0) m; start angle: 80 deg; start x: 1 m; }
    revolute oa(ground.o, crank.a) { drive: 2 N*m; }
    revolute ab(crank.b, coupler.b);
    revolute bc(coupler.c, follower.c);
    revolute od(ground.d, follower.d);
    jack ram(ground.p, coupler.c) { free_length: 0.2 m; }
    attached_mass piston(ram.slider) { mass: 30 kg; }
    attached_rotor motor(bc.shaft) { inertia: 0.001 kg*m^2; ratio: -5; }
    output both = (piston.force, motor.torque/1 m);
});

on_both!(a_driven_trolley, {
    gravity: 9.81 m/s^2;
    ground { port rail: (0, 0) m, axis: 15 deg; }
    body trolley { mass: 2 kg; inertia: 0.1 kg*m^2; port s: (0, 0) m; port p: (0.1, 0) m; start angle: 15 deg; }
    body bob { mass: 0.7 kg; inertia: 0.02 kg*m^2; port p: (0, 0.4) m; start angle: 20 deg, locked; }
    prismatic slide(ground.rail, trolley.s);
    revolute hook(trolley.p, bob.p) { damping: 0.1 N*m*s/rad; }
    constraint pull: trolley.x = 0.1 m*sin(3 rad/s*t);
});

on_both!(a_driven_four_bar_with_a_flail, {
    gravity: 9.81 m/s^2;
    ground { port a: (0.1, -0.1) m; port d: (1.1, 0) m; }
    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.15, 0.02) m; port b: (0.15, 0) m; start angle: 60 deg; }
    body coupler { mass: 0.9 kg; inertia: 0.06075 kg*m^2; port b: (-0.45, 0.1) m; port c: (0.45, 0) m; start angle: 30 deg; }
    body rocker { mass: 0.7 kg; inertia: 0.02858 kg*m^2; port d: (-0.35, 0) m; port c: (0.35, 0.1) m; start x: 1 m; start angle: 95 deg; }
    body flail { mass: 0.2 kg; inertia: 0.001 kg*m^2; port c: (-0.1, 0) m; start x: 1 m; start y: 0.6 m; start angle: 20 deg, locked; }
    revolute drive(ground.a, crank.a);
    revolute elbow(crank.b, coupler.b) { stiffness: 2 N*m/rad; damping: 0.1 N*m*s/rad; }
    revolute knee(coupler.c, rocker.c);
    revolute pivot(ground.d, rocker.d);
    revolute hook(coupler.c, flail.c);
    constraint motor: crank.angle = 60 deg + 2 rad/s*t + 0.1 rad*sin(5 rad/s*t);
    output drive.force;
});

/// Kinematics: nothing is left to integrate, and loops are followed through the time alone.
mod driven {
    scene! {
        pub CrankRocker {
            gravity: 9.81 m/s^2;
            ground { port a: (0, 0) m; port d: (1, 0) m; }
            body crank { mass: 0.5 kg; inertia: 0.0104 kg*m^2; port a: (-0.25, 0) m; port b: (0.25, 0) m; start omega: 1 rad/s; }
            body coupler { mass: 1.2 kg; inertia: 0.144 kg*m^2; port b: (-0.6, 0) m; port c: (0.6, 0) m; start x: 1 m; start y: 0.4 m; start angle: 40 deg; }
            body rocker { mass: 0.8 kg; inertia: 0.0427 kg*m^2; port d: (-0.4, 0) m; port c: (0.4, 0) m; start x: 1.2 m; start y: 0.4 m; start angle: 60 deg; }
            revolute a(ground.a, crank.a);
            revolute b(crank.b, coupler.b);
            revolute c(coupler.c, rocker.c);
            revolute d(ground.d, rocker.d);
            constraint drive: crank.angle = 1 rad/s*t;
            output d.force;
        }
    }
}

#[test]
fn what_is_driven_altogether_has_no_state() {
    let mut sim = driven::CrankRocker::new().begin().unwrap();
    let mut samples = Vec::new();
    sim.run(20.0, 0.1, |state| {
        // The room of a state is all unused.
        assert!(state.x().iter().all(|number| number.to_bits() == 0), "{:?}", state.x());
        samples.push((state.time(), state.state_of("coupler").angle, state.state_of("rocker").angle));
    })
    .unwrap();
    assert_eq!(samples.len(), 201);
    for (time, coupler, rocker) in samples {
        let gap = [
            0.5 * time.cos() + 1.2 * coupler.cos() - 0.8 * rocker.cos() - 1.0,
            0.5 * time.sin() + 1.2 * coupler.sin() - 0.8 * rocker.sin(),
        ];
        assert!(gap.iter().all(|gap| gap.abs() < 1e-14), "{time}: {gap:?}");
        // The knee stays above the line from the crank's pin to the pivot.
        assert!((rocker - coupler).sin() > 0.1, "{time}");
    }
    let mut fixed = driven::CrankRocker::new().by(plm::Rk4::new(0.01)).unwrap();
    fixed.step(20.0).unwrap();
    close("rocker", values(fixed.state_of("rocker")), values(sim.state_of("rocker")), 1e-14);
}

/// Largest difference of the second derivatives of a chart's coordinates from those by absolute coordinates at the same pose,
/// over the largest of them; along a run.
///
/// With `y' = P(q) v` of the chart, `y'' = P a + P' v`; the second term, which angles do not have, by a difference quotient.
fn accelerations_apart(least: &Scene, absolute: &Scene) -> f64 {
    let mut sim = least.begin().unwrap();
    let (held_5, _) = absolute.start_state(0.0).unwrap();
    let mut worst = 0.0_f64;
    for _ in 0..20 {
        sim.step(0.05).unwrap();
        let (state, n) = (*sim.state(), Scene::NQ);
        let (t, held) = (state.time(), state.held());
        let (q, v, _) = least.pose(t, &held, state.x());
        let OfLoops::InChart { chart, .. } = held.of_loops else { panic!("no chart") };
        let x = numbers(&q, &v);
        let (mut of_5, mut own) = (x, *state.x());
        assert!(absolute.rate(t, &held_5, &x, &mut of_5).is_good());
        assert!(least.rate(t, &held, state.x(), &mut own).is_good());
        let rates = |t: f64, q: &[f64; Scene::NQ], v: &[f64; Scene::NQ]| {
            let mut y = *state.x();
            least.to_chart(chart, t, q, v, &mut y);
            y
        };
        let a = std::array::from_fn(|k| of_5[n + k]);
        let h = 1e-4;
        let beside = |h: f64| rates(t + h, &q.map2(&v, |q, v| q + h * v), &v);
        let (straight, after, before) = (rates(t, &q, &a), beside(h), beside(-h));
        let size = (0..n).fold(1.0_f64, |size, k| size.max(own[n + k].abs()));
        for k in n..2 * n {
            let bent = (after[k] - before[k]) / (2.0 * h);
            let apart = (own[k] - straight[k] - bent).abs() / size;
            // The quotient is worth so much.
            worst = worst.max(if bent == 0.0 { apart } else { apart - 1e-6 });
        }
    }
    worst
}

#[test]
fn accelerations_at_one_state_are_the_same_to_rounding() {
    let scenes = [
        accelerations_apart(&four_bar::least::Scene::new(), &four_bar::absolute::Scene::new()),
        accelerations_apart(&slider_crank::least::Scene::new(), &slider_crank::absolute::Scene::new()),
        accelerations_apart(&quick_return::least::Scene::new(), &quick_return::absolute::Scene::new()),
        accelerations_apart(&trammel::least::Scene::new(), &trammel::absolute::Scene::new()),
    ];
    println!("{scenes:?}");
    // Some hundred operations, and pivots down to some hundredths.
    assert!(scenes.iter().all(|apart| *apart < 1e-12), "{scenes:?}");
}
