//! One look at a point: how far it is from rest, and the step that is said to lead there.
//!
//! Three things are wanted, each as far as those before it allow: the joints stay closed; forces balance, with what locks
//! have to give, and states that are free come to rest; locks need no force, and states that are locked come to rest by
//! themselves. Of all steps that do so the shortest is taken.

use std::vec::Vec;

use nalgebra::{DMatrix, DVector};

use super::Stabilise;
use super::invariant::{following, rates_along};
use super::rank::{Ranked, null_space};
use super::rest::{Point, Rest, Rows};
use super::scales::{Locks, Scales};

/// The mechanism, and what does not change on the way.
pub(super) struct Task<M: Stabilise> {
    pub(super) rest: Rest<M>,
    pub(super) scales: Scales,
    pub(super) locks: Locks,
    /// States that follow the coordinates, by index.
    pub(super) follows: Vec<bool>,
    /// States that are moved, by index.
    pub(super) free: Vec<usize>,
}

impl<M: Stabilise> Task<M> {
    pub(super) fn new(rest: Rest<M>, start: &Point) -> Option<Self> {
        let scales = Scales::of(&rest, start);
        let locks = Locks::of(*rest.mechanism());
        let mut task = Self { rest, scales, locks, follows: Vec::new(), free: Vec::new() };
        task.follows = task.following(start)?;
        task.free = (0..Rest::<M>::NX).filter(|i| !task.locks.x[*i] && !task.follows[*i]).collect();
        Some(task)
    }

    /// States that follow coordinates which can move.
    fn following(&self, start: &Point) -> Option<Vec<bool>> {
        let follows = following(&self.rest, start, &self.scales);
        let all = rates_along(&self.rest, start, &DMatrix::from_diagonal(&self.scales.q));
        let left = rates_along(&self.rest, start, &self.ways(&self.rest.by_q(start))?);
        let moves = |i: usize| left.row(i).norm() > 1e-9 * all.row(i).norm();
        Some((0..follows.len()).map(|i| follows[i] && !self.locks.x[i] && moves(i)).collect())
    }

    /// Directions that joints and locks leave, in columns: m and rad.
    fn ways(&self, by_q: &Rows<DMatrix<f64>>) -> Option<DMatrix<f64>> {
        let size = Rest::<M>::NQ;
        let mut rows = scaled(&by_q.phi, |_| 1.0 / self.scales.length, |j| self.scales.q[j]);
        let locked: Vec<usize> = (0..size).filter(|k| self.locks.q[*k]).collect();
        let first = rows.nrows();
        rows = rows.resize_vertically(first + locked.len(), 0.0);
        for (k, column) in locked.iter().enumerate() {
            rows.column_mut(*column).fill(0.0);
            rows[(first + k, *column)] = 1.0;
        }
        Some(DMatrix::from_diagonal(&self.scales.q) * null_space(&rows)?)
    }

    /// Locked coordinates.
    pub(super) fn locked(&self) -> Vec<usize> {
        (0..Rest::<M>::NQ).filter(|k| self.locks.q[*k]).collect()
    }

    /// Closes the joints by the shortest way that leaves locks alone; false if they stay open.
    pub(super) fn close(&self, point: &mut Point) -> Option<bool> {
        let closed = 1e-13 * self.scales.length.max(1.0);
        let (mut gap, mut phi) = (f64::INFINITY, self.rest.rows(point).phi);
        for _ in 0..30 {
            if phi.amax() <= closed || phi.is_empty() || phi.amax() >= gap {
                break;
            }
            gap = phi.amax();
            let column = |j: usize| if self.locks.q[j] { 0.0 } else { self.scales.q[j] };
            let rows = scaled(&self.rest.by_q(point).phi, |_| 1.0, column);
            let step = Ranked::new(&rows)?.solve(&phi);
            let before = point.q.clone();
            for j in 0..step.len() {
                point.q[j] -= column(j) * step[j];
            }
            phi = self.rest.rows(point).phi;
            // At rounding the last step may have made it worse.
            if phi.amax() > gap {
                point.q = before;
                phi = self.rest.rows(point).phi;
                break;
            }
        }
        Some(phi.is_empty() || phi.amax() <= 1e3 * closed)
    }
}

