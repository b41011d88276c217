//! Conditions at which forces and rates jump: each gets a side that is held over a step, so that within it everything is
//! smooth. Where the two sides agree at the boundary (a kink) the condition stays as it is; what it compares is looked at in every
//! step, which ends there where it matters. So are the places at which `min`, `max` and `abs` bend.
//! In constraint rows a kink of the second derivative is a jump of accelerations, so that those are held too.

use plm_cas::{Expr, Function, Node, algebra};

use super::kinks::{self, Kink};
use crate::model::{Jump, Model, Side};

/// Puts the side of every condition at which a force, a rate or an acceleration jumps, or that asks for the time alone, in
/// its place. Gives each condition and what stands for it.
pub(crate) fn hold(model: &mut Model) -> Vec<(Expr, Expr)> {
    kinks::unfold(model);
    let kinks = kinks::kinks(model);
    let mut conditions: Vec<(Expr, String)> = Vec::new();
    for (name, root) in causes(model) {
        for expr in algebra::reachable(&[root]) {
            let seen = conditions.iter().any(|(condition, _)| *condition == expr);
            if matches!(expr.node(), Node::Less(..)) && !seen {
                conditions.push((expr, name.clone()));
            }
        }
    }
    let roots: Vec<Expr> = causes(model).into_iter().map(|(_, root)| root).collect();
    let mut pairs = Vec::new();
    for (condition, name) in conditions {
        let Node::Less(a, b) = condition.node() else { continue };
        let difference = a - b;
        let instant = instant(model, difference);
        if instant.is_none() && !jumps(&roots, condition, difference) {
            model.kinks.push(difference);
            continue;
        }
        pairs.push(side(model, (condition, difference, instant), name));
    }
    let jumps = hold_rows(model, kinks, &mut pairs);
    bends(model, &roots);
    if pairs.is_empty() {
        return pairs;
    }
    // Conditions of the state stand before those of the time, as the guards do.
    model.sides.sort_by_key(|side| side.instant.is_some());
    for (symbol, jump) in jumps {
        let index = model.sides.iter().position(|side| side.symbol == symbol);
        model.jumps.extend(index.map(|side| Jump { side, ..jump }));
    }
    kinks::substitute(model, &pairs);
    let rows: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect();
    let in_rows = algebra::reachable(&rows);
    let released = pairs.iter().filter(|pair| in_rows.contains(&pair.1));
    model.released = released.map(|&(condition, held)| (held, condition)).collect();
    for load in &mut model.loads {
        load.force = std::array::from_fn(|k| algebra::substitute(&[load.force[k]], &pairs)[0]);
    }
    for state in &mut model.states {
        state.rate = algebra::substitute(&[state.rate], &pairs)[0];
    }
    for output in &mut model.outputs {
        output.components = algebra::substitute(&output.components, &pairs);
    }
    pairs
}

/// Adds what `min`, `max` and `abs` compare to the kinks, and leaves those that can be looked at: they read the state or the
/// time, and nothing that is not known before accelerations are. Where a side is held steps end already.
fn bends(model: &mut Model, roots: &[Expr]) {
    let mut kinks = std::mem::take(&mut model.kinks);
    for expr in algebra::reachable(roots) {
        let difference = match expr.node() {
            Node::Call(Function::Min | Function::Max, arguments) => match arguments[..] {
                [a, b] => a - b,
                _ => continue,
            },
            Node::Call(Function::Abs, arguments) => match arguments[..] {
                [a] => a,
                _ => continue,
            },
            _ => continue,
        };
        kinks.push(difference);
    }
    let moving: Vec<Expr> = (model.bodies.iter().flat_map(|body| body.q.into_iter().chain(body.v)))
        .chain(model.states.iter().map(|state| state.symbol))
        .chain([model.time])
        .collect();
    let held: Vec<Expr> = (model.params.iter().map(|param| param.symbol))
        .chain(model.inputs.iter().map(|input| input.symbol))
        .collect();
    for kink in kinks {
        let read = algebra::symbols(&[kink]);
        let known = read.iter().all(|symbol| moving.contains(symbol) || held.contains(symbol));
        let moves = known && read.iter().any(|symbol| moving.contains(symbol));
        let negative = -kink;
        let same = |expr: Expr| expr == kink || expr == negative;
        let is_held = model.sides.iter().any(|side| same(side.difference));
        if moves && !is_held && !model.kinks.iter().any(|other| same(*other)) {
            model.kinks.push(kink);
        }
    }
}

