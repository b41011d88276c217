//! Guards over steps of fixed length, which end where they end: what comes and goes between is told, and not met.

use super::heeded::{Heeded, bit};
use super::search::{Found, Search};
use super::{Event, Watch, guards_here};
use crate::fault::Fault;
use crate::method::{Course, Method, Path};
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

    /// What happens behind a step without dense output, by its guards where they need a look; of others it is known.
    #[inline]
    pub(crate) fn look_behind<M: System<S = S, G = G>, I: Method<M>>(
        &mut self,
        course: &Course<'_, M>,
        kept: &mut Kept<M>,
        start: &Begun<M>,
        event: Event,
    ) -> Result<Event, Fault> {
        if I::DENSE || G::LEN == 0 {
            return Ok(event);
        }
        let leg = course.leg((start.time, &start.x));
        let holds = kept.begun.as_ref().is_some_and(|centre| self.calm.holds(centre, &leg));
        if holds || self.calm.renew(&mut kept.begun, &leg) {
            return Ok(Event::None);
        }
        guards_here(course)?;
        Ok(Event::Behind { missed: self.missed(course, start) })
    }

    /// Looks for conditions that come and go within a step of a method without dense output, which ends where it ends.
    #[cold]
    fn missed<M: System<S = S, G = G>>(
        &self,
        course: &Course<'_, M>,
        start: &Begun<M>,
    ) -> Option<(usize, u64)> {
        let path = Path::between((start.time, &start.x), (course.time, &course.x), M::NQ);
        let (system, held) = (course.system, course.held);
        let search = || Search::new((system, held), path, &self.left_over, Heeded::ALL);
        if !matches!(search().first(), Found::Crossing(..)) {
            return None;
        }
        let leaves = |index: usize| matches!(search().of_one(index).first(), Found::Crossing(..));
        let all = (0..G::LEN).filter(|i| M::SELECTIVE && leaves(*i)).fold(0, |all, i| all | bit(i));
        let (heeded, mut missed) = (Heeded::of(system, &held, all), None);
        for index in (0..G::LEN).filter(|i| heeded.has(*i)) {
            let search = search().of_one(index);
            if matches!(search.first(), Found::Crossing(..)) && !search.is_past(S::lit(1.0), index) {
                let (first, count) = missed.unwrap_or((index, 0));
                let ends = course.system.must_hold(index) || course.system.end(index).is_some();
                let told = if ends { index } else { first };
                missed = Some((told, count + 1));
            }
        }
        missed
    }
}
