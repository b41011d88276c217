//! Assembly: what the manual prints, what is locked, what does not close.

use plm_runtime::absolute::{Status, assemble};
use plm_runtime::{Cause, Start};

use crate::mechanisms::{
    bars, contradictory_pendulum, double_pendulum, pendulum, unassembled_double_pendulum,
};

fn locked(value: f64) -> Start<f64> {
    Start::locked(value)
}

#[test]
fn the_manuals_double_pendulum_lands_where_the_manual_says() {
    // Manual, 2.2: 68.1934 and -25.7586 deg; reading notes, section 2: 68.193440, -25.758590 deg.
    let found = assemble(&unassembled_double_pendulum::<f64>(), 0.0).unwrap();
    assert!((found.q[2].to_degrees() - 68.193_440).abs() < 5e-7, "{}", found.q[2].to_degrees());
    assert!((found.q[5].to_degrees() + 25.758_590).abs() < 5e-7, "{}", found.q[5].to_degrees());
    assert_eq!((found.rank, found.rows, found.locks, found.freedom), (4, 4, 0, 2));
    assert_eq!((found.status, found.singular), (Status::Insufficient, false));
    assert!(found.gap < 1e-15, "{}", found.gap);
    assert_eq!(found.moved[0], found.q[0]);
}

#[test]
fn locked_angles_stay() {
    let mut m = unassembled_double_pendulum::<f64>();
    for (body, angle) in [(0, 45.0_f64), (1, 0.0)] {
        m.0.start[body].angle = locked(angle.to_radians());
    }
    let found = assemble(&m, 0.0).unwrap();
    assert_eq!([found.q[2], found.q[5]], [45.0_f64.to_radians(), 0.0]);
    assert_eq!((found.status, found.locks, found.rank, found.rows), (Status::Sufficient, 2, 6, 6));
    // Exactly the pose of the benchmark S1.
    for (a, b) in found.q.iter().zip(double_pendulum::<f64>().0.start_position()) {
        assert!((a - b.value).abs() < 1e-15);
    }
}

#[test]
fn too_many_locks_are_named() {
    // Manual, 4.4: the pendulum with angle, x and y locked: "There are 2 redundant constants".
    for shift in [0.0, 0.2] {
        let mut m = pendulum::<f64>(0.7);
        let body = &mut m.0.start[0];
        (body.x, body.y, body.angle) =
            (locked(body.x.value + shift), locked(body.y.value), locked(body.angle.value));
        let fault = assemble(&m, 0.0).unwrap_err();
        let Cause::Redundant { count, locks, joints } = fault.cause else { panic!("{fault}") };
        assert_eq!(count, 2);
        assert_eq!(locks.iter().collect::<Vec<_>>(), ["arm.x", "arm.y", "arm.angle"]);
        assert_eq!(joints.iter().collect::<Vec<_>>(), ["pivot"]);
        assert_eq!(
            fault.to_string(),
            "t = 0 s: 2 redundant position constraints: arm.x (locked), arm.y (locked), arm.angle (locked), tied by pivot"
        );
    }
}

#[test]
fn a_lock_elsewhere_is_not_blamed() {
    let mut m = unassembled_double_pendulum::<f64>();
    let [arm, forearm] = [m.0.start[0].angle.value, m.0.start[1].angle.value];
    m.0.start[0].angle = locked(arm);
    m.0.start[1].angle = locked(forearm);
    m.0.start[0].x = locked(0.353_553_390_593_273_8);
    let fault = assemble(&m, 0.0).unwrap_err();
    let Cause::Redundant { count, locks, joints } = fault.cause else { panic!("{fault}") };
    assert_eq!(count, 1);
    assert_eq!(locks.iter().collect::<Vec<_>>(), ["arm.x", "arm.angle"]);
    assert_eq!(joints.iter().collect::<Vec<_>>(), ["shoulder"]);
}

