//! The tables and functions of a mechanism, which live as long as the program: a run is a handle to them with its numbers.

use std::sync::{Arc, OnceLock};

use plm_compiler::lowered::{self, Form, Lowered};
use plm_runtime::absolute::Layout;
use plm_runtime::charts::{Charts, Revolutions};
use plm_runtime::limits::{Least, Limit};
use plm_runtime::{LabelTable, PartNames};

use crate::augmented::Augmented;
use crate::code::Code;
use crate::contact::Contacts;
use crate::description::Description;
use crate::kept::{kept, texts};
use crate::memory::Counts;
use crate::native::Translator;
use crate::places::Room;

/// A mechanism without its numbers.
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) lowered: &'static Lowered,
    pub(crate) translator: OnceLock<Arc<dyn Translator>>,
    pub(crate) layout: Layout,
    pub(crate) charts: Charts,
    pub(crate) counts: Counts,
    /// Number of coordinates of the state.
    pub(crate) coordinates: usize,
    /// Typical sizes of the numbers of the state, by place.
    pub(crate) typical: Vec<f64>,
    pub(crate) absolute: Absolute,
    pub(crate) in_charts: Vec<InChart>,
    pub(crate) augmented: Option<Augmented>,
    pub(crate) switches: Switches,
    pub(crate) contacts: Option<Contacts>,
    pub(crate) sets: Sets,
    pub(crate) start: Start,
    /// The scalars and vectors of the outputs.
    pub(crate) values: Vec<Code>,
    pub(crate) description: Description,
    pub(crate) names_of_starts: &'static [&'static str],
    pub(crate) labels: LabelTable,
    /// Names and SI units of the parameters.
    pub(crate) parameters: &'static [(&'static str, &'static str)],
    /// By count, places of its angles in the pose of all bodies.
    pub(crate) turns_in_pose: &'static [&'static [usize]],
    /// By count, places of its angles in the state; empty for loops.
    pub(crate) turns_in_state: &'static [&'static [usize]],
}

/// Functions in absolute coordinates.
#[derive(Debug)]
pub(crate) struct Absolute {
    pub(crate) dynamics: Code,
    pub(crate) free: Code,
    pub(crate) x_dot: Code,
    pub(crate) at_rest: Code,
    pub(crate) guards: Code,
    pub(crate) phi: Code,
    pub(crate) phi_dot: Code,
    pub(crate) phi_q: Code,
    pub(crate) min_norm: Code,
    pub(crate) inverse_mass: Code,
    pub(crate) kinetic_energy: Code,
    pub(crate) gravity_energy: Code,
    pub(crate) load_power: Code,
}

/// Functions in a chart.
#[derive(Debug)]
pub(crate) struct InChart {
    pub(crate) rate: Code,
    pub(crate) pose: Code,
    pub(crate) from_pose: Code,
    pub(crate) guards: Code,
    pub(crate) reactions: Option<Code>,
    pub(crate) remember: Option<Code>,
    pub(crate) remember_pose: Option<Code>,
    pub(crate) jacobian: Option<Code>,
}

/// Conditions.
#[derive(Debug)]
pub(crate) struct Switches {
    pub(crate) instants: Code,
    pub(crate) terms: Code,
    pub(crate) table: plm_runtime::Switches,
}

/// Functions of events that set states.
#[derive(Debug)]
pub(crate) struct Sets {
    pub(crate) holds: Code,
    pub(crate) values: Code,
    pub(crate) values_at_start: Code,
}

/// Parameters and starts.
#[derive(Debug)]
pub(crate) struct Start {
    pub(crate) defaults: Vec<Option<Code>>,
    pub(crate) values: Code,
    pub(crate) centres: Code,
    pub(crate) inputs: Code,
    pub(crate) limited: Code,
    pub(crate) limits: Vec<Limit>,
    pub(crate) carried: Option<Vec<[Limit; 2]>>,
    pub(crate) ends: Code,
    pub(crate) baumgarte: Option<Code>,
}

fn lists(all: impl IntoIterator<Item = Vec<usize>>) -> &'static [&'static [usize]] {
    kept(all.into_iter().map(kept))
}

