//! A driven oscillator with an exact solution that reaches every term of a formula: time, v, first-order states.
#![allow(dead_code, reason = "each uses its part")]

use plm_runtime::{Constraints, Dual, Events, Fault, Health, Labels, Linear, Mechanism, Rate, Real};

use crate::linkage::At;

/// q'' = -q + 3 cos 2t, z' = -2 t z.
#[derive(Clone, Copy, Debug)]
pub struct Oscillator<S>(pub core::marker::PhantomData<S>);

impl<S: Real> Rate for Oscillator<S> {
    type S = S;
    type X = [S; 3];
    type U = f64;
    const NQ: usize = 1;

    fn rate(&self, t: S, u: &f64, x: &[S; 3], dx: &mut [S; 3]) -> Health<S> {
        let drive = S::lit(3.0) * (t + t).cos() + S::lit(*u);
        *dx = [x[1], drive - x[0], -(t + t) * x[2]];
        Health::perfect()
    }
}

impl<S: Real> Constraints for Oscillator<S> {}

impl<S: Real> Events for Oscillator<S> {
    type G = [S; 0];
}

impl<S: Real> Labels for Oscillator<S> {
    fn part_of_state(&self, index: usize) -> &'static str {
        ["oscillator", "oscillator", "filter"][index]
    }
}

impl<S: Real> Linear for Oscillator<S> {
    type Lifted<const K: usize> = Oscillator<Dual<S, K>>;
    type In<T: Real> = Oscillator<T>;
    type Derivatives = [[S; 3]; 3];

    fn lift<const K: usize>(&self, held: &f64) -> (Self::Lifted<K>, f64) {
        (oscillator(), *held)
    }

    fn in_numbers<T: Real>(&self, held: &f64, _number: impl Fn(S) -> T) -> (Oscillator<T>, f64) {
        (oscillator(), *held)
    }
}

impl<S: Real> Mechanism for Oscillator<S> {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: S) -> Result<(Self::U, [S; 3]), Fault> {
        Ok((0.0, exact(0.0).map(S::lit)))
    }
}

/// q = sin t - cos 2t, v, z = exp(-t^2).
pub fn exact(t: f64) -> [f64; 3] {
    [t.sin() - (2.0 * t).cos(), t.cos() + 2.0 * (2.0 * t).sin(), (-t * t).exp()]
}

pub fn oscillator<S: Real>() -> Oscillator<S> {
    Oscillator(core::marker::PhantomData)
}

/// Largest difference to the exact solution.
pub fn error(t: f64, x: &[f64; 3]) -> f64 {
    exact(t).iter().zip(x).fold(0.0, |worst, (a, b)| f64::max(worst, (a - b).abs()))
}
