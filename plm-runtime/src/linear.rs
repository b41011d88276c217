//! Exact derivatives of the rate, for implicit methods and for linearisation.

use core::marker::PhantomData;

use crate::dual::Dual;
use crate::linalg::{Dense, Derivatives};
use crate::scalar::{Operation, Real, Scalar};
use crate::system::{Computation, Health, Question, Rate, System};
use crate::vector::Vector;

/// Directions in which one evaluation on dual numbers differentiates.
const DIRECTIONS: usize = 4;

/// The health of a matrix of derivatives: that of the rate, which is not a number if an entry is not finite.
pub fn finite<S: Real, const N: usize>(health: Health<S>, by_x: &[[S; N]; N]) -> Health<S> {
    // Zero times what is not finite is not a number.
    let probe = by_x.iter().flatten().fold(S::ZERO, |probe, entry| entry.mul_add(S::ZERO, probe));
    Health(health.0 + probe)
}

/// A system that can be differentiated: generated code says how its numbers become [`Dual`] numbers, the rest is done
/// by running it on them.
pub trait Linear: System<S: Real, X: Dense<<Self as Rate>::S>> {
    /// This system with dual numbers.
    type Lifted<const K: usize>: Linear<S = Dual<Self::S, K>>;
    /// This system with numbers of another type.
    type In<T: Real>: Linear<S = T>;
    /// The form in which implicit methods keep the derivatives of the rate: a matrix, where states are few, or the
    /// coefficients of an augmented system.
    type Derivatives: Derivatives<Self::S, Self::X>;

    /// The system and the discrete state with dual numbers, all of them constants.
    fn lift<const K: usize>(&self, held: &Self::U) -> (Self::Lifted<K>, <Self::Lifted<K> as Rate>::U);

    /// The system and the discrete state with numbers of another type, each made by `number`.
    fn in_numbers<T: Real>(
        &self,
        held: &Self::U,
        number: impl Fn(Self::S) -> T,
    ) -> (Self::In<T>, <Self::In<T> as Rate>::U);

    /// As [`in_numbers`](Self::in_numbers), for the rate alone. The rate reads no start values, so these may be constants.
    fn rate_in_numbers<T: Real>(
        &self,
        held: &Self::U,
        number: impl Fn(Self::S) -> T,
    ) -> (Self::In<T>, <Self::In<T> as Rate>::U) {
        self.in_numbers(held, number)
    }

    /// Does the rate read the time? True if it is not sure.
    fn rate_reads_time(&self) -> bool {
        true
    }

    /// Gives `row` the residual of every equation that a state has to keep: phi and phi_q v - nu.
    fn constraints(&self, t: Self::S, x: &Self::X, row: &mut impl FnMut(Self::S)) {
        let _ = (t, x, row);
    }

    /// Gives `row` the residual of every equation that a state has to satisfy until the next event, beside the constraints: displacements
    /// and rates of the [contact rows](crate::contact) that are in force, and discrete states.
    fn held_rows(&self, t: Self::S, u: &Self::U, x: &Self::X, row: &mut impl FnMut(Self::S)) {
        let _ = (t, u, x, row);
    }

    /// The derivative of the rate along (`dt`, `dx`), exact but for rounding; with the health of the rate.
    fn jvp(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        (dt, dx): (Self::S, &Self::X),
        out: &mut Self::X,
    ) -> Health<Self::S> {
        let (lifted, held) = self.lift::<1>(u);
        let along = |value, tangent| Dual { value, tangents: [tangent] };
        let x = Vector::from_fn(|i| along(x.at(i), dx.at(i)));
        let mut rate = x;
        let health = lifted.rate(along(t, dt), &held, &x, &mut rate);
        *out = Vector::from_fn(|i| {
            let [tangent] = rate.at(i).tangents;
            tangent
        });
        Health(health.0.value)
    }

    /// The derivatives of the rate by the state as implicit methods take them, and by the time where asked for.
    ///
    /// The health is that of the rate; it is not a number if a derivative is not finite.
    fn differentiate(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        by_x: &mut Self::Derivatives,
        by_t: Option<&mut Self::X>,
    ) -> Health<Self::S> {
        match by_x.full() {
            Some(matrix) => self.jacobian(t, u, x, matrix, by_t),
            None => Health(Self::S::lit(f64::NAN)),
        }
    }

    /// The derivatives of the rate by the state, column by column, and by the time where asked for.
    ///
    /// The health is that of the rate; it is not a number if a derivative is not finite.
    fn jacobian(
        &self,
        t: Self::S,
        u: &Self::U,
        x: &Self::X,
        by_x: &mut <Self::X as Dense<Self::S>>::Matrix,
        by_t: Option<&mut Self::X>,
    ) -> Health<Self::S> {
        by_columns(self, (t, u, x), by_x, by_t)
    }
}

