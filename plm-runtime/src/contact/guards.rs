//! Guards of contact rows: at a state, over an interval, and over a whole step.
//!
//! The modes determine which quantities a guard needs. An open gap, and a row that slips by a bound of its own, need gaps and rates alone.
//! A force that acts on a motion shapes the motion, so that the error estimate of the step reflects it; the force of a constraint row
//! moves nothing, and neither does a gap. Those two are enclosed over a step, and a row that slips is evaluated at some points of it.

use super::bounds::least_bound;
use super::driven::rests;
use super::enclosed::multipliers_within;
use super::kinematics::Kinematics;
use super::margins::{PER_ROW, SIGN, UNIQUE, each_margin, margins};
use super::modes::{Mode, Modes};
use super::rows::{Rows, below, indices};
use super::{Contacts, Modal, change_in_steps};
use crate::enclosure::Enclosed;
use crate::scalar::Scalar;

/// A guard keeps its sign if it is larger than so many times its second difference over half of the step, ...
const BENT: f64 = 2.0;
/// ... and larger than this fraction of its change.
const CHANGED: f64 = 0.125;
/// The determinant of slipping rows is 1 if none bounds another one. Below this value it is checked over the step.
const COUPLED: f64 = 0.5;

/// Guards of the rows in the present modes, for [`Events::guards`](crate::Events::guards): gives each of the
/// [`guard_count`](super::guard_count) with its index.
pub fn guards<M: Contacts<N>, const N: usize>(
    system: &M,
    t: M::S,
    u: &M::U,
    x: &M::X,
    each: &mut impl FnMut(usize, M::S),
) {
    if change_in_steps(system, u) {
        (0..=PER_ROW * N).for_each(|index| each(index, M::S::lit(1.0)));
        return;
    }
    let (modes, each) = (u.modes(), &mut existing(system, u, each));
    if is_free(system, u) {
        let rows = system.kinematics_at(t, u, x);
        if !rows.reads_forces(modes) {
            free_margins(&rows, modes, (modes.orientation, None), each);
            return;
        }
        if let Some(sizes) = system.sliding(t, u, x) {
            free_margins(&rows, modes, (modes.orientation, Some(&sizes)), each);
            return;
        }
    }
    let rows = system.rows_at(t, u, x);
    if !margins(&rows, (modes, modes.orientation), &mut bounded(system, &rows, each)) {
        (0..PER_ROW * N).for_each(|index| each(index, M::S::ZERO));
        each(PER_ROW * N, M::S::lit(-1.0));
    }
}

/// Guards over an interval, for [`Events::guards_within`](crate::Events::guards_within). Returns false if some are not given: those of
/// slipping rows while no row is a constraint, those of rows that a drive lets rest, and all if multipliers have no enclosure.
pub fn guards_within<M: Contacts<N>, const N: usize>(
    system: &M,
    t: Enclosed<M::S>,
    u: &M::U,
    x: &impl Fn(usize) -> Enclosed<M::S>,
    each: &mut impl FnMut(usize, Enclosed<M::S>),
) -> bool {
    if change_in_steps(system, u) {
        (0..=PER_ROW * N).for_each(|index| each(index, Enclosed::constant(M::S::lit(1.0))));
        return true;
    }
    let (modes, each) = (u.modes(), &mut existing(system, u, each));
    let orientation = Enclosed::constant(modes.orientation);
    if !is_free(system, u) {
        let rows = system.rows(t, u, x, &Enclosed::constant);
        let Some(found) = multipliers_within(&rows, &modes.of) else { return false };
        let rests = |row: usize| row < N && rests(&rows, modes, row);
        each_margin(&rows, (modes, orientation), &found, &mut |index, margin| {
            if index % PER_ROW == SIGN || !rests(index / PER_ROW) {
                bounded(system, &rows, each)(index, margin);
            }
        });
        return !indices::<N>().any(rests);
    }
    let slips = modes.of.iter().any(|mode| mode.slips());
    // If every row slips nothing is known.
    if !modes.of.iter().all(|mode| mode.slips()) {
        let rows = system.kinematics(t, u, x, &Enclosed::constant);
        free_margins(&rows, modes, (orientation, None), &mut |index, margin| {
            let of_row = modes.of.get(index / PER_ROW).filter(|_| index % PER_ROW != SIGN);
            let is_known = of_row.map_or(!slips, |mode| !mode.slips());
            if is_known {
                each(index, margin);
            }
        });
    }
    !slips
}

