//! Relevant conditions: those whose modes the rate can read, given the modes that the others can have.

use super::guards;
use super::marks::Marks;
use super::violated::is_violated;
use crate::scalar::Real;
use crate::system::System;
use crate::vector::Vector;

/// Words of 64 bits for the nodes of a decision diagram that are followed.
const WORDS: usize = 32;

/// Conditions that matter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Relevant(Marks);

impl Relevant {
    /// All conditions, of any number.
    pub(super) const ALL: Self = Self(Marks::ALL);

    /// Conditions that matter as long as only conditions that are `unknown` change their sides.
    pub(super) fn of<M: System>(system: &M, held: &M::U, unknown: Marks) -> Self {
        if !M::SELECTIVE {
            return Self::ALL;
        }
        let others = |i: usize| (unknown & !Marks::of(i)).first();
        Self(Marks::of_all((0..M::G::LEN).filter(|i| system.matters(held, *i, others(*i)))))
    }

    /// Kinks that matter, one bit each, as long as only conditions that are `unknown` change their sides. Kinks are counted
    /// after the conditions; those after the first 128 are left to error control.
    pub(super) fn kinks<M: System>(system: &M, held: &M::U, unknown: Marks) -> u128 {
        if !M::SELECTIVE {
            return u128::MAX;
        }
        let matter = (0..system.kink_count().min(128))
            .filter(|k| system.matters(held, M::G::LEN + k, unknown.first()));
        matter.fold(0, |bits, k| bits | 1 << k)
    }

    /// True if this condition is among them.
    #[inline]
    pub(super) fn has(self, index: usize) -> bool {
        self.0.has(index)
    }

    /// True if none of them is `unknown`.
    pub(super) fn is_apart(self, unknown: Marks) -> bool {
        (self.0 & unknown).is_empty()
    }
}

/// Bit of a side, or of a node in its word.
#[inline]
fn bit(index: usize) -> u64 {
    u32::try_from(index).ok().and_then(|index| 1_u64.checked_shl(index)).unwrap_or(0)
}

/// Updates the sides of the conditions that do not matter at a state; returns those that have changed.
pub(crate) fn refresh<M: System<S: Real>>(system: &M, t: M::S, u: &mut M::U, x: &M::X) -> Marks {
    let mut changed = Marks::NONE;
    if !M::SELECTIVE || (0..M::G::LEN).all(|i| system.matters(u, i, 0)) {
        return changed;
    }
    let here = guards(system, t, u, x);
    // A condition that does not matter resets nothing.
    let mut x = *x;
    for i in 0..M::G::LEN {
        if is_violated(system, &here, i)
            && !system.must_hold(i)
            && !system.matters(u, i, 0)
            && system.switch(t, u, &mut x, i).is_ok()
        {
            changed.put(i);
        }
    }
    changed
}

/// True if a function of sides is true, or may be true if the sides with a bit in `unknown` are other ones. The function is a
/// decision diagram: each of its `nodes` gives a side, the next node if that is negative, and the next node if it is not. Nodes are
/// counted from 2 on; 0 is false, 1 is true, and next nodes have smaller numbers.
pub fn holds<S: Real>(nodes: &[(u8, u16, u16)], root: u16, sides: &[S], unknown: u64) -> bool {
    let mut reached = [0_u64; WORDS];
    let (mut number, mut open) = (usize::from(root), 0_u32);
    loop {
        let Some(&(side, yes, no)) = number.checked_sub(2).and_then(|place| nodes.get(place)) else {
            return number != 0;
        };
        let side = usize::from(side);
        let is_unknown = unknown & bit(side) != 0;
        let negative = sides.get(side).is_some_and(|side| *side < S::ZERO);
        for (follows, next) in [(is_unknown || negative, yes), (is_unknown || !negative, no)] {
            let next = usize::from(next);
            if follows && next == 1 {
                return true;
            }
            if let (true, Some(word)) = (follows && next > 1, reached.get_mut(next / 64)) {
                open += u32::from(*word & bit(next % 64) == 0);
                *word |= bit(next % 64);
            }
        }
        if open == 0 {
            return false;
        }
        // The next node below.
        number -= 1;
        while reached.get(number / 64).is_some_and(|word| word & bit(number % 64) == 0) {
            number -= 1;
        }
        open -= 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `(a and b) or c`, by sides 0, 1 and 2, after `not b` and `c` alone.
    const NODES: [(u8, u16, u16); 5] = [(2, 1, 0), (1, 0, 1), (1, 1, 2), (0, 4, 2), (0, 3, 3)];

    #[test]
    fn what_is_not_known_may_be_either() {
        for row in 0..8_u8 {
            let holds_at = |row: u8| [0, 1, 2].map(|k| row >> k & 1 == 1);
            for unknown in 0..8_u8 {
                let can = |f: fn([bool; 3]) -> bool| {
                    (0..8).filter(|other| (other ^ row) & !unknown == 0).any(|other| f(holds_at(other)))
                };
                let sides = holds_at(row).map(|holds| if holds { -1.0 } else { 1.0 });
                let found = |root| holds(&NODES, root, &sides, u64::from(unknown));
                assert_eq!(found(5), can(|[a, b, c]| a && b || c), "{row} {unknown}");
                assert_eq!(found(3), can(|[_, b, _]| !b), "{row} {unknown}");
                assert_eq!(found(6), can(|[_, b, _]| !b), "{row} {unknown}");
                assert_eq!(found(2), can(|[_, _, c]| c), "{row} {unknown}");
                assert!(found(1) && !found(0));
            }
        }
    }
}
