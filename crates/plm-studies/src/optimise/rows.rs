//! Rows of a matrix, one after another.

use nalgebra::{DMatrix, DVector};

/// Rows of a matrix that grows.
#[derive(Default)]
pub(crate) struct Rows {
    values: Vec<f64>,
    entries: Vec<Vec<(usize, f64)>>,
}

impl Rows {
    pub(crate) fn push(&mut self, value: f64, by: impl Iterator<Item = (usize, f64)>) {
        self.values.push(value);
        self.entries.push(by.collect());
    }

    #[cfg(feature = "optimal-control")]
    pub(crate) fn len(&self) -> usize {
        self.values.len()
    }

    pub(crate) fn matrices(self, columns: usize) -> (DVector<f64>, DMatrix<f64>) {
        let mut matrix = DMatrix::zeros(self.values.len(), columns);
        for (row, entries) in self.entries.iter().enumerate() {
            for (column, entry) in entries {
                matrix[(row, *column)] += entry;
            }
        }
        (DVector::from_vec(self.values), matrix)
    }
}
