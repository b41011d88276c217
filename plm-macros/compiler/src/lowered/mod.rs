//! A mechanism as data: what emission writes as Rust, as tables and routines that a program can run without rustc.

mod augmented;
mod charts;
mod contact;
mod description;
mod equations;
mod registers;
mod routine;
mod sets;
mod start;
mod switches;

use plm_cas::Expr;

use crate::collect::CollectVec;
use crate::compile::Expansion;
use crate::derive::Equations;
use crate::facts;
use crate::formulate::{Function, Place, Program, Reduced, coordinate_name};
use crate::model::{Model, Stabilisation};
use crate::oracle::Oracle;
use crate::report::Report;
use crate::source::{Origin, Source, Symbols};
use crate::units::DisplayUnit;

pub use self::augmented::Augmented;
pub use self::charts::{Chart, Loops, Turns};
pub use self::contact::{
    BoundingReaction, Conditional, ContactChart, ContactKind, ContactRow, Contacts, Impacts, OfRows,
    ReadByConditions, RowTerm, Sliding,
};
pub use self::description::{Body, Description, Frame, GroundPort, Hole, Part, Shape, Varying};
pub use self::equations::{AbsoluteEquations, Output, OutputValue, Row};
pub use self::routine::{Operation, Register, Routine, Step, Target};
pub use self::sets::{Set, Sets};
pub use self::start::{Branch, Least, Limit, Parameter, Starts};
pub use self::switches::{End, Jump, Switch, Switches};
pub use crate::facts::quantities::{Quantities, Quantity};
pub use crate::formulate::Elimination;
pub use crate::reads::{Motion, Reads};

/// A mechanism as data.
#[derive(Clone, Debug)]
pub struct Lowered {
    /// Its name.
    pub name: String,
    /// The form of its state.
    pub form: Form,
    /// Names of the bodies.
    pub bodies: Vec<String>,
    /// Name of each coordinate, three for each body: `arm.x`, `arm.y`, `arm.angle`.
    pub coordinates: Vec<String>,
    /// Of each number of the state: its name, in charts of each coordinate that it is.
    pub names: Vec<String>,
    /// Of each number of the state: the part that it belongs to.
    pub parts: Vec<String>,
    /// Typical sizes of the numbers of the state.
    pub typical: Vec<f64>,
    /// First-order states, with their SI units.
    pub states: Vec<Named>,
    /// Size of the scene, m.
    pub length: f64,
    /// Parameters.
    pub parameters: Vec<Parameter>,
    /// Inputs, with their SI units.
    pub inputs: Vec<Named>,
    /// Start values, and what they are made of.
    pub starts: Starts,
    /// Constraint rows.
    pub rows: Vec<Row>,
    /// Absolute coordinates: constraints, and equations of motion with multipliers.
    pub absolute: AbsoluteEquations,
    /// Joint coordinates, chart by chart; none of absolute coordinates, one of a tree.
    pub charts: Vec<Chart>,
    /// Linearised equations, where implicit methods solve these in place of df/dx.
    pub augmented: Option<Augmented>,
    /// The memory of loops.
    pub loops: Option<Loops>,
    /// Angles whose turns are counted.
    pub turns: Vec<Turns>,
    /// Conditions.
    pub switches: Switches,
    /// Rows of contact.
    pub contacts: Option<Contacts>,
    /// Events that set states.
    pub sets: Sets,
    /// First-order states that only events change, by number.
    pub discrete: Vec<usize>,
    /// Declared outputs, then what is observed.
    pub outputs: Vec<Output>,
    /// The scalars and vectors that these are.
    pub values: Vec<OutputValue>,
    /// Numbers by which the rate of Baumgarte's stabilisation is found, where it is ordered: the time constant, s.
    pub baumgarte: Option<Routine>,
    /// Is its energy accounted for: no motion is prescribed, and each body has a mass?
    pub has_energy: bool,
    /// May its constraints come to depend on each other?
    pub may_be_singular: bool,
    /// Do forces read accelerations or reactions?
    pub feeds_back: bool,
    /// Names, units and numbers for tables and pictures.
    pub description: Description,
}

/// The form of the state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Absolute coordinates of all bodies.
    Absolute,
    /// Joint coordinates of a tree.
    Tree,
    /// Independent coordinates of loops, in charts.
    Loops,
}

/// A name with a unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// The name in the declaration.
    pub name: String,
    /// The SI unit.
    pub unit: String,
}

impl Expansion {
    /// The mechanism as data; nothing after errors.
    pub fn lower(&self) -> Option<Lowered> {
        let (oracle, report) = (self.oracle.as_ref()?, self.report.as_ref()?);
        let Oracle { graph, .. } = oracle;
        Some(graph.borrow_mut().enter(|| Lowered::new(oracle, report)))
    }
}

