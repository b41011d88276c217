//! Words of a command line: options and files.

use std::collections::VecDeque;
use std::ffi::OsString;

use lexopt::{Arg, Parser};

use super::Failure;

/// The words, options apart from files; behind `--` all words are files.
pub(super) struct Words {
    options: Vec<String>,
    files: VecDeque<String>,
}

impl Words {
    pub(super) fn new(words: impl Iterator<Item = OsString>) -> Result<Words, Failure> {
        let mut parser = Parser::from_args(words);
        let (mut options, mut files) = (Vec::new(), VecDeque::new());
        while let Some(word) = parser.next()? {
            match word {
                Arg::Short(letter) => options.push(format!("-{letter}")),
                Arg::Long(name) => options.push(format!("--{name}")),
                Arg::Value(word) => {
                    files.push_back(
                        word.into_string().map_err(|word| format!("{} is not UTF-8", word.display()))?,
                    );
                }
            }
        }
        Ok(Words { options, files })
    }

    /// The next word, as the name of a command.
    pub(super) fn command(&mut self) -> Result<Option<String>, Failure> {
        match self.options.first().map(String::as_str) {
            Some("--version" | "-V") => return Ok(Some("version".to_owned())),
            Some("--help" | "-h") if self.files.is_empty() => return Ok(Some("help".to_owned())),
            Some(option) if self.files.is_empty() => {
                return Err(format!("there is no option {option}").into());
            }
            _ => {}
        }
        Ok(self.files.pop_front())
    }

    pub(super) fn asks_for_help(&self) -> bool {
        self.options.iter().any(|option| option == "--help" || option == "-h")
    }

    /// Takes an option out: is it there?
    pub(super) fn takes(&mut self, option: &str) -> bool {
        let count = self.options.len();
        self.options.retain(|given| given != option);
        self.options.len() < count
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
            Some(option) => Err(format!("there is no option {option}").into()),
            None => Ok(self.files.into()),
        }
    }
}
