//! From rows back to nodes, in shared form.

use super::rows::{Kind, Rows, UNIT, base, divides};
use crate::graph::Graph;
use crate::node::{Expr, Node};
use crate::number::Number;

/// Makes the nodes of all rows that the roots need and returns the roots.
pub(super) fn rebuild(graph: &mut Graph, rows: &Rows) -> Vec<Expr> {
    let mut made: Vec<Option<Expr>> = vec![None; rows.len()];
    let mut open: Vec<(u32, bool)> = Vec::new();
    for &root in &rows.roots {
        open.push((root, false));
        while let Some((row, operands_done)) = open.pop() {
            if made[row as usize].is_some() {
                continue;
            }
            if operands_done {
                made[row as usize] = Some(node(graph, rows, row as usize, &made));
                continue;
            }
            open.push((row, true));
            let first = open.len();
            for_each_operand(graph, rows, row as usize, |operand| open.push((operand as u32, false)));
            open[first..].reverse();
        }
    }
    let zero = graph.zero();
    rows.roots.iter().map(|&root| made[root as usize].unwrap_or(zero)).collect()
}

fn for_each_operand(graph: &Graph, rows: &Rows, row: usize, mut visit: impl FnMut(usize)) {
    match (rows.kind(row), rows.source(row)) {
        (Kind::Sum, _) => rows.items(row).iter().for_each(|item| visit(item.id as usize)),
        (Kind::Product, _) => rows.items(row).iter().for_each(|item| visit(base(item.id))),
        (Kind::Other, Some(e)) => graph.node(e).for_each_child(|child| visit(rows.row_of(child))),
        (Kind::Other, None) => {}
    }
}

fn node(graph: &mut Graph, rows: &Rows, row: usize, made: &[Option<Expr>]) -> Expr {
    let zero = graph.zero();
    let at = |row: usize| made[row].unwrap_or(zero);
    let e = match rows.kind(row) {
        Kind::Sum => {
            let mut constant = Number::ZERO;
            let mut terms = Vec::with_capacity(rows.items(row).len());
            for item in rows.items(row) {
                let coefficient = rows.numbers.get(item.coefficient);
                match item.id as usize {
                    UNIT => constant = constant + coefficient,
                    term => terms.push((coefficient, at(term))),
                }
            }
            graph.nested_sum(constant, terms)
        }
        Kind::Product => {
            let power = |id: u32| (at(base(id)), if divides(id) { -1 } else { 1 });
            graph.nested_product(rows.items(row).iter().map(|item| power(item.id)).collect())
        }
        Kind::Other => rows.source(row).map_or(zero, |e| other(graph, rows, e, at)),
    };
    if let Some(source) = rows.source(row) {
        graph.copy_name(source, e);
    }
    e
}

/// Not through the constructors: they would take the new operands apart again.
fn other(graph: &mut Graph, rows: &Rows, e: Expr, at: impl Fn(usize) -> Expr) -> Expr {
    let new = |old: Expr| at(rows.row_of(old));
    match graph.node(e).clone() {
        Node::Defined(value) => {
            let name = graph.name(e).unwrap_or_default().to_owned();
            graph.define(&name, new(value))
        }
        Node::Product(factors) => {
            graph.nested_product(factors.iter().map(|&(factor, n)| (new(factor), n)).collect())
        }
        Node::Call(function, arguments) => {
            graph.intern(Node::Call(function, arguments.iter().map(|&a| new(a)).collect()))
        }
        Node::Less(a, b) => graph.intern(Node::Less(new(a), new(b))),
        Node::Select(condition, a, b) => graph.intern(Node::Select(new(condition), new(a), new(b))),
        Node::Number(_) | Node::Symbol | Node::Sum { .. } => e,
    }
}
