//! Optimal control: inputs of a mechanism that are constant in intervals, for the least cost.

mod curvature;
mod optimum;
mod problem;
mod quadratic;
mod restore;
mod sequential;
mod values;

pub use optimum::Optimum;

use self::problem::Transcription;
use crate::optimise::error::{Error, place};
use crate::optimise::mechanism::{ByDop853, Integration, Optimisable};
use crate::optimise::stack::on_large_stack;

/// A mechanism, a grid of intervals, and the demands on its motion.
///
/// The inputs are found by sequential quadratic programming on exact derivatives of the runs. All numbers are in SI.
///
/// ```
/// use plm::optimise::Control;
/// # use plm::dynamic::{Compiled, Dynamic};
/// # let text = "pub Cart { input push: N = 0 N; ground { port o: (0, 0) m; } body cart { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start vx: 0 m/s, locked; } prismatic rail(ground.o, cart.o) { drive: push; } output cart.x, cart.vx; }";
/// # let cart: Dynamic<f64, 9, 8, 32, 9> = Compiled::new("cart", text)?.mechanism()?;
/// // A cart of 1 kg goes 1 m in 1 s, from rest to rest, with the least integral of the square of its force.
/// let best = Control::new(cart, 20)
///     .duration(1.0)
///     .input("push", -20.0, 20.0)
///     .effort("push", 1.0)
///     .at_end("cart.x", 1.0)
///     .at_end("cart.vx", 0.0)
///     .run()?;
/// assert!((best.cost - 12.0).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Control<M> {
    mechanism: M,
    intervals: usize,
    /// Guess, least and largest duration, s.
    duration: [f64; 3],
    inputs: Vec<Input>,
    ends: Vec<(String, f64)>,
    paths: Vec<(String, [f64; 2])>,
    costs: Vec<Cost>,
    /// Intervals of a segment.
    segment: usize,
    iterations: usize,
}

/// An input that is found.
#[derive(Clone, Debug)]
struct Input {
    name: String,
    bounds: [f64; 2],
    guess: Vec<f64>,
}

/// A part of the cost.
#[derive(Clone, Debug)]
enum Cost {
    /// The integral of the square of an input.
    Effort { input: String, weight: f64 },
    /// The sum over the ends of the intervals of the square of an output less a value, times the length of an interval.
    Deviation { output: String, value: f64, weight: f64 },
    /// The square of an output less a value, at the end.
    EndDeviation { output: String, value: f64, weight: f64 },
    /// An output at the end, such as a first-order state that integrates a power.
    End { output: String, weight: f64 },
    /// The duration.
    Time { weight: f64 },
}

impl Cost {
    /// Its numbers, each with what it belongs to; the root of a weight that is negative is no number.
    fn numbers(&self) -> Vec<(&str, f64)> {
        let root = |weight: f64| if weight >= 0.0 { weight } else { f64::NAN };
        match self {
            Self::Effort { input, weight } => vec![(input, root(*weight))],
            Self::Deviation { output, value, weight } | Self::EndDeviation { output, value, weight } => {
                vec![(output, *value), (output, root(*weight))]
            }
            Self::End { output, weight } => vec![(output, *weight)],
            Self::Time { weight } => vec![("duration", *weight)],
        }
    }
}

impl<M: Optimisable> Control<M> {
    /// Motions of so many intervals of equal length, which are asked for nothing yet.
    pub fn new(mechanism: M, intervals: usize) -> Self {
        Self {
            mechanism,
            intervals: intervals.max(1),
            duration: [1.0; 3],
            inputs: Vec::new(),
            ends: Vec::new(),
            paths: Vec::new(),
            costs: Vec::new(),
            segment: 1,
            iterations: 500,
        }
    }

    /// Sets the duration, s; 1 s without.
    #[must_use]
    pub fn duration(self, duration: f64) -> Self {
        Self { duration: [duration; 3], ..self }
    }

    /// Has the duration found within bounds, s, from a guess.
    #[must_use]
    pub fn duration_within(self, guess: f64, least: f64, most: f64) -> Self {
        Self { duration: [guess, least, most], ..self }
    }

    /// Has an input found within bounds; they may be infinite. The search begins at zero, or at the bound next to it.
    #[must_use]
    pub fn input(mut self, name: &str, least: f64, most: f64) -> Self {
        self.inputs.push(Input { name: name.to_owned(), bounds: [least, most], guess: Vec::new() });
        self
    }

    /// Begins the search for the last input at these values, one for each interval; the last of them holds for all others.
    #[must_use]
    pub fn from(mut self, guess: impl Into<Vec<f64>>) -> Self {
        if let Some(input) = self.inputs.last_mut() {
            input.guess = guess.into();
        }
        self
    }

    /// Demands a value of an output at the end.
    #[must_use]
    pub fn at_end(mut self, output: &str, value: f64) -> Self {
        self.ends.push((output.to_owned(), value));
        self
    }

