//! Rows that give one unknown as a function of others: prescribed motions, gears, a mass on a rod.

use plm_cas::{Expr, Rotation, Vec2, algebra};

use super::coordinates::{Coordinates, Unknown};
use super::motion::Motion;
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
pub(crate) fn explicit(model: &Model, coordinates: &Coordinates, phi: Expr) -> Option<Explicit> {
    let symbols: Vec<Expr> =
        (0..coordinates.unknowns.len()).map(|k| Expr::symbol(format!("u_{k}"))).collect();
    let pairs = poses(model, coordinates, phi, &symbols);
    let phi = algebra::substitute(&[phi], &pairs)[0];
    let left = algebra::symbols(&[phi]);
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
        let coefficient = phi.diff(symbol);
        let changes = algebra::symbols(&[coefficient]);
        if !changes.contains(&model.time) && !held.iter().any(|(_, symbol)| changes.contains(symbol)) {
            coefficients.push((unknown, coefficient));
        }
    }
    (!coefficients.is_empty()).then_some(Explicit { phi, held, coefficients })
}

/// What stands for the poses of the bodies that an expression holds.
fn poses(model: &Model, coordinates: &Coordinates, phi: Expr, symbols: &[Expr]) -> Vec<(Expr, Expr)> {
    let held = algebra::symbols(&[phi]);
    let mut pairs = Vec::new();
    for (body, declared) in model.bodies.iter().enumerate() {
        if !declared.q.iter().any(|symbol| held.contains(symbol)) {
            continue;
        }
        let heading = coordinates.headings[body];
        let angle = coordinates.angle_of_class[heading.class].map_or(Expr::ZERO, |unknown| symbols[unknown]);
        let own = Rotation::by(angle) * Rotation::by(heading.offset).axis();
        let theta = declared.q[2];
        pairs.extend([(theta.cos(), own.x), (theta.sin(), own.y)]);
        pairs.push((theta, angle + heading.offset));
        let place = place(coordinates, body, symbols);
        pairs.extend([(declared.q[0], place.x), (declared.q[1], place.y)]);
    }
    pairs
}

/// G of a body as a function of the unknowns.
fn place(coordinates: &Coordinates, body: usize, symbols: &[Expr]) -> Vec2 {
    let terms = coordinates.centres[body].terms().map(|(class, slide, vector)| {
        let vector = slide.map_or(Expr::ONE, |slide| symbols[slide]) * vector;
        coordinates.angle_of_class[class].map_or(vector, |angle| Rotation::by(symbols[angle]) * vector)
    });
    terms.sum()
}

/// Solves a row for one unknown and writes its value, coefficients and rate.
pub(crate) fn solve(motion: &mut Motion, row: &Explicit, unknown: usize) {
    let coordinates = motion.coordinates;
    let Some(own) = row.coefficients.iter().find(|(of, _)| *of == unknown).map(|found| found.1) else {
        return;
    };
    let others: Vec<(usize, Expr)> = row.held.iter().copied().filter(|(of, _)| *of != unknown).collect();
    let symbol = row.held.iter().find(|(of, _)| *of == unknown).map_or(motion.time, |found| found.1);
    let rest = algebra::substitute(&[row.phi], &[(symbol, Expr::ZERO)])[0];
    let slopes: Vec<Expr> = others.iter().map(|&(_, symbol)| rest.diff(symbol)).collect();
    // Along the motion, but for the second derivatives of the other unknowns.
    let rates = others.iter().map(|&(of, _)| Expr::symbol(format!("u_rate_{of}")));
    let rates: Vec<Expr> = rates.collect();
    let mut flow: Vec<(Expr, Expr)> =
        others.iter().zip(&rates).map(|(&(_, symbol), &rate)| (symbol, rate)).collect();
    flow.push((motion.time, Expr::ONE));
    let rate = rest.directional(&flow);
    let curvature = rate.directional(&flow);
    let by_time = rest.diff(motion.time);

    let mut pairs = known(motion, &others);
    pairs.extend(others.iter().zip(&rates).map(|(&(of, _), &rate)| (rate, motion.sliding(of))));
    let mut roots = vec![rest, by_time, curvature];
    roots.extend(&slopes);
    let roots = algebra::substitute(&roots, &pairs);
    let (&[rest, by_time, curvature], slopes) = roots.split_at(3) else { return };
    // `c u + rest = 0`, and its derivatives.
    let solved = |start: Expr, of: &dyn Fn(usize) -> Expr| {
        let carried = others.iter().zip(slopes).map(|(&(other, _), &slope)| slope * of(other));
        let sum: Expr = [start].into_iter().chain(carried).sum();
        -sum / own
    };
    let value = -rest / own;
    let drift = solved(by_time, &|other| motion.drift[other]);
    let bias = solved(curvature, &|other| motion.bias[other]);
    for driver in 0..motion.drivers.len() {
        let gain = solved(Expr::ZERO, &|other| motion.gain[other][driver]);
        motion.gain[unknown][driver] = gain;
    }
    let value = motion.set_slide(unknown, value);
    (motion.drift[unknown], motion.bias[unknown]) = (drift, bias);
    if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
        motion.rotation[class] = Rotation::by(value);
    }
    motion.set_rate(unknown);
}

/// What stands for the symbols of unknowns that are known.
fn known(motion: &Motion, others: &[(usize, Expr)]) -> Vec<(Expr, Expr)> {
    let coordinates = motion.coordinates;
    let mut pairs = Vec::new();
    for &(unknown, symbol) in others {
        if let Unknown::Angle { class, .. } = coordinates.unknowns[unknown] {
            let axis = motion.turned(class, Vec2::X);
            pairs.extend([(symbol.cos(), axis.x), (symbol.sin(), axis.y)]);
        }
        pairs.push((symbol, motion.value[unknown]));
    }
    pairs
}
