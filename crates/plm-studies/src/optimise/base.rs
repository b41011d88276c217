//! Base inertia parameters: the combinations of masses, centres of gravity and moments of inertia that forces of a motion determine (M.
//! Gautier, Numerical calculation of the base inertial parameters of robots, Journal of Robotic Systems 8, 1991).
//!
//! Inverse dynamics is linear in mass, first moments and moment of inertia of each body. The rank of this linear function over many states
//! is the number of combinations, and elimination finds them.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use plm_runtime::{Cause, Described, Dual, Fault, Linear, Mechanism, Moment, Vector};

use crate::optimise::mechanism::{LANES, Lifted, Number, Optimisable};
use crate::optimise::node::own_numbers;

/// Inertia parameters of a body, in the order of the columns.
const PARAMETERS: [&str; 4] = ["mass", "moment.x", "moment.y", "inertia"];

/// Combinations of inertia parameters that forces of a motion determine.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseParameters {
    /// The combinations: names of parameters and their factors, the first of which is 1.
    pub combinations: Vec<Vec<(String, f64)>>,
    /// Parameters that change no force.
    pub without_effect: Vec<String>,
}

/// A line for each combination: `crank.inertia + 0.01 rod.mass`.
impl fmt::Display for BaseParameters {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for combination in &self.combinations {
            for (k, (name, factor)) in combination.iter().enumerate() {
                if k > 0 {
                    write!(f, " {} {:.6} ", if *factor < 0.0 { '-' } else { '+' }, factor.abs())?;
                }
                f.write_str(name)?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

/// States at which the forces are taken.
const STATES: usize = 40;
/// Singular values below this fraction of the largest count as zero.
const RANK_TOLERANCE: f64 = 1e-9;

/// Finds the base inertia parameters of a mechanism in a gravity, m/s^2: of each body `arm.mass`, the first moments `arm.moment.x` and
/// `arm.moment.y` about its declared centre of gravity in its axes, and `arm.inertia` about that point. Known are the forces along all its
/// freedoms.
///
/// # Errors
/// The fault of assembly; [`Cause::NotFinite`] of a gravity that is no number.
pub fn base_parameters<M: Optimisable>(mechanism: &M, gravity: [f64; 2]) -> Result<BaseParameters, Fault> {
    if !gravity.iter().all(|number| number.is_finite()) {
        return Err(Fault::new(0.0, Cause::NotFinite));
    }
    let (held, x) = mechanism.start_state(0.0)?;
    let bodies = mechanism.tables().bodies;
    let names: Vec<String> =
        bodies.iter().flat_map(|body| PARAMETERS.map(|own| format!("{}.{own}", body.name))).collect();
    let mut rows = DMatrix::zeros(0, names.len());
    let mut random = Random(1);
    for _ in 0..STATES {
        let Some(state) = beside(mechanism, (&held, &x), &mut random) else { continue };
        let block = forces(mechanism, (&held, &state), gravity, &mut random);
        // Beyond the range of numbers a state has no information, and decompositions do not end.
        if !block.iter().all(|force| force.is_finite()) {
            continue;
        }
        let first = rows.nrows();
        rows = rows.insert_rows(first, block.nrows(), 0.0);
        rows.rows_mut(first, block.nrows()).copy_from(&block);
    }
    Ok(reduced(&rows, &names))
}

/// Numbers within -1 and 1 (D. E. Knuth, The Art of Computer Programming 2, 3rd ed., 3.3.4: the multiplier of C. Haynes).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A state near another one, on the constraints; none where the joints do not close.
fn beside<M: Optimisable>(mechanism: &M, (held, x): (&M::U, &M::X), random: &mut Random) -> Option<M::X> {
    let (own, sizes) = own_numbers(mechanism);
    for reach in [1.0, 0.3, 0.1] {
        let mut moved = *x;
        for (place, size) in own.iter().zip(&sizes) {
            moved.set(*place, x.at(*place) + reach * size.min(1.0) * random.next());
        }
        let is_closed = mechanism.project(0.0, held, &mut moved).is_ok() && {
            let open = mechanism.opening(0.0, held, &moved);
            open.phi.abs() < 1e-8 && open.phi_dot.abs() < 1e-6 && moved.is_finite()
        };
        let mut rate = moved;
        if is_closed && mechanism.rate(0.0, held, &moved, &mut rate).is_good() && rate.is_finite() {
            return Some(moved);
        }
    }
    None
}

/// Poses and velocities of all bodies with their change along a direction of time and state; and the change of the constraints.
fn along<M: Optimisable>(
    mechanism: &M,
    (held, x): (&M::U, &M::X),
    dt: f64,
    dx: &DVector<f64>,
) -> (Vec<[Number; 6]>, Vec<f64>) {
    let (lifted, held) = mechanism.lift::<LANES>(held);
    let number = |value, tangent| Dual { value, tangents: [tangent, 0.0, 0.0, 0.0] };
    let moved = Vector::from_fn(|place| number(x.at(place), dx[place]));
    let time = number(0.0, dt);
    let mut open = Vec::new();
    lifted.constraints(time, &moved, &mut |row: Number| open.push(row.tangents[0]));
    let mut poses = Vec::new();
    let state = <<Lifted<M> as Mechanism>::State as Moment>::new(lifted, held, time, moved);
    <Lifted<M> as Described>::poses(&state, &mut |pose| poses.push(pose.components()));
    (poses, open)
}

/// Forces along the freedoms at a state, of unit inertia parameters of each body: a row for each freedom.
fn forces<M: Optimisable>(
    mechanism: &M,
    (held, x): (&M::U, &M::X),
    [gx, gy]: [f64; 2],
    random: &mut Random,
) -> DMatrix<f64> {
    let length = <M::X as Vector<f64>>::LEN;
    let velocities: Vec<usize> = (M::NQ..2 * M::NQ).filter(|place| mechanism.has_number(*place)).collect();
    let unit = |place: usize| DVector::from_fn(length, |k, _| if k == place { 1.0 } else { 0.0 });
    let each: Vec<_> =
        velocities.iter().map(|place| along(mechanism, (held, x), 0.0, &unit(*place))).collect();
    let rows = each.first().map_or(0, |(_, open)| open.len());
    let free = freedoms(&DMatrix::from_fn(rows, velocities.len(), |i, k| each[k].1[i]));
    // An acceleration that the constraints allow: that of the motion, and any along the freedoms.
    let mut rate = *x;
    mechanism.rate(0.0, held, x, &mut rate);
    let mut dx = DVector::from_fn(length, |k, _| rate.at(k));
    let more = &free * DVector::from_fn(free.ncols(), |_, _| 10.0 * random.next());
    for (k, place) in velocities.iter().enumerate() {
        dx[*place] += more[k];
    }
    let (motion, _) = along(mechanism, (held, x), 1.0, &dx);
    let mut block = DMatrix::zeros(free.ncols(), PARAMETERS.len() * motion.len());
    for (body, pose) in motion.iter().enumerate() {
        let [_, _, angle, vx, vy, omega] = pose;
        let (sin, cos) = angle.value.sin_cos();
        let [ax, ay, alpha] = [vx, vy, omega].map(|speed| speed.tangents[0]);
        let (ax, ay, square) = (ax - gx, ay - gy, omega.value * omega.value);
        for freedom in 0..free.ncols() {
            let speed = |component: usize| -> f64 {
                (0..velocities.len())
                    .map(|k| free[(k, freedom)] * each[k].0[body][component].tangents[0])
                    .sum()
            };
            let [dx, dy, turn] = [3, 4, 5].map(speed);
            // m (a - g) at G; of first moments h = R (hx, hy): alpha x h - omega^2 h at G, and h x (a - g) about it.
            let moment = |c: f64, s: f64| {
                dx * (-alpha * s - square * c) + dy * (alpha * c - square * s) + turn * (c * ay - s * ax)
            };
            let own = [dx * ax + dy * ay, moment(cos, sin), moment(-sin, cos), turn * alpha];
            for (k, force) in own.into_iter().enumerate() {
                block[(freedom, PARAMETERS.len() * body + k)] = force;
            }
        }
    }
    block
}

/// Directions of velocities along which no constraint changes; all of them where there is none.
fn freedoms(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let size = rows.ncols();
    let square = rows.tr_mul(rows);
    if !square.iter().all(|entry| entry.is_finite()) {
        return DMatrix::zeros(size, 0);
    }
    let square = square.symmetric_eigen();
    let largest = square.eigenvalues.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let free: Vec<_> = (0..size)
        .filter(|k| square.eigenvalues[*k].abs() <= 1e-12 * largest)
        .map(|k| square.eigenvectors.column(k))
        .collect();
    if free.is_empty() { DMatrix::zeros(size, 0) } else { DMatrix::from_columns(&free) }
}

/// The combinations that rows determine: columns that depend on those before them add to their combinations.
fn reduced(rows: &DMatrix<f64>, names: &[String]) -> BaseParameters {
    let largest = rows.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    // The squares of norms stay in the range of numbers.
    let rows = &(rows / largest.max(f64::MIN_POSITIVE));
    let scale = 1.0;
    let (mut basis, mut chosen): (Vec<DVector<f64>>, Vec<usize>) = (Vec::new(), Vec::new());
    let (mut combinations, mut without_effect) = (Vec::<Vec<(String, f64)>>::new(), Vec::new());
    // Masses last: they are counted with the first moments and the moments of inertia.
    let order = [3, 1, 2, 0].into_iter().flat_map(|kind| (kind..names.len()).step_by(PARAMETERS.len()));
    for column in order {
        let own = rows.column(column).into_owned();
        if own.norm() <= RANK_TOLERANCE * scale {
            without_effect.push(names[column].clone());
            continue;
        }
        let mut rest = own.clone();
        for _ in 0..2 {
            for direction in &basis {
                rest.axpy(-direction.dot(&rest), direction, 1.0);
            }
        }
        if rest.norm() > RANK_TOLERANCE * own.norm().max(scale) {
            basis.push(rest.normalize());
            chosen.push(column);
            combinations.push(vec![(names[column].clone(), 1.0)]);
            continue;
        }
        let matrix = DMatrix::from_columns(&chosen.iter().map(|k| rows.column(*k)).collect::<Vec<_>>());
        let Ok(factors) = matrix.svd(true, true).solve(&own, 0.0) else { continue };
        for (combination, factor) in combinations.iter_mut().zip(factors.iter()) {
            if factor.abs() > 1e-7 {
                combination.push((names[column].clone(), *factor));
            }
        }
    }
    BaseParameters { combinations, without_effect }
}
