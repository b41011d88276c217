//! Reactions of joints that bound frictions: `mu*abs(reaction(row))`, `mu*norm(reaction(x, y))`, and sums of these.

use crate::collect::CollectVec;
use plm_cas::{Expr, Function, Node, Number, algebra};

use crate::model::Reaction;
use crate::resolve::Resolver;

impl Resolver<'_> {
    /// A limit of the friction `contact` with symbols in the places of the sizes of reactions; `None` if it reads reactions in another
    /// way.
    pub(crate) fn sized(&mut self, contact: usize, limit: Expr) -> Option<Expr> {
        let joints: Vec<Expr> = self.unresolved.rows.iter().map(|row| row.lambda).collect_vec();
        let sizes = algebra::reachable(&[limit]).into_iter().filter(|expr| reads(*expr, &joints));
        let sizes = sizes.filter_map(|expr| Some((expr, components(expr, &joints)?))).collect_vec();
        let named = sizes.into_iter().map(|(of, components)| (of, self.size_of(contact, components)));
        let found = algebra::substitute(&[limit], &named.collect_vec())[0];
        (!reads(found, &joints)).then_some(found)
    }

    /// The symbol of the size of a reaction, which bounds the friction `contact`.
    fn size_of(&mut self, contact: usize, components: Vec<Expr>) -> Expr {
        let all = self.unresolved.contacts.iter().flat_map(|row| &row.reactions);
        let count = all.clone().count();
        let known = all.into_iter().find(|reaction| reaction.components == components).cloned();
        let reaction = known
            .unwrap_or_else(|| Reaction { size: Expr::symbol(format!("reaction_size_{count}")), components });
        let own = &mut self.unresolved.contacts[contact].reactions;
        let size = reaction.size;
        if own.iter().all(|known| known.size != size) {
            own.push(reaction);
        }
        size
    }
}

/// Does an expression read any of these symbols?
fn reads(expr: Expr, symbols: &[Expr]) -> bool {
    algebra::symbols(&[expr]).iter().any(|symbol| symbols.contains(symbol))
}

/// The components of the vector that `abs` or `norm` takes the size of, where they are linear in the multipliers of `joints`.
fn components(size: Expr, joints: &[Expr]) -> Option<Vec<Expr>> {
    let found = match size.node() {
        Node::Call(Function::Abs, arguments) => Some(arguments.to_vec()),
        Node::Call(Function::Sqrt, arguments) => squares(*arguments.first()?),
        _ => None,
    };
    let bends = |expr: Expr| matches!(expr.node(), Node::Call(..) | Node::Less(..)) && reads(expr, joints);
    let is_linear = |component: &Expr| {
        let slopes = joints.iter().map(|joint| component.diff(*joint));
        !algebra::reachable(&[*component]).into_iter().any(bends)
            && !slopes.into_iter().any(|slope| reads(slope, joints))
    };
    found.filter(|found| found.iter().all(is_linear))
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
        // A row whose normal is at a constant angle has components like `0.5*lambda`.
        let scale = coefficient.to_f64().sqrt();
        (scale > 0.0).then(|| Expr::from(Number::from_f64(scale)) * root)
    });
    found.collect::<Option<Vec<_>>>().filter(|found| found.len() <= 2)
}
