//! Continuation data of loops, of as many numbers as a mechanism has.

use plm_compiler::lowered::Loops;
use plm_runtime::charts::{Angle, Continuation, ContinuationData, Iterated, Reach};
use plm_runtime::words::{InWords, Words};
use plm_runtime::{Real, Scalar};

/// Continuation data with room for `N` of each kind.
#[derive(Clone, Copy, Debug)]
pub struct Memory<S, const N: usize> {
    numbers: Continuation<S, N, N, N, N>,
    counts: Counts,
}

/// How many numbers of each kind there are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Counts {
    pub(crate) coordinates: usize,
    pub(crate) angles: usize,
    pub(crate) determinants: usize,
    pub(crate) iterated: usize,
}

impl Counts {
    pub(crate) fn of(loops: &Loops) -> Counts {
        Counts {
            coordinates: loops.coordinates,
            angles: loops.turning.len(),
            determinants: loops.determinants,
            iterated: loops.iterated.len(),
        }
    }

    /// The largest of them.
    pub(crate) fn largest(self) -> usize {
        let Counts { coordinates, angles, determinants, iterated } = self;
        coordinates.max(angles).max(determinants).max(iterated)
    }
}

/// Compares the numbers in use; unused room is ignored.
impl<S: Scalar, const N: usize> PartialEq for Memory<S, N> {
    fn eq(&self, other: &Self) -> bool {
        self.counts == other.counts
            && self.time() == other.time()
            && self.coordinates() == other.coordinates()
            && self.angles() == other.angles()
            && self.determinants() == other.determinants()
            && self.iterated() == other.iterated()
    }
}

impl<S: Scalar, const N: usize> Memory<S, N> {
    /// The data before the first check.
    pub(crate) fn new(counts: Counts) -> Self {
        Self { numbers: ContinuationData::nothing(), counts }
    }

    /// The data with numbers of another type.
    pub(crate) fn map<T: Scalar>(&self, number: &impl Fn(S) -> T) -> Memory<T, N> {
        let mut mapped = Memory::new(self.counts);
        for k in 0..self.len() {
            if let Some(to) = mapped.number_mut(k) {
                *to = number(self.number(k));
            }
        }
        mapped
    }

    /// All numbers, in the order of storage.
    pub(crate) fn all(&self) -> Vec<S> {
        (0..self.len()).map(|index| self.number(index)).collect()
    }

    /// How many numbers it has.
    fn len(&self) -> usize {
        let Counts { coordinates, angles, determinants, iterated } = self.counts;
        2 * (coordinates + 1) + 3 * angles + determinants + 3 * iterated
    }

    /// Location of a number by its index.
    fn spot(&self, index: usize) -> Spot {
        let Counts { coordinates, angles, determinants, .. } = self.counts;
        let boxes = 2 * (coordinates + 1);
        match index {
            _ if index < boxes => Spot::Box(index / 2, index % 2),
            _ if index < boxes + 3 * angles => Spot::Angle((index - boxes) / 3, (index - boxes) % 3),
            _ if index < boxes + 3 * angles + determinants => Spot::Determinant(index - boxes - 3 * angles),
            _ => {
                let rest = index - boxes - 3 * angles - determinants;
                Spot::Iterated(rest / 3, rest % 3)
            }
        }
    }

    /// A number, in the order of storage.
    pub(crate) fn number(&self, index: usize) -> S {
        let numbers = &self.numbers;
        let number = match self.spot(index) {
            Spot::Box(k, part) => {
                let at = if k < self.counts.coordinates {
                    numbers.coordinates.get(k)
                } else {
                    Some(&numbers.time)
                };
                at.map(|at| [at.last, at.reach][part])
            }
            Spot::Angle(k, part) => numbers.angles.get(k).map(|at| [at.angle, at.cos, at.sin][part]),
            Spot::Determinant(k) => numbers.determinants.get(k).copied(),
            Spot::Iterated(k, part) => numbers.iterated.get(k).map(|at| [at.value, at.rate, at.bend][part]),
        };
        number.unwrap_or(S::ZERO)
    }

    /// A number by its index, to be written.
    pub(crate) fn number_mut(&mut self, index: usize) -> Option<&mut S> {
        let (spot, count) = (self.spot(index), self.counts.coordinates);
        let numbers = &mut self.numbers;
        match spot {
            Spot::Box(k, part) => {
                let at = if k < count { numbers.coordinates.get_mut(k)? } else { &mut numbers.time };
                Some(if part == 0 { &mut at.last } else { &mut at.reach })
            }
            Spot::Angle(k, part) => {
                let Angle { angle, cos, sin } = numbers.angles.get_mut(k)?;
                [angle, cos, sin].into_iter().nth(part)
            }
            Spot::Determinant(k) => numbers.determinants.get_mut(k),
            Spot::Iterated(k, part) => {
                let Iterated { value, rate, bend } = numbers.iterated.get_mut(k)?;
                [value, rate, bend].into_iter().nth(part)
            }
        }
    }
}

/// Location of a number.
#[derive(Clone, Copy)]
enum Spot {
    /// The interval about a coordinate, or about the time after the last one: value or reach.
    Box(usize, usize),
    /// An angle, its cosine or its sine.
    Angle(usize, usize),
    /// A determinant.
    Determinant(usize),
    /// An unknown of an iteration, its rate, or half the rate of that.
    Iterated(usize, usize),
}

impl<S: Scalar, const N: usize> ContinuationData<S> for Memory<S, N> {
    fn nothing() -> Self {
        Self::new(Counts::default())
    }

    fn coordinates(&self) -> &[Reach<S>] {
        &self.numbers.coordinates[..self.counts.coordinates]
    }

    fn coordinates_mut(&mut self) -> &mut [Reach<S>] {
        &mut self.numbers.coordinates[..self.counts.coordinates]
    }

    fn time(&self) -> Reach<S> {
        self.numbers.time
    }

    fn angles(&self) -> &[Angle<S>] {
        &self.numbers.angles[..self.counts.angles]
    }

    fn angles_mut(&mut self) -> &mut [Angle<S>] {
        &mut self.numbers.angles[..self.counts.angles]
    }

    fn determinants(&self) -> &[S] {
        &self.numbers.determinants[..self.counts.determinants]
    }

    fn iterated(&self) -> &[Iterated<S>] {
        &self.numbers.iterated[..self.counts.iterated]
    }

    fn iterated_mut(&mut self) -> &mut [Iterated<S>] {
        &mut self.numbers.iterated[..self.counts.iterated]
    }

    fn put(&mut self, one: &Self, put: impl Fn(&mut S, S)) {
        for k in 0..self.len() {
            if let Some(to) = self.number_mut(k) {
                put(to, one.number(k));
            }
        }
    }
}

/// All that there is room for, and how many of these there are.
impl<S: Real, const N: usize> InWords for Memory<S, N> {
    fn each(&mut self, words: &mut impl Words) {
        self.numbers.each(words);
        let Counts { coordinates, angles, determinants, iterated } = &mut self.counts;
        for count in [coordinates, angles, determinants, iterated] {
            let mut word = *count as u64;
            words.word(&mut word);
            *count = usize::try_from(word).map_or(N, |count| count.min(N));
        }
    }
}
