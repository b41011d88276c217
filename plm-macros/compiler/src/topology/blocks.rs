//! The order in which closures can be solved, and which of them must be solved together.
//!
//! A closure of two rows whose unknowns, but for those that are known or solved before, are two angles is the dyad RRR;
//! an angle and a displacement make RRP or RPR, two displacements PRP or RPP. Blocks of more are Newton's.
//!
//! Limits of structure; of the first two a numerical rank must judge:
//! * dimensions that make rows dependent (the third of parallel cranks is found only because its rows are too many for
//!   its unknowns; a redundant loop of another kind is not), and poses that do;
//! * that a group of loops which avoid the ground can turn as a whole: six bars that brace a square twice have as many
//!   rows as angles, yet one row is redundant and one turn is free;
//! * that a sum of two closures may hold fewer unknowns than either, so that a dyad hides in a block of two. Short
//!   loops make this rare: 2 of 10 000 random linkages of six dyads, none of fewer, 16 of eight.

use super::matching::Matching;
use super::strong::strongly_connected;
use crate::collect::CollectVec;

/// Scalar rows that hold the same unknowns: one row, or the two of a closure in the plane.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Equation {
    /// Its unknowns, ascending.
    pub(crate) unknowns: Vec<usize>,
    /// How many unknowns it can determine, 1 or 2.
    pub(crate) rows: usize,
}

/// Equations that must be solved together, with as many rows as unknowns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Block {
    /// Indices of the equations, ascending.
    pub(crate) equations: Vec<usize>,
    /// Unknowns that they determine, ascending.
    pub(crate) unknowns: Vec<usize>,
}

/// Why equations cannot be solved; one of the two is not empty.
#[cfg(test)]
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unsolved {
    /// Unknowns that stay undetermined, ascending.
    pub(crate) free: Vec<usize>,
    /// Equations with more rows, together, than unknowns that they can determine, ascending.
    pub(crate) excess: Vec<usize>,
}

/// Splits `equations` for the unknowns `0..n` without the `known` ones into the smallest blocks, in the order of
/// solution. This split is unique (A. L. Dulmage, N. S. Mendelsohn, Coverings of bipartite graphs, Canad. J. Math. 10,
/// 1958; A. Pothen, C.-J. Fan, Computing the block triangular form of a sparse matrix, ACM TOMS 16, 1990).
///
/// # Errors
/// Unknowns that stay free, or equations that are too many.
#[cfg(test)]
pub(crate) fn blocks(n: usize, equations: &[Equation], known: &[usize]) -> Result<Vec<Block>, Unsolved> {
    let split = System::new(n, equations).split(known);
    if split.free.is_empty() && split.excess.is_empty() {
        Ok(split.blocks)
    } else {
        Err(Unsolved { free: split.free, excess: split.excess })
    }
}

/// Equations, and where their unknowns stand.
pub(super) struct System<'a> {
    pub(super) equations: &'a [Equation],
    /// The equations that hold each unknown.
    pub(super) holders: Vec<Vec<usize>>,
}

/// The parts of a system.
pub(super) struct Split {
    /// The part with as many rows as unknowns.
    pub(super) blocks: Vec<Block>,
    /// The unknowns of the part with more unknowns than rows.
    pub(super) free: Vec<usize>,
    /// The equations of the part with more rows than unknowns.
    pub(super) excess: Vec<usize>,
}

