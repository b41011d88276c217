//! Impacts: impulses of all rows that touch, in one problem.
//!
//! Poisson's law (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8): compression until no row
//! approaches, then expansion, which returns the fraction e of each normal impulse. The friction of each phase is bounded by the normal
//! impulses of that phase. Newton's law demands the rate -e times that before; with friction it can create energy. Limits that do not
//! depend on contact forces carry no impulse.
//!
//! If more rows are at rest after compression than there are degrees of freedom, its impulses are one of many solutions. Expansion returns
//! fractions of them, so that the rates after it are one of many too.

use super::candidates::{Allowed, Found, MARGINAL, Solution, enumerate, is_same_motion};
use super::loads::Load;
use super::rows::{Law, Rows, below, indices};
use crate::scalar::Real;

/// The law of impact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ImpactLaw {
    /// Expansion returns the fraction e of the impulse of compression.
    #[default]
    Poisson,
    /// The rate after the impact is the fraction e of the rate of approach.
    Newton,
    /// Poisson's law for one normal row after the other, the fastest approach first.
    Sequential,
}

/// Impulses of all rows.
pub(super) enum Impulses<S, const N: usize> {
    /// The impulses, and the ambiguities of the laws.
    Found([S; N], Doubts),
    /// No combination of modes satisfies all inequalities.
    Nothing,
    /// More rows touch than are enumerated.
    TooMany,
}

/// Ambiguities that the laws of an impact leave.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Doubts {
    /// Other impulses, with other rates after them, satisfy all inequalities as well; or another row could have been the first.
    pub is_ambiguous: bool,
    /// Compression may share its impulses otherwise, and expansion would then give other rates.
    pub is_undetermined: bool,
}

impl Doubts {
    /// Ambiguities of two impacts or phases together.
    pub(super) fn and(self, other: Self) -> Self {
        let is_undetermined = self.is_undetermined || other.is_undetermined;
        Self { is_ambiguous: self.is_ambiguous || other.is_ambiguous, is_undetermined }
    }
}

/// Impulses and rates of one phase of an impact.
pub(super) struct Answer<S, const N: usize> {
    pub(super) lambda: [S; N],
    /// Rates of the rows after the phase.
    pub(super) rate: [S; N],
    /// Other impulses, with other rates after them, satisfy all inequalities as well.
    pub(super) is_ambiguous: bool,
    /// Combination of modes of the solution, if all combinations were tried.
    pub(super) combination: Option<Solution<S, N>>,
}

