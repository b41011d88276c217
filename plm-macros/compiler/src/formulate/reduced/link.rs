//! Dyads on one body by the products of vectors: how they move.
//!
//! One body, with the vector `a` from the loop's pivot of the ground to the dyad, moves the loop `a + g + p + r = 0`. All that
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
//! A slide along the ground in the direction `e` instead of the second angle is the same with `r = -J e`, but that this
//! vector does not turn: the terms with `w^2` are none.

use plm_cas::{Expr, algebra};

use super::chain::Chain;
use super::coordinates::Coordinates;
use super::dyad::{Dyad, Kind};
use super::motion::Motion;
use super::plane::{self, Vec2};

/// The body that moves a dyad.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    /// Its class.
    class: usize,
    /// `a` over the base of the class.
    arm: Vec2,
    /// Scalar and cross product of the base with the vector that the dyad's `p` is found from, `m` or `e`.
    known: Vec2,
}

/// The vectors of a dyad.
#[derive(Clone, Debug)]
pub(crate) struct Own {
    /// The class of `p`, of which it is the base.
    pub(crate) p: usize,
    /// Class and components over its base of `r`.
    pub(crate) r: (usize, Vec2),
    /// `p p`.
    pub(crate) pp: Expr,
    /// `p r`.
    pub(crate) pr: Expr,
    /// `r r`, if the second unknown is an angle.
    pub(crate) rr: Option<Expr>,
}

impl Link {
    /// Of a loop that is moved by one body, and in which nothing else slides or moves with the time.
    pub(crate) fn of(chain: &Chain, dyad: &Dyad, motion: &Motion, time: Expr) -> Option<Link> {
        let turns = dyad.classes();
        let mut known = chain.classes().into_iter().filter(|class| *class != 0 && !turns.contains(class));
        let (Some(class), None) = (known.next(), known.next()) else { return None };
        let vectors: Vec<Expr> = chain.terms().flat_map(|(_, _, vector)| vector).collect();
        let mut slides = chain.terms().filter_map(|(class, slide, _)| Some((class, slide?)));
        if slides.any(|slide| slide != (0, dyad.unknowns[1])) || algebra::symbols(&vectors).contains(&time) {
            return None;
        }
        let arm = motion.arm(chain, class, &[]);
        let (arm, unit) = (motion.over_base(class, arm), [Expr::ONE, Expr::ZERO]);
        let known = if let (Kind::Across { .. }, Some((_, e))) = (dyad.kind, chain.slide(dyad.unknowns[1])) {
            motion.products((class, unit), (0, e))
        } else {
            let ground = motion.arm(chain, 0, &[]);
            let with_arm = motion.products((class, unit), (class, arm));
            let with_ground = motion.products((class, unit), (0, ground));
            plane::add(with_arm, with_ground)
        };
        Some(Link { class, arm, known })
    }

    /// Tells `motion` the products of the body's vectors with the dyad's, from `P` and `Q` and the determinant.
    pub(crate) fn meet(
        &self,
        dyad: &Dyad,
        own: &Own,
        (ways, determinant): (Vec2, Expr),
        motion: &mut Motion,
    ) {
        let named = |products: Vec2, k: usize| {
            let names = ["dot", "cross"].map(|kind| format!("{kind}_{}_{k}", dyad.closure));
            [products[0].named(&names[0]), products[1].named(&names[1])]
        };
        let with_p = plane::turn(ways, self.known);
        let with_p = named(with_p, 0);
        motion.bases.insert_products((self.class, own.p), with_p);
        if own.rr.is_some() {
            let sum = plane::add(self.known, with_p);
            let sum = named(sum, 1);
            let with_r = plane::negated(sum);
            motion.bases.insert_products((self.class, own.r.0), with_r);
            motion.bases.insert_products((own.p, own.r.0), [own.pr, determinant]);
        }
    }

    /// Writes coefficients and rates of the dyad's unknowns into `motion`.
    pub(crate) fn differentiate(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        (dyad, own): (&Dyad, &Own),
        reciprocal: Expr,
    ) {
        let Some(body) = coordinates.angle_of_class[self.class] else { return };
        let (ratios, slopes) = self.ratios(motion, (dyad, own), reciprocal);
        let square = motion.turning[self.class].powi(2);
        for (k, &unknown) in dyad.unknowns.iter().enumerate() {
            for driver in 0..motion.drivers.len() {
                let gain = ratios[k] * motion.gain[body][driver];
                let name = format!("gain_{driver}_{}_{k}", dyad.closure);
                motion.gain[unknown][driver] = gain.named(&name);
            }
            motion.drift[unknown] = ratios[k] * motion.drift[body];
            let (turned, carried) = (square * slopes[k], ratios[k] * motion.bias[body]);
            let bias = turned + carried;
            motion.bias[unknown] = bias.named(format!("bias_{}_{k}", dyad.closure));
            motion.set_rate(coordinates, unknown);
        }
    }

    /// `u`, `w` and their derivatives.
    fn ratios(&self, motion: &Motion, (dyad, own): (&Dyad, &Own), reciprocal: Expr) -> (Vec2, Vec2) {
        let named = |values: Vec2, what: &str| {
            [0, 1].map(|k| {
                let value = values[k] * reciprocal;
                value.named(format!("{what}_{}_{k}", dyad.closure))
            })
        };
        let a = (self.class, self.arm);
        let unit = [Expr::ONE, Expr::ZERO];
        let with_p = motion.products(a, (own.p, unit));
        let with_r = motion.products(a, own.r);
        let ratios = named([-with_r[1], with_p[1]], "ratio");
        let squares = ratios.map(|ratio| ratio.powi(2));
        let by_w = own.rr.map_or([Expr::ZERO; 2], |rr| [rr, own.pr]);
        let inward = |first: Expr, by_u: Expr, by_w: Expr| {
            let terms = [first, squares[0] * by_u, squares[1] * by_w];
            algebra::sum(&terms)
        };
        let sums = [inward(with_r[0], own.pr, by_w[0]), inward(with_p[0], own.pp, by_w[1])];
        let slopes = named([sums[0], -sums[1]], "slope");
        (ratios, slopes)
    }
}