/// [`Constraints::compute`](crate::Constraints::compute) of a system that can be differentiated.
#[allow(clippy::inline_always, reason = "it is the formula")]
#[inline(always)]
pub fn compute<M: Linear, C: Computation>(
    system: &M,
    (t, h): (M::S, M::S),
    u: &M::U,
    from: (&M::X, &M::X),
) -> (C::Made<M::X>, Health<M::S>) {
    M::S::make(Computed::<M, C> { system, times: (t, h), u, from, computation: PhantomData })
}

/// [`Constraints::ask`](crate::Constraints::ask) of a system that can be differentiated.
#[allow(clippy::inline_always, reason = "it is the question")]
#[inline(always)]
pub fn ask<M: Linear, Q: Question<M::S>>(system: &M, u: &M::U, question: Q) -> Q::Answer {
    if const { !M::S::HAS_DERIVATIVES } {
        return question.of(system, u);
    }
    let (own, held) = system.rate_in_numbers(u, Real::plain);
    question.of(&own, &held)
}

/// A computation as an operation of the numbers that the rate depends on.
struct Computed<'a, M: Linear, C> {
    system: &'a M,
    times: (M::S, M::S),
    u: &'a M::U,
    from: (&'a M::X, &'a M::X),
    computation: PhantomData<C>,
}

/// States of more numbers depend on variables in more of them than there are directions, but for the first steps.
const WIDE: usize = 24;

impl<M: Linear, C: Computation> Operation<M::S> for Computed<'_, M, C> {
    type Output = (C::Made<M::X>, Health<M::S>);
    const IS_WIDE: bool = M::X::LEN > WIDE;
    const HAS_DERIVATIVES: bool = C::VECTORS > 0;

    #[allow(clippy::inline_always, reason = "it is the formula")]
    #[inline(always)]
    fn make(self) -> Self::Output {
        let Self { system, times, u, from: (x, rate), .. } = self;
        if C::FROM_RATE && M::S::AT_ONCE.has_steps() {
            let mut first = *x;
            system.rate(times.0, u, x, &mut first);
            let first = first.map2(rate, |own, rate| own.with_plain(rate.plain()));
            return C::of(system, times, u, (x, &first));
        }
        C::of(system, times, u, (x, rate))
    }

    #[inline]
    fn arguments(&self, each: impl Fn(M::S)) {
        if self.system.rate_reads_time() {
            each(self.times.0);
        }
        each(self.times.1);
        for i in 0..M::X::LEN {
            each(self.from.0.at(i));
        }
        self.system.rate_in_numbers(self.u, |number| {
            each(number);
            number
        });
    }

    fn results(&self) -> usize {
        C::VECTORS * (0..M::X::LEN).filter(|i| self.system.has_number(*i)).count()
    }

    #[inline]
    fn in_numbers<T: Real<Plain = <M::S as Real>::Plain>>(
        self,
        number: impl Fn(M::S) -> T,
        result: impl Fn(T) -> M::S,
    ) -> Self::Output {
        let Self { system, times: (t, h), u, from: (x, rate), .. } = self;
        let reads_time = system.rate_reads_time();
        let t = number(if reads_time { t } else { M::S::of_plain(t.plain()) });
        let h = number(h);
        let state: <M::In<T> as Rate>::X = Vector::from_fn(|i| number(x.at(i)));
        let (own, held) = system.rate_in_numbers(u, &number);
        // The rate is known, but not its derivatives by these arguments.
        let mut first = state;
        if C::FROM_RATE {
            if T::HAS_DERIVATIVES {
                own.rate(t, &held, &state, &mut first);
            }
            first = Vector::from_fn(|i| first.at(i).with_plain(rate.at(i).plain()));
        }
        let (made, health) = C::of(&own, (t, h), &held, (&state, &first));
        let mut vectors = 0;
        let vector = |all: &<M::In<T> as Rate>::X, to: &mut M::X| {
            vectors += 1;
            for i in 0..M::X::LEN {
                let number = all.at(i);
                let has_derivatives = vectors <= C::VECTORS && system.has_number(i);
                to.set(i, if has_derivatives { result(number) } else { M::S::of_plain(number.plain()) });
            }
        };
        let blank = M::X::fill(M::S::ZERO);
        (C::map(&made, blank, vector), Health(M::S::of_plain(health.0.plain())))
    }
}

