//! Where constraint rows bend: conditions in them, and `abs`, `min`, `max`, `sign`, which are conditions as well.
//!
//! A row holds a position. Where its two sides differ at the boundary of a condition the bodies would have to jump, where
//! their rates differ an impulse would be needed, and where only the second derivatives do, the accelerations jump: that is
//! an event like a force that jumps. Which of these it is follows from the difference of the sides and its derivatives along
//! the motion, taken on the boundary.

mod boundary;

use plm_cas::{Expr, Function, Graph, Node};

use crate::check::value;
use crate::model::{Jump, Model};

use self::boundary::{Boundary, Order};

/// A condition that a row reads.
pub(super) struct Kink {
    /// `Less(a, b)`
    pub(super) condition: Expr,
    /// `a - b`
    pub(super) difference: Expr,
    /// The row that it stands in, the first of several.
    pub(super) row: usize,
    /// What may jump there, row by row; smooth rows and those in which only accelerations jump are not among them.
    pub(super) jumps: Vec<Jump>,
    /// Does anything jump, be it an acceleration? A condition of the time alone is one anyway.
    pub(super) bends: bool,
}

/// Writes what bends in rows and in moving ports of the ground as conditions.
pub(super) fn unfold(model: &mut Model, graph: &mut Graph) {
    loop {
        let moving = moving(model);
        let roots: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect();
        let found = graph.reachable(&roots).into_iter().find_map(|expr| {
            let Node::Call(function, arguments) = graph.node(expr) else { return None };
            let (function, arguments) = (*function, arguments.to_vec());
            let bends = matches!(function, Function::Abs | Function::Sign | Function::Min | Function::Max);
            let moves = graph.symbols(&arguments).iter().any(|symbol| moving.contains(symbol));
            (bends && moves).then_some((expr, function, arguments))
        });
        let Some((call, function, arguments)) = found else { return };
        let unfolded = unfolded(function, &arguments, graph);
        let pairs = [(call, unfolded)];
        substitute(model, &pairs, graph);
    }
}

/// A call as a choice between what it is on either side.
fn unfolded(function: Function, arguments: &[Expr], graph: &mut Graph) -> Expr {
    let (zero, one) = (graph.zero(), graph.one());
    match (function, arguments) {
        (Function::Min, &[a, b]) => {
            let less = graph.less(a, b);
            graph.select(less, a, b)
        }
        (Function::Max, &[a, b]) => {
            let less = graph.less(a, b);
            graph.select(less, b, a)
        }
        (Function::Sign, &[x]) => {
            let (below, minus) = (graph.less(x, zero), graph.int(-1));
            graph.select(below, minus, one)
        }
        _ => {
            let x = arguments.first().copied().unwrap_or(zero);
            let (below, negative) = (graph.less(x, zero), graph.neg(x));
            graph.select(below, negative, x)
        }
    }
}

/// Puts the second of each pair in the place of the first, in rows and in the ports of the ground that they stand on.
pub(super) fn substitute(model: &mut Model, pairs: &[(Expr, Expr)], graph: &mut Graph) {
    for row in &mut model.rows {
        row.phi = graph.substitute(&[row.phi], pairs)[0];
    }
    for port in &mut model.ground {
        let [x, y] = port.at;
        let replaced = graph.substitute(&[x, y, port.angle], pairs);
        (port.at, port.angle) = ([replaced[0], replaced[1]], replaced[2]);
    }
}

/// What changes while it runs and may stand in a row.
fn moving(model: &Model) -> Vec<Expr> {
    let coordinates = model.bodies.iter().flat_map(|body| body.q);
    coordinates.chain([model.time]).collect()
}

/// The conditions of all rows that change while it runs.
pub(super) fn kinks(model: &Model, graph: &mut Graph) -> Vec<Kink> {
    let roots: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect();
    let moving = moving(model);
    let conditions = graph.reachable(&roots).into_iter().filter_map(|expr| match *graph.node(expr) {
        Node::Less(a, b) => Some((expr, a, b)),
        _ => None,
    });
    let conditions: Vec<(Expr, Expr, Expr)> = conditions.collect();
    let mut found = Vec::new();
    for (condition, a, b) in conditions {
        let difference = graph.sub(a, b);
        if !graph.symbols(&[difference]).iter().any(|symbol| moving.contains(symbol)) {
            continue;
        }
        found.extend(kink(model, (condition, difference), graph));
    }
    found
}

fn kink(model: &Model, (condition, difference): (Expr, Expr), graph: &mut Graph) -> Option<Kink> {
    let boundary = Boundary::new(model, difference, graph);
    let mut kink = Kink { condition, difference, row: model.rows.len(), jumps: Vec::new(), bends: false };
    for (index, row) in model.rows.iter().enumerate() {
        if !graph.reachable(&[row.phi]).contains(&condition) {
            continue;
        }
        kink.row = kink.row.min(index);
        let sides =
            [graph.one(), graph.zero()].map(|holds| graph.substitute(&[row.phi], &[(condition, holds)])[0]);
        let gap = graph.sub(sides[0], sides[1]);
        let [rate, bend] = derivatives(model, gap, graph);
        let order = boundary.order(&[gap, rate, bend], sides, graph);
        kink.bends |= order != Order::Smooth;
        if matches!(order, Order::Place | Order::Speed) {
            let steady = boundary.jump(gap, rate, sides, graph);
            let [along, _] = derivatives(model, difference, graph);
            let terms = [gap, rate, bend, difference, along];
            kink.jumps.push(Jump { side: 0, row: index, terms, steady });
        }
    }
    (kink.row < model.rows.len()).then_some(kink)
}

/// First and second derivative along a motion at constant speed.
fn derivatives(model: &Model, expr: Expr, graph: &mut Graph) -> [Expr; 2] {
    let bodies = model.bodies.iter().flat_map(|body| body.q.into_iter().zip(body.v));
    let mut flow: Vec<(Expr, Expr)> = bodies.collect();
    flow.push((model.time, graph.one()));
    let rate = graph.directional(expr, &flow);
    [rate, graph.directional(rate, &flow)]
}

/// Value of what holds numbers alone.
fn number(graph: &Graph, expr: Expr) -> f64 {
    value(graph, expr, &[])
}
