//! Functions in C of the routines of a mechanism.

use std::fmt::Write as _;

use plm_compiler::Source;
use plm_compiler::lowered::{Routine, Target};

use crate::block::{Argument, Block, Value};
use crate::plan::Plan;
use crate::print::statements;

/// Arrays of a function beside the mechanism and the time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Signature {
    /// Arrays that it reads, with their lengths.
    pub(crate) reads: &'static [&'static str],
    /// Arrays that it writes.
    pub(crate) writes: &'static [&'static str],
    /// Does it return a number?
    pub(crate) returns: bool,
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
            "q" | "v" | "a" => counts.of_bodies,
            "lambda" => counts.rows,
            "memory" => counts.memory,
            "g" => counts.watched,
            "at" | "slope" => counts.times,
            "full" => 2 * counts.of_bodies + self.lowered.states.len(),
            "out" => self.outputs().count(),
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
        let place = |(target, value): &(Target, Value)| match *target {
            Target::Element(array, k) if signature.writes.contains(&array) => {
                Some((format!("{array}[{k}]"), *value))
            }
            Target::Remembered(k) => Some((format!("memory[{k}]"), *value)),
            _ => None,
        };
        let stored: Vec<(String, Value)> = results.iter().filter_map(place).collect();
        let returned = results.iter().find(|(target, _)| *target == Target::Value).map(|(_, value)| *value);
        let printed = statements(block, &self.c(), &stored, returned.filter(|_| signature.returns));
        let mut text = self.head(name, signature);
        text.push_str("{\n");
        let written = |array: &str| stored.iter().any(|(place, _)| place.starts_with(&format!("{array}[")));
        let unwritten = signature.writes.iter().copied().filter(|array| !written(array));
        for unused in unused(&printed.reads, signature).into_iter().chain(unwritten) {
            let _ = writeln!(text, "    (void){unused};");
        }
        for line in &printed.lines {
            let _ = writeln!(text, "    {line}");
        }
        if signature.returns && returned.is_none() {
            text.push_str("    return PLM_C(1.0);\n");
        }
        text.push_str("}\n\n");
        text
    }

    /// The first line of a function.
    fn head(&self, name: &str, signature: Signature) -> String {
        let prefix = &self.name;
        let kind = if signature.returns { "plm_real" } else { "void" };
        let mut text = format!("static {kind} {prefix}_{name}(const {prefix} *self, plm_real t");
        for array in signature.reads {
            let _ = write!(text, ", const plm_real {array}[{}]", self.length(array));
        }
        for array in signature.writes {
            let _ = write!(text, ", plm_real {array}[{}]", self.length(array));
        }
        text.push_str(")\n");
        text
    }
}

/// Arguments that a function does not read.
fn unused(reads: &[Argument], signature: Signature) -> Vec<&'static str> {
    let reads_self = reads.iter().any(|argument| !matches!(argument, Argument::Time | Argument::Element(..)));
    let own = [("self", reads_self), ("t", reads.contains(&Argument::Time))];
    let own = own.into_iter().filter(|(_, is_read)| !is_read).map(|(name, _)| name);
    let is_read =
        |array: &str| reads.iter().any(|read| matches!(read, Argument::Element(own, _) if *own == array));
    own.chain(signature.reads.iter().copied().filter(|array| !is_read(array))).collect()
}
