//! What the command line asks for.

use crate::cases::KINDS;

/// The command line, read.
#[derive(Clone, Debug)]
pub struct Options {
    pub cases: u64,
    pub seed: u64,
    /// One case by its number.
    pub case: Option<u64>,
    /// Kinds whose name contains this.
    pub only: Option<String>,
    /// Lists every case that is not right.
    pub verbose: bool,
    /// Without f32.
    pub double: bool,
    pub threads: Option<usize>,
    pub check_reference: bool,
}

pub const USAGE: &str = "usage: sweep [CASES] [--seed N] [--case N] [--only KIND] [--threads N] [--verbose] [--double] [--check-reference]";

impl Options {
    /// Reads arguments.
    ///
    /// # Errors
    /// What is wrong with them, in a sentence.
    pub fn read(arguments: impl Iterator<Item = String>) -> Result<Self, String> {
        let mut options = Self {
            cases: 1000,
            seed: 1,
            case: None,
            only: None,
            verbose: false,
            double: false,
            threads: None,
            check_reference: false,
        };
        let mut arguments = arguments;
        while let Some(word) = arguments.next() {
            let mut value = || arguments.next().ok_or(format!("{word} needs a value"));
            match word.as_str() {
                "--seed" => options.seed = number(&word, &value()?)?,
                "--case" => options.case = Some(number(&word, &value()?)?),
                "--threads" => options.threads = Some(number(&word, &value()?)? as usize),
                "--only" => options.only = Some(kind(value()?)?),
                "--verbose" => options.verbose = true,
                "--double" => options.double = true,
                "--check-reference" => options.check_reference = true,
                _ if word.starts_with('-') => return Err(format!("unknown option {word}")),
                _ => options.cases = number("the number of cases", &word)?,
            }
        }
        Ok(options)
    }
}

fn number(what: &str, text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| format!("{what}: {text} is no whole number"))
}

fn kind(name: String) -> Result<String, String> {
    if KINDS.iter().any(|kind| kind.name.contains(&name)) {
        return Ok(name);
    }
    let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
    Err(format!("--only: no kind is called {name}; there are {}", names.join("; ")))
}
