//! Reactions of joints that bound a friction: `mu*abs(reaction(row))`, `mu*norm(reaction(x, y))`.

use crate::collect::CollectVec;
use plm_cas::{Expr, Function, Node, Number, algebra};

use crate::model::Reaction;
use crate::resolve::Resolver;

impl Resolver<'_> {
    /// A limit of the friction `contact` with a symbol in the place of the size of a reaction; `None` if it reads reactions in another
    /// way, or those of two.
    pub(crate) fn sized(&mut self, contact: usize, limit: Expr) -> Option<Expr> {
        let joints: Vec<Expr> = self.unresolved.rows.iter().map(|row| row.lambda).collect_vec();
        let reads = |expr: Expr| algebra::symbols(&[expr]).iter().any(|symbol| joints.contains(symbol));
        let sizes = algebra::reachable(&[limit]).into_iter().filter(|expr| reads(*expr));
        let sizes = sizes.filter_map(|expr| Some((expr, components(expr)?))).collect_vec();
        let [(of, components)] = &sizes[..] else { return None };
        let row = &mut self.unresolved.contacts[contact];
        let name = format!("size_{}", row.name);
        let reaction = row.reaction.get_or_insert_with(|| {
            // Both bounds of a friction read the same symbol.
            Reaction { size: Expr::symbol(name), components: components.clone() }
        });
        if reaction.components != *components {
            return None;
        }
        let size = reaction.size;
        let found = algebra::substitute(&[limit], &[(*of, size)])[0];
        let is_linear = !algebra::symbols(&[found.diff(size)]).contains(&size);
        (is_linear && !reads(found)).then_some(found)
    }
}

/// The components of the vector that `abs` or `norm` takes the size of.
fn components(size: Expr) -> Option<Vec<Expr>> {
    match size.node() {
        Node::Call(Function::Abs, arguments) => Some(arguments.to_vec()),
        Node::Call(Function::Sqrt, arguments) => squares(*arguments.first()?),
        _ => None,
    }
}

/// The one or two numbers of whose squares it is the sum.
fn squares(sum: Expr) -> Option<Vec<Expr>> {
    let terms = match sum.node() {
        Node::Sum { constant, terms } if constant.is_zero() => terms.to_vec(),
        _ => vec![(Number::ONE, sum)],
    };
    let found = terms.into_iter().map(|(coefficient, term)| {
        let Node::Product(factors) = term.node() else { return None };
        let roots = factors.iter().map(|&(factor, power)| (power % 2 == 0).then(|| factor.powi(power / 2)));
        let root = roots.collect::<Option<Vec<_>>>()?.into_iter().reduce(|root, factor| root * factor)?;
        (coefficient == Number::ONE).then_some(root)
    });
    found.collect::<Option<Vec<_>>>().filter(|found| found.len() <= 2)
}