impl Model {
    /// The tables of a lowered mechanism whose text has this name, and whose state has room for so many coordinates and velocities. They
    /// are never freed.
    pub(crate) fn new(lowered: Lowered, name: &str, capacity: usize) -> &'static Model {
        let lowered: &'static Lowered = Box::leak(Box::new(lowered));
        let nq = lowered.coordinates.len();
        let coordinates = lowered.charts.first().map_or(nq, |chart| chart.names.len());
        let state = Room { coordinates, capacity };
        let absolute = Absolute::new(lowered, Room { coordinates: nq, capacity });
        let counts = lowered.loops.as_ref().map_or_else(Counts::default, Counts::of);
        let turns = |places: fn(&lowered::Turns) -> Vec<usize>| lists(lowered.turns.iter().map(places));
        let turns_in_state = match lowered.form {
            Form::Loops => Vec::new(),
            Form::Tree | Form::Absolute => {
                let places =
                    lowered.turns.iter().map(|turns| turns.in_state.first().cloned().unwrap_or_default());
                places.map(|places| places.into_iter().map(|k| state.place(k)).collect::<Vec<_>>()).collect()
            }
        };
        let layout = Layout {
            rows: texts(lowered.rows.iter().map(|row| &row.name)),
            parts: texts(lowered.rows.iter().map(|row| &row.part)),
            coordinates: texts(&lowered.coordinates),
            angular: kept(lowered.rows.iter().map(|row| row.is_angular)),
            given_angles: if lowered.starts.given_angles.contains(&true) {
                kept(lowered.starts.given_angles.iter().copied())
            } else {
                &[]
            },
        };
        let value = |of: &'static lowered::OutputValue| Code::new(&of.value, &["value"], state);
        let model = Model {
            contacts: Contacts::new(lowered, &layout, state),
            sets: Sets::new(&lowered.sets, state),
            layout,
            charts: charts(lowered),
            counts,
            coordinates,
            typical: typical(lowered, state),
            absolute,
            augmented: Augmented::new(lowered, state),
            in_charts: lowered.charts.iter().map(|chart| InChart::new(chart, state)).collect(),
            switches: Switches::new(lowered, state),
            start: Start::new(lowered, state),
            values: lowered.values.iter().map(value).collect(),
            description: Description::new(lowered, name, state),
            names_of_starts: texts(&lowered.starts.names),
            labels: labels(lowered),
            parameters: kept(
                lowered.parameters.iter().map(|param| (param.name.as_str(), param.unit.as_str())),
            ),
            turns_in_pose: turns(|turns| turns.in_pose.clone()),
            turns_in_state: lists(turns_in_state),
            lowered,
            translator: OnceLock::new(),
        };
        Box::leak(Box::new(model))
    }
}

impl Model {
    /// Number of coordinates, velocities and first-order states.
    pub(crate) fn states(&self) -> usize {
        2 * self.coordinates + self.lowered.states.len()
    }

    /// Typical size of the number of the state at a place.
    #[inline]
    pub(crate) fn typical_at(&self, place: usize) -> f64 {
        self.typical.get(place).or(self.typical.first()).copied().unwrap_or(1.0)
    }

    /// Has functions translated from now on, if they were not before.
    pub(crate) fn translate_by(&self, translator: Arc<dyn Translator>) {
        let _ = self.translator.set(translator);
    }
}

/// Typical sizes of the numbers of the state, by place. What no coordinate has is zero: a size that some has changes no norm, and no largest
/// one.
fn typical(lowered: &Lowered, room: Room) -> Vec<f64> {
    let (own, states) = (&lowered.typical, lowered.states.len());
    let size = |number: usize| own.get(number).copied().unwrap_or(1.0);
    let mut typical = vec![size(0); 2 * room.capacity + states];
    typical.iter_mut().skip(room.capacity).take(room.capacity).for_each(|to| *to = size(room.coordinates));
    for (k, size) in own.iter().enumerate() {
        if let Some(to) = typical.get_mut(room.place(k)) {
            *to = *size;
        }
    }
    typical
}

/// The charts of a mechanism without loops.
pub(crate) const WITHOUT_LOOPS: Charts = Charts {
    count: 1,
    revolutions: &[],
    is_loose: false,
    turning: &[],
    found: &[],
    iterated: &[],
    closing: &[],
};

fn charts(lowered: &'static Lowered) -> Charts {
    let Some(loops) = &lowered.loops else { return WITHOUT_LOOPS };
    let revolutions = lowered.turns.iter().map(|turns| Revolutions {
        coordinates: lists(turns.in_state.iter().cloned()),
        angles: kept(turns.remembered.iter().copied()),
        iterated: kept(turns.iterated.iter().copied()),
    });
    Charts {
        count: lowered.charts.len(),
        revolutions: kept(revolutions),
        is_loose: loops.is_loose,
        turning: texts(&loops.turning),
        found: lists(lowered.charts.iter().map(|chart| chart.found.clone())),
        iterated: texts(&loops.iterated),
        closing: kept(lowered.charts.iter().map(|chart| texts(&chart.closing))),
    }
}

impl Absolute {
    fn new(lowered: &'static Lowered, room: Room) -> Absolute {
        let of = &lowered.absolute;
        let state = lowered.charts.first().map_or(room.coordinates, |chart| chart.names.len());
        let moment = Room { coordinates: state, ..room };
        Absolute {
            dynamics: Code::new(&of.dynamics, &["dx", "lambda"], room),
            free: Code::new(&of.free, &["force", "gamma"], room),
            x_dot: Code::new(&of.x_dot, &["x_dot"], room),
            at_rest: Code::new(&of.at_rest, &["force", "x_dot", "gap", "limit"], room),
            guards: Code::new(&of.guards, &["g"], room),
            phi: Code::new(&of.phi, &["phi"], room),
            phi_dot: Code::new(&of.phi_dot, &["phi_dot"], room),
            phi_q: Code::new(&of.phi_q, &["phi_q"], room),
            min_norm: Code::new(&of.min_norm, &["dq"], room),
            inverse_mass: Code::new(&of.inverse_mass, &["inverse_mass"], room),
            kinetic_energy: Code::new(&of.kinetic_energy, &[], moment),
            gravity_energy: Code::new(&of.gravity_energy, &[], moment),
            load_power: Code::new(&of.load_power, &[], moment),
        }
    }
}