/// What is seen at a point.
pub(super) struct Look {
    /// The point, with the multipliers that balance best.
    pub(super) point: Point,
    /// Forces that nothing balances, N and N m by coordinate.
    pub(super) unbalanced: DVector<f64>,
    /// Forces that the locks have to give, N and N m by locked coordinate.
    pub(super) of_locks: DVector<f64>,
    /// Rates of all first-order states.
    pub(super) rate: DVector<f64>,
    /// What a scaled unit of an unknown does to each rate at most.
    pub(super) rate_scale: DVector<f64>,
    /// Unbalanced forces and rates of free states, scaled.
    pub(super) first: f64,
    /// Forces of locks and rates of locked states, scaled.
    pub(super) second: f64,
    /// The step: coordinates (m, rad) and states.
    pub(super) step: (DVector<f64>, DVector<f64>),
    /// Its largest scaled entry.
    pub(super) length: f64,
    /// Along the unbalanced forces: coordinates by one scaled unit at most.
    pub(super) pushed: DVector<f64>,
    /// Scaled directions of coordinates and states along which nothing changes, in columns.
    pub(super) free: DMatrix<f64>,
}

impl Look {
    /// At a point with closed joints.
    pub(super) fn at<M: Stabilise>(task: &Task<M>, mut point: Point) -> Option<Self> {
        let Task { rest, scales, .. } = task;
        // Multipliers and forces of locks that balance best; both enter linearly.
        let locked = task.locked();
        let carried = carried(task, &rest.by_lambda(&point), &locked);
        let inverse = Ranked::new(&carried.matrix)?;
        let residual = rest.rows(&point).force.component_div(&scales.force);
        let reactions = -inverse.solve(&residual);
        let balance = &residual + &carried.matrix * &reactions;
        point.lambda += reactions.rows(0, Rest::<M>::NC).component_mul(&carried.sizes);
        let of_locks = reactions.rows(Rest::<M>::NC, locked.len()).into_owned();

        let (by_q, by_x) = (rest.by_q(&point), rest.by_x(&point));
        let moves = Moves::new(task, &point, task.ways(&by_q)?);
        let rows = rest.rows(&point);
        // How forces, reactions and rates change.
        let force =
            scaled(&(&by_q.force * &moves.q + &by_x.force * &moves.x), |i| 1.0 / scales.force[i], |_| 1.0);
        let reaction = -inverse.solve_all(&force);
        let by_reaction = &carried.rates * &reaction;
        let rate = &by_q.rate * &moves.q + &by_x.rate * &moves.x + by_reaction;
        let rate_scale = DVector::from_fn(Rest::<M>::NX, |i, _| rate.row(i).amax().max(1e-9 * scales.x[i]));
        let rate_change = scaled(&rate, |i| 1.0 / rate_scale[i], |_| 1.0);
        let rate_left = rows.rate.component_div(&rate_scale);

        let left = null_space(&carried.matrix.transpose())?.transpose();
        let held: Vec<usize> = (0..Rest::<M>::NX).filter(|i| task.locks.x[*i]).collect();
        let first = Level::new(
            [&(&left * &force), &rate_change.select_rows(&task.free)],
            [&(&left * &balance), &rate_left.select_rows(&task.free)],
        );
        let second = Level::new(
            [&reaction.rows(Rest::<M>::NC, locked.len()).into_owned(), &rate_change.select_rows(&held)],
            [&of_locks, &rate_left.select_rows(&held)],
        );
        let (unknowns, rest_free) = solve(&first, &second)?;
        let along = |of: &DMatrix<f64>| of * &unknowns;
        let step = (along(&moves.q), along(&moves.x));
        let size = scaled_amax(&step.0, &scales.q).max(scaled_amax(&step.1, &scales.x));
        let free = moves.scaled(scales) * rest_free;
        let unbalanced = balance.component_mul(&scales.force);
        Some(Self {
            pushed: along_forces(&moves.q, &-&unbalanced, &scales.q),
            unbalanced,
            of_locks: DVector::from_fn(locked.len(), |k, _| -of_locks[k] * scales.force[locked[k]]),
            rate: rows.rate,
            rate_scale,
            first: first.residual.norm(),
            second: second.residual.norm(),
            step,
            length: size,
            free,
            point,
        })
    }
}

/// What joints and locks can carry: scaled columns by multiplier and by lock.
struct Carried {
    /// Forces on the coordinates.
    matrix: DMatrix<f64>,
    /// Changes of rates.
    rates: DMatrix<f64>,
    /// One scaled unit of each multiplier.
    sizes: DVector<f64>,
}

