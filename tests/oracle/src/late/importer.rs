//! A solver outside, of equal steps by Kutta's formula.

use plm_foreign::fmi::{Call, Instance, Variable};
use plm_runtime::{Moment, Rate, Vector};

use super::Mechanism;

/// How it finds events.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Finds {
    /// By bisection for the time at which an indicator changes its sign.
    ByHalves,
    /// By indicators at the ends of its steps.
    AtSteps,
    /// As completed steps tell it, without a look at indicators.
    ByCompletedSteps,
}

type X = <Mechanism as Rate>::X;

/// Steps of a length, s, and events that are handed over so late, s.
pub(super) struct Importer {
    pub(super) instance: Instance<Mechanism>,
    step: f64,
    finds: Finds,
    late: f64,
    events: usize,
}

impl Importer {
    pub(super) fn new(instance: Instance<Mechanism>, step: f64, (finds, late): (Finds, f64)) -> Self {
        Self { instance, step, finds, late, events: 0 }
    }

    /// To a time, s, or a little farther where an event is handed over late; with so many events at most after the start.
    pub(super) fn run(&mut self, until: f64, most: usize) -> Result<(), String> {
        let told = |error: plm_foreign::Error| error.to_string();
        self.instance.renew().map_err(told)?;
        self.instance.pass(Call::ExitInitializationMode);
        self.instance.update().map_err(told)?;
        self.instance.pass(Call::EnterContinuousTimeMode);
        while self.time()? < until {
            self.advance(until).map_err(told)?;
            if self.events > most {
                let time = self.time()?;
                return Err(format!("{} events until {time} s", self.events));
            }
        }
        Ok(())
    }

    pub(super) fn time(&mut self) -> Result<f64, String> {
        self.instance.get(Variable::Time).map_err(|error| error.to_string())
    }

    fn advance(&mut self, until: f64) -> Result<(), plm_foreign::Error> {
        let from = {
            let state = self.instance.state()?;
            (state.time(), *state.x())
        };
        let h = self.step.min(until - from.0);
        self.lead(&from, h)?;
        if self.finds != Finds::ByCompletedSteps && self.is_beyond()? {
            if self.finds == Finds::ByHalves {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..45 {
                    let middle = 0.5 * (low + high);
                    self.lead(&from, middle)?;
                    if self.is_beyond()? { high = middle } else { low = middle }
                }
                self.lead(&from, high + self.late)?;
            }
            self.instance.accept()?;
            return self.event();
        }
        if self.instance.accept()? { self.event() } else { Ok(()) }
    }

    fn is_beyond(&mut self) -> Result<bool, plm_foreign::Error> {
        Ok(self.instance.indicators()?.iter().any(|indicator| *indicator < 0.0))
    }

    fn rates(&mut self, time: f64, x: X) -> Result<X, plm_foreign::Error> {
        self.instance.place(Some(time), Some(x))?;
        self.instance.rates()
    }

    fn lead(&mut self, (time, x): &(f64, X), h: f64) -> Result<(), plm_foreign::Error> {
        let along = |k: &X, part: f64| x.map2(k, |x, k| x + part * h * k);
        let first = self.rates(*time, *x)?;
        let second = self.rates(time + 0.5 * h, along(&first, 0.5))?;
        let third = self.rates(time + 0.5 * h, along(&second, 0.5))?;
        let fourth = self.rates(time + h, along(&third, 1.0))?;
        let sum = first.map2(&second, |a, b| a + 2.0 * b).map2(&third, |a, b| a + 2.0 * b);
        let mean = sum.map2(&fourth, |a, b| (a + b) / 6.0);
        self.instance.place(Some(time + h), Some(along(&mean, 1.0)))
    }

    fn event(&mut self) -> Result<(), plm_foreign::Error> {
        self.events += 1;
        self.instance.pass(Call::EnterEventMode);
        self.instance.update()?;
        self.instance.pass(Call::EnterContinuousTimeMode);
        Ok(())
    }
}
