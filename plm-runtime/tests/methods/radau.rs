//! Radau IIA: order, dense output, known stiff problems, what a step costs.

use plm_runtime::method::RadauIia5;
use plm_runtime::{Cause, Dopri5, Mechanism};

use crate::mechanisms::{double_pendulum, ladder, parallelogram};
use crate::oscillator::{error, oscillator};
use crate::smooth::{ProtheroRobinson, Robertson, Spring, StiffPendulum, VanDerPol, spring};

/// Error of the oscillator at t = 2 with steps of exactly `h`: the tolerance would allow longer ones.
fn error_with_steps_of(h: f64) -> f64 {
    let mut sim = oscillator().start_with(RadauIia5::new(1e-10).with_longest_step(h)).unwrap();
    sim.step(2.0).unwrap();
    assert!(sim.stats().steps as f64 <= 2.0 / h + 8.0, "{:?}", sim.stats());
    error(2.0, &sim.x)
}

#[test]
fn order_is_5() {
    let order = (error_with_steps_of(0.02) / error_with_steps_of(0.01)).log2();
    println!("Radau IIA: {order:.3}");
    assert!((order - 5.0).abs() < 0.15, "{order}");
}

#[test]
fn error_follows_the_tolerance() {
    for rtol in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let mut sim = oscillator().start_with(RadauIia5::new(rtol)).unwrap();
        sim.step(2.0).unwrap();
        let (error, stats) = (error(2.0, &sim.x), sim.stats());
        println!("{rtol:e}: {error:e} {stats:?}");
        assert!(error < 3.0 * rtol, "{rtol:e}: {error:e}");
        assert!(stats.factorisations <= stats.steps && stats.jacobians < stats.steps, "{stats:?}");
    }
}

#[test]
fn dense_output_has_order_3_or_more() {
    let worst = |h: f64| {
        let mut sim = oscillator().start_with(RadauIia5::new(1e-6).with_longest_step(h)).unwrap();
        let mut worst = 0.0;
        sim.run(2.0, 0.0013, |moment| worst = f64::max(worst, error(moment.time, &moment.x))).unwrap();
        worst
    };
    let order = (worst(0.04) / worst(0.02)).log2();
    println!("dense output: {order:.3}");
    assert!((3.5..5.0).contains(&order), "{order}");
}

/// Robertson's reaction: solution at t = 40 (Hairer and Wanner II, IV.10) and at 1e11 (F. Mazzia, C. Magherini, Test Set
/// for Initial Value Problem Solvers, problem ROBER).
#[test]
fn robertson() {
    let mut sim = Robertson { fast: 3e7_f64 }.start_with(RadauIia5::new(1e-8)).unwrap();
    for (t, expected) in [
        (40.0, [0.715_827_068_7, 9.185_534_764e-6, 0.284_163_745_7]),
        (1e11, [0.208_334_014_970_125_5e-7, 0.833_336_077_033_471_3e-13, 0.999_999_979_166_505]),
    ] {
        let elapsed = t - sim.time;
        sim.step(elapsed).unwrap();
        println!("{:?} {:?}", sim.x, sim.stats());
        for i in 0..3 {
            assert!((sim.x[i] - expected[i]).abs() < 1e-6 * expected[i], "{t}: {:?}", sim.x);
        }
    }
    // Explicit methods would need some 1e15 steps.
    assert!(sim.stats().steps < 700, "{:?}", sim.stats());
}

/// Solution at t = 2 with epsilon = 1e-6 (the same collection, problem VDPOL).
#[test]
fn van_der_pol() {
    let mut sim = VanDerPol { epsilon: 1e-6_f64 }.start_with(RadauIia5::new(1e-8)).unwrap();
    sim.step(2.0).unwrap();
    let expected = [1.706_167_732_170_483, -0.892_809_701_024_797_5];
    println!("{:?} {:?}", sim.x, sim.stats());
    for i in 0..2 {
        assert!((sim.x[i] - expected[i]).abs() < 1e-7 * expected[i].abs(), "{:?}", sim.x);
    }
}

