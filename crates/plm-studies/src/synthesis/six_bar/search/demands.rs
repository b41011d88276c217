//! Demands on positions: least transmission angles, and the angles of a crank that is not the four-bar's.

use plm_runtime::{Dual, Real};

use super::{FIRST_ANGLE, Fit, Images, UNKNOWNS, variables};
use crate::synthesis::descent::{Lack, Place};
use crate::synthesis::path::Timing;
use crate::synthesis::six_bar::kernel::{Solved, Z};
use crate::synthesis::six_bar::problem::Task;

/// The bound of the transmission angle at the positions is higher by this fraction, since between them the angle may be less.
const BETWEEN: f64 = 0.01;

/// By how much the crank of a four-bar that moves is off at a position: the sine of the difference and what its cosine lacks, of which
/// one grows with it everywhere.
pub(super) fn off<S: Real>(unknowns: &[S; UNKNOWNS], pose: &Solved<S>, input: f64) -> [S; 2] {
    let off = pose.crank().times(Z::unit(-(unknowns[FIRST_ANGLE] + S::lit(input))));
    [off.im, S::lit(1.0) - off.re]
}

impl Fit<'_> {
    /// The angle of the crank at a position, if the task gives it.
    pub(super) fn input(&self, position: usize) -> Option<f64> {
        match &self.problem.task {
            Task::Function { pairs, .. } => pairs.get(position).map(|pair| pair.crank),
            Task::Path { timing: Timing::Given(angles) | Timing::Steps(angles), .. } => {
                angles.get(position).copied()
            }
            Task::Path { timing: Timing::Free, .. } => None,
        }
    }

    fn has_no_lacks(&self) -> bool {
        if self.moves() { self.input(0).is_none() } else { self.problem.transmission <= 0.0 }
    }

    /// Violations of the demands at a position: on the input of a four-bar that moves, or on the transmission angles.
    pub(super) fn demands<S: Real>(
        &self,
        unknowns: &[S; UNKNOWNS],
        images: Images,
        (position, angle): (usize, S),
    ) -> Option<[S; 2]> {
        if !self.moves() {
            return Some(self.excess(unknowns, images, angle)?.map(|excess| excess.max(S::ZERO)));
        }
        let pose = self.pose(unknowns, images, angle)?;
        Some(off(unknowns, &pose, self.input(position)?))
    }

    /// By how much the cosines of both transmission angles, which are those of the angles between bars of a dyad, are beyond that of the
    /// least one.
    fn excess<S: Real>(&self, unknowns: &[S; UNKNOWNS], images: Images, angle: S) -> Option<[S; 2]> {
        let limit = S::lit((self.problem.transmission * (1.0 + BETWEEN)).cos());
        Some(self.pose(unknowns, images, angle)?.cosines().map(|cosine| cosine.abs() - limit))
    }

    /// Demands on positions that are not met, with their derivatives.
    pub(super) fn lacks_at(&self, place: &Place<UNKNOWNS, Images>) -> Vec<Lack<UNKNOWNS>> {
        if self.has_no_lacks() {
            return Vec::new();
        }
        let unknowns = variables(&place.unknowns);
        let mut lacks = Vec::new();
        for (row, angle) in place.angles.iter().enumerate() {
            let Some(all) = self.demands(&unknowns, place.image, (row, Dual::variable(*angle, UNKNOWNS)))
            else {
                continue;
            };
            let open = all.into_iter().filter(|excess| excess.value != 0.0);
            lacks.extend(open.map(|excess| Lack {
                row,
                value: excess.value,
                by_unknowns: std::array::from_fn(|k| excess.tangents[k]),
                by_angle: excess.tangents[UNKNOWNS],
            }));
        }
        lacks
    }

    /// Sum of their squares.
    pub(super) fn lack_at(&self, place: &Place<UNKNOWNS, Images>) -> f64 {
        if self.has_no_lacks() {
            return 0.0;
        }
        let all = |(row, angle): (usize, &f64)| self.demands(&place.unknowns, place.image, (row, *angle));
        place.angles.iter().enumerate().filter_map(all).flatten().map(|lack| lack.powi(2)).sum()
    }
}
