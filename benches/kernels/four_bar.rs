//! S2: the four-bar linkage in its crank angle.
//!
//! Reduced mass `m = J_crank + m_e (b^2 + u be) + (J_e + m_e e^2 / 4) u^2 + J_f w^2` with the ratios of [`super::dyad`];
//! the force is gravity on the three middles.

use super::crank::Crank;
use super::dyad::Dyad;
use super::lanes::Lanes;

pub(crate) struct FourBar;

const CRANK: f64 = 0.3;
const COUPLER: f64 = 0.9;
const ROCKER: f64 = 0.7;
const GROUND: f64 = 1.0;
const DYAD: Dyad = Dyad { ee: COUPLER * COUPLER, ff: ROCKER * ROCKER };

/// A bar has 1 kg/m, and about its end the moment of inertia length^3 / 3.
const CONSTANT: f64 = CRANK * CRANK * CRANK / 3.0 + COUPLER * CRANK * CRANK;
const COUPLER_INERTIA: f64 = COUPLER * COUPLER * COUPLER / 3.0;
const ROCKER_INERTIA: f64 = ROCKER * ROCKER * ROCKER / 3.0;

/// Moments of gravity per metre of horizontal distance: crank and coupler on the crank, coupler, rocker.
const CRANK_WEIGHT: f64 = -9.81 * (0.5 * CRANK + COUPLER);
const COUPLER_WEIGHT: f64 = -9.81 * 0.5 * COUPLER;
const ROCKER_WEIGHT: f64 = -9.81 * 0.5 * ROCKER;

impl Crank for FourBar {
    #[inline(always)]
    fn coefficients<const N: usize>(q: Lanes<N>) -> (Lanes<N>, Lanes<N>) {
        let (s, c) = q.sin_cos();
        // b = CRANK (c, s), d = (GROUND, 0) - b.
        let dd = c.times_plus(-2.0 * GROUND * CRANK, GROUND * GROUND + CRANK * CRANK);
        let bd = c.times_plus(GROUND * CRANK, -CRANK * CRANK);
        let cross = s * (GROUND * CRANK);
        let cut = DYAD.cut(dd);
        let r = DYAD.ratios(&cut, bd, cross);

        let mass = (r.w * ROCKER_INERTIA).times_plus(r.w, CONSTANT);
        let coupler = r.u.times_plus(COUPLER_INERTIA, r.be * COUPLER);
        let mass = coupler.times_plus(r.u, mass);
        // Half of its derivative.
        let by_u = r.u.times_plus(COUPLER_INERTIA, r.be * (0.5 * COUPLER));
        let half_mass_prime = (r.w * ROCKER_INERTIA).times_plus(r.w_prime, by_u * r.u_prime);
        let half_mass_prime = (r.be_prime * (0.5 * COUPLER)).times_plus(r.u, half_mass_prime);

        let dx = c.times_plus(-CRANK, GROUND);
        let ex = cut.p.times_plus(dx, cut.q * (s * CRANK));
        let crank_and_coupler = (r.u * COUPLER_WEIGHT).times_plus(ex, c * (CRANK * CRANK_WEIGHT));
        let force = (r.w * ROCKER_WEIGHT).times_plus(ex - dx, crank_and_coupler);

        let inverse = mass.under(1.0);
        (force * inverse, -(half_mass_prime * inverse))
    }
}
