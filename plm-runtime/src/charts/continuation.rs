//! The discrete state of loops: a chart with continuation data of the last checked state, or a pose.

use crate::held::Loops;
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Discrete state of the loops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OfLoops<M, Q> {
    /// Coordinates of a chart.
    InChart {
        /// The chart, from 0.
        chart: usize,
        /// Continuation data of the last checked state.
        continuation: M,
    },
    /// No chart is good: pose and velocity of all bodies.
    Free {
        /// Pose.
        q: Q,
        /// Velocity.
        v: Q,
    },
}

/// Continuation data of a state with `Y` coordinates, `T` angles, `A` determinants, and `F` unknowns of iterations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Continuation<S, const Y: usize, const T: usize, const A: usize, const F: usize> {
    /// The coordinates of the chart.
    pub coordinates: [Reach<S>; Y],
    /// The time.
    pub time: Reach<S>,
    /// The angle of each class of bodies that turn as one.
    pub angles: [Angle<S>; T],
    /// The determinant of each loop, whose sign identifies its mirror image.
    pub determinants: [S; A],
    /// The unknowns that iterations start from.
    pub iterated: [Iterated<S>; F],
}

/// Value of a coordinate or of the time at the last check, and how far it may move until the next one; negative if every state is checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reach<S> {
    /// The value at the last check.
    pub last: S,
    /// Half the width of its interval: so far it may move before the next check. Far from flat poses the checks allow a multiple of it.
    pub reach: S,
}

/// An angle that includes all revolutions, with its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle<S> {
    /// The angle, rad.
    pub angle: S,
    /// Its cosine.
    pub cos: S,
    /// Its sine.
    pub sin: S,
}

/// An unknown of an iteration, rad, or a displacement over the size of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iterated<S> {
    /// Its value.
    pub value: S,
    /// Its rate.
    pub rate: S,
    /// Half the rate of that.
    pub bend: S,
}

/// Continuation data of any lengths.
pub trait ContinuationData<S>: Copy {
    /// The data before the first check.
    fn nothing() -> Self;
    /// The coordinates of the chart.
    fn coordinates(&self) -> &[Reach<S>];
    /// The coordinates, mutable: for removing whole revolutions.
    fn coordinates_mut(&mut self) -> &mut [Reach<S>];
    /// The time.
    fn time(&self) -> Reach<S>;
    /// The angles.
    fn angles(&self) -> &[Angle<S>];
    /// The angles, mutable: for removing whole revolutions.
    fn angles_mut(&mut self) -> &mut [Angle<S>];
    /// The determinants.
    fn determinants(&self) -> &[S];
    /// The unknowns of iterations.
    fn iterated(&self) -> &[Iterated<S>];
    /// The unknowns of iterations, mutable: for the curvature that two checks give together.
    fn iterated_mut(&mut self) -> &mut [Iterated<S>];
    /// Copies every number of `one` into its place here by `put`.
    fn put(&mut self, one: &Self, put: impl Fn(&mut S, S));

    /// Multiplies the widths of the intervals about the coordinates by a factor.
    #[inline]
    fn narrow(&mut self, by: S)
    where
        S: Scalar,
    {
        for at in self.coordinates_mut() {
            at.reach = by * at.reach;
        }
    }

    /// `f` from the first number to the last, beginning with `start`.
    #[inline]
    fn fold<A>(&self, start: A, f: impl Fn(A, S) -> A) -> A
    where
        S: Scalar,
    {
        let reach = |all: A, at: &Reach<S>| f(f(all, at.last), at.reach);
        let turn = |all: A, at: &Angle<S>| f(f(f(all, at.angle), at.cos), at.sin);
        let iterated = |all: A, at: &Iterated<S>| f(f(f(all, at.value), at.rate), at.bend);
        let all = reach(self.coordinates().iter().fold(start, reach), &self.time());
        let all = self.angles().iter().fold(all, turn);
        let all = self.determinants().iter().fold(all, |all, &determinant| f(all, determinant));
        self.iterated().iter().fold(all, iterated)
    }

