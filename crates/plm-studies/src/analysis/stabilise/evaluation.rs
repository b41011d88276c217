//! Evaluation of a point: its distance from equilibrium, and the step of the iteration towards it.
//!
//! Three things are wanted, each as far as those before it allow: the joints stay closed; forces balance, with what locks
//! have to give, and states that are free come to rest; locks need no force, and states that are locked, or that nothing
//! reads, come to rest by themselves. Of all steps that do so the shortest is taken.

use nalgebra::{DMatrix, DVector};

use super::Stabilise;
use super::dependent_states::{following, rates_along, unread};
use super::rank::{Ranked, null_space};
use super::residuals::{Point, Residuals, Rows};
use super::scales::{Locks, Scales};

/// The equations of a search, and what is constant during it.
pub(super) struct Task<M: Stabilise> {
    pub(super) residuals: Residuals<M>,
    pub(super) scales: Scales,
    pub(super) locks: Locks,
    /// States that follow the coordinates, by index.
    pub(super) follows: Vec<bool>,
    /// States that are moved, by index.
    pub(super) free: Vec<usize>,
    /// States that stay, by index: locked ones, and integrals that nothing reads.
    pub(super) fixed: Vec<usize>,
}

impl<M: Stabilise> Task<M> {
    pub(super) fn new(residuals: Residuals<M>, start: &Point) -> Option<Self> {
        let scales = Scales::of(&residuals, start);
        let locks = Locks::of(*residuals.mechanism());
        let mut task =
            Self { residuals, scales, locks, follows: Vec::new(), free: Vec::new(), fixed: Vec::new() };
        task.follows = task.following(start)?;
        let unread = unread(&task.residuals, start, &task.scales);
        let others = (0..task.residuals.nx()).filter(|i| !task.follows[*i]);
        (task.fixed, task.free) = others.partition(|i| task.locks.x[*i] || unread[*i]);
        Some(task)
    }

    /// States that follow coordinates which can move.
    fn following(&self, start: &Point) -> Option<Vec<bool>> {
        let follows = following(&self.residuals, start, &self.scales);
        let all = rates_along(&self.residuals, start, &DMatrix::from_diagonal(&self.scales.q));
        let left = rates_along(&self.residuals, start, &self.ways(&self.residuals.by_q(start))?);
        let moves = |i: usize| left.row(i).norm() > 1e-9 * all.row(i).norm();
        Some((0..follows.len()).map(|i| follows[i] && !self.locks.x[i] && moves(i)).collect())
    }

    /// Directions that joints and locks leave, in columns: m and rad.
    fn ways(&self, by_q: &Rows<DMatrix<f64>>) -> Option<DMatrix<f64>> {
        let size = self.residuals.nq();
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
        (0..self.residuals.nq()).filter(|k| self.locks.q[*k]).collect()
    }

    /// Closes the joints by the shortest way that leaves locks alone; false if they stay open.
    pub(super) fn close(&self, point: &mut Point) -> Option<bool> {
        let closed = 1e-13 * self.scales.length.max(1.0);
        let (mut gap, mut phi) = (f64::INFINITY, self.residuals.rows(point).phi);
        for _ in 0..30 {
            if phi.amax() <= closed || phi.is_empty() || phi.amax() >= gap {
                break;
            }
            gap = phi.amax();
            let column = |j: usize| if self.locks.q[j] { 0.0 } else { self.scales.q[j] };
            let rows = scaled(&self.residuals.by_q(point).phi, |_| 1.0, column);
            let step = Ranked::new(&rows)?.solve(&phi);
            let before = point.q.clone();
            for j in 0..step.len() {
                point.q[j] -= column(j) * step[j];
            }
            phi = self.residuals.rows(point).phi;
            // At rounding the last step may have made it worse.
            if phi.amax() > gap {
                point.q = before;
                phi = self.residuals.rows(point).phi;
                break;
            }
        }
        Some(phi.is_empty() || phi.amax() <= 1e3 * closed)
    }
}