#[test]
fn a_stable() {
    // Without damping: no step of any length makes an oscillation grow. The tolerance lets every step pass.
    for wh in [0.01_f64, 0.3, 1.0, 3.0, 30.0, 1e4, 1e8] {
        let wild = RadauIia5::new(1e12).with_longest_step(1.0);
        let mut sim = Spring { w: wh, z: 0.0 }.start_with(wild).unwrap();
        let mut energy = 1.0_f64;
        for _ in 0..20 {
            sim.step(1.0).unwrap();
            let next = sim.x[0].powi(2) + (sim.x[1] / wh).powi(2);
            assert!(next <= energy * (1.0 + 1e-12), "{wh}: {next} {energy}");
            energy = next;
        }
    }
}

#[test]
fn l_stable() {
    for lambda in [-1e4_f64, -1e8, -1e12] {
        let wild = RadauIia5::new(1e12).with_longest_step(0.5);
        let mut sim = ProtheroRobinson { lambda }.start_with(wild).unwrap();
        sim.x[0] = 2.0;
        sim.step(0.5).unwrap();
        // R(z) is about 3 / z; what is left beside is the error of the slow solution, of order h^4 / lambda.
        let left = (sim.x[0] - 0.5_f64.cos()).abs();
        assert!(left < 10.0 / (0.5 * lambda).abs(), "{lambda:e}: {left:e}");
    }
}

#[test]
fn stiff_damping_costs_nothing() {
    let mut last = 0;
    for z in [1.0e2_f64, 1.0e4, 1.0e6] {
        // Overdamped: q = exp(-t w / (2 z)) to first order in 1 / z^2.
        let mut sim = Spring { w: 2.0 * z, z }.start_with(RadauIia5::new(1e-6)).unwrap();
        sim.step(2.0).unwrap();
        let slow = 2.0 / (1.0 + (1.0 - 1.0 / (z * z)).sqrt());
        let expected = (1.0 + 0.25 / (z * z)) * (-2.0 * slow).exp();
        assert!((sim.x[0] - expected).abs() < 1e-5, "{z}: {} {expected}", sim.x[0]);
        let evaluations = sim.stats().evaluations;
        println!("z = {z:e}: {:?}", sim.stats());
        assert!(last == 0 || evaluations <= 2 * last, "{evaluations} after {last}");
        last = evaluations;
    }
}

#[test]
fn a_slow_oscillation_is_that_of_the_formula() {
    let mut sim = Spring { w: 3.0, z: 0.1 }.start_with(RadauIia5::new(1e-9)).unwrap();
    sim.step(5.0).unwrap();
    let expected = spring(3.0, 0.1, 5.0);
    assert!((sim.x[0] - expected[0]).abs() < 1e-9 && (sim.x[1] - expected[1]).abs() < 1e-8);
}

/// The rigid pendulum of 1 m in a gravity of 1 m/s^2 that falls from the horizontal, at t = 1: (x, y).
fn rigid_pendulum() -> [f64; 2] {
    // The angle from the downward vertical: a'' = -sin a.
    let rigid = crate::smooth::Rod { gravity: 1.0, angle: core::f64::consts::FRAC_PI_2 };
    let mut sim = rigid.start_with(Dopri5::new(1e-13)).unwrap();
    sim.step(1.0).unwrap();
    [sim.x[0].sin(), -sim.x[0].cos()]
}

