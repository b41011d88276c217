//! Which conditions matter, given the sides of the others: `slip > 0` in `if bend > limit and slip > 0 then …` does not as long
//! as the other one does not hold.
//!
//! A condition matters where a force, a rate or a row would be another expression if it had its other side, and a kink where it is
//! read. That is a function of the sides that are held, and is kept as a decision diagram of all of them (R. E. Bryant, Graph-based algorithms for Boolean
//! function manipulation, IEEE Trans. Computers 35, 1986).

mod diagram;

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedMap;
use plm_cas::{Expr, Function, Node, algebra};

use self::diagram::{Diagram, FALSE, TRUE};
use super::forcing_terms;
use crate::model::{Decisions, End, Model};

/// Above so many conditions each of them matters always: diagrams may grow with the power of their number.
const MOST_SIDES: usize = 64;

/// When each of the conditions of the state matters, and each kink after them; nothing if all of them do always. `held` are the
/// conditions whose sides are held and what will stand for them.
pub(super) fn decisions(model: &Model, held: &[(Expr, Expr)]) -> Decisions {
    if held.is_empty() || model.watched() == 0 || model.switches.len() > MOST_SIDES {
        return Decisions::default();
    }
    let mut all = Matters::new(model, held);
    all.walk();
    let (diagram, roots) = all.finished();
    if diagram.is_too_large() || roots.iter().all(|root| *root == TRUE) {
        return Decisions::default();
    }
    diagram.reduced(roots)
}

/// Results of the search, from forces, rates and rows downwards.
struct Matters<'a> {
    model: &'a Model,
    diagram: Diagram,
    /// Conditions whose sides are held, and the indices of their switches.
    held: Vec<(Expr, usize)>,
    /// All expressions, ascending: operands are older than what reads them.
    nodes: Vec<Expr>,
    /// The sides at which each is read.
    read: Vec<usize>,
    /// The sides at which two expressions differ.
    differ: SortedMap<(Expr, Expr), usize>,
    /// The sides at which each condition matters, and at which each kink does.
    roots: Vec<usize>,
    kinks: Vec<usize>,
}

impl<'a> Matters<'a> {
    fn new(model: &'a Model, held: &[(Expr, Expr)]) -> Self {
        let moving = forcing_terms(model).map(|term| term.value);
        let starts: Vec<Expr> = moving.chain(model.rows.iter().map(|row| row.phi)).collect_vec();
        let nodes = algebra::reachable(&starts);
        let mut read = vec![FALSE; nodes.len()];
        for start in starts {
            if let Ok(place) = nodes.binary_search(&start) {
                read[place] = TRUE;
            }
        }
        let switch = |by: Expr| {
            let symbols = algebra::symbols(&[by]);
            model.switches.iter().position(|switch| symbols.contains(&switch.symbol))
        };
        let held = held.iter().filter_map(|&(of, by)| Some((of, switch(by)?))).collect_vec();
        let (roots, kinks) = (vec![FALSE; model.switches.len()], vec![FALSE; model.kinks.len()]);
        Self { model, diagram: Diagram::new(), held, nodes, read, differ: SortedMap::new(), roots, kinks }
    }

    /// The diagram, and where the conditions of the state begin in it, then the kinks. What must hold, what sets states
    /// and what rows of contact exist by matters always.
    fn finished(self) -> (Diagram, Vec<usize>) {
        let Self { model, diagram, held, mut roots, kinks, .. } = self;
        let of_events = model.whens.iter().filter_map(|when| when.condition);
        let of_rows = model.contacts.iter().filter_map(|row| row.exists);
        let of_events = algebra::reachable(&of_events.chain(of_rows).collect_vec());
        for (_, side) in held.iter().filter(|(of, _)| of_events.contains(of)) {
            roots[*side] = TRUE;
        }
        for (root, _) in roots.iter_mut().zip(&model.switches).filter(|(_, switch)| switch.must_hold) {
            *root = TRUE;
        }
        roots.truncate(model.guards());
        roots.push_all(kinks);
        (diagram, roots)
    }

