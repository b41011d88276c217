//! Loops in charts.

use plm_runtime::Real;
use plm_runtime::charts::{Charted, Charts, OfLoops};

use crate::handle::{Dynamic, Frame, Held};
use crate::memory::Memory;
use crate::model::WITHOUT_LOOPS;

impl<
    S: Real,
    const NQ: usize,
    const NC: usize,
    const N: usize,
    const L: usize,
    const H: usize,
    const R: usize,
    const P: usize,
> Charted for Dynamic<S, NQ, NC, N, L, H, R, P>
{
    type Input = [S; H];
    type Switches = [S; H];
    type Turns = [i32; NQ];
    type Contact = plm_runtime::contact::Held<S, R>;
    type Continuation = Memory<S, L>;
    type Q = [S; NQ];
    // Those of lanes alone, which no mechanism at run time has.
    const CHARTS: Charts = WITHOUT_LOOPS;

    fn charts(&self) -> &'static Charts {
        &self.model.charts
    }

    fn has_charts(&self) -> bool {
        self.is_charted()
    }

    fn pose(&self, t: S, held: &Held<S, NQ, L, H, R>, x: &[S; N]) -> ([S; NQ], [S; NQ], S) {
        let (mut q, mut v) = ([S::ZERO; NQ], [S::ZERO; NQ]);
        let chart = match &held.of_loops {
            OfLoops::InChart { chart, .. } => self.model.in_charts.get(*chart),
            OfLoops::Free { q, v } => return (*q, *v, S::ZERO),
        };
        let frame = Frame::of_state(t, held, x);
        let measure = chart.map_or(S::ZERO, |chart| self.run(&chart.pose, &frame, [&mut q, &mut v]));
        (q, v, measure)
    }

    fn continuation(&self, t: S, held: &Held<S, NQ, L, H, R>, x: &[S; N]) -> (Memory<S, L>, S) {
        let remember = match held.of_loops {
            OfLoops::InChart { chart, .. } => {
                self.model.in_charts.get(chart).and_then(|chart| chart.remember.as_ref())
            }
            OfLoops::Free { .. } => None,
        };
        let nothing = || (Memory::new(self.model.counts), S::ZERO);
        remember.map_or_else(nothing, |remember| self.remembered(remember, &Frame::of_state(t, held, x)))
    }

    fn continuation_at(&self, chart: usize, t: S, q: &[S; NQ], v: &[S; NQ]) -> (Memory<S, L>, S) {
        let remember = self.model.in_charts.get(chart).and_then(|chart| chart.remember_pose.as_ref());
        let nothing = || (Memory::new(self.model.counts), S::ZERO);
        remember.map_or_else(nothing, |remember| self.remembered(remember, &Frame::of_pose(t, q, v)))
    }

    fn to_chart(&self, chart: usize, t: S, q: &[S; NQ], v: &[S; NQ], x: &mut [S; N]) {
        if let Some(chart) = self.model.in_charts.get(chart) {
            self.run(&chart.from_pose, &Frame::of_pose(t, q, v), [x]);
        }
    }
}
