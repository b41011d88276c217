//! Where a division by zero comes on the way: what stands under a fraction and changes its sign, as `cos(angle)` under a tangent.
//!
//! Nothing goes over a pole, and a step that is long enough does all the same; so each is a condition that ends the run. It is one
//! only where the quotient grows without bound, and is read whatever else holds: `sin(x)/x` has none, and what stands within a choice
//! by a condition that is not held, or within `min` and `max`, is left to those.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedSet;
use plm_cas::{Expr, Function, Node};

use super::causes;
use super::cuts::moves;
use super::kinks::Boundary;
use super::range::range;
use crate::model::{Model, Switch};

/// Adds the poles of rows, forces and rates to the switches; `held` are conditions whose sides are held.
pub(super) fn hold_poles(model: &mut Model, held: &[(Expr, Expr)]) {
    let rows = model.rows.iter().map(|row| (row.phi, row.name.clone()));
    let causes = causes(model).map(|cause| (cause.value, cause.name.text.clone()));
    let roots: Vec<(Expr, String)> = rows.chain(causes).collect_vec();
    let mut found: Vec<(Expr, String)> = Vec::new();
    for (root, name) in roots {
        for denominator in denominators(root, held) {
            let [low, high] = range(denominator);
            let changes = low < 0.0 && high > 0.0 && moves(model, &[denominator]);
            if changes
                && !found.iter().any(|(known, _)| *known == denominator)
                && Boundary::new(model, denominator).is_pole_of(denominator, root)
            {
                found.push((denominator, name.clone()));
            }
        }
    }
    for (difference, name) in found {
        let symbol = Expr::symbol(format!("switch_{}", model.switches.len()));
        model.switches.push(Switch {
            symbol,
            difference,
            beyond: None,
            instant: None,
            name,
            text: difference.to_string(),
            is_pole: true,
            must_hold: false,
        });
    }
}

/// What an expression divides by, wherever it does.
fn denominators(root: Expr, held: &[(Expr, Expr)]) -> Vec<Expr> {
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
                found.push_all(
                    factors.iter().filter(|(_, exponent)| *exponent < 0).map(|(factor, _)| *factor),
                );
            }
            _ => {}
        }
        node.for_each_child(|child| open.push(child));
    }
    found.sort_unstable();
    found
}
