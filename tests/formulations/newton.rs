//! Loops that do not split, by Newton's iteration: against absolute coordinates, and where the iteration could fail.

use plm::{Dop853, Moment as _, Rk4};

use super::formulations::{close, on_both, values};
use crate::scene::{By as _, Given as _, Named as _};

// 8 bars and three loops (K. J. Waldron, S. V. Sreenivasan, J. Mech. Design 118, 1996): 6 angles at once.
on_both!(double_butterfly, compiled butterfly, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port c: (-1.2, 0.1) m; port e: (1.2, 0) m; }
    body base { mass: 1.1 kg; inertia: 0.2 kg*m^2; port a: (0, -0.5) m; port h: (-0.4, 0.3) m; port j: (0.5, 0.2) m; start y: 0.5 m; start omega: 1 rad/s, locked; }
    body left { mass: 0.8 kg; inertia: 0.1 kg*m^2; port b: (0.55, 0) m; port d: (-0.5, -0.4) m; port i: (0, 0.3) m; start x: -0.5 m; start y: 1.6 m; }
    body right { mass: 0.9 kg; inertia: 0.12 kg*m^2; port b: (-0.55, 0) m; port f: (0.5, -0.5) m; port k: (0, 0.4) m; start x: 0.6 m; start y: 1.6 m; }
    body strut[0] { mass: 0.3 kg; inertia: 0.02 kg*m^2; port p: (-0.1, -0.6) m; port q: (0.1, 0.5) m; start x: -1.1 m; start y: 0.7 m; }
    body strut[1] { mass: 0.3 kg; inertia: 0.02 kg*m^2; port p: (0.05, -0.6) m; port q: (-0.05, 0.5) m; start x: 1.15 m; start y: 0.6 m; }
    body strut[2] { mass: 0.3 kg; inertia: 0.02 kg*m^2; port p: (0.05, -0.5) m; port q: (-0.05, 0.6) m; start x: -0.45 m; start y: 1.3 m; }
    body strut[3] { mass: 0.3 kg; inertia: 0.02 kg*m^2; port p: (-0.05, -0.6) m; port q: (0.05, 0.7) m; start x: 0.55 m; start y: 1.3 m; }
    revolute p0(ground.a, base.a);
    revolute p1(left.b, right.b);
    revolute p2(ground.c, strut[0].p);
    revolute p3(strut[0].q, left.d);
    revolute p4(ground.e, strut[1].p);
    revolute p5(strut[1].q, right.f);
    revolute p6(base.h, strut[2].p);
    revolute p7(strut[2].q, left.i);
    revolute p8(base.j, strut[3].p);
    revolute p9(strut[3].q, right.k);
    output p1.force, p9.force;
});

// A plate on the pins of three cranks: an angle and three slides at once.
on_both!(plate_on_three_pins, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
    body crank[0] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.1 m; start angle: 20 deg, locked; start omega: 2 rad/s, locked; }
    body crank[1] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 1.1 m; start angle: 20 deg; }
    body crank[2] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.6 m; start y: 0.9 m; start angle: -20 deg; }
    body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port a: (-0.4, -0.3) m, angle: 35 deg; port b: (0.4, -0.3) m, angle: 140 deg; port c: (0, 0.4) m, angle: 100 deg; start x: 0.5 m; start y: 0.3 m; }
    revolute o0(ground.a, crank[0].o);
    revolute o1(ground.b, crank[1].o);
    revolute o2(ground.c, crank[2].o);
    pin_slot slot[0](plate.a, crank[0].p) { stiffness: 100 N/m; }
    pin_slot slot[1](plate.b, crank[1].p);
    pin_slot slot[2](plate.c, crank[2].p);
    constraint gear: crank[1].angle - crank[0].angle = 0;
    constraint back: crank[2].angle + 1.5*crank[0].angle = 10 deg;
    output slot[2].force;
});

