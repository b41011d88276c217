//! Rows of one width.

/// Numbers in rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Table {
    width: usize,
    numbers: Vec<f64>,
}

impl Table {
    pub(crate) fn new(width: usize) -> Self {
        Self { width, numbers: Vec::new() }
    }

    pub(crate) fn width(&self) -> usize {
        self.width
    }

    pub(crate) fn numbers(&self) -> &[f64] {
        &self.numbers
    }

    /// Adds a row of this width: gaps where it is shorter.
    pub(crate) fn push(&mut self, row: &[f64]) {
        let row = row.iter().copied().chain(std::iter::repeat(f64::NAN));
        self.numbers.extend(row.take(self.width));
    }

    /// Takes so many rows, with gaps after those that there are.
    pub(crate) fn fill(&mut self, mut numbers: Vec<f64>, rows: usize) {
        let length = rows * self.width;
        // Not twice as much as is needed.
        numbers.reserve_exact(length.saturating_sub(numbers.len()));
        numbers.resize(length, f64::NAN);
        self.numbers = numbers;
    }

    /// A row; nothing beyond the last.
    pub(crate) fn row(&self, row: usize) -> &[f64] {
        self.numbers.get(row * self.width..).and_then(|rest| rest.get(..self.width)).unwrap_or_default()
    }
}
