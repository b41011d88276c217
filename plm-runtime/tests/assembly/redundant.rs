//! Redundant joints and singular poses: what runs by rank.

use plm_runtime::absolute::{Status, accelerate, assemble};
use plm_runtime::{Absolute, Cause, Start};

use crate::linkage::Row;
use crate::mechanisms::{bars, double_pendulum, parallelogram};

#[test]
fn a_third_crank_is_flagged() {
    let found = assemble(&parallelogram(0.8), 0.0).unwrap();
    assert_eq!((found.rank, found.rows, found.freedom), (11, 12, 0));
    assert_eq!((found.status, found.singular), (Status::Redundant, false));
    // The dependency is along the cranks at joints that carry it; every crank takes part.
    assert!(found.redundant.iter().filter(|r| **r).count() >= 6, "{:?}", found.redundant);
}

#[test]
fn a_third_crank_closes_from_a_rough_start() {
    let mut m = parallelogram(0.8);
    for (i, body) in m.0.start.iter_mut().take(4).enumerate() {
        body.angle.value += [0.05, -0.1, 0.1, 0.03][i];
        body.x.value += 0.02;
    }
    let found = assemble(&m, 0.0).unwrap();
    assert_eq!((found.rank, found.status), (11, Status::Redundant));
    assert!(found.gap < 1e-13, "{}", found.gap);
}

#[test]
fn one_lock_on_a_redundant_mechanism_is_enough_and_two_are_too_many() {
    let mut m = parallelogram(0.8);
    m.0.start[1].angle.locked = true;
    let found = assemble(&m, 0.0).unwrap();
    assert_eq!((found.rank, found.rows, found.status), (12, 13, Status::Redundant));
    m.0.start[3].angle.locked = true;
    let fault = assemble(&m, 0.0).unwrap_err();
    let Cause::Redundant { count, locks, .. } = fault.cause else { panic!("{fault}") };
    assert_eq!(count, 1);
    assert_eq!(locks.iter().collect::<Vec<_>>(), ["crank1.angle", "crank3.angle"]);
}

#[test]
fn a_small_mechanism_has_the_rank_of_a_large_one() {
    for scale in [1e-3, 1e3] {
        let mut m = bars([0.3, 0.9, 0.7], [1.0, 0.5, 1.5]);
        for row in &mut m.0.rows {
            let Row::Coincide { pa, pb, .. } = row else { panic!("{row:?}") };
            (*pa, *pb) = (pa.map(|p| scale * p), pb.map(|p| scale * p));
        }
        for body in &mut m.0.start {
            (body.x.value, body.y.value) = (scale * body.x.value, scale * body.y.value);
        }
        m.0.length = scale;
        let found = assemble(&m, 0.0).unwrap();
        assert_eq!((found.rank, found.rows, found.singular), (9, 9, false), "{scale}");
        m.0.start[2].angle = Start::locked(found.q[8]);
        let fault = assemble(&m, 0.0).unwrap_err();
        assert!(matches!(fault.cause, Cause::Redundant { count: 1, .. }), "{scale}: {fault}");
    }
}

#[test]
fn a_flat_pose_is_singular_and_not_redundant() {
    let m = bars([0.5, 1.0, 0.5], [0.0, 0.0, 0.0]);
    let found = assemble(&m, 0.0).unwrap();
    assert_eq!((found.status, found.singular, found.rank), (Status::Sufficient, true, 8));
    assert_eq!(found.redundant, [false; 8]);
}

#[test]
fn a_crank_with_a_coupler_that_never_turns_swings_like_a_pendulum() {
    // Bar m = 2 kg translates on a circle of r = 0.5 m, three cranks 0.5 kg each turn about their ends:
    // theta'' = -g (m r + 3 m_c r / 2) / (m r^2 + 3 m_c r^2 / 3) cos(theta).
    let m = parallelogram(0.3);
    let (bar, crank, r) = (2.0, 0.5, 0.5);
    let inertia = bar * r * r + crank * r * r;
    let expected = -9.81 * (bar * r + 1.5 * crank * r) / inertia * 0.3_f64.cos();
    let found = assemble(&m, 0.0).unwrap();
    let a = m.0.acceleration_by_rank(0.0, &found.q, &found.v).unwrap();
    for crank in [5, 8, 11] {
        assert!((a[crank] - expected).abs() < 1e-12 * expected.abs(), "{} {expected}", a[crank]);
    }
    assert!(a[2].abs() < 1e-12);
}

