//! Rows of contact where the motion is known: gaps, rates, accelerations without contact forces, Delassus operator, limits.
//!
//! The forces of contact stand in the loads with their multipliers as symbols, so that every formulation gives accelerations that
//! are affine in them, `a = a_0 + sum_j a_j lambda_j`. With `z'' = w a + zeta`
//!
//! ```text
//! (1)  c_i  = w_i a_0 + zeta_i
//! (2)  D_ij = d(w_i a)/d lambda_j
//! ```
//!
//! (F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 4).

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use super::function::{Function, Place};
use super::rows::{OfRows, RowTerm};
use super::sliding::{self, Sliding};
use crate::derive::Equations;
use crate::model::{ContactLaw, Model, Step, bounding_reactions};

/// Functions of the rows of contact.
pub(crate) struct ContactFunctions {
    /// `rows.gap` and `rows.rate`.
    pub(crate) kinematics: Function,
    /// `dx` without contact forces, `response`, by which a multiplier of one changes it, and the rest of `rows`. It returns what the rate
    /// returns.
    pub(crate) motion: Function,
    /// Both in one, where a step of Moreau and Jean is ordered, which needs all of it.
    pub(crate) together: Option<Function>,
    /// Rates are not zero where velocities are: rows, or joints, move by the time.
    pub(crate) moves_by_time: bool,
    /// The rate is `dx` and the sum of the responses times their multipliers.
    pub(crate) is_affine: bool,
    /// Frictions that all slip, where something else than pushes bounds one.
    pub(crate) sliding: Option<Sliding>,
}

/// A motion whose accelerations are known.
pub(super) struct Accelerated<'a> {
    /// Accelerations of all bodies, three each.
    pub(super) bodies: &'a [Expr],
    /// Results of the rate: `dx`, and what it returns.
    pub(super) rate: &'a [(Place, Expr)],
    /// Number of the coordinates of the state; their accelerations stand after their velocities in `dx`.
    pub(super) coordinates: usize,
    /// Values for the symbols of the model.
    pub(super) substitution: &'a [(Expr, Expr)],
    /// Multipliers of the joints, in the order of the rows.
    pub(super) reactions: &'a [Expr],
    /// Symbols of the accelerations of the coordinates.
    pub(super) second: &'a [Expr],
    /// Multipliers of the joints by those symbols, where that takes fewer operations.
    pub(super) by_second: &'a [Expr],
}

/// The functions of the rows of contact; none if there are no rows.
pub(super) fn functions(
    model: &Model,
    equations: &Equations,
    motion: &Accelerated,
) -> Option<ContactFunctions> {
    if model.contacts.is_empty() {
        return None;
    }
    let lambda: Vec<Expr> = model.contacts.iter().map(|contact| contact.lambda).collect_vec();
    let without: Vec<(Expr, Expr)> = lambda.iter().map(|&symbol| (symbol, Expr::ZERO)).collect_vec();
    let mut rows = accelerations(model, equations, motion, &lambda);
    rows.extend(limits(model, motion, &lambda));
    rows.extend(reactions(model, equations, motion, &lambda));
    let (response, is_affine) = response(motion, &lambda);
    rows.extend(response);
    let rows = without_zeros(Function::of_results(rows).substitute(&without));
    let rate = Function::of_results(motion.rate.to_vec()).substitute(&without);
    let results = rate.results.into_iter().chain(rows.results).collect_vec();
    let kinematics = kinematics(model, equations, motion);
    let together = model.steps.contains(&Step::MoreauJean).then(|| {
        let results = kinematics.results.iter().chain(&results).cloned().collect_vec();
        Function::of_results(results).optimise()
    });
    Some(ContactFunctions {
        kinematics: kinematics.optimise(),
        motion: Function::of_results(results).optimise(),
        together,
        moves_by_time: moves_by_time(equations),
        is_affine,
        sliding: if is_affine { sliding::functions(model, equations, motion) } else { None },
    })
}

/// Are there rates of rows or of joints that are not zero where velocities are?
fn moves_by_time(equations: &Equations) -> bool {
    let at_rest: Vec<(Expr, Expr)> = equations.v.iter().map(|&v| (v, Expr::ZERO)).collect_vec();
    let rates = equations.contacts.iter().map(|row| row.rate).chain(equations.phi_dot.iter().copied());
    algebra::substitute(&rates.collect_vec(), &at_rest).into_iter().any(|rate| !rate.is_zero())
}

/// Gaps and rates.
fn kinematics(model: &Model, equations: &Equations, motion: &Accelerated) -> Function {
    let here = |expr: Expr| algebra::substitute(&[expr], motion.substitution)[0];
    let mut results = Vec::new();
    for (i, (contact, row)) in model.contacts.iter().zip(&equations.contacts).enumerate() {
        results.push((Place::Rows(OfRows::Gap(i)), here(contact.displacement)));
        results.push((Place::Rows(OfRows::Rate(i)), here(row.rate)));
    }
    without_zeros(Function::of_results(results))
}