    /// Bounds an output at the end of each interval.
    #[must_use]
    pub fn within(mut self, output: &str, least: f64, most: f64) -> Self {
        self.paths.push((output.to_owned(), [least, most]));
        self
    }

    /// Adds to the cost the integral of the square of an input times a weight.
    #[must_use]
    pub fn effort(mut self, input: &str, weight: f64) -> Self {
        self.costs.push(Cost::Effort { input: input.to_owned(), weight });
        self
    }

    /// Adds to the cost the squares of an output less a value at the ends of the intervals, times their length and a weight.
    #[must_use]
    pub fn deviation(mut self, output: &str, value: f64, weight: f64) -> Self {
        self.costs.push(Cost::Deviation { output: output.to_owned(), value, weight });
        self
    }

    /// Adds to the cost the square of an output less a value at the end, times a weight.
    #[must_use]
    pub fn end_deviation(mut self, output: &str, value: f64, weight: f64) -> Self {
        self.costs.push(Cost::EndDeviation { output: output.to_owned(), value, weight });
        self
    }

    /// Adds to the cost an output at the end times a weight, such as a first-order state that integrates a power.
    #[must_use]
    pub fn end(mut self, output: &str, weight: f64) -> Self {
        self.costs.push(Cost::End { output: output.to_owned(), weight });
        self
    }

    /// Adds to the cost the duration times a weight, per s.
    #[must_use]
    pub fn time(mut self, weight: f64) -> Self {
        self.costs.push(Cost::Time { weight });
        self
    }

    /// Shoots in segments of so many intervals; 1 without, and all of them for single shooting. The states in which segments begin are
    /// variables. Contacts and loops are to be in the same modes and charts as with the guesses there.
    #[must_use]
    pub fn shoot(self, intervals: usize) -> Self {
        Self { segment: intervals.max(1), ..self }
    }

    /// Ends the search after so many iterations; 500 without.
    #[must_use]
    pub fn iterations(self, most: usize) -> Self {
        Self { iterations: most, ..self }
    }

    /// Finds the inputs with runs by Dormand and Prince of order 8 and the tolerance 1e-10.
    ///
    /// # Errors
    /// As [`run_by`](Self::run_by).
    pub fn run(&self) -> Result<Optimum, Error> {
        self.run_by(ByDop853::default())
    }

    /// Finds the inputs with runs by a method.
    ///
    /// # Errors
    /// Names that are not there; a run with the guesses that ends with a fault; a search that does not end at a minimum that keeps all
    /// that is demanded.
    pub fn run_by(&self, integration: impl Integration<M>) -> Result<Optimum, Error> {
        on_large_stack(|| self.found_by(integration))
    }

    fn found_by(&self, integration: impl Integration<M>) -> Result<Optimum, Error> {
        self.check()?;
        let mut transcription = Transcription::new(self, integration)?;
        let start = transcription
            .start()
            .map_err(|fault| Error::AtGuess { experiment: 0, fault: Box::new(fault) })?;
        let found = sequential::minimise(&mut transcription, start, self.iterations)?;
        Ok(transcription.optimum(&found))
    }

    fn check(&self) -> Result<(), Error> {
        if self.inputs.is_empty() {
            return Err(Error::Nothing("input to be found"));
        }
        let [guess, least, most] = self.duration;
        let in_order = |[least, most]: [f64; 2]| least <= most;
        let senseless = |name: &str, guess, bounds| Error::Senseless { name: name.to_owned(), guess, bounds };
        if !(least > 0.0 && in_order([least, most]) && most.is_finite() && guess.is_finite()) {
            return Err(senseless("duration", guess, [least, most]));
        }
        for Input { name, bounds, .. } in &self.inputs {
            if !in_order(*bounds) {
                return Err(senseless(name, 0.0, *bounds));
            }
        }
        let wrong = self.paths.iter().find(|(_, bounds)| !in_order(*bounds));
        wrong.map_or(Ok(()), |(name, bounds)| Err(senseless(name, 0.0, *bounds)))?;
        let guesses = self.inputs.iter().flat_map(|own| own.guess.iter().map(|guess| (&own.name, *guess)));
        let ends = self.ends.iter().map(|(name, value)| (name, *value));
        let costs = self.costs.iter().flat_map(Cost::numbers);
        let mut numbers = guesses.chain(ends).map(|(name, number)| (name.as_str(), number)).chain(costs);
        let anything = [f64::NEG_INFINITY, f64::INFINITY];
        numbers
            .find(|(_, number)| !number.is_finite())
            .map_or(Ok(()), |(name, number)| Err(senseless(name, number, anything)))
    }

    fn input_number(&self, name: &str) -> Result<usize, Error> {
        place("input to be found", name, self.inputs.iter().map(|input| input.name.as_str()))
    }
}
