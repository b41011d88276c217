//! Notices: elements of a file that could not be taken, with their places.

use std::fmt;
use std::rc::Rc;

/// A place in a file: line and column, in characters, from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The name of the file.
    pub file: Rc<str>,
    /// The line, from 1.
    pub line: u32,
    /// The column, in characters, from 1.
    pub column: u32,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// Weight of a notice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// The element is left out or replaced, as the message says.
    Warning,
    /// Without the element the motion would be another one: there is no declaration.
    Error,
}

/// An element that was not taken as it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// Its weight.
    pub level: Level,
    /// The place of the element.
    pub place: Place,
    /// The finding and its consequence.
    pub message: String,
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let level = match self.level {
            Level::Warning => "warning",
            Level::Error => "error",
        };
        write!(f, "{level}: {}\n --> {}", self.message, self.place)
    }
}

/// A mistake that has its notice.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Told;

/// The notices of an import, in the order in which they are found.
#[derive(Debug, Default)]
pub(crate) struct Notices(pub(crate) Vec<Notice>);

impl Notices {
    pub(crate) fn warn(&mut self, place: &Place, message: impl Into<String>) {
        self.add(Level::Warning, place, message.into());
    }

    pub(crate) fn error(&mut self, place: &Place, message: impl Into<String>) {
        self.add(Level::Error, place, message.into());
    }

    pub(crate) fn has_errors(&self) -> bool {
        self.0.iter().any(|notice| notice.level == Level::Error)
    }

    fn add(&mut self, level: Level, place: &Place, message: String) {
        self.0.push(Notice { level, place: place.clone(), message });
    }
}
