//! Samples, intervals and the steps between them.

use plm_runtime::method::Method;
use plm_runtime::{Adams, Dop853, Dopri5, Mechanism, Rk4, Vern9};

use crate::mechanisms::double_pendulum;
use crate::oscillator::{Oscillator, error, oscillator};

#[test]
fn samples_do_not_shorten_steps() {
    let mut plain = oscillator().start_with(Dopri5::new(1e-6)).unwrap();
    plain.step(2.0).unwrap();
    let mut sampled = oscillator().start_with(Dopri5::new(1e-6)).unwrap();
    let mut times = Vec::new();
    sampled.run(2.0, 0.01, |moment| times.push(moment.time)).unwrap();
    assert_eq!(plain.x, sampled.x);
    assert_eq!(plain.stats(), sampled.stats());
    assert_eq!(times.len(), 201);
    assert_eq!((times[0], times[200]), (0.0, 2.0));
}

#[test]
fn samples_cost_the_extra_stages_only_where_they_are() {
    cost_so_many_stages(3, &Dop853::new(1e-6));
    cost_so_many_stages(4, &Vern9::new(1e-6));
    cost_so_many_stages(0, &Adams::new(1e-6));
}

fn cost_so_many_stages(stages: u64, method: &impl Method<Oscillator<f64>>) {
    let run = |every: f64| {
        let mut sim = oscillator().start_with(method.clone()).unwrap();
        sim.run(2.0, every, |_| ()).unwrap();
        (sim.x, sim.stats())
    };
    let ((x, plain), (x_few, few), (x_many, many)) = (run(2.0), run(1.0), run(0.001));
    assert_eq!((x, x), (x_few, x_many));
    assert_eq!(few.evaluations, plain.evaluations + stages);
    assert_eq!(many.evaluations, plain.evaluations + stages * plain.steps);
}

#[test]
fn samples_of_fixed_steps_are_steps() {
    let mut sim = oscillator().start_with(Rk4::new(0.004)).unwrap();
    let mut worst: f64 = 0.0;
    sim.run(1.0, 0.01, |moment| worst = worst.max(error(moment.time, &moment.x))).unwrap();
    // 0.01 s is divided into three steps; the error is that of Runge-Kutta 4 with 1/300 s.
    assert_eq!(sim.stats().steps, 300);
    assert!(worst < 1e-9, "{worst}");
}

#[test]
fn run_ends_between_samples_if_it_must() {
    for dense in [true, false] {
        let mut times = Vec::new();
        let mut push = |t: f64| times.push(t);
        let end = if dense {
            let mut sim = oscillator::<f64>().start().unwrap();
            sim.run(1.0, 0.3, |moment| push(moment.time)).unwrap();
            sim.time
        } else {
            let mut sim = oscillator::<f64>().start_with(Rk4::new(0.01)).unwrap();
            sim.run(1.0, 0.3, |moment| push(moment.time)).unwrap();
            sim.time
        };
        assert_eq!(times, [0.0, 0.3, 0.6, 0.3 * 3.0]);
        assert_eq!(end, 1.0);
    }
}

#[test]
fn a_step_that_is_cut_does_not_shorten_the_next_ones() {
    let mut whole = oscillator().start_with(Dopri5::new(1e-6)).unwrap();
    whole.step(4.0).unwrap();
    let mut cut = oscillator().start_with(Dopri5::new(1e-6)).unwrap();
    for _ in 0..4 {
        cut.step(0.999).unwrap();
        cut.step(0.001).unwrap();
    }
    assert!(cut.stats().steps <= whole.stats().steps + 12, "{:?} {:?}", cut.stats(), whole.stats());
}

#[test]
fn a_changed_input_is_felt_at_once() {
    // Constant force 1 on the oscillator from t = 1 on moves its equilibrium: q - exact = 1 - cos(t - 1).
    let mut sim = oscillator().start_with(Dopri5::new(1e-10)).unwrap();
    sim.step(1.0).unwrap();
    let evaluations = sim.stats().evaluations;
    sim.held = 1.0;
    sim.step(1.0).unwrap();
    let expected = crate::oscillator::exact(2.0)[0] + 1.0 - 1.0_f64.cos();
    assert!((sim.x[0] - expected).abs() < 1e-8, "{}", sim.x[0] - expected);
    assert!(sim.stats().evaluations > evaluations);
}

#[test]
fn a_projected_step_is_interpolated_to_where_it_was_projected() {
    // Tolerances at which nearly every step is projected: samples just before and at the ends of steps must meet.
    let mut sim = double_pendulum::<f64>().start_with(Dopri5::new(1e-5)).unwrap();
    let mut last: Option<(f64, [f64; 12])> = None;
    let mut jump: f64 = 0.0;
    let dt = 1e-5;
    sim.run(1.0, dt, |moment| {
        if let Some((_, x)) = last {
            for i in 0..6 {
                let predicted = x[i] + dt * 0.5 * (x[6 + i] + moment.x[6 + i]);
                jump = jump.max((moment.x[i] - predicted).abs());
            }
        }
        last = Some((moment.time, moment.x));
    })
    .unwrap();
    assert!(sim.stats().projected > 5, "{:?}", sim.stats());
    // Samples drift less than a tenth of the tolerance, 1e-6; a lost correction would show as a jump of that size.
    assert!(jump < 1e-6, "{jump}");
}
