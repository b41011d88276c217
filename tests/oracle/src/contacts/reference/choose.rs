//! All combinations of modes at a state that satisfy the laws.

use super::problem::{Mode, Problem};
use super::world::Law;

/// Below this fraction of its terms a margin is zero.
pub const ZERO: f64 = 1e-9;
/// So many combinations are tried at most.
const MOST: usize = 1 << 18;

/// A combination that satisfies all inequalities.
#[derive(Clone, Debug)]
pub struct Choice {
    pub modes: Vec<Mode>,
    /// Rows that rest by the others.
    pub carried: Vec<bool>,
    pub lambda: Vec<f64>,
    /// Accelerations of the rows.
    pub a: Vec<f64>,
    /// Margins that are zero: whether they rise is not known.
    pub marginal: Vec<usize>,
    /// Rows that could rest and move.
    pub moving: usize,
    /// How far what holds is from its limits.
    pub slack: f64,
}

/// Modes that a row may have, in the order of preference, and whether it rests.
#[derive(Clone, Debug)]
pub struct Allowed {
    pub modes: Vec<Mode>,
    pub rests: bool,
}

/// The margin of a row in a mode at the state of the problem, and the size of its terms; none where it has none.
pub fn margin(problem: &Problem, i: usize, mode: Mode, rests: bool, lambda: &[f64]) -> Option<(f64, f64)> {
    let (a, size) = problem.acceleration(i, lambda);
    let force = size / problem.d[i][i];
    match mode {
        Mode::Closed => Some((lambda[i], force)),
        Mode::Sticks => Some((stick(problem, i, lambda), force)),
        Mode::Off => None,
        _ if !rests => None,
        Mode::Backwards => Some((-a, size)),
        _ => Some((a, size)),
    }
}

/// How far a row that sticks is from its limits.
pub fn stick(problem: &Problem, i: usize, lambda: &[f64]) -> f64 {
    let Law::Rub(bound) = &problem.laws[i] else { return 0.0 };
    let [forwards, backwards] = [0, 1].map(|side| bound.adhesion * problem.bound(i, side, lambda));
    (lambda[i] + forwards).min(backwards - lambda[i])
}

/// A friction that has no bound in these modes.
fn is_off(problem: &Problem, modes: &[Mode], i: usize) -> bool {
    match &problem.laws[i] {
        Law::Rub(bound) => {
            let is_loose = bound.by.is_none_or(|(k, mu)| mu == 0.0 || modes[k] == Mode::Open);
            is_loose && bound.own == [0.0; 2] && bound.joint.is_none_or(|(_, _, share)| share == 0.0)
        }
        Law::Gap { .. } => false,
    }
}

/// All combinations; none if there are too many to be tried.
pub fn choices(problem: &Problem, allowed: &[Allowed], guess: &[f64]) -> Option<Vec<Choice>> {
    let gaps: Vec<usize> =
        (0..problem.count()).filter(|i| matches!(problem.laws[*i], Law::Gap { .. })).collect();
    let mut modes = vec![Mode::Off; problem.count()];
    let mut found = Vec::new();
    let mut tried = 0;
    over(&gaps, allowed, &mut modes, &mut |modes| {
        // The frictions that can have a force when these gaps are closed.
        let rubs: Vec<usize> = (0..problem.count())
            .filter(|i| matches!(problem.laws[*i], Law::Rub(_)) && !is_off(problem, modes, *i))
            .collect();
        let mut modes = modes.clone();
        (0..problem.count())
            .filter(|i| matches!(problem.laws[*i], Law::Rub(_)) && !rubs.contains(i))
            .for_each(|i| modes[i] = Mode::Off);
        over(&rubs, allowed, &mut modes, &mut |modes| {
            tried += 1;
            if tried <= MOST {
                found.extend(choice(problem, allowed, modes, guess));
            }
        });
    });
    (tried <= MOST).then_some(found)
}

/// Gives `each` every combination of modes of the rows `of`.
fn over(of: &[usize], allowed: &[Allowed], modes: &mut Vec<Mode>, each: &mut impl FnMut(&Vec<Mode>)) {
    let mut counter = vec![0; of.len()];
    loop {
        for (row, k) in of.iter().zip(&counter) {
            modes[*row] = allowed[*row].modes[*k];
        }
        each(modes);
        let mut place = 0;
        loop {
            if place == of.len() {
                return;
            }
            counter[place] += 1;
            if counter[place] < allowed[of[place]].modes.len() {
                break;
            }
            counter[place] = 0;
            place += 1;
        }
    }
}

fn choice(problem: &Problem, allowed: &[Allowed], modes: &[Mode], guess: &[f64]) -> Option<Choice> {
    let (lambda, _) = problem.forces(modes, guess)?;
    let n = problem.count();
    let a = (0..n).map(|i| problem.acceleration(i, &lambda).0).collect();
    let mut choice = Choice {
        modes: modes.to_vec(),
        carried: vec![false; n],
        lambda,
        a,
        marginal: Vec::new(),
        moving: 0,
        slack: 1.0,
    };
    for i in 0..n {
        let (mode, rests) = (modes[i], allowed[i].rests);
        let Some((value, size)) = margin(problem, i, mode, rests, &choice.lambda) else { continue };
        if !mode.holds() && value.abs() <= ZERO * size && problem.depends(i, modes) {
            choice.carried[i] = true;
            continue;
        }
        // Not a number is refused.
        let is_met = value >= -ZERO * size;
        if !is_met {
            return None;
        }
        if value <= ZERO * size {
            choice.marginal.push(i);
        }
        if mode.holds() {
            choice.slack = choice.slack.min(value / size);
        } else {
            choice.moving += 1;
        }
    }
    Some(choice)
}

/// Have two choices the same accelerations?
pub fn is_same(problem: &Problem, one: &Choice, other: &Choice) -> bool {
    let size = |i| problem.acceleration(i, &one.lambda).1.max(problem.acceleration(i, &other.lambda).1);
    // What is all rounding of the others differs by rounding.
    let largest = (0..problem.count()).map(size).fold(0.0, f64::max);
    (0..problem.count()).all(|i| (one.a[i] - other.a[i]).abs() <= 1e-7 * size(i) + 1e-12 * largest)
}
