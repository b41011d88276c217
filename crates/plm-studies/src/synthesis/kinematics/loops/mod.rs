//! All images of coupled loops: every way in which a mechanism of revolute joints can be assembled, dyads or not.
//!
//! With a unit vector `theta` of each body as a complex number and its conjugate `tau`, loops are linear in both, and `theta tau = 1`. L loops
//! of 2 L bodies leave L unknowns of each kind and 2 L bilinear equations, which have at most `(2L)! / (L!)^2` solutions: 2 for a dyad, 6 for a
//! triad, 20, 70 (Wampler, Solving the kinematics of planar mechanisms, J. Mech. Des. 121, 1999). As many paths are followed from the
//! solutions of a product of linear forms with random complex coefficients, over a bilinear homotopy in two projective spaces. With
//! probability one every isolated solution is the end of a path (Morgan and Sommese, Appl. Math. Comput. 24, 1987).

mod tracker;

use nalgebra::{DMatrix, DVector};

use self::tracker::{Bilinear, End, paths};
use crate::synthesis::four_bar::{Point, Vector, unit, vector};
use crate::synthesis::numbers::first_without;

/// Loop of vectors that close.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Bodies of unknown angles, which count from 0, with the way through each in its frame, m.
    pub vectors: Vec<(usize, Point)>,
    /// Sum of all vectors of known directions, m: of the ground, of bodies with given angles.
    pub known: Point,
}

/// Images of coupled loops.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopImages {
    /// Angles of the bodies in each image, rad, from -pi to pi, in order of the first one.
    pub images: Vec<Vec<f64>>,
    /// Paths that were followed: the greatest number of images.
    pub paths: usize,
    /// Solutions with complex angles, which are no images; they come in pairs.
    pub complex: usize,
    /// Paths that end at infinity, or where solutions coincide: of special dimensions, as at a singular pose.
    pub singular: usize,
    /// True if the paths have ends of their own, so that no image is left out but those that coincide.
    pub is_complete: bool,
}

/// Why loops have no images.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoLoopImages {
    /// L independent loops close 2 L bodies, no other number.
    Bodies {
        /// Loops that were given.
        loops: usize,
        /// Bodies that they name.
        bodies: usize,
    },
    /// The loops depend on each other.
    Dependent,
    /// A vector of this loop, from 0, has a coordinate that is no finite number.
    NoNumber {
        /// The loop.
        of: usize,
    },
    /// More than six loops, which have more than 924 paths.
    TooMany,
}

impl std::fmt::Display for NoLoopImages {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Bodies { loops, bodies } => {
                write!(f, "{loops} loops of {bodies} bodies: each loop has two bodies of its own")
            }
            Self::Dependent => f.write_str("the loops depend on each other"),
            Self::NoNumber { of } => write!(f, "a number of loop {of}, counted from 0, is none"),
            Self::TooMany => f.write_str("more than six loops"),
        }
    }
}

impl std::error::Error for NoLoopImages {}

/// How far an angle of an image may be off the unit circle before it is polished.
const REAL: f64 = 1e-7;

/// Solutions that are nearer to each other count as one.
const SAME: f64 = 1e-7;

/// Every image of coupled loops.
///
/// # Errors
/// [`NoLoopImages`].
pub fn loop_images(loops: &[Loop]) -> Result<LoopImages, NoLoopImages> {
    let bodies = loops.iter().flat_map(|l| &l.vectors).map(|(body, _)| body + 1).max().unwrap_or(0);
    if bodies != 2 * loops.len() || loops.is_empty() {
        return Err(NoLoopImages::Bodies { loops: loops.len(), bodies });
    }
    if loops.len() > 6 {
        return Err(NoLoopImages::TooMany);
    }
    let without =
        |own: &Loop| first_without(own.vectors.iter().map(|(_, way)| *way).chain([own.known])).is_some();
    if let Some(of) = loops.iter().position(without) {
        return Err(NoLoopImages::NoNumber { of });
    }
    let forms = forms(loops).ok_or(NoLoopImages::Dependent)?;
    // Paths that meet are followed again by smaller steps.
    let mut found = ends(loops, &forms, 1.0);
    for accuracy in [1e-1, 1e-2] {
        if !found.is_complete {
            found = ends(loops, &forms, accuracy);
        }
    }
    Ok(found)
}

