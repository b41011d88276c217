//! Values and derivatives of the nonlinear program at a point.

use nalgebra::{DMatrix, DVector};

use crate::optimise::rows::Rows;

/// Values of the program at a point, with their derivatives by rows.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    /// The cost is the sum of their squares, ...
    pub(crate) squares: DVector<f64>,
    pub(crate) squares_by: DMatrix<f64>,
    /// ... and this.
    pub(crate) linear: f64,
    pub(crate) linear_by: DVector<f64>,
    /// Values of equality constraints.
    pub(crate) equal: DVector<f64>,
    pub(crate) equal_by: DMatrix<f64>,
    /// Values of inequality constraints, which have bounds.
    pub(crate) within: DVector<f64>,
    pub(crate) within_by: DMatrix<f64>,
    pub(crate) limits: Vec<[f64; 2]>,
    /// The segment of each row of squares, of equality and of inequality constraints.
    pub(crate) owners: [Vec<usize>; 3],
    /// The variables that each segment depends on.
    pub(crate) columns: Vec<Vec<usize>>,
}

impl Values {
    /// The cost.
    pub(crate) fn cost(&self) -> f64 {
        self.squares.norm_squared() + self.linear
    }
}

/// Parts of the program that grow.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) squares: Rows,
    pub(super) linear: f64,
    pub(super) linear_by: DVector<f64>,
    pub(super) equal: Rows,
    pub(super) within: Rows,
    pub(super) limits: Vec<[f64; 2]>,
    pub(super) owners: [Vec<usize>; 3],
    pub(super) columns: Vec<Vec<usize>>,
}

impl Parts {
    /// Assigns rows without a segment to this one.
    pub(super) fn own_up_to(&mut self, segment: usize) {
        let counts = [self.squares.len(), self.equal.len(), self.within.len()];
        for (owners, count) in self.owners.iter_mut().zip(counts) {
            owners.resize(count, segment);
        }
    }
    /// All rows as matrices.
    pub(super) fn values(self) -> Values {
        let columns = self.linear_by.len();
        let (squares, squares_by) = self.squares.matrices(columns);
        let (equal, equal_by) = self.equal.matrices(columns);
        let (within, within_by) = self.within.matrices(columns);
        let Self { linear, linear_by, limits, owners, columns, .. } = self;
        Values {
            squares,
            squares_by,
            linear,
            linear_by,
            equal,
            equal_by,
            within,
            within_by,
            limits,
            owners,
            columns,
        }
    }
}
