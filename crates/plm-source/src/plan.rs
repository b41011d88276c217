//! A mechanism with the numbers of its source, and parts that no source has.

use std::fmt;

use plm_compiler::Source;
use plm_compiler::lowered::{Chart, Form, Lowered, Output, OutputValue, ReadByConditions, Routine, Set};
use plm_dynamic::{Mechanism, Numbers, Steps};
use plm_foreign::Names;
use plm_runtime::described::Tables;

use crate::Precision;
use crate::block::OfPrecision;
use crate::c::C;
use crate::check;
use crate::names;
use crate::source::{CAUSES, parts};
use crate::template::fill;

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
    if let Some(contacts) = &lowered.contacts {
        let row = contacts.rows.first().map_or("", |row| &row.name);
        if contacts.read == ReadByConditions::Multipliers {
            refuse(row, "a condition that reads a force of contact");
        }
        if contacts.conditional.is_some() {
            refuse(row, "a constraint that holds on a condition");
        }
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
        if let Set::Velocity(k) = *set {
            refuse(
                lowered.coordinates.get(k).map_or("when", String::as_str),
                "an event that sets a velocity",
            );
        }
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
    /// The state after the first step over rows of contact, in the numbers of the source.
    pub(crate) over_contact: Option<Vec<f64>>,
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
    /// Rows of contact.
    pub(crate) contacts: usize,
    /// Places for rows of contact, and for reactions that bound frictions.
    pub(crate) places: usize,
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
            contacts: lowered.contacts.as_ref().map_or(0, |contacts| contacts.rows.len()),
            places: lowered.contacts.as_ref().map_or(0, |contacts| contacts.places),
        }
    }
}

impl<'a> Plan<'a> {
    pub(crate) fn new(mechanism: &'a Mechanism, steps: &Steps, precision: Precision) -> Plan<'a> {
        let (lowered, start) = (mechanism.lowered(), steps.numbers());
        let over_contact = lowered.contacts.as_ref().and_then(|_| match precision {
            Precision::Double => steps.moreau_jean_in::<f64>(check::STEP).ok(),
            Precision::Single => {
                let step = steps.moreau_jean_in::<f32>(check::STEP).ok();
                step.map(|numbers| numbers.into_iter().map(f64::from).collect())
            }
        });
        Plan {
            name: names::of_mechanism(&lowered.name),
            upper: Names::upper(&lowered.name).to_string(),
            lowered,
            tables: mechanism.tables(),
            counts: Counts::of(lowered, &start),
            start,
            precision,
            over_contact,
            is_fixed: fixed(lowered),
        }
    }

    /// A text with its name and sizes.
    pub(crate) fn filled(&self, text: &str) -> String {
        let sizes = [
            ("places", self.counts.places),
            ("states", self.length("x")),
            ("of_bodies", self.length("q")),
            ("nq", self.counts.coordinates),
        ];
        let sizes = sizes.map(|(word, size)| (word, size.to_string()));
        fill(text, &[sizes.as_slice(), &[("p", self.name.clone())]].concat())
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

    pub(crate) fn is_absolute(&self) -> bool {
        self.lowered.form == Form::Absolute
    }

    /// Are states projected onto joints?
    pub(crate) fn projects(&self) -> bool {
        self.is_absolute() && self.lowered.baumgarte.is_none()
    }

    pub(crate) fn is_loops(&self) -> bool {
        self.lowered.form == Form::Loops
    }

    /// Its declared outputs: number among all outputs, and the output.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = (usize, &'a Output)> {
        self.lowered.outputs.iter().enumerate().filter(|(_, output)| output.declared)
    }

    /// Has it a function of the rate? With rows of contact that of a step is another one, unless rates are not affine in the forces.
    pub(crate) fn has_rate(&self) -> bool {
        self.lowered.contacts.as_ref().is_none_or(|contacts| !contacts.is_affine)
    }

    /// Is the rate there for other methods? With rows of contact it needs the modes that a step decides.
    pub(crate) fn has_own_rate(&self) -> bool {
        self.lowered.contacts.is_none()
    }

    /// Do conditions read modes of contact?
    pub(crate) fn conditions_read_modes(&self) -> bool {
        let contacts = self.lowered.contacts.as_ref();
        contacts.is_some_and(|contacts| contacts.read != ReadByConditions::Nothing)
    }

    /// May a row of contact begin to exist by a condition?
    pub(crate) fn may_appear(&self) -> bool {
        let exist = self.lowered.contacts.as_ref().is_some_and(|contacts| contacts.exist.is_some());
        exist && !self.lowered.switches.all.is_empty()
    }

    /// Rows of contact that states move.
    pub(crate) fn moved_rows(&self) -> impl Iterator<Item = usize> {
        let rows = self.lowered.contacts.iter().flat_map(|contacts| contacts.rows.iter().enumerate());
        rows.filter(|(_, row)| row.moved_by_states).map(|(k, _)| k)
    }

    /// Are rows of contact checked after events have set states?
    pub(crate) fn settles(&self) -> bool {
        self.sets_states() && (self.may_appear() || self.moved_rows().next().is_some())
    }

    /// Do events set states?
    pub(crate) fn sets_states(&self) -> bool {
        !self.lowered.sets.events.is_empty()
    }

    /// Do functions read forces of contact?
    pub(crate) fn reads_forces(&self) -> bool {
        let reads =
            |routine: &Routine| routine.sources.iter().any(|source| matches!(source, Source::Multiplier(_)));
        let solutions = self.lowered.charts.iter().filter_map(|chart| chart.reactions.as_ref());
        let mut solutions = solutions.chain([&self.lowered.absolute.dynamics]);
        let contacts = self.lowered.contacts.as_ref();
        contacts.is_some_and(|contacts| !contacts.is_affine)
            || self.values().any(|of| reads(&of.value))
            || self.solves() && solutions.any(reads)
    }

    /// The number of the first row of contact among the parts that a failure may have.
    pub(crate) fn first_row(&self) -> usize {
        parts(self).len() + CAUSES.len() - self.counts.contacts
    }

    /// Does an output need accelerations or reactions?
    pub(crate) fn solves(&self) -> bool {
        self.values().any(|of| of.solves)
    }

    /// The values of its declared outputs.
    fn values(&self) -> impl Iterator<Item = &'a OutputValue> {
        let all = &self.lowered.values;
        self.outputs().filter_map(move |(_, output)| all.get(output.value))
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