#[test]
fn a_lock_at_a_dead_point_is_not_redundant() {
    // Crank and coupler in line: the rocker is at the end of its swing, its angle cannot move to first order.
    let (crank, coupler, rocker) = (0.3_f64, 0.9, 0.7);
    let reach = crank + coupler;
    let foot = ((reach * reach + 1.0 - rocker * rocker) / (2.0 * reach)).acos();
    let gamma = (reach * foot.sin()).atan2(reach * foot.cos() - 1.0);
    let mut m = bars([crank, coupler, rocker], [foot, foot, gamma]);
    m.0.start[0].angle.locked = false;
    m.0.start[2].angle.locked = true;
    let found = assemble(&m, 0.0).unwrap();
    assert!(found.singular);
    assert_eq!(found.rank, 8);
}

#[test]
fn bars_that_are_too_short_stay_open() {
    // Crank at 180 deg: coupler and rocker, 1.1 m together, have 1.3 m to span.
    let m = bars([0.3, 0.6, 0.5], [core::f64::consts::PI, 0.1, 3.0]);
    let fault = assemble(&m, 0.0).unwrap_err();
    let Cause::Open { gap } = fault.cause else { panic!("{fault}") };
    assert!(["b", "c", "d"].contains(&fault.part), "{fault}");
    // Wherever the iteration ends, the open joint has to bridge its part of 0.2 m, less what the crank gives.
    assert!((0.05..1.0).contains(&gap), "{gap}");
}

#[test]
fn rows_that_contradict_each_other_stay_open() {
    let fault = assemble(&contradictory_pendulum(), 0.0).unwrap_err();
    assert_eq!(fault.part, "pivot");
    // x = 1 and x = 1.25: an eighth remains in each of two rows of the joint.
    let Cause::Open { gap } = fault.cause else { panic!("{fault}") };
    assert!((gap - 0.125 * 2_f64.sqrt()).abs() < 1e-12, "{gap}");
}

#[test]
fn velocities_are_corrected_least() {
    // A bar on its end pivot with omega = 1 free and G's velocity wrong: minimum norm of the correction.
    let mut m = pendulum::<f64>(0.0);
    m.0.start[0].omega = Start::free(1.0);
    let found = assemble(&m, 0.0).unwrap();
    // min (vy)^2 + (omega - 1)^2 with vy = omega / 2: omega = 0.8.
    assert!((found.v[2] - 0.8).abs() < 1e-15 && (found.v[1] - 0.4).abs() < 1e-15, "{:?}", found.v);
    m.0.start[0].omega = locked(1.0);
    let found = assemble(&m, 0.0).unwrap();
    assert!((found.v[1] - 0.5).abs() < 1e-15 && found.v[2] == 1.0, "{:?}", found.v);
}

#[test]
fn too_many_velocity_locks_are_named() {
    let mut m = pendulum::<f64>(0.0);
    m.0.start[0].omega = locked(1.0);
    m.0.start[0].vy = locked(0.5);
    let fault = assemble(&m, 0.0).unwrap_err();
    assert!(fault.to_string().contains("arm.vy (locked), arm.omega (locked)"), "{fault}");
    let Cause::VelocityRedundant { count, locks, .. } = fault.cause else { panic!("{fault}") };
    assert_eq!(count, 1);
    assert_eq!(locks.iter().collect::<Vec<_>>(), ["arm.y", "arm.angle"]);
}

#[test]
fn a_start_that_is_not_a_number_is_named() {
    let mut m = pendulum::<f64>(0.0);
    m.0.start[0].y = Start::free(f64::NAN);
    let fault = assemble(&m, 0.0).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("arm.y", Cause::NotFinite));
}

#[test]
fn the_report_reads_well() {
    let report = assemble(&unassembled_double_pendulum::<f64>(), 0.0).unwrap().to_string();
    let first = report.lines().next().unwrap();
    assert_eq!(first, "F = 3N - M = 6 - 4 = 2; 0 locked; rank 4 of 4 rows: insufficient");
    assert!(report.contains("forearm.angle = -0.4495"), "{report}");
}
