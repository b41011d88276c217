//! Search from many starts: the linkages of its outcomes.

use super::kernel::{FIRST_ANGLE, GROUND_ANGLE, UNKNOWNS, four_bar};
use super::solve::{Place, Solver};
use super::start::start;
use super::{Crank, Found, Path, Search};
use crate::synthesis::descent::{self, Outcome};
use crate::synthesis::four_bar::{Demands, Image, vector};
use crate::synthesis::random::Random;

/// Starts that are polished for each requested linkage: many lead to one linkage.
pub(crate) const CANDIDATES: usize = 8;

pub(super) fn search(path: &Path, search: &Search) -> Vec<Found> {
    let solver = Solver::new(path);
    let from = |number| start(path, &solver, Random::new(search.seed, number));
    let count = CANDIDATES * search.keep.max(1);
    let polished = descent::search(&solver, search.starts, count, from, |outcome| found(path, outcome));
    distinct(polished, search.keep)
}

/// The linkage of an outcome.
fn found(path: &Path, outcome: &Outcome<UNKNOWNS, Image>) -> Option<Found> {
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