/// (1) with the multipliers still in it, and (2).
fn accelerations(
    model: &Model,
    equations: &Equations,
    motion: &Accelerated,
    lambda: &[Expr],
) -> Vec<(Place, Expr)> {
    let here = |expr: Expr| algebra::substitute(&[expr], motion.substitution)[0];
    let mut results = Vec::new();
    for i in 0..model.contacts.len() {
        let row = &equations.contacts[i];
        let terms = row.direction.iter().map(|&(k, entry)| here(entry) * motion.bodies[k]);
        let along: Expr = terms.sum();
        results.push((Place::Rows(OfRows::Free(i)), along + here(row.bias)));
        results.push((Place::Rows(OfRows::Bias(i)), here(row.bias)));
        let columns = lambda.iter().enumerate();
        results
            .push_all(columns.map(|(j, &lambda)| (Place::Rows(OfRows::Delassus(i, j)), along.diff(lambda))));
    }
    results
}

/// Limits of frictions, each what it is by itself, and its factors of the multipliers and of the sizes of reactions.
fn limits(model: &Model, motion: &Accelerated, lambda: &[Expr]) -> Vec<(Place, Expr)> {
    let sizes = bounding_reactions(&model.contacts).into_iter().map(|reaction| reaction.size).collect_vec();
    let none = sizes.iter().map(|size| (*size, Expr::ZERO)).collect_vec();
    let mut results = Vec::new();
    for (i, contact) in model.contacts.iter().enumerate() {
        let ContactLaw::Friction { kinetic, adhesion, reactions } = &contact.law else { continue };
        for (sticks, limits) in [(false, kinetic), (true, adhesion)] {
            let limits = algebra::substitute(limits, motion.substitution);
            for (upper, limit) in [false, true].into_iter().zip(limits) {
                let place = |term| OfRows::Limit { row: i, sticks, upper, term };
                if reactions.is_empty() {
                    results.extend(affine(place, limit, lambda));
                    continue;
                }
                let own = algebra::substitute(&[limit], &none)[0];
                results.extend(affine(place, own, lambda));
                let shares = sizes.iter().enumerate();
                results.push_all(
                    shares.map(|(load, size)| (Place::Rows(place(RowTerm::Share(load))), limit.diff(*size))),
                );
            }
        }
    }
    results
}

/// Reactions of joints that bound frictions.
fn reactions(
    model: &Model,
    equations: &Equations,
    motion: &Accelerated,
    lambda: &[Expr],
) -> Vec<(Place, Expr)> {
    let joints = equations.lambda.iter().copied().zip(motion.reactions.iter().copied());
    let known: Vec<(Expr, Expr)> = joints.chain(motion.substitution.iter().copied()).collect_vec();
    let mut results = Vec::new();
    for (load, reaction) in bounding_reactions(&model.contacts).into_iter().enumerate() {
        let components = algebra::substitute(&reaction.components, &known);
        for (k, component) in components.into_iter().enumerate() {
            results.extend(affine(|term| OfRows::Reaction { load, component: k, term }, component, lambda));
        }
    }
    results
}

/// An affine function of the multipliers; those that are left in its own part become zero later.
fn affine(place: impl Fn(RowTerm) -> OfRows, value: Expr, lambda: &[Expr]) -> Vec<(Place, Expr)> {
    let mut results = vec![(Place::Rows(place(RowTerm::Own)), value)];
    let factors = lambda.iter().enumerate();
    results.push_all(factors.map(|(j, &lambda)| (Place::Rows(place(RowTerm::By(j))), value.diff(lambda))));
    results
}

/// Accelerations of the coordinates by a multiplier of one; and whether the rate is affine in all multipliers by them.
fn response(motion: &Accelerated, lambda: &[Expr]) -> (Vec<(Place, Expr)>, bool) {
    let n = motion.coordinates;
    let (mut results, mut others) = (Vec::new(), Vec::new());
    for (place, value) in motion.rate {
        match place {
            Place::Element("dx", k) if (n..2 * n).contains(k) => {
                let columns = lambda.iter().enumerate();
                results.push_all(
                    columns.map(|(j, &lambda)| (Place::Entry("response", j, *k), value.diff(lambda))),
                );
            }
            _ => others.push(*value),
        }
    }
    others.push_all(results.iter().map(|(_, column)| *column));
    let read = algebra::symbols(&others);
    let is_affine = lambda.iter().all(|lambda| !read.contains(lambda));
    (results, is_affine)
}

/// A function that stores no zeros: they are there before.
fn without_zeros(mut function: Function) -> Function {
    function.results.retain(|(_, value)| !value.is_zero());
    function
}
