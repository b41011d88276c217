//! Options of the command line.

use plm_program::{Arguments, BadOption, Known};

use crate::cases::KINDS;
use crate::run::By;

/// The command line, read.
#[derive(Clone, Debug)]
pub struct Options {
    pub cases: u64,
    pub seed: u64,
    /// One case by its number.
    pub case: Option<u64>,
    /// Kinds whose name contains this.
    pub only: Option<String>,
    /// By this method, where a mechanism knows it; otherwise methods are drawn.
    pub by: Option<By>,
    /// Lists every case that is not right.
    pub verbose: bool,
    /// Without f32.
    pub double: bool,
    pub threads: Option<usize>,
    pub check_reference: bool,
    /// Tolerances whose name contains this are varied: a table of what becomes of the cases.
    #[cfg(feature = "vary-tolerances")]
    pub sensitivity: Option<String>,
}

#[cfg(feature = "vary-tolerances")]
const COUNT: usize = 11;
#[cfg(not(feature = "vary-tolerances"))]
const COUNT: usize = 9;

const KNOWN: [Known; COUNT] = [
    Known::word("CASES", "how many; 1000 if nothing is said"),
    Known::value("seed", "N", "of the random mechanisms; 1 if nothing is said"),
    Known::value("case", "N", "this one alone, with all its numbers"),
    Known::value("only", "KIND", "kinds whose name contains this"),
    Known::value("by", "METHOD", "this method where a mechanism knows it; drawn if nothing is said"),
    Known::value("threads", "N", "as many as the machine has if nothing is said"),
    Known::flag("verbose", "lists every case that is not right"),
    Known::flag("double", "without f32"),
    Known::flag("check-reference", "the reference itself, beside published digits"),
    #[cfg(feature = "vary-tolerances")]
    Known::value("vary", "NAME=FACTOR", "multiplies this tolerance of plm-runtime/src/tolerances"),
    #[cfg(feature = "vary-tolerances")]
    Known::value(
        "sensitivity",
        "NAME",
        "multiplies tolerances whose name contains this, or `all`, by 10 and by 0.1: a table",
    ),
];

impl Options {
    /// Those of the command line; nothing where help was asked for and printed.
    ///
    /// # Errors
    /// [`BadOption`], whose text says in a sentence what is wrong.
    pub fn from_args() -> Result<Option<Self>, BadOption> {
        let given = Arguments::from_args(&KNOWN)?;
        if let Some(help) = given.help() {
            println!("{help}");
            return Ok(None);
        }
        #[cfg(feature = "vary-tolerances")]
        if let Some(text) = given.text("vary")? {
            vary(&text)?;
        }
        Ok(Some(Self {
            cases: given.number("CASES")?.unwrap_or(1000),
            seed: given.number("seed")?.unwrap_or(1),
            case: given.number("case")?,
            only: given.text("only")?.map(kind).transpose()?,
            by: given.text("by")?.as_deref().map(method).transpose()?,
            verbose: given.flag("verbose"),
            double: given.flag("double"),
            threads: given.number("threads")?,
            check_reference: given.flag("check-reference"),
            #[cfg(feature = "vary-tolerances")]
            sensitivity: given.text("sensitivity")?,
        }))
    }
}

/// Multiplies a tolerance by a factor.
#[cfg(feature = "vary-tolerances")]
fn vary(text: &str) -> Result<(), BadOption> {
    use plm_runtime::tolerances::{names, set_factor};
    let varied = text.split_once('=').and_then(|(name, factor)| Some(set_factor(name, factor.parse().ok()?)));
    match varied {
        Some(true) => Ok(()),
        Some(false) => Err(BadOption::new(format!(
            "--vary: no such tolerance; there are {:?}",
            names().collect::<Vec<_>>()
        ))),
        None => Err(BadOption::new("--vary: NAME=FACTOR is expected".to_owned())),
    }
}

fn kind(name: String) -> Result<String, BadOption> {
    if KINDS.iter().any(|kind| kind.name.contains(&name)) {
        return Ok(name);
    }
    let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
    Err(BadOption::new(format!("--only: no kind is called {name}; there are {}", names.join("; "))))
}

fn method(name: &str) -> Result<By, BadOption> {
    let named = By::ALL.into_iter().find(|by| format!("{by:?}").eq_ignore_ascii_case(name));
    named.ok_or_else(|| BadOption::new(format!("--by: no method is called {name}; there are {:?}", By::ALL)))
}
