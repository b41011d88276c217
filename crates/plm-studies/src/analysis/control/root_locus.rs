//! Root locus: how poles move with a parameter.

use nalgebra::Complex;

use crate::analysis::Linearisation;

/// Poles over a parameter, each as a branch.
#[derive(Clone, Debug, PartialEq)]
pub struct RootLocus {
    /// Values of the parameter.
    pub values: Vec<f64>,
    /// Of each branch the poles at these values, 1/s.
    pub branches: Vec<Vec<Complex<f64>>>,
}

/// Poles over values of a parameter; `system` linearises the mechanism with each. The poles of a value continue those before it along
/// straight lines, the nearest first, so that branches may cross. All systems have as many states.
///
/// # Errors
/// The first error of `system`.
pub fn root_locus<E>(
    values: impl IntoIterator<Item = f64>,
    mut system: impl FnMut(f64) -> Result<Linearisation, E>,
) -> Result<RootLocus, E> {
    let mut all = RootLocus { values: Vec::new(), branches: Vec::new() };
    for value in values {
        let poles = system(value)?.poles();
        if all.values.is_empty() {
            all.branches = poles.into_iter().map(|pole| vec![pole]).collect();
        } else {
            all.continued(value, poles);
        }
        all.values.push(value);
    }
    Ok(all)
}

impl RootLocus {
    /// Gives each branch one of the poles at the next value.
    fn continued(&mut self, value: f64, mut poles: Vec<Complex<f64>>) {
        let expected: Vec<_> = self.branches.iter().map(|branch| self.expected(branch, value)).collect();
        let mut open: Vec<usize> = (0..expected.len()).collect();
        while !open.is_empty() && !poles.is_empty() {
            let mut nearest = (f64::INFINITY, 0, 0);
            for (k, branch) in open.iter().enumerate() {
                for (j, pole) in poles.iter().enumerate() {
                    let distance = (pole - expected[*branch]).norm();
                    nearest = if distance < nearest.0 { (distance, k, j) } else { nearest };
                }
            }
            let (_, k, j) = nearest;
            let (branch, pole) = (open.swap_remove(k), poles.swap_remove(j));
            self.branches[branch].push(pole);
        }
        // A system with fewer states has no pole for this branch.
        for branch in open {
            let none = Complex::new(f64::NAN, f64::NAN);
            self.branches[branch].push(none);
        }
    }

    /// Pole of a branch at a value, extrapolated on a straight line through the last two; the last one if it is the only one.
    fn expected(&self, branch: &[Complex<f64>], value: f64) -> Complex<f64> {
        let n = self.values.len();
        let [Some(last), before] = [branch.last(), n.checked_sub(2).and_then(|k| branch.get(k))] else {
            return Complex::new(0.0, 0.0);
        };
        let Some(before) = before else { return *last };
        let [from, to] = [self.values[n - 2], self.values[n - 1]];
        let share = if to == from { 0.0 } else { (value - to) / (to - from) };
        last + (last - before) * share
    }
}
