//! Gauss collocation with steps of equal length, for long runs.

mod tableau;

use plm_math::exact::two_sum;

use self::tableau::{Legendre, Nodes, Tableau};
use super::estimate::{Estimate, Sizes};
use super::partition::Partition;
use super::{Context, DenseOutput, ErrorControl, FixedLength, Method, drift_of_size};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::system::{Drift, System};
use crate::vector::Vector;
use crate::words::{InWords, Words};

/// Gauss collocation with 2 (order 4) or 3 stages (order 6) and steps of equal length: symplectic and time-reversible.
///
/// Over long runs the energy of a conservative system oscillates and does not drift (E. Hairer, C. Lubich, G. Wanner, Geometric
/// Numerical Integration, VI.4, IX.8). The stages are iterated until rounding stops them, and the rounding errors of the sum
/// over the steps are carried along, so that rounding does not drift either (the same, VIII.5 and VIII.6). Fixed-point
/// iteration: for equations that are not stiff. A projection onto constraints breaks the symmetry; it takes place only if the
/// state drifted by more than the tolerance.
#[derive(Clone, Copy, Debug)]
pub struct Gauss<M: System, const STAGES: usize> {
    /// Longest step, s.
    pub longest_step: M::S,
    /// Tolerated drift, as a fraction of the typical coordinate and velocity.
    pub tolerance: M::S,
    partition: Partition<M::S>,
    /// Rates of the last stages, and the length of their step.
    last: Option<([M::X; STAGES], M::S)>,
    /// Rounding errors of the last sums.
    rounded: M::X,
    /// Error of the last step.
    estimate: Estimate<M::S>,
}

/// Most iterations for the stages.
const MOST_ITERATIONS: usize = 100;
/// Changes below this fraction of the state, as a multiple of the distance from 1 to the next number, may be rounding.
const ROUNDING: f64 = 65_536.0;

impl<M: System<S: Real>, const STAGES: usize> Gauss<M, STAGES> {
    /// The method with steps of at most `longest_step`, in s, and a tolerated drift of 1e-10 (at least the resolution of the
    /// scalar).
    pub fn new(longest_step: M::S) -> Self {
        Self {
            longest_step,
            tolerance: M::S::lit(1e-10).max(M::S::lit(64.0) * M::S::EPSILON),
            partition: Partition::none(),
            last: None,
            rounded: M::X::fill(M::S::ZERO),
            estimate: Estimate::NONE,
        }
    }

    /// This method with another tolerance on the drift, as a fraction of the typical coordinate and velocity.
    #[must_use]
    pub fn with_tolerance(self, tolerance: M::S) -> Self {
        Self { tolerance, ..self }
    }

    /// Rates of the stages at which the iteration begins: the polynomial of the last step continued (the same, VIII.6.1), or
    /// the rate at the start of the step.
    fn first_guess(
        &self,
        context: &mut Context<'_, M>,
        tableau: &Tableau<M::S, STAGES>,
    ) -> Result<[M::X; STAGES], Fault>
    where
        Legendre: Nodes<STAGES>,
    {
        let Some((last, h)) = &self.last else {
            let (x, mut rate) = (context.x, context.x);
            context.rate(context.time, &x, &mut rate)?;
            return Ok([rate; STAGES]);
        };
        let ratio = self.partition.h / *h;
        Ok(core::array::from_fn(|i| {
            let theta = tableau.c[i].mul_add(ratio, M::S::lit(1.0));
            let mut rate = M::X::fill(M::S::ZERO);
            for (j, k) in last.iter().enumerate() {
                rate.add([(tableau.lagrange(j, theta), k)]);
            }
            rate
        }))
    }

