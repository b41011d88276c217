//! Function generation: four-bars whose rocker turns by a function of the crank.
//!
//! Freudenstein's equation (Approximate synthesis of four-bar linkages, Trans. ASME 77, 1955) is linear in three ratios of the lengths:
//! `K1 cos(psi) - K2 cos(phi) + K3 = cos(phi - psi)`, with the crank's angle phi and the rocker's psi from the line of the pivots,
//! `K1 = d/a`, `K2 = d/c`, `K3 = (a^2 - b^2 + c^2 + d^2)/(2 a c)` of the ground d, the crank a, the coupler b and the rocker c.

use nalgebra::{DMatrix, DVector};

use crate::synthesis::four_bar::{Defect, Demands, FourBar, Image, unit};
use crate::synthesis::numbers::{decomposed, first_without};
use crate::synthesis::roots::trigonometric_roots;

/// Pair of angles that a function generator has to have at once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// Angle of the crank, rad.
    pub crank: f64,
    /// Angle of the rocker, rad.
    pub rocker: f64,
}

/// Which zeros of the scales of crank and rocker a synthesis is free to choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scales {
    /// Angles are those from the line of the pivots: three pairs are met exactly, more by least squares.
    Given,
    /// The crank's scale begins anywhere: four pairs are met exactly.
    FreeCrank,
    /// Both scales begin anywhere: five pairs are met exactly.
    FreeBoth,
}

/// Four-bar that generates a function.
#[derive(Clone, Debug, PartialEq)]
pub struct Generator {
    /// Linkage, with the crank's pivot at the origin and the rocker's on the x-axis.
    pub four_bar: FourBar,
    /// Angle of the crank from the x-axis where that of its scale is zero, rad.
    pub crank_zero: f64,
    /// Angle of the rocker from the x-axis where that of its scale is zero, rad.
    pub rocker_zero: f64,
    /// Angle of the rocker beyond the demanded one at each pair, rad (the structural error). Infinite where the loop does not close.
    pub errors: Vec<f64>,
    /// Defects of the linkage between the pairs.
    pub defects: Vec<Defect>,
}

/// Why there is no generator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoGenerator {
    /// The scales ask for more pairs than were given: so many are needed.
    TooFewPairs {
        /// Pairs that are needed.
        needed: usize,
    },
    /// More pairs than freedom, and scales to choose: least squares take given scales.
    TooManyPairs {
        /// Pairs that can be met.
        most: usize,
    },
    /// The equations of the pairs depend on each other, as with a pair twice.
    Dependent,
    /// No real and finite lengths solve the equations.
    NoLengths,
    /// An angle of this pair, from 0, is no finite number.
    NoNumber {
        /// The pair.
        pair: usize,
    },
    /// The ground has no positive, finite length.
    Ground,
}

impl std::fmt::Display for NoGenerator {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::TooFewPairs { needed } => write!(f, "too few pairs of angles: {needed} are needed"),
            Self::TooManyPairs { most } => {
                write!(f, "too many pairs of angles: {most} can be met with free scales")
            }
            Self::Dependent => f.write_str("the equations of the pairs depend on each other"),
            Self::NoLengths => f.write_str("no real and finite lengths solve the equations"),
            Self::NoNumber { pair } => write!(f, "an angle of pair {pair}, counted from 0, is no number"),
            Self::Ground => f.write_str("the length of the ground is no positive number"),
        }
    }
}

impl std::error::Error for NoGenerator {}

/// Zeros of Chebyshev's polynomial over an interval: precision points of a nearly least greatest error (Freudenstein, 1955).
pub fn chebyshev(count: usize, from: f64, to: f64) -> Vec<f64> {
    let angle = |k: usize| std::f64::consts::PI * (2.0 * k as f64 + 1.0) / (2.0 * count as f64);
    (0..count).map(|k| 0.5 * (from + to) - 0.5 * (to - from) * angle(k).cos()).collect()
}

