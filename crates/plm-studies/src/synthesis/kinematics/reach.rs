//! Workspace and dead points of any mechanism, compiled or from text, from the equations that it runs by.

use nalgebra::{DMatrix, DVector};
use plm_runtime::{AsMoment, Moment, Statics, Vector};

use super::continuation::{Curve, OnCurve, corrected};
use crate::synthesis::four_bar::{Point, unit};
use crate::synthesis::numbers::rank;

/// Border of the workspace in a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach {
    /// Direction from the place of the point, from the x-axis, rad.
    pub direction: f64,
    /// Distance to the border, m; infinite where none was met within 100 sizes of the mechanism.
    pub distance: f64,
    /// Place of the border, m, where there is one.
    pub border: Option<Point>,
}

/// Dead point of a coordinate.
#[derive(Clone, Debug, PartialEq)]
pub struct DeadPoint {
    /// Value of the coordinate, which turns back there, m or rad.
    pub value: f64,
    /// All coordinates, in the order of the declaration, m and rad.
    pub pose: Vec<f64>,
}

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoReach {
    /// No body or coordinate has this name.
    Unknown {
        /// The name.
        name: String,
    },
    /// The mechanism has another mobility than the question asks for.
    Mobility {
        /// Degrees of freedom that it has.
        found: usize,
        /// Degrees of freedom that the question asks for.
        needed: usize,
    },
    /// The pose is singular, or the motion comes to a branch point, where it has no direction.
    Branch,
}

impl std::fmt::Display for NoReach {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Unknown { name } => write!(f, "nothing is called `{name}`"),
            Self::Mobility { found, needed } => {
                write!(f, "{found} degrees of freedom, where the question is of {needed}")
            }
            Self::Branch => f.write_str("a pose from which the motion has no direction of its own"),
        }
    }
}

impl std::error::Error for NoReach {}

/// Constraints of a mechanism where a simulation is, with lengths in units of its size.
struct Constraints<'a, T> {
    state: &'a T,
    /// Unit of each coordinate: the size, or 1 of an angle.
    units: Vec<f64>,
    rows: usize,
}

impl<'a, T: Moment<M: Statics<State = T, S = f64>>> Constraints<'a, T> {
    fn new(state: &'a T) -> Self {
        let mechanism = state.mechanism();
        let size = mechanism.size();
        let units = (0..mechanism.coordinate_names().len()).map(|k| if k % 3 == 2 { 1.0 } else { size });
        Self { state, units: units.collect(), rows: mechanism.row_names().len() }
    }

    /// Coordinates of the state, in units.
    fn start(&self) -> DVector<f64> {
        let full = T::M::full(self.state);
        DVector::from_fn(self.units.len(), |k, _| full.at(k) / self.units[k])
    }

    /// Positions and velocities of the rows at coordinates, with one velocity as 1 or none.
    fn rows(&self, x: &DVector<f64>, moving: Option<usize>) -> [Vec<f64>; 2] {
        let (mechanism, count) = (self.state.mechanism(), self.units.len());
        let own = T::M::full(self.state);
        let full = Vector::from_fn(|k| match k.checked_sub(count) {
            None => x[k] * self.units[k],
            Some(velocity) if velocity < count => {
                if moving == Some(velocity) {
                    self.units[velocity]
                } else {
                    0.0
                }
            }
            _ => own.at(k),
        });
        let multipliers = Vector::from_fn(|_| 0.0);
        let mut values = Vec::new();
        let held = self.state.held();
        mechanism.equations(self.state.time(), &held, &full, &multipliers, &mut |value| values.push(value));
        let part = |from: usize| values.iter().copied().skip(from).take(self.rows).collect();
        [part(count), part(count + self.rows)]
    }

