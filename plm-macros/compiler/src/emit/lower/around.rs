//! Surroundings of statements.

use plm_cas::Expr;

/// Surroundings of the statements of a function.
pub(in crate::emit) struct Around<'a> {
    /// The names of its arguments.
    pub(in crate::emit) reserved: &'a [&'a str],
    /// Arrays among them are references, or values.
    pub(in crate::emit) by_reference: bool,
    /// The type of the numbers.
    pub(in crate::emit) scalar: &'a str,
    /// Angles of which the argument `DIRECT` says that their sines and cosines need no branch; `None` without such an argument.
    pub(in crate::emit) direct: Option<&'a [Expr]>,
    /// Is what repeats itself written as loops?
    pub(in crate::emit) rerolled: bool,
}

/// Form of constants that multiply or are divided.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Constants {
    /// Numbers of the scalar, `lit(2.0)`, as all other constants.
    Numbers,
    /// Factors, `by(2.0)`: numbers with derivatives take one product of each.
    Factors,
}
