//! Order conditions, one for each rooted tree (Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I, II.2).

extern crate std;

use std::vec::Vec;

use super::tableau::*;

/// The times of the stages, as fractions of the step; the seventeenth is its end.
const C: [f64; 22] =
    [0.0, 0.0, C2, C3, C4, C5, C6, C7, C8, C9, C10, C11, C12, C13, C14, 1.0, 1.0, 1.0, C18, C19, C20, C21];

/// A stage, its row, and the stages of the row.
type Row = (usize, &'static [f64], &'static [usize]);

const ROWS: [Row; 20] = [
    (2, &A2, &[1]),
    (3, &A3, &[1, 2]),
    (4, &A4, &[1, 3]),
    (5, &A5, &[1, 3, 4]),
    (6, &A6, &[1, 4, 5]),
    (7, &A7, &[1, 4, 5, 6]),
    (8, &A8, &[1, 6, 7]),
    (9, &A9, &[1, 6, 7, 8]),
    (10, &A10, &[1, 6, 7, 8, 9]),
    (11, &A11, &[1, 6, 7, 8, 9, 10]),
    (12, &A12, &[1, 6, 7, 8, 9, 10, 11]),
    (13, &A13, &[1, 6, 7, 8, 9, 10, 11, 12]),
    (14, &A14, &[1, 6, 7, 8, 9, 10, 11, 12, 13]),
    (15, &A15, &[1, 6, 7, 8, 9, 10, 11, 12, 13, 14]),
    (16, &A16, &[1, 6, 7, 8, 9, 10, 11, 12, 13]),
    (17, &B, &STEP),
    (18, &A18, &[1, 8, 9, 10, 11, 12, 13, 14, 15, 17]),
    (19, &A19, &[1, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18]),
    (20, &A20, &[1, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19]),
    (21, &A21, &[1, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19, 20]),
];

/// The stages of the weights, of the estimate of the error, and of the dense output.
const STEP: [usize; 9] = [1, 8, 9, 10, 11, 12, 13, 14, 15];
const ERROR: [usize; 10] = [1, 8, 9, 10, 11, 12, 13, 14, 15, 16];
const DENSE: [usize; 14] = [1, 8, 9, 10, 11, 12, 13, 14, 15, 17, 18, 19, 20, 21];

/// Rounding of sums of terms up to 36, and of the dense output's up to 1600.
const ROUNDING: f64 = 4e-15;
const ROUNDING_DENSE: f64 = 2e-13;

/// A rooted tree: its order, the product gamma, and its value at every stage.
#[derive(Clone)]
struct Tree {
    order: usize,
    gamma: f64,
    stages: [f64; 22],
}

/// sum of weight times the tree at the stages.
fn sum(weights: &[f64], stages: &[usize], tree: &Tree) -> f64 {
    assert_eq!(weights.len(), stages.len());
    weights.iter().zip(stages).map(|(weight, stage)| weight * tree.stages[*stage]).sum()
}

/// The tree whose root carries `branches`.
fn planted(branches: &[&Tree]) -> Tree {
    let order = 1 + branches.iter().map(|branch| branch.order).sum::<usize>();
    let gamma = order as f64 * branches.iter().map(|branch| branch.gamma).product::<f64>();
    let mut stages = [1.0; 22];
    for branch in branches {
        let mut below = [0.0; 22];
        for (stage, row, of) in ROWS {
            below[stage] = sum(row, of, branch);
        }
        for (stage, value) in stages.iter_mut().zip(below) {
            *stage *= value;
        }
    }
    Tree { order, gamma, stages }
}

/// All rooted trees up to an order.
fn trees(order: usize) -> Vec<Tree> {
    let mut all: Vec<Tree> = Vec::new();
    for order in 1..=order {
        let mut branches = Vec::new();
        let before = all.clone();
        grow(order - 1, &before, &mut branches, &mut all);
    }
    all
}

/// Adds the trees whose branches have `rest` nodes beside those chosen; branches are chosen in order.
fn grow<'t>(rest: usize, from: &'t [Tree], branches: &mut Vec<&'t Tree>, all: &mut Vec<Tree>) {
    if rest == 0 {
        all.push(planted(branches));
    }
    for (k, tree) in from.iter().enumerate().filter(|(_, tree)| tree.order <= rest) {
        branches.push(tree);
        grow(rest - tree.order, &from[k..], branches, all);
        branches.pop();
    }
}

#[test]
fn stages_are_at_their_times() {
    for (stage, row, _) in ROWS {
        assert!((row.iter().sum::<f64>() - C[stage]).abs() < ROUNDING, "{stage}");
    }
}

#[test]
fn the_weights_are_of_order_9_and_those_of_the_error_of_order_8() {
    let trees = trees(10);
    let numbers =
        [1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map(|order| trees.iter().filter(|t| t.order == order).count());
    // N. J. A. Sloane, The On-Line Encyclopedia of Integer Sequences, A000081.
    assert_eq!(numbers, [1, 1, 2, 4, 9, 20, 48, 115, 286, 719]);
    let mut worst = [[0.0_f64; 2]; 11];
    for tree in &trees {
        let step = (sum(&B, &STEP, tree) - 1.0 / tree.gamma).abs();
        let error = sum(&E, &ERROR, tree).abs();
        let [most, least] = &mut worst[tree.order];
        (*most, *least) = (most.max(step), least.max(error));
    }
    for (order, [step, error]) in worst.into_iter().enumerate().skip(1) {
        assert_eq!((step < ROUNDING, error < ROUNDING), (order < 10, order < 9), "{order}: {step} {error}");
    }
}

#[test]
fn the_dense_output_is_of_order_8() {
    let mut next = 0.0_f64;
    for tree in trees(9) {
        // Of a polynomial through the tree: its ends, the rates there, and the five terms beyond them.
        let end = sum(&B, &STEP, &tree);
        let [first, last] = [tree.stages[1], tree.stages[17]];
        let bends = [D4, D5, D6, D7, D8].map(|d| sum(&d, &DENSE, &tree));
        for theta in [0.1, 0.35, 0.5, 0.8_f64] {
            let rest = 1.0 - theta;
            let bend = bends[3] + rest * bends[4];
            let bend = bends[0] + theta * (bends[1] + rest * (bends[2] + theta * bend));
            let start_slope = first - end;
            let end_slope = end - last - start_slope;
            let y = theta * (end + rest * (start_slope + theta * (end_slope + rest * bend)));
            let error = (y - theta.powi(tree.order as i32) / tree.gamma).abs();
            assert!(tree.order > 8 || error < ROUNDING_DENSE, "{} at {theta}: {error}", tree.order);
            next = next.max(error);
        }
    }
    assert!(next > 1e-8, "order 9 as well");
}
