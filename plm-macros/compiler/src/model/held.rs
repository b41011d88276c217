//! Discrete state: sides of conditions, with the jumps where they change, and whole revolutions.

use plm_cas::Expr;

/// A condition `difference < 0` whose side is held over a step.
#[derive(Clone, Debug)]
pub struct Switch {
    /// Stands for the side: -1 where the condition holds, else 1.
    pub symbol: Expr,
    /// The expression that changes its sign.
    pub difference: Expr,
    /// Its side does not change as long as this is positive either.
    pub beyond: Option<Expr>,
    /// The time at which it does, s, and the slope of the difference there, if it depends on the time alone.
    pub instant: Option<[Expr; 2]>,
    /// The part or state that jumps; the requirement.
    pub name: String,
    /// The condition as it was written; empty of a requirement, which has a name.
    pub text: String,
    /// Why the run ends where it changes, if it does.
    pub end: Option<End>,
    /// It must not change: a requirement, positive as long as it holds.
    pub must_hold: bool,
}

/// Why a run ends where an expression passes zero.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// Something is divided by it, as it is printed.
    Pole(String),
    /// A function, as it is printed, is defined on one side alone.
    Domain(String),
}

impl End {
    /// Is it the end of a domain?
    pub fn is_domain(&self) -> bool {
        matches!(self, End::Domain(_))
    }
}

/// A comparison as it was written.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The two sides of the comparison, left and right.
    pub of: [Expr; 2],
    /// `bend > limit`
    pub text: String,
}

/// When conditions of the state matter, and kinks, given the sides that are held: as decision diagrams. A node asks a side, and says which
/// node follows where its condition holds, and where it does not; 0 stands for "does not matter", 1 for "matters", and nodes
/// are counted from 2 on.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Decisions {
    /// An index into [`Model::switches`](super::Model::switches), and what follows on either side.
    pub nodes: Vec<(usize, usize, usize)>,
    /// Roots of the diagrams, by condition of the state, then by kink; none if all of them matter always.
    pub roots: Vec<usize>,
}

/// Angles whose whole turns are counted together: their bodies turn as one.
#[derive(Clone, Debug)]
pub struct Counted {
    /// Stands for the number of turns.
    pub symbol: Expr,
    /// Indices into [`Model::bodies`](super::Model::bodies), ascending.
    pub bodies: Vec<usize>,
}

/// A row whose place or speed may jump where a condition changes its side.
#[derive(Clone, Debug)]
pub struct Jump {
    /// Index into [`Model::switches`](super::Model::switches).
    pub switch: usize,
    /// Index into [`Model::rows`](super::Model::rows).
    pub row: usize,
    /// The row's phi on one side less that on the other, its first and second derivative along the motion; what
    /// changes its sign at the boundary, and its derivative.
    pub terms: [Expr; 5],
    /// The side that it always has, if that is known.
    pub steady: Option<Steady>,
}

/// A jump that happens in every run that comes so far.
#[derive(Clone, Copy, Debug)]
pub struct Steady {
    /// When, s.
    pub at: f64,
    /// By how much, in the row's unit, or that over s.
    pub by: f64,
    /// The speed jumps, not the place.
    pub of_speed: bool,
}
