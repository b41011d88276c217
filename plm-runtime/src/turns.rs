//! Revolutions of angles that may turn without end, counted beside the state.
//!
//! An angle in the state stays within three quarters of a revolution: its sine and cosine are as exact after a day as after a minute, in
//! `f32` as well. Quantities that read the angle itself get the revolutions added.

use crate::scalar::{Real, Scalar};
use crate::vector::Vector;

/// An angle whose absolute value is larger, rad, is reduced by revolutions. The bound is three quarters of a revolution, so that an angle
/// that swings about half a revolution is not reduced each time.
const FARTHEST: f64 = 0.75 * TAU;
/// A revolution, rad ...
const TAU: f64 = core::f64::consts::TAU;
/// ... and its rounding error.
const TAU_LOW: f64 = 2.449_293_598_294_706_4e-16;
/// So many numbers stay in registers over a step.
const IN_REGISTERS: usize = 8;
/// An angle that is larger, rad, is left alone: no step can turn so far.
const MOST: f64 = 1e9;

/// The angle with its revolutions, rad.
#[inline]
#[must_use]
pub fn whole<S: Real>(angle: S, turns: i32) -> S {
    S::of_turns(turns).mul_add(S::lit(TAU), angle)
}

/// Adds the counted revolutions to angles among `numbers`; `places` has the indices of the angles of each count.
#[inline]
pub fn add<S: Real, const K: usize>(turns: &[i32; K], numbers: &mut impl Vector<S>, places: &[&[usize]; K]) {
    for (&turns, places) in turns.iter().zip(places) {
        for &place in *places {
            numbers.set(place, whole(numbers.at(place), turns));
        }
    }
}

/// Number of revolutions by which an angle is to be reduced; 0 as long as it is near.
#[inline]
pub(crate) fn due<S: Real>(angle: S) -> i32 {
    let is_far = angle.abs() > S::lit(FARTHEST) && angle.abs() < S::lit(MOST);
    if !is_far {
        return 0;
    }
    // The floor by way of an integer, which rounds to zero: an `i32` has room for so many revolutions.
    let turns = angle * S::lit(1.0 / TAU) + S::lit(0.5);
    let whole = turns.to_turns();
    if S::of_turns(whole) > turns { whole - 1 } else { whole }
}

/// The numbers by which angles are reduced, for code that does it without this crate: the absolute value above which an angle is reduced, and
/// that above which it is not any more; the inverse of a revolution; the revolution in a scalar type, and what that lacks.
pub fn constants<S: Real>() -> [S; 5] {
    let turn = S::lit(TAU);
    [S::lit(FARTHEST), S::lit(MOST), S::lit(1.0 / TAU), turn, S::lit(TAU - turn.to_f64() + TAU_LOW)]
}

/// Is an angle so near to zero that it is not reduced?
#[inline]
pub fn is_near<S: Real>(angle: S) -> bool {
    due(angle) == 0
}

/// An angle less whole revolutions: the difference is exact for one revolution (Sterbenz), its rest is rounded once.
#[inline]
pub(crate) fn less<S: Real>(angle: S, turns: i32) -> S {
    let (count, high) = (S::of_turns(turns), S::lit(TAU));
    (angle - count * high) - count * S::lit(TAU - high.to_f64() + TAU_LOW)
}

/// Is the first angle of a count among `numbers` to be reduced?
#[inline]
pub fn are_due<S: Real, const K: usize>(numbers: &impl Vector<S>, places: &[&[usize]; K]) -> bool {
    places.iter().filter_map(|places| places.first()).any(|&place| due(numbers.at(place)) != 0)
}

/// Negation of [`are_due`] for states side by side: 0 in the lanes where an angle is to be reduced, 1 elsewhere.
#[inline]
pub fn all_near<T: Scalar, const K: usize>(numbers: &impl Vector<T>, places: &[&[usize]; K]) -> T {
    let first = places.iter().filter_map(|places| places.first());
    first.fold(T::lit(1.0), |near, &place| near.min(are_near(numbers.at(place))))
}

/// 0 in the lanes whose angle is to be reduced, 1 elsewhere.
#[inline]
pub(crate) fn are_near<T: Scalar>(angle: T) -> T {
    let (zero, one) = (T::lit(0.0), T::lit(1.0));
    let due = T::select(angle.abs().lt(T::lit(MOST)), zero, one);
    T::select(T::lit(FARTHEST).lt(angle.abs()), due, one)
}