#[test]
fn multipliers_are_the_shortest_and_their_doubt_is_said() {
    let m = parallelogram(0.8);
    let found = assemble(&m, 0.0).unwrap();
    let force = m.0.force;
    let phi_q = m.0.phi_q(&found.q);
    let solved = accelerate(0.0, &m.inverse_mass(), &force, &[0.0; 12], |rows| *rows = phi_q).unwrap();
    assert_eq!(solved.rank, 11);
    assert_eq!(solved.undetermined, found.redundant);
    let jacobian = nalgebra::SMatrix::<f64, 12, 12>::from_fn(|i, j| phi_q[i][j]);
    let rest = nalgebra::SVector::<f64, 12>::from_fn(|i, _| force[i] - m.0.mass[i] * solved.a[i]);
    let lambda = jacobian.transpose().pseudo_inverse(1e-9).unwrap() * rest;
    for j in 0..12 {
        assert!((lambda[j] - solved.lambda[j]).abs() < 1e-11, "{} {}", lambda[j], solved.lambda[j]);
    }
}

#[test]
fn a_four_bar_near_its_flat_pose_loses_no_digits() {
    // Close to flat the condition number of phi_q is large, and that of phi_q M^-1 phi_q^T is its square. Equal and
    // opposite accelerations of the cranks of a parallelogram are exact: the coupler does not turn.
    for angle in [1e-2, 1e-4, 1e-6] {
        let m = bars([0.5, 1.0, 0.5], [angle, 0.0, angle]);
        let (q, v) = (m.0.start_position().map(|s| s.value), [0.0; 9]);
        let by_rank = m.0.acceleration_by_rank(0.0, &q, &v).unwrap();
        // Kinetic energy 1/2 (m r^2 + 2 (1/3) m_c r^2) theta'^2 with m = 1, m_c = r = 1/2.
        let expected = -9.81 * (0.5 + 0.25) / (0.25 + 1.0 / 12.0) * angle.cos();
        let error = (by_rank[2] - expected).abs().max((by_rank[8] - expected).abs()) / expected.abs();
        assert!(error < 1e-15 / angle, "{angle}: {error:e}");
    }
}

#[test]
fn a_light_link_carries_a_heavy_body() {
    // Masses 1e10 apart are no reason to lose a direction. Lagrange's equations of the double pendulum at rest:
    // [m11 m12; m12 m22] a = -g [(m1 c1 + m2 l1) cos(theta1); m2 c2 cos(theta2)].
    let (m1, j1, m2, j2) = (1e-7, 1e-9, 1e3, 1.0);
    let mut m = double_pendulum::<f64>();
    m.0.mass = [m1, m1, j1, m2, m2, j2];
    m.0.force = [0.0, -9.81 * m1, 0.0, 0.0, -9.81 * m2, 0.0];
    let q = m.start_position().map(|s| s.value);
    let by_rank = m.0.acceleration_by_rank(0.0, &q, &[0.0; 6]).unwrap();
    let (c1, c2, l1, turn) = (0.5, 1.0, 1.0, q[2] - q[5]);
    let (m11, m12, m22) = (j1 + m1 * c1 * c1 + m2 * l1 * l1, m2 * l1 * c2 * turn.cos(), j2 + m2 * c2 * c2);
    let (f1, f2) = (-9.81 * (m1 * c1 + m2 * l1) * q[2].cos(), -9.81 * m2 * c2 * q[5].cos());
    let determinant = m11 * m22 - m12 * m12;
    let expected = [(m22 * f1 - m12 * f2) / determinant, (m11 * f2 - m12 * f1) / determinant];
    for (a, e) in [by_rank[2], by_rank[5]].into_iter().zip(expected) {
        assert!((a - e).abs() < 1e-11 * (1.0 + e.abs()), "{a} {e}");
    }
}

#[test]
fn velocity_locks_are_felt_through_redundant_joints() {
    let mut m = parallelogram(0.8);
    m.0.start[1].omega = Start::locked(2.0);
    let found = assemble(&m, 0.0).unwrap();
    for crank in [5, 8, 11] {
        assert!((found.v[crank] - 2.0).abs() < 1e-14);
    }
    assert!(found.v[2].abs() < 1e-14);
}
