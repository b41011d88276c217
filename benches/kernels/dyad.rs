//! The four-bar linkage as a formula: a crank, and the dyad of coupler and rocker that closes it.
//!
//! Vectors enter by products alone, which no frame changes. With the crank b (from its pivot to the coupler),
//! t = k x b its derivative, d from the coupler's joint to the rocker's pivot, the coupler e and the rocker
//! f = e - d, both to their common joint, the circles about the ends of d cut at
//!
//! ```text
//! e = p d + q k x d,   p = (d^2 + e^2 - f^2) / (2 d^2),   q = +- sqrt(4 e^2 d^2 - (d^2 + e^2 - f^2)^2) / (2 d^2)
//! ```
//!
//! (q > 0 has the common joint on the left of d). The loop `t + u k x e = w k x f` and its derivative give the ratios of
//! the angular velocities of coupler and rocker to the crank's,
//!
//! ```text
//! u = -(t f) / (e x f),   u' = -(g f) / (e x f),   g = -b - u^2 e + w^2 f,   e x f = q d^2
//! w = -(t e) / (e x f),   w' = -(g e) / (e x f)
//! ```

use super::lanes::Lanes;

/// The lengths of a dyad.
pub(crate) struct Dyad {
    /// Square of the coupler, m^2.
    pub(crate) ee: f64,
    /// Square of the rocker, m^2.
    pub(crate) ff: f64,
}

/// Where the circles cut: e = p d + q k x d.
#[derive(Clone, Copy)]
pub(crate) struct Cut<const N: usize> {
    pub(crate) p: Lanes<N>,
    pub(crate) q: Lanes<N>,
    /// -1 / (e x f).
    minus_inverse: Lanes<N>,
    /// The product e f.
    ef: Lanes<N>,
}

/// What moves with the crank, over its angular velocity, and the derivatives by its angle.
#[derive(Clone, Copy)]
pub(crate) struct Ratios<const N: usize> {
    /// Coupler.
    pub(crate) u: Lanes<N>,
    pub(crate) u_prime: Lanes<N>,
    /// Rocker.
    pub(crate) w: Lanes<N>,
    pub(crate) w_prime: Lanes<N>,
    /// The product b e: a point at `share` of the coupler has the square of velocity
    /// `b^2 + 2 share u be + share^2 u^2 e^2`.
    pub(crate) be: Lanes<N>,
    pub(crate) be_prime: Lanes<N>,
}

impl Dyad {
    /// Cuts the circles about the ends of d, on its left.
    #[inline(always)]
    pub(crate) fn cut<const N: usize>(&self, dd: Lanes<N>) -> Cut<N> {
        let sum = dd + (self.ee - self.ff);
        let root = sum.times_plus(-sum, dd * (4.0 * self.ee)).sqrt();
        let half_inverse = dd.under(0.5);
        Cut {
            p: sum * half_inverse,
            q: root * half_inverse,
            minus_inverse: root.under(-2.0),
            ef: dd.times_plus(-0.5, 0.5 * (self.ee + self.ff)),
        }
    }

    /// The ratios, from the scalar product `bd` and the vector product `cross` = d x b.
    #[inline(always)]
    pub(crate) fn ratios<const N: usize>(&self, cut: &Cut<N>, bd: Lanes<N>, cross: Lanes<N>) -> Ratios<N> {
        // b (k x d) = d x b = -t d, and t (k x d) = b d.
        let be = cut.p.times_plus(bd, cut.q * cross);
        let te = cut.q.times_plus(bd, -(cut.p * cross));
        let (bf, tf) = (be - bd, te + cross);
        let (u, w) = (tf * cut.minus_inverse, te * cut.minus_inverse);
        let (uu, ww) = (u * u, w * w);
        let gf = ww.times_plus(self.ff, -uu.times_plus(cut.ef, bf));
        let ge = ww.times_plus(cut.ef, -uu.times_plus(self.ee, be));
        Ratios {
            u,
            u_prime: gf * cut.minus_inverse,
            w,
            w_prime: ge * cut.minus_inverse,
            be,
            // (be)' = u (k x e) b + e t.
            be_prime: te.times_plus(-u, te),
        }
    }
}

impl<const N: usize> Cut<N> {
    /// The cut on the right of d.
    #[inline(always)]
    pub(crate) fn mirrored(self) -> Self {
        Self { q: -self.q, minus_inverse: -self.minus_inverse, ..self }
    }
}
