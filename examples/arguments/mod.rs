//! The command line of an example: what it knows is taken, what is left is a mistake.

use std::env;

/// The words behind the program's name that nobody has taken.
pub(crate) struct Arguments(Vec<String>);

impl Arguments {
    pub(crate) fn new() -> Self {
        Self(env::args().skip(1).collect())
    }

    /// Takes `name`, if it is there.
    pub(crate) fn flag(&mut self, name: &str) -> bool {
        let at = self.0.iter().position(|word| word == name);
        at.map(|at| self.0.remove(at)).is_some()
    }

    /// Takes `name` and the word behind it, if it is there.
    ///
    /// # Errors
    /// When nothing, or an option, stands behind it.
    pub(crate) fn value(&mut self, name: &str) -> Result<Option<String>, String> {
        let Some(at) = self.0.iter().position(|word| word == name) else { return Ok(None) };
        if self.0.get(at + 1).is_none_or(|word| word.starts_with("--")) {
            return Err(format!("{name} needs a value"));
        }
        self.0.remove(at);
        Ok(Some(self.0.remove(at)))
    }

    /// Nothing is left.
    ///
    /// # Errors
    /// The first word that is, beside what the program knows.
    pub(crate) fn end(self, known: &str) -> Result<(), String> {
        self.0.first().map_or(Ok(()), |word| Err(format!("unknown argument {word}; known: {known}")))
    }
}
