//! Derivatives of the rate of a mechanism from text, for implicit methods: their form and size are known when the program runs.

use plm_runtime::Real;
use plm_runtime::linalg::sparse::{self, Work};
use plm_runtime::linalg::{Both, Complex, Derivatives, Entry, Pattern, lu};
use plm_runtime::words::Words;

/// Unknowns of an augmented system, over the numbers of a state that there is room for: places, velocities and accelerations of the bodies,
/// and forces in joints, stand beside those.
const UNKNOWNS: usize = 4;

/// A matrix, or in its place the coefficients of an augmented system, as [`Sparse`](plm_runtime::linalg::Sparse) has them.
#[derive(Clone, Debug)]
pub struct AtRunTime<S, const N: usize> {
    /// Rows of the matrix, or the coefficients one after the other; none before there are derivatives.
    numbers: Vec<[S; N]>,
    /// Number of coordinates and of first-order states, where the matrix has rows and columns of room.
    filled: Option<[usize; 2]>,
    /// The pattern, where these are coefficients.
    pattern: Option<&'static Pattern>,
}

/// A decomposed lambda I - J of such derivatives.
#[derive(Clone, Debug)]
pub struct Decomposed<T, const N: usize> {
    /// 1 / lambda.
    inverse: T,
    /// The factors L and U of the rows that are not room, or the entries of an eliminated system one after the other.
    rows: Vec<[T; N]>,
    /// The row that each step of the elimination brought to its place.
    pivots: Vec<usize>,
}

impl<S: Real, const N: usize> AtRunTime<S, N> {
    /// Is there room for an augmented system with this pattern, and for so many coefficients?
    pub(crate) fn fits(pattern: &Pattern, coefficients: usize) -> bool {
        let last =
            pattern.pivots.iter().map(|pivot| pivot.entry).chain(pattern.targets.iter().copied()).max();
        let entries = last.map_or(0, |last| last as usize + 1);
        let rates = (pattern.coordinates + pattern.states) as usize;
        entries.max(coefficients) <= N * N && pattern.pivots.len() <= UNKNOWNS * N && rates <= N
    }

    /// Becomes an augmented system with this pattern, whose coefficients are to be written here.
    pub(crate) fn coefficients(&mut self, pattern: &'static Pattern) -> &mut [S] {
        self.pattern = Some(pattern);
        self.rows().as_flattened_mut()
    }

    /// Becomes a matrix with so many coordinates and first-order states, whose other rows and columns are room.
    pub(crate) fn fill(&mut self, coordinates: usize, states: usize) {
        self.filled = Some([coordinates, states]);
    }

    fn rows(&mut self) -> &mut [[S; N]] {
        self.numbers.resize(N, [S::ZERO; N]);
        &mut self.numbers
    }

    /// The matrix; `None` before there are derivatives.
    fn matrix(&self) -> Option<&[[S; N]; N]> {
        self.numbers.as_slice().try_into().ok()
    }

    /// Number of coordinates and of first-order states.
    fn counts(&self, nq: usize) -> [usize; 2] {
        self.filled.unwrap_or([nq, N.saturating_sub(2 * nq)])
    }
}

/// Place in a state of an unknown that remains where coordinates are eliminated: velocities, then first-order states.
fn place(index: usize, coordinates: usize, nq: usize) -> usize {
    if index < coordinates { nq + index } else { 2 * nq + index - coordinates }
}

impl<S: Real, const N: usize> Derivatives<S, [S; N]> for AtRunTime<S, N> {
    type Resolvent<T: Entry<S>> = Decomposed<T, N>;

    fn zeros() -> Self {
        Self { numbers: Vec::new(), filled: None, pattern: None }
    }

    fn room<T: Entry<S>>(&self) -> Decomposed<T, N> {
        Decomposed { inverse: T::real(S::ZERO), rows: Vec::new(), pivots: Vec::new() }
    }

    fn decompose<T: Entry<S>>(&self, lambda: T, nq: usize, into: &mut Decomposed<T, N>) -> bool {
        let Decomposed { inverse, rows, pivots } = into;
        *inverse = lambda.reciprocal();
        let Some(pattern) = self.pattern else {
            let Some(matrix) = self.matrix() else { return false };
            let [coordinates, states] = self.counts(nq);
            rows.clear();
            rows.resize(coordinates + states, [T::real(S::ZERO); N]);
            for (i, row) in rows.iter_mut().enumerate() {
                eliminate(row, &matrix[place(i, coordinates, nq)], (*inverse, coordinates, nq));
                row[i] = row[i] + lambda;
            }
            pivots.clear();
            pivots.resize(rows.len(), 0);
            let order = rows.len();
            return lu::decompose(rows, pivots, order);
        };
        rows.clear();
        rows.resize(N, [T::real(S::ZERO); N]);
        let system = (pattern, self.numbers.as_flattened());
        let mut made_of = vec![S::ZERO; UNKNOWNS * N];
        sparse::decompose(system, (lambda, *inverse), rows.as_flattened_mut(), &mut made_of)
    }

