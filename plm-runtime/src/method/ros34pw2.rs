//! A Rosenbrock-W method for stiff equations with steps of equal length.

use super::partition::Partition;
use super::{Context, DenseOutput, ErrorControl, Estimate, FixedLength, Length, Method, drift_of_size};
use crate::fault::{Cause, Fault};
use crate::linalg::Derivatives;
use crate::linear::Linear;
use crate::scalar::{Real, Scalar};
use crate::system::Drift;
use crate::vector::Vector;

/// ROS34PW2 with steps of equal length: order 3, L-stable, for stiff equations in real time.
///
/// A step takes four rates, one matrix of derivatives and one decomposition, for all equations. It is a W-method: the order does
/// not depend on the exactness of the derivatives. It suits equations that are stiff by damping or by first-order states, and
/// stiff springs that turn little: if a spring of the frequency w turns by the angle a within a step, (w h)^2 a^2 must not be
/// large against 1, as for all methods that solve linear systems only once. A step that fails for this reason ends the run.
///
/// Source: J. Rang, L. Angermann, New Rosenbrock W-methods of order 3 for partial differential algebraic equations of
/// index 1, BIT 45 (2005), table 4.2.
#[derive(Clone, Copy, Debug)]
pub struct Ros34Pw2<S> {
    /// Longest step, s.
    pub longest_step: S,
    /// Tolerated drift, as a fraction of the typical coordinate and velocity.
    pub tolerance: S,
    /// Estimated error of a step, as a fraction of the size of a state, above which the run ends.
    pub worst_error: S,
    partition: Partition<S>,
    /// Error of the last step.
    estimate: Estimate<S>,
}

const STAGES: usize = 4;
type Coefficients = [[f64; STAGES]; STAGES];

