//! Orders of convergence, by halving the step.

use plm_runtime::method::{DormandPrince5, DormandPrince853, Embedded, Method, Pair, Verner98};
use plm_runtime::{Adams, Dop853, Dopri5, Mechanism, Rk4, SemiImplicitEuler, Vern9};

use crate::oscillator::{Oscillator, error, exact, oscillator};

/// Error at t = 2 with steps of at most `h`.
fn error_with(method: impl Method<Oscillator<f64>>) -> f64 {
    let mut sim = oscillator().start_with(method).unwrap();
    sim.step(2.0).unwrap();
    assert_eq!(sim.time, 2.0);
    error(2.0, &sim.x)
}

/// Observed order between steps of 1/50 and 1/100 s.
fn order(error_with_step: impl Fn(f64) -> f64) -> f64 {
    (error_with_step(0.02) / error_with_step(0.01)).log2()
}

#[test]
fn semi_implicit_euler_has_order_1() {
    let order = order(|h| error_with(SemiImplicitEuler::new(h)));
    assert!((order - 1.0).abs() < 0.05, "{order}");
}

#[test]
fn rk4_has_order_4() {
    let order = order(|h| error_with(Rk4::new(h)));
    assert!((order - 4.0).abs() < 0.05, "{order}");
}

/// Dormand-Prince with a tolerance that lets every step of `h` pass.
fn fixed<P: Pair>(h: f64) -> Embedded<Oscillator<f64>, P> {
    Embedded::new(10.0).with_longest_step(h)
}

#[test]
fn dopri5_has_order_5() {
    let order = order(|h| error_with(fixed::<DormandPrince5>(2.0 * h)));
    assert!((order - 5.0).abs() < 0.2, "{order}");
}

#[test]
fn dop853_has_order_8() {
    let order = order(|h| error_with(fixed::<DormandPrince853>(10.0 * h)));
    assert!((order - 8.0).abs() < 0.3, "{order}");
}

#[test]
fn vern9_has_order_9() {
    let order = order(|h| error_with(fixed::<Verner98>(10.0 * h)));
    assert!((order - 9.0).abs() < 0.3, "{order}");
}

/// Observed order of the worst error inside the steps, between `2 h` and `h`.
fn dense_order<P: Pair>(h: f64) -> f64 {
    let worst = |h: f64| {
        let mut sim = oscillator().start_with(fixed::<P>(h)).unwrap();
        let mut worst = 0.0;
        sim.run(2.0, 0.013, |moment| worst = f64::max(worst, error(moment.time, &moment.x))).unwrap();
        assert!(sim.stats().longest_step > 0.9 * h);
        worst
    };
    (worst(2.0 * h) / worst(h)).log2()
}

#[test]
fn dense_output_has_the_order_of_its_polynomial_or_more() {
    // The error inside a step is that of its ends (order 5, 8, 9) and of the polynomial (local error of order 5, 8, 9).
    let (fifth, eighth) = (dense_order::<DormandPrince5>(0.02), dense_order::<DormandPrince853>(0.08));
    assert!((4.8..5.3).contains(&fifth), "{fifth}");
    assert!((7.7..8.4).contains(&eighth), "{eighth}");
    // Of Verner's polynomial the term of order 9 is small beside the next.
    let ninth = dense_order::<Verner98>(0.1);
    assert!((8.7..10.2).contains(&ninth), "{ninth}");
}

#[test]
fn the_pairs_keep_their_tolerance() {
    for (rtol, of_5, of_853, of_9) in [(1e-4, 150, 150, 200), (1e-8, 700, 350, 300), (1e-12, 4000, 1000, 700)]
    {
        let mut sim = oscillator().start_with(Dopri5::new(rtol)).unwrap();
        sim.step(2.0).unwrap();
        // The tolerance is per step; the solution neither grows nor decays.
        assert!(error(2.0, &sim.x) < 30.0 * rtol, "{rtol}: {}", error(2.0, &sim.x));
        assert!(sim.stats().evaluations < of_5, "{rtol}: {:?}", sim.stats());
        let mut sim = oscillator().start_with(Dop853::new(rtol)).unwrap();
        sim.step(2.0).unwrap();
        assert!(error(2.0, &sim.x) < 30.0 * rtol, "{rtol}: {}", error(2.0, &sim.x));
        assert!(sim.stats().evaluations < of_853, "{rtol}: {:?}", sim.stats());
        let mut sim = oscillator().start_with(Vern9::new(rtol)).unwrap();
        sim.step(2.0).unwrap();
        assert!(error(2.0, &sim.x) < 30.0 * rtol, "{rtol}: {}", error(2.0, &sim.x));
        assert!(sim.stats().evaluations < of_9, "{rtol}: {:?}", sim.stats());
    }
}

/// Tolerances are per step, and a run has some hundred of them.
#[test]
fn adams_keeps_its_tolerance_at_and_between_the_ends_of_steps() {
    for (rtol, evaluations, order) in [(1e-4, 200, 4), (1e-8, 500, 7), (1e-12, 900, 9)] {
        let mut sim = oscillator().start_with(Adams::new(rtol)).unwrap();
        let (mut worst, mut before, mut bend) = (0.0, [0.0; 3], 0.0);
        sim.run(2.0, 0.002, |moment| {
            worst = f64::max(worst, error(moment.time, &moment.x));
            let known = exact(moment.time);
            let off: [f64; 3] = core::array::from_fn(|i| moment.x[i] - known[i]);
            bend = (0..3).map(|i| f64::abs(off[i] - before[i])).fold(bend, f64::max);
            before = off;
        })
        .unwrap();
        // Within a step, which has many samples, errors change by less than the step may err: the states come to 2, beside 1.
        assert!(bend < 3.0 * rtol, "{rtol}: {bend:e}");
        let highest = sim.method().order().unwrap_or(0);
        assert!(worst < 100.0 * rtol, "{rtol}: {worst:e}");
        assert!(sim.stats().evaluations < evaluations, "{rtol}: {:?}", sim.stats());
        assert!(highest >= order, "{rtol}: {highest}");
    }
}

#[test]
fn semi_implicit_euler_uses_the_new_velocity() {
    let mut sim = oscillator().start_with(SemiImplicitEuler::new(0.5)).unwrap();
    let [q, v, z] = sim.x;
    sim.step(0.5).unwrap();
    let v_new = v + 0.5 * (3.0 - q);
    assert_eq!(sim.x, [q + 0.5 * v_new, v_new, z]);
}
