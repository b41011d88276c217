//! S5: Andrews' squeezing mechanism in its crank angle (W. Schiehlen, Multibody Systems Handbook, 1990).
//!
//! Three four-bars ([`super::dyad`]): the crank K1 drives K3 through K2; K3, as a crank, drives K5 through K4 and K7
//! through K6. The last two have the same lengths and pivots: they are cut once, on both sides of the same line. What
//! hangs on K3 has a reduced mass M and a force by K3's angle, and so the whole has
//! `m = K1 + m2 (b^2 + 2 share u be) + I2 u^2 + (J3 + M) w^2`.

use super::crank::Crank;
use super::dyad::Dyad;
use super::lanes::Lanes;

pub(crate) struct Andrews;

/// Crank and the pivots of K3 and of K5 with K7; the crank's own is the origin.
const CRANK: f64 = 0.007;
const B: [f64; 2] = [-0.03635, 0.03273];
const C: [f64; 2] = [-0.06934, -0.00227];
/// K2 from the crank and K3 from its pivot, to their common joint.
const ROD: f64 = 0.028;
const K3: f64 = 0.035;
const FIRST: Dyad = Dyad { ee: ROD * ROD, ff: K3 * K3 };
/// K4 or K6, and K5 or K7.
const COUPLER: f64 = 0.02;
const SECOND: Dyad = Dyad { ee: COUPLER * COUPLER, ff: 0.04 * 0.04 };

/// K1 about its pivot, with K2's mass at its pin.
const CONSTANT: f64 = 2.194e-6 + 0.04325 * 0.00092 * 0.00092 + 0.00365 * CRANK * CRANK;
/// K2 about the crank's pin, and its static moment over its length.
const K2_INERTIA: f64 = 4.41e-7 + 0.00365 * 0.0115 * 0.0115;
const K2_MOMENT: f64 = 0.00365 * 0.0115 / ROD;
/// K3 about its pivot, with the masses of K4 and K6 at its pin.
const K3_INERTIA: f64 =
    5.255e-6 + 0.02373 * (0.01043 * 0.01043 + 0.01874 * 0.01874) + 2.0 * 0.00706 * K3 * K3;
/// K4, or K6, about the common joint; its static moment over its length.
const COUPLER_INERTIA: f64 = 5.667e-7 + 0.00706 * 0.01421 * 0.01421;
const COUPLER_MOMENT: f64 = 0.00706 * 0.01421 / COUPLER;
/// K5 and K7 about their pivot.
const K5_INERTIA: f64 = 1.169e-5 + 0.0705 * (0.02308 * 0.02308 + 0.00916 * 0.00916);
const K7_INERTIA: f64 = 1.912e-5 + 0.05498 * (0.01228 * 0.01228 + 0.00449 * 0.00449);

const TORQUE: f64 = 0.033;
/// The spring: from a fixed point D to the point h = ALONG f + ACROSS k x f of K3, f from its pivot to its pin.
const STIFFNESS: f64 = 4530.0;
const FREE_LENGTH: f64 = 0.07785;
const D_TO_B: [f64; 2] = [B[0] - 0.014, B[1] - 0.072];
const ALONG: f64 = (0.01874 - 0.00074) / K3;
const ACROSS: f64 = (0.01043 + 0.00957) / K3;