const GAMMA: f64 = 4.358_665_215_084_59e-1;
/// alpha_ij.
const ALPHA: Coefficients = [
    [0.0; 4],
    [8.717_330_430_169_18e-1, 0.0, 0.0, 0.0],
    [8.445_706_001_536_942e-1, -1.129_906_423_648_418_5e-1, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
];
/// gamma_ij.
const GAMMAS: Coefficients = [
    [GAMMA, 0.0, 0.0, 0.0],
    [-8.717_330_430_169_18e-1, GAMMA, 0.0, 0.0],
    [-9.033_805_701_304_408e-1, 5.418_067_238_809_532_6e-2, GAMMA, 0.0],
    [2.421_238_070_609_534_6e-1, -1.223_250_583_904_514_7, 5.452_602_553_351_021e-1, GAMMA],
];
/// Weights b_i of order 3 (stiffly accurate: alpha_4i + gamma_4i), less those of order 2.
const ERROR: [f64; STAGES] = [
    GAMMAS[3][0] - 3.781_090_314_581_937e-1,
    GAMMAS[3][1] + 9.604_229_221_242_318e-2,
    ALPHA[3][2] + GAMMAS[3][2] - 5.0e-1,
    GAMMA - 2.179_332_607_542_295e-1,
];
/// Error of the step of a linear oscillator, 0.0259 z^4, over the difference of the formula of order 2, 0.0396 z^3, to the power
/// of 4/3; for stiff equations both fall alike.
const CONSTANT: f64 = 1.92;
/// Estimates of order 2 below this share of a state are ignored: the step errs by less than 1e-4.
const SHORT: f64 = 6e-4;
/// The stages are solved for u = Gamma k, so that no product with the Jacobian is needed (E. Hairer, G. Wanner, Solving
/// Ordinary Differential Equations II, IV.7, eq. (7.25)): C = 1/gamma I - Gamma^-1, A = alpha Gamma^-1. The weights
/// b Gamma^-1 are the last row of A, and 1: the method is stiffly accurate.
const INVERSE: Coefficients = inverse(&GAMMAS);
const A: Coefficients = product(&ALPHA, &INVERSE);
const E: [f64; STAGES] = product(&[ERROR; STAGES], &INVERSE)[0];

impl<S: Real> Ros34Pw2<S> {
    /// The method with steps of at most `longest_step`, in s, and a tolerated drift of 1e-10 (at least the resolution of the
    /// scalar).
    pub fn new(longest_step: S) -> Self {
        let tolerance = S::lit(1e-10).max(S::lit(64.0) * S::EPSILON);
        Self {
            longest_step,
            tolerance,
            worst_error: S::lit(Ros34Pw2Formula::WORST_ERROR),
            partition: Partition::none(),
            estimate: Estimate::NONE,
        }
    }

    /// This method with another tolerance on the drift, as a fraction of the typical coordinate and velocity.
    #[must_use]
    pub fn with_tolerance(self, tolerance: S) -> Self {
        Self { tolerance, ..self }
    }
}

/// A state after a step, and the estimate of its error.
#[derive(Clone, Copy, Debug)]
pub struct Trial<X> {
    /// State after the step.
    pub x: X,
    /// Estimate of its error.
    pub error: X,
}

/// The formula, for callers that provide the rates and the linear algebra.
#[derive(Clone, Copy, Debug)]
pub struct Ros34Pw2Formula;

impl Ros34Pw2Formula {
    /// Estimated error of a step, as a fraction of the size of a state, above which it is not taken.
    pub const WORST_ERROR: f64 = 0.05;

    /// The lambda of the linear systems (lambda I - J) k = r of a step of `h`.
    #[inline]
    pub fn lambda<S: Real>(h: S) -> S {
        S::lit(1.0) / (S::lit(GAMMA) * h)
    }

    /// Makes a step of `h` from `x` at `t`: `rates` gives the rate of a stage, by its number, and `solve` the k of an r; `by_t`
    /// is the derivative of the rate by the time.
    #[inline]
    pub fn step<S: Real, X: Vector<S>>(
        (t, h): (S, S),
        (x, by_t): (&X, &X),
        mut rates: impl FnMut(usize, S, &X, &mut X),
        mut solve: impl FnMut(&X, &mut X),
    ) -> Trial<X> {
        let lit = S::lit;
        let (mut stage, mut u) = (*x, [X::fill(S::ZERO); STAGES]);
        for i in 0..STAGES {
            let (alpha, gamma): (f64, f64) = (ALPHA[i].iter().sum(), GAMMAS[i].iter().sum());
            let (a, c) = (A[i].map(lit), INVERSE[i].map(|c| lit(-c) / h));
            stage.combine(x, [(a[0], &u[0]), (a[1], &u[1]), (a[2], &u[2])]);
            let mut r = *x;
            rates(i, t + lit(alpha) * h, &stage, &mut r);
            r.add([(lit(gamma) * h, by_t)]);
            for j in 0..i {
                r.add([(c[j], &u[j])]);
            }
            solve(&r, &mut u[i]);
        }
        let ([u1, u2, u3, u4], [e1, e2, e3, e4]) = (&u, E.map(lit));
        stage.add([(lit(1.0), u4)]);
        let mut error = X::fill(S::ZERO);
        error.add([(e1, u1), (e2, u2), (e3, u3), (e4, u4)]);
        Trial { x: stage, error }
    }
}

impl<X> Trial<X> {
    /// Largest error as a fraction of the size of its state, which began as `x`.
    pub fn worst<S: Real>(&self, x: &X, typical: &X) -> S
    where
        X: Vector<S>,
    {
        (0..X::LEN).fold(S::ZERO, |worst, i| self.fraction(i, x, typical).max(worst))
    }

    /// The largest error, with its state.
    #[cold]
    pub(crate) fn largest<S: Real>(&self, x: &X, typical: &X) -> Estimate<S>
    where
        X: Vector<S>,
    {
        Estimate::largest(X::LEN, |i| self.fraction(i, x, typical))
    }

    /// Error of a state as a fraction of its size.
    #[inline]
    fn fraction<S: Real>(&self, i: usize, x: &X, typical: &X) -> S
    where
        X: Vector<S>,
    {
        let size = x.at(i).abs().max(self.x.at(i).abs()).max(typical.at(i));
        self.error.at(i).abs() / size
    }
}

/// Makes one step of `h` from the state reached.
fn step<M: Linear>(context: &mut Context<'_, M>, h: M::S) -> Result<Trial<M::X>, Fault> {
    let (mut by_x, mut by_t) = (M::Derivatives::zeros(), context.x);
    context.differentiate(&mut by_x, Some(&mut by_t))?;
    context.stats.factorisations += 1;
    let Some(resolvent) = by_x.resolvent(Ros34Pw2Formula::lambda(h), M::NQ) else {
        return Err(context.fault(Cause::Singular { rows: M::X::LEN }));
    };
    let (t, x, mut outcome) = (context.time, context.x, Ok(()));
    let rates = |_, t: M::S, x: &M::X, dx: &mut M::X| {
        if outcome.is_ok() {
            outcome = context.rate(t, x, dx);
        }
    };
    let solve = |r: &M::X, k: &mut M::X| by_x.resolve(&resolvent, M::NQ, |i| r.at(i), |i, s| k.set(i, s));
    let trial = Ros34Pw2Formula::step((t, h), (&x, &by_t), rates, solve);
    outcome.map(|()| trial)
}

impl<M: Linear> Method<M> for Ros34Pw2<M::S> {
    #[inline]
    fn name(&self) -> &'static str {
        "Ros34Pw2"
    }

    #[inline]
    fn length(&self) -> Length {
        Length::Fixed { caution: 4.0 }
    }

    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.partition = Partition::of_interval(context, self.longest_step)?;
        Ok(())
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let by_rank = context.stats.by_rank;
        let trial = step(context, self.partition.h)?;
        let typical = context.system.typical();
        let error = trial.worst(&context.x, &typical);
        self.estimate = Estimate::NONE;
        if error > self.worst_error {
            let largest = trial.largest(&context.x, &typical);
            return Err(largest.fault(context.system, context.time, self.partition.h));
        }
        if error > M::S::lit(SHORT) {
            let found = trial.largest(&context.x, &typical).of_term(CONSTANT, 4.0 / 3.0);
            // Only `worst_error` ends a run.
            self.estimate = Estimate { error: found.error.min(M::S::lit(0.99)), ..found };
        }
        self.partition.arrive(context, trial.x, self.tolerance, context.stats.by_rank > by_rank)?;
        Ok(())
    }

    fn restart(&mut self) {}

    fn fresh(&self) -> Self {
        let Self { longest_step, tolerance, worst_error, .. } = *self;
        Self { tolerance, worst_error, ..Self::new(longest_step) }
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}

