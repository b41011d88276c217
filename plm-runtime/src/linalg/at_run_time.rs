//! Derivatives of a mechanism that comes from text: their form is known when the program runs.

use super::complex::{Both, Complex, Entry};
use super::lu::Lu;
use super::resolvent::{Dense, Derivatives, Resolvent};
use super::sparse::{Pattern, Work, at, decompose, solve};
use crate::scalar::Real;
use crate::words::Words;

/// Unknowns of an augmented system, over the numbers of a state that there is room for: places, velocities and accelerations of the bodies,
/// and forces in joints, stand beside those.
const UNKNOWNS: usize = 4;

/// A matrix, or in its place the coefficients of an augmented system, as [`Sparse`](super::Sparse) has them.
#[derive(Clone, Copy, Debug)]
pub struct AtRunTime<S, const N: usize> {
    /// The matrix, or the coefficients one after the other.
    numbers: [[S; N]; N],
    /// The pattern, where these are coefficients.
    pattern: Option<&'static Pattern>,
}

impl<S: Real, const N: usize> AtRunTime<S, N> {
    /// Is there room for an augmented system with this pattern, and for so many coefficients?
    pub fn fits(pattern: &Pattern, coefficients: usize) -> bool {
        let last =
            pattern.pivots.iter().map(|pivot| pivot.entry).chain(pattern.targets.iter().copied()).max();
        let entries = last.map_or(0, |last| last as usize + 1);
        let rates = (pattern.coordinates + pattern.states) as usize;
        entries.max(coefficients) <= N * N && pattern.pivots.len() <= UNKNOWNS * N && rates <= N
    }

    /// Becomes an augmented system with this pattern, whose coefficients are to be written here.
    pub fn coefficients(&mut self, pattern: &'static Pattern) -> &mut [S] {
        self.pattern = Some(pattern);
        self.numbers.as_flattened_mut()
    }
}

impl<S: Real, const N: usize> Derivatives<S, [S; N]> for AtRunTime<S, N> {
    type Resolvent<T: Entry<S>> = Resolvent<T, N>;

    fn zeros() -> Self {
        Self { numbers: <[S; N]>::zeros(), pattern: None }
    }

    fn room<T: Entry<S>>(&self) -> Resolvent<T, N> {
        self.numbers.room()
    }

    fn decompose<T: Entry<S>>(&self, lambda: T, nq: usize, into: &mut Resolvent<T, N>) -> bool {
        let Some(pattern) = self.pattern else { return self.numbers.decompose(lambda, nq, into) };
        let Resolvent { inverse, lu: Lu { rows, .. } } = into;
        *inverse = lambda.reciprocal();
        *rows = [[T::real(S::ZERO); N]; N];
        let (system, entries) = ((pattern, self.numbers.as_flattened()), rows.as_flattened_mut());
        let mut made_of = [[S::ZERO; N]; UNKNOWNS];
        decompose(system, (lambda, *inverse), entries, made_of.as_flattened_mut())
    }

    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Resolvent<T, N>,
        nq: usize,
        r: impl FnMut(usize) -> T,
        each: impl FnMut(usize, T),
    ) {
        let Some(pattern) = self.pattern else { return self.numbers.resolve(resolvent, nq, r, each) };
        let entry = |place| at::<S, T>(resolvent.lu.rows.as_flattened(), place);
        self.solve(pattern, (entry, resolvent.inverse), nq, (r, each));
    }

    fn resolve_both(
        &self,
        (real, complex): (&Resolvent<S, N>, &Resolvent<Complex<S>, N>),
        nq: usize,
        r: impl FnMut(usize) -> Both<S>,
        each: impl FnMut(usize, Both<S>),
    ) {
        let Some(pattern) = self.pattern else {
            return self.numbers.resolve_both((real, complex), nq, r, each);
        };
        let entry = |place| Both {
            real: at::<S, S>(real.lu.rows.as_flattened(), place),
            complex: at::<S, Complex<S>>(complex.lu.rows.as_flattened(), place),
        };
        let inverse = Both { real: real.inverse, complex: complex.inverse };
        self.solve(pattern, (entry, inverse), nq, (r, each));
    }

    /// The full matrix; coefficients, if there were some, become zeros.
    fn full(&mut self) -> Option<&mut [[S; N]; N]> {
        if self.pattern.take().is_some() {
            self.numbers = <[S; N]>::zeros();
        }
        Some(&mut self.numbers)
    }

    /// Without the pattern: code that reads coefficients has it.
    fn in_words(&mut self, words: &mut impl Words) {
        self.numbers.in_words(words);
    }
}

impl<S: Real, const N: usize> AtRunTime<S, N> {
    fn solve<T: Entry<S>>(
        &self,
        pattern: &Pattern,
        entries: (impl Fn(u32) -> T, T),
        nq: usize,
        (mut r, mut each): (impl FnMut(usize) -> T, impl FnMut(usize, T)),
    ) {
        // A state has room for nq coordinates; first-order states stand after that.
        let n = pattern.coordinates as usize;
        let place = |index: usize| if index < nq + n { index } else { index - n + nq };
        let sides = (|index| r(place(index)), |index, k| each(place(index), k));
        let zero = T::real(S::ZERO);
        let (mut knowns, mut b) = ([[zero; N]; 3], [[zero; N]; UNKNOWNS]);
        let work = Work::of(&mut knowns, b.as_flattened_mut());
        solve((pattern, self.numbers.as_flattened()), entries, nq, sides, work);
    }
}
