//! Dyads on one body by the products of vectors: how they move.
//!
//! One body, the crank, with the vector `a` from the loop's pivot of the ground to the dyad, moves the loop `a + g + p + r = 0`. All that
//! velocities and accelerations need are the scalar and the cross products of `a` with `p` and `r`, and of these with each
//! other. With the dyad's `p = P m + Q J m`, `m = a + g`, the former follow from those of `a` with `m`. The rates of the
//! dyad's angles over that of `a`, and the derivatives of these ratios (J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of
//! Machines and Mechanisms, 4th ed., 2011, chapters 3 and 4: kinematic coefficients) are
//!
//! ```text
//! u = (r x a) / D,    u' = (a r + u^2 p r + w^2 r r) / D
//! w = (a x p) / D,    w' = -(a p + u^2 p p + w^2 p r) / D
//! ```
//!
//! A displacement along the ground in the direction `e` instead of the second angle is the same with `r = -J e`, but that this
//! vector does not turn: the terms with `w^2` are none.

use crate::collect::CollectVec;
use plm_cas::{Expr, Rotation, Vec2, algebra};

use crate::formulate::reduced::groups::dyad::{Dyad, Kind};
use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::bases::Products;

/// The crank: the one body that moves a dyad.
#[derive(Clone)]
pub(crate) struct Crank {
    /// Its orientation.
    orientation: usize,
    /// `a` over the base of the orientation.
    arm: Vec2,
    /// Scalar and cross product of the base with the vector that the dyad's `p` is found from, `m` or `e`.
    known: Products,
}

/// The vectors of a dyad.
#[derive(Clone)]
pub(crate) struct DyadVectors {
    /// The orientation of `p`, of which it is the base.
    pub(crate) p: usize,
    /// Orientation and components over its base of `r`.
    pub(crate) r: (usize, Vec2),
    /// `p p`.
    pub(crate) pp: Expr,
    /// `p r`.
    pub(crate) pr: Expr,
    /// `r r`, if the second unknown is an angle.
    pub(crate) rr: Option<Expr>,
}

impl Crank {
    /// Of a loop that is moved by one body, and in which nothing else slides or moves with the time.
    pub(crate) fn of(chain: &Chain, dyad: &Dyad, motion: &Motion) -> Option<Crank> {
        let turns = dyad.orientations();
        let mut known = chain
            .orientations()
            .into_iter()
            .filter(|orientation| *orientation != 0 && !turns.contains(orientation));
        let (Some(orientation), None) = (known.next(), known.next()) else { return None };
        let vectors: Vec<Expr> = chain.terms().flat_map(|(_, _, vector)| vector.components()).collect_vec();
        let mut displacements =
            chain.terms().filter_map(|(orientation, displacement, _)| Some((orientation, displacement?)));
        if displacements.any(|displacement| displacement != (0, dyad.unknowns[1]))
            || algebra::symbols(&vectors).contains(&motion.time)
        {
            return None;
        }
        let arm = motion.over_base(orientation, motion.arm(chain, orientation, &[]));
        let base = (orientation, Vec2::X);
        let known =
            if let (Kind::Across { .. }, Some((_, e))) = (dyad.kind, chain.displacement(dyad.unknowns[1])) {
                motion.products(base, (0, e))
            } else {
                let ground = motion.arm(chain, 0, &[]);
                motion.products(base, (orientation, arm)) + motion.products(base, (0, ground))
            };
        Some(Crank { orientation, arm, known })
    }

    /// Tells `motion` the products of the body's vectors with the dyad's, from `P` and `Q` and the determinant.
    pub(crate) fn meet(
        &self,
        dyad: &Dyad,
        own: &DyadVectors,
        (ways, determinant): (Rotation, Expr),
        motion: &mut Motion,
    ) {
        let named = |products: Products, k: usize| products.named(&format!("{}_{k}", dyad.closure));
        let with_p = named(self.known.turned(ways), 0);
        motion.bases.insert_products((self.orientation, own.p), with_p);
        if own.rr.is_some() {
            // `r = -(m + p)`.
            let with_r = -named(self.known + with_p, 1);
            motion.bases.insert_products((self.orientation, own.r.0), with_r);
            motion.bases.insert_products((own.p, own.r.0), Products { dot: own.pr, cross: determinant });
        }
    }

    /// Writes coefficients and rates of the dyad's unknowns into `motion`.
    pub(crate) fn differentiate(
        &self,
        motion: &mut Motion,
        (dyad, own): (&Dyad, &DyadVectors),
        reciprocal: Expr,
    ) {
        let coordinates = motion.coordinates;
        let Some(body) = coordinates.angle_of_orientation[self.orientation] else { return };
        let (ratios, slopes) = self.ratios(motion, (dyad, own), reciprocal);
        let square = motion.turning[self.orientation].squared();
        for (k, (&unknown, (ratio, slope))) in
            dyad.unknowns.iter().zip(ratios.into_iter().zip(slopes)).enumerate()
        {
            for coordinate in 0..motion.independent.len() {
                let coefficient = ratio * motion.coefficient[body][coordinate];
                motion.coefficient[unknown][coordinate] =
                    coefficient.named(format!("coefficient_{coordinate}_{}_{k}", dyad.closure));
            }
            motion.time_rate[unknown] = ratio * motion.time_rate[body];
            let bias = square * slope + ratio * motion.bias[body];
            motion.bias[unknown] = bias.named(format!("bias_{}_{k}", dyad.closure));
            motion.set_rate(unknown);
        }
    }

    /// `u`, `w` and their derivatives.
    fn ratios(
        &self,
        motion: &Motion,
        (dyad, own): (&Dyad, &DyadVectors),
        reciprocal: Expr,
    ) -> ([Expr; 2], [Expr; 2]) {
        let over_determinant = |values: [Expr; 2], what: &str| {
            let [first, second] = values;
            let first = (first * reciprocal).named(format!("{what}_{}_0", dyad.closure));
            [first, (second * reciprocal).named(format!("{what}_{}_1", dyad.closure))]
        };
        let a = (self.orientation, self.arm);
        let ap = motion.products(a, (own.p, Vec2::X));
        let ar = motion.products(a, own.r);
        let [u, w] = over_determinant([-ar.cross, ap.cross], "ratio");
        let (uu, ww) = (u.squared(), w.squared());
        let DyadVectors { pp, pr, .. } = *own;
        // A displacement along the ground does not turn.
        let (rr, rp) = own.rr.map_or((Expr::ZERO, Expr::ZERO), |rr| (rr, pr));
        let inward = [ar.dot + uu * pr + ww * rr, ap.dot + uu * pp + ww * rp];
        ([u, w], over_determinant([inward[0], -inward[1]], "slope"))
    }
}
