//! Which unknowns of a sparse linear system depend on which of its equations, by structure alone.
//!
//! Each unknown is matched to an equation that determines it. It depends on this equation, and on whatever the other
//! unknowns of the equation depend on. For a system with a perfect matching these are the entries of the inverse that are
//! not zero for almost all values (J. R. Gilbert, Predicting structure in sparse matrix computations, SIAM J. Matrix Anal.
//! Appl. 15, 1994, theorem 5.1).

use super::blocks::{Equation, System};
use super::matching::Matching;
use crate::collect::{CollectVec, PushAll};

/// Dependence of unknowns on some equations.
pub(crate) struct Influence {
    /// By source, whether each unknown depends on it.
    reached: Vec<Vec<bool>>,
}

impl Influence {
    /// Dependence of the unknowns `0..n` on `sources`, each a list of equations. Unknowns that no equation determines depend on all
    /// of them, and so do those that need such an unknown.
    pub(crate) fn new(n: usize, equations: &[Equation], sources: &[Vec<usize>]) -> Influence {
        let system = System::new(n, equations);
        let matching = Matching::new(&system, &[]);
        let (undetermined, _) = matching.undetermined();
        let reached = |source: &Vec<usize>| {
            let mut reached = vec![false; n];
            let mut open: Vec<usize> = undetermined.clone();
            open.push_all(
                source.iter().filter_map(|&equation| matching.solved_by(&[equation]).first().copied()),
            );
            while let Some(unknown) = open.pop() {
                if std::mem::replace(&mut reached[unknown], true) {
                    continue;
                }
                let holders = &system.holders[unknown];
                open.push_all(holders.iter().flat_map(|&equation| matching.solved_by(&[equation])));
            }
            reached
        };
        Influence { reached: sources.iter().map(reached).collect_vec() }
    }

    /// The sources that an unknown depends on, ascending.
    pub(crate) fn sources(&self, unknown: usize) -> impl Iterator<Item = usize> {
        let reached = self.reached.iter().enumerate();
        reached.filter(move |(_, reached)| reached[unknown]).map(|(source, _)| source)
    }
}

/// The largest rank that a matrix of this structure has, each equation a row.
pub(crate) fn structural_rank(n: usize, equations: &[Equation]) -> usize {
    let system = System::new(n, equations);
    let matching = Matching::new(&system, &[]);
    matching.solved_by(&(0..equations.len()).collect_vec()).len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(rows: &[&[usize]]) -> Vec<Equation> {
        rows.iter().map(|unknowns| Equation { unknowns: unknowns.to_vec(), rows: 1 }).collect()
    }

    #[test]
    fn a_triangle_is_solved_from_its_tip() {
        let triangle = rows(&[&[0], &[0, 1], &[1, 2]]);
        let influence = Influence::new(3, &triangle, &[vec![0], vec![1], vec![2]]);
        let sources = |unknown| influence.sources(unknown).collect::<Vec<_>>();
        assert_eq!([sources(0), sources(1), sources(2)], [vec![0], vec![0, 1], vec![0, 1, 2]]);
    }

    #[test]
    fn what_is_solved_together_depends_on_all_of_it() {
        let influence = Influence::new(3, &rows(&[&[0, 1], &[0, 1], &[2]]), &[vec![1]]);
        let sources = |unknown| influence.sources(unknown).count();
        assert_eq!([sources(0), sources(1), sources(2)], [1, 1, 0]);
    }

    #[test]
    fn an_undetermined_unknown_depends_on_everything() {
        let wide = rows(&[&[0, 1], &[2]]);
        let influence = Influence::new(3, &wide, &[vec![1]]);
        let sources = |unknown| influence.sources(unknown).count();
        assert_eq!([sources(0), sources(1), sources(2)], [1, 1, 1]);
        assert_eq!(structural_rank(3, &wide), 2);
    }
}
