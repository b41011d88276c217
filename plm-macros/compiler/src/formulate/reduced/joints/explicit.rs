//! Rows that give one unknown as a function of others: prescribed motions, gears, a mass on a rod.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Rotation, Vec2, algebra};

use crate::formulate::reduced::joints::coordinates::Coordinates;
use crate::model::Model;

/// `c u + rest(t, other unknowns) = 0` for one unknown u at least, with a constant c.
#[derive(Clone)]
pub(crate) struct Explicit {
    /// The row, with a symbol for each unknown.
    pub(crate) phi: Expr,
    /// The unknowns that it holds, ascending, and their symbols.
    pub(crate) held: Vec<(usize, Expr)>,
    /// The unknowns that it can be solved for, and their coefficients.
    coefficients: Vec<(usize, Expr)>,
}

impl Explicit {
    /// The coefficient of an unknown that it can be solved for.
    pub(crate) fn coefficient(&self, unknown: usize) -> Option<Expr> {
        self.coefficients.iter().find(|(of, _)| *of == unknown).map(|found| found.1)
    }
}

/// The row as an explicit one, if it is.
pub(crate) fn explicit(model: &Model, coordinates: &Coordinates, phi: Expr) -> Option<Explicit> {
    let symbols: Vec<Expr> =
        (0..coordinates.unknowns.len()).map(|k| Expr::symbol(format!("u_{k}"))).collect_vec();
    let pairs = poses(model, coordinates, phi, &symbols);
    let phi = algebra::substitute(&[phi], &pairs)[0];
    let left = algebra::symbols(&[phi]);
    let is_fixed = |symbol: &Expr| {
        *symbol == model.time
            || symbols.contains(symbol)
            || model.switches.iter().any(|switch| switch.symbol == *symbol)
            || model.params.iter().any(|param| param.symbol == *symbol)
    };
    if !left.iter().all(is_fixed) {
        return None;
    }
    let held = symbols.iter().enumerate().filter(|(_, symbol)| left.contains(symbol));
    let held: Vec<(usize, Expr)> = held.map(|(unknown, &symbol)| (unknown, symbol)).collect_vec();
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

/// Values for the poses of the bodies that an expression holds.
fn poses(model: &Model, coordinates: &Coordinates, phi: Expr, symbols: &[Expr]) -> Vec<(Expr, Expr)> {
    let held = algebra::symbols(&[phi]);
    let mut pairs = Vec::new();
    for (body, declared) in model.bodies.iter().enumerate() {
        if !declared.q.iter().any(|symbol| held.contains(symbol)) {
            continue;
        }
        let absolute_angle = coordinates.absolute_angles[body];
        let angle = coordinates.angle_of_orientation[absolute_angle.orientation]
            .map_or(Expr::ZERO, |unknown| symbols[unknown]);
        let own = Rotation::by(angle) * Rotation::by(absolute_angle.offset).axis();
        let theta = declared.q[2];
        pairs.push_all([(theta.cos(), own.x), (theta.sin(), own.y)]);
        pairs.push((theta, angle + absolute_angle.offset));
        let position = position(coordinates, body, symbols);
        pairs.push_all([(declared.q[0], position.x), (declared.q[1], position.y)]);
    }
    pairs
}

/// G of a body as a function of the unknowns.
fn position(coordinates: &Coordinates, body: usize, symbols: &[Expr]) -> Vec2 {
    let terms = coordinates.centres[body].terms().map(|(orientation, displacement, vector)| {
        let vector = displacement.map_or(Expr::ONE, |displacement| symbols[displacement]) * vector;
        coordinates.angle_of_orientation[orientation]
            .map_or(vector, |angle| Rotation::by(symbols[angle]) * vector)
    });
    terms.sum()
}
