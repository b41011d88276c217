//! Kinks of constraint rows: conditions in them, and `abs`, `min`, `max`, `sign`, which are written as conditions.
//!
//! A row holds a position. Where its two sides differ at the boundary of a condition the bodies would have to jump, where
//! their rates differ an impulse would be needed, and where only the second derivatives do, the accelerations jump: that is
//! an event like a force that jumps. Which of these it is follows from the difference of the sides and its derivatives along
//! the motion, taken on the boundary.
//!
//! Assembly and projection hold no side of these conditions: both sides agree there.

mod boundary;

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Function, Node, algebra};

use crate::model::{Jump, Model};

use self::boundary::Order;
pub(super) use self::boundary::{Boundary, root};

/// A condition that a row reads.
pub(super) struct Kink {
    /// `Less(a, b)`
    pub(super) condition: Expr,
    /// `a - b`
    pub(super) difference: Expr,
    /// The row that it stands in, the first of several.
    pub(super) row: usize,
    /// Jumps there, row by row; smooth rows and those in which only accelerations jump are not among them.
    pub(super) jumps: Vec<Jump>,
    /// Does anything jump, be it an acceleration? A condition of the time alone is one anyway.
    pub(super) bends: bool,
}

/// Writes what bends in rows and in moving ports of the ground as conditions.
pub(super) fn unfold(model: &mut Model) {
    loop {
        let moving = moving(model);
        let roots: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
        let found = algebra::reachable(&roots).into_iter().find_map(|expr| {
            let Node::Call(function, arguments) = expr.node() else { return None };
            let arguments = arguments.into_vec();
            let bends = matches!(function, Function::Abs | Function::Sign | Function::Min | Function::Max);
            let moves = algebra::symbols(&arguments).iter().any(|symbol| moving.contains(symbol));
            (bends && moves).then_some((expr, function, arguments))
        });
        let Some((call, function, arguments)) = found else { return };
        substitute(model, &[(call, unfolded(function, &arguments))]);
    }
}

/// A call as a choice between what it is on either side.
fn unfolded(function: Function, arguments: &[Expr]) -> Expr {
    let (zero, one) = (Expr::ZERO, Expr::ONE);
    match (function, arguments) {
        (Function::Min, &[a, b]) => a.less(b).select(a, b),
        (Function::Max, &[a, b]) => a.less(b).select(b, a),
        (Function::Sign, &[x]) => x.less(zero).select(Expr::from(-1), one),
        (_, &[x, ..]) => x.less(zero).select(-x, x), // abs
        (_, &[]) => zero,
    }
}

/// Puts the second of each pair in the place of the first, in rows and in the ports of the ground that they stand on.
pub(super) fn substitute(model: &mut Model, pairs: &[(Expr, Expr)]) {
    for row in &mut model.rows {
        row.phi = algebra::substitute(&[row.phi], pairs)[0];
    }
    for port in &mut model.ground {
        let replaced = algebra::substitute(&[port.at.x, port.at.y, port.angle], pairs);
        (port.at, port.angle) = ([replaced[0], replaced[1]].into(), replaced[2]);
    }
}

/// Symbols that change during a run and may stand in a row.
fn moving(model: &Model) -> Vec<Expr> {
    let coordinates = model.bodies.iter().flat_map(|body| body.q);
    coordinates.chain([model.time]).collect_vec()
}

/// The conditions of all rows that change while it runs.
pub(super) fn kinks(model: &Model) -> Vec<Kink> {
    let roots: Vec<Expr> = model.rows.iter().map(|row| row.phi).collect_vec();
    let moving = moving(model);
    let mut found = Vec::new();
    for condition in algebra::reachable(&roots) {
        let Node::Less(a, b) = condition.node() else { continue };
        let difference = a - b;
        if algebra::symbols(&[difference]).iter().any(|symbol| moving.contains(symbol)) {
            found.push_all(kink(model, condition, difference));
        }
    }
    found
}

fn kink(model: &Model, condition: Expr, difference: Expr) -> Option<Kink> {
    let boundary = Boundary::new(model, difference);
    let mut kink = Kink { condition, difference, row: model.rows.len(), jumps: Vec::new(), bends: false };
    for (index, row) in model.rows.iter().enumerate() {
        if !algebra::reachable(&[row.phi]).contains(&condition) {
            continue;
        }
        kink.row = kink.row.min(index);
        let row_where = |holds: Expr| algebra::substitute(&[row.phi], &[(condition, holds)])[0];
        let sides = [row_where(Expr::ONE), row_where(Expr::ZERO)];
        let gap = sides[0] - sides[1];
        let [rate, bend] = derivatives(model, gap);
        let order = boundary.order(&[gap, rate, bend], sides);
        kink.bends |= order != Order::Smooth;
        if matches!(order, Order::Place | Order::Speed) {
            let steady = boundary.jump(gap, rate, sides);
            let [along, _] = derivatives(model, difference);
            let terms = [gap, rate, bend, difference, along];
            kink.jumps.push(Jump { switch: 0, row: index, terms, steady });
        }
    }
    (kink.row < model.rows.len()).then_some(kink)
}

/// First and second derivative along a motion at constant speed.
pub(super) fn derivatives(model: &Model, expr: Expr) -> [Expr; 2] {
    let bodies = model.bodies.iter().flat_map(|body| body.q.into_iter().zip(body.v));
    let mut flow: Vec<(Expr, Expr)> = bodies.collect_vec();
    flow.push((model.time, Expr::ONE));
    let rate = expr.directional(&flow);
    [rate, rate.directional(&flow)]
}
