//! The versions of the standard, and what each calls its functions.
//!
//! Everything else stands once for both versions. The C functions of a version are a text beside this file.

use core::fmt;

use super::Call;

/// A version of the standard.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Version {
    /// FMI 2.0 (2.0.5).
    Two,
    /// FMI 3.0 (3.0.2).
    #[default]
    Three,
}

impl Version {
    /// As `fmiVersion` has it.
    pub fn number(self) -> &'static str {
        match self {
            Self::Two => "2.0",
            Self::Three => "3.0",
        }
    }

    /// One of the two.
    pub(super) fn pick<T>(self, two: T, three: T) -> T {
        match self {
            Self::Two => two,
            Self::Three => three,
        }
    }
}

/// The name of a function in a version.
pub(super) struct Function(pub(super) Version, pub(super) Call);

impl fmt::Display for Function {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(version, call) = *self;
        let own = match call {
            Call::Get => version.pick("fmi2GetReal", "fmi3GetFloat64"),
            Call::Set => version.pick("fmi2SetReal", "fmi3SetFloat64"),
            Call::UpdateDiscreteStates => version.pick("fmi2NewDiscreteStates", "fmi3UpdateDiscreteStates"),
            Call::GetContinuousStateDerivatives => {
                version.pick("fmi2GetDerivatives", "fmi3GetContinuousStateDerivatives")
            }
            call => return write!(f, "fmi{}{call:?}", version.pick(2, 3)),
        };
        f.write_str(own)
    }
}