    /// Residuals and their derivatives by the coordinates, with so many columns after them.
    fn equations(&self, x: &DVector<f64>, columns: usize, after: usize) -> (DVector<f64>, DMatrix<f64>) {
        let [residuals, at_rest] = self.rows(x, None);
        let mut by = DMatrix::zeros(self.rows + after, columns);
        for k in 0..self.units.len() {
            let [_, moving] = self.rows(x, Some(k));
            for row in 0..self.rows {
                by[(row, k)] = moving[row] - at_rest[row];
            }
        }
        let mut all = DVector::zeros(self.rows + after);
        all.rows_mut(0, self.rows).copy_from_slice(&residuals);
        (all, by)
    }

    /// Degrees of freedom at the state.
    fn mobility(&self) -> usize {
        let (_, by) = self.equations(&self.start(), self.units.len(), 0);
        self.units.len() - rank(by.clone(), 1e-9 * by.amax().max(f64::MIN_POSITIVE))
    }
}

/// Poses of a mechanism of one degree of freedom.
struct Motion<'a, T>(Constraints<'a, T>);

impl<T: Moment<M: Statics<State = T, S = f64>>> Curve for Motion<'_, T> {
    fn equations(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        self.0.equations(x, self.0.units.len(), 0)
    }
}

/// Poses whose point lies on a ray; the last unknown is the distance.
struct Ray<'a, T> {
    constraints: &'a Constraints<'a, T>,
    /// Index of the body's x.
    body: usize,
    /// Point in the frame of the body, and where the ray begins, in units of the size.
    at: Point,
    from: Point,
    along: Point,
}

impl<T: Moment<M: Statics<State = T, S = f64>>> Ray<'_, T> {
    fn place(&self, x: &DVector<f64>) -> Point {
        let (sin, cos) = x[self.body + 2].sin_cos();
        let [u, v] = self.at;
        [x[self.body] + cos * u - sin * v, x[self.body + 1] + sin * u + cos * v]
    }
}

impl<T: Moment<M: Statics<State = T, S = f64>>> Curve for Ray<'_, T> {
    fn equations(&self, x: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
        let count = self.constraints.units.len();
        let (mut all, mut by) = self.constraints.equations(x, count + 1, 2);
        let (rows, place) = (self.constraints.rows, self.place(x));
        // The arm from the origin of the body, turned by a right angle.
        let arm = [-(place[1] - x[self.body + 1]), place[0] - x[self.body]];
        for k in 0..2 {
            all[rows + k] = place[k] - self.from[k] - x[count] * self.along[k];
            by[(rows + k, self.body + k)] = 1.0;
            by[(rows + k, self.body + 2)] = arm[k];
            by[(rows + k, count)] = -self.along[k];
        }
        (all, by)
    }
}

/// Border of the workspace of a point of a body, of a mechanism with two degrees of freedom: in so many directions from where the point is,
/// the place at which it turns back on a straight way. Velocities of the point along the way vanish there: a singularity of the first kind
/// (Gosselin and Angeles, 1990). Of a workspace that is not seen whole from the point, ask from several places.
///
/// The motion along each way is followed by arc length through `phi(q) = 0`, with the derivatives that the equations give; drives are no
/// degrees of freedom, so the mechanism has none for its two. Contacts and stops are ignored.
///
/// # Errors
/// [`NoReach`].
pub fn workspace<A, T>(of: &A, body: &str, at: Point, directions: usize) -> Result<Vec<Reach>, NoReach>
where
    A: AsMoment<State = T>,
    T: Moment<M: Statics<State = T, S = f64>>,
{
    let constraints = Constraints::new(of.as_moment());
    let body = coordinate(of.as_moment(), &format!("{body}.x"))
        .ok_or_else(|| NoReach::Unknown { name: body.to_owned() })?;
    needs(&constraints, 2)?;
    let size = of.as_moment().mechanism().size();
    let start = constraints.start();
    let ray = |number: usize| {
        let direction = std::f64::consts::TAU * number as f64 / directions as f64;
        let along = unit(direction);
        let mut ray = Ray {
            constraints: &constraints,
            body,
            at: at.map(|x| x / size),
            from: [0.0; 2],
            along: [along.re, along.im],
        };
        ray.from = ray.place(&start);
        let distance = end_of(&ray, &start)? * size;
        let place = [0, 1].map(|k| ray.from[k] * size + distance * ray.along[k]);
        Ok(Reach { direction, distance, border: distance.is_finite().then_some(place) })
    };
    (0..directions).map(ray).collect()
}

