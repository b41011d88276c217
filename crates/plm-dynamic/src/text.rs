//! From text to a mechanism that can run.

use std::fmt;
use std::path::Path;

use plm_compiler::lowered::Lowered;
use plm_compiler::token::Sources;
use plm_compiler::{analyse, without_panic};

use crate::capacity::{EVENTS, INPUTS, KINKS, ROWS, SWITCHES};
use crate::handle::Dynamic;
use crate::memory::Counts;
use crate::model::Model;

/// A declaration that was compiled: tables and functions.
#[derive(Clone, Debug)]
pub struct Compiled {
    name: String,
    lowered: Lowered,
}

/// Why a text gives no mechanism.
#[derive(Clone, Debug, PartialEq)]
pub enum Refused {
    /// It has mistakes: the diagnostics, as rustc would show them.
    Mistakes(String),
    /// The compiler has failed.
    Bug(String),
    /// It is larger than there is room for: what there is too much of, how much, and the most.
    TooLarge {
        /// Kind of the elements that are too many.
        what: &'static str,
        /// How much.
        found: usize,
        /// The most that there is room for.
        most: usize,
        /// The first for which there is none, by its name; empty where they have no names.
        first: String,
    },
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mistakes(text) | Self::Bug(text) => f.write_str(text),
            Self::TooLarge { what, found, most, first } => {
                write!(f, "{found} {what}, and a run of a text has room for {most}")?;
                if first.is_empty() { Ok(()) } else { write!(f, ": `{first}` is the first without") }
            }
        }
    }
}

impl std::error::Error for Refused {}

impl Compiled {
    /// Compiles a declaration, the inside of a call of `mechanism!`. `name` is what messages call it; files that it names are read
    /// beside that.
    ///
    /// # Errors
    /// The diagnostics of its mistakes, or what there is no room for.
    pub fn new(name: &str, text: &str) -> Result<Compiled, Refused> {
        let compiled = without_panic(|| {
            let mut sources = Sources::new();
            sources.add_text(name, text);
            for file in sources.named_files() {
                let content = std::fs::read_to_string(Path::new(name).with_file_name(&file));
                sources.add_file(&file, content.map_err(|error| error.to_string()));
            }
            let expansion = analyse(&mut sources);
            expansion.lower().ok_or_else(|| {
                let all = expansion.diagnostics.sorted();
                all.into_iter().map(|one| one.render(&sources)).collect::<String>()
            })
        });
        match compiled {
            Err(bug) => Err(Refused::Bug(bug)),
            Ok(Err(mistakes)) => Err(Refused::Mistakes(mistakes)),
            Ok(Ok(lowered)) => Compiled::with_room(name, lowered),
        }
    }

    /// Checks the capacities that all sizes have in common.
    fn with_room(name: &str, lowered: Lowered) -> Result<Compiled, Refused> {
        let contacts = lowered.contacts.as_ref();
        within(
            &lowered,
            [
                ("rows of contact", contacts.map_or(0, |contacts| contacts.places), ROWS),
                ("conditions", lowered.switches.all.len(), SWITCHES),
                ("guards of conditions and contact", guards(&lowered), SWITCHES),
                ("events that set states", lowered.sets.events.len(), EVENTS),
                ("inputs", lowered.inputs.len(), INPUTS),
                ("kinks", lowered.switches.kinks, KINKS),
            ],
        )?;
        Ok(Compiled { name: name.to_owned(), lowered })
    }

    /// Is there room for a run of a mechanism that was compiled?
    ///
    /// # Errors
    /// [`Refused::TooLarge`].
    pub fn has_room(name: &str, lowered: Lowered) -> Result<(), Refused> {
        Compiled::with_room(name, lowered)?.fits_largest()
    }

    /// The mechanism as declared, with room for `NQ` coordinates, `NC` rows, `N` numbers of a state and `P` parameters; parameters without a default
    /// are zero until they are set. Its tables are never freed.
    ///
    /// # Errors
    /// [`Refused::TooLarge`].
    pub fn mechanism<const NQ: usize, const NC: usize, const N: usize, const L: usize, const P: usize>(
        self,
    ) -> Result<Dynamic<f64, NQ, NC, N, L, SWITCHES, ROWS, P>, Refused> {
        self.fits::<NQ, NC, N, L, SWITCHES, ROWS, P>()?;
        Ok(Dynamic::declared(self.model(NQ), &[]))
    }

    /// Its tables, with room for so many coordinates.
    pub(crate) fn model(self, coordinates: usize) -> &'static Model {
        Model::new(self.lowered, &self.name, coordinates)
    }

    /// Is there room for it?
    pub(crate) fn fits<
        const NQ: usize,
        const NC: usize,
        const N: usize,
        const L: usize,
        const H: usize,
        const R: usize,
        const P: usize,
    >(
        &self,
    ) -> Result<(), Refused> {
        let loops = self.lowered.loops.as_ref();
        let remembered = loops.map_or(0, |loops| Counts::of(loops).largest());
        let states = N.saturating_sub(2 * NQ);
        let contacts = self.lowered.contacts.as_ref();
        let conditional = contacts.and_then(|contacts| contacts.conditional.as_ref());
        let conditional = conditional.map_or(0, |conditional| conditional.rows.len());
        within(
            &self.lowered,
            [
                ("coordinates", self.lowered.coordinates.len(), NQ),
                ("constraint rows", self.lowered.rows.len() + conditional, NC),
                ("first-order states", self.lowered.states.len(), states),
                ("numbers that loops remember of a kind", remembered, L),
                ("parameters", self.lowered.parameters.len(), P),
                ("inputs", self.lowered.inputs.len(), H),
                ("conditions", self.lowered.switches.all.len(), H),
                ("guards of conditions and contact", guards(&self.lowered), H),
                ("rows of contact", contacts.map_or(0, |contacts| contacts.places), R),
            ],
        )
    }
}

/// Guards of conditions and of rows of contact.
fn guards(lowered: &Lowered) -> usize {
    lowered.switches.guards + lowered.contacts.as_ref().map_or(0, |contacts| contacts.guard_names.len())
}

/// Is nothing larger than the most that there is room for: what, how much, and the most?
fn within<const K: usize>(
    lowered: &Lowered,
    counts: [(&'static str, usize, usize); K],
) -> Result<(), Refused> {
    match counts.into_iter().find(|(_, found, most)| found > most) {
        Some((what, found, most)) => {
            let first = name_of(lowered, what, most).unwrap_or_default();
            Err(Refused::TooLarge { what, found, most, first })
        }
        None => Ok(()),
    }
}

/// The name of what has this number among what there is too much of.
fn name_of(lowered: &Lowered, what: &str, number: usize) -> Option<String> {
    let contacts = lowered.contacts.as_ref();
    let own = match what {
        "rows of contact" => &contacts?.rows.get(number)?.name,
        "conditions" => &lowered.switches.all.get(number)?.name,
        "guards of conditions and contact" => match number.checked_sub(lowered.switches.guards) {
            Some(after) => contacts?.guard_names.get(after)?,
            None => &lowered.switches.all.get(number)?.name,
        },
        "parameters" => &lowered.parameters.get(number)?.name,
        "inputs" => &lowered.inputs.get(number)?.name,
        "constraint rows" => &lowered.rows.get(number)?.name,
        "first-order states" => &lowered.states.get(number)?.name,
        "coordinates" => lowered.bodies.get(number / 3)?,
        _ => return None,
    };
    Some(own.clone())
}
