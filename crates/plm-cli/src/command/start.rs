//! A declaration at its start, with parameters and inputs from the command line.

use plm_dynamic::Mechanism;

use super::run::setting;
use super::words::Words;
use super::{Failure, Streams};
use crate::excerpt::is_rust;
use crate::read::{self, File};

/// A declaration, and the values that it is to start with.
pub(super) struct Start {
    pub(super) file: File,
    set: Vec<String>,
    input: Vec<String>,
}

impl Start {
    /// Takes `--set`, `--input` and the file, the last of all arguments.
    ///
    /// # Errors
    /// The file cannot be read, or is Rust.
    pub(super) fn asked(mut words: Words, streams: &mut Streams) -> Result<Start, Failure> {
        let (set, input) = (words.values("--set"), words.values("--input"));
        let file = read::file(&words.file()?, streams.input)?;
        if is_rust(&file.name) {
            let name = file.name;
            return Err(format!("{name}: a file is wanted that is a declaration (`.plm`), not Rust").into());
        }
        Ok(Start { file, set, input })
    }

    /// The mechanism with these values.
    ///
    /// # Errors
    /// Mistakes of the declaration, a value that is none.
    pub(super) fn mechanism(&self) -> Result<Mechanism, Failure> {
        let mut mechanism = Mechanism::from_named_text(&self.file.name, &self.file.text)?;
        for text in &self.set {
            let (name, value) = setting("--set", text, mechanism.declared_parameters())?;
            mechanism.set_parameter(name, value)?;
        }
        for text in &self.input {
            let (name, value) = setting("--input", text, mechanism.declared_inputs())?;
            mechanism.set_input(name, value)?;
        }
        Ok(mechanism)
    }
}