    /// Every expression after those that read it.
    fn walk(&mut self) {
        for place in (0..self.nodes.len()).rev() {
            let (expr, read) = (self.nodes[place], self.read[place]);
            let node = expr.node();
            // What jumps by itself is held where it is read.
            if let (Node::Call(..), Some(&(_, side))) = (&node, self.held.iter().find(|(of, _)| *of == expr))
            {
                self.roots[side] = self.diagram.or(self.roots[side], read);
            }
            let Some((side, yes, no)) = self.choice(&node) else {
                self.bends(&node, read);
                self.ends(expr, &node, read);
                node.for_each_child(|child| self.reads(child, read, TRUE));
                continue;
            };
            let differs = self.differs(yes, no);
            let matters = self.diagram.and(read, differs);
            let matters = self.diagram.without(matters, side);
            self.roots[side] = self.diagram.or(self.roots[side], matters);
            let holds = self.diagram.side(side);
            self.reads(yes, read, holds);
            let fails = self.diagram.not(holds);
            self.reads(no, read, fails);
        }
    }

    /// Divisors, and the arguments that decide where a function is defined, end a run where they are read.
    fn ends(&mut self, expr: Expr, node: &Node, read: usize) {
        for (side, switch) in self.model.switches.iter().enumerate() {
            let is_read = match (&switch.end, node) {
                (Some(End::Pole(_)), Node::Product(factors)) => {
                    factors.iter().any(|&(factor, exponent)| exponent < 0 && factor == switch.difference)
                }
                (Some(End::Domain(text)), Node::Call(..)) => *text == expr.to_string(),
                _ => false,
            };
            if is_read {
                self.roots[side] = self.diagram.or(self.roots[side], read);
            }
        }
    }

    /// A comparison that is no switch is a derivative discontinuity.
    fn bends(&mut self, node: &Node, read: usize) {
        let (difference, matters) = match node {
            Node::Select(condition, yes, no) => match condition.node() {
                Node::Less(a, b) => (a - b, self.differs(*yes, *no)),
                _ => return,
            },
            Node::Call(Function::Min | Function::Max, of) if of.len() == 2 => (of[0] - of[1], TRUE),
            Node::Call(Function::Abs, of) if of.len() == 1 => (of[0], TRUE),
            _ => return,
        };
        let matters = self.diagram.and(read, matters);
        let opposite = -difference;
        for (kink, root) in self.model.kinks.iter().zip(&mut self.kinks) {
            if *kink == difference || *kink == opposite {
                *root = self.diagram.or(*root, matters);
            }
        }
    }

    /// An operand is read where what reads it is, `when` it is chosen.
    fn reads(&mut self, operand: Expr, read: usize, when: usize) {
        if let Ok(place) = self.nodes.binary_search(&operand) {
            let chosen = self.diagram.and(read, when);
            self.read[place] = self.diagram.or(self.read[place], chosen);
        }
    }

    /// The condition by whose side a node chooses, and the two values.
    fn choice(&self, node: &Node) -> Option<(usize, Expr, Expr)> {
        let Node::Select(condition, yes, no) = *node else { return None };
        let &(_, side) = self.held.iter().find(|(of, _)| *of == condition)?;
        Some((side, yes, no))
    }

    /// The sides at which two values are not the same expression. It goes as deep as choices stand within choices by sides, of
    /// which there are few.
    fn differs(&mut self, a: Expr, b: Expr) -> usize {
        if a == b {
            return FALSE;
        }
        if let Some(known) = self.differ.get(&(a, b)) {
            return *known;
        }
        let found = if let Some((side, yes, no)) = self.choice(&a.node()) {
            let (yes, no) = (self.differs(yes, b), self.differs(no, b));
            self.diagram.choice(side, yes, no)
        } else if let Some((side, yes, no)) = self.choice(&b.node()) {
            let (yes, no) = (self.differs(a, yes), self.differs(a, no));
            self.diagram.choice(side, yes, no)
        } else {
            TRUE
        };
        self.differ.insert((a, b), found);
        found
    }
}
