//! The resolved mechanism: what the front end hands to derivation.
//!
//! Every name is bound, every part is taken apart into constraint rows, loads, states and outputs, every quantity is
//! in SI, and every expression stands in one [`Graph`]. After `resolve` a
//! `Model` changes once: derivation puts switches in their places.
//!
//! Coordinates stand at the centre of gravity G of each body: `q = (x, y, theta)` per body, in the order of
//! declaration (manual, section 4.3.4: "the state variables of a body are calculated at the center of gravity").

mod contact;
mod event;
mod held;
mod instance;
mod joint;
mod limit;
mod pair;
mod shape;
mod step;

use crate::sorted::SortedSet;

use plm_cas::algebra::{self, Vec2};
use plm_cas::{Expr, Graph};

pub(crate) use contact::bounding_reactions;
pub use contact::{Contact, ContactLaw, ContactMode, Impacts, Reaction};
pub use event::{Target, When};
pub use held::{Comparison, Counted, Decisions, End, Jump, Steady, Switch};
pub use instance::{Instance, SetField};
pub use joint::{FrameRef, Pair, Part, Turn};
pub use limit::{Limit, Range};
pub use shape::{Look, Shape, Size};
pub use step::Step;

use crate::diag::Use;
use crate::span::Span;
use crate::units::{Dimension, DisplayUnit};

/// A mechanism with every name bound.
#[derive(Debug)]
pub struct Model {
    /// Name of the type, as written.
    pub name: Name,
    /// Visibility tokens as written, e.g. `pub` or `pub(crate)`; empty for private.
    pub visibility: String,
    /// Documentation lines of the mechanism, without `///`.
    pub docs: Vec<String>,
    /// The declaration as it was written.
    pub text: String,
    /// Path of the runtime crate in emitted code; `::plm` unless `crate = path` says otherwise.
    pub crate_path: String,
    /// All expressions.
    pub graph: Graph,
    /// The symbol of time, s.
    pub time: Expr,
    /// Symbol of the largest growth of a pivot's reciprocal that does not say that its row depends on others: the scalar's.
    pub most_growth: Expr,
    /// Symbol of the part, one in so many, by which lengths that repeat each other may differ: the scalar's.
    pub agreement: Expr,
    /// Symbol of a unit in the last place of 1: the scalar's.
    pub precision: Expr,
    /// Acceleration of gravity, absolute axes, m/s^2.
    pub gravity: Vec2,
    /// The formulation that the user ordered, and where.
    pub formulation: Option<(Formulation, Span)>,
    /// How the user ordered that repetitions are written.
    pub repetitions: Option<Repetitions>,
    /// How constraints are kept.
    pub stabilisation: Stabilisation,
    /// Steps that the user ordered, in the order of [`Step::NAMES`].
    pub steps: SortedSet<Step>,
    /// Fields that can change between runs.
    pub params: Vec<Param>,
    /// Fields that change while it runs.
    pub inputs: Vec<Input>,
    /// Bodies in the order of declaration; body `i` owns coordinates `3 i .. 3 i + 3`.
    pub bodies: Vec<Body>,
    /// Top-level parts (joints, forces, …) in the order of declaration; rows and loads point here.
    pub parts: Vec<Part>,
    /// Ports of the ground, in the order of declaration; `at` from the origin, absolute axes.
    pub ground: Vec<Port>,
    /// Constraint rows, `phi = 0`.
    pub rows: Vec<Row>,
    /// Rows of joints with a compliance: no constraints, their `lambda` is an expression, and it stands in the loads.
    pub compliant: Vec<Row>,
    /// Rows of contact: no constraints, their forces stand in the loads.
    pub contacts: Vec<Contact>,
    /// The law of impact.
    pub impacts: Impacts,
    /// Values beside masses and inertias that only some numbers make sense for.
    pub limits: Vec<Limit>,
    /// Generalised forces on bodies.
    pub loads: Vec<Load>,
    /// First-order states.
    pub states: Vec<State>,
    /// Events that set states.
    pub whens: Vec<When>,
    /// Conditions whose side is held over a step: of the state first, then of the time. Requirements are there from the
    /// beginning, derivation finds the others.
    pub switches: Vec<Switch>,
    /// Comparisons as they were written.
    pub comparisons: Vec<Comparison>,
    /// When conditions of the state and kinks matter; derivation finds it.
    pub decisions: Decisions,
    /// Expressions at whose zeros forces and rates bend: kinks, at which nothing is switched.
    pub kinks: Vec<Expr>,
    /// Angles whose whole turns are counted; derivation finds them.
    pub turns: Vec<Counted>,
    /// Rows that may jump where a condition changes its side; derivation finds them.
    pub jumps: Vec<Jump>,
    /// Symbols in rows for conditions whose sides are held, and these conditions. Where nothing is held, as in assembly
    /// and projection, the conditions themselves decide: on the boundary both sides agree.
    pub released: Vec<(Expr, Expr)>,
    /// Outputs: first those that are declared, then those that are observed.
    pub outputs: Vec<Output>,
    /// The parts of the declaration; of those inside of them, what joins frames or has sizes.
    pub instances: Vec<Instance>,
    /// Files that the declaration names.
    pub files: Vec<String>,
    /// Warning codes that the declaration allows, e.g. `W0002`.
    pub allowed: Vec<String>,
}

