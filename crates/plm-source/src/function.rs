//! Functions in C of the routines of a mechanism.

use std::fmt::Write as _;

use plm_compiler::Source;
use plm_compiler::lowered::{Routine, Target};

use crate::block::{Argument, Block, Value};
use crate::plan::Plan;
use crate::print::statements;

/// The place of a result that a function returns.
pub(crate) const RETURNED: &str = "return";
/// The end of a function that returns no result of its routine.
const NOTHING_RETURNED: &str = "    return PLM_C(1.0);\n}\n\n";

/// Arrays of a function beside the mechanism and the time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Signature {
    /// Arrays that it reads, with their lengths.
    pub(crate) reads: &'static [&'static str],
    /// Arrays that it writes.
    pub(crate) writes: &'static [&'static str],
    /// Does it return a number?
    pub(crate) returns: bool,
    /// Does it read the forces of contact, where a mechanism has them?
    pub(crate) is_forced: bool,
}

impl Signature {
    /// The arrays that it reads.
    pub(crate) fn read(self, plan: &Plan) -> impl Iterator<Item = &'static str> {
        let forces = (self.is_forced && plan.reads_forces()).then_some("force");
        self.reads.iter().copied().chain(forces)
    }
}

impl Plan<'_> {
    /// A source as a value: fixed parameters are constants.
    pub(crate) fn read(&self, block: &mut Block, source: Source) -> Value {
        match source {
            Source::Parameter(k) if self.is_fixed.get(k) == Some(&true) => {
                block.number(self.start.parameters.get(k).copied().unwrap_or(0.0))
            }
            source => block.source(source),
        }
    }

    pub(crate) fn block(&self) -> Block {
        Block::new(self.scalar())
    }

    /// Number of elements of an array, at least one.
    pub(crate) fn length(&self, array: &str) -> usize {
        let counts = &self.counts;
        let length = match array {
            "q" | "v" | "a" | "w" | "dq" | "inverse_mass" => counts.of_bodies,
            "lambda" | "phi" | "phi_dot" | "r" => counts.rows,
            "memory" => counts.memory,
            "g" => counts.watched,
            "at" | "slope" => counts.times,
            "full" => 2 * counts.of_bodies + self.lowered.states.len(),
            "out" => self.outputs().count(),
            "force" | "restitution" | "exist" => counts.places,
            "holds" => self.lowered.sets.events.len(),
            "set" => self.lowered.sets.events.iter().map(Vec::len).sum(),
            "limited" => self.lowered.starts.limits.len(),
            _ => counts.states,
        };
        length.max(1)
    }

    /// A function of one routine.
    pub(crate) fn of_routine(&self, name: &str, routine: &Routine, signature: Signature) -> String {
        let mut block = self.block();
        let results = block.routine(routine, |block, source| self.read(block, source));
        self.function(name, &block, &results, signature)
    }

    /// A function whose results are elements of its arrays, or what it returns.
    pub(crate) fn function(
        &self,
        name: &str,
        block: &Block,
        results: &[(Target, Value)],
        signature: Signature,
    ) -> String {
        let place = |target| match target {
            Target::Element(array, k) if signature.writes.contains(&array) => Some(format!("{array}[{k}]")),
            Target::Remembered(k) => Some(format!("memory[{k}]")),
            Target::Value if signature.returns => Some(RETURNED.to_owned()),
            _ => None,
        };
        let arrays: Vec<&str> = signature.read(self).chain(signature.writes.iter().copied()).collect();
        let text = self.head(name, signature);
        let body = self.body(block, results, place, &arrays);
        let body = if signature.returns { body } else { body.replace(NOTHING_RETURNED, "}\n\n") };
        text + &body
    }

    /// The body of a function that returns a number, one of good health where no result is [`RETURNED`]: results are stored in their
    /// places; arguments `arrays` that it does not name are read as nothing.
    pub(crate) fn body(
        &self,
        block: &Block,
        results: &[(Target, Value)],
        place: impl Fn(Target) -> Option<String>,
        arrays: &[&str],
    ) -> String {
        let placed = |(target, value): &(Target, Value)| Some((place(*target)?, *value));
        let (returned, stored): (Vec<_>, Vec<_>) =
            results.iter().filter_map(placed).partition(|(place, _)| place == RETURNED);
        let returned = returned.first().map(|(_, value)| *value);
        let printed = statements(block, &self.c(), &stored, returned);
        let mut text = "{\n".to_owned();
        for unused in unused(&printed.reads, &stored, arrays) {
            let _ = writeln!(text, "    (void){unused};");
        }
        for line in &printed.lines {
            let _ = writeln!(text, "    {line}");
        }
        text.push_str(if returned.is_none() { NOTHING_RETURNED } else { "}\n\n" });
        text
    }

    /// The first line of a function.
    fn head(&self, name: &str, signature: Signature) -> String {
        let prefix = &self.name;
        let kind = if signature.returns { "plm_real" } else { "void" };
        let mut text = format!("static {kind} {prefix}_{name}(const {prefix} *self, plm_real t");
        for array in signature.read(self) {
            let _ = write!(text, ", const plm_real {array}[{}]", self.length(array));
        }
        for array in signature.writes {
            let _ = write!(text, ", plm_real {array}[{}]", self.length(array));
        }
        text.push_str(")\n");
        text
    }
}

/// Arguments that a function neither reads nor writes.
fn unused<'a>(reads: &[Argument], stored: &[(String, Value)], arrays: &[&'a str]) -> Vec<&'a str> {
    let reads_self = reads.iter().any(|argument| !matches!(argument, Argument::Time | Argument::Element(..)));
    let own = [("self", reads_self), ("t", reads.contains(&Argument::Time))];
    let own = own.into_iter().filter(|(_, is_read)| !is_read).map(|(name, _)| name);
    let is_named = |array: &str| {
        let is_written = stored.iter().any(|(place, _)| {
            place.strip_prefix(array).is_some_and(|rest| rest.starts_with('[') || rest.starts_with("->"))
        });
        is_written || reads.iter().any(|read| matches!(read, Argument::Element(own, _) if *own == array))
    };
    own.chain(arrays.iter().copied().filter(|array| !is_named(array))).collect()
}
