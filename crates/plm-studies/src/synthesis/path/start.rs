//! Random starts: a shape and angles of the crank by chance, and what the points say of size, place and coupler point.
//!
//! With the directions of crank and coupler known at each point, the coupler point is linear in the pivot, in the crank as a vector, and
//! in the coupler point as a vector: they come from least squares. Of several shapes the one that fits best is taken.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};

use super::kernel::{COUPLER_POINT, FIRST_ANGLE, GROUND_ANGLE, Linkage, SHAPE, Unknowns};
use super::solve::{Place, Solver};
use super::{Crank, Path, Timing};
use crate::synthesis::descent::{self, Problem};
use crate::synthesis::four_bar::{Image, Point, Vector, unit, vector};
use crate::synthesis::random::Random;

/// Shapes that are drawn for a start.
const SHAPES: usize = 8;

/// The start of a number. `None` where none of its shapes closes.
pub(super) fn start(path: &Path, solver: &Solver<'_>, mut random: Random) -> Option<Place> {
    let drawn = (0..SHAPES).filter_map(|_| {
        let place = draw(path, solver, &mut random)?;
        let cost = descent::cost(solver, &place, 1.0);
        cost.is_finite().then_some((cost, place))
    });
    drawn.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, place)| place)
}

/// A shape of unit crank with angles, fitted to the points.
fn draw(path: &Path, solver: &Solver<'_>, random: &mut Random) -> Option<Place> {
    let image = if random.between(0.0, 1.0) < 0.5 { Image::Left } else { Image::Right };
    let mut unknowns: Unknowns = [0.0; 10];
    let shape = match path.crank {
        Crank::Turns => [1.0, random.ratio(0.02, 20.0), random.ratio(0.02, 20.0), random.ratio(0.02, 20.0)],
        Crank::Any => [random.ratio(0.1, 10.0), 1.0, random.ratio(0.1, 10.0), random.ratio(0.1, 10.0)],
    };
    unknowns[SHAPE..COUPLER_POINT].copy_from_slice(&shape);
    let first = if solver.is_fixed(FIRST_ANGLE) { 0.0 } else { random.between(0.0, TAU) };
    unknowns[FIRST_ANGLE] = first;
    let angles = match &path.timing {
        Timing::Given(angles) | Timing::Steps(angles) => angles.clone(),
        Timing::Free => spread(&path.points, random),
    };
    let linkage = Linkage::new(path.crank, &unknowns, image);
    let directions =
        angles.iter().map(|angle| linkage.directions(angle + first)).collect::<Option<Vec<_>>>()?;
    fit(path, solver, &directions, &mut unknowns)?;
    descent::clamp(&mut unknowns, solver.bounds());
    Some(Place { unknowns, angles, image })
}

/// Angles of the crank by chance in the order of the points: between equal steps and steps in proportion to the distances.
pub(crate) fn spread(points: &[Point], random: &mut Random) -> Vec<f64> {
    let mut ways = vec![0.0];
    for pair in points.windows(2) {
        ways.push(ways[ways.len() - 1] + (vector(pair[1]) - vector(pair[0])).norm());
    }
    let steps = (points.len() - 1) as f64;
    let whole = ways[points.len() - 1].max(f64::MIN_POSITIVE);
    let sweep = random.between(0.1, 1.0) * TAU * steps / (steps + 1.0);
    let sweep = if random.between(0.0, 1.0) < 0.5 { -sweep } else { sweep };
    let (first, share) = (random.between(0.0, TAU), random.between(0.0, 1.0));
    let part = |k: usize| (1.0 - share) * k as f64 / steps + share * ways[k] / whole;
    (0..points.len()).map(|k| first + sweep * part(k)).collect()
}

/// Columns of the least squares: pivot x and y, crank (a vector, or its length where the angle of the ground is fixed), coupler point.
type Columns = [Vector; 6];

fn fit(path: &Path, solver: &Solver<'_>, directions: &[[Vector; 2]], unknowns: &mut Unknowns) -> Option<()> {
    let i = Vector::new(0.0, 1.0);
    let turned = solver.is_fixed(GROUND_ANGLE);
    let ground = if turned { unit(path.bounds.ground_angle[0]) } else { Vector::from(1.0) };
    let held = [solver.is_fixed(0), solver.is_fixed(1), false, turned, false, false];
    let place = Vector::new(
        if held[0] { path.bounds.pivot[0][0] } else { 0.0 },
        if held[1] { path.bounds.pivot[1][0] } else { 0.0 },
    );
    let mut matrix = SMatrix::<f64, 6, 6>::zeros();
    let mut right = SVector::<f64, 6>::zeros();
    for (&[crank, coupler], target) in directions.iter().zip(&path.points) {
        let [crank, coupler] = [ground * crank, ground * coupler];
        let columns: Columns = [Vector::from(1.0), i, crank, i * crank, coupler, i * coupler];
        let target = vector(*target) - place;
        for row in 0..6 {
            right[row] += (columns[row].conj() * target).re;
            for column in 0..6 {
                matrix[(row, column)] += (columns[row].conj() * columns[column]).re;
            }
        }
    }
    for k in 0..6 {
        if held[k] {
            matrix.set_row(k, &SMatrix::<f64, 1, 6>::zeros());
            matrix.set_column(k, &SVector::<f64, 6>::zeros());
            right[k] = 0.0;
        }
        // Where points leave a direction open, the shortest of its lengths is as good as any.
        matrix[(k, k)] += if held[k] { 1.0 } else { 1e-9 * matrix[(k, k)] };
    }
    let x = matrix.cholesky()?.solve(&right);
    let (crank, coupler) = (Vector::new(x[2], x[3]), Vector::new(x[4], x[5]));
    let size = if turned { crank.re } else { crank.norm() };
    if size <= 0.0 {
        return None;
    }
    let along = if turned { Vector::from(1.0) } else { crank / size };
    if !held[0] {
        unknowns[0] = x[0];
    }
    if !held[1] {
        unknowns[1] = x[1];
    }
    unknowns[GROUND_ANGLE] = if turned { path.bounds.ground_angle[0] } else { along.arg() };
    let coupler_point = coupler * along.conj();
    unknowns[COUPLER_POINT] = coupler_point.re;
    unknowns[COUPLER_POINT + 1] = coupler_point.im;
    // The same shape in the size that fits, as far as its bounds allow.
    let largest = path.crank.lengths(unknowns).into_iter().zip(path.bounds.lengths);
    let room = largest.map(|(length, [_, most])| most / length).fold(f64::INFINITY, f64::min);
    for value in &mut unknowns[SHAPE..COUPLER_POINT] {
        *value *= size.min(room);
    }
    Some(())
}