impl Crank for Andrews {
    #[inline(always)]
    fn coefficients<const N: usize>(q: Lanes<N>) -> (Lanes<N>, Lanes<N>) {
        let (s, c) = q.sin_cos();
        let to_b = dot([c, s], [CRANK * B[0], CRANK * B[1]]);
        let cross = dot([c, s], [-CRANK * B[1], CRANK * B[0]]);
        let dd = to_b.times_plus(-2.0, B[0] * B[0] + B[1] * B[1] + CRANK * CRANK);
        let cut = FIRST.cut(dd);
        let r = FIRST.ratios(&cut, to_b - CRANK * CRANK, cross);

        // f = e - d = (p - 1) d + q k x d.
        let (dx, dy) = (c.times_plus(-CRANK, B[0]), s.times_plus(-CRANK, B[1]));
        let along = cut.p - 1.0;
        let fx = along.times_plus(dx, -(cut.q * dy));
        let fy = along.times_plus(dy, cut.q * dx);
        let k3 = k3(fx, fy);

        let mass = (r.w * k3.mass).times_plus(r.w, CONSTANT);
        let by_u = r.u.times_plus(K2_INERTIA, r.be * K2_MOMENT);
        let mass = r.be.times_plus(K2_MOMENT, by_u).times_plus(r.u, mass);
        // Half of its derivative: by u, by be, by w, and by K3's angle.
        let by_w = r.w_prime.times_plus(k3.mass, (r.w * r.w) * k3.half_mass_prime);
        let by_pose = (r.be_prime * K2_MOMENT).times_plus(r.u, by_w * r.w);
        let half_mass_prime = by_u.times_plus(r.u_prime, by_pose);

        let inverse = mass.under(1.0);
        (k3.force.times_plus(r.w, TORQUE) * inverse, -(half_mass_prime * inverse))
    }
}

/// K3 with what hangs on it, in its own angle.
struct Reduced<const N: usize> {
    mass: Lanes<N>,
    half_mass_prime: Lanes<N>,
    force: Lanes<N>,
}

#[inline(always)]
fn k3<const N: usize>(fx: Lanes<N>, fy: Lanes<N>) -> Reduced<N> {
    const BC: [f64; 2] = [C[0] - B[0], C[1] - B[1]];
    let to_c = dot([fx, fy], BC);
    let cross = dot([fx, fy], [-BC[1], BC[0]]);
    let dd = to_c.times_plus(-2.0, BC[0] * BC[0] + BC[1] * BC[1] + K3 * K3);
    let (cut, bd) = (SECOND.cut(dd), to_c - K3 * K3);
    let six = SECOND.ratios(&cut, bd, cross);
    let four = SECOND.ratios(&cut.mirrored(), bd, cross);

    let (mut mass, mut half_mass_prime) = (Lanes::from(K3_INERTIA), Lanes::from(0.0));
    for (r, rocker) in [(four, K5_INERTIA), (six, K7_INERTIA)] {
        let by_u = r.u.times_plus(COUPLER_INERTIA, r.be * COUPLER_MOMENT);
        mass = r.be.times_plus(COUPLER_MOMENT, by_u).times_plus(r.u, mass);
        mass = (r.w * rocker).times_plus(r.w, mass);
        half_mass_prime = by_u.times_plus(r.u_prime, half_mass_prime);
        half_mass_prime = (r.be_prime * COUPLER_MOMENT).times_plus(r.u, half_mass_prime);
        half_mass_prime = (r.w * rocker).times_plus(r.w_prime, half_mass_prime);
    }
    Reduced { mass, half_mass_prime, force: spring(fx, fy) }
}

/// The spring's moment on K3: with g from D to B, its length squared is `g^2 + 2 g h + h^2`, of which half the
/// derivative is `g (k x h)`.
#[inline(always)]
fn spring<const N: usize>(fx: Lanes<N>, fy: Lanes<N>) -> Lanes<N> {
    const G: [f64; 2] = D_TO_B;
    // g h is the product of f with this vector, g (k x h) that with the vector turned clockwise.
    const GH: [f64; 2] = [G[0] * ALONG + G[1] * ACROSS, G[1] * ALONG - G[0] * ACROSS];
    const SQUARES: f64 = G[0] * G[0] + G[1] * G[1] + (ALONG * ALONG + ACROSS * ACROSS) * K3 * K3;
    let length = dot([fx, fy], [2.0 * GH[0], 2.0 * GH[1]]) + SQUARES;
    // The force over the length.
    let pull = length.sqrt().under(STIFFNESS * FREE_LENGTH) - STIFFNESS;
    pull * dot([fx, fy], [GH[1], -GH[0]])
}

/// The product with a constant vector.
#[inline(always)]
fn dot<const N: usize>([x, y]: [Lanes<N>; 2], [a, b]: [f64; 2]) -> Lanes<N> {
    x.times_plus(a, y * b)
}
