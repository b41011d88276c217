//! Everything in single precision.

use plm_runtime::absolute::{Status, assemble};
use plm_runtime::{Adams, Cause, Dopri5, Mechanism, Rk4, Start, Vern9};

use crate::mechanisms::{double_pendulum, pendulum, unassembled_double_pendulum};
use crate::oscillator::{error, oscillator};

#[test]
fn assembly_works_in_single_precision() {
    let found = assemble(&unassembled_double_pendulum::<f32>(), 0.0).unwrap();
    assert!((found.q[2].to_degrees() - 68.193_44).abs() < 1e-4, "{}", found.q[2].to_degrees());
    assert_eq!(found.status, Status::Insufficient);
    let mut m = pendulum::<f32>(0.7);
    let body = &mut m.0.start[0];
    (body.x, body.y, body.angle) =
        (Start::locked(body.x.value), Start::locked(body.y.value), Start::locked(body.angle.value));
    assert!(matches!(assemble(&m, 0.0).unwrap_err().cause, Cause::Redundant { count: 2, .. }));
}

#[test]
fn methods_work_in_single_precision() {
    let mut sim = oscillator::<f32>().start_with(Rk4::new(0.01)).unwrap();
    sim.step(2.0).unwrap();
    assert!(error(2.0, &sim.x.map(f64::from)) < 1e-5);
    assert_eq!(sim.stats().steps, 200);
    let mut sim = oscillator::<f32>().start_with(Dopri5::new(1e-5)).unwrap();
    sim.step(2.0).unwrap();
    assert!(error(2.0, &sim.x.map(f64::from)) < 1e-4);
    let mut sim = oscillator::<f32>().start_with(Adams::new(1e-5)).unwrap();
    sim.step(2.0).unwrap();
    assert!(error(2.0, &sim.x.map(f64::from)) < 1e-4);
    let mut sim = oscillator::<f32>().start_with(Vern9::new(1e-5)).unwrap();
    sim.step(2.0).unwrap();
    assert!(error(2.0, &sim.x.map(f64::from)) < 1e-5);
}

#[test]
fn a_double_pendulum_runs_in_single_precision() {
    // Angles after 1 s: references.json, S1@1.
    let reference = [-1.982_300_8_f32, -2.289_295];
    let mut fixed = double_pendulum::<f32>().start_with(Rk4::new(2e-3)).unwrap();
    fixed.step(1.0).unwrap();
    let mut adaptive = double_pendulum::<f32>().start().unwrap();
    adaptive.step(1.0).unwrap();
    for x in [fixed.x, adaptive.x] {
        assert!((x[2] - reference[0]).abs() < 1e-3 && (x[5] - reference[1]).abs() < 1e-3, "{x:?}");
    }
    assert!(adaptive.drift().phi < 1e-5, "{:?}", adaptive.drift());
}
