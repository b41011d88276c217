//! Rows that are linear in the unknowns: prescribed motions, gears.

use plm_cas::{Expr, Graph};

use super::chain::Chain;
use super::coordinates::{Coordinates, Heading, Unknown};
use super::motion::Motion;
use crate::model::Model;

/// `sum of c_j u_j + rest(t) = 0` with constant coefficients.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    /// Unknown and coefficient, ascending.
    pub(crate) terms: Vec<(usize, Expr)>,
    /// What depends on the time at most.
    pub(crate) rest: Expr,
}

/// The row as a linear one in the unknowns, if it is.
pub(crate) fn linear(
    model: &Model,
    coordinates: &Coordinates,
    phi: Expr,
    graph: &mut Graph,
) -> Option<Linear> {
    let symbols: Vec<Expr> =
        (0..coordinates.unknowns.len()).map(|k| graph.symbol(&format!("u_{k}"))).collect();
    let mut pairs = Vec::new();
    for (body, declared) in model.bodies.iter().enumerate() {
        let Heading { class, offset } = coordinates.headings[body];
        let of_class = coordinates.angle_of_class[class].map_or(graph.zero(), |unknown| symbols[unknown]);
        let angle = graph.add(of_class, offset);
        pairs.push((declared.q[2], angle));
        if let Some([x, y]) = straight(&coordinates.centres[body], &symbols, graph) {
            pairs.extend([(declared.q[0], x), (declared.q[1], y)]);
        }
    }
    let phi = graph.substitute(&[phi], &pairs)[0];
    let left = graph.symbols(&[phi]);
    let of_bodies =
        |symbol: &Expr| model.bodies.iter().any(|body| body.q.contains(symbol) || body.v.contains(symbol));
    let of_states = |symbol: &Expr| model.states.iter().any(|state| state.symbol == *symbol);
    let of_inputs = |symbol: &Expr| model.inputs.iter().any(|input| input.symbol == *symbol);
    if left.iter().any(|symbol| of_bodies(symbol) || of_states(symbol) || of_inputs(symbol)) {
        return None;
    }
    let mut terms = Vec::new();
    let mut rest = phi;
    for (unknown, &symbol) in symbols.iter().enumerate() {
        let coefficient = graph.diff(phi, symbol);
        if graph.is_zero(coefficient) {
            continue;
        }
        let held = graph.symbols(&[coefficient]);
        if held.contains(&model.time) || held.iter().any(|symbol| symbols.contains(symbol)) {
            return None;
        }
        terms.push((unknown, coefficient));
        rest = graph.substitute(&[rest], &[(symbol, graph.zero())])[0];
    }
    (!terms.is_empty()).then_some(Linear { terms, rest })
}

/// A place whose vectors are fixed on the ground, or slide along it.
fn straight(centre: &Chain, symbols: &[Expr], graph: &mut Graph) -> Option<[Expr; 2]> {
    let mut sum = [graph.zero(); 2];
    for (class, slide, vector) in centre.terms() {
        if class != 0 {
            return None;
        }
        let factor = slide.map_or(graph.one(), |slide| symbols[slide]);
        let along = super::plane::scale(graph, factor, vector);
        sum = super::plane::add(graph, sum, along);
    }
    Some(sum)
}

/// Solves a row for one unknown and writes its value, coefficients and rate.
pub(crate) fn solve(
    coordinates: &Coordinates,
    motion: &mut Motion,
    row: &Linear,
    unknown: usize,
    time: Expr,
    graph: &mut Graph,
) {
    let rates = [row.rest, graph.diff(row.rest, time)];
    let curvature = graph.diff(rates[1], time);
    let sum = |graph: &mut Graph, start: Expr, of: &dyn Fn(usize) -> Expr| {
        let mut terms = vec![start];
        let mut own = graph.one();
        for &(other, coefficient) in &row.terms {
            if other == unknown {
                own = coefficient;
            } else {
                terms.push(graph.mul(coefficient, of(other)));
            }
        }
        let sum = graph.sum(&terms);
        let sum = graph.neg(sum);
        graph.div(sum, own)
    };
    let value = sum(graph, rates[0], &|other| motion.value[other]);
    let drift = sum(graph, rates[1], &|other| motion.drift[other]);
    let bias = sum(graph, curvature, &|other| motion.bias[other]);
    let zero = graph.zero();
    for driver in 0..motion.drivers.len() {
        let gain = sum(graph, zero, &|other| motion.gain[other][driver]);
        motion.gain[unknown][driver] = gain;
    }
    let value = motion.set_slide(unknown, value, graph);
    (motion.drift[unknown], motion.bias[unknown]) = (drift, bias);
    if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
        motion.axis[class] = [graph.cos(value), graph.sin(value)];
    }
    motion.set_rate(coordinates, unknown, graph);
}