/// The passes' results that are read to lower a mechanism.
struct Parts<'a> {
    model: &'a Model,
    equations: &'a Equations,
    program: &'a Program,
    reduced: Option<&'a Reduced>,
    /// Places of what is remembered of loops, in the order of storage.
    paths: Vec<String>,
}

impl Parts<'_> {
    /// A function with the arguments of an origin.
    fn routine(&self, function: &Function, origin: Origin) -> Routine {
        self.routine_with(function, origin, &[])
    }

    /// A function with the arguments of an origin and others.
    fn routine_with(&self, function: &Function, origin: Origin, others: &[(Expr, Source)]) -> Routine {
        let &Parts { model, equations, program, reduced, .. } = self;
        let symbols = Symbols { model, equations, absolute: &program.absolute, reduced };
        let places = symbols.of(origin).into_iter().chain(others.iter().copied());
        Routine::new(function, &places.collect(), &self.paths)
    }

    /// May a body be without mass, if others carry it? Absolute coordinates divide by each mass.
    fn may_be_carried(&self) -> bool {
        let Parts { model, equations, program, reduced, .. } = self;
        let Some(reduced) = reduced else { return false };
        let of_tree = !reduced.has_loops() && reduced.first().is_some_and(|chart| chart.reactions.is_some());
        of_tree || !facts::reads_solution(model, equations, &program.absolute)
    }

    /// A value that parameters and the time give, as what the routine returns.
    fn value(&self, value: Expr) -> Routine {
        self.routine(&Function::of_results(vec![(Place::Value, value)]), Origin::Arguments)
    }

    /// Values that parameters and the time give, as an array.
    fn values(&self, values: &[Expr]) -> Routine {
        self.routine(&Function::of_array("values", values), Origin::Arguments)
    }
}

impl Lowered {
    fn new(oracle: &Oracle, report: &Report) -> Lowered {
        let Oracle { model, equations, program, .. } = oracle;
        let reduced = program.reduced();
        let memory = reduced.iter().flat_map(|reduced| &reduced.memory);
        let paths = memory.map(|(_, path)| path.clone()).collect_vec();
        let parts = Parts { model, equations, program, reduced, paths };
        let form = match reduced {
            None => Form::Absolute,
            Some(reduced) if reduced.has_loops() => Form::Loops,
            Some(_) => Form::Tree,
        };
        let named = |name: &str, unit: &DisplayUnit| Named { name: name.to_owned(), unit: si(unit) };
        let states = model.states.iter().map(|state| named(&state.name.text, &state.unit));
        let inputs = model.inputs.iter().map(|input| named(&input.name.text, &input.unit));
        let discrete = model.states.iter().enumerate().filter(|(_, state)| state.rate.is_zero());
        Lowered {
            name: model.name.text.clone(),
            form,
            bodies: model.bodies.iter().map(|body| body.name.text.clone()).collect_vec(),
            coordinates: (0..equations.q.len()).map(|k| coordinate_name(model, k)).collect_vec(),
            names: facts::state::names(model, equations, reduced),
            parts: facts::state::parts(model, equations, reduced),
            typical: facts::state::typical(model, equations, reduced, report.length),
            states: states.collect_vec(),
            length: report.length,
            parameters: start::parameters(&parts),
            inputs: inputs.collect_vec(),
            starts: Starts::new(&parts),
            rows: equations::rows(&parts),
            absolute: AbsoluteEquations::new(&parts),
            charts: charts::charts(&parts),
            augmented: Augmented::new(&parts),
            loops: reduced.filter(|_| form == Form::Loops).map(|reduced| Loops::new(model, reduced)),
            turns: charts::turns(&parts),
            switches: Switches::new(&parts),
            contacts: Contacts::new(&parts),
            sets: Sets::new(&parts),
            discrete: discrete.map(|(k, _)| k).collect_vec(),
            outputs: equations::outputs(&parts),
            values: equations::values(&parts),
            baumgarte: match model.stabilisation {
                Stabilisation::Projection => None,
                Stabilisation::Baumgarte(tau) => Some(parts.values(&[tau])),
            },
            has_energy: !facts::knows_time(model) && model.has_masses(),
            may_be_singular: facts::may_be_singular(model, equations, reduced),
            feeds_back: crate::derive::feeds_back(model),
            description: Description::new(&parts, report),
        }
    }
}

/// The SI unit of a quantity; empty where it has none.
fn si(unit: &DisplayUnit) -> String {
    DisplayUnit::si(unit.dimension).text
}

/// Names as text.
fn names<'a>(names: impl Iterator<Item = &'a String>) -> Vec<String> {
    names.cloned().collect_vec()
}

/// The places of parameters that some expressions read.
fn read_parameters(model: &Model, roots: &[Expr]) -> Vec<usize> {
    let read = plm_cas::algebra::symbols(roots);
    let all = model.params.iter().enumerate().filter(|(_, param)| read.contains(&param.symbol));
    all.map(|(k, _)| k).collect_vec()
}
