//! Nodes: where parts of one domain meet.
//!
//! A storage gives a node its across quantity (a pressure, a position); what acts on the node adds to its through
//! quantities (flows, forces), which the storage reads. Until everything that acts is known, a symbol stands for the sum.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use crate::diag::{Code, help_similar};
use crate::resolve::Resolver;
use crate::resolve::names::{ScopeId, Thunk};
use crate::resolve::values::expect::Wanted;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Scalar, Value};
use crate::span::Span;
use crate::syntax::ast::{self, Domain, Ident};

/// A node.
pub(crate) struct UnresolvedNode<'a> {
    domain: &'a Domain,
    /// Full name, `cylinder.cap`.
    pub(crate) name: String,
    pub(crate) scope: ScopeId,
    pub(crate) span: Span,
    /// Its across quantity, once it has been evaluated; another name of a node has none.
    pub(crate) across: Option<Scalar>,
    /// In the order of its domain.
    pub(crate) through: Vec<Through>,
}

/// A through quantity at a node.
pub(crate) struct Through {
    /// Stands for the sum.
    pub(crate) symbol: Expr,
    /// Stands for its rate.
    pub(crate) rate: Expr,
    /// The summands.
    pub(crate) terms: Vec<Expr>,
    /// Reads of all of them.
    reads: Reads,
}

/// Reads that are assumed of a sum before its terms are known: they let it stand in forces and rates, but in no constraint.
const SUM: Reads = Reads::SUM.and(Reads::POSITION).and(Reads::TIME);

impl<'a> Resolver<'a> {
    /// `node name: kind = expr;`
    pub(crate) fn declare_node(&mut self, scope: ScopeId, ast: &'a ast::Node) {
        if self.needs_index(scope, &ast.name) {
            return;
        }
        let Ok(key) = self.key(scope, &ast.name) else { return };
        let span = ast.name.ident.span;
        let slot = match self.wanted_at(scope, &ast.kind) {
            Ok(Wanted::Port(domain)) => {
                let node = self.new_node(scope, domain, &key, span);
                let wanted = Wanted::Node(node);
                self.names.waiting_slot(span, Thunk { scope, expr: &ast.value, wanted })
            }
            Ok(wanted) => self.names.waiting_slot(span, Thunk { scope, expr: &ast.value, wanted }),
            Err(Failed) => self.names.failed_slot(span),
        };
        self.names.checks.push(slot);
        let home = self.names.home(scope);
        if self.names.instance(scope).is_some() {
            self.names.scopes[home].outputs.insert(key.clone(), slot);
        }
        self.bind(scope, &ast.name.ident, key, slot);
    }

    /// Kind of value that a kind of port wants: `frame`, `body`, or a node of a domain.
    pub(crate) fn wanted_at(&mut self, scope: ScopeId, kind: &Ident) -> Eval<Wanted> {
        match kind.text.as_str() {
            "frame" => return Ok(Wanted::Frame),
            "body" => return Ok(Wanted::Body),
            name => {
                if let Some(domain) = self.library.domain(name) {
                    return Ok(Wanted::Port(self.domain_index(domain)));
                }
            }
        }
        let mut names = vec!["frame", "body"];
        names.push_all(self.library.domains());
        let message = format!("unknown kind of port `{}`", kind.text);
        let diagnostic = self.error(scope, Code::WrongKind, kind.span, message);
        help_similar(diagnostic, &kind.text, "kind", "kinds", &names);
        Err(Failed)
    }

    fn domain_index(&mut self, domain: &'a Domain) -> usize {
        let known = self.unresolved.domains.iter().position(|known| std::ptr::eq(*known, domain));
        known.unwrap_or_else(|| {
            self.unresolved.domains.push(domain);
            self.unresolved.domains.len() - 1
        })
    }

