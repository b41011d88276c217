//! Steps over a sharp bend of the rate, which estimates of an error may miss by chance.

use plm_runtime::{Constraints, Dop853, Events, Fault, Health, Labels, Mechanism, Rate, Sim};

use crate::linkage::At;

/// v' = 900 sin 30 t + 0.2 |R|, as friction by the size of a reaction R = (100 (t - passes), closest) that passes near zero.
#[derive(Clone, Copy, Debug)]
struct Bend<const BENDS: bool> {
    closest: f64,
    passes: f64,
}

impl<const BENDS: bool> Rate for Bend<BENDS> {
    type S = f64;
    type X = [f64; 1];
    type U = ();
    const NQ: usize = 0;

    fn rate(&self, t: f64, (): &(), _: &[f64; 1], dx: &mut [f64; 1]) -> Health<f64> {
        *dx = [900.0 * (30.0 * t).sin() + 0.2 * (100.0 * (t - self.passes)).hypot(self.closest)];
        Health::perfect()
    }
}

impl<const BENDS: bool> Constraints for Bend<BENDS> {}

impl<const BENDS: bool> Events for Bend<BENDS> {
    type G = [f64; 0];
    const BENDS: bool = BENDS;
}

impl<const BENDS: bool> Labels for Bend<BENDS> {}

impl<const BENDS: bool> Mechanism for Bend<BENDS> {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Self::U, [f64; 1]), Fault> {
        Ok(((), [10.0]))
    }
}

/// The integral of hypot(u, d).
fn integral(u: f64, d: f64) -> f64 {
    0.5 * (u * u.hypot(d) + d * d * (u / d).asinh())
}

const TOLERANCE: f64 = 1e-10;

/// The largest error of the first step of 1600 runs, in tolerances.
fn largest_error<const BENDS: bool>() -> f64 {
    let bends = (0..20).flat_map(|i| (0..80).map(move |k| (i, k)));
    bends.fold(0.0, |largest: f64, (i, k)| {
        let (closest, passes) = (0.02 * 1.3_f64.powi(i), 0.0005 * f64::from(k + 1));
        let mut sim = Bend::<BENDS> { closest, passes }.start_with(Dop853::new(TOLERANCE)).unwrap();
        Sim::watch_while(&mut sim, 1.0, 1.0, |_| (), |_| false).unwrap();
        let (t, v) = (sim.time, sim.x[0]);
        assert!(t > 0.0 && t < 0.1, "{t}");
        let pushed = integral(100.0 * (t - passes), closest) - integral(-100.0 * passes, closest);
        let known = 10.0 + 30.0 * (1.0 - (30.0 * t).cos()) + 0.002 * pushed;
        largest.max((v - known).abs() / (TOLERANCE * (1.0 + known.abs())))
    })
}

#[test]
fn a_first_step_over_a_bend_errs_by_no_more_than_its_tolerance() {
    let (alone, both) = (largest_error::<false>(), largest_error::<true>());
    assert!(both <= 1.0, "{both}");
    // One estimate would not do.
    assert!(alone > 1000.0, "{alone}");
}
