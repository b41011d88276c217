//! Random starts: a shape by chance whose loops close, and what the task says of size, place and zero.
//!
//! With the directions of the links known, a point of the first bar is linear in the pivot, in the size as a vector and in the point as a
//! vector: they come from least squares. Of several shapes the one that fits best is taken.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, SVector};

use super::demands::off;
use super::{
    BARS, ENDS, FIRST_ANGLE, Fit, GROUND_ANGLE, Images, OUTPUT_ZERO, POINT, SHAPE, UNKNOWNS, Unknowns,
    angles, direction,
};
use crate::synthesis::descent::{self, Place, Problem};
use crate::synthesis::four_bar::{Image, Vector};
use crate::synthesis::path::Crank;
use crate::synthesis::random::Random;
use crate::synthesis::six_bar::kernel::{Solved, Z};

/// Shapes that are drawn for a start, at most, and shapes that close.
const DRAWN: usize = 200;
const CLOSED: usize = 6;

/// The start of a number. `None` where none of its shapes closes.
pub(super) fn start(fit: &Fit<'_>, mut random: Random) -> Option<Place<UNKNOWNS, Images>> {
    let mut best: Option<(f64, Place<UNKNOWNS, Images>)> = None;
    let mut closed = 0;
    for _ in 0..DRAWN {
        let Some(place) = draw(fit, &mut random) else { continue };
        let cost = descent::cost(fit, &place, 1.0);
        if cost.is_finite() {
            closed += 1;
            if best.as_ref().is_none_or(|(least, _)| cost < *least) {
                best = Some((cost, place));
            }
        }
        if closed == CLOSED {
            break;
        }
    }
    best.map(|(_, place)| place)
}

/// A shape of unit size with its angles, fitted to the task.
fn draw(fit: &Fit<'_>, random: &mut Random) -> Option<Place<UNKNOWNS, Images>> {
    let mut image = || if random.between(0.0, 1.0) < 0.5 { Image::Left } else { Image::Right };
    let images = [image(), image()];
    let mut unknowns: Unknowns = [0.0; UNKNOWNS];
    let shape = match fit.problem.crank {
        Crank::Turns => [1.0, random.ratio(0.05, 10.0), random.ratio(0.05, 10.0), random.ratio(0.05, 10.0)],
        Crank::Any => [random.ratio(0.1, 10.0), 1.0, random.ratio(0.1, 10.0), random.ratio(0.1, 10.0)],
    };
    unknowns[SHAPE..ENDS].copy_from_slice(&shape);
    let size = fit.problem.crank.lengths_of(&shape).into_iter().fold(0.0, f64::max);
    for end in &mut unknowns[ENDS..BARS] {
        *end = random.between(-1.5, 1.5) * size;
    }
    for bar in &mut unknowns[BARS..POINT] {
        *bar = random.ratio(0.2, 2.0) * size;
    }
    unknowns[FIRST_ANGLE] = direction(fit.is_fixed(FIRST_ANGLE), random);
    let mut angles = angles(fit.problem, random);
    if fit.moves() && fit.input(0).is_some() {
        angles = follow(fit, (&unknowns, images), &angles, random)?;
    }
    let solve = |angle: &f64| fit.pose(&unknowns, images, *angle);
    let poses = angles.iter().map(solve).collect::<Option<Vec<Solved<f64>>>>()?;
    if fit.is_path() {
        place(fit, &poses, &mut unknowns)?;
    } else {
        zero(fit, &poses, &mut unknowns);
    }
    descent::clamp(&mut unknowns, fit.bounds());
    Some(Place { unknowns, angles, image: images })
}

/// Looks around at the angles of a four-bar that moves.
const LOOKS: usize = 72;

