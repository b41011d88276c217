//! Rates of states and sums at nodes are known last. Until then symbols stand in for them; here each symbol is replaced by its
//! value.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedSet;

use plm_cas::{Expr, algebra};

use crate::diag::Code;
use crate::model::{Contact, Load, Output, State, When};
use crate::resolve::Resolver;
use crate::resolve::declarations::node::UnresolvedNode;
use crate::span::Span;

/// A value that a symbol stood for.
struct Placeholder {
    symbol: Expr,
    value: Expr,
    /// Its name in messages.
    what: String,
    span: Span,
}

impl Resolver<'_> {
    /// Puts rates and sums where symbols stood for them.
    pub(crate) fn replace_placeholders(
        &mut self,
        states: &mut [State],
        loads: &mut [Load],
        outputs: &mut [Output],
        (switches, whens): (Vec<&mut Expr>, &mut [When]),
        contacts: &mut [Contact],
    ) {
        if states.len() < self.unresolved.states.len() || self.sink.has_errors() {
            return;
        }
        let mut placeholders = self.placeholders(states);
        let mut places: Vec<&mut Expr> = Vec::new();
        places.push_all(states.iter_mut().map(|state| &mut state.rate));
        places.push_all(loads.iter_mut().flat_map(|load| &mut load.force));
        places.push_all(outputs.iter_mut().flat_map(|output| &mut output.components));
        places.push_all(switches);
        places.push_all(whens.iter_mut().flat_map(When::expressions_mut));
        places.push_all(contacts.iter_mut().flat_map(Contact::expressions_mut));
        let roots: Vec<Expr> = places.iter().map(|place| **place).collect_vec();
        self.add_rates_of_sums(&roots, &mut placeholders);
        if placeholders.is_empty() || !self.free_of_each_other(&mut placeholders) {
            return;
        }
        let pairs: Vec<(Expr, Expr)> = placeholders.iter().map(|of| (of.symbol, of.value)).collect_vec();
        for (place, root) in places.into_iter().zip(algebra::substitute(&roots, &pairs)) {
            *place = root;
        }
    }

    fn placeholders(&mut self, states: &[State]) -> Vec<Placeholder> {
        let rates = self.unresolved.states.iter().zip(states).map(|(state, found)| Placeholder {
            symbol: state.placeholder,
            value: found.rate,
            what: format!("the rate of `{}`", found.name.text),
            span: found.name.span,
        });
        let mut placeholders: Vec<Placeholder> = rates.collect_vec();
        placeholders.push_all(self.unresolved.idle.iter().map(|(symbol, value, span)| Placeholder {
            symbol: *symbol,
            value: *value,
            what: String::new(),
            span: *span,
        }));
        for node in &self.unresolved.nodes {
            for through in &node.through {
                let value = algebra::sum(&through.terms);
                let what = format!("what acts on `{}`", node.name);
                placeholders.push(Placeholder { symbol: through.symbol, value, what, span: node.span });
            }
        }
        placeholders
    }

    /// Rates of sums, of those sums whose rate is read. What is read by one may be read by it alone.
    fn add_rates_of_sums(&mut self, roots: &[Expr], placeholders: &mut Vec<Placeholder>) {
        let mut open: Vec<(usize, usize)> = Vec::new();
        for (node, state) in self.unresolved.nodes.iter().enumerate() {
            open.push_all((0..state.through.len()).map(|k| (node, k)));
        }
        loop {
            let mut read: Vec<Expr> = roots.to_vec();
            read.push_all(placeholders.iter().map(|of| of.value));
            let read: SortedSet<Expr> = algebra::symbols(&read).into_iter().collect();
            let is_read =
                |&(node, k): &(usize, usize)| read.contains(&self.unresolved.nodes[node].through[k].rate);
            let (now, later): (Vec<_>, Vec<_>) = open.into_iter().partition(is_read);
            if now.is_empty() {
                return;
            }
            open = later;
            for (node, k) in now {
                placeholders.push_all(self.rate_of_sum(node, k));
            }
        }
    }

    fn rate_of_sum(&mut self, node: usize, k: usize) -> Option<Placeholder> {
        let sum = algebra::sum(&self.unresolved.nodes[node].through[k].terms);
        let value = self.calculus.total_derivative(sum);
        let UnresolvedNode { name, span, scope, .. } = &self.unresolved.nodes[node];
        let (what, span, scope) = (format!("the rate of what acts on `{name}`"), *span, *scope);
        let inputs = self.calculus.held.clone();
        let accelerations: Vec<Expr> = self.unresolved.bodies.iter().flat_map(|body| body.a).collect_vec();
        if holds_any(sum, &inputs) {
            self.error(scope, Code::NoRate, span, format!("{what} is not known: it reads inputs"))
                .note("inputs are held over a step; a `state` has a rate");
            return None;
        }
        if holds_any(value, &accelerations) {
            self.error(scope, Code::Feedback, span, format!("{what} reads accelerations"));
            return None;
        }
        Some(Placeholder { symbol: self.unresolved.nodes[node].through[k].rate, value, what, span })
    }

    /// Frees the placeholders values of the symbols of others. One may hold another: as many rounds as there are values reach the
    /// last in a row. False if one needs itself.
    fn free_of_each_other(&mut self, placeholders: &mut [Placeholder]) -> bool {
        let symbols: Vec<Expr> = placeholders.iter().map(|of| of.symbol).collect_vec();
        let mut values: Vec<Expr> = placeholders.iter().map(|of| of.value).collect_vec();
        for _ in 0..symbols.len() {
            let pairs: Vec<(Expr, Expr)> = symbols.iter().copied().zip(values.iter().copied()).collect_vec();
            let next = algebra::substitute(&values, &pairs);
            if next == values {
                break;
            }
            values = next;
        }
        let circle = |k: &usize| holds_any(values[*k], &symbols[*k..=*k]);
        if let Some(k) = (0..values.len()).find(circle) {
            let message = format!("{} needs itself", placeholders[k].what);
            self.error(0, Code::Cycle, placeholders[k].span, message);
            return false;
        }
        for (of, value) in placeholders.iter_mut().zip(values) {
            of.value = value;
        }
        true
    }
}

fn holds_any(expr: Expr, symbols: &[Expr]) -> bool {
    algebra::symbols(&[expr]).iter().any(|symbol| symbols.contains(symbol))
}
