//! Search from many starts, on all threads, with a result that does not depend on them.

use rayon::prelude::*;

use super::kernel::{FIRST_ANGLE, GROUND_ANGLE, four_bar};
use super::solve::{Effort, Place, Solver};
use super::start::start;
use super::{Crank, Found, Path, Search};
use crate::four_bar::{Demands, Image, vector};
use crate::random::Random;

/// Effort of each start.
const SEARCH: Effort = Effort { iterations: 40, decrease: 1e-3, weight: 1.0 };

/// Efforts of each start that is kept: the bounds of sums become exact by a growing weight.
const POLISH: [Effort; 4] = [
    Effort { iterations: 500, decrease: 1e-9, weight: 1.0 },
    Effort { iterations: 300, decrease: 1e-9, weight: 1e2 },
    Effort { iterations: 300, decrease: 1e-10, weight: 1e5 },
    Effort { iterations: 300, decrease: 1e-12, weight: 1e8 },
];

/// Starts that are polished for each linkage that is kept: many lead to one linkage.
const CANDIDATES: usize = 8;

/// Outcome of a start: its cost and its number decide the order.
struct Outcome {
    cost: f64,
    number: u64,
    place: Place,
}

/// Outcomes in order, as many as are of use. The best of two lists are the best of both, in whatever order lists are joined.
fn best_of(mut one: Vec<Outcome>, other: Vec<Outcome>, count: usize) -> Vec<Outcome> {
    one.extend(other);
    one.sort_by(|a, b| a.cost.total_cmp(&b.cost).then(a.number.cmp(&b.number)));
    one.truncate(count);
    one
}

pub(super) fn search(path: &Path, search: &Search) -> Vec<Found> {
    let solver = Solver::new(path);
    let count = CANDIDATES * search.keep.max(1);
    let outcome = |number: u64| {
        let mut place = start(path, &solver, Random::new(search.seed, number))?;
        let cost = solver.descend(&mut place, &SEARCH);
        cost.is_finite().then_some(Outcome { cost, number, place })
    };
    let best = (0..search.starts)
        .into_par_iter()
        .filter_map(outcome)
        .fold(Vec::new, |mut list, outcome| {
            list.push(outcome);
            if list.len() < 4 * count { list } else { best_of(list, Vec::new(), count) }
        })
        .reduce(Vec::new, |one, other| best_of(one, other, count));
    let polished: Vec<Found> = best_of(best, Vec::new(), count)
        .into_par_iter()
        .filter_map(|mut outcome| {
            for effort in &POLISH {
                solver.descend(&mut outcome.place, effort);
            }
            found(path, &outcome)
        })
        .collect();
    distinct(polished, search.keep)
}

/// The linkage of an outcome.
fn found(path: &Path, outcome: &Outcome) -> Option<Found> {
    let Place { unknowns, angles, image } = &outcome.place;
    let four_bar = four_bar(path, unknowns, *image);
    let first = unknowns[GROUND_ANGLE] + unknowns[FIRST_ANGLE];
    let angles: Vec<f64> = angles.iter().map(|angle| angle + first).collect();
    let (mut error, mut greatest) = (0.0, 0.0_f64);
    for (angle, target) in angles.iter().zip(&path.points) {
        let distance = (vector(four_bar.pose(*angle)?.point) - vector(*target)).norm();
        error += distance * distance;
        greatest = greatest.max(distance);
    }
    let positions: Vec<(f64, Image)> = angles.iter().map(|&angle| (angle, *image)).collect();
    // The bound is exact up to the last weight of the polish.
    let demands = Demands {
        turns: path.crank == Crank::Turns,
        order: true,
        transmission: path.transmission * (1.0 - 1e-6),
    };
    let defects = four_bar.defects(&positions, &demands);
    Some(Found { four_bar, angles, error, greatest, defects, start: outcome.number })
}

/// Linkages in order, each once: those without a defect first, then by error.
fn distinct(mut all: Vec<Found>, keep: usize) -> Vec<Found> {
    all.sort_by(|a, b| {
        let has_defect = |found: &Found| !found.defects.is_empty();
        has_defect(a).cmp(&has_defect(b)).then(a.error.total_cmp(&b.error)).then(a.start.cmp(&b.start))
    });
    let mut kept: Vec<Found> = Vec::new();
    for found in all {
        let is_same = |other: &Found| {
            let (a, b) = (found.four_bar.lengths(), other.four_bar.lengths());
            a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 1e-4 * b)
        };
        if kept.len() < keep && !kept.iter().any(is_same) {
            kept.push(found);
        }
    }
    kept
}
