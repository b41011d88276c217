//! Tables of a mechanism that no parameter changes: names, units, connections.

use plm_math::Operations;

/// The tables of a mechanism, in the order of the declaration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tables {
    /// Name of its type.
    pub name: &'static str,
    /// Its documentation, line by line.
    pub docs: &'static str,
    /// Choices of the compiler.
    pub report: Report,
    /// The bodies.
    pub bodies: &'static [Body],
    /// Ports of the ground.
    pub ground: &'static [GroundPort],
    /// The parts of the declaration; of those inside of them, what joins frames or has sizes.
    pub parts: &'static [Part],
    /// The parameters.
    pub parameters: &'static [Quantity],
    /// The inputs.
    pub inputs: &'static [Quantity],
    /// The first-order states.
    pub states: &'static [Quantity],
    /// The declared outputs, a vector as two; in these units [`Ports::outputs`](crate::Ports::outputs) gives them.
    pub outputs: &'static [Quantity],
    /// Variables that each of these outputs reads at a moment, then those of the rate of each first-order state; `None` if accelerations or
    /// reactions are read, which may depend on all.
    pub reads: &'static [Option<Reads>],
}

/// Variables that a quantity reads at a moment, beside parameters; all others have no influence on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reads {
    /// Motion of bodies that it reads.
    pub motion: Motion,
    /// Does it read the time, by itself or by a motion that is prescribed?
    pub time: bool,
    /// First-order states, by number.
    pub states: &'static [usize],
    /// Inputs, by number.
    pub inputs: &'static [usize],
}

/// Motion of bodies that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Motion {
    /// Nothing.
    Nothing,
    /// Poses, which all coordinates may give.
    Poses,
    /// Velocities, which all coordinates and their rates may give.
    Velocities,
}

/// The formulation that was taken, why, and what it costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Report {
    /// Its number, from 1 (kinematics) to 5 (absolute coordinates).
    pub rung: u8,
    /// Unknowns of the formulation: `joint coordinates`.
    pub formulation: &'static str,
    /// Why it was taken: `the joints make a tree, so that no constraint is left`.
    pub reason: &'static str,
    /// Operations of one evaluation of the right-hand side.
    pub operations: Operations,
    /// Degrees of freedom, `3 N - M`.
    pub degrees_of_freedom: isize,
}

/// A body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Body {
    /// Its name.
    pub name: &'static str,
    /// Names of its ports.
    pub ports: &'static [&'static str],
    /// How many points its contour has; 0 if there is none.
    pub contour: usize,
    /// Index of its first number: mass, inertia, depth, its ports, its contour.
    #[doc(hidden)]
    pub first: usize,
}

/// A port of the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GroundPort {
    /// Its name.
    pub name: &'static str,
    /// Does its place change with the time?
    pub moves: bool,
    /// Index of its first number: x, y, angle, depth.
    #[doc(hidden)]
    pub first: usize,
}

/// A part in use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Its full name, `arm.spring`.
    pub name: &'static str,
    /// The name of its definition: `revolute`, `jack`.
    pub kind: &'static str,
    /// Its kinematic pair, if it is a joint that states one: `revolute`, `prismatic`, `pin_slot`, `weld`.
    pub pair: Option<&'static str>,
    /// The frames that it joins.
    pub frames: &'static [Frame],
    /// Names of its parameters that pictures show: `pin_diameter`.
    pub sizes: &'static [&'static str],
    /// Index of its first size.
    #[doc(hidden)]
    pub first: usize,
}

/// A shape that pictures draw of a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shape {
    /// The number of its part.
    pub part: usize,
    /// How it is drawn: `outline`, `mark`, `line`, `surface`, `circle`.
    pub look: &'static str,
    /// The number of the body of its frame, none for the ground, and that of the port.
    pub at: (Option<usize>, usize),
    /// The frame that its x axis points to; without it the axis is that of its frame.
    pub towards: Option<(Option<usize>, usize)>,
    /// Do its points count in half widths of a bar, and along the line to another frame as shares of that? Else they are in m.
    pub is_symbol: bool,
    /// How many points it has. The first of a symbol and of a circle is where its origin is, m; a circle has one more, on its rim.
    pub points: usize,
    /// Index of the first point.
    #[doc(hidden)]
    pub first: usize,
}

/// A hole of the contour of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hole {
    /// The number of its body.
    pub body: usize,
    /// How many points it has.
    pub points: usize,
    /// Index of the first point.
    #[doc(hidden)]
    pub first: usize,
}

/// A frame that a part joins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Name of the frame in the part: `a`.
    pub argument: &'static str,
    /// The number of its body; none for the ground.
    pub body: Option<usize>,
    /// The number of the port of that body, or of the ground.
    pub port: usize,
}

/// A quantity with its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// Its name in the declaration.
    pub name: &'static str,
    /// Its documentation, line by line.
    pub docs: &'static str,
    /// The unit that it was declared in; empty for a pure number.
    pub unit: &'static str,
    /// A value in SI is one in this unit times the factor.
    pub factor: f64,
    /// Exponents of its base units: m, kg, s, K, A, mol, rad.
    pub exponents: [i8; 7],
    /// Its value as declared, SI: the default of a parameter, an input or a state at the start, with parameters at their
    /// defaults. None for outputs, for a parameter without default, and for what reads one.
    pub default: Option<f64>,
}