/// Reduces angles among `numbers` by whole revolutions, and counts these. The angles of one count are reduced together, when the first of
/// them is far; the others may be far from that. Returns true if some were reduced.
#[inline]
pub fn unwind<S: Real, X: Vector<S>, const K: usize>(
    turns: &mut [i32; K],
    numbers: &mut X,
    places: &[&[usize]; K],
) -> bool {
    // In almost all steps all are near: a comparison for each, without what a turn takes.
    let near = |places: &&[usize]| {
        places.first().is_none_or(|&at| numbers.at(at).plain().abs() <= S::Plain::lit(FARTHEST))
    };
    if places.iter().fold(true, |all, places| all & near(places)) {
        return false;
    }
    if X::LEN > IN_REGISTERS {
        return unwind_far(turns, numbers, places);
    }
    // Copies: what is lent to a call stands in memory, and a state that is near stays in registers.
    let (mut all, mut far) = (*turns, *numbers);
    let turned = unwind_far(&mut all, &mut far, places);
    (*turns, *numbers) = (all, far);
    turned
}

/// As [`unwind`], if an angle may be far.
#[cold]
fn unwind_far<S: Real, const K: usize>(
    turns: &mut [i32; K],
    numbers: &mut impl Vector<S>,
    places: &[&[usize]; K],
) -> bool {
    let mut turned = false;
    for (turns, places) in turns.iter_mut().zip(places) {
        let due = places.first().map_or(0, |&place| due(numbers.at(place)));
        if due == 0 {
            continue;
        }
        for &place in *places {
            numbers.set(place, less(numbers.at(place), due));
        }
        *turns = turns.saturating_add(due);
        turned = true;
    }
    turned
}

#[cfg(test)]
mod tests {
    use super::{FARTHEST, TAU, add, all_near, due, less, unwind, whole};

    /// Compares the counted revolutions with a sum of equal steps in integers: the pose is that of the first revolutions.
    fn turned<S: crate::Real>(steps: u32) -> (S, i32) {
        let (mut angle, mut turns) = ([S::ZERO], [0]);
        for _ in 0..steps {
            angle[0] = angle[0] + S::lit(0.125);
            unwind(&mut turns, &mut angle, &[&[0]]);
            assert!(angle[0].abs() <= S::lit(FARTHEST));
        }
        (angle[0], turns[0])
    }

    #[test]
    fn a_shaft_is_as_exact_after_many_turns_as_after_one() {
        let steps = 10_000_000;
        let (angle, turns) = turned::<f32>(steps);
        let expected = f64::from(steps) * 0.125;
        let off = f64::from(angle) + f64::from(turns) * TAU - expected;
        // Steps of an eighth are exact; what a turn lacks of its 24 bits is lost in them, 1.75e-7 rad a turn.
        assert!(off.abs() < 1.8e-7 * f64::from(turns), "{off:e}");
        // The sum by itself is stuck where a step is half a unit in the last place.
        let sum = (0..steps).fold(0.0_f32, |sum, _| sum + 0.3);
        assert!((f64::from(sum) / (0.3 * f64::from(steps)) - 1.0).abs() > 0.05);
    }

    #[test]
    fn whole_angles_are_what_they_were() {
        for angle in [5.0_f64, -5.0, 17.3, -4e5, 1e8] {
            let turns = due(angle);
            let back = less(angle, turns);
            assert!(back.abs() <= 0.5 * TAU + 1e-9, "{angle}: {back}");
            assert!((whole(back, turns) - angle).abs() <= 2.0 * f64::EPSILON * angle.abs());
            assert_eq!(all_near::<f64, 1>(&[angle], &[&[0]]), 0.0);
        }
        for near in [0.0, 3.2, -4.7, f64::NAN, f64::INFINITY, 1e30] {
            assert_eq!((due(near), all_near::<f64, 1>(&[near], &[&[0]])), (0, 1.0));
        }
        let mut pose = [1.0, 2.0, 3.0, 4.0];
        add(&[2, -1], &mut pose, &[&[1, 3], &[0]]);
        assert_eq!(pose, [1.0 - TAU, 2.0 + 2.0 * TAU, 3.0, 4.0 + 2.0 * TAU]);
    }
}
