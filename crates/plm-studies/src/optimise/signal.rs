//! Piecewise constant inputs, and runs that follow them with samples at any times.

use plm_runtime::{Described, Fault, Method, Moment, Scalar, Sim};

/// An input that is constant from each of its times to the next.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Signal {
    /// Number of the input.
    pub(crate) input: usize,
    /// Times at which the values begin, ascending, s. The first value holds before its time too.
    pub(crate) times: Vec<f64>,
    /// Values, SI.
    pub(crate) values: Vec<f64>,
}

impl Signal {
    /// The number of the value that holds from a time on.
    pub(crate) fn piece(&self, time: f64) -> usize {
        self.times.partition_point(|begins| *begins <= time).saturating_sub(1)
    }
}

/// Inputs and sample times of a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Schedule<'a> {
    /// The inputs that are not as declared.
    pub(crate) signals: &'a [Signal],
    /// Times of the samples, ascending, s. One at which an input changes is taken before the change.
    pub(crate) samples: &'a [f64],
    /// Last time of the run, s.
    pub(crate) end: f64,
}

/// Times and values of a schedule in the numbers of a run.
pub(crate) trait Numbers<S> {
    /// A time, s.
    fn time(&self, time: f64) -> S;
    /// The value of a signal that holds in one of its pieces.
    fn value(&self, signal: usize, piece: usize) -> S;
}

/// Gives the inputs the values that hold from the time of a run on.
pub(crate) fn set_inputs<L: Described>(
    held: &mut L::U,
    time: f64,
    signals: &[Signal],
    numbers: &impl Numbers<L::S>,
) {
    for (k, signal) in signals.iter().enumerate() {
        if let Some(input) = L::input(L::inputs(held), signal.input) {
            *input = numbers.value(k, signal.piece(time));
        }
    }
}

impl Schedule<'_> {
    /// Takes a run, whose inputs are set, to its end, and shows the samples by number.
    ///
    /// # Errors
    /// Those of the run.
    pub(crate) fn follow<L: Described, I: Method<L>>(
        &self,
        sim: &mut Sim<L, I>,
        numbers: &impl Numbers<L::S>,
        see: &mut impl FnMut(usize, &L::State),
    ) -> Result<(), Fault> {
        let begin = sim.state().time().to_f64();
        let mut next = 0;
        while let Some(time) = self.samples.get(next).filter(|time| **time <= begin) {
            debug_assert!(*time >= begin, "a sample before the run");
            see(next, sim.state());
            next += 1;
        }
        for stop in self.stops(begin) {
            self.advance(sim, stop, &mut next, numbers, see)?;
            if stop < self.end {
                let state = sim.state();
                let (mechanism, mut held, time, x) =
                    (*state.mechanism(), state.held(), state.time(), *state.x());
                set_inputs::<L>(&mut held, stop, self.signals, numbers);
                **sim = Moment::new(mechanism, held, time, x);
            }
        }
        Ok(())
    }

    /// Times after `begin` at which an input changes, and the end.
    fn stops(&self, begin: f64) -> Vec<f64> {
        let changes = self.signals.iter().flat_map(|signal| signal.times.iter().skip(1).copied());
        let mut stops: Vec<f64> = changes.filter(|time| *time > begin && *time < self.end).collect();
        stops.push(self.end);
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        stops
    }

    /// Takes a run to a time by steps of its method, with samples by its dense output.
    fn advance<L: Described, I: Method<L>>(
        &self,
        sim: &mut Sim<L, I>,
        stop: f64,
        next: &mut usize,
        numbers: &impl Numbers<L::S>,
        see: &mut impl FnMut(usize, &L::State),
    ) -> Result<(), Fault> {
        let due = |next: usize, until: f64| self.samples.get(next).copied().filter(|time| *time <= until);
        while sim.state().time().to_f64() < stop {
            let end = numbers.time(stop);
            if !sim.method().is_dense() || due(*next, stop).is_none_or(|time| time >= stop) {
                // Nothing is to be seen on the way, or only at ends of steps.
                let until = due(*next, stop).unwrap_or(stop);
                sim.step_to(if until < stop { numbers.time(until) } else { end })?;
            } else {
                let left = end - sim.state().time();
                Sim::watch_while(sim, end, left, |_| (), |_| false)?;
            }
            let now = sim.state().time().to_f64();
            while let Some(time) = due(*next, now) {
                if time < now {
                    see(*next, &sim.at(numbers.time(time))?);
                } else {
                    see(*next, sim.state());
                }
                *next += 1;
            }
        }
        Ok(())
    }
}
