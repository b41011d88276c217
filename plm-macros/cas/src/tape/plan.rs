//! Which nodes get no value of their own, because their one user computes them better.

use crate::graph::Graph;
use crate::node::{Expr, Node};
use crate::number::Number;

/// How a node is lowered.
#[derive(Copy, Clone, PartialEq)]
#[repr(u8)]
pub(super) enum Treatment {
    /// Not below a root.
    Absent = 0,
    /// By itself.
    Own,
    /// A product whose coefficient stands in its user: `100*dx*dy` is one product there.
    Absorbed,
    /// A sum that is computed with all signs turned: `-(a - b)` is `b - a`.
    Turned,
    /// A product that comes out negated because one of its factors is turned.
    Carrier,
}

pub(super) struct Plan {
    treatments: Treatments,
}

/// The treatment of each node, as bytes: most are 0, which the allocator provides.
struct Treatments(Vec<u8>);

impl Treatments {
    fn set(&mut self, e: Expr, treatment: Treatment) {
        self.0[e.index()] = treatment as u8;
    }
}

impl Plan {
    pub(super) fn new(graph: &Graph, roots: &[Expr]) -> Self {
        let reachable = graph.reachable(roots);
        // What is made after the last root is no part of it.
        let length = reachable.last().map_or(0, |last| last.index() + 1);
        let mut uses = vec![0_u32; length];
        let mut treatments = Treatments(vec![0; length]);
        for &root in roots {
            uses[root.index()] += 1;
        }
        for &e in &reachable {
            treatments.set(e, Treatment::Own);
            graph.node(e).for_each_child(|child| uses[child.index()] += 1);
        }
        let free = |e: Expr| uses[e.index()] == 1 && graph.name(e).is_none();
        for &e in &reachable {
            if let Node::Sum { constant, terms } = graph.node(e) {
                let negation = constant.is_zero() && terms.len() == 1 && terms[0].0.is_minus_one();
                match terms[0].1 {
                    inner if negation => treat_negated(graph, inner, &free, &mut treatments),
                    _ => treat_terms(graph, terms, &free, &mut treatments),
                }
            }
        }
        Self { treatments }
    }

    pub(super) fn of(&self, e: Expr) -> Treatment {
        use Treatment::{Absent, Absorbed, Carrier, Own, Turned};
        let treatment = self.treatments.0.get(e.index()).copied().unwrap_or_default();
        [Absent, Own, Absorbed, Turned, Carrier][usize::from(treatment)]
    }

    /// The number of the graph's first nodes that hold all that is lowered.
    pub(super) fn length(&self) -> usize {
        self.treatments.0.len()
    }
}

/// Products that stand in a sum with a coefficient take it as their first factor.
fn treat_terms(
    graph: &Graph,
    terms: &[(Number, Expr)],
    free: &impl Fn(Expr) -> bool,
    treatments: &mut Treatments,
) {
    for &(coefficient, term) in terms {
        let unit = coefficient.is_one() || coefficient.is_minus_one();
        if !unit && matches!(graph.node(term), Node::Product(_)) && free(term) {
            treatments.set(term, Treatment::Absorbed);
        }
    }
}

/// `-inner` for its own sake: turn a difference, there or in a factor, or put the sign on a numerator.
fn treat_negated(graph: &Graph, inner: Expr, free: &impl Fn(Expr) -> bool, treatments: &mut Treatments) {
    if !free(inner) {
        return;
    }
    let can_turn = |e: Expr| free(e) && turns_for_nothing(graph.node(e));
    if can_turn(inner) {
        treatments.set(inner, Treatment::Turned);
    } else if let Node::Product(factors) = graph.node(inner) {
        if let Some(&(factor, _)) = factors.iter().find(|f| f.1.abs() == 1 && can_turn(f.0)) {
            treatments.set(factor, Treatment::Turned);
            treatments.set(inner, Treatment::Carrier);
        } else if factors.iter().all(|f| f.1 < 0) {
            treatments.set(inner, Treatment::Absorbed); // -1/x
        }
    }
}

/// Has the sum a term that can begin the sum of the opposite sign: a negative one, or one with a number before it?
fn turns_for_nothing(node: &Node) -> bool {
    match node {
        Node::Sum { constant, terms } => {
            let several = terms.len() + usize::from(!constant.is_zero()) > 1;
            several && (!constant.is_zero() || terms.iter().any(|term| !term.0.is_one()))
        }
        _ => false,
    }
}