/// All generators that meet pairs of angles on a ground of a length, m. Given scales have one.
///
/// # Errors
/// [`NoGenerator`].
pub fn generators(pairs: &[Pair], ground: f64, scales: Scales) -> Result<Vec<Generator>, NoGenerator> {
    let (needed, at_most) = match scales {
        Scales::Given => (3, usize::MAX),
        Scales::FreeCrank => (4, 4),
        Scales::FreeBoth => (5, 5),
    };
    if pairs.len() < needed {
        return Err(NoGenerator::TooFewPairs { needed });
    }
    if pairs.len() > at_most {
        return Err(NoGenerator::TooManyPairs { most: at_most });
    }
    if let Some(pair) = first_without(pairs.iter().map(|pair| [pair.crank, pair.rocker])) {
        return Err(NoGenerator::NoNumber { pair });
    }
    if !(ground > 0.0 && ground.is_finite()) {
        return Err(NoGenerator::Ground);
    }
    let found = match scales {
        Scales::Given => vec![given_scales(pairs)?],
        Scales::FreeCrank | Scales::FreeBoth => free_scales(pairs, scales)?,
    };
    let is_exact = pairs.len() == needed;
    let meets = |own: &Generator| !is_exact || own.errors.iter().all(|error| error.abs() <= MET);
    let found: Vec<Generator> = found
        .into_iter()
        .filter_map(|solution| solution.generator(ground, pairs))
        .filter(|own| meets(own))
        .collect();
    if found.is_empty() { Err(NoGenerator::NoLengths) } else { Ok(found) }
}

/// An error below this, rad, meets a pair exactly: at a dead point rounding has its root.
const MET: f64 = 1e-6;
/// A ratio below this part of the largest, or of 1, is the rounding of the equations: its link would be endless.
const ENDLESS: f64 = 1e-10;

/// Ratios of Freudenstein's equation, and the angles by which the scales begin.
#[derive(Clone, Copy, Debug)]
struct Solution {
    ratios: [f64; 3],
    zeros: [f64; 2],
}

/// Least squares of Freudenstein's equation, exact for three pairs; more pairs are then fitted by their structural errors.
fn given_scales(pairs: &[Pair]) -> Result<Solution, NoGenerator> {
    let matrix = DMatrix::from_fn(pairs.len(), 3, |row, column| {
        let Pair { crank, rocker } = pairs[row];
        [rocker.cos(), -crank.cos(), 1.0][column]
    });
    let right = DVector::from_iterator(pairs.len(), pairs.iter().map(|p| (p.crank - p.rocker).cos()));
    let ratios = least_squares(matrix, &right)?;
    let solution = Solution { ratios: [ratios[0], ratios[1], ratios[2]], zeros: [0.0; 2] };
    Ok(if pairs.len() > 3 { solution.fitted(pairs) } else { solution })
}

fn least_squares(matrix: DMatrix<f64>, right: &DVector<f64>) -> Result<DVector<f64>, NoGenerator> {
    let decomposed = decomposed(matrix).ok_or(NoGenerator::Dependent)?;
    let [most, least] = [decomposed.singular_values.max(), decomposed.singular_values.min()];
    if least <= 1e-12 * most {
        return Err(NoGenerator::Dependent);
    }
    decomposed.solve(right, 0.0).map_err(|_| NoGenerator::Dependent)
}

/// Free scales: with `delta = crank zero - rocker zero`, `X = (K1 cos, K1 sin)` of the rocker's zero, `Y = (K2 cos, K2 sin)` of the
/// crank's, and K3, the equations of all pairs are linear, with a right side that is linear in cos(delta) and sin(delta). The angle of Y
/// beyond that of X has to be delta, up to half a turn: a trigonometric polynomial in delta.
fn free_scales(pairs: &[Pair], scales: Scales) -> Result<Vec<Solution>, NoGenerator> {
    let both = scales == Scales::FreeBoth;
    let count = pairs.len();
    let matrix = DMatrix::from_fn(count, count, |row, column| {
        let Pair { crank, rocker } = pairs[row];
        let terms = [-crank.cos(), crank.sin(), 1.0, rocker.cos(), -rocker.sin()];
        terms[column]
    });
    let side = |part: fn(f64) -> f64| {
        let right = DVector::from_iterator(count, pairs.iter().map(|p| part(p.crank - p.rocker)));
        least_squares(matrix.clone(), &right)
    };
    let (by_cos, by_sin) = (side(f64::cos)?, side(|angle| -angle.sin())?);
    let solve = |delta: f64| {
        let x = &by_cos * delta.cos() + &by_sin * delta.sin();
        let of_crank = nalgebra::Complex::new(x[0], x[1]);
        let of_rocker = nalgebra::Complex::new(x[3], if both { x[4] } else { 0.0 });
        (of_crank, of_rocker, x[2])
    };
    let mismatch = |delta: f64| {
        let (of_crank, of_rocker, _) = solve(delta);
        // The rocker's scale has no zero of its own where it is given: X is real.
        let of_rocker = if both { of_rocker } else { nalgebra::Complex::from(1.0) };
        (unit(delta) * of_crank.conj() * of_rocker).im
    };
    let solution = |delta: f64| {
        let (of_crank, of_rocker, third) = solve(delta);
        let rocker_zero = if both { of_rocker.arg() } else { 0.0 };
        let crank_zero = rocker_zero + delta;
        let first = (of_rocker * unit(-rocker_zero)).re;
        let second = (of_crank * unit(-crank_zero)).re;
        Solution { ratios: [first, second, third], zeros: [crank_zero, rocker_zero] }
    };
    let degree = if both { 3 } else { 2 };
    Ok(trigonometric_roots(degree, mismatch).into_iter().map(solution).collect())
}