// Without freedom: nothing is left to integrate.
on_both!(plate_on_driven_pins, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (0.5, 0.9) m; }
    body crank[0] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.1 m; start angle: 20 deg; }
    body crank[1] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 1.1 m; start angle: 20 deg; }
    body crank[2] { mass: 0.3 kg; inertia: 0.01 kg*m^2; port o: (-0.1, 0) m; port p: (0.1, 0) m; start x: 0.6 m; start y: 0.9 m; start angle: -20 deg; }
    body plate { mass: 2 kg; inertia: 0.3 kg*m^2; port a: (-0.4, -0.3) m, angle: 35 deg; port b: (0.4, -0.3) m, angle: 140 deg; port c: (0, 0.4) m, angle: 100 deg; start x: 0.5 m; start y: 0.3 m; }
    revolute o0(ground.a, crank[0].o);
    revolute o1(ground.b, crank[1].o);
    revolute o2(ground.c, crank[2].o);
    pin_slot slot[0](plate.a, crank[0].p) { stiffness: 100 N/m; }
    pin_slot slot[1](plate.b, crank[1].p);
    pin_slot slot[2](plate.c, crank[2].p);
    constraint first: crank[0].angle = 0.4 rad*sin(3 rad/s*t);
    constraint second: crank[1].angle = 0.3 rad*cos(2 rad/s*t);
    constraint third: crank[2].angle = 0.2 rad*sin(4 rad/s*t) - 0.1 rad;
    output slot[1].force;
});

// A six-bar that is driven from the side from which it does not split into dyads.
on_both!(stephenson_from_its_dyad, {
    gravity: 9.81 m/s^2;
    ground { port a: (0, 0) m; port d: (1, 0) m; port g: (1.5, 0.3) m; }
    body crank { mass: 0.3 kg; inertia: 0.00225 kg*m^2; port a: (-0.05, -0.175) m; port b: (0.05, 0.175) m; start x: 0.05 m; start y: 0.175 m; }
    body coupler { mass: 0.9 kg; inertia: 0.06 kg*m^2; port b: (-0.433, -0.317) m; port c: (0.417, 0.033) m; port e: (0.017, 0.283) m; start x: 0.533 m; start y: 0.667 m; }
    body rocker { mass: 0.7 kg; inertia: 0.03 kg*m^2; port d: (0.025, -0.35) m; port c: (-0.025, 0.35) m; start x: 0.975 m; start y: 0.35 m; }
    body link { mass: 0.4 kg; inertia: 0.01 kg*m^2; port e: (-0.4, 0.05) m; port f: (0.4, -0.05) m; start x: 0.95 m; start y: 0.9 m; }
    body lever { mass: 0.5 kg; inertia: 0.02 kg*m^2; port g: (0.075, -0.275) m; port f: (-0.075, 0.275) m; start x: 1.425 m; start y: 0.575 m; }
    body flail { mass: 0.2 kg; inertia: 0.001 kg*m^2; port c: (-0.1, -0.02) m; start x: 1.05 m; start y: 0.72 m; start angle: 0 deg, locked; }
    revolute p0(ground.a, crank.a);
    revolute p1(crank.b, coupler.b);
    revolute p2(coupler.c, rocker.c);
    revolute p3(ground.d, rocker.d);
    revolute p4(coupler.e, link.e);
    revolute p5(link.f, lever.f);
    revolute p6(ground.g, lever.g);
    revolute hook(coupler.c, flail.c);
    constraint motor: lever.angle = 0.15 rad*sin(3 rad/s*t);
    output p1.force;
});

/// Full turns, in which each coordinate that is tried has dead points: charts are switched, nothing is lost.
#[test]
fn a_double_butterfly_turns_over() {
    for omega in [1.0, 3.0] {
        let least = double_butterfly::least::Scene::new().with_start("base.omega", omega);
        let absolute = double_butterfly::absolute::Scene::new().with_start("base.omega", omega);
        let mut one = least.by(Dop853::new(1e-13)).unwrap();
        let mut other = absolute.by(Dop853::new(1e-13)).unwrap();
        let start = one.kinetic_energy() + one.gravity_energy();
        for _ in 0..100 {
            one.step(0.1).unwrap();
            other.step(0.1).unwrap();
            // Errors of the start grow along the way: by 1e4 in 10 s.
            close("base", values(one.state_of("base")), values(other.state_of("base")), 1e-7);
            let gained = one.kinetic_energy() + one.gravity_energy() - start;
            assert!(gained.abs() < 1e-9 * start, "{gained} J of {start} J at {} s", one.time());
        }
        assert!(one.state_of("base").angle > 6.0 && one.stats().charts > 10, "{:?}", one.stats());
    }
}