/// Unit vector of each body as a linear form of the homogeneous unknowns, whose first one stands for 1: a solution of the loops, and a basis of
/// the ways that leave them closed. `None` where the loops depend on each other.
fn forms(loops: &[Loop]) -> Option<DMatrix<Vector>> {
    let (rows, columns) = (loops.len(), 2 * loops.len());
    let mut matrix = DMatrix::from_element(rows, columns, Vector::from(0.0));
    let mut size = vec![0.0_f64; rows];
    for (row, l) in loops.iter().enumerate() {
        for &(body, way) in &l.vectors {
            matrix[(row, body)] += vector(way);
            size[row] = size[row].max(vector(way).norm());
        }
    }
    let known = DVector::from_iterator(rows, loops.iter().map(|l| -vector(l.known)));
    // Rows of the adjoint span the part that the loops determine; the orthogonal part is free.
    let gram = &matrix * matrix.adjoint();
    let pivots = gram.clone().lu();
    let scale = size.iter().copied().fold(0.0, f64::max);
    if pivots.determinant().norm() <= 1e-12 * scale.powi(2 * rows as i32) {
        return None;
    }
    let particular = matrix.adjoint() * pivots.solve(&known)?;
    let mut forms = DMatrix::from_element(columns, rows + 1, Vector::from(0.0));
    forms.set_column(0, &particular);
    let mut basis: Vec<DVector<Vector>> = Vec::new();
    let project = |v: &DVector<Vector>| Some(v - matrix.adjoint() * pivots.solve(&(&matrix * v))?);
    for unit in 0..columns {
        let mut way = DVector::from_element(columns, Vector::from(0.0));
        way[unit] = Vector::from(1.0);
        for _ in 0..2 {
            way = project(&way)?;
            for other in &basis {
                let along = other.dotc(&way);
                way -= other * along;
            }
        }
        let norm = way.norm();
        if norm > 1e-3 && basis.len() < rows {
            basis.push(way / Vector::from(norm));
        }
    }
    if basis.len() < rows {
        return None;
    }
    for (k, way) in basis.iter().enumerate() {
        forms.set_column(k + 1, way);
    }
    Some(forms)
}

/// Ends of all paths as images, with steps in proportion to an accuracy.
fn ends(loops: &[Loop], forms: &DMatrix<Vector>, accuracy: f64) -> LoopImages {
    let ends = paths(&Bilinear { forms: forms.clone() }, accuracy);
    let paths = ends.len();
    let mut finite: Vec<DVector<Vector>> = Vec::new();
    let (mut images, mut singular, mut is_complete) = (Vec::new(), 0, true);
    for end in ends {
        match end {
            End::Regular(theta, tau) => {
                let both = DVector::from_iterator(2 * theta.len(), theta.iter().chain(tau.iter()).copied());
                if finite.iter().any(|other| (other - &both).norm() <= SAME * both.norm()) {
                    is_complete = false;
                }
                let is_real = theta
                    .iter()
                    .zip(tau.iter())
                    .all(|(z, w)| (z.norm() - 1.0).abs() < REAL && (z.conj() - w).norm() < REAL);
                if is_real {
                    let angles: Vec<f64> = theta.iter().map(|z| z.arg()).collect();
                    images.push(polished(loops, angles));
                }
                finite.push(both);
            }
            End::Singular => singular += 1,
            End::Lost => is_complete = false,
        }
    }
    images
        .sort_by(|a, b| a.iter().zip(b).fold(std::cmp::Ordering::Equal, |o, (a, b)| o.then(a.total_cmp(b))));
    LoopImages { complex: finite.len() - images.len(), images, paths, singular, is_complete }
}

/// Angles after a few steps of Newton's iteration on the loops themselves.
fn polished(loops: &[Loop], mut angles: Vec<f64>) -> Vec<f64> {
    let n = angles.len();
    for _ in 0..3 {
        let mut matrix = DMatrix::<f64>::zeros(n, n);
        let mut gap = DVector::<f64>::zeros(n);
        for (row, l) in loops.iter().enumerate() {
            let mut sum = vector(l.known);
            for &(body, way) in &l.vectors {
                let turned = vector(way) * unit(angles[body]);
                sum += turned;
                matrix[(2 * row, body)] -= turned.im;
                matrix[(2 * row + 1, body)] += turned.re;
            }
            (gap[2 * row], gap[2 * row + 1]) = (sum.re, sum.im);
        }
        let Some(step) = matrix.lu().solve(&gap) else { break };
        for (angle, step) in angles.iter_mut().zip(step.iter()) {
            *angle -= step;
        }
    }
    angles.into_iter().map(|angle| unit(angle).arg()).collect()
}
