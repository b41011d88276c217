//! What is held over a step: sides of conditions, with what jumps where they change, and whole turns.

use plm_cas::Expr;

/// A condition `difference < 0` whose side is held over a step.
#[derive(Clone, Debug)]
pub struct Switch {
    /// Stands for the side: -1 where the condition holds, else 1.
    pub symbol: Expr,
    /// What changes its sign.
    pub difference: Expr,
    /// The time at which it does, s, and the slope of the difference there, if it depends on the time alone.
    pub instant: Option<[Expr; 2]>,
    /// The part or state that jumps; the requirement.
    pub name: String,
    /// It must not change: a requirement, positive as long as it holds.
    pub must_hold: bool,
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
    /// What is known of it already.
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