fn carried<M: Stabilise>(task: &Task<M>, by_lambda: &Rows<DMatrix<f64>>, locked: &[usize]) -> Carried {
    let (nq, nc) = (Rest::<M>::NQ, Rest::<M>::NC);
    let force = scaled(&by_lambda.force, |i| 1.0 / task.scales.force[i], |_| 1.0);
    let sizes = DVector::from_fn(nc, |j, _| {
        let largest = force.column(j).amax();
        if largest > 0.0 { 1.0 / largest } else { 1.0 }
    });
    let mut matrix = DMatrix::zeros(nq, nc + locked.len());
    let mut rates = DMatrix::zeros(Rest::<M>::NX, nc + locked.len());
    for j in 0..nc {
        matrix.set_column(j, &(force.column(j) * sizes[j]));
        rates.set_column(j, &(by_lambda.rate.column(j) * sizes[j]));
    }
    for (k, coordinate) in locked.iter().enumerate() {
        matrix[(*coordinate, nc + k)] = 1.0;
    }
    Carried { matrix, rates, sizes }
}

/// What the unknowns move, in columns: first ways of the coordinates with the states that follow, then free states.
struct Moves {
    q: DMatrix<f64>,
    x: DMatrix<f64>,
}

impl Moves {
    fn new<M: Stabilise>(task: &Task<M>, point: &Point, ways: DMatrix<f64>) -> Self {
        let (count, states) = (ways.ncols(), task.free.len());
        let mut x = rates_along(&task.rest, point, &ways).resize_horizontally(count + states, 0.0);
        for i in (0..x.nrows()).filter(|i| !task.follows[*i]) {
            x.row_mut(i).fill(0.0);
        }
        for (k, i) in task.free.iter().enumerate() {
            x[(*i, count + k)] = task.scales.x[*i];
        }
        Self { q: ways.resize_horizontally(count + states, 0.0), x }
    }

    /// Coordinates over states, scaled.
    fn scaled(&self, scales: &Scales) -> DMatrix<f64> {
        let (nq, nx) = (self.q.nrows(), self.x.nrows());
        DMatrix::from_fn(nq + nx, self.q.ncols(), |i, j| {
            if i < nq { self.q[(i, j)] / scales.q[i] } else { self.x[(i - nq, j)] / scales.x[i - nq] }
        })
    }
}

/// Equations of one rank of importance: change * unknowns = -residual.
struct Level {
    change: DMatrix<f64>,
    residual: DVector<f64>,
}

impl Level {
    fn new(change: [&DMatrix<f64>; 2], residual: [&DVector<f64>; 2]) -> Self {
        let above = change[0].nrows();
        let entry =
            |i: usize, j: usize| if i < above { change[0][(i, j)] } else { change[1][(i - above, j)] };
        let left = |i: usize| if i < above { residual[0][i] } else { residual[1][i - above] };
        let rows = above + change[1].nrows();
        Self {
            change: DMatrix::from_fn(rows, change[0].ncols(), entry),
            residual: DVector::from_fn(rows, |i, _| left(i)),
        }
    }
}

/// The shortest unknowns that solve the first level, and the second as far as that leaves room; and what both leave free.
fn solve(first: &Level, second: &Level) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let ranked = Ranked::new(&first.change)?;
    let (mut unknowns, room) = (-ranked.solve(&first.residual), ranked.null_space());
    let ranked = Ranked::new(&(&second.change * &room))?;
    unknowns -= &room * ranked.solve(&(&second.residual + &second.change * &unknowns));
    Some((unknowns, room * ranked.null_space()))
}

/// Coordinates moved along what `forces` do, by one scaled unit at most; not at all where they do nothing.
fn along_forces(ways: &DMatrix<f64>, forces: &DVector<f64>, sizes: &DVector<f64>) -> DVector<f64> {
    let moved = ways * (ways.transpose() * forces);
    let size = scaled_amax(&moved, sizes);
    if size > 0.0 { moved / size } else { moved }
}

/// A matrix with factors for its rows and columns.
fn scaled(matrix: &DMatrix<f64>, row: impl Fn(usize) -> f64, column: impl Fn(usize) -> f64) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| row(i) * matrix[(i, j)] * column(j))
}

fn scaled_amax(values: &DVector<f64>, sizes: &DVector<f64>) -> f64 {
    if values.is_empty() { 0.0 } else { values.component_div(sizes).amax() }
}
