//! Impacts: impulses of all rows that touch, in one problem.
//!
//! Poisson's law (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8): compression until no row
//! approaches, then expansion, which gives back the fraction e of each normal impulse. The friction of both phases is bounded by the normal
//! impulses of the phase. Newton's law asks for the rate -e times that before; with friction it can create energy. Limits that do not
//! depend on contact forces carry no impulse.

use super::candidates::{Allowed, Found, Solution, enumerate};
use super::rows::{Law, Limit, Rows};
use crate::scalar::Real;

/// The law of impact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImpactLaw {
    /// The fraction e of the impulse of compression comes back.
    #[default]
    Poisson,
    /// The fraction e of the rate of approach comes back.
    Newton,
    /// Poisson's law for one normal row after the other, the fastest approach first.
    Sequential,
}

/// Impulses of all rows.
pub(super) enum Impulses<S, const N: usize> {
    /// And whether other impulses, with other rates behind them, satisfy all inequalities as well.
    Found([S; N], bool),
    /// No combination of modes satisfies all inequalities.
    Nothing,
    /// More rows touch than are enumerated.
    TooMany,
}

/// Impulses and rates of one phase of an impact.
pub(super) struct Answer<S, const N: usize> {
    pub(super) lambda: [S; N],
    /// The rates of the rows behind it.
    pub(super) rate: [S; N],
    /// Other impulses, with other rates behind them, satisfy all inequalities as well.
    pub(super) is_ambiguous: bool,
}

/// The impulses of the rows that touch, `touches`, of which one approaches at least; `solve` solves the problem of a phase.
pub(super) fn impulses<S: Real, const N: usize>(
    rows: &Rows<S, N>,
    laws: &[Law<S>; N],
    (law, mut touches): (ImpactLaw, [bool; N]),
    solve: &mut impl FnMut(&Rows<S, N>, &[bool; N]) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Impulses<S, N> {
    if law == ImpactLaw::Sequential {
        let fastest = (0..N)
            .filter(|i| touches[*i] && laws[*i].is_unilateral())
            .reduce(|a, b| if rows.rate[b] < rows.rate[a] { b } else { a });
        for i in 0..N {
            touches[i] &= fastest == Some(i) || !laws[i].is_unilateral();
        }
    }
    let problem = without_own_limits(rows);
    let found = match law {
        ImpactLaw::Newton => newton(problem, laws, |problem| solve(problem, &touches)),
        ImpactLaw::Poisson | ImpactLaw::Sequential => {
            poisson(&problem, laws, |problem| solve(problem, &touches))
        }
    };
    found.unwrap_or_else(|none| none)
}

/// The problem of rates: accelerations are rates behind the impact, forces are impulses.
fn without_own_limits<S: Real, const N: usize>(rows: &Rows<S, N>) -> Rows<S, N> {
    let mut problem = Rows { free: rows.rate, adhesion: rows.kinetic, ..*rows };
    for friction in problem.kinetic.iter_mut().chain(&mut problem.adhesion) {
        (friction.lower.own, friction.upper.own) = (S::ZERO, S::ZERO);
    }
    problem.reaction.as_flattened_mut().iter_mut().for_each(|reaction| reaction.own = S::ZERO);
    problem
}

fn newton<S: Real, const N: usize>(
    mut problem: Rows<S, N>,
    laws: &[Law<S>; N],
    mut solve: impl FnMut(&Rows<S, N>) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Result<Impulses<S, N>, Impulses<S, N>> {
    for i in 0..N {
        if let Law::Unilateral { restitution } = laws[i] {
            problem.free[i] = problem.free[i] + restitution * problem.free[i].min(S::ZERO);
        }
    }
    let Answer { lambda, is_ambiguous, .. } = solve(&problem)?;
    Ok(Impulses::Found(lambda, is_ambiguous))
}

fn poisson<S: Real, const N: usize>(
    problem: &Rows<S, N>,
    laws: &[Law<S>; N],
    mut solve: impl FnMut(&Rows<S, N>) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Result<Impulses<S, N>, Impulses<S, N>> {
    let compression = solve(problem)?;
    let back: [S; N] = core::array::from_fn(|i| match laws[i] {
        Law::Unilateral { restitution } => restitution * compression.lambda[i],
        Law::Friction | Law::Constraint => S::ZERO,
    });
    if back.iter().all(|impulse| *impulse == S::ZERO) {
        return Ok(Impulses::Found(compression.lambda, compression.is_ambiguous));
    }
    let mut expansion = *problem;
    for i in 0..N {
        let sum = expansion.delassus[i].iter().zip(&back);
        expansion.free[i] = sum.fold(compression.rate[i], |rate, (d, back)| d.mul_add(*back, rate));
        for friction in [&mut expansion.kinetic[i], &mut expansion.adhesion[i]] {
            for limit in [&mut friction.lower, &mut friction.upper] {
                *limit = Limit { own: limit.at(&back), ..*limit };
            }
        }
        for reaction in &mut expansion.reaction[i] {
            reaction.own = reaction.at(&back);
        }
    }
    let others = solve(&expansion)?;
    let sum = |i: usize| compression.lambda[i] + back[i] + others.lambda[i];
    Ok(Impulses::Found(core::array::from_fn(sum), compression.is_ambiguous || others.is_ambiguous))
}

/// Impulses and rates of a phase, by all inequalities.
pub(super) fn by_enumeration<S: Real, const N: usize>(
    problem: &Rows<S, N>,
    laws: &[Law<S>; N],
    touches: &[bool; N],
) -> Result<Answer<S, N>, Impulses<S, N>> {
    let allowed = core::array::from_fn(|i| match laws[i].fixed(touches[i]) {
        Some(mode) => Allowed::Only(mode),
        None if laws[i].is_unilateral() => Allowed::Touching,
        None => Allowed::Resting,
    });
    match enumerate(problem, &allowed, |_, margins| margins.broken()) {
        Found::Modes(Solution { lambda, acceleration, .. }, is_ambiguous) => {
            Ok(Answer { lambda, rate: acceleration, is_ambiguous })
        }
        Found::Nothing => Err(Impulses::Nothing),
        Found::TooMany => Err(Impulses::TooMany),
    }
}