    /// True if every number is finite. The reach of the time may be infinite: a prescribed motion may rest.
    #[inline]
    fn is_finite(&self) -> bool
    where
        S: Scalar,
    {
        self.fold(true, |finite, number| finite && number.is_finite()) || self.is_finite_at_rest()
    }

    /// As [`is_finite`](Self::is_finite), allowing an infinite reach of the time.
    #[cold]
    fn is_finite_at_rest(&self) -> bool
    where
        S: Scalar,
    {
        let of_time = 2 * self.coordinates().len() + 1;
        let is_known = |place: usize, number: S| {
            number.is_finite() || place == of_time && number.to_f64().abs() == f64::INFINITY
        };
        self.fold((0, true), |(place, known), number| (place + 1, known && is_known(place, number))).1
    }
}

impl<S: Scalar, const Y: usize, const T: usize, const A: usize, const F: usize> ContinuationData<S>
    for Continuation<S, Y, T, A, F>
{
    fn nothing() -> Self {
        let zero = S::lit(0.0);
        let reach = Reach { last: zero, reach: zero };
        Continuation {
            coordinates: [reach; Y],
            time: reach,
            angles: [Angle { angle: zero, cos: zero, sin: zero }; T],
            determinants: [zero; A],
            iterated: [Iterated { value: zero, rate: zero, bend: zero }; F],
        }
    }

    fn coordinates(&self) -> &[Reach<S>] {
        &self.coordinates
    }

    fn coordinates_mut(&mut self) -> &mut [Reach<S>] {
        &mut self.coordinates
    }

    fn time(&self) -> Reach<S> {
        self.time
    }

    fn angles(&self) -> &[Angle<S>] {
        &self.angles
    }

    fn angles_mut(&mut self) -> &mut [Angle<S>] {
        &mut self.angles
    }

    fn determinants(&self) -> &[S] {
        &self.determinants
    }

    fn iterated(&self) -> &[Iterated<S>] {
        &self.iterated
    }

    fn iterated_mut(&mut self) -> &mut [Iterated<S>] {
        &mut self.iterated
    }

    #[inline]
    fn put(&mut self, one: &Self, put: impl Fn(&mut S, S)) {
        put_continuation(self, one, &put);
    }
}

impl<S: Real> Reach<S> {
    /// Is a value within reach?
    pub(super) fn holds(&self, value: S) -> bool {
        (value - self.last).abs() < self.reach
    }
}

impl<S: Scalar, const Y: usize, const T: usize, const A: usize, const F: usize, const NQ: usize> Loops<S>
    for OfLoops<Continuation<S, Y, T, A, F>, [S; NQ]>
{
    type Packed<P: Scalar> = OfLoops<Continuation<P, Y, T, A, F>, [P; NQ]>;

    #[allow(clippy::inline_always, reason = "a rate reads few of these numbers")]
    #[inline(always)]
    fn packed<P: Scalar, const N: usize>(
        &self,
        all: [&Self; N],
        number: &impl Fn([S; N]) -> P,
    ) -> Self::Packed<P> {
        match self {
            OfLoops::InChart { chart, continuation } => {
                let mut each = [continuation; N];
                for i in 0..N {
                    if let OfLoops::InChart { continuation, .. } = all[i] {
                        each[i] = continuation;
                    }
                }
                OfLoops::InChart { chart: *chart, continuation: packed(each, number) }
            }
            OfLoops::Free { q, v } => {
                let mut each = [(q, v); N];
                for i in 0..N {
                    if let OfLoops::Free { q, v } = all[i] {
                        each[i] = (q, v);
                    }
                }
                OfLoops::Free {
                    q: Vector::from_fn(|k| number(Vector::from_fn(|i| each[i].0[k]))),
                    v: Vector::from_fn(|k| number(Vector::from_fn(|i| each[i].1[k]))),
                }
            }
        }
    }

    #[inline]
    fn put<P: Scalar>(wide: &mut Self::Packed<P>, one: &Self, put: &impl Fn(&mut P, S)) {
        if let (OfLoops::InChart { continuation: wide, .. }, OfLoops::InChart { continuation: one, .. }) =
            (wide, one)
        {
            put_continuation(wide, one, put);
        }
    }

    #[inline]
    fn take<P: Scalar>(&mut self, wide: &Self::Packed<P>, take: &impl Fn(P) -> S) {
        if let (OfLoops::InChart { continuation: one, .. }, OfLoops::InChart { continuation: wide, .. }) =
            (self, wide)
        {
            put_continuation(one, wide, &|one: &mut S, wide| *one = take(wide));
        }
    }

    fn chart(&self) -> Option<usize> {
        match *self {
            OfLoops::InChart { chart, .. } => Some(chart),
            OfLoops::Free { .. } => None,
        }
    }
}