    fn new_node(&mut self, scope: ScopeId, domain: usize, key: &str, span: Span) -> usize {
        let domain = self.unresolved.domains[domain];
        let name = format!("{}{key}", self.names.prefix(scope));
        let through = domain.through.iter().map(|quantity| {
            let symbol = Expr::symbol(format!("{}_of_{name}", quantity.name.text));
            let rate = Expr::symbol(format!("rate_{}_of_{name}", quantity.name.text));
            self.calculus.changes(symbol, rate);
            Through { symbol, rate, terms: Vec::new(), reads: Reads::NOTHING }
        });
        let through = through.collect_vec();
        self.unresolved.nodes.push(UnresolvedNode { domain, name, scope, span, across: None, through });
        self.unresolved.nodes.len() - 1
    }

    /// A node where a port of a domain is wanted.
    pub(crate) fn port_of_domain(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        value: Value,
        domain: usize,
    ) -> Eval<Value> {
        match value {
            Value::Node(node)
                if std::ptr::eq(self.unresolved.nodes[node].domain, self.unresolved.domains[domain]) =>
            {
                Ok(value)
            }
            other => Err(self.not_of_domain(scope, expr, &other, self.unresolved.domains[domain])),
        }
    }

    /// Value of a node: another name of a node, or its across quantity.
    pub(crate) fn value_of_node(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        value: Value,
        node: usize,
    ) -> Eval<Value> {
        let domain = self.unresolved.nodes[node].domain;
        match value {
            Value::Node(other) if other == node => Err(self.needs_itself(scope, node, expr.span)),
            Value::Node(other) if std::ptr::eq(self.unresolved.nodes[other].domain, domain) => Ok(value),
            Value::Scalar(..) => {
                let wanted = Wanted::Number(domain.across.unit.dimension, Reads::ACTING);
                if let Value::Scalar(across) = self.wanted(scope, expr, value, wanted)? {
                    let nature = Nature::derived(across.nature.dimension, across.nature.reads);
                    self.unresolved.nodes[node].across = Some(Quantity { nature, ..across });
                }
                Ok(Value::Node(node))
            }
            other => Err(self.not_of_domain(scope, expr, &other, domain)),
        }
    }

    fn not_of_domain(&mut self, scope: ScopeId, expr: &ast::Expr, found: &Value, domain: &Domain) -> Failed {
        let what = match found {
            Value::Node(node) => {
                format!("a port of the domain `{}`", self.unresolved.nodes[*node].domain.name.text)
            }
            other => other.kind().to_string(),
        };
        let message = format!("expected a port of the domain `{}`, found {what}", domain.name.text);
        let ports = match found {
            Value::Instance(instance) => self.ports_of_domain(*instance, domain),
            _ => Vec::new(),
        };
        let is_of_slider = domain.name.text == "slider" && matches!(found, Value::Frame(_) | Value::Body(_));
        let diagnostic = self.error(scope, Code::WrongKind, expr.span, message);
        if !ports.is_empty() {
            diagnostic.help(format!("name one of its ports: {}", ports.join(", ")));
        } else if is_of_slider && matches!(found, Value::Frame(frame) if frame.body.is_some()) {
            diagnostic.help(
                "a `slider` is one-dimensional: `frame_axes name(body.port);` has ports that push a body",
            );
        } else if is_of_slider {
            diagnostic.help("a fixed point of a line is `slider_ground name();`: write `name.slider`");
        }
        Failed
    }

    /// Names of the ports that a part shows, of one domain.
    fn ports_of_domain(&self, instance: usize, domain: &Domain) -> Vec<String> {
        let prefix = format!("{}.", self.names.instances[instance].name);
        let nodes = self.unresolved.nodes.iter().filter(|node| std::ptr::eq(node.domain, domain));
        let names = nodes.filter_map(|node| node.name.strip_prefix(&prefix));
        names.filter(|name| !name.contains('.')).map(ToString::to_string).collect_vec()
    }