/// A place in a declaration or in the definition of a part.
#[derive(Clone, Debug)]
pub struct Declared {
    /// Span in its source.
    pub span: Span,
    /// Inside a part: the uses that lead there, from the declaration inwards.
    pub uses: Vec<Use>,
}

/// A name and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The text; parts inside `repeat` and parts carry their path, `bar[3]`, `arm.spring`.
    pub text: String,
    /// Span of its declaration.
    pub span: Span,
}

/// How constraints are kept over a run.
#[derive(Clone, Copy, Debug)]
pub enum Stabilisation {
    /// Projection onto position and velocity constraints between steps (the default).
    Projection,
    /// Baumgarte's method with `alpha = beta = 1 / tau`; `tau` in s, a constant or parameter expression.
    Baumgarte(Expr),
}

/// Formulations that a declaration can order. The numbers are those of the report, from 1 (kinematics) to 5.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formulation {
    /// Joint coordinates of a tree: formulation 2.
    Tree,
    /// Joint coordinates with loops in closed form, 3, or by Newton's iteration, 4; without loops formulation 2.
    Loops,
    /// Absolute coordinates and multipliers: formulation 5.
    Absolute,
}

impl Formulation {
    /// Names in the language.
    pub const NAMES: [(&'static str, Formulation); 3] =
        [("tree", Formulation::Tree), ("loops", Formulation::Loops), ("absolute", Formulation::Absolute)];

    /// Its name in the language.
    pub fn name(self) -> &'static str {
        Formulation::NAMES.iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// The formulation of that name.
    pub fn named(name: &str) -> Option<Formulation> {
        Formulation::NAMES.iter().find(|known| known.0 == name).map(|known| known.1)
    }
}

/// How the code has what repeats itself, link after link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Repetitions {
    /// Once, in a loop.
    Rolled,
    /// Each by itself.
    Unrolled,
}

impl Repetitions {
    /// Both as the language names them.
    pub const NAMES: [(&'static str, Repetitions); 2] =
        [("rolled", Repetitions::Rolled), ("unrolled", Repetitions::Unrolled)];

    /// The value of that name.
    pub fn named(name: &str) -> Option<Repetitions> {
        Repetitions::NAMES.iter().find(|known| known.0 == name).map(|known| known.1)
    }
}

/// A `param`: a field of the generated type.
#[derive(Clone, Debug)]
pub struct Param {
    /// Name of the field.
    pub name: Name,
    /// Its symbol.
    pub symbol: Expr,
    /// Its default, an expression without other symbols than earlier parameters; 1 in SI units where there is none, for what
    /// is tried before it is known.
    pub default: Expr,
    /// Has it no default, so that whoever makes the mechanism must say it?
    pub required: bool,
    /// Unit that it was declared in.
    pub unit: DisplayUnit,
    /// Documentation lines.
    pub docs: Vec<String>,
}

/// An `input`: a field of the generated `Input` type, held over a step.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name of the field.
    pub name: Name,
    /// Its symbol.
    pub symbol: Expr,
    /// Its value at the start.
    pub default: Expr,
    /// Unit that it was declared in.
    pub unit: DisplayUnit,
    /// Documentation lines.
    pub docs: Vec<String>,
}

/// A rigid body.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: Name,
    /// Mass, kg.
    pub mass: Expr,
    /// Span of the expression that gives the mass; of the body's name if no mass is declared.
    pub mass_span: Span,
    /// Moment of inertia about G, kg m^2.
    pub inertia: Expr,
    /// Span of the expression that gives the inertia; of the body's name if no mass is declared.
    pub inertia_span: Span,
    /// Are mass and inertia declared? Else both are numbers that no result may depend on.
    pub has_mass: bool,
    /// Symbols of (x, y, theta) of G: m, m, rad.
    pub q: [Expr; 3],
    /// Symbols of their rates: m/s, m/s, rad/s.
    pub v: [Expr; 3],
    /// Symbols of their accelerations: m/s^2, m/s^2, rad/s^2; only outputs may hold them.
    pub a: [Expr; 3],
    /// G in the body's axes, from its origin O, m; (0, 0) where drawing coordinates are used.
    pub centre: Vec2,
    /// Ports in the order of declaration.
    pub ports: Vec<Port>,
    /// Start of (x, y, angle) of the origin O; with drawing coordinates O is G. m, m, rad.
    pub start: [Start; 3],
    /// Start of (vx, vy, omega) of the origin O: m/s, m/s, rad/s.
    pub start_velocity: [Start; 3],
    /// Outline for pictures: points from G in the body's axes, m; empty if there is none.
    pub contour: Vec<Vec2>,
    /// Width of the outline round its ports, m; of a body without contour.
    pub width: Option<Expr>,
    /// Holes of the contour, in the same axes, m.
    pub holes: Vec<Vec<Vec2>>,
    /// Depth for pictures, m.
    pub depth: Option<Expr>,
}

/// A port of a body.
#[derive(Clone, Debug)]
pub struct Port {
    /// Its name.
    pub name: Name,
    /// Position from G in the body's axes, m.
    pub at: Vec2,
    /// Joint angle from the body's x axis, rad.
    pub angle: Expr,
    /// Is it used by any part?
    pub used: bool,
    /// Depth for pictures, m; of ports of the ground.
    pub depth: Option<Expr>,
}

/// A start value; `locked` in the declaration.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Value, SI; an expression of parameters at most.
    pub value: Expr,
    /// Is the assembly forbidden to move it?
    pub locked: bool,
    /// Was it written, or follows it from drawing coordinates? Else it is the default 0.
    pub given: bool,
    /// Span of the declared start; of the body's name if none is declared.
    pub span: Span,
}

