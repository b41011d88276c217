//! Record of impacts: impulses of each row, and energy.
//!
//! The impulses Lambda of an impact change the kinetic energy by `sum Lambda_i (g_i- + g_i+ - 2 r_i)/2`. Here g are the rates of the rows
//! before and after it, and r their parts that depend on time alone. The energy lost is `-sum Lambda_i (g_i- + g_i+)/2`, and contacts that
//! are moved do the work `-sum Lambda_i r_i`.

use super::impact::Doubts;
use crate::scalar::Real;
use crate::words::{InWords, Words};

/// Gain of an impact, as a fraction of the energy that impulses and rates turn over, up to which it counts as rounding.
pub(super) const GAIN: f64 = 1e-9;

/// Impulse of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impulse {
    /// Time of the impact, s.
    pub time: f64,
    /// Integral of the reaction of the row, N s or N m s: positive for a gap; for a friction it has the sign of its force.
    pub size: f64,
}

/// Energy of impacts since the run began, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ImpactEnergy {
    /// Energy lost in the last impact; that of all impacts at one time together.
    pub last: f64,
    /// Energy lost in all impacts.
    pub lost: f64,
    /// Work that moved contacts have done in impacts. The kinetic energy changes by this work less the energy lost.
    pub work: f64,
}

/// Record of the impacts of `N` rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Booked<const N: usize> {
    /// Last impulse of each row; its time is negative infinity before the first one.
    impulses: [Impulse; N],
    energy: ImpactEnergy,
    /// Time of the last impact, s.
    time: f64,
}

/// Sums over the impacts of an event.
#[derive(Clone, Copy, Debug)]
pub(super) struct Struck<S, const N: usize> {
    pub(super) impulses: [S; N],
    pub(super) lost: S,
    pub(super) work: S,
    /// Number of impacts.
    pub(super) count: u32,
    /// Ambiguities that the laws of impact leave.
    pub(super) doubts: Doubts,
}

impl<S: Real, const N: usize> Struck<S, N> {
    /// No impact.
    pub(super) fn nothing() -> Self {
        Self { impulses: [S::ZERO; N], lost: S::ZERO, work: S::ZERO, count: 0, doubts: Doubts::default() }
    }

    /// Adds an impact with the rates of the rows `before` and `after` it; `moved` are their parts that depend on time alone. An impact that
    /// gains energy is an error, with the gain and the energy that impulses and rates turn over, J.
    pub(super) fn add(
        &mut self,
        [before, after]: [&[S; N]; 2],
        moved: &[S; N],
        impulses: &[S; N],
    ) -> Result<(), [f64; 2]> {
        let half = S::lit(0.5);
        let (mut lost, mut size) = (S::ZERO, S::ZERO);
        for i in 0..N {
            let (impulse, rates) = (impulses[i], [before[i], after[i]]);
            lost = lost - half * impulse * (rates[0] + rates[1]);
            size = size + half * impulse.abs() * (rates[0].abs() + rates[1].abs());
            self.work = self.work - impulse * moved[i];
            self.impulses[i] = self.impulses[i] + impulse;
        }
        self.lost = self.lost + lost;
        self.count += 1;
        let gain = -lost;
        if gain > S::lit(GAIN).max(S::lit(64.0) * S::EPSILON) * size {
            return Err([gain.to_f64(), size.to_f64()]);
        }
        Ok(())
    }
}

impl<const N: usize> Booked<N> {
    /// Record before the first impact.
    pub(super) fn nothing() -> Self {
        let never = f64::NEG_INFINITY;
        Self {
            impulses: [Impulse { time: never, size: 0.0 }; N],
            energy: ImpactEnergy::default(),
            time: never,
        }
    }

    /// Records the impacts of an event.
    pub(super) fn book<S: Real>(&mut self, time: f64, struck: &Struck<S, N>) {
        if struck.count == 0 {
            return;
        }
        // Bits are compared, and nothing is added to zero: on processors without f64 each such sum takes a hundred instructions.
        let is_same = |other: f64| other.to_bits() == time.to_bits();
        for (row, impulse) in self.impulses.iter_mut().zip(struck.impulses) {
            if impulse != S::ZERO {
                let size = impulse.to_f64();
                *row = Impulse { time, size: if is_same(row.time) { row.size + size } else { size } };
            }
        }
        let ImpactEnergy { last, lost, work } = &mut self.energy;
        if !is_same(self.time) {
            *last = 0.0;
        }
        if struck.lost != S::ZERO {
            let loses = struck.lost.to_f64();
            (*last, *lost) = (if is_same(self.time) { *last + loses } else { loses }, *lost + loses);
        }
        if struck.work != S::ZERO {
            *work += struck.work.to_f64();
        }
        self.time = time;
    }

    /// Last impulses of the rows.
    pub(super) fn impulses(&self) -> &[Impulse; N] {
        &self.impulses
    }

    /// Energy of the impacts.
    pub(super) fn energy(&self) -> ImpactEnergy {
        self.energy
    }
}

impl<const N: usize> InWords for Booked<N> {
    fn each(&mut self, words: &mut impl Words) {
        for impulse in &mut self.impulses {
            words.numbers([&mut impulse.time, &mut impulse.size]);
        }
        let ImpactEnergy { last, lost, work } = &mut self.energy;
        words.numbers([last, lost, work, &mut self.time]);
    }
}
