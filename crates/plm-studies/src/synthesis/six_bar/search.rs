//! Least squares of a six-bar's problem, with exact derivatives by dual numbers.

mod demands;
mod start;

use std::f64::consts::{PI, TAU};

use plm_runtime::{Dual, Real};

use super::kernel::{Dimensions, Solved, Z};
use super::problem::{Found, Problem, Task};
use super::{Chain, SixBar};
use crate::synthesis::descent::{self, Lack, Outcome, Place, Row};
use crate::synthesis::four_bar::{Demands, FourBar, Image, Vector, point, unit, vector};
use crate::synthesis::function::Scales;
use crate::synthesis::path::{Crank, Search, Timing};
use crate::synthesis::random::Random;

/// Unknowns: the pivot's coordinates, the angle of the ground, four numbers of the shape, the ends of the dyad, its bars, the point, the
/// angle of the crank and that of the output where their scales begin.
const UNKNOWNS: usize = 17;
const GROUND_ANGLE: usize = 2;
const SHAPE: usize = 3;
const ENDS: usize = 7;
const BARS: usize = 11;
const POINT: usize = 13;
const FIRST_ANGLE: usize = 15;
const OUTPUT_ZERO: usize = 16;
/// Directions of derivatives: the unknowns, and the angle of the row.
const DIRECTIONS: usize = UNKNOWNS + 1;

type Unknowns = [f64; UNKNOWNS];
/// Images of the four-bar and of the dyad.
type Images = [Image; 2];

/// Linkages of the best starts of a search, in no order.
pub(super) fn search(problem: &Problem, search: &Search) -> Vec<Found> {
    let fit = Fit::new(problem);
    let from = |number| start::start(&fit, Random::new(search.seed, number));
    let count = crate::synthesis::path::CANDIDATES * search.keep.max(1);
    descent::search(&fit, search.starts, count, from, |outcome| fit.found(outcome))
}

/// Least squares of a problem.
struct Fit<'a> {
    problem: &'a Problem,
    /// Points, or unit vectors of the output.
    targets: Vec<Vector>,
    bounds: [[f64; 2]; UNKNOWNS],
}

impl<'a> Fit<'a> {
    fn new(problem: &'a Problem) -> Self {
        let b = &problem.bounds;
        let mut bounds = [[f64::NEG_INFINITY, f64::INFINITY]; UNKNOWNS];
        bounds[..2].copy_from_slice(&b.pivot);
        match problem.crank {
            Crank::Any => bounds[SHAPE..ENDS].copy_from_slice(&b.lengths[..4]),
            Crank::Turns => {
                bounds[SHAPE] = b.lengths[1];
                bounds[SHAPE + 1..ENDS].fill([0.0, f64::INFINITY]);
            }
        }
        bounds[ENDS..BARS].fill(b.points);
        bounds[BARS..POINT].copy_from_slice(&b.lengths[4..]);
        bounds[POINT..FIRST_ANGLE].fill(b.points);
        let nothing = [0.0; 2];
        let (targets, free) = match &problem.task {
            Task::Function { pairs, scales } => {
                // A function says nothing of place, direction and point.
                bounds[..SHAPE].fill(nothing);
                bounds[POINT..FIRST_ANGLE].fill(nothing);
                let targets = pairs.iter().map(|pair| unit(pair.rocker)).collect();
                (targets, [*scales != Scales::Given, *scales == Scales::FreeBoth])
            }
            Task::Path { points, timing } => {
                let targets = points.iter().copied().map(vector).collect();
                (targets, [matches!(timing, Timing::Steps(_)), false])
            }
        };
        for (k, free) in free.into_iter().enumerate() {
            if !free {
                bounds[FIRST_ANGLE + k] = nothing;
            }
        }
        Self { problem, targets, bounds }
    }

    fn is_fixed(&self, k: usize) -> bool {
        let [least, most] = self.bounds[k];
        least == most
    }

    fn is_path(&self) -> bool {
        matches!(self.problem.task, Task::Path { .. })
    }

