//! Steps by extrapolation of the modified midpoint rule (W. B. Gragg, SIAM J. Numer. Anal. 2, 1965; E. Hairer, S. P. Nørsett,
//! G. Wanner, Solving Ordinary Differential Equations I, section II.9).

use super::run::State;

/// Numbers of substeps; one more would bring nothing in 16 digits.
const SUBSTEPS: [usize; 7] = [2, 4, 6, 8, 10, 12, 14];
const TOLERANCE: f64 = 2e-14;

/// The state after a step; none if the step is too long for its tolerance, or if the accelerations are not known.
pub fn step(from: &State, h: f64, accelerations: &impl Fn(&State) -> Option<Vec<f64>>) -> Option<State> {
    let first = accelerations(from)?;
    let mut table: Vec<Vec<f64>> = Vec::new();
    for (k, n) in SUBSTEPS.iter().enumerate() {
        let mut row = midpoint((from, &first), h, *n, accelerations)?;
        let mut before = row.clone();
        for (l, known) in table.iter_mut().enumerate() {
            // Row l of the table has what was extrapolated from the substeps k - 1 - l to k - 1.
            let ratio = (*n as f64 / SUBSTEPS[k - 1 - l] as f64).powi(2) - 1.0;
            let next: Vec<f64> = row.iter().zip(known.iter()).map(|(a, b)| a + (a - b) / ratio).collect();
            before = std::mem::replace(known, row);
            row = next;
        }
        let error = row.iter().zip(table.last().unwrap_or(&before));
        let error = error.fold(0.0, |error: f64, (a, b)| error.max((a - b).abs() / (1.0 + a.abs())));
        table.push(row);
        if k >= 2 && error < TOLERANCE {
            return Some(split(from, h, &table[k]));
        }
        let is_last = k + 1 == SUBSTEPS.len();
        if is_last && error < 50.0 * TOLERANCE {
            return Some(split(from, h, &table[k]));
        }
    }
    None
}

fn split(from: &State, h: f64, x: &[f64]) -> State {
    let n = from.q.len();
    State { t: from.t + h, q: x[..n].to_vec(), v: x[n..].to_vec() }
}

/// n substeps of the midpoint rule, with Gragg's smoothing at the end.
fn midpoint(
    (from, first): (&State, &[f64]),
    h: f64,
    n: usize,
    accelerations: &impl Fn(&State) -> Option<Vec<f64>>,
) -> Option<Vec<f64>> {
    let d = h / n as f64;
    let joined = |state: &State| -> Vec<f64> { state.q.iter().chain(&state.v).copied().collect() };
    let mut last = joined(from);
    let slope = |v: &[f64], a: &[f64]| -> Vec<f64> { v.iter().chain(a).copied().collect() };
    let mut now: Vec<f64> = last.iter().zip(slope(&from.v, first)).map(|(x, slope)| x + d * slope).collect();
    for k in 1..=n {
        let state = split(from, k as f64 * d, &now);
        let slope = slope(&state.v, &accelerations(&state)?);
        if k == n {
            return Some((0..now.len()).map(|i| 0.5 * (last[i] + now[i] + d * slope[i])).collect());
        }
        let next = (0..now.len()).map(|i| last[i] + 2.0 * d * slope[i]).collect();
        last = std::mem::replace(&mut now, next);
    }
    None
}