    /// Increments h b_i k_i of the stages, and their states. Coordinates follow from the velocities of the stages, not from
    /// those of the last iteration: for q'' = f(q) an iteration then gains a factor of order h^2.
    fn stages(
        &self,
        x: &M::X,
        tableau: &Tableau<M::S, STAGES>,
        rates: &[M::X; STAGES],
    ) -> ([M::X; STAGES], [M::X; STAGES])
    where
        Legendre: Nodes<STAGES>,
    {
        let weights = Tableau::<M::S, STAGES>::weights(self.partition.h);
        let mut increments: [M::X; STAGES] = core::array::from_fn(|i| rates[i].map(|rate| weights[i] * rate));
        let mut states = [*x; STAGES];
        let state = |i: usize, k: usize, increments: &[M::X; STAGES]| {
            let terms = tableau.mu[i].iter().zip(increments);
            let sum = terms.fold(self.rounded.at(k), |sum, (mu, step)| mu.mul_add(step.at(k), sum));
            x.at(k) + sum
        };
        for i in 0..STAGES {
            for k in M::NQ..M::X::LEN {
                states[i].set(k, state(i, k, &increments));
            }
            for k in 0..M::NQ {
                increments[i].set(k, weights[i] * states[i].at(M::NQ + k));
            }
        }
        for i in 0..STAGES {
            for k in 0..M::NQ {
                states[i].set(k, state(i, k, &increments));
            }
        }
        (increments, states)
    }

    /// Iterates the stages until no component comes nearer any more (Antoñana, Makazaga, Murua, section 3.1), and
    /// returns the increments.
    fn solve(&mut self, context: &mut Context<'_, M>) -> Result<[M::X; STAGES], Fault>
    where
        Legendre: Nodes<STAGES>,
    {
        let tableau = Tableau::new();
        let (time, h, x) = (context.time, self.partition.h, context.x);
        let typical = context.system.typical();
        let mut rates = self.first_guess(context, &tableau)?;
        let (_, mut states) = self.stages(&x, &tableau, &rates);
        let mut least = M::X::fill(M::S::INFINITY);
        for _ in 0..MOST_ITERATIONS {
            for (i, (state, rate)) in states.iter().zip(&mut rates).enumerate() {
                // Stages that diverge are those of a step that is too long; the state at its beginning is finite.
                context.rate(time + tableau.c[i] * h, state, rate).map_err(|fault| match fault.cause {
                    Cause::NotFinite => context.fault(Cause::NotConverged { step: h.to_f64() }),
                    _ => fault,
                })?;
            }
            let (increments, next) = self.stages(&x, &tableau, &rates);
            let (mut nearer, mut is_small) = (false, true);
            for k in 0..M::X::LEN {
                let changes = states.iter().zip(&next).map(|(old, new)| (new.at(k) - old.at(k)).abs());
                let change = changes.fold(M::S::ZERO, |most, change| change.max(most));
                let size = typical.at(k).max(x.at(k).abs());
                is_small &= change <= M::S::lit(ROUNDING) * M::S::EPSILON * size;
                if change > M::S::ZERO && change < least.at(k) {
                    least.set(k, change);
                    nearer = true;
                }
            }
            states = next;
            if is_small && !nearer {
                self.last = Some((rates, h));
                return Ok(increments);
            }
        }
        Err(context.fault(Cause::NotConverged { step: h.to_f64() }))
    }

    /// Error of a step from `x` to `next`. Positions give the third term of Taylor's series by the trapezoidal rule; the
    /// differences of the rates give the third term for three stages, the second one for two.
    fn error(&self, system: &M, [x, next]: [&M::X; 2], increments: &[M::X; STAGES]) -> Estimate<M::S>
    where
        Legendre: Nodes<STAGES>,
    {
        let (h, order) = (self.partition.h, (2 * STAGES + 1) as f64);
        let sizes = Sizes { typical: system.typical(), from: x, to: next };
        let third =
            |i: usize| if i < M::NQ { M::S::lit(12.0) * sizes.bend((i, M::NQ, h)) } else { M::S::ZERO };
        let stage = |k: usize, i: usize| increments[k].at(i) / M::S::lit(Legendre::B[k]);
        let apart = M::S::lit(Legendre::C[1] - Legendre::C[0]);
        let differs = |i: usize| {
            if i < M::NQ {
                return M::S::ZERO;
            }
            let (first, last) = (stage(1, i) - stage(0, i), stage(STAGES - 1, i) - stage(STAGES - 2, i));
            let term = if STAGES == 2 { first / apart } else { (last - first) / (apart * apart) };
            term.abs() / sizes.of(i)
        };
        let constant = Legendre::ERROR;
        let places = Estimate::largest(M::X::LEN, third).of_term(constant, order / 3.0);
        let rates = Estimate::largest(M::X::LEN, differs).of_term(constant, order / STAGES as f64);
        if places.error < rates.error { rates } else { places }
    }

    /// State after the step: the sum of the increments, with the rounding errors of earlier sums.
    fn sum(&mut self, x: &M::X, increments: &[M::X; STAGES]) -> M::X {
        let rounded = self.rounded;
        M::X::from_fn(|k| {
            let step = increments.iter().fold(rounded.at(k), |sum, increment| sum + increment.at(k));
            let (sum, rest) = two_sum(x.at(k), step);
            self.rounded.set(k, rest);
            sum
        })
    }
}

impl<M: System<S: Real> + Copy, const STAGES: usize> Method<M> for Gauss<M, STAGES>
where
    Legendre: Nodes<STAGES>,
{
    #[inline]
    fn name(&self) -> &'static str {
        "Gauss"
    }

