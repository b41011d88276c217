//! Command-line arguments of a program: a table lists its options, everything else is a mistake.

use std::ffi::OsString;
use std::str::FromStr;

use lexopt::{Arg, Parser, ValueExt};
use plm_run::{BadOption, nearest};

/// An option that a program knows: a line of its help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Known {
    name: &'static str,
    value: Value,
    help: &'static str,
}

/// Value of an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Value {
    Nothing,
    Needed(&'static str),
    /// After `=` alone.
    Possible(&'static str),
    /// A positional argument: it has no dashes.
    Alone(&'static str),
}

impl Known {
    /// `--name`.
    pub const fn flag(name: &'static str, help: &'static str) -> Self {
        Self { name, value: Value::Nothing, help }
    }

    /// `--name VALUE`, or `--name=VALUE`.
    pub const fn value(name: &'static str, value: &'static str, help: &'static str) -> Self {
        Self { name, value: Value::Needed(value), help }
    }

    /// `--name`, or `--name=VALUE`.
    pub const fn flag_or_value(name: &'static str, value: &'static str, help: &'static str) -> Self {
        Self { name, value: Value::Possible(value), help }
    }

    /// A positional argument; its value is read by this name.
    pub const fn word(name: &'static str, help: &'static str) -> Self {
        Self { name, value: Value::Alone(name), help }
    }

    /// Without the dashes.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// As help shows it.
    fn shown(&self) -> String {
        let Self { name, value, .. } = self;
        match value {
            Value::Nothing => format!("--{name}"),
            Value::Needed(value) => format!("--{name} {value}"),
            Value::Possible(value) => format!("--{name}[={value}]"),
            Value::Alone(name) => (*name).to_owned(),
        }
    }
}

/// Every program knows it.
const HELP: Known = Known::flag("help", "these lines");

/// Arguments of a command line by a table of options; for programs without a mechanism to be run, as `tests/oracle/stability`.
/// [`Options`](super::Options) are the usual ones of a run, and take further ones.
///
/// ```
/// use plm::view::{Arguments, Known};
///
/// const KNOWN: &[Known] = &[
///     Known::word("CASES", "how many"),
///     Known::value("seed", "N", "of the random numbers"),
///     Known::flag("quick", "few settings"),
/// ];
/// let given = Arguments::parse(KNOWN, ["1000", "--seed", "31"])?;
/// assert_eq!((given.number("CASES")?, given.number("seed")?), (Some(1000), Some(31)));
/// assert!(!given.flag("quick"));
/// let mistake = Arguments::parse(KNOWN, ["--sed", "31"]).unwrap_err().to_string();
/// assert!(mistake.starts_with("there is no option `--sed`; is `--seed` meant?"));
/// # Ok::<(), plm::view::BadOption>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arguments {
    known: Vec<Known>,
    given: Vec<(&'static str, OsString)>,
}

/// A mistake that the parser of the command line finds.
#[allow(clippy::needless_pass_by_value, reason = "as `map_err` hands it over")]
fn of_words(error: lexopt::Error) -> BadOption {
    BadOption::new(error.to_string())
}

impl Arguments {
    /// Those of this program.
    ///
    /// # Errors
    /// An argument that the table does not have, with the nearest that it has; a value that is missing, or too much.
    pub fn from_args(known: &[Known]) -> Result<Self, BadOption> {
        Self::parse(known, std::env::args_os().skip(1))
    }

    /// Those of a list of arguments.
    ///
    /// # Errors
    /// As [`from_args`](Self::from_args).
    pub fn parse<W: Into<OsString>>(
        known: &[Known],
        words: impl IntoIterator<Item = W>,
    ) -> Result<Self, BadOption> {
        let mut arguments = Self { known: known.iter().copied().chain([HELP]).collect(), given: Vec::new() };
        let mut parser = Parser::from_args(words.into_iter().map(Into::into).collect::<Vec<OsString>>());
        while let Some(word) = parser.next().map_err(of_words)? {
            let given = match word {
                Arg::Short('h') => (HELP.name, OsString::new()),
                Arg::Short(letter) => return Err(arguments.unknown(&format!("-{letter}"))),
                Arg::Value(word) => (arguments.place_of(&word)?, word),
                Arg::Long(name) => {
                    let known = arguments.find(name)?;
                    let value = match known.value {
                        Value::Needed(_) => value_of(&known, &mut parser)?,
                        Value::Possible(_) => parser.optional_value().unwrap_or_default(),
                        Value::Nothing | Value::Alone(_) => OsString::new(),
                    };
                    (known.name, value)
                }
            };
            arguments.given.push(given);
        }
        Ok(arguments)
    }

    /// True if an option is given.
    pub fn flag(&self, name: &str) -> bool {
        self.given.iter().any(|(given, _)| *given == name)
    }

    /// The value of an option, the last where it stands several times; empty where it may have none.
    pub fn value(&self, name: &str) -> Option<&OsString> {
        self.given.iter().rev().find(|(given, _)| *given == name).map(|(_, value)| value)
    }

    /// The value of an option as a text.
    ///
    /// # Errors
    /// A value that is no text.
    pub fn text(&self, name: &str) -> Result<Option<String>, BadOption> {
        self.value(name).map(text).transpose()
    }

    /// All values of an option that may stand several times, as texts.
    ///
    /// # Errors
    /// A value that is no text.
    pub fn texts(&self, name: &str) -> Result<Vec<String>, BadOption> {
        self.given.iter().filter(|(given, _)| *given == name).map(|(_, value)| text(value)).collect()
    }

    /// The value of an option as a number.
    ///
    /// # Errors
    /// A value that is no number of the requested type.
    pub fn number<T: FromStr>(&self, name: &str) -> Result<Option<T>, BadOption> {
        let Some(text) = self.text(name)? else { return Ok(None) };
        let shown = self.known.iter().find(|known| known.name == name).map_or(name.to_owned(), Known::shown);
        let wrong = |_| BadOption::new(format!("{shown}: `{text}` is not such a number"));
        text.parse().map(Some).map_err(wrong)
    }

    /// The table as help, if `--help` is there.
    pub fn help(&self) -> Option<String> {
        self.flag(HELP.name).then(|| self.table())
    }

    /// A line for each option.
    fn table(&self) -> String {
        let shown: Vec<String> = self.known.iter().map(Known::shown).collect();
        let width = shown.iter().map(String::len).max().unwrap_or_default();
        let lines =
            shown.iter().zip(&self.known).map(|(shown, known)| format!("{shown:width$}  {}", known.help));
        lines.collect::<Vec<String>>().join("\n")
    }

    /// The option of a name.
    fn find(&self, name: &str) -> Result<Known, BadOption> {
        let found = self.named().find(|known| known.name == name);
        found.copied().ok_or_else(|| self.unknown(&format!("--{name}")))
    }

    /// Name of the first positional argument that is not given yet.
    fn place_of(&self, word: &OsString) -> Result<&'static str, BadOption> {
        let mut places = self.known.iter().filter(|known| matches!(known.value, Value::Alone(_)));
        let free = places.find(|known| !self.flag(known.name));
        free.map(|known| known.name).ok_or_else(|| self.unknown(&word.to_string_lossy()))
    }

    fn unknown(&self, word: &str) -> BadOption {
        let near = nearest(word.trim_start_matches('-'), self.named().map(|known| known.name));
        let hint = near.map_or("there are".to_owned(), |name| format!("is `--{name}` meant? There are"));
        let what = if word.starts_with('-') { "option" } else { "place for a word" };
        BadOption::new(format!("there is no {what} `{word}`; {hint}\n{}", self.table()))
    }

    /// The options, without positional arguments.
    fn named(&self) -> impl Iterator<Item = &Known> {
        self.known.iter().filter(|known| !matches!(known.value, Value::Alone(_)))
    }
}

/// Value after an option, which must not be an option.
fn value_of(known: &Known, parser: &mut Parser) -> Result<OsString, BadOption> {
    if let Some(value) = parser.optional_value() {
        return Ok(value);
    }
    let after =
        parser.try_raw_args().and_then(|words| words.peek().map(|word| word.to_string_lossy().into_owned()));
    match after {
        Some(word) if !word.starts_with("--") => parser.value().map_err(of_words),
        _ => Err(BadOption::new(format!("{}: the value is missing", known.shown()))),
    }
}

fn text(value: &OsString) -> Result<String, BadOption> {
    value.clone().string().map_err(of_words)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Arguments, Known};

    const KNOWN: &[Known] = &[
        Known::word("CASES", "how many"),
        Known::value("seed", "N", "of the random numbers"),
        Known::value("until", "TIME", "the end"),
        Known::flag_or_value("serve", "PORT", "a page"),
        Known::flag("quick", "few"),
    ];

    #[test]
    fn words_are_taken_by_the_table() {
        let given =
            Arguments::parse(KNOWN, ["--seed=7", "--quick", "12", "--serve", "--seed", "-8"]).unwrap();
        assert!(given.flag("quick") && given.help().is_none());
        assert_eq!((given.number("CASES").unwrap(), given.number("seed").unwrap()), (Some(12), Some(-8)));
        assert_eq!(given.text("serve").unwrap().as_deref(), Some(""));
        assert_eq!(Arguments::parse(KNOWN, ["--serve=80"]).unwrap().number("serve").unwrap(), Some(80_u16));
        let help = Arguments::parse(KNOWN, ["-h"]).unwrap().help().unwrap();
        assert!(
            help.contains("--serve[=PORT]  a page\n--quick         few\n--help          these lines"),
            "{help}"
        );
    }

    #[test]
    fn mistakes_say_what_there_is() {
        for (words, said) in [
            (["--sed", "3"], "no option `--sed`; is `--seed` meant?"),
            (["--bananas", "3"], "no option `--bananas`; there are\nCASES"),
            (["--CASES", "3"], "no option `--CASES`"),
            (["-x", "3"], "no option `-x`"),
            (["12", "13"], "no place for a word `13`"),
            (["--seed", "--quick"], "--seed N: the value is missing"),
            (["--quick=3", "4"], "unexpected argument"),
        ] {
            let found = Arguments::parse(KNOWN, words).unwrap_err().to_string();
            assert!(found.contains(said), "{found}");
        }
        let given = Arguments::parse(KNOWN, ["--seed", "x"]).unwrap();
        let found = given.number::<u64>("seed").unwrap_err().to_string();
        assert_eq!(found, "--seed N: `x` is not such a number");
    }
}
