//! Start values from text, as `Display` of the generated `Starts` writes them.

use std::fmt;
use std::string::{String, ToString};
use std::vec::Vec;

use plm_runtime::{Scalar, Start, StartValues};

/// Error of a text of start values.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
#[derive(Clone, PartialEq, Eq)]
pub struct BadStarts {
    /// Everything that is wrong, in the order of the text; then what it lacks.
    pub problems: Vec<StartProblem>,
}

/// One thing that is wrong with a text of start values.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StartProblem {
    /// A line is not of the form `name = number`, or its number is not finite.
    Line {
        /// The line, from 1.
        line: usize,
        /// The message.
        text: String,
    },
    /// The mechanism has no start value of this name.
    Unknown {
        /// The line, from 1.
        line: usize,
        /// The name.
        name: String,
    },
    /// A start value stands twice.
    Twice {
        /// The second line, from 1.
        line: usize,
        /// Its name.
        name: &'static str,
    },
    /// A start value does not stand in the text.
    Missing {
        /// Its name.
        name: &'static str,
    },
}

impl std::error::Error for BadStarts {}

impl fmt::Debug for BadStarts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for BadStarts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list: Vec<String> = self.problems.iter().map(ToString::to_string).collect();
        write!(f, "start values: {}", list.join("; "))
    }
}

impl fmt::Display for StartProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line { line, text } => write!(f, "line {line}: `{text}` is not `name = number`"),
            Self::Unknown { line, name } => write!(f, "line {line}: there is no `{name}`"),
            Self::Twice { line, name } => write!(f, "line {line}: `{name}` stands twice"),
            Self::Missing { name } => write!(f, "`{name}` is missing"),
        }
    }
}

/// `starts` with the values of a text, one a line as in `arm.angle = 0.5`, SI units; locks stay as they are. Empty lines and
/// lines that begin with `#` say nothing.
///
/// The text is that of `sim.starts().to_string()`, in which numbers come back to the last bit.
///
/// # Errors
/// Lines that cannot be read, names that there are not, and names that are missing, all at once.
pub fn read_starts<S: Scalar, T: StartValues<S>>(text: &str, mut starts: T) -> Result<T, BadStarts> {
    let mut problems = Vec::new();
    let mut given = Vec::new();
    for (index, text) in text.lines().enumerate() {
        let (line, text) = (index + 1, text.trim());
        if text.is_empty() || text.starts_with('#') {
            continue;
        }
        let entry = text.split_once('=').map(|(name, value)| (name.trim(), value.trim().parse::<f64>()));
        match entry {
            Some((name, Ok(value))) if value.is_finite() => {
                given.push(Given { line, name, value, read: false });
            }
            _ => problems.push(StartProblem::Line { line, text: text.into() }),
        }
    }
    starts.each(&mut |name, start: &mut Start<S>| {
        let mut lines = given.iter_mut().filter(|given| given.name == name);
        match lines.next() {
            Some(given) => {
                given.read = true;
                start.value = S::lit(given.value);
            }
            None => problems.push(StartProblem::Missing { name }),
        }
        for again in lines {
            again.read = true;
            problems.push(StartProblem::Twice { line: again.line, name });
        }
    });
    let unknown = given.iter().filter(|given| !given.read);
    problems.extend(unknown.map(|given| StartProblem::Unknown { line: given.line, name: given.name.into() }));
    problems.sort_by_key(|problem| match problem {
        StartProblem::Line { line, .. }
        | StartProblem::Unknown { line, .. }
        | StartProblem::Twice { line, .. } => *line,
        StartProblem::Missing { .. } => usize::MAX,
    });
    if problems.is_empty() { Ok(starts) } else { Err(BadStarts { problems }) }
}

/// A line that could be read.
struct Given<'a> {
    line: usize,
    name: &'a str,
    value: f64,
    read: bool,
}