    fn dimensions<S: Real>(&self, unknowns: &[S; UNKNOWNS], images: Images) -> Dimensions<S> {
        let map = self.problem.crank.lengths_by_shape();
        let length =
            |row: [f64; 4]| (0..4).fold(S::ZERO, |sum, n| sum + S::lit(row[n]) * unknowns[SHAPE + n]);
        let pair = |k: usize| Z::new(unknowns[k], unknowns[k + 1]);
        Dimensions {
            chain: self.problem.chain,
            lengths: map.map(length),
            ends: [pair(ENDS), pair(ENDS + 2)],
            bars: [unknowns[BARS], unknowns[BARS + 1]],
            images,
        }
    }

    /// The pose at an angle of the crank from where its scale begins.
    fn pose<S: Real>(&self, unknowns: &[S; UNKNOWNS], images: Images, angle: S) -> Option<Solved<S>> {
        // A four-bar that moves has an angle of its own.
        let angle = if self.moves() { angle } else { angle + unknowns[FIRST_ANGLE] };
        self.dimensions(unknowns, images).solve(angle)
    }

    /// Is the crank another link than the first one of the four-bar?
    fn moves(&self) -> bool {
        self.problem.chain == Chain::StephensonTwo
    }

    /// The point, or the unit vector of the output from its zero, at an angle of the crank from where its scale begins.
    fn value<S: Real>(&self, unknowns: &[S; UNKNOWNS], images: Images, angle: S) -> Option<Z<S>> {
        let pose = self.pose(unknowns, images, angle)?;
        let (traced, output) = (pose.traced(self.problem.chain), pose.output(self.problem.chain));
        Some(if self.is_path() {
            let place = Z::unit(unknowns[GROUND_ANGLE])
                .times(traced.at(Z::new(unknowns[POINT], unknowns[POINT + 1])));
            place.plus(Z::new(unknowns[0], unknowns[1]))
        } else {
            output.times(Z::unit(-unknowns[OUTPUT_ZERO]))
        })
    }

    /// The linkage of an outcome.
    fn found(&self, outcome: &Outcome<UNKNOWNS, Images>) -> Option<Found> {
        let Place { unknowns, angles, image: images } = &outcome.place;
        let dimensions = self.dimensions(unknowns, *images);
        let within = |length: f64, k: usize| {
            let [least, most] = self.problem.bounds.lengths[k];
            length.clamp(least, most)
        };
        let [ground, crank, coupler, rocker] = std::array::from_fn(|k| within(dimensions.lengths[k], k));
        let pivot = [unknowns[0], unknowns[1]];
        let six_bar = SixBar {
            four_bar: FourBar {
                pivots: [pivot, point(vector(pivot) + unit(unknowns[GROUND_ANGLE]) * ground)],
                crank,
                coupler,
                rocker,
                point: [0.0; 2],
                image: images[0],
            },
            chain: self.problem.chain,
            ends: dimensions.ends.map(|end| [end.re, end.im]),
            bars: dimensions.bars,
            image: images[1],
            point: [unknowns[POINT], unknowns[POINT + 1]],
        };
        let moves = self.moves();
        let first = if moves { 0.0 } else { unknowns[GROUND_ANGLE] + unknowns[FIRST_ANGLE] };
        let angles: Vec<f64> = angles.iter().map(|angle| angle + first).collect();
        let (mut error, mut greatest) = (0.0, 0.0_f64);
        for (position, (angle, target)) in angles.iter().zip(&self.targets).enumerate() {
            let pose = six_bar.pose(*angle)?;
            if let Some(input) = self.input(position).filter(|_| moves) {
                let wanted = unknowns[GROUND_ANGLE] + unknowns[FIRST_ANGLE] + input;
                if (0.5 * (pose.crank - wanted)).sin().abs() > 1e-6 {
                    return None;
                }
            }
            let output = if moves { pose.angles[0] + PI } else { pose.angles[1] };
            let reached =
                if self.is_path() { vector(pose.point) } else { unit(output - unknowns[OUTPUT_ZERO]) };
            error += (reached - target).norm_sqr();
            let off = if self.is_path() { (reached - target).norm() } else { (reached / target).arg().abs() };
            greatest = greatest.max(off);
        }
        let demands = Demands {
            turns: self.problem.crank == Crank::Turns,
            order: true,
            transmission: self.problem.transmission,
        };
        let defects = six_bar.defects(&angles, &demands);
        let output_zero = unknowns[OUTPUT_ZERO];
        Some(Found { six_bar, angles, output_zero, error, greatest, defects, start: outcome.number })
    }
}

