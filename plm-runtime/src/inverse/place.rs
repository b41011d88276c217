//! Poses and velocities in which targets are where they are wanted.

use super::error::Unsolved;
use super::names::Quantity;
use super::{Inverse, Invertible, Wanted};
use crate::described::Described;
use crate::dual::Dual;
use crate::linalg::Dense;
use crate::linear::Linear;
use crate::mechanism::{Mechanism, Moment};
use crate::scalar::{Real, Scalar};
use crate::system::{Constraints, Rate};
use crate::vector::Vector;

/// A way is gone in parts down to this fraction.
const SHORTEST: f64 = 1e-3;
/// Steps of Newton's method; from a pose nearby four or five are usual.
const ROUNDS: usize = 25;

type Number<S> = Dual<S, 1>;
type Lifted<M> = <M as Linear>::Lifted<1>;

/// A row that has to vanish: its number, the target that it is of, and its residual.
type Row<S> = (usize, Option<usize>, Number<S>);

/// A linear least-norm problem whose rows are added one by one: orthonormal rows, and what the unknowns are along them.
struct LeastNorm<M: Rate<S: Real, X: Dense<<M as Rate>::S>>> {
    rows: <M::X as Dense<M::S>>::Matrix,
    rank: usize,
    known: M::X,
}

impl<M: Rate<S: Real, X: Dense<<M as Rate>::S>>> LeastNorm<M> {
    fn new() -> Self {
        Self { rows: M::X::zeros(), rank: 0, known: M::X::fill(M::S::lit(0.0)) }
    }

    fn row(&self, number: usize) -> M::X {
        M::X::from_fn(|i| M::X::entry(&self.rows, number, i))
    }

    /// Adds row y = right; a row that depends on those before is left out.
    fn add(&mut self, mut row: M::X, mut right: M::S) {
        let size = dot::<M>(&row, &row).sqrt();
        for k in (0..2).flat_map(|_| 0..self.rank) {
            let other = self.row(k);
            let factor = dot::<M>(&row, &other);
            row.add([(-factor, &other)]);
            right = right - factor * self.known.at(k);
        }
        let norm = dot::<M>(&row, &row).sqrt();
        if self.rank < M::X::LEN && norm > M::S::RANK_TOLERANCE * size {
            for i in 0..M::X::LEN {
                M::X::set_entry(&mut self.rows, self.rank, i, row.at(i) / norm);
            }
            self.known.set(self.rank, right / norm);
            self.rank += 1;
        }
    }

    fn solution(&self) -> M::X {
        let mut y = M::X::fill(M::S::lit(0.0));
        for k in 0..self.rank {
            y.add([(self.known.at(k), &self.row(k))]);
        }
        y
    }
}

fn dot<M: Rate>(one: &M::X, other: &M::X) -> M::S {
    (0..M::X::LEN).fold(M::S::lit(0.0), |sum, i| one.at(i).mul_add(other.at(i), sum))
}

