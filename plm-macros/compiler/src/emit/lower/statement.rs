//! Statements, and what they read and make.

use plm_cas::Count;

/// A statement and what it needs.
pub(super) enum Statement {
    /// A comment above what follows.
    Title(String),
    /// `let name = array[element];`, of an argument.
    Read { local: usize, array: String, element: usize },
    /// `let name = value;` (`name` may be a pattern).
    Let { makes: Vec<usize>, pattern: String, value: String, reads: Vec<usize> },
    /// `place = value;`
    Store { place: String, value: String, reads: Vec<usize> },
    /// Lines by themselves, which make nothing but elements of arrays.
    Block { text: String, reads: Vec<usize> },
}

/// A lowered function.
pub(super) struct Lines {
    /// Arrays of intermediate values, which stand in front: names and lengths.
    pub(super) arrays: Vec<(String, usize)>,
    /// Statements in order.
    pub(super) statements: Vec<Statement>,
    /// The value that the function returns and the locals that it reads.
    pub(super) value: Option<(String, Vec<usize>)>,
    /// Names of the locals, by their numbers.
    pub(super) locals: Vec<String>,
    /// Operations of one call.
    pub(super) count: Count,
}

impl Statement {
    /// Locals that the statement reads.
    pub(super) fn reads(&self) -> impl Iterator<Item = usize> {
        let reads: &[usize] = match self {
            Statement::Title(_) | Statement::Read { .. } => &[],
            Statement::Let { reads, .. }
            | Statement::Store { reads, .. }
            | Statement::Block { reads, .. } => reads,
        };
        reads.iter().copied()
    }

    /// Locals that the statement makes.
    pub(super) fn makes(&self) -> impl Iterator<Item = usize> {
        let makes: &[usize] = match self {
            Statement::Read { local, .. } => std::slice::from_ref(local),
            Statement::Let { makes, .. } => makes,
            Statement::Title(_) | Statement::Store { .. } | Statement::Block { .. } => &[],
        };
        makes.iter().copied()
    }
}