    fn resolve<T: Entry<S>>(
        &self,
        resolvent: &Decomposed<T, N>,
        nq: usize,
        mut r: impl FnMut(usize) -> T,
        mut each: impl FnMut(usize, T),
    ) {
        let Decomposed { inverse, rows, pivots } = resolvent;
        if let Some(pattern) = self.pattern {
            let entry = |place| sparse::at::<S, T>(rows.as_flattened(), place);
            return self.solve(pattern, (entry, *inverse), nq, (r, each));
        }
        let Some(matrix) = self.matrix() else { return };
        let [coordinates, _] = self.counts(nq);
        let zero = T::real(S::ZERO);
        let (mut kq, mut kw) = ([zero; N], [zero; N]);
        for (i, k) in kq.iter_mut().enumerate().take(coordinates) {
            *k = r(i) * *inverse;
        }
        for (i, k) in kw.iter_mut().enumerate().take(rows.len()) {
            let own = place(i, coordinates, nq);
            let known = matrix[own].iter().zip(&kq).take(coordinates);
            *k = known.fold(r(own), |sum, (by_q, k)| sum + T::real(*by_q) * *k);
        }
        lu::solve(rows, pivots, rows.len(), &mut kw);
        for (i, (kq, kv)) in kq.iter().zip(&kw).enumerate().take(coordinates) {
            each(i, *kq + *kv * *inverse);
        }
        // Room has no right-hand side.
        for i in coordinates..nq {
            each(i, zero);
            each(nq + i, zero);
        }
        for (i, k) in kw.iter().enumerate().take(rows.len()) {
            each(place(i, coordinates, nq), *k);
        }
        for i in 2 * nq + rows.len() - coordinates..N {
            each(i, zero);
        }
    }

    fn resolve_both(
        &self,
        (real, complex): (&Decomposed<S, N>, &Decomposed<Complex<S>, N>),
        nq: usize,
        mut r: impl FnMut(usize) -> Both<S>,
        mut each: impl FnMut(usize, Both<S>),
    ) {
        let Some(pattern) = self.pattern else {
            let mut first = [S::ZERO; N];
            self.resolve(real, nq, |i| r(i).real, |i, k| first[i] = k);
            let both = |i: usize, complex| each(i, Both { real: first[i], complex });
            return self.resolve(complex, nq, |i| r(i).complex, both);
        };
        let entry = |place| Both {
            real: sparse::at::<S, S>(real.rows.as_flattened(), place),
            complex: sparse::at::<S, Complex<S>>(complex.rows.as_flattened(), place),
        };
        let inverse = Both { real: real.inverse, complex: complex.inverse };
        self.solve(pattern, (entry, inverse), nq, (r, each));
    }

    /// The full matrix; coefficients, if there were some, become zeros.
    fn full(&mut self) -> Option<&mut [[S; N]; N]> {
        if self.pattern.take().is_some() {
            self.numbers.clear();
        }
        self.rows().try_into().ok()
    }

    /// Without the pattern: code that reads coefficients has it.
    fn in_words(&mut self, words: &mut impl Words) {
        for row in self.rows() {
            words.numbers(row);
        }
    }
}

/// A row of -J_ww - J_wq \[I 0\] / lambda, of which `entries` is the row of J.
fn eliminate<S: Real, T: Entry<S>, const N: usize>(
    row: &mut [T; N],
    entries: &[S; N],
    (inverse, coordinates, nq): (T, usize, usize),
) {
    for (j, entry) in row.iter_mut().enumerate() {
        if let Some(by_w) = entries.get(place(j, coordinates, nq)) {
            *entry = T::real(-*by_w);
        }
    }
    for (entry, by_q) in row.iter_mut().zip(entries).take(coordinates) {
        *entry = entry.less_product(inverse, T::real(*by_q));
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
        sparse::solve((pattern, self.numbers.as_flattened()), entries, nq, sides, work);
    }
}
