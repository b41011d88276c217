//! The time after many intervals, and intervals that cannot be.

use plm_runtime::{Cause, Dop853, Fault, Mechanism, Rk4, Scalar, SemiImplicitEuler};

use crate::oscillator::oscillator;

#[test]
fn a_million_milliseconds_are_a_thousand_seconds_in_single_precision() {
    let mut sim = oscillator::<f32>().start_with(SemiImplicitEuler::new(1e-3_f32)).unwrap();
    for _ in 0..1_000_000 {
        sim.step(1e-3).unwrap();
    }
    // f32 holds 1e-3 as 1.0000000475e-3: a million are 1000.0000475, and numbers of this size are 6.1e-5 apart.
    assert!((sim.time - 1000.0).abs() <= 6.2e-5, "{}", sim.time);
    assert_eq!(sim.stats().steps, 1_000_000, "an interval of one step is one step");
}

#[test]
fn an_interval_of_whole_steps_is_so_many_at_any_time() {
    macro_rules! steps {
        ($real:ident, $start:expr, $each:expr) => {{
            let h: $real = 1e-3;
            let mut sim = oscillator::<$real>().start_at($start, Rk4::new(h)).unwrap();
            // Its rate grows with the time.
            sim.x[2] = 0.0;
            for _ in 0..1000 {
                sim.step(h * $each).unwrap();
            }
            sim.stats().steps
        }};
    }
    for start in [0.0, 1.0, 900.0_f32] {
        for each in [1.0, 3.0, 10.0_f32] {
            assert_eq!(steps!(f32, start, each), (1000.0 * f64::from(each)) as u64, "f32 from {start}");
        }
    }
    for start in [0.0, 1e3, 1e6] {
        for each in [1.0, 3.0, 10.0] {
            assert_eq!(steps!(f64, start, each), (1000.0 * each) as u64, "f64 from {start}");
        }
    }
}

#[test]
fn what_is_shorter_than_a_unit_of_the_time_is_not_lost() {
    // At 1000 s numbers of f32 are 6.1e-5 s apart.
    let mut sim = oscillator::<f32>().start_at(1000.0, Dop853::default()).unwrap();
    for _ in 0..100_000 {
        sim.step(1e-5).unwrap();
    }
    assert!((sim.time - 1001.0).abs() < 1e-4, "{}", sim.time);
}

#[test]
fn runs_that_cannot_be_say_which_length() {
    let mut sim = oscillator::<f64>().start().unwrap();
    sim.step(0.1).unwrap();
    let message = |fault: Result<(), Fault>| fault.unwrap_err().to_string();
    let before = message(sim.run(0.05, 0.1, |_| ()));
    assert_eq!(before, "t = 0.1 s: an interval of -0.05 s cannot be integrated");
    let tiny = message(sim.run(1.0, 1e-300, |_| ()));
    assert_eq!(tiny, "t = 0.1 s: an interval of 1e-300 s cannot be integrated");
    for every in [f64::NEG_INFINITY, -1.0, 0.0, f64::NAN] {
        let fault = sim.run(1.0, every, |_| ()).unwrap_err();
        assert!(matches!(fault.cause, Cause::Interval { .. }), "{every}: {fault}");
        assert_eq!(sim.time, 0.1);
    }
    assert!(matches!(sim.run(f64::NAN, 0.1, |_| ()).unwrap_err().cause, Cause::Interval { .. }));
    assert!(matches!(sim.run(f64::INFINITY, 0.1, |_| ()).unwrap_err().cause, Cause::Interval { .. }));
    let (mut samples, zero) = (0, f64::lit(0.0));
    sim.run(1.0, f64::INFINITY, |_| samples += 1).unwrap();
    assert_eq!((samples, sim.time, sim.step(zero)), (1, 1.0, Ok(())));
}
