//! Places as sums of vectors that are fixed in turning axes.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::Vec2;

/// `p = sum over c of R(theta_c) (d_c + sum over j of s_j e_cj)`.
///
/// `theta_c` are the angles of orientations of bodies that never turn against each other (orientation 0 is the ground, with angle
/// 0), `s_j` displacements, `d` and `e` constant vectors. The key of a vector is its orientation, and the unknown that it is
/// multiplied with if it is one along a displacement.
#[derive(Clone, Default)]
pub(crate) struct Chain {
    terms: SortedMap<(usize, Option<usize>), Vec2>,
}

impl Chain {
    /// Adds `sign * R(theta_orientation) vector`, times a displacement if one is given.
    pub(crate) fn add(
        &mut self,
        orientation: usize,
        displacement: Option<usize>,
        vector: Vec2,
        negative: bool,
    ) {
        let signed = if negative { -vector } else { vector };
        let key = (orientation, displacement);
        let sum = self.terms.get(&key).map_or(signed, |&old| old + signed);
        if sum.is_zero() {
            self.terms.remove(&key);
        } else {
            self.terms.insert(key, sum);
        }
    }

    /// The vectors: orientation, displacement, components in the axes of the orientation; ascending.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (usize, Option<usize>, Vec2)> {
        self.terms.iter().map(|(&(orientation, displacement), &vector)| (orientation, displacement, vector))
    }

    /// How many of its vectors move.
    pub(crate) fn moving(&self) -> usize {
        self.terms.keys().filter(|key| **key != (0, None)).count()
    }

    /// The orientations that it holds, ascending.
    pub(crate) fn orientations(&self) -> Vec<usize> {
        let mut orientations: Vec<usize> =
            self.terms.keys().map(|&(orientation, _)| orientation).collect_vec();
        orientations.dedup();
        orientations
    }

    /// The vectors of one orientation: displacement, components.
    pub(crate) fn of_orientation(&self, orientation: usize) -> impl Iterator<Item = (Option<usize>, Vec2)> {
        self.terms
            .iter()
            .filter(move |((own, _), _)| *own == orientation)
            .map(|(&(_, displacement), &vector)| (displacement, vector))
    }

    /// Orientation and vector of a displacement.
    pub(crate) fn displacement(&self, displacement: usize) -> Option<(usize, Vec2)> {
        self.terms()
            .find(|term| term.1 == Some(displacement))
            .map(|(orientation, _, vector)| (orientation, vector))
    }
}

/// Adds to how often a loop goes through a joint.
pub(crate) fn cross(crossed: &mut Vec<(usize, i32)>, joint: usize, times: i32) {
    match crossed.iter_mut().find(|(other, _)| *other == joint) {
        Some((_, sum)) => *sum += times,
        None => crossed.push((joint, times)),
    }
}
