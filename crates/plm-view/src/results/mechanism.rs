//! A mechanism as a results file describes it: SI throughout, lengths in m, angles in rad.

use std::collections::BTreeMap;

use plm_runtime::Operations;
use serde::{Deserialize, Serialize};

use super::number::or_nan;

/// A mechanism with its parameters.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Mechanism {
    /// Name of its type.
    pub name: String,
    /// Its documentation.
    pub doc: String,
    /// Choices of the compiler.
    pub report: Report,
    /// The bodies.
    pub bodies: Vec<Body>,
    /// Ports of the ground, at the time 0.
    pub ground: Vec<GroundPort>,
    /// The parts.
    pub parts: Vec<Part>,
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// The inputs.
    pub inputs: Vec<Quantity>,
    /// The first-order states.
    pub states: Vec<Quantity>,
}

impl Mechanism {
    /// Does a port of the ground move with the time? Then a recording has their places.
    pub fn ground_moves(&self) -> bool {
        self.ground.iter().any(|port| port.moves)
    }
}

/// The formulation that was taken, why, and what it costs.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Report {
    /// Unknowns of the formulation: `joint coordinates`.
    pub formulation: String,
    /// Why it was taken.
    pub reason: String,
    /// Degrees of freedom, `3 N - M`.
    pub degrees_of_freedom: i64,
    /// Operations of one right-hand side.
    #[serde(with = "InFile")]
    pub operations: Operations,
}

/// How a file has them.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Operations")]
struct InFile {
    add: u32,
    mul: u32,
    div: u32,
    sqrt: u32,
    sin_cos: u32,
    other: u32,
}

/// A body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// kg
    #[serde(deserialize_with = "or_nan")]
    pub mass: f64,
    /// About G, kg m^2.
    #[serde(deserialize_with = "or_nan")]
    pub inertia: f64,
    /// Along z, m.
    #[serde(deserialize_with = "or_nan")]
    pub depth: f64,
    /// From G, in the axes of the body.
    pub ports: Vec<Port>,
    /// Its outline, if it has one: points from G, in the axes of the body, m.
    pub contour: Option<Vec<[f64; 2]>>,
    /// Holes of its outline, in the same axes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub holes: Vec<Vec<[f64; 2]>>,
}

/// A port of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// m
    #[serde(deserialize_with = "or_nan")]
    pub x: f64,
    /// m
    #[serde(deserialize_with = "or_nan")]
    pub y: f64,
    /// rad
    #[serde(deserialize_with = "or_nan")]
    pub angle: f64,
}

/// A port of the ground.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GroundPort {
    /// Its name.
    pub name: String,
    /// m
    #[serde(deserialize_with = "or_nan")]
    pub x: f64,
    /// m
    #[serde(deserialize_with = "or_nan")]
    pub y: f64,
    /// rad
    #[serde(deserialize_with = "or_nan")]
    pub angle: f64,
    /// Along z, m.
    #[serde(deserialize_with = "or_nan")]
    pub depth: f64,
    /// Does its place change with the time?
    #[serde(default)]
    pub moves: bool,
}

/// A part in use.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its full name, `arm.spring`.
    pub name: String,
    /// The keyword of the declaration: `revolute`, `jack`.
    pub kind: String,
    /// Its kinematic pair, if it is a joint that states one.
    pub pair: Option<String>,
    /// The frames that it joins.
    pub frames: Vec<Frame>,
    /// Sizes for pictures that are not 0, m: `pin`, `piston`, `rod`, `free_length`, or what a part of one's own names.
    pub sizes: BTreeMap<String, f64>,
    /// Shapes for pictures.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub shapes: Vec<Shape>,
}

/// A shape of a part.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// How it is drawn: `outline`, `mark`, `line`, `surface`, `circle`.
    pub look: String,
    /// The index of the body of its frame; none for the ground.
    pub body: Option<usize>,
    /// The index of the port of its frame.
    pub port: Option<usize>,
    /// The frame that its x axis points to, by body and port.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub towards: Option<(Option<usize>, Option<usize>)>,
    /// Do its points count in half widths of a bar, and along the line to another frame as shares of that? Else they are in m.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub symbol: bool,
    /// Points in the axes of its frame. The first of a symbol and of a circle is where its origin is, m; a circle has one more, on its rim.
    pub points: Vec<[f64; 2]>,
}

/// A frame that a part joins.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Frame {
    /// Name of the frame in the part: `a`.
    pub argument: String,
    /// The number of its body; none for the ground.
    pub body: Option<usize>,
    /// The number of its port; none for G, or for the origin of the ground.
    pub port: Option<usize>,
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "FlatParameter")]
pub struct Parameter {
    /// Name and unit.
    #[serde(flatten)]
    pub quantity: Quantity,
    /// Its default, SI; none if it must be said.
    pub default: Option<f64>,
    /// Its value in this run, SI.
    #[serde(deserialize_with = "or_nan")]
    pub value: f64,
}

/// A parameter as it stands in the file. serde would buffer flattened fields in another form until all of them are known, unknown keys too,
/// in many times the memory.
#[derive(Deserialize)]
struct FlatParameter {
    name: String,
    #[serde(default)]
    doc: String,
    unit: String,
    factor: f64,
    #[serde(default)]
    exponents: [i8; 7],
    default: Option<f64>,
    #[serde(deserialize_with = "or_nan")]
    value: f64,
}

impl From<FlatParameter> for Parameter {
    fn from(flat: FlatParameter) -> Self {
        let FlatParameter { name, doc, unit, factor, exponents, default, value } = flat;
        Self { quantity: Quantity { name, doc, unit, factor, exponents }, default, value }
    }
}

/// A name with its unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// Its name in the declaration.
    pub name: String,
    /// Its documentation.
    #[serde(default)]
    pub doc: String,
    /// The unit that it was declared in; empty for a pure number.
    pub unit: String,
    /// A value in SI is one in this unit times the factor.
    pub factor: f64,
    /// Exponents of m, kg, s, K, A, mol, rad.
    #[serde(default)]
    pub exponents: [i8; 7],
}