/// Angles of a four-bar that moves at which its crank has the angles of the task: at first by chance one of those that there are, then the
/// nearest one.
fn follow(
    fit: &Fit<'_>,
    (unknowns, images): (&Unknowns, Images),
    inputs: &[f64],
    random: &mut Random,
) -> Option<Vec<f64>> {
    let mut last = random.between(0.0, TAU);
    let mut all = Vec::with_capacity(inputs.len());
    for input in inputs {
        // The sine of what the crank is off by, on the side on which it is near.
        let sine = |angle: f64| {
            let [sine, lack] = off(unknowns, &fit.pose(unknowns, images, angle)?, *input);
            (lack < 1.0).then_some(sine)
        };
        let at = |k: usize| last + TAU * (k as f64 / LOOKS as f64 - 0.5);
        let values: Vec<Option<f64>> = (0..=LOOKS).map(|k| sine(at(k))).collect();
        let changes =
            (0..LOOKS).filter(|k| matches!((values[*k], values[k + 1]), (Some(a), Some(b)) if a * b <= 0.0));
        let nearest = changes.min_by_key(|k| (2 * k + 1).abs_diff(LOOKS))?;
        let (mut from, mut to, below) = (at(nearest), at(nearest + 1), values[nearest]?);
        for _ in 0..50 {
            let middle = f64::midpoint(from, to);
            if sine(middle)? * below > 0.0 { from = middle } else { to = middle }
        }
        last = from;
        all.push(last);
    }
    Some(all)
}

fn complex(z: Z<f64>) -> Vector {
    Vector::new(z.re, z.im)
}

/// Pivot, size, direction and point of a path, by least squares of complex numbers.
fn place(fit: &Fit<'_>, poses: &[Solved<f64>], unknowns: &mut Unknowns) -> Option<()> {
    let mut matrix = SMatrix::<Vector, 3, 3>::zeros();
    let mut right = SVector::<Vector, 3>::zeros();
    for (pose, target) in poses.iter().zip(&fit.targets) {
        let bar = pose.traced(fit.problem.chain);
        let columns = [Vector::from(1.0), complex(bar.origin), complex(bar.along)];
        for row in 0..3 {
            right[row] += columns[row].conj() * target;
            for column in 0..3 {
                matrix[(row, column)] += columns[row].conj() * columns[column];
            }
        }
    }
    for k in 0..3 {
        // Where points leave a direction open, the shortest of its lengths is as good as any.
        matrix[(k, k)] *= Vector::from(1.0 + 1e-9);
    }
    let solution = matrix.lu().solve(&right)?;
    let [pivot, size, drawn] = [solution[0], solution[1], solution[2]];
    let scale = room(fit, unknowns).min(size.norm());
    if scale <= 0.0 {
        return None;
    }
    let drawn = drawn / size * size.norm();
    (unknowns[0], unknowns[1], unknowns[GROUND_ANGLE]) = (pivot.re, pivot.im, size.arg());
    (unknowns[POINT], unknowns[POINT + 1]) = (drawn.re, drawn.im);
    for value in &mut unknowns[SHAPE..POINT] {
        *value *= scale;
    }
    Some(())
}

/// Zero of the output of a function, and a size in the middle of the bounds.
fn zero(fit: &Fit<'_>, poses: &[Solved<f64>], unknowns: &mut Unknowns) {
    let turned = poses
        .iter()
        .zip(&fit.targets)
        .map(|(pose, target)| complex(pose.output(fit.problem.chain)) * target.conj());
    unknowns[OUTPUT_ZERO] = turned.sum::<Vector>().arg();
    let scale = 0.5 * room(fit, unknowns);
    for value in &mut unknowns[SHAPE..POINT] {
        *value *= scale;
    }
}

/// Greatest factor of the size within the bounds of lengths.
fn room(fit: &Fit<'_>, unknowns: &Unknowns) -> f64 {
    let lengths = fit.problem.crank.lengths_of(&unknowns[SHAPE..ENDS]).into_iter();
    let all = lengths.chain(unknowns[BARS..POINT].iter().copied()).zip(fit.problem.bounds.lengths);
    all.map(|(length, [_, most])| most / length).fold(f64::INFINITY, f64::min)
}
