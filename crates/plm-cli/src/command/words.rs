//! Arguments of a command line: options and files.

use std::collections::VecDeque;
use std::ffi::OsString;

use lexopt::{Arg, Parser};

use super::Failure;

/// The kind of an option.
pub(super) enum Kind {
    /// It has a value, whose placeholder this is.
    Valued(&'static str),
    Bare,
    Unknown,
}

/// The arguments, options apart from files; after `--` all arguments are files.
pub(super) struct Words {
    /// Options with their values.
    options: Vec<(String, Option<String>)>,
    files: VecDeque<String>,
}

impl Words {
    /// Parses the arguments; `kind_of` gives the kind of an option.
    pub(super) fn new(
        words: impl Iterator<Item = OsString>,
        kind_of: impl Fn(&str) -> Kind,
    ) -> Result<Words, Failure> {
        let mut parser = Parser::from_args(words);
        let (mut options, mut files) = (Vec::new(), VecDeque::new());
        while let Some(word) = parser.next()? {
            match word {
                Arg::Short(letter) => options.push((format!("-{letter}"), None)),
                Arg::Long(name) => {
                    let name = format!("--{name}");
                    let value = match kind_of(&name) {
                        Kind::Valued(wanted) => Some(value(&name, wanted, &mut parser)?),
                        Kind::Bare => None,
                        // It is reported later, when the command is known.
                        Kind::Unknown => parser.optional_value().map(text).transpose()?,
                    };
                    options.push((name, value));
                }
                Arg::Value(word) => files.push_back(text(word)?),
            }
        }
        Ok(Words { options, files })
    }

    /// The next argument, as the name of a command.
    pub(super) fn command(&mut self) -> Result<Option<String>, Failure> {
        if self.files.is_empty() && self.asks_for_help() {
            return Ok(Some("help".to_owned()));
        }
        match self.options.first().map(|(option, _)| option.as_str()) {
            Some("--version" | "-V") => return Ok(Some("version".to_owned())),
            Some("--help" | "-h") if self.files.is_empty() => return Ok(Some("help".to_owned())),
            Some(option) if self.files.is_empty() => {
                return Err(format!("there is no option {option}").into());
            }
            _ => {}
        }
        Ok(self.files.pop_front())
    }

    /// The next argument that is no option.
    pub(super) fn word(&mut self) -> Option<String> {
        self.files.pop_front()
    }

    pub(super) fn asks_for_help(&self) -> bool {
        self.options.iter().any(|(option, _)| option == "--help" || option == "-h")
    }

    /// The first option that is none of these.
    pub(super) fn other_than(&self, known: &[&str]) -> Option<&str> {
        self.options.iter().map(|(option, _)| option.as_str()).find(|option| !known.contains(option))
    }

    /// Takes an option out: is it there?
    pub(super) fn takes(&mut self, option: &str) -> bool {
        let count = self.options.len();
        self.options.retain(|(given, _)| given != option);
        self.options.len() < count
    }

    /// Takes an option with its value out: the last one where it stands several times.
    pub(super) fn value(&mut self, option: &str) -> Option<String> {
        self.values(option).pop()
    }

    /// Takes out all values of an option.
    pub(super) fn values(&mut self, option: &str) -> Vec<String> {
        let (taken, left) =
            std::mem::take(&mut self.options).into_iter().partition(|(given, _)| given == option);
        self.options = left;
        let taken: Vec<(String, Option<String>)> = taken;
        taken.into_iter().filter_map(|(_, value)| value).collect()
    }

    /// The files, when all options are taken: one at least.
    pub(super) fn files(self) -> Result<Vec<String>, Failure> {
        let files = self.no_options()?;
        if files.is_empty() { Err("name a file, or `-` for the standard input".into()) } else { Ok(files) }
    }

    /// The only file, when all options are taken.
    pub(super) fn file(self) -> Result<String, Failure> {
        let mut files = self.files()?;
        match files.len() {
            1 => Ok(files.remove(0)),
            _ => Err("one file at a time".into()),
        }
    }

    /// No file, and no option that is left.
    pub(super) fn nothing(self) -> Result<(), Failure> {
        match self.no_options()?.first() {
            Some(word) => Err(format!("{word} has no meaning here").into()),
            None => Ok(()),
        }
    }

    fn no_options(self) -> Result<Vec<String>, Failure> {
        match self.options.first() {
            Some((option, _)) => Err(format!("there is no option {option}").into()),
            None => Ok(self.files.into()),
        }
    }
}

/// Value after an option, which must not be an option.
fn value(option: &str, wanted: &str, parser: &mut Parser) -> Result<String, Failure> {
    if let Some(value) = parser.optional_value() {
        return text(value);
    }
    let is_value = parser
        .try_raw_args()
        .is_some_and(|words| words.peek().is_some_and(|word| !word.to_string_lossy().starts_with("--")));
    if is_value {
        text(parser.value()?)
    } else {
        Err(format!("{option} {wanted}: the value is missing").into())
    }
}

fn text(word: OsString) -> Result<String, Failure> {
    word.into_string().map_err(|word| format!("{} is not UTF-8", word.display()).into())
}

/// Names after an option, which commas separate: not those in brackets.
pub(super) fn names(texts: &[String]) -> Vec<String> {
    let mut all = Vec::new();
    for text in texts {
        let mut depth = 0;
        let apart = text.split(|letter| {
            depth += i32::from(letter == '[') - i32::from(letter == ']');
            letter == ',' && depth == 0
        });
        all.extend(apart.map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned));
    }
    all
}

/// Are all names known ones?
pub(super) fn known<'a>(
    option: &str,
    mut names: impl Iterator<Item = &'a str>,
    all: &[&str],
) -> Result<(), Failure> {
    match names.find(|name| !all.contains(name)) {
        Some(name) => Err(format!("{option}: there is no `{name}`; there are {}", all.join(", ")).into()),
        None => Ok(()),
    }
}