/// A new side of a condition, and what stands for that.
fn side(
    model: &mut Model,
    (condition, difference, instant): (Expr, Expr, Option<[Expr; 2]>),
    name: String,
) -> (Expr, Expr) {
    let symbol = Expr::symbol(format!("side_{}", model.sides.len()));
    let zero = Expr::ZERO;
    model.sides.push(Side { symbol, difference, instant, name, must_hold: false });
    (condition, symbol.less(zero))
}

/// Sides of the conditions in rows; gives what may jump there, with the symbols of these sides.
fn hold_rows(model: &mut Model, kinks: Vec<Kink>, pairs: &mut Vec<(Expr, Expr)>) -> Vec<(Expr, Jump)> {
    let mut jumps = Vec::new();
    for Kink { condition, difference, row, jumps: of_rows, bends } in kinks {
        let known = pairs.iter().find(|pair| pair.0 == condition).copied();
        let instant = instant(model, difference);
        let pair = match known {
            Some(pair) => pair,
            None if instant.is_none() && !bends => continue,
            None => {
                let name = model.rows[row].name.clone();
                let pair = side(model, (condition, difference, instant), name);
                pairs.push(pair);
                pair
            }
        };
        if let Some(symbol) = algebra::symbols(&[pair.1]).first().copied() {
            jumps.extend(of_rows.into_iter().map(|jump| (symbol, jump)));
        }
    }
    jumps
}

/// What may jump, and whose it is.
fn causes(model: &Model) -> Vec<(String, Expr)> {
    let loads = model.loads.iter().flat_map(|load| {
        let name = &model.parts[load.part].name.text;
        load.force.map(|force| (name.clone(), force))
    });
    let rates = model.states.iter().map(|state| (state.name.text.clone(), state.rate));
    loads.chain(rates).collect()
}

/// The one time at which a difference vanishes that is linear in the time and reads nothing but parameters and inputs,
/// and its slope.
fn instant(model: &Model, difference: Expr) -> Option<[Expr; 2]> {
    let held = algebra::symbols(&[difference]);
    let constant = |symbol: &Expr| {
        model.params.iter().any(|param| param.symbol == *symbol)
            || model.inputs.iter().any(|input| input.symbol == *symbol)
    };
    if !held.contains(&model.time) || !held.iter().all(|symbol| *symbol == model.time || constant(symbol)) {
        return None;
    }
    let slope = difference.diff(model.time);
    if algebra::symbols(&[slope]).contains(&model.time) {
        return None;
    }
    Some([root(difference, model.time, slope), slope])
}

/// `s - d / d'`, where `d` is linear in the symbol `s`.
pub(super) fn root(difference: Expr, symbol: Expr, slope: Expr) -> Expr {
    let step = difference / slope;
    symbol - step
}

/// Do the two values between which a condition chooses differ where it changes?
fn jumps(roots: &[Expr], condition: Expr, difference: Expr) -> bool {
    let choices: Vec<Expr> = algebra::reachable(roots)
        .into_iter()
        .filter_map(|expr| match expr.node() {
            Node::Select(by, yes, no) if by == condition => Some((yes, no)),
            _ => None,
        })
        .collect::<Vec<_>>()
        .into_iter()
        .map(|(yes, no)| yes - no)
        .collect();
    // The boundary, solved for a symbol in which it is linear.
    let boundary = algebra::symbols(&[difference]).into_iter().find_map(|symbol| {
        let slope = difference.diff(symbol);
        let linear = !slope.is_zero() && !algebra::symbols(&[slope]).contains(&symbol);
        linear.then(|| (symbol, root(difference, symbol, slope)))
    });
    let Some(boundary) = boundary else { return true };
    choices.iter().any(|&choice| {
        let there = algebra::substitute(&[choice], &[boundary])[0];
        !there.is_zero()
    })
}