/// [`Linear::jacobian`] column by column.
pub fn by_columns<M: Linear + ?Sized>(
    system: &M,
    at: (M::S, &M::U, &M::X),
    by_x: &mut <M::X as Dense<M::S>>::Matrix,
    by_t: Option<&mut M::X>,
) -> Health<M::S> {
    let own = |column: usize| column;
    let layout = Layout { count: M::X::LEN, of_column: own, column: |direction: usize, _| direction };
    in_passes::<M, DIRECTIONS>(system, at, &layout, by_x, by_t)
}

/// Columns that share no row, each time those of one colour: one direction differentiates them together (A. R. Curtis, M. J. D.
/// Powell, J. K. Reid, On the estimation of sparse Jacobian matrices, J. Inst. Maths Applics 13, 1974). In a row of N numbers
/// that a colour does not reach, and above those that say q' = v, there is nothing to be written.
#[derive(Clone, Copy, Debug)]
pub struct Colours<const N: usize, const COUNT: usize> {
    /// The colour of each column; `COUNT` for one that no row reads.
    pub of_columns: [usize; N],
    /// The column that each row has in each colour; `N` for none.
    pub columns: [[usize; N]; COUNT],
    /// Does the rate read the time?
    pub knows_time: bool,
}

/// [`Linear::jacobian`] in one direction for each colour, `K` at once: the same bits as column by column, but that what is zero
/// by its place is a positive zero.
pub fn by_directions<M: Linear, const K: usize, const N: usize, const COUNT: usize>(
    system: &M,
    at: (M::S, &M::U, &M::X),
    colours: &Colours<N, COUNT>,
    by_x: &mut <M::X as Dense<M::S>>::Matrix,
    by_t: Option<&mut M::X>,
) -> Health<M::S> {
    let Colours { of_columns, columns, knows_time } = colours;
    let layout = Layout {
        count: COUNT,
        of_column: |column: usize| of_columns.get(column).copied().unwrap_or(COUNT),
        column: |direction: usize, row: usize| {
            columns.get(direction).and_then(|columns| columns.get(row)).copied().unwrap_or(N)
        },
    };
    match by_t {
        Some(by_t) if !knows_time => {
            *by_t = M::X::fill(M::S::ZERO);
            in_passes::<M, K>(system, at, &layout, by_x, None)
        }
        by_t => in_passes::<M, K>(system, at, &layout, by_x, by_t),
    }
}

/// Which direction a column belongs to, and which column a row has in a direction; what is beyond the end is none.
struct Layout<F, G> {
    count: usize,
    of_column: F,
    column: G,
}

/// The derivatives by the state, and by the time in a direction after the others, in passes of `K` directions.
fn in_passes<M: Linear + ?Sized, const K: usize>(
    system: &M,
    (t, u, x): (M::S, &M::U, &M::X),
    layout: &Layout<impl Fn(usize) -> usize, impl Fn(usize, usize) -> usize>,
    by_x: &mut <M::X as Dense<M::S>>::Matrix,
    by_t: Option<&mut M::X>,
) -> Health<M::S> {
    let (lifted, held) = system.lift::<K>(u);
    let (size, time, mut time_column) = (M::X::LEN, layout.count, *x);
    let directions = layout.count + usize::from(by_t.is_some());
    let (mut worst, mut probe) = (Health::perfect(), M::S::ZERO);
    *by_x = M::X::zeros();
    for i in 0..M::NQ {
        M::X::set_entry(by_x, i, M::NQ + i, M::S::lit(1.0)); // q' = v
    }
    // Once at least, for the health.
    for first in (0..directions.max(1)).step_by(K) {
        // What lies before or beyond this pass, or has no direction, becomes one that does not exist.
        let variable = |value, direction: usize| Dual::variable(value, direction.wrapping_sub(first));
        let of_state = |i| match (layout.of_column)(i) {
            direction if direction < layout.count => variable(x.at(i), direction),
            _ => Dual::constant(x.at(i)),
        };
        let point = Vector::from_fn(of_state);
        let mut rate = point;
        let t = if directions > time { variable(t, time) } else { Dual::constant(t) };
        let health = lifted.rate(t, &held, &point, &mut rate);
        worst = worst.worst(Health(health.0.value));
        for i in 0..size {
            for (k, tangent) in rate.at(i).tangents.into_iter().enumerate() {
                probe = tangent.mul_add(M::S::ZERO, probe);
                if first + k == time {
                    time_column.set(i, tangent);
                } else if i >= M::NQ && first + k < time {
                    M::X::set_entry(by_x, i, (layout.column)(first + k, i), tangent);
                }
            }
        }
    }
    if let Some(by_t) = by_t {
        *by_t = time_column;
    }
    // Zero times what is not finite is not a number.
    Health(worst.0 + probe)
}
