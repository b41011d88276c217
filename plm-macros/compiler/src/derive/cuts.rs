//! Branch cuts of `atan2`: on the negative x axis the angle jumps by a turn.
//!
//! Each cut is a condition that nobody writes. Its side is held over a step, on which the angle goes on smoothly over the cut. The guard
//! is `max(side y, x)`. It is zero on the cut, and on the half of the y axis that the motion reaches through the other quadrants, where
//! both sides give one angle. An angle that cannot come to its cut has no such condition.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Function, Node, Number, algebra};

use super::forcing_terms;
use super::kinks::derivatives;
use super::range::range;
use crate::model::{Jump, Model, Switch};
use crate::numeric::{Random, defaults, value};

/// Places on a cut that are looked at.
const PLACES: u64 = 12;
/// Below this part of its size a difference is rounding.
const ROUNDING: f64 = 1e-9;

/// Holds the sides of cuts that forces, rates or rows may come to. Gives each call and what stands for it, with `pairs` in its
/// operands, and what jumps in rows with the symbol of the side.
pub(super) fn hold_cuts(model: &mut Model, pairs: &mut Vec<(Expr, Expr)>) -> Vec<(Expr, Jump)> {
    let mut jumps = Vec::new();
    for (call, name) in calls(model) {
        let Node::Call(_, arguments) = call.node() else { continue };
        let &[y, x] = &*arguments else { continue };
        let of_rows = jumps_of(model, call, [y, x]);
        let forces: Vec<Expr> = forcing_terms(model).map(|term| term.value).collect_vec();
        if of_rows.is_empty() && forces.iter().all(|&force| gap(model, force, call) == Gap::None) {
            continue;
        }
        let symbol = Expr::symbol(format!("switch_{}", model.switches.len()));
        let [inner, inner_y, inner_x] = [call, y, x].map(|expr| algebra::substitute(&[expr], pairs)[0]);
        let [lower, upper] = sides(inner, [inner_y, inner_x]);
        pairs.push((call, symbol.less(Expr::ZERO).select(lower, upper)));
        let text = format!("the cut of {call}");
        model.switches.push(Switch {
            symbol,
            difference: y,
            beyond: Some(x),
            instant: None,
            name,
            text,
            end: None,
            must_hold: false,
        });
        jumps.push_all(of_rows.into_iter().map(|jump| (symbol, jump)));
    }
    jumps
}

/// The calls that move and may come to their cuts, operands first, and whose they are.
fn calls(model: &Model) -> Vec<(Expr, String)> {
    let rows = model.rows.iter().map(|row| (row.phi, row.name.clone()));
    let forcing = forcing_terms(model).map(|term| (term.value, term.name.text.clone()));
    let mut found: Vec<(Expr, String)> = Vec::new();
    for (root, name) in rows.chain(forcing) {
        for expr in algebra::reachable(&[root]) {
            let Node::Call(Function::Atan2, arguments) = expr.node() else { continue };
            let &[y, x] = &*arguments else { continue };
            let [y_range, x_range] = [range(y), range(x)];
            let meets = y_range[0] < 0.0 && y_range[1] > 0.0 && x_range[0] < 0.0;
            if meets && moves(model, &[y, x]) && !found.iter().any(|(known, _)| *known == expr) {
                found.push((expr, name.clone()));
            }
        }
    }
    crate::sorted::sort_by_key(&mut found, |(expr, _)| *expr);
    found
}

/// Do they read what changes in a step, and nothing that is not known before accelerations are?
pub(super) fn moves(model: &Model, exprs: &[Expr]) -> bool {
    let read = algebra::symbols(exprs);
    let unknown = model.bodies.iter().flat_map(|body| body.a).chain(model.rows.iter().map(|row| row.lambda));
    let bodies = model.bodies.iter().flat_map(|body| body.q.into_iter().chain(body.v));
    let mut moving = bodies.chain(model.states.iter().map(|state| state.symbol)).chain([model.time]);
    moving.any(|symbol| read.contains(&symbol)) && !unknown.into_iter().any(|symbol| read.contains(&symbol))
}

