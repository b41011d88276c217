//! The options that programs over a mechanism have in common.

use std::borrow::ToOwned;
use std::ffi::OsString;
use std::fmt;
use std::format;
use std::path::PathBuf;
use std::string::{String, ToString};
use std::vec::Vec;

use lexopt::{Arg, Parser, ValueExt};
use plm_runtime::{AsMoment, Described, Moment};

use super::recorder::Recorder;

/// What is asked for on the command line.
///
/// ```
/// use plm::view::Options;
///
/// let options = Options::parse(["--until", "5", "--set", "mass=3", "--csv=run.csv"])?;
/// assert_eq!((options.until, options.csv.as_deref()), (Some(5.0), Some("run.csv".as_ref())));
/// assert!(Options::parse(["--untl", "5"]).unwrap_err().to_string().contains("--until"));
/// # Ok::<(), plm::view::BadOption>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// `--view FILE`: the page that moves.
    pub view: Option<PathBuf>,
    /// `--live`: the page holds the mechanism itself, to be run in it.
    pub live: bool,
    /// `--csv FILE`: the table.
    pub csv: Option<PathBuf>,
    /// `--svg FILE`: the curves.
    pub svg: Option<PathBuf>,
    /// `--out FILE`: the results file.
    pub out: Option<PathBuf>,
    /// `--c FOLDER`: a static library of the mechanism, and its header.
    pub c: Option<PathBuf>,
    /// `--fmu FILE`: an FMU of the mechanism.
    pub fmu: Option<PathBuf>,
    /// `--until TIME`, s.
    pub until: Option<f64>,
    /// `--every TIME`, s: between samples.
    pub every: Option<f64>,
    /// `--set NAME=VALUE`, as often as wanted: parameters in their declared units.
    pub set: Vec<(String, f64)>,
    /// `--help`.
    pub help: bool,
}

/// The options in words.
pub(super) const HELP: &str = "\
--view FILE       the page that moves, one HTML file (written to target/plm where nothing else is asked for)
--live            the page holds the mechanism itself: parameters are turned, bodies pulled
--out FILE        the results file, .npz (NumPy reads it)
--csv FILE        the table
--svg FILE        the curves
--c FOLDER        a static library of the mechanism as declared, and its header, for C and C++
--fmu FILE        an FMU of the mechanism as declared (FMI 3.0)
--until TIME      when the run ends, s
--every TIME      between samples, s
--set NAME=VALUE  a parameter in its declared unit; as often as wanted
--help            these lines";

/// A mistake on the command line.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
pub struct BadOption(pub(super) String);

impl fmt::Debug for BadOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for BadOption {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadOption {}

impl From<lexopt::Error> for BadOption {
    fn from(error: lexopt::Error) -> Self {
        let message = error.to_string();
        let unknown =
            matches!(error, lexopt::Error::UnexpectedOption(_) | lexopt::Error::UnexpectedArgument(_));
        Self(if unknown { format!("{message}; there are\n{HELP}") } else { message })
    }
}

impl Options {
    /// Those of this program.
    ///
    /// # Errors
    /// A word that is no option, or a value that is missing or no number.
    pub fn from_args() -> Result<Self, BadOption> {
        Self::parse(std::env::args_os().skip(1))
    }

    /// Those of a list of words.
    ///
    /// # Errors
    /// As [`from_args`](Self::from_args).
    pub fn parse<W: Into<OsString>>(words: impl IntoIterator<Item = W>) -> Result<Self, BadOption> {
        let words: Vec<OsString> = words.into_iter().map(Into::into).collect();
        let mut parser = Parser::from_args(words);
        let mut options = Self::default();
        while let Some(word) = parser.next()? {
            match word {
                Arg::Long("view") => options.view = Some(parser.value()?.into()),
                Arg::Long("live") => options.live = true,
                Arg::Long("csv") => options.csv = Some(parser.value()?.into()),
                Arg::Long("svg") => options.svg = Some(parser.value()?.into()),
                Arg::Long("out") => options.out = Some(parser.value()?.into()),
                Arg::Long("c") => options.c = Some(parser.value()?.into()),
                Arg::Long("fmu") => options.fmu = Some(parser.value()?.into()),
                Arg::Long("until") => options.until = Some(time("--until", &mut parser)?),
                Arg::Long("every") => options.every = Some(time("--every", &mut parser)?),
                Arg::Long("set") => options.set.push(setting(&parser.value()?.string()?)?),
                Arg::Long("help") | Arg::Short('h') => options.help = true,
                other => return Err(other.unexpected().into()),
            }
        }
        Ok(options)
    }

    /// A recorder of what they need: the declared outputs in their units, or all that a live page shows.
    pub fn recorder<M: Described>(&self, of: &impl AsMoment<State: Moment<M = M>>) -> Recorder<M> {
        if self.live { Recorder::observing_all(of) } else { Recorder::new(of) }
    }

    /// Sets the parameters of a mechanism.
    ///
    /// # Errors
    /// A name that is no parameter, with those that there are.
    pub fn apply<M: Described<S = f64>>(&self, mechanism: &mut M) -> Result<(), BadOption> {
        for (name, value) in &self.set {
            let parameters = M::TABLES.parameters;
            let Some(index) = parameters.iter().position(|parameter| parameter.name == name) else {
                return Err(BadOption(format!("there is no parameter `{name}`; {}", known::<M>())));
            };
            mechanism.set_parameter(index, value * parameters[index].factor);
        }
        Ok(())
    }
}

/// The parameters of a mechanism in words.
fn known<M: Described>() -> String {
    let parameters = M::TABLES.parameters.iter();
    let named: Vec<String> = parameters
        .map(|parameter| match parameter.unit {
            "" => parameter.name.to_owned(),
            unit => format!("{} ({unit})", parameter.name),
        })
        .collect();
    if named.is_empty() { "it has none".to_owned() } else { format!("there are {}", named.join(", ")) }
}

/// A positive time, s.
fn time(option: &str, parser: &mut Parser) -> Result<f64, BadOption> {
    let word = parser.value()?.string()?;
    let time: Option<f64> = word.parse().ok();
    let positive = time.filter(|time| *time > 0.0 && time.is_finite());
    positive.ok_or_else(|| BadOption(format!("{option} wants a positive time in seconds, not `{word}`")))
}

/// `mass=3`.
fn setting(word: &str) -> Result<(String, f64), BadOption> {
    let split = word.split_once('=');
    let read = split.and_then(|(name, value)| Some((name.trim().to_owned(), value.trim().parse().ok()?)));
    read.ok_or_else(|| BadOption(format!("--set wants NAME=NUMBER, not `{word}`")))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use std::string::ToString;
    use std::vec;

    use super::Options;

    #[test]
    fn every_option_is_read() {
        let words = vec![
            "--view", "a.html", "--live", "--csv", "b", "--svg", "c", "--out", "d", "--every", "1e-2",
            "--set", "k = -3",
        ];
        let options = Options::parse(words).unwrap();
        assert!(options.live && !options.help && options.until.is_none());
        assert_eq!(options.set, [("k".to_string(), -3.0)]);
        assert_eq!(options.every, Some(0.01));
    }

    #[test]
    fn mistakes_say_what_was_wanted() {
        for (words, said) in [
            (vec!["--untill", "3"], "--until TIME"),
            (vec!["run"], "--view FILE"),
            (vec!["--until", "-3"], "positive time"),
            (vec!["--until"], "missing argument"),
            (vec!["--set", "mass"], "NAME=NUMBER"),
        ] {
            let found = Options::parse(words).unwrap_err().to_string();
            assert!(found.contains(said), "{found}");
        }
    }
}
