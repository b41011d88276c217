//! S6: the slider-crank in its crank angle.
//!
//! Crank r = 0.2 m, rod l = 3 r, slider on y = 0. The rod's angle psi obeys `sin psi = -sin(q) / 3`; with y = dpsi/dq,
//! C = cos psi and (s, c) of the crank angle
//!
//! ```text
//! y  = -c / (3 C),                                 y' = s (1 - y^2) / (3 C)
//! rod's centre:  (-r s (1 - y/2), r c / 2) v       slider:  -r s (1 - y) v
//! m  = k + s^2 P(y) + 0.018 y^2,                   P = 0.026 y^2 - 0.064 y + 0.038
//! ```
//!
//! where P holds the masses 0.6 kg and 0.5 kg, k the crank and the rod's rise with c^2 = 1 - s^2.

use super::crank::Crank;
use super::lanes::Lanes;

pub(crate) struct SliderCrank;

/// The crank about its pivot, and 0.6 kg r^2 / 4.
const CONSTANT: f64 = 0.2 * 0.2 * 0.2 / 3.0 + 0.006;
/// Moment of gravity on the crank per cosine: crank and rod both have their centres at r s / 2.
const GRAVITY: f64 = -9.81 * (0.2 + 0.6) * 0.1;
const TORQUE: f64 = 1.0;

impl Crank for SliderCrank {
    #[inline(always)]
    fn coefficients<const N: usize>(q: Lanes<N>) -> (Lanes<N>, Lanes<N>) {
        let (s, c) = q.sin_cos();
        let ss = s * s;
        let third_over_cos = ss.times_plus(-1.0 / 9.0, 1.0).sqrt().under(1.0 / 3.0);
        let y = -(c * third_over_cos);
        let yy = y * y;
        let y_prime = (s * third_over_cos) * (-yy + 1.0);

        let p_half_prime = y.times_plus(0.026, -0.032);
        let p = (p_half_prime - 0.032).times_plus(y, 0.038);
        let mass = ss.times_plus(p, yy.times_plus(0.018, CONSTANT));
        let by_y = ss.times_plus(p_half_prime, y * 0.018);
        let half_mass_prime = (s * c).times_plus(p, by_y * y_prime);

        let force = c.times_plus(GRAVITY, TORQUE);
        let inverse = mass.under(1.0);
        (force * inverse, -(half_mass_prime * inverse))
    }
}
