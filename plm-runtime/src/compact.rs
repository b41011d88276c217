//! Long tables as they are written: names in one text, numbers as repetitions.
//!
//! A mechanism of a thousand bodies has tables of tens of thousands of entries. rustc takes a microsecond or more for each entry that is
//! written out in the source. The functions here expand a compact form, and a table that nothing uses is never expanded.
//!
//! All of this runs while rustc evaluates constants: what does not fit is an error there.

use crate::described::{self, Body, Frame};
use crate::linalg::{Below, Part, Pivot, Term};

/// So many repetitions of a row of numbers, each larger than the one before by the steps in the second row, modulo 2^32;
/// steps that are not there are zero.
pub type Run = (u32, &'static [u32], &'static [u32]);

/// The numbers of all runs, one after the other. Column by column: each statement takes the evaluator half a microsecond.
pub const fn numbers<const N: usize>(runs: &[Run]) -> [u32; N] {
    let (mut all, mut at, mut run) = ([0; N], 0, 0);
    while run < runs.len() {
        let (count, first, steps) = runs[run];
        let (length, mut k) = (first.len(), 0);
        let end = at + length * count as usize;
        while k < length {
            let step = if k < steps.len() { steps[k] } else { 0 };
            let (mut place, mut number) = (at + k, first[k]);
            while place < end {
                all[place] = number;
                number = number.wrapping_add(step);
                place += length;
            }
            k += 1;
        }
        at = end;
        run += 1;
    }
    assert!(at == N, "as many numbers as there are places");
    all
}

/// The names in a text, one after the other, of these lengths.
pub const fn names<const N: usize>(mut text: &'static str, lengths: &[Run]) -> [&'static str; N] {
    let (lengths, mut all, mut at) = (numbers::<N>(lengths), [""; N], 0);
    while at < N {
        (all[at], text) = text.split_at(lengths[at] as usize);
        at += 1;
    }
    all
}

/// Values by their numbers.
pub const fn chosen<const N: usize>(values: &[f64], numbers: &[u32]) -> [f64; N] {
    let (mut all, mut at) = ([0.0; N], 0);
    while at < N {
        all[at] = values[numbers[at] as usize];
        at += 1;
    }
    all
}

/// Lists of one number each.
pub const fn singles<const N: usize>(numbers: &'static [[usize; 1]; N]) -> [&'static [usize]; N] {
    let mut all: [&[usize]; N] = [&[]; N];
    let mut at = 0;
    while at < N {
        all[at] = &numbers[at];
        at += 1;
    }
    all
}

/// `[first]`, `[first + step]`, and so on.
pub const fn places<const N: usize>(first: usize, step: usize) -> [[usize; 1]; N] {
    let (mut all, mut at) = ([[0]; N], 0);
    while at < N {
        all[at] = [first + step * at];
        at += 1;
    }
    all
}

/// Pairs of numbers.
pub const fn pairs<const N: usize>(numbers: &[u32]) -> [[u32; 2]; N] {
    let (mut all, mut at) = ([[0; 2]; N], 0);
    while at < N {
        all[at] = [numbers[2 * at], numbers[2 * at + 1]];
        at += 1;
    }
    all
}

/// Terms: coefficient, row, column, entry, and which part of the unknown, in the order of [`Part`].
pub const fn terms<const N: usize>(numbers: &[u32]) -> [Term; N] {
    let mut all = [Term { coefficient: 0, row: 0, column: 0, entry: 0, part: Part::Value }; N];
    let mut at = 0;
    while at < N {
        let k = 5 * at;
        all[at] = term([numbers[k], numbers[k + 1], numbers[k + 2], numbers[k + 3], numbers[k + 4]]);
        at += 1;
    }
    all
}

/// One of them.
pub const fn term([coefficient, row, column, entry, part]: [u32; 5]) -> Term {
    let part = match part {
        0 => Part::Value,
        1 => Part::Rate,
        2 => Part::Position,
        3 => Part::Velocity,
        _ => Part::Acceleration,
    };
    Term { coefficient, row, column, entry, part }
}

