//! Messages to the simulator.

use alloc::ffi::CString;
use alloc::vec::Vec;
use core::ffi::{CStr, c_char, c_void};
use core::fmt;

use super::{DISCARD, ERROR, Outcome, WARNING};
use crate::Text;
use crate::fmi::Version;

/// Severity of a message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Severity {
    /// It was done; the user should know something of it.
    Warning,
    /// Another step may do.
    Discard,
    /// It was called wrongly, or nothing else will do.
    Error,
}

impl Severity {
    pub(super) const ALL: [Self; 3] = [Self::Warning, Self::Discard, Self::Error];

    pub(super) fn outcome(self) -> Outcome {
        match self {
            Self::Warning => WARNING,
            Self::Discard => DISCARD,
            Self::Error => ERROR,
        }
    }

    /// The category of its messages.
    fn category(self) -> &'static CStr {
        match self {
            Self::Warning => c"logStatusWarning",
            Self::Discard => c"logStatusDiscard",
            Self::Error => c"logStatusError",
        }
    }

    /// That of a category.
    pub(super) fn of(category: &CStr) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.category() == category)
    }
}

/// `fmi3LogMessageCallback`
pub type Log = Option<unsafe extern "C" fn(*mut c_void, Outcome, *const c_char, *const c_char)>;

/// `fmi2CallbackLogger`; the message is a format.
pub type Log2 =
    Option<unsafe extern "C" fn(*mut c_void, *const c_char, Outcome, *const c_char, *const c_char, ...)>;

/// Receiver of messages.
enum Whom {
    Three(Log),
    /// With the name of the instance.
    Two(Log2, CString),
}

/// A simulator's function for messages, with what it is called with.
pub struct Listener {
    whom: Whom,
    environment: *mut c_void,
    /// Messages that are wanted.
    heard: Vec<Severity>,
}

impl Listener {
    /// That of 3.0.
    pub fn three(log: Log, environment: *mut c_void) -> Self {
        Self { whom: Whom::Three(log), environment, heard: Severity::ALL.into() }
    }

    /// That of 2.0, with the name of the instance.
    pub fn two(log: Log2, environment: *mut c_void, name: &CStr) -> Self {
        Self { whom: Whom::Two(log, name.into()), environment, heard: Severity::ALL.into() }
    }

    /// The version whose functions are called.
    pub(super) fn version(&self) -> Version {
        match self.whom {
            Whom::Two(..) => Version::Two,
            Whom::Three(_) => Version::Three,
        }
    }

    /// Messages of these are wanted from now on, or not.
    pub(super) fn hear(&mut self, is_heard: bool, of: &[Severity]) {
        self.heard.retain(|own| !of.contains(own));
        if is_heard {
            self.heard.extend(of);
        }
    }

    /// Sends a message to the simulator.
    ///
    /// # Safety
    /// The function may be called with the environment.
    pub(super) unsafe fn tell(&self, severity: Severity, what: impl fmt::Display) {
        if !self.heard.contains(&severity) {
            return;
        }
        let (status, category) = (severity.outcome(), severity.category().as_ptr());
        match &self.whom {
            Whom::Three(Some(log)) => {
                // SAFETY: the caller's part.
                unsafe { log(self.environment, status, category, Text::of(what).as_ptr()) };
            }
            Whom::Two(Some(log), name) => {
                let text = Text::of(Format(what));
                // SAFETY: the caller's part.
                unsafe { log(self.environment, name.as_ptr(), status, category, text.as_ptr()) };
            }
            Whom::Three(None) | Whom::Two(None, _) => {}
        }
    }
}

/// A text as a format that prints it.
struct Format<T>(T);

impl<T: fmt::Display> fmt::Display for Format<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        /// Writes percent signs twice.
        struct Twice<'a, 'b>(&'a mut fmt::Formatter<'b>);
        impl fmt::Write for Twice<'_, '_> {
            fn write_str(&mut self, words: &str) -> fmt::Result {
                words.split('%').enumerate().try_for_each(|(k, words)| {
                    self.0.write_str(if k > 0 { "%%" } else { "" })?;
                    self.0.write_str(words)
                })
            }
        }
        fmt::Write::write_fmt(&mut Twice(f), format_args!("{}", self.0))
    }
}
