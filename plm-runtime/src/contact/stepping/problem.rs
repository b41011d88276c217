//! Contact problem of a time step: accelerations over it, complementary to the forces of the rows; and the correction of constraint
//! rows.

use super::Stride;
use super::solver::{Rule, Solved, eliminate, solve};
use crate::contact::modes::{Mode, Modes};
use crate::contact::rows::{Law, Rows, below};
use crate::scalar::Real;

/// Rate, as a fraction of the change by accelerations in a step, below which a friction is assumed to stick at first.
pub(in crate::contact) const NO_SLIP: f64 = 1e-9;

/// Rows of a step. Their free accelerations become the rates at the end of the step without contact forces over its length, with
/// `slack`.
pub(super) struct Problem<S, const N: usize> {
    rules: [Rule; N],
    guess: [Mode; N],
    /// Part of the free acceleration that allows a gap to close within the step.
    slack: [S; N],
    h: S,
}

impl<S: Real, const N: usize> Problem<S, N> {
    /// Problem of the rows at the intermediate place, after impacts; `before` are the modes before the step.
    pub(super) fn of(
        stride: &Stride<S>,
        (laws, exists): (&[Law<S>; N], &[bool; N]),
        rows: &mut Rows<S, N>,
        before: &Modes<S, N>,
    ) -> Self {
        let ([ahead, behind], inverse) = (stride.parts(), S::lit(1.0) / stride.h);
        let rules = core::array::from_fn(|i| Rule::of(&laws[i], exists[i]));
        let (share, closing) = (ahead * inverse, inverse / behind);
        let fastest = rows.free.iter().fold(S::ZERO, |most, free| most.max(free.abs()));
        let none = S::lit(NO_SLIP).max(S::lit(64.0) * S::EPSILON) * stride.h * fastest;
        let mut problem = Self { rules, guess: before.of, slack: [S::ZERO; N], h: stride.h };
        for i in 0..N {
            // (3): free acceleration and bias are those of the intermediate place.
            let over_step = rows.rate[i].mul_add(inverse, rows.free[i] - share * rows.bias[i]);
            if rules[i] == Rule::Gap {
                let gap = at_standstill(stride, rows, i).max(S::ZERO);
                problem.slack[i] = gap * closing;
            }
            rows.free[i] = over_step + problem.slack[i];
            problem.guess[i] = match rules[i] {
                Rule::Absent(mode) => mode,
                Rule::Constraint => Mode::Closed,
                Rule::Gap if rows.free[i] < S::ZERO => Mode::Closed,
                Rule::Gap => Mode::Open,
                Rule::Friction if before.is_sticking(i) => Mode::Sticks,
                Rule::Friction => slip(rows.rate[i], none),
            };
        }
        problem
    }

    /// Solves for the forces over the step.
    pub(super) fn solve(&self, rows: &Rows<S, N>) -> Solved<S, N> {
        solve(rows, &self.rules, self.guess)
    }

    /// Rate of a row at the end of the step.
    pub(super) fn rate_at_end(&self, solved: &Solved<S, N>, i: usize) -> S {
        let i = below::<N>(i);
        self.h * (solved.acceleration[i] - self.slack[i])
    }
}

/// First guess of the mode of a friction.
fn slip<S: Real>(rate: S, none: S) -> Mode {
    if rate > none {
        Mode::Forwards
    } else if rate < -none {
        Mode::Backwards
    } else {
        Mode::Sticks
    }
}

/// Displacement of a row at the end of a step if its rate there is zero: a parabola from the intermediate place.
fn at_standstill<S: Real, const N: usize>(stride: &Stride<S>, rows: &Rows<S, N>, i: usize) -> S {
    let [_, after] = stride.parts();
    let i = below::<N>(i);
    rows.gap[i] - S::lit(0.5) * after * after * rows.bias[i]
}

/// Displacement of a row at the end of a step with a rate there.
pub(super) fn end<S: Real, const N: usize>(stride: &Stride<S>, rows: &Rows<S, N>, i: usize, rate: S) -> S {
    let [_, after] = stride.parts();
    after.mul_add(rate, at_standstill(stride, rows, i))
}

/// Time, from 0 to the length of the step, after which a gap closes that is open and has a rate at the end of the step; `None` if it stays
/// open. The gap is the parabola `z_m + (t - t_m) w v + (t - t_m)^2 zeta/2 + theta t^2 w a` about the intermediate place.
pub(super) fn first_closing<S: Real, const N: usize>(
    stride: &Stride<S>,
    rows: &Rows<S, N>,
    (i, rate_at_end): (usize, S),
) -> Option<S> {
    let ([ahead, after], half, i) = (stride.parts(), S::lit(0.5), below::<N>(i));
    let (gap, rate, bias) = (rows.gap[i], rows.rate[i], rows.bias[i]);
    let pull = (rate_at_end - rate - after * bias) / stride.h;
    let c = gap - ahead * rate + half * ahead * ahead * bias;
    let b = rate - ahead * bias;
    let a = stride.theta * pull + half * bias;
    if c <= S::ZERO {
        return Some(S::ZERO);
    }
    // The first root of a t^2 + b t + c, without cancellation.
    let two = S::lit(2.0);
    let time = two * c / ((b * b - two * two * a * c).max(S::ZERO).sqrt() - b);
    // False for NaN.
    let is_within = time >= S::ZERO && time <= stride.h;
    is_within.then_some(time)
}

/// Displacements of constraint rows from their places at the end of a step; zero for a gap that closes there.
pub(super) fn away<S: Real, const N: usize>(
    stride: &Stride<S>,
    rows: &Rows<S, N>,
    solved: &Solved<S, N>,
    before: &Modes<S, N>,
) -> [S; N] {
    core::array::from_fn(|i| match (solved.modes[i], solved.rules[i]) {
        (Mode::Closed, Rule::Gap) => at_standstill(stride, rows, i).min(S::ZERO),
        (Mode::Closed, _) => at_standstill(stride, rows, i),
        (Mode::Sticks, _) if before.of[i] == Mode::Sticks => at_standstill(stride, rows, i) - before.place[i],
        _ => S::ZERO,
    })
}

/// Factors of the responses that correct these displacements of constraint rows; `None` if there are none. The free accelerations of
/// the rows are overwritten.
pub(super) fn lead_back<S: Real, const N: usize>(
    rows: &mut Rows<S, N>,
    modes: &[Mode; N],
    away: &[S; N],
) -> Option<[S; N]> {
    if away.iter().all(|displacement| *displacement == S::ZERO) {
        return None;
    }
    let only = modes.map(|mode| if mode.holds() { mode } else { Mode::Open });
    rows.free = *away;
    Some(eliminate(rows, &only, &[[S::ZERO; 2]; N]).0)
}