    /// `node.pressure`, `node.flow`; `None` also where the across quantity is not known yet.
    pub(crate) fn node_member(&self, node: usize, name: &str) -> Option<Value> {
        let state = &self.unresolved.nodes[node];
        if state.domain.across.name.text == name {
            return state.across.map(Value::Scalar);
        }
        let through = state.domain.through.iter().position(|quantity| quantity.name.text == name)?;
        let nature = Nature::derived(state.domain.through[through].unit.dimension, SUM);
        Some(Quantity::new(state.through[through].symbol, nature).into())
    }

    /// The across quantity of a node reads itself.
    pub(crate) fn needs_itself(&mut self, scope: ScopeId, node: usize, at: Span) -> Failed {
        let declared = self.unresolved.nodes[node].span;
        self.error(scope, Code::Cycle, at, "this value needs itself")
            .note_at(declared, "its definition stands here");
        Failed
    }

    /// A value with the summands of all sums that it reads. It is left as it is before all that acts on nodes is known.
    pub(crate) fn with_sums(&self, mut value: Scalar) -> Scalar {
        let sums = self.unresolved.nodes.iter().flat_map(|node| &node.through).collect_vec();
        // A sum may read another: as many rounds as there are sums reach the last in a row.
        for _ in 0..=sums.len() {
            if !self.unresolved.has_all_loads || !value.nature.reads.has(Reads::SUM) {
                break;
            }
            let read = algebra::symbols(&[value.value]);
            let read = sums.iter().filter(|sum| read.contains(&sum.symbol)).collect_vec();
            let own = value.nature.reads.beyond(Reads::SUM);
            value.nature.reads = read.iter().fold(own, |reads, sum| reads.and(sum.reads));
            let pairs = read.iter().map(|sum| (sum.symbol, algebra::sum(&sum.terms))).collect_vec();
            value.value = algebra::substitute(&[value.value], &pairs)[0];
        }
        value
    }

    /// Names of the members of a node.
    pub(crate) fn members_of_node(&self, node: usize) -> Vec<&'a str> {
        let domain = self.unresolved.nodes[node].domain;
        let through = domain.through.iter().map(|quantity| quantity.name.text.as_str());
        std::iter::once(domain.across.name.text.as_str()).chain(through).collect_vec()
    }

    /// The node after `from`: of the same domain.
    pub(crate) fn other_node(
        &mut self,
        scope: ScopeId,
        expr: &'a ast::Expr,
        value: Value,
        node: usize,
    ) -> Eval<usize> {
        match value {
            Value::Node(other)
                if std::ptr::eq(self.unresolved.nodes[other].domain, self.unresolved.nodes[node].domain) =>
            {
                Ok(other)
            }
            found => Err(self.not_of_domain(scope, expr, &found, self.unresolved.nodes[node].domain)),
        }
    }

    /// Adds what acts on a node, and its opposite on another.
    pub(crate) fn act_on_node(
        &mut self,
        scope: ScopeId,
        ast: &'a ast::Load,
        node: usize,
        from: Option<usize>,
    ) -> Eval<()> {
        let domain = self.unresolved.nodes[node].domain;
        let name = &ast.quantity;
        let Some(k) = domain.through.iter().position(|of| of.name.text == name.text) else {
            let names: Vec<&str> = domain.through.iter().map(|of| of.name.text.as_str()).collect_vec();
            let message =
                format!("`{}` does not act on a port of the domain `{}`", name.text, domain.name.text);
            let diagnostic = self.error(scope, Code::UnknownMember, name.span, message);
            help_similar(diagnostic, &name.text, "quantity", "what acts on it", &names);
            return Err(Failed);
        };
        let found = self.eval_quantity(scope, &ast.value, domain.through[k].unit.dimension, Reads::ACTING)?;
        if !found.value.is_zero() {
            self.unresolved.on_nodes.push(scope);
        }
        let acting = std::iter::once((node, found.value)).chain(from.map(|from| (from, -found.value)));
        for (node, value) in acting {
            let through = &mut self.unresolved.nodes[node].through[k];
            through.terms.push(value);
            through.reads = through.reads.and(found.nature.reads);
        }
        Ok(())
    }
}
