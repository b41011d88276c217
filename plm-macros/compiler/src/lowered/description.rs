//! Names, units and numbers of a mechanism as data, for tables and pictures.

use plm_math::Operations;

use super::Parts;
use super::routine::Routine;
use crate::collect::CollectVec;
use crate::emit::names;
use crate::facts::quantities::{Quantities, trimmed};
use crate::model::{FrameRef, Pair};
use crate::reads::{Reads, reads};
use crate::report::Report;
use crate::tables::{Entry, NumericTable};

/// The tables by which a mechanism describes itself. Numbers of items are entries of one list, at which these begin.
#[derive(Clone, Debug)]
pub struct Description {
    /// Name of the type that compiled code has.
    pub name: String,
    /// The declaration as it was written.
    pub declaration: String,
    /// Files that it names.
    pub files: Vec<String>,
    /// Its documentation, line by line.
    pub docs: String,
    /// Number of the formulation, from 1 (kinematics) to 5 (absolute coordinates).
    pub number: u8,
    /// Kind of the unknowns.
    pub formulation: String,
    /// Why it was taken.
    pub reason: String,
    /// Operations of one right-hand side.
    pub operations: Operations,
    /// Degrees of freedom, `3 N - M`.
    pub freedom: isize,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Ports of the ground.
    pub ground: Vec<GroundPort>,
    /// The parts.
    pub parts: Vec<Part>,
    /// Shapes of parts, in the order of the parts.
    pub shapes: Vec<Shape>,
    /// Holes of contours, in the order of the bodies.
    pub holes: Vec<Hole>,
    /// Parameters, inputs, first-order states, declared outputs.
    pub quantities: Quantities,
    /// Reads of each declared output, then of the rate of each first-order state.
    pub reads: Vec<Option<Reads>>,
    /// All numbers, SI; not numbers where they vary.
    pub constants: Vec<f64>,
    /// Those of parameters and the time.
    pub varying: Vec<Varying>,
}

/// A number of parameters and the time.
#[derive(Clone, Debug)]
pub struct Varying {
    /// Its place among all numbers.
    pub index: usize,
    /// Its value, which the routine returns.
    pub value: Routine,
}

/// A body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Names of its ports.
    pub ports: Vec<String>,
    /// Number of points of its contour.
    pub contour: usize,
    /// Begin of its numbers.
    pub first: usize,
}

/// A port of the ground.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GroundPort {
    /// Its name.
    pub name: String,
    /// Does its place change with the time?
    pub moves: bool,
    /// Begin of its numbers.
    pub first: usize,
}

/// A part in use.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its full name, `arm.spring`.
    pub name: String,
    /// The name of its definition.
    pub kind: String,
    /// Its kinematic pair, if it states one.
    pub pair: Option<&'static str>,
    /// The frames that it joins.
    pub frames: Vec<Frame>,
    /// Names of its sizes.
    pub sizes: Vec<String>,
    /// Begin of its sizes.
    pub first: usize,
}

/// A frame that a part joins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Its name in the part.
    pub argument: String,
    /// The number of its body; none for the ground.
    pub body: Option<usize>,
    /// The number of its port.
    pub port: usize,
}

/// A shape of a part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shape {
    /// The number of its part.
    pub part: usize,
    /// How it is drawn.
    pub look: &'static str,
    /// Body, none for the ground, and port of its frame.
    pub at: (Option<usize>, usize),
    /// The frame that its x axis points to.
    pub towards: Option<(Option<usize>, usize)>,
    /// Is it a symbol?
    pub is_symbol: bool,
    /// Number of its points.
    pub points: usize,
    /// Begin of its points.
    pub first: usize,
}

/// A hole of a contour.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Hole {
    /// The number of its body.
    pub body: usize,
    /// Number of its points.
    pub points: usize,
    /// Begin of its points.
    pub first: usize,
}

impl Description {
    pub(super) fn new(parts: &Parts, report: &Report) -> Description {
        let (model, table) = (parts.model, NumericTable::new(parts.model));
        let (constants, varying) = numbers(parts, &table);
        Description {
            name: names::type_name(&model.name.text),
            declaration: model.text.clone(),
            files: model.files.clone(),
            docs: trimmed(&model.docs),
            number: report.taken.number,
            formulation: report.taken.formulation.clone(),
            reason: report.taken.reason.clone(),
            operations: report.rate.operations,
            freedom: report.freedom,
            bodies: bodies(parts, &table),
            ground: ground(parts, &table),
            parts: instances(parts, &table),
            shapes: shapes(parts, &table),
            holes: holes(parts, &table),
            quantities: Quantities::of(model),
            reads: reads(model),
            constants,
            varying,
        }
    }
}

fn numbers(parts: &Parts, table: &NumericTable) -> (Vec<f64>, Vec<Varying>) {
    let (mut constants, mut varying) = (Vec::new(), Vec::new());
    for (index, entry) in table.all.iter().enumerate() {
        constants.push(match entry {
            Entry::Constant(value) => *value,
            Entry::Varying(expr) => {
                varying.push(Varying { index, value: parts.value(*expr) });
                f64::NAN
            }
        });
    }
    (constants, varying)
}

fn bodies(parts: &Parts, table: &NumericTable) -> Vec<Body> {
    let bodies = parts.model.bodies.iter().zip(&table.bodies).map(|(body, first)| Body {
        name: body.name.text.clone(),
        ports: body.ports.iter().map(|port| port.name.text.clone()).collect_vec(),
        contour: body.contour.len(),
        first: *first,
    });
    bodies.collect_vec()
}

fn ground(parts: &Parts, table: &NumericTable) -> Vec<GroundPort> {
    let ports = parts.model.ground.iter().zip(&table.ground).map(|(port, place)| GroundPort {
        name: port.name.text.clone(),
        moves: place.moves,
        first: place.first,
    });
    ports.collect_vec()
}

fn instances(parts: &Parts, table: &NumericTable) -> Vec<Part> {
    let parts = parts.model.instances.iter().zip(&table.parts).map(|(instance, first)| {
        let frames = instance.frames.iter().map(|(argument, frame)| Frame {
            argument: argument.clone(),
            body: frame.body,
            port: frame.port,
        });
        Part {
            name: instance.name.clone(),
            kind: instance.kind.clone(),
            pair: instance.pair.map(Pair::name),
            frames: frames.collect_vec(),
            sizes: instance.sizes.iter().map(|size| size.name.clone()).collect_vec(),
            first: *first,
        }
    });
    parts.collect_vec()
}

fn shapes(parts: &Parts, table: &NumericTable) -> Vec<Shape> {
    let parts = parts.model.instances.iter().enumerate();
    let shapes = parts.flat_map(|(part, instance)| instance.shapes.iter().map(move |shape| (part, shape)));
    let place = |of: &FrameRef| (of.body, of.port);
    let shapes = shapes.zip(&table.shapes).map(|((part, shape), first)| Shape {
        part,
        look: shape.look.name(),
        at: place(&shape.at),
        towards: shape.towards.as_ref().map(place),
        is_symbol: shape.is_symbol,
        points: shape.points.len(),
        first: *first,
    });
    shapes.collect_vec()
}

fn holes(parts: &Parts, table: &NumericTable) -> Vec<Hole> {
    let bodies = parts.model.bodies.iter().enumerate();
    let holes = bodies.flat_map(|(body, of)| of.holes.iter().map(move |hole| (body, hole.len())));
    let holes = holes.zip(&table.holes).map(|((body, points), first)| Hole { body, points, first: *first });
    holes.collect_vec()
}