/// Residuals, forces and the next step at a point.
pub(super) struct Evaluation {
    /// The point, with the multipliers that balance best.
    pub(super) point: Point,
    /// Forces that nothing balances, N and N m by coordinate.
    pub(super) unbalanced: DVector<f64>,
    /// Forces that the locks have to give, N and N m by locked coordinate.
    pub(super) of_locks: Vec<f64>,
    /// Rates of all first-order states.
    pub(super) rate: DVector<f64>,
    /// Largest change of each rate by a scaled unit of an unknown.
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

impl Evaluation {
    /// At a point with closed joints.
    pub(super) fn at<M: Stabilise>(task: &Task<M>, mut point: Point) -> Option<Self> {
        let Task { residuals, scales, .. } = task;
        let balance = Balance::at(task, &mut point)?;
        let by_q = residuals.by_q(&point);
        let moves = Moves::new(task, &point, task.ways(&by_q)?);
        let rate = residuals.rows(&point).rate;
        let (levels, rate_scale) = balance.levels(task, &moves, (&by_q, &residuals.by_x(&point)), &rate);
        let (unknowns, room) = levels.solve()?;
        let step = (&moves.q * &unknowns, &moves.x * &unknowns);
        let unbalanced = balance.left.component_mul(&scales.force);
        let of_lock = |(force, k): (&f64, &usize)| -force * scales.force[*k];
        let of_locks: Vec<f64> = balance.of_locks.iter().zip(&task.locked()).map(of_lock).collect();
        Some(Self {
            pushed: along_forces(&moves.q, &-&unbalanced, &scales.q),
            unbalanced,
            of_locks,
            rate,
            rate_scale,
            first: levels.0[0].residual.norm(),
            second: levels.0[1].residual.norm(),
            length: scaled_amax(&step.0, &scales.q).max(scaled_amax(&step.1, &scales.x)),
            step,
            free: moves.scaled(scales) * room,
            point,
        })
    }
}

/// Forces and what joints and locks carry of them, scaled.
struct Balance {
    /// Derivatives of the forces on the coordinates by the multipliers and the forces of locks, in columns.
    carries: DMatrix<f64>,
    /// Derivatives of the rates by them.
    rates: DMatrix<f64>,
    /// The inverse of the first.
    inverse: Ranked,
    /// Forces that nothing carries.
    left: DVector<f64>,
    /// Forces that locks carry.
    of_locks: DVector<f64>,
}

impl Balance {
    /// Gives the point the multipliers that balance best: they, and the forces of locks, enter linearly.
    fn at<M: Stabilise>(task: &Task<M>, point: &mut Point) -> Option<Self> {
        let (nq, nc, locked) = (task.residuals.nq(), task.residuals.nc(), task.locked());
        let by_lambda = task.residuals.by_lambda(point);
        let force = scaled(&by_lambda.force, |i| 1.0 / task.scales.force[i], |_| 1.0);
        let sizes = DVector::from_fn(nc, |j, _| match force.column(j).amax() {
            0.0 => 1.0,
            largest => 1.0 / largest,
        });
        let mut carries = DMatrix::zeros(nq, nc + locked.len());
        let mut rates = DMatrix::zeros(task.residuals.nx(), nc + locked.len());
        for j in 0..nc {
            carries.set_column(j, &(force.column(j) * sizes[j]));
            rates.set_column(j, &(by_lambda.rate.column(j) * sizes[j]));
        }
        for (k, coordinate) in locked.iter().enumerate() {
            carries[(*coordinate, nc + k)] = 1.0;
        }
        let inverse = Ranked::new(&carries)?;
        let forces = task.residuals.rows(point).force.component_div(&task.scales.force);
        let reactions = -inverse.solve(&forces);
        point.lambda += reactions.rows(0, nc).component_mul(&sizes);
        let left = forces + &carries * &reactions;
        Some(Self { carries, rates, inverse, left, of_locks: reactions.rows(nc, locked.len()).into_owned() })
    }

    /// The equations in their order of importance, and what a scaled unit of an unknown does to each rate at most.
    fn levels<M: Stabilise>(
        &self,
        task: &Task<M>,
        moves: &Moves,
        (by_q, by_x): (&Rows<DMatrix<f64>>, &Rows<DMatrix<f64>>),
        rate: &DVector<f64>,
    ) -> (Levels, DVector<f64>) {
        let Task { scales, free, fixed, .. } = task;
        let force = &by_q.force * &moves.q + &by_x.force * &moves.x;
        let force = scaled(&force, |i| 1.0 / scales.force[i], |_| 1.0);
        let reaction = -self.inverse.solve_all(&force);
        let change = &by_q.rate * &moves.q + &by_x.rate * &moves.x + &self.rates * &reaction;
        let sizes = DVector::from_fn(rate.len(), |i, _| change.row(i).amax().max(1e-9 * scales.x[i]));
        let change = scaled(&change, |i| 1.0 / sizes[i], |_| 1.0);
        let left = rate.component_div(&sizes);
        // What joints and locks do not carry of a change of the forces.
        let uncarried = &force + &self.carries * &reaction;
        let of_locks = reaction.rows(task.residuals.nc(), self.of_locks.len()).into_owned();
        let first =
            Level::new([&uncarried, &change.select_rows(free)], [&self.left, &left.select_rows(free)]);
        let second =
            Level::new([&of_locks, &change.select_rows(fixed)], [&self.of_locks, &left.select_rows(fixed)]);
        (Levels([first, second]), sizes)
    }
}

/// Directions of the unknowns, in columns: first ways of the coordinates with the states that follow, then free states.
struct Moves {
    q: DMatrix<f64>,
    x: DMatrix<f64>,
}

impl Moves {
    fn new<M: Stabilise>(task: &Task<M>, point: &Point, ways: DMatrix<f64>) -> Self {
        let (count, states) = (ways.ncols(), task.free.len());
        let mut x = rates_along(&task.residuals, point, &ways).resize_horizontally(count + states, 0.0);
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

/// Equations in their order of importance.
struct Levels([Level; 2]);

impl Levels {
    /// The shortest unknowns that solve the first level, and the second as far as that leaves room; and what both leave
    /// free, in columns.
    fn solve(&self) -> Option<(DVector<f64>, DMatrix<f64>)> {
        let Self([first, second]) = self;
        let ranked = Ranked::new(&first.change)?;
        let (mut unknowns, room) = (-ranked.solve(&first.residual), ranked.null_space());
        let ranked = Ranked::new(&(&second.change * &room))?;
        unknowns -= &room * ranked.solve(&(&second.residual + &second.change * &unknowns));
        Some((unknowns, room * ranked.null_space()))
    }
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
