//! Names, units and numbers of a mechanism for tables and pictures, as lists that live as long as the program.

use plm_compiler::lowered::{self, Lowered, Varying};
use plm_compiler::{Motion, Quantity, Reads};
use plm_runtime::described;

use crate::code::Code;
use crate::kept::{kept, text, texts};
use crate::places::Room;

/// Names with their units.
type Named = &'static [(&'static str, &'static str)];

/// The tables by which a mechanism describes itself.
#[derive(Debug)]
pub(crate) struct Description {
    pub(crate) tables: &'static described::Tables,
    /// Names and SI units of all outputs.
    pub(crate) observed: Named,
    /// Names of the declared outputs, and the units that they are shown in.
    pub(crate) outputs: Named,
    /// Names and SI units of the inputs.
    pub(crate) inputs: Named,
    /// Names and SI units of the first-order states.
    pub(crate) states: Named,
    pub(crate) declaration: &'static str,
    /// Files that the declaration names, and their paths.
    pub(crate) files: Named,
    pub(crate) shapes: &'static [described::Shape],
    pub(crate) holes: &'static [described::Hole],
    /// The numbers of the tables, SI; not numbers where they vary.
    pub(crate) constants: Vec<f64>,
    /// Place and function of those that vary, in the order of their places.
    pub(crate) varying: Vec<(usize, Code)>,
}

impl Description {
    /// That of a lowered mechanism whose text has this name.
    pub(crate) fn new(lowered: &'static Lowered, name: &str, room: Room) -> Description {
        let of = &lowered.description;
        let path = |file: &String| std::path::Path::new(name).with_file_name(file).display().to_string();
        let declared = lowered.outputs.iter().filter(|output| output.declared);
        let varying = |Varying { index, value }: &'static Varying| (*index, Code::new(value, &[], room));
        Description {
            tables: Box::leak(Box::new(tables(of))),
            observed: named(lowered.outputs.iter().map(|output| (&output.name, &output.si))),
            outputs: named(declared.map(|output| (&output.name, &output.unit))),
            inputs: with_units(&lowered.inputs),
            states: with_units(&lowered.states),
            declaration: &of.declaration,
            files: kept(of.files.iter().map(|file| (file.as_str(), text(&path(file))))),
            shapes: kept(of.shapes.iter().map(shape)),
            holes: kept(of.holes.iter().map(hole)),
            constants: of.constants.clone(),
            varying: of.varying.iter().map(varying).collect(),
        }
    }
}

fn named(all: impl Iterator<Item = (&'static String, &'static String)>) -> Named {
    kept(all.map(|(name, unit)| (name.as_str(), unit.as_str())))
}

/// Names and SI units; a pure number has the text `no unit`, as in compiled code.
fn with_units(all: &'static [lowered::Named]) -> Named {
    let unit = |unit: &'static str| if unit.is_empty() { "no unit" } else { unit };
    kept(all.iter().map(|of| (of.name.as_str(), unit(of.unit.as_str()))))
}

fn tables(of: &'static lowered::Description) -> described::Tables {
    let list = |quantities: &'static [Quantity]| kept(quantities.iter().map(quantity));
    described::Tables {
        name: &of.name,
        docs: &of.docs,
        report: described::Report {
            rung: of.number,
            formulation: &of.formulation,
            reason: &of.reason,
            operations: of.operations,
            degrees_of_freedom: of.freedom,
        },
        bodies: kept(of.bodies.iter().map(body)),
        ground: kept(of.ground.iter().map(ground)),
        parts: kept(of.parts.iter().map(part)),
        parameters: list(&of.quantities.parameters),
        inputs: list(&of.quantities.inputs),
        states: list(&of.quantities.states),
        outputs: list(&of.quantities.outputs),
        reads: kept(of.reads.iter().map(|row| row.as_ref().map(reads))),
    }
}

fn quantity(of: &'static Quantity) -> described::Quantity {
    described::Quantity {
        name: &of.name,
        docs: &of.docs,
        unit: &of.unit,
        factor: of.factor,
        exponents: of.exponents,
        default: of.default,
    }
}

fn reads(of: &'static Reads) -> described::Reads {
    described::Reads {
        motion: match of.motion {
            Motion::Nothing => described::Motion::Nothing,
            Motion::Poses => described::Motion::Poses,
            Motion::Velocities => described::Motion::Velocities,
        },
        time: of.time,
        states: &of.states,
        inputs: &of.inputs,
    }
}

fn body(of: &'static lowered::Body) -> described::Body {
    let lowered::Body { name, ports, contour, first } = of;
    described::Body { name, ports: texts(ports), contour: *contour, first: *first }
}

fn ground(of: &'static lowered::GroundPort) -> described::GroundPort {
    described::GroundPort { name: &of.name, moves: of.moves, first: of.first }
}

fn part(of: &'static lowered::Part) -> described::Part {
    let frames = of.frames.iter().map(|frame| described::Frame {
        argument: &frame.argument,
        body: frame.body,
        port: frame.port,
    });
    described::Part {
        name: &of.name,
        kind: &of.kind,
        pair: of.pair,
        frames: kept(frames),
        sizes: texts(&of.sizes),
        first: of.first,
    }
}

fn shape(of: &lowered::Shape) -> described::Shape {
    let lowered::Shape { part, look, at, towards, is_symbol, points, first } = *of;
    described::Shape { part, look, at, towards, is_symbol, points, first }
}

fn hole(of: &lowered::Hole) -> described::Hole {
    let lowered::Hole { body, points, first } = *of;
    described::Hole { body, points, first }
}
