//! Impacts within a time step, at the state at which the first row closes.

use super::attempt::Setting;
use super::solver::{Rule, solve};
use super::{Motion, Stride};
use crate::contact::booked::Struck;
use crate::contact::event::CLOSED;
use crate::contact::impact::{Answer, ImpactLaw, Impulses, impulses};
use crate::contact::modes::{Mode, Modes};
use crate::contact::rows::{Law, Rows, below, indices};
use crate::contact::{Contacts, sum_of};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Most successive impacts of pairs in one step.
const MOST_PAIRS: u32 = 16;

/// Diagnostics of the impacts of a step.
pub(super) struct Blow<S> {
    /// The largest residual of impacts, as a rate.
    pub(super) residual: S,
    pub(super) rounds: u32,
}

/// Impacts at a state from which the time of `rest` is left of a step of `h`. Rates of the rows and velocities become those after the
/// impacts.
pub(super) fn impacts<M: Contacts<N>, const N: usize>(
    system: &M,
    (rest, h): (&Stride<M::S>, M::S),
    (setting, u): (&Setting<M::S, N>, &M::U),
    (motion, x): (&mut Motion<M::S, M::X, N>, &mut M::X),
    blow: &mut Blow<M::S>,
) -> Result<Struck<M::S, N>, Fault> {
    let (mut struck, Setting { laws, before: modes, .. }) = (Struck::nothing(), setting);
    let left = (rest.h, h);
    let Some(mut row) = striking(left, setting, &motion.rows) else { return Ok(struck) };
    let law = system.impact_law();
    let most = if law == ImpactLaw::Sequential { MOST_PAIRS } else { 1 };
    let moved_by_time = rates_at_rest(system, rest.t, u, x);
    let touches = touches(rest.h, setting, &motion.rows, (modes, system.length()));
    for pair in 1..=most {
        let laws = laws_of_impact(h, laws, &motion.rows);
        let mut by_rounds = |rows: &Rows<M::S, N>, touches: &[bool; N]| {
            let rules = core::array::from_fn(|i| rule(&laws[i], touches[i]));
            let guess = core::array::from_fn(|i| guess(rules[i], rows.free[i]));
            let solved = solve(rows, &rules, guess);
            blow.residual = blow.residual.max(solved.residual);
            blow.rounds += solved.rounds;
            let (lambda, rate) = (solved.lambda, solved.acceleration);
            Ok(Answer { lambda, rate, is_ambiguous: false, combination: None })
        };
        let Impulses::Found(impulses, _) = impulses(&mut motion.rows, &laws, (law, touches), &mut by_rounds)
        else {
            break;
        };
        let changes = changes(&motion.rows, &impulses);
        let rate = &mut motion.rows.rate;
        let after = Vector::from_fn(|i| rate[i] + changes[i]);
        struck.add([rate, &after], &moved_by_time, &impulses).map_err(|[by, of]| {
            Fault::of_part(rest.t.to_f64(), system.contact_name(row), Cause::ImpactGains { by, of })
        })?;
        *rate = after;
        let change = sum_of(&motion.responses, &impulses);
        for v in M::NQ..2 * M::NQ {
            x.set(v, x.at(v) + change.at(v));
        }
        let next = if pair < most { striking(left, setting, &motion.rows) } else { None };
        let Some(next) = next else { break };
        row = next;
    }
    Ok(struck)
}

fn rule<S>(law: &Law<S>, touches: bool) -> Rule {
    Rule::of(law, touches)
}

fn guess<S: Real>(rule: Rule, rate: S) -> Mode {
    match rule {
        Rule::Absent(mode) => mode,
        Rule::Gap if rate >= S::ZERO => Mode::Open,
        Rule::Gap | Rule::Constraint => Mode::Closed,
        Rule::Friction => Mode::Sticks,
    }
}

/// First row that strikes: the rest of the step would close its gap, faster than accelerations make it in a step of `h`.
fn striking<S: Real, const N: usize>(
    (rest, h): (S, S),
    Setting { laws, exists, .. }: &Setting<S, N>,
    rows: &Rows<S, N>,
) -> Option<usize> {
    indices::<N>().find(|&i| {
        let i = below::<N>(i);
        let approaches = exists[i] && laws[i].is_unilateral() && rows.rate[i] < S::ZERO;
        approaches && closes(rest, rows, i) && is_fast(h, (laws, &rows.free), rows, (i, rows.rate[i]))
    })
}

/// True if a rate of a row is larger than what accelerations make of it in a step of `h`: a bounce with it lasts longer than a step.
pub(super) fn is_fast<S: Real, const N: usize>(
    h: S,
    (laws, free): (&[Law<S>; N], &[S; N]),
    rows: &Rows<S, N>,
    (i, rate): (usize, S),
) -> bool {
    // The pull on one row may act on others: a_i^2/D_ii has one unit in all rows.
    let pull = |i: usize| free[i] * free[i] / rows.delassus[i][i];
    let gaps = indices::<N>().filter(|j| laws[*j].is_unilateral() && rows.delassus[*j][*j] > S::ZERO);
    let most = gaps.fold(S::ZERO, |most, j| most.max(pull(j)));
    let i = below::<N>(i);
    rate * rate > h * h * rows.delassus[i][i] * most
}

/// The laws of an impact: a bounce that would end within a step of `h` is none.
fn laws_of_impact<S: Real, const N: usize>(h: S, laws: &[Law<S>; N], rows: &Rows<S, N>) -> [Law<S>; N] {
    core::array::from_fn(|i| match laws[i] {
        Law::Unilateral { restitution }
            if !is_fast(h, (laws, &rows.free), rows, (i, restitution * rows.rate[i])) =>
        {
            Law::Unilateral { restitution: S::ZERO }
        }
        law => law,
    })
}

/// True if the gap closes in a time without contact.
fn closes<S: Real, const N: usize>(time: S, rows: &Rows<S, N>, i: usize) -> bool {
    let i = below::<N>(i);
    let half = S::lit(0.5) * time;
    time.mul_add(half.mul_add(rows.free[i], rows.rate[i]), rows.gap[i]) < S::ZERO
}

/// Rows that take part in the impact: gaps that are closed, or that the rest of the step would close, and frictions.
fn touches<S: Real, const N: usize>(
    rest: S,
    Setting { laws, exists, .. }: &Setting<S, N>,
    rows: &Rows<S, N>,
    (modes, length): (&Modes<S, N>, S),
) -> [bool; N] {
    core::array::from_fn(|i| {
        let is_near = || {
            let was_closed = modes.of[i] == Mode::Closed || modes.carried[i];
            was_closed || rows.gap[i] <= S::lit(CLOSED) * length || closes(rest, rows, i)
        };
        exists[i] && (!laws[i].is_unilateral() || is_near())
    })
}

/// Changes of the rates of the rows by impulses.
fn changes<S: Real, const N: usize>(rows: &Rows<S, N>, impulses: &[S; N]) -> [S; N] {
    core::array::from_fn(|i| {
        let terms = rows.delassus[i].iter().zip(impulses);
        terms.fold(S::ZERO, |sum, (d, impulse)| d.mul_add(*impulse, sum))
    })
}

/// Rates of the rows that depend on time alone.
fn rates_at_rest<M: Contacts<N>, const N: usize>(system: &M, t: M::S, u: &M::U, x: &M::X) -> [M::S; N] {
    if !system.moves_by_time() {
        return [M::S::ZERO; N];
    }
    let mut rest = *x;
    for i in M::NQ..2 * M::NQ {
        rest.set(i, M::S::ZERO);
    }
    system.kinematics_at(t, u, &rest).rate
}