impl<'a> System<'a> {
    pub(super) fn new(n: usize, equations: &'a [Equation]) -> System<'a> {
        let mut holders = vec![Vec::new(); n];
        for (k, equation) in equations.iter().enumerate() {
            for &unknown in &equation.unknowns {
                holders[unknown].push(k);
            }
        }
        System { equations, holders }
    }

    /// Splits the unknowns: solvable when `known` is given, free, and overdetermined.
    pub(super) fn split(&self, known: &[usize]) -> Split {
        let matching = Matching::new(self, known);
        let (free, under) = matching.undetermined();
        let over = matching.overdetermined();
        let solved = |equation: usize| !under[equation] && !over[equation];
        let next: Vec<Vec<usize>> = (0..self.equations.len())
            .map(|k| {
                if solved(k) {
                    matching.needs(k).filter(|&other| solved(other)).collect_vec()
                } else {
                    Vec::new()
                }
            })
            .collect_vec();
        let components = strongly_connected(&next).into_iter().filter(|component| solved(component[0]));
        let blocks =
            components.map(|equations| Block { unknowns: matching.solved_by(&equations), equations });
        let blocks = blocks.collect_vec();
        let excess = (0..self.equations.len()).filter(|&k| over[k]).collect_vec();
        Split { blocks, free, excess }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::super::scenes::{
        Random, andrews, double_butterfly, four_bar, grown, ladder, quadrorhomb, stephenson_iii, three_cranks,
    };
    use super::*;

    fn pair(unknowns: &[usize]) -> Equation {
        Equation { unknowns: unknowns.to_vec(), rows: 2 }
    }

    fn solved_in_turn(n: usize, equations: &[Equation], known: &[usize]) -> Vec<Vec<usize>> {
        blocks(n, equations, known).unwrap().into_iter().map(|block| block.unknowns).collect()
    }

    #[test]
    fn four_bar_from_each_of_its_bars() {
        let closures = four_bar().closures();
        for (coordinate, dyad) in [(0, [1, 2]), (1, [0, 2]), (2, [0, 1])] {
            assert_eq!(solved_in_turn(3, &closures, &[coordinate]), [dyad]);
        }
    }

    /// Angles of crank and rod, and the displacement.
    #[test]
    fn slider_crank_from_crank_or_displacement() {
        let closure = [pair(&[0, 1, 2])];
        assert_eq!(solved_in_turn(3, &closure, &[0]), [[1, 2]]);
        assert_eq!(solved_in_turn(3, &closure, &[2]), [[0, 1]]);
    }

    /// A jack: its length is a function of one angle, `rows` 1; then the four-bar follows.
    #[test]
    fn a_single_row_is_a_monad() {
        let equations = [pair(&[0, 1, 2]), Equation { unknowns: vec![0, 3], rows: 1 }];
        let found = blocks(4, &equations, &[3]).unwrap();
        assert_eq!(found[0], Block { equations: vec![1], unknowns: vec![0] });
        assert_eq!(found[1], Block { equations: vec![0], unknowns: vec![1, 2] });
    }

    #[test]
    fn andrews_is_three_dyads_from_the_crank() {
        assert_eq!(solved_in_turn(7, &andrews().closures(), &[0]), [[1, 2], [3, 4], [5, 6]]);
    }

    #[test]
    fn quadrorhomb_is_six_dyads_from_the_crank() {
        let found = solved_in_turn(13, &quadrorhomb().closures(), &[0]);
        assert_eq!(found, [[1, 3], [2, 4], [5, 6], [7, 8], [9, 10], [11, 12]]);
    }

    #[test]
    fn ladder_is_a_dyad_a_window_from_either_end() {
        let n = 40;
        for crank in [0, 40, 80] {
            let found = blocks(2 * n + 1, &ladder(n).closures(), &[crank]).unwrap();
            assert_eq!(found.len(), n);
            assert!(found.iter().all(|block| block.unknowns.len() == 2));
        }
    }

    /// Its three loops must be solved at once, whichever bar drives (the reference is at the linkage).
    #[test]
    fn double_butterfly_is_one_block() {
        for coordinate in 0..7 {
            let found = blocks(7, &double_butterfly().closures(), &[coordinate]).unwrap();
            assert_eq!(found.len(), 1);
            assert_eq!((found[0].equations.len(), found[0].unknowns.len()), (3, 6));
        }
    }

    #[test]
    fn stephenson_iii_splits_from_its_four_bar_alone() {
        let closures = stephenson_iii().closures();
        assert_eq!(solved_in_turn(5, &closures, &[0]), [[1, 2], [3, 4]]);
        assert_eq!(solved_in_turn(5, &closures, &[4]), [[0, 1, 2, 3]]);
    }

    #[test]
    fn linkages_grown_by_up_to_five_dyads_split_into_them() {
        let mut random = Random(4);
        for linkage in (0..600).map(|k| grown(1 + k % 5, &mut random)) {
            let found = blocks(linkage.bodies, &linkage.closures(), &[0]).unwrap();
            assert!(found.iter().all(|block| block.unknowns.len() == 2), "{:?}", linkage.pins);
        }
    }

    #[test]
    fn two_mechanisms_share_no_block() {
        let both = [pair(&[0, 1, 2]), pair(&[3, 4, 5])];
        assert_eq!(solved_in_turn(6, &both, &[0, 5]), [[1, 2], [3, 4]]);
        let unsolved = Unsolved { free: vec![3, 4, 5], excess: vec![0] };
        assert_eq!(blocks(6, &both, &[0, 2]), Err(unsolved));
    }

    /// Four rows hold four angles, so that no coordinate is left, although parallel cranks of one length turn.
    #[test]
    fn third_crank_is_one_row_too_many() {
        let mut closures = three_cranks().closures();
        assert_eq!(blocks(4, &closures, &[0]), Err(Unsolved { free: vec![], excess: vec![0, 1] }));
        assert!(blocks(4, &closures, &[]).is_ok(), "structure alone takes it for a truss");
        closures[1].rows = 1;
        assert_eq!(solved_in_turn(4, &closures, &[0]).concat().len(), 3);
    }

    /// Six bars brace a square twice: one row is redundant, and the square still turns; structure sees neither.
    #[test]
    fn a_braced_square_looks_determined() {
        let closures = [pair(&[0, 1, 4]), pair(&[2, 3, 4]), pair(&[0, 3, 5])];
        assert!(blocks(6, &closures, &[]).is_ok());
    }

    #[test]
    fn what_no_equation_holds_is_free() {
        assert_eq!(blocks(2, &[], &[0]), Err(Unsolved { free: vec![1], excess: vec![] }));
        assert_eq!(blocks(1, &[], &[0]), Ok(vec![]));
    }

    const PRIME: u64 = 2_147_483_647;

    /// The rank over the integers modulo a prime.
    fn rank(mut rows: Vec<Vec<u64>>) -> usize {
        let mut rank = 0;
        for column in 0..rows.first().map_or(0, Vec::len) {
            let Some(found) = (rank..rows.len()).find(|&k| rows[k][column] != 0) else { continue };
            rows.swap(rank, found);
            let pivot = rows[rank].clone();
            for row in &mut rows[rank + 1..] {
                let factor = row[column];
                for (entry, &p) in row.iter_mut().zip(&pivot) {
                    *entry = (*entry * pivot[column] + (PRIME - factor) * p % PRIME) % PRIME;
                }
            }
            rank += 1;
        }
        rank
    }

    fn without(rows: &[Vec<u64>], row: Option<usize>, column: Option<usize>) -> Vec<Vec<u64>> {
        let rows = rows.iter().enumerate().filter(|&(k, _)| Some(k) != row).map(|(_, row)| row);
        let kept = |row: &Vec<u64>| {
            row.iter().enumerate().filter(|&(k, _)| Some(k) != column).map(|(_, &e)| e).collect()
        };
        rows.map(kept).collect()
    }

    /// With random coefficients, an unknown is free if its column adds nothing to the rank, and an equation in excess
    /// if its row does not; in a block every unknown depends on every row, and on no later block.
    #[test]
    fn random_systems_split_as_the_rank_says() {
        let mut random = Random(3);
        let mut full = 0;
        for _ in 0..2000 {
            let n = 2 + random.below(7);
            let mut left = n + random.below(3) - 1;
            let mut equations = Vec::new();
            while left > 0 {
                let rows = left.min(1 + random.below(2));
                left -= rows;
                equations
                    .push(Equation { unknowns: (0..n).filter(|_| random.below(2) == 0).collect(), rows });
            }
            let row_of: Vec<usize> = (0..equations.len()).flat_map(|k| vec![k; equations[k].rows]).collect();
            let mut entry = |k: usize, u: usize| {
                let held = equations[k].unknowns.contains(&u);
                if held { 1 + random.below(1 << 30) as u64 } else { 0 }
            };
            let matrix: Vec<Vec<u64>> =
                row_of.iter().map(|&k| (0..n).map(|u| entry(k, u)).collect()).collect();
            let all = rank(matrix.clone());
            let free: Vec<usize> = (0..n).filter(|&u| rank(without(&matrix, None, Some(u))) == all).collect();
            let mut excess: Vec<usize> = (0..row_of.len())
                .filter(|&row| rank(without(&matrix, Some(row), None)) == all)
                .map(|row| row_of[row])
                .collect();
            excess.dedup();
            match blocks(n, &equations, &[]) {
                Err(unsolved) => assert_eq!(unsolved, Unsolved { free, excess }, "{equations:?}"),
                Ok(found) => {
                    assert!(free.is_empty() && excess.is_empty());
                    full += 1;
                    check_blocks(&found, &equations, &row_of, &matrix);
                }
            }
        }
        assert!(full > 300, "only {full} systems could be solved");
    }

    fn check_blocks(found: &[Block], equations: &[Equation], row_of: &[usize], matrix: &[Vec<u64>]) {
        let mut known: Vec<usize> = Vec::new();
        for block in found {
            known.extend(&block.unknowns);
            let held = block.equations.iter().flat_map(|&k| &equations[k].unknowns);
            assert!(held.into_iter().all(|unknown| known.contains(unknown)));
            let rows = (0..row_of.len()).filter(|&row| block.equations.contains(&row_of[row]));
            let part: Vec<Vec<u64>> = rows
                .map(|row| block.unknowns.iter().map(|&unknown| matrix[row][unknown]).collect())
                .collect();
            for (row, column) in (0..part.len() * part.len()).map(|k| (k / part.len(), k % part.len())) {
                assert_eq!(rank(without(&part, Some(row), Some(column))), part.len() - 1);
            }
        }
        assert_eq!(known.len(), matrix[0].len());
    }
}