/// True if no guard comes near to zero in a step, for [`Events::stay`](crate::Events::stay), whose arguments these are; `end` gives the
/// guards at its end. Most steps then need no dense output.
pub fn stay<M: Contacts<N>, const N: usize>(
    system: &M,
    u: &M::U,
    places: [(M::S, &M::X); 2],
    (time, x): (Enclosed<M::S>, &impl Fn(usize) -> Enclosed<M::S>),
    end: impl Fn(usize) -> M::S,
) -> bool {
    let (modes, half) = (u.modes(), M::S::lit(0.5));
    if !is_free(system, u) {
        return false;
    }
    if modes.of.contains(&Mode::Open) {
        let rows = system.kinematics(time, u, x, &Enclosed::constant);
        let is_far = |row: usize| {
            let row = below::<N>(row);
            let gap = rows.gap[row].range(half);
            modes.of[row] != Mode::Open
                || !system.exists(u, row)
                || gap.low > M::S::lit(CHANGED) * (gap.high - gap.low)
        };
        if !indices::<N>().all(is_far) {
            return false;
        }
    }
    if !modes.of.iter().any(|mode| mode.slips()) {
        return true;
    }
    if end(PER_ROW * N) < M::S::lit(COUPLED) {
        return false;
    }
    let [first, second] = places.map(|(t, x)| slipping(system, u, t, x));
    let is_clear = |row: usize, k: usize| {
        let place = |guards: &[[M::S; PER_ROW]; N]| guards[below::<N>(row)][below::<PER_ROW>(k)];
        let (a, b, c) = (place(&first), place(&second), end(PER_ROW * row + k));
        let (bent, changed) = ((a - b - b + c).abs(), (c - a).abs());
        a.min(b).min(c) > M::S::lit(BENT) * bent + M::S::lit(CHANGED) * changed
    };
    // Signs of reactions that bound nothing are far from zero.
    indices::<N>().all(|row| !modes.of[row].slips() || (0..SIGN).all(|k| is_clear(row, k)))
        && indices::<N>().all(|load| is_clear(load, SIGN))
}

/// Guards at a state, while no row is a constraint.
fn slipping<M: Contacts<N>, const N: usize>(system: &M, u: &M::U, t: M::S, x: &M::X) -> [[M::S; PER_ROW]; N] {
    let (modes, mut found) = (u.modes(), [[M::S::ZERO; PER_ROW]; N]);
    let kinematics = system.kinematics_at(t, u, x);
    let has_sign = |load: usize| kinematics.is_line(load) && kinematics.bounds_slip(load, modes);
    let mut each = |index: usize, guard: M::S| {
        if let Some(row) = found.get_mut(index / PER_ROW) {
            row[index % PER_ROW] = guard;
        }
    };
    if !indices::<N>().any(has_sign) {
        free_margins(&kinematics, modes, (modes.orientation, None), &mut each);
    } else if let Some(sizes) = system.sliding(t, u, x) {
        free_margins(&kinematics, modes, (modes.orientation, Some(&sizes)), &mut each);
    } else {
        // If multipliers are not unique the guards stay zero, so that none is clear.
        let _ = margins(&system.rows_at(t, u, x), (modes, modes.orientation), &mut each);
    }
    found
}

/// Gives each margin while no row is a constraint and rows that are off stay off. `sizes` are those of reactions along a line, if sweeps
/// have found the forces of slipping rows: if these converge, the determinant has not come to zero since the modes were chosen.
fn free_margins<T: Scalar, const N: usize>(
    rows: &Kinematics<T, N>,
    modes: &Modes<impl Scalar, N>,
    (orientation, sizes): (T, Option<&[T; N]>),
    each: &mut impl FnMut(usize, T),
) {
    let far = T::lit(1.0);
    for row in 0..N {
        let mode = modes.of[row];
        let margin = match mode {
            _ if modes.is_carried(row) => far,
            Mode::Open => rows.gap[row],
            Mode::Forwards | Mode::Backwards => mode.sign::<T>() * rows.rate[row],
            Mode::Closed | Mode::Off | Mode::Sticks => far,
        };
        each(PER_ROW * row, margin);
        each(PER_ROW * row + 1, far);
    }
    for load in 0..N {
        let is_sized = rows.is_line(load) && rows.bounds_slip(load, modes);
        each(PER_ROW * load + SIGN, sizes.filter(|_| is_sized).map_or(far, |sizes| sizes[load]));
    }
    let least = T::lit(if modes.of.iter().any(|mode| mode.slips()) { UNIQUE } else { 0.0 });
    each(PER_ROW * N, if sizes.is_some() { far } else { orientation } - least);
}

/// True if no row is a constraint, no row that is off can get a force unless a gap closes, and no bound has to be checked.
fn is_free<M: Contacts<N>, const N: usize>(system: &M, u: &M::U) -> bool {
    let is_there = |row: usize| system.exists(u, row);
    let stays_off = |row: usize| system.is_bounded_by_pushes(row) || !is_there(row);
    let falls = |row: usize| system.bound_may_fall(row) && is_there(row);
    let is_free =
        |(row, mode): (usize, &Mode)| !mode.holds() && (*mode != Mode::Off || stays_off(row)) && !falls(row);
    u.modes().of.iter().enumerate().all(is_free)
}

/// Limits the second margin of a friction whose bound may become negative to that bound.
fn bounded<'a, M: Contacts<N>, T: Scalar, const N: usize>(
    system: &'a M,
    rows: &'a Rows<T, N>,
    each: &'a mut impl FnMut(usize, T),
) -> impl FnMut(usize, T) + 'a {
    move |index, margin| {
        let row = index / PER_ROW;
        let is_second = index % PER_ROW == 1 && row < N && system.bound_may_fall(row);
        each(index, if is_second { margin.min(least_bound(rows, row)) } else { margin });
    }
}

/// Sets the margins of rows that do not exist, and of constraints, to 1. A reaction has a margin if rows read it.
fn existing<'a, M: Contacts<N>, T: Scalar, const N: usize>(
    system: &'a M,
    u: &'a M::U,
    each: &'a mut impl FnMut(usize, T),
) -> impl FnMut(usize, T) + 'a {
    move |index, margin| {
        let row = index / PER_ROW;
        let is_sign = index % PER_ROW == SIGN;
        let has_margins = row >= N || is_sign || system.exists(u, row) && !system.law(row).is_constraint();
        each(index, if has_margins { margin } else { T::lit(1.0) });
    }
}