/// One scalar constraint `phi = 0`.
#[derive(Clone, Debug)]
pub struct Row {
    /// Full name, e.g. `shoulder.x`.
    pub name: String,
    /// Index into [`Model::parts`].
    pub part: usize,
    /// The residual, m or rad (dimension of the row's expression).
    pub phi: Expr,
    /// Symbol of its multiplier; outputs may hold it (`M a + phi_q^T lambda = Q`).
    pub lambda: Expr,
    /// Span of the name of its joint in the declaration; of its own name if it stands there by itself.
    pub span: Span,
    /// Place of its equation; that of a joint's row is in the definition of the joint.
    pub declared: Declared,
    /// `m` or `rad`.
    pub unit: DisplayUnit,
}

impl Row {
    /// Is its residual an angle? Else it is a length.
    pub fn is_angular(&self) -> bool {
        self.unit.dimension.same(Dimension::NUMBER)
    }
}

/// A generalised force on one body, already carried to G.
#[derive(Clone, Debug)]
pub struct Load {
    /// Index of the body.
    pub body: usize,
    /// Index into [`Model::parts`].
    pub part: usize,
    /// Force along x and y (N) and torque about G (N m), absolute axes.
    pub force: [Expr; 3],
}

/// A first-order state, `rate(symbol) = rate`.
#[derive(Clone, Debug)]
pub struct State {
    /// Full name.
    pub name: Name,
    /// Its symbol.
    pub symbol: Expr,
    /// Its time derivative.
    pub rate: Expr,
    /// Its value at the start.
    pub start: Expr,
    /// Must a search for an equilibrium leave it alone?
    pub locked: bool,
    /// Unit that it was declared in.
    pub unit: DisplayUnit,
}

impl Model {
    /// Has each body a mass?
    pub fn has_masses(&self) -> bool {
        self.bodies.iter().all(|body| body.has_mass)
    }

    /// Number of switches that depend on the state, and of kinks: what is looked at in every step.
    pub fn watched(&self) -> usize {
        self.guards() + self.kinks.len()
    }

    /// Does an expression read a parameter without a default?
    pub fn reads_required(&self, expr: Expr) -> bool {
        let mut required = self.params.iter().filter(|param| param.required).peekable();
        required.peek().is_some() && {
            let read = algebra::symbols(&[expr]);
            required.any(|param| read.contains(&param.symbol))
        }
    }

    /// Number of switches that depend on the state.
    pub fn guards(&self) -> usize {
        self.switches.iter().filter(|switch| switch.instant.is_none()).count()
    }
}

/// A named output with one component, or two for a vector.
#[derive(Clone, Debug)]
pub struct Output {
    /// Path as written, e.g. `shoulder.force`; generated as `shoulder_force()`.
    pub name: Name,
    /// One expression, or (x, y); may hold accelerations and multipliers.
    pub components: Vec<Expr>,
    /// Unit in which tables and charts show it (the accessor gives SI).
    pub unit: DisplayUnit,
    /// Is it declared as an output, so that it stands in recordings? Else it is observed.
    pub declared: bool,
    /// Its documentation in a sentence, with the place where it points; empty where the name says all.
    pub docs: String,
}
