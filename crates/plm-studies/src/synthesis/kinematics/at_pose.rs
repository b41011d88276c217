//! Mobility of a mechanism where a simulation is, from the equations that it runs by.

use plm_runtime::{AsMoment, Moment, Statics, Vector};

use super::Mobility;

/// Norm of a row beside those before it, as a fraction of its own, below which they imply it.
const IMPLIED: f64 = 1e-9;

/// Mobility of a mechanism at a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MobilityAt {
    /// Degrees of freedom, with prescribed motions as rows.
    pub mobility: Mobility,
    /// Names of the rows that those before them imply, as `pivot.x`.
    pub redundant: Vec<&'static str>,
}

/// Mobility of any mechanism where a simulation is, compiled or from text: by the rank of its velocity equations `phi_q v = nu`, whose
/// coefficients are read from the equations by unit velocities. Rows are taken with coordinates in units of the mechanism's size.
///
/// Rows of contact are no constraints of it, whether they hold or not.
pub fn mobility_at<A, T>(of: &A) -> MobilityAt
where
    A: AsMoment<State = T>,
    T: Moment<M: Statics<State = T, S = f64>>,
{
    let state = of.as_moment();
    let mechanism = state.mechanism();
    let names = mechanism.row_names();
    let coordinates = mechanism.coordinate_names().len();
    let at_rest = velocity_rows(state, None);
    let mut rows = vec![vec![0.0; coordinates]; names.len()];
    for column in 0..coordinates {
        let unit = if column % 3 == 2 { 1.0 / mechanism.size() } else { 1.0 };
        let moving = velocity_rows(state, Some(column));
        for (row, (moving, at_rest)) in rows.iter_mut().zip(moving.iter().zip(&at_rest)) {
            row[column] = (moving - at_rest) * unit;
        }
    }
    let implied = implied(rows);
    let rank = names.len() - implied.len();
    MobilityAt {
        mobility: Mobility {
            counted: coordinates as isize - names.len() as isize,
            at_pose: coordinates - rank,
            redundant: implied.len(),
        },
        redundant: implied.into_iter().map(|row| names[row]).collect(),
    }
}

/// `phi_q v - nu` with the velocity of one coordinate as 1, of the others as 0.
fn velocity_rows<T: Moment<M: Statics<State = T, S = f64>>>(state: &T, moving: Option<usize>) -> Vec<f64> {
    let mechanism = state.mechanism();
    let (coordinates, rows) = (mechanism.coordinate_names().len(), mechanism.row_names().len());
    let full = T::M::full(state);
    let velocities = coordinates..2 * coordinates;
    let x = Vector::from_fn(|k| match moving {
        _ if !velocities.contains(&k) => full.at(k),
        Some(column) if k == coordinates + column => 1.0,
        _ => 0.0,
    });
    let multipliers = Vector::from_fn(|_| 0.0);
    let mut values = Vec::new();
    mechanism.equations(state.time(), &state.held(), &x, &multipliers, &mut |value| values.push(value));
    // Forces stand first, then phi.
    values.into_iter().skip(coordinates + rows).take(rows).collect()
}

/// Rows that those before them imply: what is left of each beside an orthonormal basis of the others (Gram and Schmidt, twice).
fn implied(rows: Vec<Vec<f64>>) -> Vec<usize> {
    let norm = |row: &[f64]| row.iter().map(|x| x * x).sum::<f64>().sqrt();
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let mut found = Vec::new();
    for (number, mut row) in rows.into_iter().enumerate() {
        let before = norm(&row);
        for _ in 0..2 {
            for other in &basis {
                let along: f64 = row.iter().zip(other).map(|(a, b)| a * b).sum();
                for (a, b) in row.iter_mut().zip(other) {
                    *a -= along * b;
                }
            }
        }
        let left = norm(&row);
        if left <= IMPLIED * before {
            found.push(number);
        } else {
            for x in &mut row {
                *x /= left;
            }
            basis.push(row);
        }
    }
    found
}
