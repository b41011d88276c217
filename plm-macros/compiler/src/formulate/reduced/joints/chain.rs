//! Places as sums of vectors that are fixed in turning axes.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::Vec2;

/// `p = sum over c of R(theta_c) (d_c + sum over j of s_j e_cj)`.
///
/// `theta_c` are the angles of classes of bodies that never turn against each other (class 0 is the ground, with angle
/// 0), `s_j` slides, `d` and `e` constant vectors. The key of a vector is its class, and the unknown that it is
/// multiplied with if it is one along a slide.
#[derive(Clone, Default)]
pub(crate) struct Chain {
    terms: SortedMap<(usize, Option<usize>), Vec2>,
}

impl Chain {
    /// Adds `sign * R(theta_class) vector`, times a slide if one is given.
    pub(crate) fn add(&mut self, class: usize, slide: Option<usize>, vector: Vec2, negative: bool) {
        let signed = if negative { -vector } else { vector };
        let key = (class, slide);
        let sum = self.terms.get(&key).map_or(signed, |&old| old + signed);
        if sum.is_zero() {
            self.terms.remove(&key);
        } else {
            self.terms.insert(key, sum);
        }
    }

    /// The vectors: class, slide, components in the axes of the class; ascending.
    pub(crate) fn terms(&self) -> impl Iterator<Item = (usize, Option<usize>, Vec2)> {
        self.terms.iter().map(|(&(class, slide), &vector)| (class, slide, vector))
    }

    /// How many of its vectors move.
    pub(crate) fn moving(&self) -> usize {
        self.terms.keys().filter(|key| **key != (0, None)).count()
    }

    /// The classes that it holds, ascending.
    pub(crate) fn classes(&self) -> Vec<usize> {
        let mut classes: Vec<usize> = self.terms.keys().map(|&(class, _)| class).collect_vec();
        classes.dedup();
        classes
    }

    /// The vectors of one class: slide, components.
    pub(crate) fn of_class(&self, class: usize) -> impl Iterator<Item = (Option<usize>, Vec2)> {
        self.terms
            .iter()
            .filter(move |((own, _), _)| *own == class)
            .map(|(&(_, slide), &vector)| (slide, vector))
    }

    /// Class and vector of a slide.
    pub(crate) fn slide(&self, slide: usize) -> Option<(usize, Vec2)> {
        self.terms().find(|term| term.1 == Some(slide)).map(|(class, _, vector)| (class, vector))
    }
}
