//! The numeric table of a mechanism: masses, places, contours, sizes.
//!
//! All numbers are entries of one list, in the order of the declaration. Most are constants; those that read parameters or
//! the time are expressions. The rows of names hold the index at which the numbers of each item begin.
//!
//! Constants cost rustc next to nothing: a chain of 64 bars has 3 % more text by its table.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::algebra::Vec2;
use plm_cas::{Expr, algebra};

use crate::model::{Body, Model, Port};
use crate::numeric::value;
use crate::units::DisplayUnit;

/// The numbers, and the index at which those of each item begin.
pub(crate) struct NumericTable {
    /// All numbers, SI.
    pub(crate) all: Vec<Entry>,
    /// Of each body: mass, inertia, depth; x, y, angle of each port; x, y of each point of the contour.
    pub(crate) bodies: Vec<usize>,
    /// Of each port of the ground: x, y, angle, depth.
    pub(crate) ground: Vec<Ground>,
    /// Of each part in use: its sizes.
    pub(crate) parts: Vec<usize>,
    /// Of each shape of each part: x, y of each point.
    pub(crate) shapes: Vec<usize>,
    /// Of each hole of each body: x, y of each point.
    pub(crate) holes: Vec<usize>,
}

/// A number of the table.
pub(crate) enum Entry {
    /// A number that is equal in all mechanisms of the type.
    Constant(f64),
    /// Of parameters; of ports of the ground also of the time.
    Varying(Expr),
}

/// A port of the ground.
pub(crate) struct Ground {
    /// Index of its first number in the table.
    pub(crate) first: usize,
    /// Does it move with the time?
    pub(crate) moves: bool,
}

impl NumericTable {
    pub(crate) fn new(model: &Model) -> NumericTable {
        let mut table = NumericTable {
            all: Vec::new(),
            bodies: Vec::new(),
            ground: Vec::new(),
            parts: Vec::new(),
            shapes: Vec::new(),
            holes: Vec::new(),
        };
        for body in &model.bodies {
            let first = table.push_masses(body);
            table.push([body.depth.unwrap_or(Expr::ZERO)]);
            body.ports.iter().for_each(|port| {
                table.push(place(port));
            });
            body.contour.iter().for_each(|point| {
                table.push(point.components());
            });
            table.bodies.push(first);
        }
        for port in &model.ground {
            let [x, y, angle] = at_its_side(model, place(port));
            let moves = algebra::symbols(&[x, y, angle]).contains(&model.time);
            let first = table.push([x, y, angle, port.depth.unwrap_or(Expr::ZERO)]);
            table.ground.push(Ground { first, moves });
        }
        for instance in &model.instances {
            let first = table.push(instance.sizes.iter().map(|size| size.value));
            table.parts.push(first);
        }
        for shape in model.instances.iter().flat_map(|instance| &instance.shapes) {
            let first = table.push_points(&shape.points);
            table.shapes.push(first);
        }
        for hole in model.bodies.iter().flat_map(|body| &body.holes) {
            let first = table.push_points(hole);
            table.holes.push(first);
        }
        table
    }

    /// Adds mass and inertia of a body, no number where it has none.
    fn push_masses(&mut self, body: &Body) -> usize {
        if body.has_mass {
            return self.push([body.mass, body.inertia]);
        }
        self.all.push_all([Entry::Constant(f64::NAN), Entry::Constant(f64::NAN)]);
        self.all.len() - 2
    }

    fn push_points(&mut self, points: &[Vec2]) -> usize {
        self.push(points.iter().flat_map(|at| at.components()))
    }

    /// Adds numbers and returns the index of the first.
    fn push(&mut self, exprs: impl IntoIterator<Item = Expr>) -> usize {
        let first = self.all.len();
        self.all.push_all(exprs.into_iter().map(|expr| {
            let is_constant = algebra::symbols(&[expr]).is_empty();
            if is_constant { Entry::Constant(value(expr, &[])) } else { Entry::Varying(expr) }
        }));
        first
    }
}

fn place(port: &Port) -> [Expr; 3] {
    [port.at.x, port.at.y, port.angle]
}

/// Conditions of the time have sides that are held over a step; a table that knows the time alone asks the conditions.
fn at_its_side(model: &Model, place: [Expr; 3]) -> [Expr; 3] {
    let side = |difference: Expr| difference.less(Expr::ZERO).select(Expr::from(-1), Expr::ONE);
    let sides: Vec<(Expr, Expr)> =
        model.switches.iter().map(|held| (held.symbol, side(held.difference))).collect_vec();
    place.map_each(|expr| algebra::substitute(&[expr], &sides)[0])
}

/// Parameters with the values that they are declared with, SI; without those that have no default, and those whose default
/// reads one of these.
pub(crate) fn declared_values(model: &Model) -> Vec<(Expr, f64)> {
    let mut known = Vec::new();
    for param in model.params.iter().filter(|param| !param.required) {
        let declared = value(param.default, &known);
        if !declared.is_nan() {
            known.push((param.symbol, declared));
        }
    }
    known
}

/// Exponents of a unit's base units, in the order m, kg, s, K, A, mol, rad.
pub(crate) fn exponents(unit: &DisplayUnit) -> [i8; 7] {
    let dimension = unit.dimension;
    [dimension.m, dimension.kg, dimension.s, dimension.k, dimension.a, 0, dimension.rad]
}
