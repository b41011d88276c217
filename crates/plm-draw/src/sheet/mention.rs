//! Mentions: which names an item reads, and where.

use plm_compiler::syntax::ast::{
    Bound, Expr, ExprKind, Friction, Ident, IndexedName, Item, ItemKind, Load, Moment, Node, Output, Port,
    Value, When,
};

/// A name that is read, with the member of it that follows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mention<'s> {
    pub(crate) name: &'s Ident,
    pub(crate) member: Option<&'s Ident>,
}

/// All mentions of an item, and of the items in it. What stands in a part of the text's own has names of its own.
pub(crate) fn mentions<'s>(item: &'s Item, take: &mut impl FnMut(Mention<'s>)) {
    match &item.kind {
        ItemKind::Gravity(value) | ItemKind::Stabilisation(_, Some(value)) => of_expr(value, take),
        ItemKind::Param(value)
        | ItemKind::Input(value)
        | ItemKind::State(value)
        | ItemKind::Discrete(value) => {
            of_value(value, take);
        }
        ItemKind::When(when) => of_when(when, take),
        ItemKind::Let(name, value) | ItemKind::Rate(name, value) => {
            of_indices(name, take);
            of_expr(value, take);
            // A rate belongs to its state.
            if matches!(item.kind, ItemKind::Rate(..)) {
                take(Mention { name: &name.ident, member: None });
            }
        }
        ItemKind::Ground(ports) => ports.iter().for_each(|port| of_port(port, take)),
        ItemKind::Body(body) => {
            of_indices(&body.name, take);
            body.fields.iter().for_each(|(_, value)| of_expr(value, take));
            body.ports.iter().for_each(|port| of_port(port, take));
            body.starts.iter().for_each(|start| of_expr(&start.value, take));
            for contour in body.contour.iter().chain(&body.holes) {
                if let plm_compiler::syntax::ast::Contour::Points(points) = contour {
                    for point in points {
                        of_expr(point, take);
                    }
                }
            }
        }
        ItemKind::Instance(of) => {
            of_indices(&of.name, take);
            take(Mention { name: &of.kind, member: None });
            of.arguments.iter().for_each(|argument| of_expr(argument, take));
            let values =
                of.fields.iter().flat_map(|field| std::iter::once(&field.value).chain(&field.others));
            values.for_each(|value| of_expr(value, take));
        }
        ItemKind::Constraint(name, left, right, when) => {
            of_indices(name, take);
            [left, right].into_iter().chain(when).for_each(|value| of_expr(value, take));
        }
        ItemKind::Unilateral(of) => {
            of_indices(&of.name, take);
            of.sides.iter().chain(&of.restitution).chain(&of.when).for_each(|value| of_expr(value, take));
        }
        ItemKind::Friction(of) => of_friction(of, take),
        ItemKind::Require(name, condition) => {
            of_indices(name, take);
            of_expr(condition, take);
        }
        ItemKind::Load(Load { on, from, value, .. }) => {
            [on, value].into_iter().chain(from).for_each(|value| of_expr(value, take));
        }
        ItemKind::Node(Node { name, value, .. }) => {
            of_indices(name, take);
            of_expr(value, take);
        }
        ItemKind::Output(outputs) => outputs.iter().for_each(|output| of_output(output, take)),
        ItemKind::Observe(list) => list.iter().for_each(|value| of_expr(value, take)),
        ItemKind::Repeat(repeat) => {
            of_expr(&repeat.turns.from, take);
            of_expr(&repeat.turns.to, take);
            repeat.items.iter().for_each(|item| mentions(item, take));
        }
        _ => {}
    }
}

fn of_value<'s>(value: &'s Value, take: &mut impl FnMut(Mention<'s>)) {
    of_indices(&value.name, take);
    value.value.iter().for_each(|value| of_expr(value, take));
}

fn of_when<'s>(when: &'s When, take: &mut impl FnMut(Mention<'s>)) {
    if let Moment::BecomesTrue(condition) = &when.moment {
        of_expr(condition, take);
    }
    for assignment in &when.assignments {
        of_expr(&assignment.target, take);
        of_expr(&assignment.value, take);
    }
}

fn of_port<'s>(port: &'s Port, take: &mut impl FnMut(Mention<'s>)) {
    of_indices(&port.name, take);
    std::iter::once(&port.at).chain(&port.angle).chain(&port.depth).for_each(|value| of_expr(value, take));
}

fn of_friction<'s>(of: &'s Friction, take: &mut impl FnMut(Mention<'s>)) {
    of_indices(&of.name, take);
    let bounds = std::iter::once(&of.kinetic).chain(&of.adhesion);
    let limits = bounds.flat_map(|Bound { lower, upper }| lower.iter().chain(std::iter::once(upper)));
    std::iter::once(&of.displacement).chain(limits).chain(&of.when).for_each(|value| of_expr(value, take));
}

/// Mentions of an output.
pub(crate) fn of_output<'s>(output: &'s Output, take: &mut impl FnMut(Mention<'s>)) {
    of_expr(&output.value, take);
}

fn of_indices<'s>(name: &'s IndexedName, take: &mut impl FnMut(Mention<'s>)) {
    name.indices.iter().for_each(|index| of_expr(index, take));
}

/// Mentions of an expression. The parser bounds its depth.
pub(crate) fn of_expr<'s>(expr: &'s Expr, take: &mut impl FnMut(Mention<'s>)) {
    match &expr.kind {
        ExprKind::Unknown | ExprKind::Number(_) => {}
        ExprKind::Quantity(inner, _) | ExprKind::Neg(inner) | ExprKind::Not(inner) => of_expr(inner, take),
        ExprKind::Pair(x, y) | ExprKind::Power(x, y) => [x, y].into_iter().for_each(|of| of_expr(of, take)),
        ExprKind::Name(name) => {
            of_indices(name, take);
            take(Mention { name: &name.ident, member: None });
        }
        ExprKind::Path(base, members) => {
            for member in members {
                of_indices(member, take);
            }
            match &base.kind {
                ExprKind::Name(name) => {
                    of_indices(name, take);
                    take(Mention { name: &name.ident, member: members.first().map(|member| &member.ident) });
                }
                _ => of_expr(base, take),
            }
        }
        ExprKind::Call(_, arguments) => arguments.iter().for_each(|argument| of_expr(argument, take)),
        ExprKind::Chain(first, links) => {
            of_expr(first, take);
            for link in links {
                of_expr(&link.operand, take);
            }
        }
        ExprKind::If(condition, yes, no) => {
            for of in [condition, yes, no] {
                of_expr(of, take);
            }
        }
    }
}