#[test]
fn the_stiff_pendulum_becomes_the_rigid_one() {
    let rigid = rigid_pendulum();
    for (stiffness, most_evaluations) in [(1e6_f64, 1000), (1e8, 4000), (1e10, 9000), (1e12, 25_000)] {
        let mut sim = StiffPendulum { stiffness }.start_with(RadauIia5::new(1e-8)).unwrap();
        sim.step(1.0).unwrap();
        let error = (sim.x[0] - rigid[0]).hypot(sim.x[1] - rigid[1]);
        println!("k = {stiffness:e}: {error:e} {:?}", sim.stats());
        // The spring is longer than the rod by some 3 / k, which slows the fall by about as much.
        assert!(error < 3.0 / stiffness + 3e-6, "{stiffness:e}: {error:e}");
        assert!(sim.stats().evaluations < most_evaluations, "{stiffness:e}: {:?}", sim.stats());
    }
}

#[test]
fn constraints_are_kept() {
    // S1@1 of the references.
    let mut sim = double_pendulum::<f64>().start_with(RadauIia5::new(1e-9)).unwrap();
    let mut worst: f64 = 0.0;
    sim.run(1.0, 0.01, |moment| {
        worst = worst.max(
            plm_runtime::Constraints::drift(&moment.mechanism, moment.time, &moment.held, &moment.x).phi,
        );
    })
    .unwrap();
    println!("{:?} drift {worst:e}", sim.stats());
    assert!(
        (sim.x[2] + 1.982_300_799_7).abs() < 1e-6 && (sim.x[5] + 2.289_294_970_6).abs() < 1e-6,
        "{:?}",
        sim.x
    );
    assert!(worst < 1e-8, "{worst}");
}

#[test]
fn redundant_joints_take_difference_quotients() {
    // The pivots of a parallelogram with three cranks vanish: rates and derivatives come from the solution by rank.
    let mut stiff = parallelogram(0.3).start_with(RadauIia5::new(1e-8)).unwrap();
    let mut plain = parallelogram(0.3).start_with(Dopri5::new(1e-10)).unwrap();
    stiff.step(0.5).unwrap();
    plain.step(0.5).unwrap();
    assert!(stiff.stats().by_rank > 0);
    for i in 0..24 {
        assert!((stiff.x[i] - plain.x[i]).abs() < 1e-6, "{i}: {} {}", stiff.x[i], plain.x[i]);
    }
}

#[test]
fn flat_poses_are_passed() {
    // Every crank upright: the energy says whether the branch was kept.
    let mut sim = ladder().start_with(RadauIia5::new(1e-8)).unwrap();
    let energy = |x: &[f64; 30]| -> f64 {
        (0..5)
            .map(|b| {
                let (q, v) = (3 * b, 15 + 3 * b);
                let inertia = x[v + 2] * x[v + 2] / 12.0;
                9.81 * x[q + 1] + 0.5 * (x[v] * x[v] + x[v + 1] * x[v + 1] + inertia)
            })
            .sum()
    };
    let start = energy(&sim.x);
    sim.step(1.0).unwrap();
    println!("{:?}", sim.stats());
    assert!((energy(&sim.x) - start).abs() < 1e-5 * start, "{} {start}", energy(&sim.x));
}

#[test]
fn faults_are_those_of_other_methods() {
    let mut sim = oscillator().start_with(RadauIia5::new(1e-12).with_most_steps(3)).unwrap();
    assert_eq!(sim.step(10.0).unwrap_err().cause, Cause::TooManySteps { steps: 3 });
    for h in [0.0, -1.0, f64::NAN] {
        let mut sim = oscillator().start_with(RadauIia5::new(1e-6).with_longest_step(h)).unwrap();
        assert!(matches!(sim.step(1.0).unwrap_err().cause, Cause::StepTooSmall { .. }), "{h}");
    }
    let mut sim = oscillator().start_with(RadauIia5::new(1e-6)).unwrap();
    sim.x[2] = f64::NAN;
    let fault = sim.step(1.0).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("filter", Cause::NotFinite));
}

#[test]
fn single_precision() {
    let mut sim = oscillator::<f32>().start_with(RadauIia5::new(1e-5)).unwrap();
    sim.step(2.0).unwrap();
    assert!(error(2.0, &sim.x.map(f64::from)) < 1e-4);
}