impl Solution {
    /// Newton's iteration for least squares of the structural errors, as long as they fall.
    fn fitted(self, pairs: &[Pair]) -> Self {
        let cost = |solution: &Self| {
            solution.generator(1.0, pairs).map_or(f64::INFINITY, |g| g.errors.iter().map(|e| e * e).sum())
        };
        let (mut best, mut least) = (self, cost(&self));
        for _ in 0..50 {
            let Some(step) = best.step(pairs) else { break };
            let tried = [1.0, 0.5, 0.25, 0.125].map(|part| {
                let ratios = std::array::from_fn(|k| best.ratios[k] + part * step[k]);
                let next = Self { ratios, zeros: best.zeros };
                (cost(&next), next)
            });
            let Some(&(error, next)) = tried.iter().find(|(error, _)| *error < least) else { break };
            (best, least) = (next, error);
        }
        best
    }

    /// Step of Gauss and Newton: derivatives of the rocker's angle by the ratios, from Freudenstein's equation.
    fn step(&self, pairs: &[Pair]) -> Option<DVector<f64>> {
        let errors = self.generator(1.0, pairs)?.errors;
        let matrix = DMatrix::from_fn(pairs.len(), 3, |row, column| {
            let Pair { crank, rocker } = pairs[row];
            let rocker = rocker + errors[row];
            let slope = -self.ratios[0] * rocker.sin() - (crank - rocker).sin();
            [-rocker.cos(), crank.cos(), -1.0][column] / slope
        });
        let right = DVector::from_iterator(pairs.len(), errors.iter().map(|error| -error));
        least_squares(matrix, &right).ok()
    }

    /// The linkage. A negative length turns the zero of its scale by half a revolution. `None` if a length is not real.
    fn generator(&self, ground: f64, pairs: &[Pair]) -> Option<Generator> {
        let [first, second, third] = self.ratios;
        let least = ENDLESS * self.ratios.iter().fold(1.0, |most: f64, ratio| most.max(ratio.abs()));
        if first.abs() <= least || second.abs() <= least {
            return None;
        }
        let (crank, rocker) = (ground / first, ground / second);
        let square = crank * crank + rocker * rocker + ground * ground - 2.0 * third * crank * rocker;
        if !(square > 0.0 && crank.is_finite() && rocker.is_finite()) {
            return None;
        }
        let half_turn = |length: f64| if length < 0.0 { std::f64::consts::PI } else { 0.0 };
        let [crank_zero, rocker_zero] = [self.zeros[0] + half_turn(crank), self.zeros[1] + half_turn(rocker)];
        let mut four_bar = FourBar {
            pivots: [[0.0, 0.0], [ground, 0.0]],
            crank: crank.abs(),
            coupler: square.sqrt(),
            rocker: rocker.abs(),
            point: [0.0, 0.0],
            image: Image::Left,
        };
        let placed = pairs.iter().map(|pair| (pair.crank + crank_zero, pair.rocker + rocker_zero));
        let images: Vec<(f64, Image)> =
            placed.clone().map(|(angle, rocker)| (angle, four_bar.nearest_image(angle, rocker).0)).collect();
        four_bar.image = images[0].1;
        let errors = placed.map(|(angle, rocker)| four_bar.nearest_image(angle, rocker).1).collect();
        let defects = four_bar.defects(&images, &Demands { order: true, ..Demands::default() });
        Some(Generator { four_bar, crank_zero, rocker_zero, errors, defects })
    }
}

impl FourBar {
    /// Image whose rocker is next to an angle from the x-axis, and the angle of the rocker beyond it.
    fn nearest_image(&self, crank: f64, rocker: f64) -> (Image, f64) {
        let error = |image| {
            let pose = self.pose_on(crank, image);
            (image, pose.map_or(f64::INFINITY, |pose| (unit(rocker).conj() * unit(pose.angles[2])).arg()))
        };
        let [left, right] = [Image::Left, Image::Right].map(error);
        if right.1.abs() < left.1.abs() { right } else { left }
    }
}