impl InChart {
    fn new(of: &'static lowered::Chart, room: Room) -> InChart {
        let code = |routine, outputs: &[&str]| Code::new(routine, outputs, room);
        InChart {
            rate: code(&of.rate, &["dx"]),
            pose: code(&of.pose, &["q", "v"]),
            from_pose: code(&of.from_pose, &["x"]),
            guards: code(&of.guards, &["g"]),
            reactions: of.reactions.as_ref().map(|reactions| code(reactions, &["a", "lambda"])),
            remember: of.remember.as_ref().map(|remember| code(remember, &[])),
            remember_pose: of.remember_pose.as_ref().map(|remember| code(remember, &[])),
            jacobian: of.jacobian.as_ref().map(|jacobian| code(jacobian, &[])),
        }
    }
}

impl Switches {
    fn new(lowered: &'static Lowered, room: Room) -> Switches {
        let of = &lowered.switches;
        Switches {
            instants: Code::new(&of.instants, &["at", "slope"], room),
            terms: Code::new(&of.terms, &["jump"], room),
            table: table(lowered),
        }
    }
}

/// Names of states, conditions and rows.
fn labels(lowered: &'static Lowered) -> LabelTable {
    let conditions = lowered.switches.all.iter().take(lowered.switches.guards);
    let of_contact = || lowered.contacts.iter().flat_map(|contacts| &contacts.guard_names);
    let rows = lowered.contacts.iter().flat_map(|contacts| &contacts.rows);
    LabelTable {
        parts: PartNames::Numbers(texts(&lowered.parts)),
        states: texts(&lowered.names),
        in_charts: texts(lowered.charts.iter().flat_map(|chart| chart.names.iter().chain(&chart.rates))),
        guards: texts(conditions.clone().map(|switch| &switch.name).chain(of_contact())),
        conditions: texts(conditions.map(|switch| &switch.text).chain(of_contact())),
        instants: texts(lowered.switches.all.iter().skip(lowered.switches.guards).map(|switch| &switch.name)),
        contacts: texts(rows.map(|row| &row.name)),
    }
}

/// The tables of conditions and of contact.
fn table(lowered: &'static Lowered) -> plm_runtime::Switches {
    let (of, contacts) = (&lowered.switches, lowered.contacts.as_ref());
    plm_runtime::Switches {
        guards: of.guards,
        kinks: of.kinks,
        times: of.all.len() - of.guards,
        selective: !of.roots.is_empty(),
        roots: &of.roots,
        nodes: &of.nodes,
        jumps: kept(of.jumps.iter().map(|jump| (jump.row, jump.switch))),
        rows: contacts.map_or(0, |contacts| contacts.rows.len()),
        contact_guards: contacts.map_or(0, |contacts| contacts.guard_names.len()),
        bends: contacts.is_some_and(|contacts| contacts.reactions.iter().any(|reaction| reaction.in_plane)),
    }
}

impl Sets {
    fn new(of: &'static lowered::Sets, room: Room) -> Sets {
        let [holds, values, values_at_start] =
            [(&of.holds, "holds"), (&of.values, "set"), (&of.values_at_start, "set")]
                .map(|(routine, name)| Code::new(routine, &[name], room));
        Sets { holds, values, values_at_start }
    }
}

impl Start {
    fn new(lowered: &'static Lowered, room: Room) -> Start {
        let of = &lowered.starts;
        let values = |routine| Code::new(routine, &["values"], room);
        Start {
            defaults: lowered.parameters.iter().map(|param| param.default.as_ref().map(values)).collect(),
            values: values(&of.values),
            centres: values(&of.centres),
            inputs: values(&of.inputs),
            limited: values(&of.limited),
            limits: of.limits.iter().map(limit).collect(),
            carried: of.carried.as_ref().map(|all| all.iter().map(|[a, b]| [limit(a), limit(b)]).collect()),
            ends: values(&of.ends),
            baumgarte: lowered.baumgarte.as_ref().map(values),
        }
    }
}

fn limit(of: &'static plm_compiler::Limit) -> Limit {
    let least = match of.least {
        plm_compiler::Least::Positive => Least::Positive,
        plm_compiler::Least::Carried => Least::Carried,
        plm_compiler::Least::Zero => Least::Zero,
        plm_compiler::Least::Negative => Least::Negative,
        plm_compiler::Least::Share => Least::Share,
        plm_compiler::Least::Required => Least::Required,
    };
    Limit { part: &of.part, what: &of.what, unit: &of.unit, least }
}