/// The angle below the cut and above it: each goes on over the cut by an eighth of a turn.
fn sides(call: Expr, [y, x]: [Expr; 2]) -> [Expr; 2] {
    let (zero, turn) = (Expr::ZERO, Expr::from(Number::pi()) * Expr::from(2));
    let is_low = y.less(zero);
    let lower = is_low.select(zero, x.less(-y).select(-turn, zero));
    let upper = is_low.select(x.less(y).select(turn, zero), zero);
    [call + lower, call + upper]
}

/// The rows that jump at a cut: all that read the angle, but for those in which it jumps by whole turns of a body.
fn jumps_of(model: &Model, call: Expr, [y, x]: [Expr; 2]) -> Vec<Jump> {
    let mut jumps = Vec::new();
    let [lower, upper] = sides(call, [y, x]);
    for (row, of) in model.rows.iter().enumerate() {
        let gap = gap(model, of.phi, call);
        if gap == Gap::None || gap == Gap::Turns && of.is_angular() {
            continue;
        }
        let side = |by: Expr| algebra::substitute(&[of.phi], &[(call, by)])[0];
        let gap = side(lower) - side(upper);
        let [rate, bend] = derivatives(model, gap);
        let [along, _] = derivatives(model, y);
        jumps.push(Jump { switch: 0, row, terms: [gap, rate, bend, y, along], steady: None });
    }
    jumps
}

/// Rows of angles that change by whole turns at a cut, and what stands for their residuals where a pose is looked for: whole turns
/// are no distance.
pub(super) fn turning_rows(model: &Model) -> Vec<(usize, Expr)> {
    let calls = calls(model);
    let rows = model.rows.iter().enumerate().filter(|(_, row)| row.is_angular());
    let turning =
        rows.filter(|(_, row)| calls.iter().any(|(call, _)| gap(model, row.phi, *call) == Gap::Turns));
    turning.map(|(index, row)| (index, row.phi.sin().atan2(row.phi.cos()))).collect_vec()
}

/// Behaviour of an expression at a cut.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Gap {
    None,
    /// It changes by whole turns.
    Turns,
    Any,
}

/// Behaviour of an expression that reads a call at its cut, by random places on it.
fn gap(model: &Model, root: Expr, call: Expr) -> Gap {
    use std::f64::consts::{PI, TAU};
    if !algebra::reachable(&[root]).contains(&call) {
        return Gap::None;
    }
    let angle = Expr::symbol("angle");
    let of_angle = algebra::substitute(&[root], &[(call, angle)])[0];
    let mut found = Gap::None;
    for seed in 0..PLACES {
        let values = places(model, seed);
        let [above, below] = [PI, -PI].map(|at| value(of_angle, &[&values[..], &[(angle, at)]].concat()));
        let rounding = ROUNDING * above.abs().max(below.abs()).max(1.0);
        let by = above - below;
        if (by - TAU * (by / TAU).round()).abs() > rounding {
            return Gap::Any;
        }
        found = if by.abs() > rounding { Gap::Turns } else { found };
    }
    found
}

/// Random values of all symbols.
fn places(model: &Model, seed: u64) -> Vec<(Expr, f64)> {
    let mut numbers = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(7));
    let mut values = defaults(model);
    for (_, number) in &mut values {
        *number = *number * (1.0 + 0.1 * numbers.unit()) + 0.01 * numbers.unit();
    }
    let coordinates = model.bodies.iter().flat_map(|body| body.q.into_iter().chain(body.v));
    values.push_all(coordinates.map(|symbol| (symbol, 2.0 * numbers.unit())));
    values
}

/// Is an expression positive in some of many random places, and negative in others? Sums of squares are not, however they are written.
pub(super) fn has_both_signs(model: &Model, expr: Expr) -> bool {
    let found = (0..8 * PLACES).map(|seed| {
        let mut values = places(model, seed);
        if let Some((_, time)) = values.iter_mut().find(|(symbol, _)| *symbol == model.time) {
            *time = seed as f64 * 0.05;
        }
        value(expr, &values)
    });
    let found: Vec<f64> = found.collect_vec();
    found.iter().any(|value| *value < 0.0) && found.iter().any(|value| *value > 0.0)
}
