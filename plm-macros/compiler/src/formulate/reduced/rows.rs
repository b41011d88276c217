//! Rows that give one unknown as a function of others: prescribed motions, gears, a mass on a rod.

use plm_cas::{Expr, Graph};

use super::coordinates::{Coordinates, Unknown};
use super::motion::Motion;
use super::plane::{self, Vec2};
use crate::model::Model;

/// `c u + rest(t, other unknowns) = 0` for one unknown u at least, with a constant c.
#[derive(Clone, Debug)]
pub(crate) struct Explicit {
    /// The row, with a symbol for each unknown.
    pub(crate) phi: Expr,
    /// The unknowns that it holds, ascending, and their symbols.
    pub(crate) held: Vec<(usize, Expr)>,
    /// The unknowns that it can be solved for, and their coefficients.
    coefficients: Vec<(usize, Expr)>,
}

impl Explicit {
    /// Can it be solved for this unknown?
    pub(crate) fn gives(&self, unknown: usize) -> bool {
        self.coefficients.iter().any(|(of, _)| *of == unknown)
    }
}

/// The row as an explicit one, if it is.
pub(crate) fn explicit(
    model: &Model,
    coordinates: &Coordinates,
    phi: Expr,
    graph: &mut Graph,
) -> Option<Explicit> {
    let symbols: Vec<Expr> =
        (0..coordinates.unknowns.len()).map(|k| graph.symbol(&format!("u_{k}"))).collect();
    let pairs = poses(model, coordinates, phi, &symbols, graph);
    let phi = graph.substitute(&[phi], &pairs)[0];
    let left = graph.symbols(&[phi]);
    let is_fixed = |symbol: &Expr| {
        *symbol == model.time
            || symbols.contains(symbol)
            || model.sides.iter().any(|side| side.symbol == *symbol)
            || model.params.iter().any(|param| param.symbol == *symbol)
    };
    if !left.iter().all(is_fixed) {
        return None;
    }
    let held = symbols.iter().enumerate().filter(|(_, symbol)| left.contains(symbol));
    let held: Vec<(usize, Expr)> = held.map(|(unknown, &symbol)| (unknown, symbol)).collect();
    let mut coefficients = Vec::new();
    for &(unknown, symbol) in &held {
        let coefficient = graph.diff(phi, symbol);
        let changes = graph.symbols(&[coefficient]);
        if !changes.contains(&model.time) && !held.iter().any(|(_, symbol)| changes.contains(symbol)) {
            coefficients.push((unknown, coefficient));
        }
    }
    (!coefficients.is_empty()).then_some(Explicit { phi, held, coefficients })
}

/// What stands for the poses of the bodies that an expression holds.
fn poses(
    model: &Model,
    coordinates: &Coordinates,
    phi: Expr,
    symbols: &[Expr],
    graph: &mut Graph,
) -> Vec<(Expr, Expr)> {
    let held = graph.symbols(&[phi]);
    let mut pairs = Vec::new();
    for (body, declared) in model.bodies.iter().enumerate() {
        if !declared.q.iter().any(|symbol| held.contains(symbol)) {
            continue;
        }
        let heading = coordinates.headings[body];
        let angle =
            coordinates.angle_of_class[heading.class].map_or(graph.zero(), |unknown| symbols[unknown]);
        let axis = [graph.cos(angle), graph.sin(angle)];
        let offset = [graph.cos(heading.offset), graph.sin(heading.offset)];
        let own = plane::turn(graph, axis, offset);
        let theta = declared.q[2];
        pairs.extend([(graph.cos(theta), own[0]), (graph.sin(theta), own[1])]);
        pairs.push((theta, graph.add(angle, heading.offset)));
        let place = place(coordinates, body, symbols, graph);
        pairs.extend([(declared.q[0], place[0]), (declared.q[1], place[1])]);
    }
    pairs
}

/// G of a body as a function of the unknowns.
fn place(coordinates: &Coordinates, body: usize, symbols: &[Expr], graph: &mut Graph) -> Vec2 {
    let mut sum = [graph.zero(); 2];
    for (class, slide, vector) in coordinates.centres[body].terms() {
        let factor = slide.map_or(graph.one(), |slide| symbols[slide]);
        let vector = plane::scale(graph, factor, vector);
        let turned = match coordinates.angle_of_class[class] {
            Some(angle) => {
                let axis = [graph.cos(symbols[angle]), graph.sin(symbols[angle])];
                plane::turn(graph, axis, vector)
            }
            None => vector,
        };
        sum = plane::add(graph, sum, turned);
    }
    sum
}

/// Solves a row for one unknown and writes its value, coefficients and rate.
pub(crate) fn solve(
    coordinates: &Coordinates,
    motion: &mut Motion,
    row: &Explicit,
    unknown: usize,
    time: Expr,
    graph: &mut Graph,
) {
    let Some(own) = row.coefficients.iter().find(|(of, _)| *of == unknown).map(|found| found.1) else {
        return;
    };
    let others: Vec<(usize, Expr)> = row.held.iter().copied().filter(|(of, _)| *of != unknown).collect();
    let symbol = row.held.iter().find(|(of, _)| *of == unknown).map_or(time, |found| found.1);
    let zero = graph.zero();
    let rest = graph.substitute(&[row.phi], &[(symbol, zero)])[0];
    let slopes: Vec<Expr> = others.iter().map(|&(_, symbol)| graph.diff(rest, symbol)).collect();
    // Along the motion, but for the second derivatives of the other unknowns.
    let rates = others.iter().map(|&(of, _)| graph.symbol(&format!("u_rate_{of}")));
    let rates: Vec<Expr> = rates.collect();
    let mut flow: Vec<(Expr, Expr)> =
        others.iter().zip(&rates).map(|(&(_, symbol), &rate)| (symbol, rate)).collect();
    flow.push((time, graph.one()));
    let rate = graph.directional(rest, &flow);
    let curvature = graph.directional(rate, &flow);
    let by_time = graph.diff(rest, time);

    let mut pairs = known(coordinates, motion, &others, graph);
    pairs.extend(others.iter().zip(&rates).map(|(&(of, _), &rate)| (rate, motion.sliding(of))));
    let mut roots = vec![rest, by_time, curvature];
    roots.extend(&slopes);
    let roots = graph.substitute(&roots, &pairs);
    let (&[rest, by_time, curvature], slopes) = roots.split_at(3) else { return };
    let sum = |graph: &mut Graph, start: Expr, of: &dyn Fn(usize) -> Expr| {
        let mut terms = vec![start];
        terms.extend(others.iter().zip(slopes).map(|(&(other, _), &slope)| graph.mul(slope, of(other))));
        let sum = graph.sum(&terms);
        let sum = graph.neg(sum);
        graph.div(sum, own)
    };
    let value = graph.neg(rest);
    let value = graph.div(value, own);
    let drift = sum(graph, by_time, &|other| motion.drift[other]);
    let bias = sum(graph, curvature, &|other| motion.bias[other]);
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

/// What stands for the symbols of unknowns that are known.
fn known(
    coordinates: &Coordinates,
    motion: &Motion,
    others: &[(usize, Expr)],
    graph: &mut Graph,
) -> Vec<(Expr, Expr)> {
    let mut pairs = Vec::new();
    for &(unknown, symbol) in others {
        if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
            let along = [graph.one(), graph.zero()];
            let [cos, sin] = motion.turned(graph, class, along);
            pairs.extend([(graph.cos(symbol), cos), (graph.sin(symbol), sin)]);
        }
        pairs.push((symbol, motion.value[unknown]));
    }
    pairs
}