/// Distance at which the point turns back on a ray, in units of the size.
fn end_of<T: Moment<M: Statics<State = T, S = f64>>>(
    ray: &Ray<'_, T>,
    start: &DVector<f64>,
) -> Result<f64, NoReach> {
    let last = start.len();
    let begin = start.clone().push(0.0);
    let mut like = DVector::zeros(last + 1);
    like[last] = 1.0;
    let mut here = OnCurve::new(ray, begin, &like).ok_or(NoReach::Branch)?;
    while here.x[last] < 100.0 {
        let (next, length) = here.next(ray).ok_or(NoReach::Branch)?;
        if next.way[last] <= 0.0 {
            return Ok(here.turn(ray, length, last).ok_or(NoReach::Branch)?.x[last]);
        }
        here = next;
    }
    Ok(f64::INFINITY)
}

/// Steps of a motion, at most: 2000 sizes of the mechanism, or as many radians.
const MOST_STEPS: usize = 100_000;

/// Dead points of a coordinate, as `crank.angle`, along the whole motion of a mechanism with one degree of freedom: poses at which the
/// coordinate turns back while the others go on, so that a drive of it cannot go on. The motion is followed by arc length from where
/// the simulation is until it comes back, through dead points of all kinds; one that has an end, or goes on without one, is followed in
/// one direction and then has those of 2000 sizes or radians.
///
/// # Errors
/// [`NoReach`].
pub fn dead_points<A, T>(of: &A, name: &str) -> Result<Vec<DeadPoint>, NoReach>
where
    A: AsMoment<State = T>,
    T: Moment<M: Statics<State = T, S = f64>>,
{
    let state = of.as_moment();
    let constraints = Constraints::new(state);
    let index = coordinate(state, name).ok_or_else(|| NoReach::Unknown { name: name.to_owned() })?;
    needs(&constraints, 1)?;
    let motion = Motion(constraints);
    let units = motion.0.units.clone();
    let start = corrected(&motion, motion.0.start()).ok_or(NoReach::Branch)?;
    let mut here = OnCurve::new(&motion, start.clone(), &start).ok_or(NoReach::Branch)?;
    let first = here.way.clone();
    let mut found = Vec::new();
    let mut away = false;
    for _ in 0..MOST_STEPS {
        let (next, length) = here.next(&motion).ok_or(NoReach::Branch)?;
        if next.way[index] * here.way[index] < 0.0 {
            let turn = here.turn(&motion, length, index).ok_or(NoReach::Branch)?;
            let pose: Vec<f64> = turn.x.iter().zip(&units).map(|(x, unit)| x * unit).collect();
            found.push(DeadPoint { value: pose[index], pose });
        }
        here = next;
        let off = DVector::from_fn(units.len(), |k, _| {
            let off = here.x[k] - start[k];
            if k % 3 == 2 { off.sin().atan2(off.cos()) } else { off }
        });
        let is_near = off.norm() < 2.0 * length && here.way.dot(&first) > 0.9;
        // Back, and past the start.
        if is_near && away && off.dot(&here.way) >= 0.0 {
            break;
        }
        away |= off.norm() > 0.1;
    }
    Ok(found)
}

fn coordinate<T: Moment<M: Statics<State = T, S = f64>>>(state: &T, name: &str) -> Option<usize> {
    state.mechanism().coordinate_names().iter().position(|known| *known == name)
}

fn needs<T: Moment<M: Statics<State = T, S = f64>>>(
    of: &Constraints<'_, T>,
    needed: usize,
) -> Result<(), NoReach> {
    let found = of.mobility();
    if found == needed { Ok(()) } else { Err(NoReach::Mobility { found, needed }) }
}