impl descent::Problem<UNKNOWNS> for Fit<'_> {
    type Image = Images;

    fn rows(&self, place: &Place<UNKNOWNS, Images>) -> Option<Vec<Row<UNKNOWNS>>> {
        let unknowns = variables(&place.unknowns);
        let row = |(angle, target): (&f64, &Vector)| {
            let value = self.value(&unknowns, place.image, Dual::variable(*angle, UNKNOWNS))?;
            let by = |k: usize| Vector::new(value.re.tangents[k], value.im.tangents[k]);
            Some(Row {
                residual: Vector::new(value.re.value, value.im.value) - target,
                by_unknowns: std::array::from_fn(by),
                by_angle: by(UNKNOWNS),
            })
        };
        place.angles.iter().zip(&self.targets).map(row).collect()
    }

    fn error(&self, place: &Place<UNKNOWNS, Images>) -> f64 {
        let square = |(angle, target): (&f64, &Vector)| {
            let value = self.value(&place.unknowns, place.image, *angle)?;
            Some((Vector::new(value.re, value.im) - target).norm_sqr())
        };
        place.angles.iter().zip(&self.targets).map(square).sum::<Option<f64>>().unwrap_or(f64::INFINITY)
    }

    fn violations(&self, unknowns: &Unknowns) -> Vec<(f64, [f64; UNKNOWNS])> {
        if self.problem.crank == Crank::Any {
            return Vec::new();
        }
        let map = self.problem.crank.lengths_by_shape();
        let lengths = self.problem.crank.lengths_of(&unknowns[SHAPE..ENDS]);
        let violation = |k: usize| {
            let [least, most] = self.problem.bounds.lengths[k];
            let mut by = [0.0; UNKNOWNS];
            by[SHAPE..ENDS].copy_from_slice(&map[k]);
            ((lengths[k] - most).max(0.0) + (lengths[k] - least).min(0.0), by)
        };
        (0..4).map(violation).filter(|(violation, _)| *violation != 0.0).collect()
    }

    fn bounds(&self) -> &[[f64; 2]; UNKNOWNS] {
        &self.bounds
    }

    fn lacks(&self, place: &Place<UNKNOWNS, Images>) -> Vec<Lack<UNKNOWNS>> {
        self.lacks_at(place)
    }

    fn lack(&self, place: &Place<UNKNOWNS, Images>) -> f64 {
        self.lack_at(place)
    }

    fn angles_are_free(&self) -> bool {
        self.moves() || matches!(&self.problem.task, Task::Path { timing: Timing::Free, .. })
    }
}

/// Unknowns with derivatives by each.
fn variables(unknowns: &Unknowns) -> [Dual<f64, DIRECTIONS>; UNKNOWNS] {
    std::array::from_fn(|k| Dual::variable(unknowns[k], k))
}

/// Angles of the crank at the positions, as far as they are known, else by chance.
fn angles(problem: &Problem, random: &mut Random) -> Vec<f64> {
    match &problem.task {
        Task::Function { pairs, .. } => pairs.iter().map(|pair| pair.crank).collect(),
        Task::Path { timing: Timing::Given(angles) | Timing::Steps(angles), .. } => angles.clone(),
        Task::Path { points, timing: Timing::Free } => crate::synthesis::path::spread(points, random),
    }
}

