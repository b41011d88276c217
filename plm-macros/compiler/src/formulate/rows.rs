//! Places of the numbers of rows of contact, as the runtime has them.

use std::fmt;

/// A number of the rows of contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfRows {
    /// The gap, or the displacement, of a row.
    Gap(usize),
    /// Its rate.
    Rate(usize),
    /// Its acceleration without contact forces.
    Free(usize),
    /// The part of that which no acceleration gives.
    Bias(usize),
    /// An entry of the Delassus operator.
    Delassus(usize, usize),
    /// A limit of a friction.
    Limit {
        /// The row.
        row: usize,
        /// The limit while it sticks, else while it slips.
        sticks: bool,
        /// The limit of its force to the positive side, else to the negative one.
        upper: bool,
        /// The term of it.
        term: RowTerm,
    },
    /// A reaction that bounds frictions.
    Reaction {
        /// Its number.
        load: usize,
        /// 0 or 1.
        component: usize,
        /// The term of it.
        term: RowTerm,
    },
}

/// A term of what is affine in multipliers and sizes of reactions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowTerm {
    /// The part that does not depend on them.
    Own,
    /// The factor of the multiplier of a row.
    By(usize),
    /// The factor of the size of a reaction.
    Share(usize),
}

/// The place in Rust.
impl fmt::Display for OfRows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Gap(row) => write!(f, "rows.gap[{row}]"),
            Self::Rate(row) => write!(f, "rows.rate[{row}]"),
            Self::Free(row) => write!(f, "rows.free[{row}]"),
            Self::Bias(row) => write!(f, "rows.bias[{row}]"),
            Self::Delassus(row, column) => write!(f, "rows.delassus[{row}][{column}]"),
            Self::Limit { row, sticks, upper, term } => {
                let limits = if sticks { "adhesion" } else { "kinetic" };
                let side = if upper { "upper" } else { "lower" };
                write!(f, "rows.{limits}[{row}].{side}.{term}")
            }
            Self::Reaction { load, component, term } => {
                write!(f, "rows.reaction[{load}][{component}].{term}")
            }
        }
    }
}

impl fmt::Display for RowTerm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Own => f.write_str("own"),
            Self::By(row) => write!(f, "by[{row}]"),
            Self::Share(load) => write!(f, "share[{load}]"),
        }
    }
}
