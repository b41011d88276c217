//! Projection onto the constraints.

use plm_runtime::absolute::{assemble, drift, project};
use plm_runtime::{Adams, Cause, Dop853, Dopri5, Mechanism, Notice, Rk4};

use crate::mechanisms::{contradictory_pendulum, double_pendulum, four_bar};

#[test]
fn a_drifted_state_is_projected_to_rounding() {
    let m = four_bar();
    let found = assemble(&m, 0.0).unwrap();
    for size in [1e-3, 1e-6, 1e-9, 1e-12] {
        let (mut q, mut v) = (found.q, found.v);
        for i in 0..9 {
            q[i] += size * f64::from(i as u32 % 4) / 4.0;
            v[i] += size * f64::from(i as u32 % 5) / 5.0;
        }
        let before = (q, v);
        project(&m, 0.0, &mut q, &mut v).unwrap();
        let mut x = [0.0; 18];
        plm_runtime::absolute::join(&q, &v, &mut x);
        let after = drift(&m, 0.0, &x);
        assert!(after.phi < 5e-16 && after.phi_dot < 5e-16, "{size}: {after:?}");
        assert!(q.iter().zip(&before.0).all(|(a, b)| (a - b).abs() < 10.0 * size));
    }
}

#[test]
fn projection_moves_heavy_bodies_less() {
    // The correction is orthogonal to every possible motion in the metric of the masses: M dq = phi_q^T (...).
    let m = double_pendulum::<f64>();
    let found = assemble(&m, 0.0).unwrap();
    let (mut q, mut v) = (found.q, found.v);
    q[0] += 1e-7;
    let off = q;
    project(&m, 0.0, &mut q, &mut v).unwrap();
    let jacobian = nalgebra::SMatrix::<f64, 4, 6>::from_fn(|i, j| m.0.phi_q(&q)[i][j]);
    let pull = nalgebra::SVector::<f64, 6>::from_fn(|i, _| m.0.mass[i] * (q[i] - off[i]));
    let motions =
        nalgebra::SMatrix::<f64, 6, 6>::identity() - jacobian.pseudo_inverse(1e-12).unwrap() * jacobian;
    assert!((motions * pull).amax() < 1e-12, "{}", motions * pull);
}

#[test]
fn a_state_that_cannot_be_projected_is_a_fault() {
    let m = contradictory_pendulum();
    let (mut q, mut v) = ([1.0, 0.0, 0.0], [0.0; 3]);
    let fault = project(&m, 3.0, &mut q, &mut v).unwrap_err();
    assert_eq!((fault.time, fault.part), (3.0, "pivot"));
    assert!(matches!(fault.cause, Cause::Drift { phi, .. } if (phi - 0.125).abs() < 1e-9), "{fault}");
}

#[test]
fn fixed_steps_are_projected_seldom_and_enough() {
    let mut sim = double_pendulum::<f64>().start_with(Rk4::new(2e-3)).unwrap();
    let mut worst: f64 = 0.0;
    for _ in 0..500 {
        sim.step(2e-3).unwrap();
        worst = worst.max(sim.drift().phi).max(sim.drift().phi_dot / 10.0);
    }
    println!("rk4 2 ms: worst drift {worst:e}, {:?}", sim.stats());
    assert!(sim.stats().projected > 0 && sim.stats().projected < 400, "{:?}", sim.stats());
    // The tolerance, and what the steps between two looks add to it.
    assert!(worst < 1e-8, "{worst:e}");
}

#[test]
fn without_drift_to_speak_of_nothing_is_projected() {
    let mut sim = double_pendulum::<f64>().start_with(Rk4::new(1e-4)).unwrap();
    sim.step(0.1).unwrap();
    assert_eq!(sim.stats().projected, 0);
}

#[test]
fn adams_keeps_joints_together_and_follows() {
    let mut sim = double_pendulum().start_with(Adams::new(1e-9)).unwrap();
    sim.step(1.0).unwrap();
    // Above a tenth of the tolerance drift is projected; the system's size is about a metre.
    assert!(sim.stats().projected > 0 && sim.drift().phi < 1e-9, "{:?}", sim.drift());
    // Angles after 1 s: references.json, S1@1.
    let off = [sim.x[2] + 1.982_300_8, sim.x[5] + 2.289_295];
    assert!(off.iter().all(|off: &f64| off.abs() < 1e-6), "{:?}", sim.x);
}

#[test]
fn settling_costs_one_evaluation() {
    let mut sim = double_pendulum::<f64>().start_with(Dopri5::new(1e-8)).unwrap();
    sim.step(1.0).unwrap();
    let stats = sim.stats();
    assert!(stats.projected > 0);
    // One at the start, one for the first step, six a step, one for each projected state.
    assert_eq!(stats.evaluations, 2 + 6 * (stats.steps + stats.rejected) + stats.projected);
}

#[test]
fn stiff_stabilisation_is_noticed() {
    let mut m = double_pendulum::<f64>();
    m.0.alpha = Some(100.0);
    let mut sim = m.start_with(Rk4::new(6e-3)).unwrap();
    sim.step(6e-3).unwrap();
    let Some(Notice::StiffStabilisation { h_alpha }) = sim.notice() else { panic!("no notice") };
    assert!((h_alpha - 0.6).abs() < 1e-12);
}

#[test]
fn drift_that_is_left_standing_does_not_shorten_steps() {
    // Drift of a few hundredths of the tolerance is not projected; were it taken for an error of the step, which is to aim
    // at 0.7^8 = 0.058 of the tolerance, every step would be shorter than the one before, without end.
    for k in 0..24 {
        let rtol = 1e-13 * 10_f64.powf(f64::from(k) / 3.0);
        let mut sim = four_bar().start_with(Dop853::new(rtol)).unwrap();
        sim.step(10.0).unwrap_or_else(|fault| panic!("{rtol:e}: {fault}"));
        // Steps of order 8 grow by 10^(1/8) from decade to decade.
        let most = 220.0 * (1e-5 / rtol).powf(0.125);
        assert!((sim.stats().steps as f64) < most, "{rtol:e}: {:?}", sim.stats());
    }
}