    fn begin(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        self.partition = Partition::of_interval(context, self.longest_step)?;
        Ok(())
    }

    fn advance(&mut self, context: &mut Context<'_, M>) -> Result<(), Fault> {
        let by_rank = context.stats.by_rank;
        let increments = self.solve(context)?;
        let next = self.sum(&context.x, &increments);
        self.estimate = self.error(context.system, [&context.x, &next], &increments);
        if self.partition.arrive(context, next, self.tolerance, context.stats.by_rank > by_rank)? {
            self.rounded = M::X::fill(M::S::ZERO);
        }
        Ok(())
    }

    fn restart(&mut self) {
        self.last = None;
        self.rounded = M::X::fill(M::S::ZERO);
    }

    fn fresh(&self) -> Self {
        Self::new(self.longest_step).with_tolerance(self.tolerance)
    }

    fn drift_limit(&self, system: &M) -> Drift<M::S> {
        drift_of_size(system, self.tolerance)
    }
}

impl<M: System<S: Real> + Copy, const STAGES: usize> DenseOutput<M> for Gauss<M, STAGES> where
    Legendre: Nodes<STAGES>
{
}

impl<M: System<S: Real> + Copy, const STAGES: usize> ErrorControl<M> for Gauss<M, STAGES> where
    Legendre: Nodes<STAGES>
{
}

impl<M: System<S: Real> + Copy, const STAGES: usize> FixedLength<M> for Gauss<M, STAGES>
where
    Legendre: Nodes<STAGES>,
{
    #[inline]
    fn next_time(&self) -> Option<M::S> {
        Some(self.partition.next_time)
    }

    fn estimate(&self) -> Estimate<M::S> {
        self.estimate
    }

    fn shorter(&self, longest: M::S) -> Option<Self> {
        Some(Self::new(longest).with_tolerance(self.tolerance))
    }
}

/// Options, and the data that one step leaves for the next: the rates of its stages, and the rounding errors of its sums.
impl<M: System<S: Real>, const STAGES: usize> InWords for Gauss<M, STAGES> {
    fn each(&mut self, words: &mut impl Words) {
        words.numbers([&mut self.longest_step, &mut self.tolerance]);
        let blank = ([M::X::fill(M::S::ZERO); STAGES], M::S::ZERO);
        words.perhaps(&mut self.last, blank, |words, (rates, h)| {
            for rate in rates {
                words.vector(rate);
            }
            words.number(h);
        });
        words.vector(&mut self.rounded);
    }
}
