//! A mechanism with the numbers of its source, and parts that no source has.

use std::fmt;

use plm_compiler::Source;
use plm_compiler::lowered::{Chart, Form, Lowered, Output, Routine, Set};
use plm_dynamic::{Mechanism, Numbers};
use plm_foreign::Names;
use plm_runtime::described::Tables;

use crate::Precision;
use crate::block::OfPrecision;
use crate::c::C;

/// A part of a mechanism that no source has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    /// The part, by its name in the declaration.
    pub part: String,
    /// The ability that is missing.
    pub what: &'static str,
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { part, what } = self;
        write!(f, "`{part}`: {what}")
    }
}

/// All that is refused of a mechanism.
pub(crate) fn refused(lowered: &Lowered) -> Vec<Refused> {
    let mut all = Vec::new();
    let mut refuse = |part: &str, what| all.push(Refused { part: part.to_owned(), what });
    for row in lowered.contacts.iter().flat_map(|contacts| &contacts.rows) {
        refuse(&row.name, "friction and contact that change their modes");
    }
    if lowered.form == Form::Absolute {
        let part = lowered.rows.first().map(|row| &row.part).or(lowered.bodies.first());
        refuse(part.map_or("", String::as_str), "absolute coordinates, which are projected onto the joints");
    }
    let switches = &lowered.switches;
    if switches.read_solution
        && let Some(switch) = switches.all.first()
    {
        refuse(&switch.name, "a condition that reads an acceleration or a reaction");
    }
    for jump in &switches.jumps {
        if let Some(row) = lowered.rows.get(jump.row) {
            refuse(&row.name, "a prescribed motion that may jump");
        }
    }
    for set in lowered.sets.events.iter().flatten() {
        let part = match *set {
            Set::State(k) => lowered.states.get(k).map(|state| &state.name),
            Set::Velocity(k) => lowered.coordinates.get(k),
        };
        refuse(part.map_or("when", String::as_str), "an event that sets values");
    }
    all
}

/// The refusal of a start that is in no chart.
pub(crate) fn without_chart(lowered: &Lowered, start: &Numbers) -> Option<Refused> {
    let chart = lowered.charts.first().filter(|_| lowered.form == Form::Loops && start.chart.is_none())?;
    let part = chart.closing.first().cloned().unwrap_or_default();
    Some(Refused { part, what: "a start at a singular pose, where no coordinates are good" })
}

/// A mechanism with all that its source is made of.
pub(crate) struct Plan<'a> {
    /// Its name in C: `double_pendulum`.
    pub(crate) name: String,
    /// Its name in capitals.
    pub(crate) upper: String,
    pub(crate) lowered: &'a Lowered,
    pub(crate) tables: &'a Tables,
    /// The numbers of the start.
    pub(crate) start: Numbers,
    pub(crate) precision: Precision,
    pub(crate) counts: Counts,
    /// Of each parameter: does the assembled start depend on it, so that it is a constant?
    pub(crate) is_fixed: Vec<bool>,
}

/// How many numbers of each kind there are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counts {
    /// Coordinates, velocities and first-order states.
    pub(crate) states: usize,
    /// Coordinates.
    pub(crate) coordinates: usize,
    /// Coordinates of all bodies.
    pub(crate) of_bodies: usize,
    pub(crate) charts: usize,
    pub(crate) angles: usize,
    pub(crate) determinants: usize,
    pub(crate) iterated: usize,
    /// Numbers of continuation data.
    pub(crate) memory: usize,
    pub(crate) turns: usize,
    pub(crate) guards: usize,
    /// Guards and kinks.
    pub(crate) watched: usize,
    /// Conditions on the time.
    pub(crate) times: usize,
    pub(crate) rows: usize,
}

impl Counts {
    fn of(lowered: &Lowered, start: &Numbers) -> Counts {
        let loops = lowered.loops.as_ref();
        let coordinates = lowered.charts.first().map_or(lowered.coordinates.len(), |chart| chart.names.len());
        Counts {
            states: start.x.len(),
            coordinates,
            of_bodies: lowered.coordinates.len(),
            charts: if lowered.form == Form::Loops { lowered.charts.len() } else { 1 },
            angles: loops.map_or(0, |loops| loops.turning.len()),
            determinants: loops.map_or(0, |loops| loops.determinants),
            iterated: loops.map_or(0, |loops| loops.iterated.len()),
            memory: start.memory.len(),
            turns: lowered.turns.len(),
            guards: lowered.switches.guards,
            watched: lowered.switches.guards + lowered.switches.kinks,
            times: lowered.switches.all.len() - lowered.switches.guards,
            rows: lowered.rows.len(),
        }
    }
}

impl<'a> Plan<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism, start: Numbers, precision: Precision) -> Plan<'a> {
        let lowered = mechanism.lowered();
        Plan {
            name: Names::lower(&lowered.name).to_string(),
            upper: Names::upper(&lowered.name).to_string(),
            lowered,
            tables: mechanism.tables(),
            counts: Counts::of(lowered, &start),
            start,
            precision,
            is_fixed: fixed(lowered),
        }
    }

    pub(crate) fn c(&self) -> C {
        C { single: self.precision == Precision::Single }
    }

    pub(crate) fn scalar(&self) -> OfPrecision {
        match self.precision {
            Precision::Double => OfPrecision::of::<f64>(),
            Precision::Single => OfPrecision::of::<f32>(),
        }
    }

    /// Its charts: of a tree the first one, in which it stays.
    pub(crate) fn charts(&self) -> &'a [Chart] {
        let all = &self.lowered.charts;
        if self.is_loops() { all } else { all.get(..1).unwrap_or_default() }
    }

    pub(crate) fn is_loops(&self) -> bool {
        self.lowered.form == Form::Loops
    }

    /// Its declared outputs: number among all outputs, and the output.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = (usize, &'a Output)> {
        self.lowered.outputs.iter().enumerate().filter(|(_, output)| output.declared)
    }

    /// Does an output need accelerations or reactions?
    pub(crate) fn solves(&self) -> bool {
        self.outputs().any(|(_, output)| output.solves)
    }
}

/// Parameters that the start depends on: lengths that joints close, start values, and what is derived of these.
fn fixed(lowered: &Lowered) -> Vec<bool> {
    let mut is_fixed = vec![false; lowered.parameters.len()];
    let mut fix = |routine: &Routine| {
        for source in &routine.sources {
            if let Source::Parameter(k) = source
                && let Some(fixed) = is_fixed.get_mut(*k)
            {
                *fixed = true;
            }
        }
    };
    [&lowered.starts.values, &lowered.starts.centres].into_iter().for_each(&mut fix);
    lowered.charts.iter().for_each(|chart| fix(&chart.from_pose));
    // Joint coordinates of a tree close nothing.
    if lowered.form != Form::Tree {
        let absolute = &lowered.absolute;
        [&absolute.phi, &absolute.phi_dot, &lowered.starts.ends].into_iter().for_each(&mut fix);
    }
    is_fixed
}