impl<'a, S: Real, const TARGETS: usize, const DRIVES: usize> Inverse<'a, S, TARGETS, DRIVES> {
    /// The moment at a time at which the targets have the wanted places and velocities, reached from a pose nearby by the least motion;
    /// joints stay closed, and so does contact that holds. Freedoms that targets leave keep their places as far as joints allow.
    ///
    /// # Errors
    /// [`Unsolved::NotReached`] where no such pose is near; [`Unsolved::Fault`] where the pose cannot be a continuation of the one before.
    pub fn place<T>(&self, of: &T, time: S, wanted: &Wanted<S, TARGETS>) -> Result<T, Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        Ok(self.placed(of, time, wanted)?.0)
    }

    /// As [`place`](Self::place), with the number of freedoms that the targets leave. A distance too long for one step of the loops is
    /// divided.
    pub(super) fn placed<T>(
        &self,
        of: &T,
        time: S,
        wanted: &Wanted<S, TARGETS>,
    ) -> Result<(T, usize), Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (one, (places, velocities)) = (S::lit(1.0), self.motion(of));
        let part = |fraction: S| {
            let on_the_way =
                |from: Option<S>, to: S| from.map_or(to, |from| fraction.mul_add(to - from, from));
            let mut part = *wanted;
            for k in 0..TARGETS {
                part.place[k] = on_the_way(places[k], wanted.place[k]);
                part.velocity[k] = on_the_way(velocities[k], wanted.velocity[k]);
            }
            (fraction.mul_add(time - of.time(), of.time()), part)
        };
        let (mut state, mut done, mut length) = (*of, S::lit(0.0), one);
        loop {
            let next = done + length;
            let is_last = next >= one;
            let (at, to) = if is_last { (time, *wanted) } else { part(next) };
            match self.placed_at_once(&state, at, &to) {
                Ok(found) if is_last => return Ok(found),
                Ok((found, _)) => (state, done) = (found, next),
                Err(refused) if length < S::lit(SHORTEST) => return Err(refused),
                Err(_) => length = S::lit(0.5) * length,
            }
        }
    }

    /// As [`placed`](Self::placed), in one step.
    fn placed_at_once<T>(
        &self,
        of: &T,
        time: S,
        wanted: &Wanted<S, TARGETS>,
    ) -> Result<(T, usize), Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (mechanism, mut held, mut x) = (of.mechanism(), of.held(), *of.x());
        for _ in 0..ROUNDS {
            let at = T::new(*mechanism, held, time, x);
            let system = self.linear::<T>(&at, wanted);
            let step = system.solution();
            x.add([(S::lit(1.0), &step)]);
            // False for NaN.
            let is_small = |i: usize| step.at(i).abs() <= S::RANK_TOLERANCE * (S::lit(1.0) + x.at(i).abs());
            if (0..<T::M as Rate>::X::LEN).all(is_small) {
                self.is_reached(&T::new(*mechanism, held, time, x), wanted)?;
                mechanism.update(time, &mut held, &mut x)?;
                let freedoms = mechanism.coordinates().saturating_sub(system.rank / 2);
                return Ok((T::new(*mechanism, held, time, x), freedoms));
            }
        }
        let reached = self.is_reached(&T::new(*mechanism, held, time, x), wanted);
        let misses = f64::NAN;
        reached.and(Err(Unsolved::NotReached { time: time.to_f64(), target: "", misses }))
    }

    /// All rows at a moment, linearised. A pass for each number of the state gives a column of as many rows as the state has numbers.
    fn linear<T>(&self, at: &T, wanted: &Wanted<S, TARGETS>) -> LeastNorm<T::M>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        type X<T> = <<T as Moment>::M as Rate>::X;
        let (mechanism, size) = (at.mechanism(), X::<T>::LEN);
        let moves = 2 * <T::M as Rate>::NQ;
        let mut system = LeastNorm::new();
        let (mut first, mut count) = (0, usize::MAX);
        while first < count {
            let (mut matrix, mut right) = (X::<T>::zeros(), X::<T>::fill(S::lit(0.0)));
            count = 0;
            for column in (0..moves).filter(|place| mechanism.has_number(*place)) {
                self.rows(at, Some(column), wanted, &mut |(number, _, row): Row<S>| {
                    count = number + 1;
                    if let Some(place) = number.checked_sub(first).filter(|place| *place < size) {
                        let [slope] = row.tangents;
                        X::<T>::set_entry(&mut matrix, place, column, slope);
                        right.set(place, -row.value);
                    }
                });
            }
            for place in 0..size.min(count - first.min(count)) {
                system.add(X::<T>::from_fn(|i| X::<T>::entry(&matrix, place, i)), right.at(place));
            }
            first += size;
        }
        system
    }

    /// # Errors
    /// [`Unsolved::NotReached`] with the row that misses most.
    fn is_reached<T>(&self, at: &T, wanted: &Wanted<S, TARGETS>) -> Result<(), Unsolved<'a>>
    where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (mut worst, mut of) = (S::lit(0.0), None);
        self.rows(at, None, wanted, &mut |(_, target, row): Row<S>| {
            let misses = row.value.abs();
            // NaN is worst of all, and stays so.
            if misses > worst || !misses.is_finite() {
                (worst, of) = (misses, target);
            }
        });
        if worst <= S::RANK_TOLERANCE {
            return Ok(());
        }
        let target = of.and_then(|target: usize| self.targets.get(target)).map_or("", |found| found.name);
        Err(Unsolved::NotReached { time: at.time().to_f64(), target, misses: worst.to_f64() })
    }

    /// Gives `each` the residual of every row with its derivative by a number of the state: joints, contact that holds, targets.
    fn rows<T>(
        &self,
        at: &T,
        column: Option<usize>,
        wanted: &Wanted<S, TARGETS>,
        each: &mut impl FnMut(Row<S>),
    ) where
        T: Moment<M: Invertible<DRIVES, S = S, State = T>>,
    {
        let (lifted, held) = at.mechanism().lift::<1>(&at.held());
        let mut x = <Lifted<T::M> as Rate>::X::from_fn(|i| Dual::constant(at.x().at(i)));
        if let Some(column) = column {
            x.set(column, Dual::variable(x.at(column).value, 0));
        }
        let (mut number, time) = (0, Dual::constant(at.time()));
        let mut row = |target, residual| {
            each((number, target, residual));
            number += 1;
        };
        lifted.constraints(time, &x, &mut |residual| row(None, residual));
        lifted.held_rows(time, &held, &x, &mut |residual| row(None, residual));
        let state = <Lifted<T::M> as Mechanism>::State::new(lifted, held, time, x);
        let mut body = 0;
        <Lifted<T::M>>::poses(&state, &mut |pose| {
            for (k, target) in self.targets.iter().enumerate() {
                if let Quantity::Coordinate(own, axis) = target.quantity
                    && own == body
                {
                    let [place, velocity] = axis.of(&pose);
                    row(Some(k), place - Dual::constant(wanted.place[k]));
                    row(Some(k), velocity - Dual::constant(wanted.velocity[k]));
                }
            }
            body += 1;
        });
        for (k, target) in self.targets.iter().enumerate() {
            if let Quantity::Rate(index) = target.quantity
                && let Some(found) = <Lifted<T::M>>::observed(&state, index)
            {
                row(Some(k), found - Dual::constant(wanted.velocity[k]));
            }
        }
    }
}
