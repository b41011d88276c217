//! Loops that a step would tear open.

use plm::runtime::absolute::Absolute as _;
use plm::{Cause, Dop853, Fault, Mechanism as _, Moment as _, Notice, Rk4, Sim};

use crate::near_singular_scenes::TripleRocker;
use crate::scene::{Named as _, numbers};
use crate::scenes::{s1, s1_baumgarte, s2};

/// Steps of RK4 over 4 s: the largest gap in a joint of the states that were given, the relative error of the energy at the
/// end, what ended the run early, and whether it is told that steps are too long, and that they were divided.
fn rocks(h: f64) -> (f64, f64, Option<Fault>, [bool; 2]) {
    let mechanism = TripleRocker::new();
    let mut sim = mechanism.start_with(Rk4::new(h)).unwrap();
    let (start, mut gap) = (sim.kinetic_energy(), 0.0);
    for _ in 0..(4.0 / h).round() as u32 {
        if let Err(fault) = sim.step(h) {
            return (gap, f64::NAN, Some(fault), [true; 2]);
        }
        let bodies = ["crank", "coupler", "rocker"].map(|name| sim.state_of(name));
        let q: Vec<f64> = bodies.iter().flat_map(|body| [body.x, body.y, body.angle]).collect();
        let phi = mechanism.phi(sim.time(), numbers(&q, &[]).first_chunk().unwrap());
        gap = phi.iter().fold(gap, |gap, phi| f64::max(gap, phi.abs()));
    }
    // Every link comes to a dead point again and again: none could drive alone.
    assert!(sim.stats().charts >= 4, "{:?}", sim.stats());
    let told = |is: fn(&Notice) -> bool| Sim::notices(&sim).any(|notice| is(&notice));
    let told = [
        told(|notice| matches!(notice, Notice::LongSteps { .. })),
        told(|notice| matches!(notice, Notice::DividedSteps { .. })),
    ];
    (gap, (sim.kinetic_energy() / start - 1.0).abs(), None, told)
}

#[test]
fn dead_points_are_passed_in_other_charts() {
    let (gap, coarse, fault, _) = rocks(2e-3);
    assert!(gap < 64.0 * f64::EPSILON && fault.is_none(), "{gap:e} {fault:?}");
    let (_, fine, ..) = rocks(5e-4);
    assert!(fine < 2e-7 && coarse < 1e-5, "{coarse:e} {fine:e}");
    let mut sim = TripleRocker::new().start_with(Dop853::new(1e-10)).unwrap();
    let start = sim.kinetic_energy();
    sim.step(4.0).unwrap();
    assert!((sim.kinetic_energy() / start - 1.0).abs() < 1e-8, "{:e}", sim.kinetic_energy() / start - 1.0);
}

/// Steps that would tear a loop open, or in which it could go through a flat pose unseen, are divided. Loops stay closed, and a run whose
/// motion makes no sense tells it, or ends.
#[test]
fn steps_that_are_too_long_for_a_loop_are_divided() {
    for h in [0.1, 0.05, 0.03, 0.02] {
        let (gap, energy, fault, [is_long, is_divided]) = rocks(h);
        assert!(gap < 64.0 * f64::EPSILON && is_divided, "{h}: {gap:e}");
        assert!(fault.is_none_or(|fault| matches!(fault.cause, Cause::StepTooLong { .. })), "{h}: {fault:?}");
        assert!(energy < 0.03 || is_long, "{h}: {energy:e}");
    }
}

#[test]
fn a_run_stops_at_a_change_point_if_it_is_told_to() {
    let mut sim = Rhomb::new().start().unwrap();
    sim.step(2.5).unwrap();
    assert_eq!(sim.stats().change_points, 1);
    // The turn through the flat pose at constant speed goes on as a parallelogram.
    assert!(
        (sim.state_of("left").angle - 3.5).abs() < 1e-7 && (sim.state_of("right").angle - 3.5).abs() < 1e-7
    );
    let mut sim = Rhomb::new().start().unwrap();
    sim.stop_at_change_points(true);
    let fault = sim.step(3.0).unwrap_err();
    assert_eq!((fault.cause, fault.part), (Cause::ChangePoint, "c"));
    assert!(
        fault.time > std::f64::consts::PI - 1.0 && sim.state_of("left").angle < std::f64::consts::PI,
        "{fault}"
    );
}

scene! {
    /// A parallelogram without gravity that turns at 1 rad/s from 1 rad.
    pub Rhomb {
        ground { port a: (0, 0) m; port d: (2, 0) m; }
        body left { mass: 1 kg; inertia: 1 kg*m^2/48; port a: (-0.25, 0) m; port b: (0.25, 0) m; start angle: 1 rad, locked; start omega: 1 rad/s, locked; }
        body top { mass: 2 kg; inertia: 2 kg*m^2/3; port b: (-1, 0) m; port c: (1, 0) m; start x: 1 m; start y: 0.4 m; }
        body right { mass: 1 kg; inertia: 1 kg*m^2/48; port d: (-0.25, 0) m; port c: (0.25, 0) m; start x: 2 m; start angle: 1 rad; }
        revolute a(ground.a, left.a);
        revolute b(left.b, top.b);
        revolute c(top.c, right.c);
        revolute d(ground.d, right.d);
    }
}

#[test]
fn energy_out_of_nowhere_ends_the_run_if_it_is_watched() {
    // Steps of 2/w, w = sqrt(500/0.35) 1/s: Runge-Kutta's formula is stable there and takes most of the energy away.
    let mut sim = Shaken::new().start_with(Rk4::new(0.05)).unwrap();
    sim.watch_energy(Some(0.1));
    let fault = sim.step(1.0).unwrap_err();
    assert!(matches!(fault.cause, Cause::EnergyJump { by, .. } if by.abs() > 0.0), "{fault}");
    // Springs, dampers and torques do work; with steps that are short enough nothing is out of order.
    let mut sim = Shaken::new().start_with(Rk4::new(1e-4)).unwrap();
    sim.watch_energy(Some(0.1));
    sim.step(1.0).unwrap();
    let mut sim = TripleRocker::new().start().unwrap();
    sim.watch_energy(Some(0.01));
    sim.step(4.0).unwrap();
}

/// What gravity takes from the motion it stores.
#[test]
fn gravity_is_part_of_the_energy_that_is_watched() {
    // Both swing through poses at rest and back, by the default method; its errors are below 1e-6 of the energy.
    let mut tree = s1::DoublePendulum::new().start().unwrap();
    tree.watch_energy(Some(1e-4));
    tree.step(5.0).unwrap();
    let mut rows = s1_baumgarte::DoublePendulum::new().start().unwrap();
    rows.watch_energy(Some(1e-4));
    rows.step(5.0).unwrap();
    let mut linkage = s2::FourBar::new().start().unwrap();
    linkage.watch_energy(Some(1e-4));
    linkage.step(5.0).unwrap();
}

scene! {
    /// A damped bar on a spring that is too stiff for long steps.
    pub Shaken {
        ground { port o: (0, 0) m; }
        body bar { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (-0.5, 0) m; start angle: 5 deg, locked; start omega: 1 rad/s, locked; }
        revolute hinge(ground.o, bar.o) { stiffness: 500 N*m/rad; damping: 0.5 N*m*s/rad; drive: 1 N*m*cos(20 rad/s*t); }
    }
}
