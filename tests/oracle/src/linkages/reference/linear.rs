//! The symmetric system `(phi_q W phi_q^T) x = r` by elimination with diagonal pivots.
//!
//! N. J. Higham, Accuracy and Stability of Numerical Algorithms (2002), section 10.3. Rows that others repeat leave a pivot
//! of nothing but rounding; they are left out, and their multipliers are zero.

use super::dd::Dd;

/// A pivot below so much of its row's own size is rounding.
const RANK: f64 = 1e-25;

/// A decomposition `P A P^T = L D L^T`.
pub struct Factor {
    size: usize,
    /// Rows in the order of elimination.
    order: Vec<usize>,
    /// How many of them are independent.
    pub rank: usize,
    /// Lower triangle in the order of elimination, row by row.
    lower: Vec<Dd>,
    inverse: Vec<Dd>,
    /// The smallest pivot that was kept, as a fraction of its row's own size: how near to a singular pose it is.
    pub least: f64,
}

impl Factor {
    /// Of the rows `phi_q`, with weights of the coordinates.
    pub fn new(rows: &[Vec<(usize, Dd)>], weights: &[Dd]) -> Self {
        let size = rows.len();
        let mut dense = vec![Dd::ZERO; weights.len()];
        let mut a = vec![Dd::ZERO; size * size];
        for (i, row) in rows.iter().enumerate() {
            for (index, value) in row {
                dense[*index] = *value * weights[*index];
            }
            for (j, other) in rows.iter().enumerate().take(i + 1) {
                let mut sum = Dd::ZERO;
                for (index, value) in other {
                    if dense[*index].hi != 0.0 {
                        sum += dense[*index] * *value;
                    }
                }
                a[i * size + j] = sum;
                a[j * size + i] = sum;
            }
            for (index, _) in row {
                dense[*index] = Dd::ZERO;
            }
        }
        Self::eliminate(size, a)
    }

    fn eliminate(size: usize, mut a: Vec<Dd>) -> Self {
        let own: Vec<f64> = (0..size).map(|i| a[i * size + i].hi).collect();
        let mut order: Vec<usize> = (0..size).collect();
        let (mut inverse, mut rank, mut least) = (vec![Dd::ZERO; size], 0, 1.0_f64);
        for k in 0..size {
            let health = |row: usize| a[row * size + row].hi / own[row];
            let best = (k..size).max_by(|i, j| health(order[*i]).total_cmp(&health(order[*j])));
            let Some(best) = best.filter(|best| health(order[*best]) > RANK) else { break };
            least = least.min(health(order[best]));
            order.swap(k, best);
            let pivot = order[k];
            inverse[k] = Dd::ONE / a[pivot * size + pivot];
            rank += 1;
            for i in k + 1..size {
                let row = order[i];
                let factor = a[row * size + pivot] * inverse[k];
                if factor.hi == 0.0 {
                    continue;
                }
                for &column in &order[k + 1..=i] {
                    let new = a[row * size + column] - factor * a[pivot * size + column];
                    a[row * size + column] = new;
                    a[column * size + row] = new;
                }
                // Read no more by the elimination: the factor takes its place.
                a[row * size + pivot] = factor;
            }
        }
        let mut lower = vec![Dd::ZERO; size * size];
        for i in 0..size {
            for k in 0..i.min(rank) {
                lower[i * size + k] = a[order[i] * size + order[k]];
            }
        }
        Self { size, order, rank, lower, inverse, least }
    }

    /// Solves in place.
    pub fn solve(&self, r: &mut [Dd]) {
        let mut y: Vec<Dd> = self.order.iter().take(self.rank).map(|row| r[*row]).collect();
        for i in 0..self.rank {
            let row = &self.lower[i * self.size..];
            let mut sum = y[i];
            for k in 0..i {
                if row[k].hi != 0.0 {
                    sum -= row[k] * y[k];
                }
            }
            y[i] = sum;
        }
        for i in (0..self.rank).rev() {
            let mut sum = y[i] * self.inverse[i];
            for k in i + 1..self.rank {
                let factor = self.lower[k * self.size + i];
                if factor.hi != 0.0 {
                    sum -= factor * y[k];
                }
            }
            y[i] = sum;
        }
        r.fill(Dd::ZERO);
        for (row, value) in self.order.iter().zip(y) {
            r[*row] = value;
        }
    }
}
