//! Conditions at which forces and rates jump: each gets a side that is held over a step, so that within it everything is
//! smooth.
//!
//! A condition whose two sides agree at the boundary (a kink) gets no side. Its difference is watched in every step, and the step ends at
//! its zero if the kink is relevant there. The places at which `min`, `max` and `abs` bend are treated alike. In constraint rows a kink of
//! the second derivative is a jump of accelerations, so that those conditions get a side too.

use crate::collect::{CollectVec, MapEach, PushAll};
use crate::sorted::sort_by_key;
use plm_cas::{Expr, Function, Node, Number, algebra};

use super::cuts::{self, hold_cuts, moves};
use super::decisions::decisions;
use super::forcing_terms;
use super::kinks::{self, Kink, root};
use super::poles::hold_poles;
use crate::model::{Contact, ContactMode, Jump, Model, Switch};

/// A number above zero that changes nothing.
const ABOVE_ZERO: f64 = 1e-30;

/// Puts the side of every condition at which a force, a rate or an acceleration jumps, or that asks for the time alone, in
/// its place. Gives each condition and what stands for it.
pub(crate) fn hold_switches(model: &mut Model) -> Vec<(Expr, Expr)> {
    kinks::unfold(model);
    unfold_signs(model);
    let kinks = kinks::kinks(model);
    let roots: Vec<Expr> = forcing_terms(model).map(|term| term.value).collect_vec();
    let mut pairs = hold_events(model);
    for (condition, name) in conditions(model) {
        let Node::Less(a, b) = condition.node() else { continue };
        let difference = a - b;
        if pairs.iter().any(|pair| pair.0 == condition) {
            continue;
        }
        if instant(model, difference).is_none() && !jumps(&roots, condition, difference) {
            model.kinks.push(difference);
        } else {
            let text = text(model, [a, b]);
            pairs.push((condition, switch(model, difference, (name, text))));
        }
    }
    let turning = cuts::turning_rows(model);
    let mut jumps = hold_rows(model, kinks, &mut pairs);
    jumps.extend(hold_cuts(model, &mut pairs));
    bends(model, &roots);
    hold_poles(model, &pairs);
    // Conditions of the state stand before those of the time, as the guards do.
    sort_by_key(&mut model.switches, |switch| switch.instant.is_some());
    if !pairs.is_empty() {
        for (symbol, jump) in jumps {
            let index = model.switches.iter().position(|switch| switch.symbol == symbol);
            model.jumps.push_all(index.map(|switch| Jump { switch, ..jump }));
        }
        model.decisions = decisions(model, &pairs);
        substitute(model, &pairs);
    }
    model.released.extend(turning.into_iter().map(|(row, wrapped)| (model.rows[row].phi, wrapped)));
    pairs
}

/// Writes the signs that jump in forces and rates as conditions: -1, 0 or 1.
fn unfold_signs(model: &mut Model) {
    let (zero, one) = (Expr::ZERO, Expr::ONE);
    loop {
        let roots: Vec<Expr> = forcing_terms(model).map(|term| term.value).collect_vec();
        // Operands come first: one sign may stand in another.
        let sign = algebra::reachable(&roots).into_iter().find_map(|expr| match expr.node() {
            Node::Call(Function::Sign, of) if moves(model, &of) => Some((expr, of[0])),
            _ => None,
        });
        let Some((sign, x)) = sign else { return };
        substitute(model, &[(sign, x.less(zero).select(-one, zero.less(x).select(one, zero)))]);
    }
}

/// Switches of all comparisons in the conditions of events and of rows of contact, whatever else reads them.
fn hold_events(model: &mut Model) -> Vec<(Expr, Expr)> {
    let mut pairs: Vec<(Expr, Expr)> = Vec::new();
    let of_events = model.whens.iter().filter_map(|when| Some((when.condition?, when.text.clone())));
    let of_rows = model.contacts.iter().filter_map(|row| Some((row.exists?, row.name.clone())));
    for (condition, name) in of_events.chain(of_rows).collect_vec() {
        for expr in algebra::reachable(&[condition]) {
            let Node::Less(a, b) = expr.node() else { continue };
            if pairs.iter().all(|pair| pair.0 != expr) {
                let text = text(model, [a, b]);
                pairs.push((expr, switch(model, a - b, (name.clone(), text))));
            }
        }
    }
    pairs
}