/// Puts every number to that in its place in another.
#[inline]
fn put_continuation<S: Copy, P, const Y: usize, const T: usize, const A: usize, const F: usize>(
    wide: &mut Continuation<P, Y, T, A, F>,
    one: &Continuation<S, Y, T, A, F>,
    put: &impl Fn(&mut P, S),
) {
    let reaches = wide.coordinates.iter_mut().zip(&one.coordinates).chain([(&mut wide.time, &one.time)]);
    for (wide, one) in reaches {
        put(&mut wide.last, one.last);
        put(&mut wide.reach, one.reach);
    }
    for (wide, one) in wide.angles.iter_mut().zip(&one.angles) {
        put(&mut wide.angle, one.angle);
        put(&mut wide.cos, one.cos);
        put(&mut wide.sin, one.sin);
    }
    for (wide, one) in wide.determinants.iter_mut().zip(&one.determinants) {
        put(wide, *one);
    }
    for (wide, one) in wide.iterated.iter_mut().zip(&one.iterated) {
        put(&mut wide.value, one.value);
        put(&mut wide.rate, one.rate);
        put(&mut wide.bend, one.bend);
    }
}

/// The data of several states as one.
#[allow(clippy::inline_always, reason = "a rate reads few of these numbers")]
#[inline(always)]
fn packed<
    S: Scalar,
    P: Scalar,
    const Y: usize,
    const T: usize,
    const A: usize,
    const F: usize,
    const N: usize,
>(
    all: [&Continuation<S, Y, T, A, F>; N],
    number: &impl Fn([S; N]) -> P,
) -> Continuation<P, Y, T, A, F> {
    let coordinate = |k: usize| Reach {
        last: number(Vector::from_fn(|i| all[i].coordinates[k].last)),
        reach: number(Vector::from_fn(|i| all[i].coordinates[k].reach)),
    };
    let time = Reach {
        last: number(Vector::from_fn(|i| all[i].time.last)),
        reach: number(Vector::from_fn(|i| all[i].time.reach)),
    };
    let angle = |k: usize| Angle {
        angle: number(Vector::from_fn(|i| all[i].angles[k].angle)),
        cos: number(Vector::from_fn(|i| all[i].angles[k].cos)),
        sin: number(Vector::from_fn(|i| all[i].angles[k].sin)),
    };
    let iterated = |k: usize| Iterated {
        value: number(Vector::from_fn(|i| all[i].iterated[k].value)),
        rate: number(Vector::from_fn(|i| all[i].iterated[k].rate)),
        bend: number(Vector::from_fn(|i| all[i].iterated[k].bend)),
    };
    let (zero, determinant) = (P::ZERO, |k| number(Vector::from_fn(|i| all[i].determinants[k])));
    let mut data = Continuation {
        coordinates: [Reach { last: zero, reach: zero }; Y],
        time,
        angles: [Angle { angle: zero, cos: zero, sin: zero }; T],
        determinants: Vector::from_fn(determinant),
        iterated: [Iterated { value: zero, rate: zero, bend: zero }; F],
    };
    for k in 0..Y {
        data.coordinates[k] = coordinate(k);
    }
    for k in 0..T {
        data.angles[k] = angle(k);
    }
    for k in 0..F {
        data.iterated[k] = iterated(k);
    }
    data
}