/// Impulses of the rows that touch, `touches`, at least one of which approaches; `solve` solves the problem of a phase.
pub(super) fn impulses<S: Real, const N: usize>(
    rows: &mut Rows<S, N>,
    laws: &[Law<S>; N],
    (law, mut touches): (ImpactLaw, [bool; N]),
    solve: &mut impl FnMut(&Rows<S, N>, &[bool; N]) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Impulses<S, N> {
    let mut first = Doubts::default();
    if law == ImpactLaw::Sequential {
        let fastest = indices::<N>()
            .filter(|i| touches[*i] && laws[*i].is_unilateral())
            .map(below::<N>)
            .reduce(|a, b| if rows.rate[b] < rows.rate[below::<N>(a)] { b } else { a });
        first.is_ambiguous = fastest.is_some_and(|fastest| {
            indices::<N>().any(|i| touches[i] && laws[i].is_unilateral() && is_as_fast(rows, fastest, i))
        });
        for i in 0..N {
            touches[i] &= fastest == Some(i) || !laws[i].is_unilateral();
        }
    }
    let mut solve = |problem: &Rows<S, N>| solve(problem, &touches);
    let mut of_rates = |problem: &mut Rows<S, N>| match law {
        ImpactLaw::Newton => newton(problem, laws, &mut solve),
        ImpactLaw::Poisson | ImpactLaw::Sequential => poisson(problem, (laws, &touches), &mut solve),
    };
    let found = if laws.contains(&Law::Friction) {
        of_rates(&mut without_own_limits(rows))
    } else {
        // Without frictions, limits have no meaning: only the free accelerations change, and they are restored.
        let free = core::mem::replace(&mut rows.free, rows.rate);
        let found = of_rates(rows);
        rows.free = free;
        found
    };
    match found.unwrap_or_else(|none| none) {
        Impulses::Found(impulses, doubts) => Impulses::Found(impulses, doubts.and(first)),
        none => none,
    }
}

/// True if another row approaches as fast as the fastest one and their impacts influence each other: then their order decides the outcome.
fn is_as_fast<S: Real, const N: usize>(rows: &Rows<S, N>, fastest: usize, other: usize) -> bool {
    let (d, none) = (&rows.delassus, S::lit(MARGINAL));
    let [fastest, other] = [fastest, other].map(below::<N>);
    let couples = d[fastest][other].abs() > none * (d[fastest][fastest] * d[other][other]).sqrt();
    let apart = (rows.rate[other] - rows.rate[fastest]).abs();
    other != fastest && couples && apart <= none * rows.rate[fastest].abs()
}

/// Problem of the rates: accelerations stand for the rates after the impact, forces for impulses.
fn without_own_limits<S: Real, const N: usize>(rows: &Rows<S, N>) -> Rows<S, N> {
    let mut problem = Rows { free: rows.rate, adhesion: rows.kinetic, ..*rows };
    for i in 0..N {
        for friction in [&mut problem.kinetic[i], &mut problem.adhesion[i]] {
            (friction.lower.own, friction.upper.own) = (S::ZERO, S::ZERO);
        }
        for reaction in &mut problem.reaction[i] {
            reaction.own = S::ZERO;
        }
    }
    problem
}

fn newton<S: Real, const N: usize>(
    problem: &mut Rows<S, N>,
    laws: &[Law<S>; N],
    mut solve: impl FnMut(&Rows<S, N>) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Result<Impulses<S, N>, Impulses<S, N>> {
    for i in 0..N {
        if let Law::Unilateral { restitution } = laws[i] {
            problem.free[i] = problem.free[i] + restitution * problem.free[i].min(S::ZERO);
        }
    }
    let Answer { lambda, is_ambiguous, .. } = solve(problem)?;
    Ok(Impulses::Found(lambda, Doubts { is_ambiguous, ..Doubts::default() }))
}

fn poisson<S: Real, const N: usize>(
    problem: &mut Rows<S, N>,
    (laws, touches): (&[Law<S>; N], &[bool; N]),
    mut solve: impl FnMut(&Rows<S, N>) -> Result<Answer<S, N>, Impulses<S, N>>,
) -> Result<Impulses<S, N>, Impulses<S, N>> {
    let compression = solve(problem)?;
    let combination = compression.combination.as_ref();
    let is_undetermined = combination.is_some_and(|found| is_shared(problem, laws, (touches, found)));
    let doubts = Doubts { is_ambiguous: compression.is_ambiguous, is_undetermined };
    let back = given_back(laws, &compression.lambda);
    if back.iter().all(|impulse| *impulse == S::ZERO) {
        return Ok(Impulses::Found(compression.lambda, doubts));
    }
    // From here on the problem is that of expansion.
    for i in 0..N {
        let sum = problem.delassus[i].iter().zip(&back);
        problem.free[i] = sum.fold(compression.rate[i], |rate, (d, back)| d.mul_add(*back, rate));
        if let Law::Friction = laws[i] {
            for friction in [&mut problem.kinetic[i], &mut problem.adhesion[i]] {
                friction.lower.own = friction.lower.at(&back);
                friction.upper.own = friction.upper.at(&back);
            }
        }
        if problem.load[i] != Load::Nothing {
            for reaction in &mut problem.reaction[i] {
                reaction.own = reaction.at(&back);
            }
        }
    }
    let others = solve(problem)?;
    let sum = |i: usize| compression.lambda[i] + back[i] + others.lambda[i];
    let other = Doubts { is_ambiguous: others.is_ambiguous, ..Doubts::default() };
    Ok(Impulses::Found(core::array::from_fn(sum), doubts.and(other)))
}

/// Least impulses of expansion: the fractions of the impulses of compression.
fn given_back<S: Real, const N: usize>(laws: &[Law<S>; N], compression: &[S; N]) -> [S; N] {
    core::array::from_fn(|i| match laws[i] {
        Law::Unilateral { restitution } => restitution * compression[i],
        Law::Friction | Law::Constraint => S::ZERO,
    })
}

/// True if rows may share the impulses of a compression otherwise, with equal rates after it and other rates after the expansion. All
/// solutions of a compression lie between those with independent rows, which are among the combinations.
fn is_shared<S: Real, const N: usize>(
    problem: &Rows<S, N>,
    laws: &[Law<S>; N],
    (touches, compression): (&[bool; N], &Solution<S, N>),
) -> bool {
    let gives_back = |law: &Law<S>| matches!(law, Law::Unilateral { restitution } if *restitution > S::ZERO);
    if !compression.carried.contains(&true) || !laws.iter().any(gives_back) {
        return false;
    }
    let known = given_back(laws, &compression.lambda);
    let mut differs = false;
    let _ = enumerate(problem, &allowed(laws, touches), |solution, margins| {
        let broken = margins.broken();
        if !broken.contains(&true) && is_same_motion(problem, compression, solution) {
            let back = given_back(laws, &solution.lambda);
            differs |= indices::<N>().any(|i| {
                let terms = indices::<N>().map(|j| (problem.delassus[i][j], known[j], back[j]));
                let (apart, size) = terms.fold((S::ZERO, S::ZERO), |(apart, size), (d, one, other)| {
                    (d.mul_add(one - other, apart), size + d.abs() * (one.abs() + other.abs()))
                });
                apart.abs() > S::lit(4.0 * MARGINAL) * size
            });
        }
        broken
    });
    differs
}

/// Impulses and rates of a phase, from the enumeration of all modes.
pub(super) fn by_enumeration<S: Real, const N: usize>(
    problem: &Rows<S, N>,
    laws: &[Law<S>; N],
    touches: &[bool; N],
) -> Result<Answer<S, N>, Impulses<S, N>> {
    match enumerate(problem, &allowed(laws, touches), |_, margins| margins.broken()) {
        Found::Modes(found, is_ambiguous) => {
            let (lambda, rate) = (found.lambda, found.acceleration);
            Ok(Answer { lambda, rate, is_ambiguous, combination: Some(found) })
        }
        Found::Nothing => Err(Impulses::Nothing),
        Found::TooMany => Err(Impulses::TooMany),
    }
}

/// Modes that each row may have in an impact.
fn allowed<S: Real, const N: usize>(laws: &[Law<S>; N], touches: &[bool; N]) -> [Allowed; N] {
    core::array::from_fn(|i| match laws[i].fixed(touches[i]) {
        Some(mode) => Allowed::Only(mode),
        None if laws[i].is_unilateral() => Allowed::Touching,
        None => Allowed::Resting,
    })
}