/// The conditions that forces and rates hold, each once, and whose they are.
fn conditions(model: &Model) -> Vec<(Expr, String)> {
    let mut conditions: Vec<(Expr, String)> = Vec::new();
    for term in forcing_terms(model) {
        for expr in algebra::reachable(&[term.value]) {
            let seen = conditions.iter().any(|(condition, _)| *condition == expr);
            if matches!(expr.node(), Node::Less(..)) && !seen {
                conditions.push((expr, term.name.text.clone()));
            }
        }
    }
    conditions
}

/// Puts what stands for each condition in its place, wherever that may be.
fn substitute(model: &mut Model, pairs: &[(Expr, Expr)]) {
    kinks::substitute(model, pairs);
    let rows: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
    let in_rows = algebra::reachable(&rows);
    let released = pairs.iter().filter(|pair| in_rows.contains(&pair.1));
    model.released = released.map(|&(condition, held)| (held, condition)).collect_vec();
    for load in &mut model.loads {
        load.force = load.force.map_each(|force| algebra::substitute(&[force], pairs)[0]);
    }
    for state in &mut model.states {
        state.rate = algebra::substitute(&[state.rate], pairs)[0];
    }
    for output in &mut model.outputs {
        output.components = algebra::substitute(&output.components, pairs);
    }
    // Values that events set are worked out by the state of their moment.
    for condition in model.whens.iter_mut().filter_map(|when| when.condition.as_mut()) {
        *condition = algebra::substitute(&[*condition], pairs)[0];
    }
    for place in model.contacts.iter_mut().flat_map(Contact::expressions_mut) {
        *place = algebra::substitute(&[*place], pairs)[0];
    }
}

/// Adds what `min`, `max` and `abs` compare to the kinks, and leaves those that can be looked at: they read the state or the
/// time, and nothing that is not known before accelerations are. Where a side is held steps end already.
fn bends(model: &mut Model, roots: &[Expr]) {
    let mut kinks = std::mem::take(&mut model.kinks);
    for expr in algebra::reachable(roots) {
        let Node::Call(function, arguments) = expr.node() else { continue };
        match (function, &arguments[..]) {
            (Function::Min | Function::Max, &[a, b]) => kinks.push(a - b),
            (Function::Abs, &[a]) => kinks.push(a),
            _ => {}
        }
    }
    let moving: Vec<Expr> = (model.bodies.iter().flat_map(|body| body.q.into_iter().chain(body.v)))
        .chain(model.states.iter().map(|state| state.symbol))
        .chain([model.time])
        .collect_vec();
    let held: Vec<Expr> = (model.params.iter().map(|param| param.symbol))
        .chain(model.inputs.iter().map(|input| input.symbol))
        .collect_vec();
    for kink in kinks {
        let read = algebra::symbols(&[kink]);
        let known = read.iter().all(|symbol| moving.contains(symbol) || held.contains(symbol));
        let moves = known && read.iter().any(|symbol| moving.contains(symbol));
        let opposite = -kink;
        let same = |expr: Expr| expr == kink || expr == opposite;
        let is_held = model.switches.iter().any(|switch| same(switch.difference));
        if moves && !is_held && !model.kinks.iter().any(|other| same(*other)) {
            model.kinks.push(kink);
        }
    }
}

/// A new switch of the condition `difference < 0`, and the condition that stands for that: `switch < 0`.
fn switch(model: &mut Model, difference: Expr, (name, text): (String, String)) -> Expr {
    let symbol = Expr::symbol(format!("switch_{}", model.switches.len()));
    let (instant, difference) = (instant(model, difference), at_rest(model, difference));
    model.switches.push(Switch {
        symbol,
        difference,
        beyond: None,
        instant,
        name,
        text,
        end: None,
        must_hold: false,
    });
    symbol.less(Expr::ZERO)
}

