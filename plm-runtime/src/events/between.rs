//! Guards over steps of fixed length, which end where they end: what comes and goes between is told, and not met.

use super::heeded::{Heeded, bit};
use super::search::{Found, Search};
use super::{Watch, guards_here};
use crate::fault::Fault;
use crate::method::{Course, Path};
use crate::scalar::Real;
use crate::sim::{Begun, Kept};
use crate::system::{Leg, System};
use crate::vector::Vector;

impl<S: Real, G: Vector<S>> Watch<S, G> {
    /// Do all guards stay on their sides over a step of fixed length, by what is known already?
    #[inline]
    pub(crate) fn is_calm<M: System<S = S, G = G>>(&self, kept: &Kept<M>, leg: &Leg<'_, M>) -> bool {
        G::LEN == 0 || kept.begun.as_ref().is_some_and(|centre| self.calm.holds(centre, leg))
    }

    /// Looks at the guards in a step of a method without dense output, if they need it.
    #[inline]
    pub(super) fn look_between<M: System<S = S, G = G>>(
        &mut self,
        course: &mut Course<'_, M>,
        start: &Begun<M>,
    ) -> Result<(), Fault> {
        let (mut kept, leg) = (course.kept.take(), course.leg((start.time, &start.x)));
        self.is_calm = kept.as_deref_mut().is_some_and(|kept| {
            let holds = kept.begun.as_ref().is_some_and(|centre| self.calm.holds(centre, &leg));
            holds || self.calm.renew(&mut kept.begun, &leg)
        });
        course.kept = kept;
        if self.is_calm {
            return Ok(());
        }
        guards_here(course)?;
        self.look_closely(course, start);
        Ok(())
    }

    /// Looks for conditions that come and go within a step of a method without dense output, which ends where it ends.
    #[cold]
    fn look_closely<M: System<S = S, G = G>>(&mut self, course: &Course<'_, M>, start: &Begun<M>) {
        let path = Path::between((start.time, &start.x), (course.time, &course.x), M::NQ);
        let (system, held) = (course.system, course.held);
        let search = || Search::new((system, held), path, &self.left_over, Heeded::ALL);
        self.brief = None;
        if !matches!(search().first(), Found::Crossing(..)) {
            return;
        }
        let leaves = |index: usize| matches!(search().of_one(index).first(), Found::Crossing(..));
        let all = (0..G::LEN).filter(|i| M::SELECTIVE && leaves(*i)).fold(0, |all, i| all | bit(i));
        let heeded = Heeded::of(system, &held, all);
        for index in (0..G::LEN).filter(|i| heeded.has(*i)) {
            let search = search().of_one(index);
            if matches!(search.first(), Found::Crossing(..)) && !search.is_past(S::lit(1.0), index) {
                let (first, count) = self.brief.unwrap_or((index, 0));
                let ends = course.system.must_hold(index) || course.system.end(index).is_some();
                let told = if ends { index } else { first };
                self.brief = Some((told, count + 1));
            }
        }
    }
}
