//! Impacts of a time step: rows with restitution that the step would close, solved before its forces.

use super::solver::{Rule, solve};
use super::{Motion, Stride, problem};
use crate::contact::booked::Struck;
use crate::contact::event::CLOSED;
use crate::contact::impact::{Answer, ImpactLaw, Impulses, impulses};
use crate::contact::modes::{Mode, Modes};
use crate::contact::rows::{Law, Rows, below, indices};
use crate::contact::{Contacts, Modal, sum_of};
use crate::fault::{Cause, Fault};
use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// Most successive impacts of pairs in one step.
const MOST_PAIRS: u32 = 16;

/// Progress of a step.
pub(super) struct Progress<S> {
    /// The largest residual of impacts, as a rate.
    pub(super) residual: S,
    pub(super) rounds: u32,
}

/// Impacts at the beginning of the step. Rates of the rows, velocities and the intermediate place become those
/// after the impacts.
pub(super) fn impacts<M: Contacts<N>, const N: usize>(
    system: &M,
    stride: &Stride<M::S>,
    (laws, exists): (&[Law<M::S>; N], &[bool; N]),
    u: &M::U,
    (motion, x): (&mut Motion<M::S, M::X, N>, &mut M::X),
    progress: &mut Progress<M::S>,
) -> Result<Struck<M::S, N>, Fault> {
    let mut struck = Struck::nothing();
    let Some(mut row) = striking(stride, (laws, exists), &motion.rows) else { return Ok(struck) };
    let law = system.impact_law();
    let most = if law == ImpactLaw::Sequential { MOST_PAIRS } else { 1 };
    let moved_by_time = rates_at_rest(system, stride, u, x);
    let touches = touches(stride, (laws, exists), &motion.rows, (u.modes(), system.length()));
    for pair in 1..=most {
        let mut by_rounds = |rows: &Rows<M::S, N>, touches: &[bool; N]| {
            let rules = core::array::from_fn(|i| rule(&laws[i], touches[i]));
            let guess = core::array::from_fn(|i| guess(rules[i], rows.free[i]));
            let solved = solve(rows, &rules, guess);
            progress.residual = progress.residual.max(solved.residual);
            progress.rounds += solved.rounds;
            let (lambda, rate) = (solved.lambda, solved.acceleration);
            Ok(Answer { lambda, rate, is_ambiguous: false, combination: None })
        };
        let Impulses::Found(impulses, _) = impulses(&mut motion.rows, laws, (law, touches), &mut by_rounds)
        else {
            break;
        };
        let ([before, _], changes) = (stride.parts(), changes(&motion.rows, &impulses));
        let Rows { gap, rate, .. } = &mut motion.rows;
        let after = Vector::from_fn(|i| rate[i] + changes[i]);
        struck.add([rate, &after], &moved_by_time, &impulses).map_err(|[by, of]| {
            Fault::of_part(stride.t.to_f64(), system.contact_name(row), Cause::ImpactGains { by, of })
        })?;
        *rate = after;
        for i in 0..N {
            gap[i] = before.mul_add(changes[i], gap[i]);
        }
        let change = sum_of(&motion.responses, &impulses);
        for i in 0..M::NQ {
            let v = M::NQ + i;
            x.set(v, x.at(v) + change.at(v));
            x.set(i, before.mul_add(change.at(v), x.at(i)));
        }
        let next = if pair < most { striking(stride, (laws, exists), &motion.rows) } else { None };
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

/// First row that strikes: the step would close its gap, and its bounce would last longer than a step.
fn striking<S: Real, const N: usize>(
    stride: &Stride<S>,
    (laws, exists): (&[Law<S>; N], &[bool; N]),
    rows: &Rows<S, N>,
) -> Option<usize> {
    // The pull on one row may act on others: a_i^2/D_ii has one unit in all rows.
    let pull = |i: usize| rows.free[i] * rows.free[i] / rows.delassus[i][i];
    let mut most = None;
    indices::<N>().find(|&i| {
        let i = below::<N>(i);
        let Law::Unilateral { restitution } = laws[i] else { return false };
        let approaches = exists[i] && rows.rate[i] < S::ZERO && restitution > S::ZERO;
        if !approaches || !closes(stride, rows, i) {
            return false;
        }
        let most = *most.get_or_insert_with(|| {
            let gaps = indices::<N>().filter(|j| laws[*j].is_unilateral() && rows.delassus[*j][*j] > S::ZERO);
            gaps.fold(S::ZERO, |most, j| most.max(pull(j)))
        });
        let (bounce, h) = (restitution * rows.rate[i], stride.h);
        bounce * bounce > h * h * rows.delassus[i][i] * most
    })
}

/// True if the step would close the gap without contact.
fn closes<S: Real, const N: usize>(stride: &Stride<S>, rows: &Rows<S, N>, i: usize) -> bool {
    let ([before, _], i) = (stride.parts(), below::<N>(i));
    let rate = stride.h.mul_add(rows.free[i], rows.rate[i]) - before * rows.bias[i];
    problem::end(stride, rows, i, rate) < S::ZERO
}

/// Rows that take part in the impact: gaps that are closed, or that the step would close, and frictions.
fn touches<S: Real, const N: usize>(
    stride: &Stride<S>,
    (laws, exists): (&[Law<S>; N], &[bool; N]),
    rows: &Rows<S, N>,
    (modes, length): (&Modes<S, N>, S),
) -> [bool; N] {
    core::array::from_fn(|i| {
        let is_near = || {
            let was_closed = modes.of[i] == Mode::Closed || modes.carried[i];
            was_closed || rows.gap[i] <= S::lit(CLOSED) * length || closes(stride, rows, i)
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
fn rates_at_rest<M: Contacts<N>, const N: usize>(
    system: &M,
    stride: &Stride<M::S>,
    u: &M::U,
    x: &M::X,
) -> [M::S; N] {
    if !system.moves_by_time() {
        return [M::S::ZERO; N];
    }
    let ([before, _], mut rest) = (stride.parts(), *x);
    for i in M::NQ..2 * M::NQ {
        rest.set(i, M::S::ZERO);
    }
    system.kinematics_at(stride.t + before, u, &rest).rate
}
