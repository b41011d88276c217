//! Impacts by Poisson's law: compression, then expansion that gives back a fraction of each normal impulse.

use super::choose::{Allowed, choices, is_same};
use super::problem::{Mode, Problem};
use super::world::Law;

/// Impulses of an impact.
pub enum Impulses {
    Found(Vec<f64>),
    /// Several with different rates after them.
    Ambiguous,
    /// Several distributions over the rows, of which restitution gives back different parts.
    Undetermined,
    Nothing,
}

/// The impulses of rows that touch.
pub fn poisson(problem: &Problem, touches: &[bool]) -> Impulses {
    let rates = problem.of_rates();
    let n = rates.count();
    let allowed: Vec<Allowed> = (0..n).map(|i| allowed(&rates.laws[i], touches[i])).collect();
    let compression = match only(&rates, &allowed) {
        Ok((lambda, is_unique)) if is_unique => lambda,
        Ok(_) => return Impulses::Undetermined,
        Err(other) => return other,
    };
    let back: Vec<f64> = (0..n)
        .map(|i| match rates.laws[i] {
            Law::Gap { restitution } => restitution * compression[i],
            Law::Rub(_) => 0.0,
        })
        .collect();
    if back.iter().all(|impulse| *impulse == 0.0) {
        return Impulses::Found(compression);
    }
    let mut expansion = rates.clone();
    for i in 0..n {
        let given: f64 = rates.d[i].iter().zip(&back).map(|(d, back)| d * back).sum();
        expansion.c[i] = rates.acceleration(i, &compression).0 + given;
        if let Law::Rub(bound) = &mut expansion.laws[i] {
            let given = bound.by.map_or(0.0, |(k, mu)| mu * back[k]);
            bound.own = [given; 2];
        }
    }
    for joint in &mut expansion.joints {
        joint.own = joint.at(&back);
    }
    match only(&expansion, &allowed) {
        Ok((lambda, _)) => Impulses::Found((0..n).map(|i| compression[i] + back[i] + lambda[i]).collect()),
        Err(other) => other,
    }
}

fn allowed(law: &Law, touches: bool) -> Allowed {
    let modes = match (law, touches) {
        (Law::Gap { .. }, true) => vec![Mode::Closed, Mode::Open],
        (Law::Gap { .. }, false) => vec![Mode::Open],
        (Law::Rub(_), _) => vec![Mode::Sticks, Mode::Forwards, Mode::Backwards],
    };
    Allowed { modes, rests: touches || matches!(law, Law::Rub(_)) }
}

/// The impulses, and whether what restitution gives back is unique.
fn only(problem: &Problem, allowed: &[Allowed]) -> Result<(Vec<f64>, bool), Impulses> {
    let guess = vec![1.0; problem.count()];
    let found = choices(problem, allowed, &guess).ok_or(Impulses::Nothing)?;
    let best = found
        .iter()
        .reduce(|a, b| if (b.moving, -b.slack) < (a.moving, -a.slack) { b } else { a })
        .ok_or(Impulses::Nothing)?;
    if found.iter().any(|other| !is_same(problem, best, other)) {
        return Err(Impulses::Ambiguous);
    }
    let size = best.lambda.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let gives = |i: &usize| matches!(problem.laws[*i], Law::Gap { restitution } if restitution > 0.0);
    let is_unique = (0..problem.count())
        .filter(gives)
        .all(|i| found.iter().all(|other| (other.lambda[i] - best.lambda[i]).abs() <= 1e-7 * size));
    Ok((best.lambda.clone(), is_unique))
}
