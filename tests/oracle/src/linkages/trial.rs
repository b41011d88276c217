//! Runs of a case beside the motion that is known, and errors of steps alone.

use crate::cases::Case;
use crate::judge::{Known, LIVELY, Mode, Verdict};
use crate::run::{By, EVERY, Order, Outcome};

/// Steps of a millisecond may be off by this part of the size, more in a lively motion.
const ROUGH: f64 = 1e-2;
/// An error of up to so many times the bound may be that of steps alone: ...
const MOST_BY_STEPS: f64 = 10.0;
/// ... then it is a tenth at most at a hundredth of the tolerance, and falls with fixed steps of a quarter as their order says.
const FINER: f64 = 100.0;
const LESS: f64 = 0.1;

/// A case in a mode, by a method.
pub struct Trial<'c> {
    pub case: &'c Case,
    pub mode: Mode,
    pub by: By,
    pub known: &'c Known,
    /// By how much the motion multiplies a change at its start.
    pub lively: f64,
}

/// A run of it.
pub struct Run {
    pub outcome: Outcome,
    /// The largest error as a multiple of the bound, and the time of the first that is more.
    pub ratio: f64,
    pub first: Option<f64>,
    /// The largest error as a part of the size.
    pub worst: f64,
}

impl Trial<'_> {
    /// With steps, or a tolerance, divided by a number.
    pub fn run(&self, finer: f64) -> Run {
        self.run_in(self.mode, finer)
    }

    fn run_in(&self, mode: Mode, finer: f64) -> Run {
        let Self { case, by, .. } = *self;
        let (numbers, starts) = (case.scene.numbers(), case.starts());
        let (samples, pace) = (case.samples, case.pace);
        self.beside(mode.run(case, &Order { numbers: &numbers, starts: &starts, samples, by, pace, finer }))
    }

    /// The verdict on a run that is off, or stops, by the error of its steps alone; nothing where it is right or that does not explain it.
    pub fn excuse(&self, run: &Run) -> Option<Verdict> {
        match (self.by.fixed(), run.outcome.fault.is_some()) {
            (true, stops) if stops || run.ratio > 1.0 => self.fixed_steps(run),
            (false, false) if (1.0..MOST_BY_STEPS).contains(&run.ratio) => {
                let finer = self.run(FINER);
                let falls = finer.outcome.fault.is_none() && finer.worst < LESS * run.worst;
                falls.then_some(Verdict::Coarse)
            }
            _ => None,
        }
    }

    /// The length of fixed steps decides how exact they are: they may be off by so much, if shorter ones come nearer to the reference. In
    /// f32 shorter ones add up more rounding; there the same steps in f64 must be off by as much.
    fn fixed_steps(&self, run: &Run) -> Option<Verdict> {
        let most = ROUGH * (self.lively / LIVELY).max(1.0);
        if self.mode == Mode::Single {
            let double = self.run_in(Mode::Default, 1.0);
            let excused = run.outcome.fault.is_none() && run.worst < most && run.worst < 2.0 * double.worst;
            return excused.then_some(Verdict::Right);
        }
        let [fourth, last] = [4.0, 16.0].map(|finer| self.run(finer));
        if last.outcome.fault.is_some() || last.worst >= 0.1 * fourth.worst && last.ratio > 1.0 {
            return None;
        }
        // A motion that goes another way is off by more than the order of a method explains.
        let by_order = run.worst < 4_f64.powi(self.by.order() + 1) * fourth.worst;
        match run.worst {
            worst if worst < most => Some(Verdict::Right),
            worst if worst < MOST_BY_STEPS * most && by_order => Some(Verdict::Coarse),
            _ => None,
        }
    }

    /// An outcome beside the reference.
    fn beside(&self, outcome: Outcome) -> Run {
        let Self { known, mode, by, .. } = *self;
        let allowed = mode.allowed(by);
        let (mut ratio, mut first, mut worst) = (0.0_f64, None, 0.0_f64);
        for seen in &outcome.seen {
            let error = known.sizes.error(seen, &known.samples[seen.index]);
            let here = error / (allowed * (known.growth[seen.index] / LIVELY).max(1.0));
            // What is not a number is wrong.
            let here = if here.is_nan() { f64::INFINITY } else { here };
            if here > 1.0 && first.is_none() {
                first = Some(EVERY * seen.index as f64);
            }
            ratio = ratio.max(here);
            worst = worst.max(if error.is_nan() { f64::INFINITY } else { error });
        }
        Run { outcome, ratio, first, worst }
    }
}
