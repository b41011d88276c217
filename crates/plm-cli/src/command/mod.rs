//! The command line: a table of commands, each of which has a module.

mod check;
mod clock;
mod expand;
mod export;
mod fmt;
#[cfg(feature = "identify")]
mod identify;
mod import;
mod lsp;
#[cfg(feature = "mcp")]
mod mcp;
#[cfg(feature = "identify")]
mod modes;
mod picture;
mod run;
mod start;
mod words;

use std::ffi::OsString;
use std::io::{self, Read, Write};
use std::process::ExitCode;

use words::{Kind, Words};

/// Input, results and messages of a command.
pub struct Streams<'a> {
    /// Standard input.
    pub input: &'a mut dyn Read,
    /// Results.
    pub output: &'a mut dyn Write,
    /// Messages.
    pub errors: &'a mut dyn Write,
}

/// Outcome of a command; of the first three in the order of weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// Nothing is wrong, or there are warnings alone: 0.
    Good,
    /// A declaration has errors, a file has another layout, or a run ends with a fault: 1.
    Wrong,
    /// The arguments are no command, or a file cannot be read: 2.
    Failed,
    /// The command has its result, with notices to be checked before it is used: 3.
    Doubtful,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> ExitCode {
        ExitCode::from(outcome as u8)
    }
}

/// Why a command ends: a message, which ends it as [`Outcome::Failed`].
type Failure = Box<dyn std::error::Error>;

/// A command.
struct Command {
    name: &'static str,
    /// Arguments after its name.
    usage: &'static str,
    /// Its purpose, in a line.
    title: &'static str,
    /// Its options, a line each; after a blank the placeholder of a value.
    options: &'static [(&'static str, &'static str)],
    run: fn(Words, &mut Streams) -> Result<Outcome, Failure>,
}

/// All commands, in the order of the help.
const COMMANDS: &[Command] = &[
    check::COMMAND,
    run::COMMAND,
    #[cfg(feature = "identify")]
    identify::COMMAND,
    #[cfg(feature = "identify")]
    modes::COMMAND,
    picture::COMMAND,
    expand::EXPAND,
    expand::REPORT,
    export::COMMAND,
    import::COMMAND,
    fmt::COMMAND,
    lsp::COMMAND,
    #[cfg(feature = "mcp")]
    mcp::COMMAND,
];

/// Runs the command that the arguments name, without the name of the program.
pub fn run(words: impl Iterator<Item = OsString>, streams: &mut Streams) -> Outcome {
    let outcome = Words::new(words, kind_of).and_then(|words| dispatch(words, streams));
    outcome.unwrap_or_else(|failure| {
        // A reader may close the results early, as `head` does.
        let is_closed =
            failure.downcast_ref::<io::Error>().is_some_and(|why| why.kind() == io::ErrorKind::BrokenPipe);
        if is_closed {
            return Outcome::Good;
        }
        // If messages cannot be written, there is no place to report it.
        let _ = writeln!(streams.errors, "plm: {failure}");
        Outcome::Failed
    })
}

fn dispatch(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let name = words.command()?;
    let known = |name: &str| COMMANDS.iter().find(|command| command.name == name);
    match name.as_deref() {
        None => {
            write!(streams.errors, "{}", help())?;
            Ok(Outcome::Failed)
        }
        Some("help") => {
            let text = match words.word() {
                None => help(),
                Some(of) => known(&of).map(Command::help).ok_or_else(|| unknown(&of))?,
            };
            write!(streams.output, "{text}")?;
            Ok(Outcome::Good)
        }
        Some("version") => {
            writeln!(streams.output, "plm {}", env!("CARGO_PKG_VERSION"))?;
            Ok(Outcome::Good)
        }
        Some(name) => {
            let command = known(name).ok_or_else(|| unknown(name))?;
            if words.asks_for_help() {
                write!(streams.output, "{}", command.help())?;
                return Ok(Outcome::Good);
            }
            command.knows(&words)?;
            (command.run)(words, streams)
        }
    }
}

/// The kind of an option, by the options of all commands.
fn kind_of(option: &str) -> Kind {
    let shown = COMMANDS.iter().flat_map(|command| command.options).map(|(shown, _)| *shown);
    let mut own = shown.filter(|shown| name_of(shown) == option);
    own.next().map_or(Kind::Unknown, |shown| match shown.split_once(' ') {
        Some((_, value)) => Kind::Valued(value),
        None => Kind::Bare,
    })
}

/// The name of an option of the table.
fn name_of(shown: &str) -> &str {
    shown.split_once(' ').map_or(shown, |(name, _)| name)
}

fn unknown(name: &str) -> String {
    let names: Vec<&str> = COMMANDS.iter().map(|command| command.name).collect();
    let near = plm_compiler::diag::nearest(name, names.iter().copied());
    let near = near.map_or(String::new(), |near| format!("; `{near}` is one"));
    format!("there is no command `{name}`{near}\ncommands: {}", names.join(", "))
}

/// The commands, a line each.
fn help() -> String {
    let shown =
        COMMANDS.iter().map(|command| (format!("plm {} {}", command.name, command.usage), command.title));
    let mut lines = vec!["Declarations of planar mechanisms without rustc.".to_owned(), String::new()];
    lines.extend(shown.map(|(usage, title)| format!("  {usage:30} {title}")));
    lines.push("\nA FILE is a declaration, or Rust (`.rs`) with `mechanism! { … }` in it; `-` is the standard input.".to_owned());
    lines.push("`plm help COMMAND` shows the options of a command, `plm version` the version.\n".to_owned());
    lines.join("\n")
}

impl Command {
    /// Are all options those of this command?
    fn knows(&self, words: &Words) -> Result<(), Failure> {
        let names = |of: &Command| of.options.iter().map(|(shown, _)| name_of(shown)).collect::<Vec<_>>();
        let own = names(self);
        let Some(option) = words.other_than(&own) else { return Ok(()) };
        let others = COMMANDS.iter().filter(|other| names(other).contains(&option));
        let others: Vec<String> = others.map(|other| format!("`plm {}`", other.name)).collect();
        let near = match plm_compiler::diag::nearest(option, own.iter().copied()) {
            Some(near) => format!("; `{near}` is one"),
            None if !others.is_empty() => format!("; it is one of {}", others.join(", ")),
            None => String::new(),
        };
        let all = if own.is_empty() { "none".to_owned() } else { own.join(", ") };
        Err(format!("there is no option {option}{near}\noptions of `plm {}`: {all}", self.name).into())
    }

    fn help(&self) -> String {
        let width = self.options.iter().map(|(option, _)| option.len()).max().unwrap_or_default();
        let options = self.options.iter().map(|(option, meaning)| format!("  {option:width$}  {meaning}\n"));
        format!("plm {} {}\n    {}\n{}", self.name, self.usage, self.title, options.collect::<String>())
    }
}
