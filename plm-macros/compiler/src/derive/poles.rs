//! Poles, where a divisor passes zero, as `cos(angle)` under a tangent; and ends of domains, as that of a root.
//!
//! Each is a condition that ends the run: no motion goes over a pole, but a step that is long enough does. A divisor counts only if the
//! quotient grows without bound at its zero; that of `sin(x)/x` does not. Each is watched whatever else holds. So those are left out that
//! stand within a choice by a condition that is not held, within a comparison, or within `min` and `max`.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedSet;
use plm_cas::{Expr, Function, Node};

use super::cuts::{has_both_signs, moves};
use super::forcing_terms;
use super::kinks::Boundary;
use super::range::range;
use crate::model::{End, Model, Switch};

/// Adds the poles and ends of domains of rows and forces to the switches; those of rates of states are left to error control. `held` are
/// conditions whose sides are held.
pub(super) fn hold_poles(model: &mut Model, held: &[(Expr, Expr)]) {
    let rows = model.rows.iter().map(|row| (row.phi, row.name.clone()));
    let forces = forcing_terms(model).filter(|term| term.is_force);
    let forces = forces.map(|term| (term.value, term.name.text.clone()));
    let roots: Vec<(Expr, String)> = rows.chain(forces).collect_vec();
    let mut found: Vec<(Expr, End, String)> = Vec::new();
    for (root, name) in roots {
        for (difference, end) in ends_of(model, root, held) {
            let [low, high] = range(difference);
            let changes =
                low < 0.0 && high > 0.0 && moves(model, &[difference]) && has_both_signs(model, difference);
            let is_known = found.iter().any(|(known, ..)| *known == difference);
            let ends =
                |difference| end.is_domain() || Boundary::new(model, difference).is_pole_of(difference, root);
            if changes && !is_known && ends(difference) {
                found.push((difference, end, name.clone()));
            }
        }
    }
    for (difference, end, name) in found {
        let symbol = Expr::symbol(format!("switch_{}", model.switches.len()));
        model.switches.push(Switch {
            symbol,
            difference,
            beyond: None,
            instant: None,
            name,
            text: String::new(),
            end: Some(end),
            must_hold: false,
        });
    }
}

/// Divisors of an expression, and arguments that decide where its functions are defined, wherever they stand.
fn ends_of(model: &Model, root: Expr, held: &[(Expr, Expr)]) -> Vec<(Expr, End)> {
    let (mut open, mut seen, mut found) = (vec![root], SortedSet::new(), Vec::new());
    while let Some(expr) = open.pop() {
        if !seen.insert(expr) {
            continue;
        }
        let node = expr.node();
        match &node {
            Node::Select(condition, ..) if !held.iter().any(|(of, _)| of == condition) => continue,
            Node::Call(Function::Min | Function::Max, _) | Node::Less(..) => continue,
            Node::Product(factors) => {
                let below = factors.iter().filter(|(_, exponent)| *exponent < 0).map(|(factor, _)| *factor);
                found.push_all(below.map(|below| (below, End::Pole(below.to_string()))));
            }
            Node::Call(Function::Sqrt | Function::Ln, of) if of.len() == 1 => {
                found.push((of[0], End::Domain(expr.to_string())));
            }
            Node::Call(Function::Asin | Function::Acos, of) if moves(model, &of[..1]) && !is_sine(of[0]) => {
                found.push((Expr::ONE - of[0] * of[0], End::Domain(expr.to_string())));
            }
            _ => {}
        }
        node.for_each_child(|child| open.push(child));
    }
    found
}

/// Can it be nothing but a sine?
fn is_sine(expr: Expr) -> bool {
    let [low, high] = range(expr);
    low >= -1.0 && high <= 1.0
}