/// Pivots: row, entry, below and right with beginning and end, targets.
pub const fn pivots<const N: usize>(numbers: &[u32]) -> [Pivot; N] {
    let mut all = [Pivot { row: 0, entry: 0, below: [0; 2], right: [0; 2], targets: 0 }; N];
    let mut at = 0;
    while at < N {
        let k = 7 * at;
        let (below, right) = ([numbers[k + 2], numbers[k + 3]], [numbers[k + 4], numbers[k + 5]]);
        all[at] = Pivot { row: numbers[k], entry: numbers[k + 1], below, right, targets: numbers[k + 6] };
        at += 1;
    }
    all
}

/// Entries below pivots: row, entry, across.
pub const fn below<const N: usize>(numbers: &[u32]) -> [Below; N] {
    let (mut all, mut at) = ([Below { row: 0, entry: 0, across: 0 }; N], 0);
    while at < N {
        let k = 3 * at;
        all[at] = Below { row: numbers[k], entry: numbers[k + 1], across: numbers[k + 2] };
        at += 1;
    }
    all
}

/// Bodies by their names; of each: which of the lists of ports, points of the contour, first figure.
pub const fn bodies<const N: usize>(
    names: [&'static str; N],
    ports: &[&'static [&'static str]],
    numbers: &[u32],
) -> [Body; N] {
    let (mut all, mut at) = ([Body { name: "", ports: &[], contour: 0, first: 0 }; N], 0);
    while at < N {
        let [list, contour, first] =
            [numbers[3 * at] as usize, numbers[3 * at + 1] as usize, numbers[3 * at + 2] as usize];
        all[at] = Body { name: names[at], ports: ports[list], contour, first };
        at += 1;
    }
    all
}

/// Parts by their names; of each: which of the kinds, number of frames, first figure. The frames are those of all
/// parts.
pub const fn parts<const N: usize>(
    names: [&'static str; N],
    kinds: &[described::Part],
    numbers: &[u32],
    mut frames: &'static [Frame],
) -> [described::Part; N] {
    let nothing = described::Part { name: "", kind: "", pair: None, frames: &[], sizes: &[], first: 0 };
    let (mut all, mut at) = ([nothing; N], 0);
    while at < N {
        let [kind, count, first] =
            [numbers[3 * at] as usize, numbers[3 * at + 1] as usize, numbers[3 * at + 2] as usize];
        let (own, rest) = frames.split_at(count);
        all[at] = described::Part { name: names[at], frames: own, first, ..kinds[kind] };
        frames = rest;
        at += 1;
    }
    all
}

/// Frames: which of the arguments, body (none beyond the last number) and port.
pub const fn frames<const N: usize>(arguments: &[&'static str], numbers: &[u32]) -> [Frame; N] {
    let (mut all, mut at) = ([Frame { argument: "", body: None, port: 0 }; N], 0);
    while at < N {
        let [argument, body, port] = [numbers[3 * at], numbers[3 * at + 1], numbers[3 * at + 2]];
        let body = if body == u32::MAX { None } else { Some(body as usize) };
        all[at] = Frame { argument: arguments[argument as usize], body, port: port as usize };
        at += 1;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::{names, numbers, places, singles};

    #[test]
    fn runs_go_on_from_repetition_to_repetition() {
        const ALL: [u32; 9] =
            numbers(&[(1, &[7], &[]), (3, &[1, 10], &[2, u32::MAX]), (2, &[u32::MAX], &[0])]);
        assert_eq!(ALL, [7, 1, 10, 3, 9, 5, 8, u32::MAX, u32::MAX]);
    }

    #[test]
    fn names_are_told_apart_by_their_lengths() {
        const THREE: [&str; 3] = names("arm.xarm.angle", &[(1, &[5, 0, 9], &[])]);
        const MANY: [&str; 4] = names("a1a2a3b", &[(3, &[2], &[0]), (1, &[1], &[])]);
        assert_eq!((THREE, MANY), (["arm.x", "", "arm.angle"], ["a1", "a2", "a3", "b"]));
    }

    #[test]
    fn places_are_lists_of_one() {
        const PLACES: [[usize; 1]; 3] = places(2, 3);
        const LISTS: [&[usize]; 3] = singles(&PLACES);
        assert_eq!(LISTS, [&[2], &[5], &[8]]);
    }
}
