//! Saved simulations resume to the bit.

use plm_runtime::method::Method;
use plm_runtime::{Adams, Dop853, Dopri5, Mechanism, Rk4, Sim, Vern9};

use crate::mechanisms::{DoublePendulum, double_pendulum};

fn bits(x: &[f64; 12]) -> [u64; 12] {
    x.map(f64::to_bits)
}

fn resumes_to_the_bit<I: Method<DoublePendulum<f64>>>(mut sim: Sim<DoublePendulum<f64>, I>) {
    sim.step(0.37).unwrap();
    let saved = sim.save();
    sim.step(0.41).unwrap();
    let (x, stats) = (bits(&sim.x), sim.stats());
    sim.step(0.2).unwrap();
    sim.resume(&saved);
    assert_eq!(sim.time, 0.37);
    sim.step(0.41).unwrap();
    assert_eq!((bits(&sim.x), sim.stats()), (x, stats));
}

#[test]
fn every_method_resumes_to_the_bit() {
    resumes_to_the_bit(double_pendulum().start_with(Dopri5::new(1e-7)).unwrap());
    resumes_to_the_bit(double_pendulum().start_with(Dop853::new(1e-9)).unwrap());
    resumes_to_the_bit(double_pendulum().start_with(Vern9::new(1e-9)).unwrap());
    resumes_to_the_bit(double_pendulum().start_with(Adams::new(1e-9)).unwrap());
    resumes_to_the_bit(double_pendulum().start_with(Rk4::new(3e-3)).unwrap());
}

#[test]
fn two_runs_give_the_same_bits() {
    let run = || {
        let mut sim = double_pendulum().start_with(Dop853::new(1e-9)).unwrap();
        let mut all = Vec::new();
        sim.run(1.0, 0.01, |moment| all.push(bits(&moment.x))).unwrap();
        all
    };
    assert_eq!(run(), run());
}

#[test]
fn reading_does_not_forget_the_rate_and_writing_does() {
    let evaluations = |touch: fn(&mut Sim<DoublePendulum<f64>>)| {
        let mut sim = double_pendulum().start().unwrap();
        sim.step(0.1).unwrap();
        let before = sim.stats().evaluations;
        touch(&mut sim);
        sim.step(1e-9).unwrap();
        sim.stats().evaluations - before
    };
    assert_eq!(evaluations(|sim| assert!(sim.x[0] < 1.0)), 12);
    assert_eq!(evaluations(|sim| sim.x[0] += 0.0), 13);
}