/// The angle of a random direction, rad, or the one that is given.
fn direction(is_fixed: bool, random: &mut Random) -> f64 {
    if is_fixed { 0.0 } else { random.between(0.0, TAU) }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::synthesis::descent::Problem as _;
    use crate::synthesis::function::Pair;
    use crate::synthesis::six_bar::{Bounds, Chain};

    const CHAINS: [Chain; 5] =
        [Chain::WattOne, Chain::WattTwo, Chain::StephensonOne, Chain::StephensonThree, Chain::StephensonTwo];
    const IMAGES: Images = [Image::Left, Image::Right];
    const SHAPED: Unknowns =
        [0.1, 0.2, 0.3, 0.3, 0.9, 0.8, 0.7, 0.5, 0.4, 0.3, -0.4, 1.1, 1.2, 0.3, 0.2, 0.5, 0.3];

    #[test]
    fn derivatives_are_those_of_differences() {
        let timing = Timing::Steps(vec![0.0, 0.7]);
        let points = vec![[0.2, 0.3], [0.4, 0.1]];
        let pairs = vec![Pair { crank: 0.0, rocker: 0.1 }, Pair { crank: 0.7, rocker: 0.4 }];
        for task in [Task::Path { points, timing }, Task::Function { pairs, scales: Scales::FreeBoth }] {
            for chain in CHAINS {
                let (bounds, crank) = (Bounds::up_to(5.0), Crank::Turns);
                let problem = Problem { chain, task: task.clone(), bounds, crank, transmission: 0.0 };
                let fit = Fit::new(&problem);
                let (unknowns, image) = (SHAPED, IMAGES);
                let place = Place { unknowns, angles: vec![0.0, 0.7], image };
                for (k, row) in fit.rows(&place).unwrap().into_iter().enumerate() {
                    let value = |x: &Unknowns, angle: f64| {
                        let value = fit.value(x, image, angle).unwrap();
                        Vector::new(value.re, value.im)
                    };
                    let (angle, h) = (place.angles[k], 1e-5);
                    assert!((row.residual - value(&unknowns, angle) + fit.targets[k]).norm() < 1e-15);
                    let by = (value(&unknowns, angle + h) - value(&unknowns, angle - h)) / (2.0 * h);
                    assert!((by - row.by_angle).norm() < 1e-7);
                    for (n, exact) in row.by_unknowns.into_iter().enumerate() {
                        let beside = |h: f64| {
                            let mut x = unknowns;
                            x[n] += h;
                            value(&x, angle)
                        };
                        let by = (beside(h) - beside(-h)) / (2.0 * h);
                        assert!((by - exact).norm() < 1e-7, "{chain:?} {n} {by} {exact}");
                    }
                }
            }
        }
    }

    /// Of a path, at a least angle of 80 deg, which most poses lack, and of the input of a four-bar that moves.
    #[test]
    fn lacks_have_the_derivatives_of_differences() {
        for chain in CHAINS {
            let points = vec![[0.2, 0.3], [0.4, 0.1]];
            let task = Task::Path { points, timing: Timing::Steps(vec![0.0, 0.7]) };
            let (bounds, crank) = (Bounds::up_to(5.0), Crank::Turns);
            let problem = Problem { chain, task, bounds, crank, transmission: 1.4 };
            let fit = Fit::new(&problem);
            let place = Place { unknowns: SHAPED, angles: vec![0.0, 0.7], image: IMAGES };
            let lacks = fit.lacks(&place);
            assert!(!lacks.is_empty(), "{chain:?}");
            let squares: f64 = lacks.iter().map(|lack| lack.value * lack.value).sum();
            assert!((squares - fit.lack(&place)).abs() < 1e-15);
            for lack in lacks {
                // The one of the two dyads that this lack is of.
                let own = |excess: &f64| (excess - lack.value).abs() < 1e-12;
                let (angle, h) = (place.angles[lack.row], 1e-5);
                let both = |x: &Unknowns, angle: f64| fit.demands(x, IMAGES, (lack.row, angle)).unwrap();
                let which = both(&SHAPED, angle).iter().position(own).unwrap();
                let by = (both(&SHAPED, angle + h)[which] - both(&SHAPED, angle - h)[which]) / (2.0 * h);
                assert!((by - lack.by_angle).abs() < 1e-7, "{chain:?} {by}");
                for n in 0..UNKNOWNS {
                    let beside = |h: f64| {
                        let mut x = SHAPED;
                        x[n] += h;
                        both(&x, angle)[which]
                    };
                    let by = (beside(h) - beside(-h)) / (2.0 * h);
                    assert!((by - lack.by_unknowns[n]).abs() < 1e-7, "{chain:?} {n} {by}");
                }
            }
        }
    }
}