/// A difference of the rate of a row of contact, of its size or of a gap, and a constant: while that row sticks or is closed, as if the
/// first were zero. What is left of it then is rounding of either sign, at which nothing is to happen. At zero the condition does not hold,
/// which a number above zero says. A row with a condition is none of these: it comes to be and ends at events, which may be of what it
/// compares itself, and the side at which it came to be is kept.
fn at_rest(model: &Model, difference: Expr) -> Expr {
    let flow: Vec<(Expr, Expr)> = (model.bodies.iter().flat_map(|body| body.q.into_iter().zip(body.v)))
        .chain([(model.time, Expr::ONE)])
        .collect_vec();
    let is_constant = |of: &Expr| {
        algebra::symbols(&[*of]).iter().all(|symbol| model.params.iter().any(|param| param.symbol == *symbol))
    };
    let rest = |of: Expr| [difference - of, difference + of].into_iter().find(is_constant);
    let mut rows = model.contacts.iter().filter(|row| row.exists.is_none());
    let found = rows.find_map(|contact| {
        let gap = (contact.kind_of_mode() == ContactMode::Open).then_some(contact.displacement);
        let rate = contact.displacement.directional(&flow);
        let known = [Some(rate), Some(rate.abs()), gap];
        Some((contact, known.into_iter().flatten().find_map(rest)?))
    });
    let Some((contact, rest)) = found else { return difference };
    let rest = if rest.is_zero() { Expr::from(Number::from_f64(ABOVE_ZERO)) } else { rest };
    let [yes, no] = match contact.kind_of_mode() {
        ContactMode::Open => [difference, rest],
        ContactMode::Sticking => [rest, difference],
    };
    (Expr::ONE / Expr::from(2)).less(contact.mode).select(yes, no)
}

/// The comparison `a < b` as it was written, or else as it is printed.
fn text(model: &Model, [a, b]: [Expr; 2]) -> String {
    let written = model.comparisons.iter().find(|known| known.of == [a, b] || known.of == [b, a]);
    written.map_or_else(|| format!("{a} < {b}"), |known| known.text.clone())
}

/// Switches of the conditions in rows; gives what may jump there, with the symbols of these switches.
fn hold_rows(model: &mut Model, kinks: Vec<Kink>, pairs: &mut Vec<(Expr, Expr)>) -> Vec<(Expr, Jump)> {
    let mut jumps = Vec::new();
    for Kink { condition, difference, row, jumps: of_rows, bends } in kinks {
        let known = pairs.iter().find(|pair| pair.0 == condition).map(|pair| pair.1);
        let held = match known {
            Some(held) => held,
            None if instant(model, difference).is_none() && !bends => continue,
            None => {
                let Node::Less(a, b) = condition.node() else { continue };
                let name = (model.rows[row].name.clone(), text(model, [a, b]));
                let held = switch(model, difference, name);
                pairs.push((condition, held));
                held
            }
        };
        if let Some(&symbol) = algebra::symbols(&[held]).first() {
            jumps.push_all(of_rows.into_iter().map(|jump| (symbol, jump)));
        }
    }
    jumps
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
    // What is periodic is linear from jump to jump, and vanishes more than once.
    let at = root(difference, model.time, slope);
    (!algebra::symbols(&[at]).contains(&model.time)).then_some([at, slope])
}

/// Do the two values between which a condition chooses differ where it changes?
fn jumps(roots: &[Expr], condition: Expr, difference: Expr) -> bool {
    let choices: Vec<(Expr, Expr)> = algebra::reachable(roots)
        .into_iter()
        .filter_map(|expr| match expr.node() {
            Node::Select(by, yes, no) if by == condition => Some((yes, no)),
            _ => None,
        })
        .collect_vec();
    let gaps: Vec<Expr> = choices.into_iter().map(|(yes, no)| yes - no).collect_vec();
    // The boundary, solved for a symbol in which it is linear.
    let boundary = algebra::symbols(&[difference]).into_iter().find_map(|symbol| {
        let slope = difference.diff(symbol);
        let linear = !slope.is_zero() && !algebra::symbols(&[slope]).contains(&symbol);
        linear.then(|| (symbol, root(difference, symbol, slope)))
    });
    let Some(boundary) = boundary else { return true };
    gaps.iter().any(|&gap| !algebra::substitute(&[gap], &[boundary])[0].is_zero())
}