/// Tolerances so loose that steps reach beyond what the iteration can follow: shorter ones are made.
#[test]
fn steps_are_no_longer_than_the_iteration_can_follow() {
    let mut loose = double_butterfly::least::Scene::new().by(Dop853::new(5e-6)).unwrap();
    let mut exact = double_butterfly::absolute::Scene::new().by(Dop853::new(1e-10)).unwrap();
    loose.step(3.0).unwrap();
    exact.step(3.0).unwrap();
    close("base", values(loose.state_of("base")), values(exact.state_of("base")), 1e-3);
}

/// The first step of half a second would end at another solution of the iteration: it is divided.
#[test]
fn a_fixed_step_that_is_too_long_is_divided() {
    let scene = double_butterfly::least::Scene::new();
    let mut coarse = scene.by(Rk4::new(0.5)).unwrap();
    let mut exact = double_butterfly::absolute::Scene::new().by(Dop853::new(1e-10)).unwrap();
    coarse.step(0.5).unwrap();
    exact.step(0.5).unwrap();
    assert!(coarse.stats().divided == 1, "{:?}", coarse.stats());
    close("base", values(coarse.state_of("base")), values(exact.state_of("base")), 1e-3);
}

/// Runge-Kutta 4 keeps its order: what the iteration leaves is below it. Later in this motion steps are divided.
#[test]
fn fixed_steps_converge() {
    let scene = double_butterfly::least::Scene::new();
    let mut exact = scene.by(Dop853::new(1e-12)).unwrap();
    exact.step(0.5).unwrap();
    let error = |h: f64| {
        let mut fixed = scene.by(Rk4::new(h)).unwrap();
        fixed.step(0.5).unwrap();
        assert_eq!(fixed.stats().rejected, 0, "{h}");
        (fixed.state_of("base").angle - exact.state_of("base").angle).abs()
    };
    let errors = [5e-4, 2.5e-4].map(error);
    assert!(errors.windows(2).all(|pair| (14.0..20.0).contains(&(pair[0] / pair[1]))), "{errors:?}");
}

/// Next to its flat poses the measure of a group changes faster than its unknowns turn. Steps that do not know their error are
/// divided for it, also the first one in a new chart.
#[test]
fn fixed_steps_are_divided_where_a_group_turns_sharply() {
    let scene = double_butterfly::least::Scene::new().with_start("base.omega", 3.0);
    // The most energy that is lost or won in a millisecond.
    let lost = |h: f64| {
        let mut fixed = scene.by(Rk4::new(h)).unwrap();
        let energies = (0..=10_000).map(|_| {
            let energy = fixed.kinetic_energy() + fixed.gravity_energy();
            fixed.step(1e-3).unwrap();
            energy
        });
        let energies: Vec<f64> = energies.collect();
        energies.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max) / energies[0]
    };
    let [coarse, fine] = [1e-3, 2.5e-4].map(lost);
    // Shorter steps lose less, down to what the steps over the poses themselves leave.
    assert!(coarse < 1e-6 && fine < coarse && fine < 3e-8, "{coarse:e} {fine:e}");
}

/// What counts as closed depends on the arithmetic.
#[test]
fn single_precision_iterates_as_well() {
    let mut single = butterfly::Scene::<f32>::of().by(Rk4::new(1e-3)).unwrap();
    let mut double = double_butterfly::least::Scene::new().by(Rk4::new(1e-3)).unwrap();
    single.step(1.0).unwrap();
    double.step(1.0).unwrap();
    let (found, wanted) = (f64::from(single.base().angle), double.state_of("base").angle);
    assert!((found - wanted).abs() < 1e-4, "{found} {wanted}");
}