impl<M: Linear> DenseOutput<M> for Ros34Pw2<M::S> {}

impl<M: Linear> ErrorControl<M> for Ros34Pw2<M::S> {}

impl<M: Linear> FixedLength<M> for Ros34Pw2<M::S> {
    #[inline]
    fn next_time(&self) -> Option<M::S> {
        Some(self.partition.next_time)
    }

    fn estimate(&self) -> Estimate<M::S> {
        self.estimate
    }

    fn shorter(&self, longest: M::S) -> Option<Self> {
        let Self { tolerance, worst_error, .. } = *self;
        Some(Self { tolerance, worst_error, ..Self::new(longest) })
    }
}

/// The product of two matrices.
const fn product(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let mut out = [[0.0; STAGES]; STAGES];
    let mut place = 0;
    while place < STAGES * STAGES {
        let (i, j) = (place / STAGES, place % STAGES);
        let mut k = 0;
        while k < STAGES {
            out[i][j] += a[i][k] * b[k][j];
            k += 1;
        }
        place += 1;
    }
    out
}

/// The inverse of a lower triangular matrix, column by column.
const fn inverse(lower: &Coefficients) -> Coefficients {
    let mut out = [[0.0; STAGES]; STAGES];
    let mut place = 0;
    while place < STAGES * STAGES {
        let (i, j) = (place % STAGES, place / STAGES);
        if i >= j {
            let mut rest = if i == j { 1.0 } else { 0.0 };
            let mut k = j;
            while k < i {
                rest -= lower[i][k] * out[k][j];
                k += 1;
            }
            out[i][j] = rest / lower[i][i];
        }
        place += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{ALPHA, ERROR, GAMMAS, STAGES};

    type Row = [f64; STAGES];

    fn times(matrix: &[Row; STAGES], v: Row) -> Row {
        matrix.map(|row| dot(row, v))
    }

    fn dot(a: Row, b: Row) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    /// The conditions of order 3 for any matrix in place of the derivatives (Hairer and Wanner II, IV.7, theorem 7.7 and
    /// eqs. (7.11'), (7.15)), those of order 2 for the weights of the error estimate, and stiff accuracy.
    #[test]
    fn order_conditions() {
        let b: Row = core::array::from_fn(|i| ALPHA[3][i] + GAMMAS[3][i]);
        let lower: Row = core::array::from_fn(|i| b[i] - ERROR[i]);
        let one = [1.0; STAGES];
        let (alpha, gamma) = (times(&ALPHA, one), times(&GAMMAS, one));
        assert!((alpha[3] - 1.0).abs() < 1e-15, "the last stage is at the end");
        for weights in [b, lower] {
            for (got, want) in
                [(dot(weights, one), 1.0), (dot(weights, alpha), 0.5), (dot(weights, gamma), 0.0)]
            {
                assert!((got - want).abs() < 1e-15, "{got} {want}");
            }
        }
        for (got, want) in [
            (dot(b, alpha.map(|a| a * a)), 1.0 / 3.0),
            (dot(b, times(&ALPHA, alpha)), 1.0 / 6.0),
            (dot(b, times(&ALPHA, gamma)), 0.0),
            (dot(b, times(&GAMMAS, alpha)), 0.0),
            (dot(b, times(&GAMMAS, gamma)), 0.0),
        ] {
            assert!((got - want).abs() < 1e-15, "{got} {want}");
        }
        assert!(
            (dot(lower, alpha.map(|a| a * a)) - 1.0 / 3.0).abs() > 1e-3,
            "the estimate is of lower order"
        );
    }
}
