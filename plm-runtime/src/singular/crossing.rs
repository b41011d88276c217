//! A step over a singular pose, by collocation: the rate is asked for at the nodes alone, which lie on both sides of it.

use super::ExtendedPrecision;
use super::collocation::{NODES, Polynomial, place};
use super::equations::Equations;
use super::size;
use crate::scalar::{Real, Scalar};
use crate::tolerances::{
    AGREES, CLOSED_ON_THE_WAY, COLLOCATION_STEPS, DISAGREE_BY_ROUNDING, FEW_ROWS, FOUND, SPREAD, STAGNATED,
    UNDECIDED, half_of_digits,
};
use crate::vector::Vector;

/// Why there is no step over a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Refused<S> {
    /// The joints would open by this, m: the pose is passed by.
    Opens(S),
    /// The joints would open by so little, m, that rounding decides where the motion goes on.
    Undecided(S),
    /// It is derived by lengths with which there is no such pose.
    HasNoDerivative,
    /// The step is too long, or a node is too near to the pose.
    NotFound,
}

/// The motion over the next `h` seconds.
pub(super) fn cross<M, const NQ: usize, const NC: usize, const NX: usize>(
    equations: &Equations<M, NQ, NC, NX>,
    (t, held): (M::S, &M::U),
    (from, rate): (&[M::S; NX], Option<&[M::S; NX]>),
    (h, evaluations): (M::S, &mut u64),
) -> Result<Polynomial<M::S, NX>, Refused<M::S>>
where
    M: ExtendedPrecision<NQ, NC, NX>,
{
    let nodes: [M::S; NODES] = Vector::from_fn(|j| M::S::lit(place(j)));
    let mut states = nodes.map(|c| guess::<_, NQ, NX>(from, rate, c * h));
    let mut before = M::S::INFINITY;
    for _ in 0..COLLOCATION_STEPS {
        let (mut rates, mut beside, mut disagree) = ([[M::S::ZERO; NX]; NODES], true, M::S::ZERO);
        for (rate, (x, c)) in rates.iter_mut().zip(states.iter().zip(nodes)) {
            let evaluated = equations.evaluate(t + c * h, held, x).ok_or(Refused::NotFound)?;
            beside &= equations.is_beside(x, &evaluated);
            disagree = disagree.max(equations.gap(t + c * h, &evaluated.x));
            *rate = evaluated.dx;
        }
        *evaluations += NODES as u64;
        let polynomial = Polynomial::of(*from, h, &rates);
        let mut moved = M::S::ZERO;
        for (state, c) in states.iter_mut().zip(nodes) {
            let next = polynomial.at(c);
            let change: [M::S; NX] = Vector::from_fn(|i| next.at(i) - state.at(i));
            let weight = |i: usize| equations.typical_of(i) + next.at(i).abs();
            moved = moved.max(size(&change, weight));
            *state = next;
        }
        if !states.iter().all(Vector::is_finite) {
            return Err(Refused::NotFound);
        }
        let rounded = moved < STAGNATED.of::<M::S>() && moved + moved > before;
        if moved < FOUND.of::<M::S>() * M::S::EPSILON || rounded {
            if !beside {
                return Err(Refused::NotFound);
            }
            return check(equations, (t, held), (disagree, rate), polynomial);
        }
        before = moved;
    }
    Err(Refused::NotFound)
}

/// The state after a time, roughly.
fn guess<S: Real, const NQ: usize, const NX: usize>(
    from: &[S; NX],
    rate: Option<&[S; NX]>,
    time: S,
) -> [S; NX] {
    Vector::from_fn(|i| {
        let bend = rate.map_or(S::ZERO, |rate| rate.at(i + NQ));
        let half = S::lit(0.5) * time * time;
        match i {
            _ if i < NQ => from.at(i) + time * from.at(i + NQ) + half * bend,
            _ => from.at(i) + time * rate.map_or(S::ZERO, |rate| rate.at(i)),
        }
    })
}

/// Are the joints closed all the way, but by what those that repeat others `disagree` at the nodes, and does the motion go
/// on from there as it came?
fn check<M, const NQ: usize, const NC: usize, const NX: usize>(
    equations: &Equations<M, NQ, NC, NX>,
    (t, held): (M::S, &M::U),
    (disagree, before): (M::S, Option<&[M::S; NX]>),
    polynomial: Polynomial<M::S, NX>,
) -> Result<Polynomial<M::S, NX>, Refused<M::S>>
where
    M: ExtendedPrecision<NQ, NC, NX>,
{
    // The gap is a sum over all rows, as is its rounding.
    let many = M::S::lit(equations.system.layout().rows.len() as f64 / FEW_ROWS.get()).max(M::S::lit(1.0));
    let unit = many * M::S::EPSILON * equations.size(&polynomial.from);
    let gap_at = |part: M::S| equations.gap(t + part * polynomial.h, &polynomial.at(part));
    // The rounded state that it begins with is as open as rounding makes it.
    let disagree = disagree.max(gap_at(M::S::ZERO));
    let disagree = if disagree > CLOSED_ON_THE_WAY.of::<M::S>() * unit { disagree } else { M::S::ZERO };
    if disagree > DISAGREE_BY_ROUNDING.of::<M::S>() * unit {
        return Err(Refused::Undecided(disagree));
    }
    let inside = (1..=2 * NODES).map(|k| gap_at(M::S::lit(k as f64 / (2 * NODES) as f64)));
    let gap = inside.fold(M::S::ZERO, M::S::max) - SPREAD.of::<M::S>() * disagree;
    if gap > CLOSED_ON_THE_WAY.of::<M::S>() * unit {
        let undecided = gap <= UNDECIDED.of::<M::S>() * unit;
        return Err(if undecided { Refused::Undecided(gap) } else { Refused::Opens(gap) });
    }
    let (one, end) = (M::S::lit(1.0), polynomial.at(M::S::lit(1.0)));
    let after = equations.evaluate(t + polynomial.h, held, &end).ok_or(Refused::NotFound)?;
    let agrees = |part: M::S, (x, dx): (&[M::S; NX], &[M::S; NX])| {
        let rate = polynomial.rate(part);
        let off: [M::S; NX] = Vector::from_fn(|i| polynomial.h * (dx.at(i) - rate.at(i)));
        size(&off, |i| equations.typical_of(i) + x.at(i).abs()) < half_of_digits(AGREES)
    };
    // No node sees what changes before the first of them or after the last.
    let begins = before.is_none_or(|before| agrees(M::S::ZERO, (&polynomial.from, before)));
    if begins && agrees(one, (&end, &after.dx)) { Ok(polynomial) } else { Err(Refused::NotFound) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn states_are_guessed_along_their_parabola() {
        // Two places and velocities, one state of first order; after 2 s.
        let (from, rate) = ([1.0, 2.0, 3.0, 5.0, 7.0], [3.0, 5.0, 11.0, 13.0, 17.0]);
        assert_eq!(guess::<f64, 2, 5>(&from, Some(&rate), 2.0), [29.0, 38.0, 25.0, 31.0, 41.0]);
        assert_eq!(guess::<f64, 2, 5>(&from, None, 2.0), [7.0, 12.0, 3.0, 5.0, 7.0]);
    }
}
