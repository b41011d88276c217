//! Facts of a mechanism that `modelDescription.xml` tells, whoever computes its numbers: compiled code, or C source.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use plm_runtime::described::{Quantity, Tables};
use plm_runtime::{Events, Rate, StartValues, Vector};

use super::method::Settings;
use super::names::names;
use super::{Exchanged, Variable, token};
use crate::Kind;

/// Facts of a mechanism as an FMU. Lists have the order of the variables of their kinds.
#[derive(Clone, Debug)]
pub struct Facts<'a> {
    /// Names, units, documentation and dependencies.
    pub tables: &'a Tables,
    /// Token that identifies the FMU.
    pub token: String,
    /// How it is made, which decides about its abilities.
    pub code: Code<'a>,
    /// The interfaces that it has.
    pub interfaces: Interfaces,
    /// All variables, in the order of their value references.
    pub variables: Vec<Variable>,
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// Values that inputs begin with, SI.
    pub inputs: Vec<f64>,
    /// Start values: names and values, SI.
    pub starts: Vec<(&'a str, f64)>,
    /// Observed quantities: names and SI units.
    pub observed: Vec<(&'a str, &'a str)>,
    /// Number of coordinates, which come first among the states, before their velocities.
    pub coordinates: usize,
    /// States: names, in all charts, and typical sizes, SI.
    pub states: Vec<(&'a str, f64)>,
    /// Names of conditions that have event indicators.
    pub guards: Vec<&'a str>,
    /// Names of rows of contact.
    pub contacts: Vec<&'a str>,
    /// The time of the start, s.
    pub time: f64,
    /// The usual tolerance of co-simulation, where it has one.
    pub tolerance: Option<f64>,
    /// The usual length of steps of co-simulation, s.
    pub step: f64,
}

/// A parameter, as it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its value, SI.
    pub value: f64,
    /// It cannot be set.
    pub is_constant: bool,
}

/// How an FMU is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code<'a> {
    /// A library of compiled code.
    Compiled,
    /// C source, in these files.
    Source(&'a [&'a str]),
}

/// The interfaces of an FMU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interfaces {
    /// Model exchange and co-simulation.
    #[default]
    Both,
    /// Model exchange.
    ModelExchange,
    /// Co-simulation.
    CoSimulation,
}

impl Interfaces {
    /// Is model exchange among them?
    pub fn exchange(self) -> bool {
        self != Self::CoSimulation
    }

    /// Is co-simulation among them?
    pub fn co_simulation(self) -> bool {
        self != Self::ModelExchange
    }
}

impl<'a> Facts<'a> {
    /// Those of a compiled mechanism.
    pub fn of<M: Exchanged>(declared: &'a M) -> Self {
        let tables = declared.tables();
        let named = |kind: Kind| {
            let mut all = Vec::new();
            kind.names(declared, &mut |name| all.push(name));
            all
        };
        let (mut copy, mut starts) = (*declared, Vec::new());
        copy.starts_mut().each(&mut |name, own| starts.push((name, own.value)));
        let typical = declared.typical();
        let Settings { tolerance, step, .. } = Settings::usual::<M>();
        Self {
            tables,
            token: token::<M>().as_str().to_string(),
            code: Code::Compiled,
            interfaces: Interfaces::Both,
            variables: Variable::all(declared).collect(),
            parameters: (0..tables.parameters.len())
                .map(|k| Parameter { value: declared.parameter(k).unwrap_or_default(), is_constant: false })
                .collect(),
            inputs: tables.inputs.iter().map(|row| row.default.unwrap_or_default()).collect(),
            starts,
            observed: declared.observables().to_vec(),
            coordinates: <M as Rate>::NQ,
            states: (0..M::X::LEN).map(|k| (declared.name_of_state(k), typical.at(k))).collect(),
            guards: (0..<M as Events>::G::LEN).map(|k| declared.guard_name(k)).collect(),
            contacts: named(Kind::Contact),
            time: 0.0,
            tolerance: Some(tolerance),
            step,
        }
    }

    /// The names of all variables, in the order of their value references.
    pub fn names(&self) -> Vec<String> {
        names(self)
    }

    /// The declared output of an observed quantity, if it is one.
    pub(super) fn output(&self, index: usize) -> Option<&'a Quantity> {
        let (name, _) = self.observed.get(index)?;
        self.tables.outputs.iter().find(|row| row.name == *name)
    }

    /// The number of event indicators.
    pub(super) fn indicators(&self) -> usize {
        self.variables.iter().filter(|variable| matches!(variable, Variable::Indicator(_))).count()
    }
}
