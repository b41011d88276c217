//! Description of a mechanism for a results file.

use plm_runtime::described::{self, Described, Place};
use plm_runtime::{Rate, Scalar};

use crate::results::{Body, Frame, GroundPort, Mechanism, Parameter, Part, Port, Quantity, Report, Shape};

/// Description of a mechanism, with the present values of its parameters, for a results file.
pub fn mechanism<M: Described>(of: &M) -> Mechanism {
    let tables = of.tables();
    Mechanism {
        name: tables.name.to_owned(),
        doc: tables.docs.to_owned(),
        report: report(&tables.report),
        bodies: (0..tables.bodies.len()).map(|k| body(of, k)).collect(),
        ground: (0..tables.ground.len()).map(|k| ground(of, k)).collect(),
        parts: (0..tables.parts.len()).map(|k| part(of, k)).collect(),
        parameters: tables.parameters.iter().enumerate().map(|(k, row)| parameter(of, k, row)).collect(),
        inputs: tables.inputs.iter().map(quantity).collect(),
        states: tables.states.iter().map(quantity).collect(),
    }
}

/// A number of the tables; NaN if there is none.
fn number<S: Scalar>(number: Option<S>) -> f64 {
    number.map_or(f64::NAN, Scalar::to_f64)
}

fn report(report: &described::Report) -> Report {
    Report {
        formulation: report.formulation.to_owned(),
        reason: report.reason.to_owned(),
        degrees_of_freedom: report.degrees_of_freedom as i64,
        operations: report.operations,
    }
}

fn body<M: Described>(of: &M, k: usize) -> Body {
    let row = &of.tables().bodies[k];
    let ports = row.ports.iter().enumerate().map(|(j, name)| {
        let [x, y, angle] = numbers(of.port(k, j));
        Port { name: (*name).to_owned(), x, y, angle }
    });
    let contour = Some(points(row.contour, |point| of.contour(k, point)));
    let holes = of.holes().iter().enumerate().filter(|(_, hole)| hole.body == k);
    Body {
        name: row.name.to_owned(),
        mass: number(of.mass(k)),
        inertia: number(of.inertia(k)),
        depth: number(of.depth(k)),
        ports: ports.collect(),
        contour: contour.filter(|points| !points.is_empty()),
        holes: holes.map(|(k, hole)| points(hole.points, |point| of.hole_point(k, point))).collect(),
    }
}

/// Points of a shape; none where parameters make one that cannot be drawn.
fn points<S: Scalar>(count: usize, at: impl Fn(usize) -> Option<[S; 2]>) -> Vec<[f64; 2]> {
    let points: Option<Vec<[f64; 2]>> =
        (0..count).map(|point| Some(at(point)?.map(Scalar::to_f64))).collect();
    points.filter(|points| points.iter().flatten().all(|x| x.is_finite())).unwrap_or_default()
}

/// Place and angle.
pub(crate) fn numbers<S: Scalar>(place: Option<Place<S>>) -> [f64; 3] {
    Place::components(place).map(Scalar::to_f64)
}

fn ground<M: Described>(of: &M, k: usize) -> GroundPort {
    let row = &of.tables().ground[k];
    let [x, y, angle] = numbers(of.ground(<M as Rate>::S::lit(0.0), k));
    GroundPort { name: row.name.to_owned(), x, y, angle, depth: number(of.ground_depth(k)), moves: row.moves }
}

fn part<M: Described>(of: &M, k: usize) -> Part {
    let row = &of.tables().parts[k];
    let frames = row.frames.iter().map(|frame| Frame {
        argument: frame.argument.to_owned(),
        body: frame.body,
        port: Some(frame.port),
    });
    let sizes = row.sizes.iter().enumerate().map(|(j, name)| (size_name(name), number(of.size(k, j))));
    Part {
        name: row.name.to_owned(),
        kind: row.kind.to_owned(),
        pair: row.pair.map(ToOwned::to_owned),
        frames: frames.collect(),
        sizes: sizes.filter(|(_, size)| size.is_finite() && *size != 0.0).collect(),
        shapes: (0..of.shapes().len()).filter(|j| of.shapes()[*j].part == k).map(|j| shape(of, j)).collect(),
    }
}

fn shape<M: Described>(of: &M, k: usize) -> Shape {
    let row = &of.shapes()[k];
    Shape {
        look: row.look.to_owned(),
        body: row.at.0,
        port: Some(row.at.1),
        towards: row.towards.map(|(body, port)| (body, Some(port))),
        symbol: row.is_symbol,
        points: points(row.points, |point| of.shape_point(k, point)),
    }
}

/// In the file a diameter is called by what has it: `pin`, `piston`, `rod`.
fn size_name(parameter: &str) -> String {
    parameter.strip_suffix("_diameter").unwrap_or(parameter).to_owned()
}

fn parameter<M: Described>(of: &M, k: usize, row: &described::Quantity) -> Parameter {
    Parameter { quantity: quantity(row), default: row.default, value: number(of.parameter(k)) }
}

fn quantity(row: &described::Quantity) -> Quantity {
    Quantity {
        name: row.name.to_owned(),
        doc: row.docs.to_owned(),
        unit: row.unit.to_owned(),
        factor: row.factor,
        exponents: row.exponents,
    }
}
