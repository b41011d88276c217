//! Numbers that nobody means, into public functions that take some: each call ends, and none panics.
//!
//! A call runs on a thread of its own, which is left alone where it does not end in time.

mod analysis;
mod fits;
mod runs;
mod synthesis;
mod tables;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use crate::draw::Draw;
use crate::sweep::{Case, Verdict};

/// Outcome of a call that has ended.
pub(crate) enum Outcome {
    /// A result, of a function that has no errors or whose errors are not for numbers.
    Done,
    /// A result of a function that refuses what is no number.
    Accepted,
    /// The words of an error.
    Refused(String),
}

/// A public function with hostile numbers.
pub(crate) struct Call {
    pub(crate) name: &'static str,
    pub(crate) call: fn(&mut Hostile) -> Outcome,
}

/// Numbers, half of which are hostile.
pub(crate) struct Hostile {
    pub(crate) draw: Draw,
    drawn: Arc<Mutex<Vec<f64>>>,
}

/// Numbers that formulas, loops and comparisons stumble over.
const HOSTILE: [f64; 14] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e-300,
    -1e-300,
    1e300,
    -1e300,
    0.0,
    -0.0,
    f64::MAX,
    f64::MIN_POSITIVE,
    5e-324,
    1.0,
    -1.0,
];

impl Hostile {
    pub(crate) fn number(&mut self) -> f64 {
        self.within(-2.0, 2.0)
    }

    /// A hostile one, else one between two.
    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        let number =
            if self.draw.chance(0.4) { *self.draw.one_of(&HOSTILE) } else { self.draw.rounded(low, high) };
        if let Ok(mut drawn) = self.drawn.lock() {
            drawn.push(number);
        }
        number
    }

    pub(crate) fn numbers<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.number())
    }

    pub(crate) fn list(&mut self, most: usize) -> Vec<f64> {
        (0..self.draw.below(most + 1)).map(|_| self.number()).collect()
    }
}

/// A call that takes longer does not end.
const DEADLINE: Duration = Duration::from_secs(60);

pub(crate) fn case(draw: &mut Draw) -> Case {
    let all: Vec<&Call> = [synthesis::CALLS, analysis::CALLS, fits::CALLS, runs::CALLS, tables::CALLS]
        .into_iter()
        .flatten()
        .collect();
    let call = *draw.one_of(&all);
    let seed = draw.below(1 << 30) as u64;
    let drawn = Arc::new(Mutex::new(Vec::new()));
    let mut hostile = Hostile { draw: Draw::new(seed, 0), drawn: Arc::clone(&drawn) };
    let (sender, receiver) = channel();
    let work = move || {
        let outcome = catch_unwind(AssertUnwindSafe(|| (call.call)(&mut hostile)));
        // Nobody listens after the deadline.
        let _ = sender.send(outcome.map_err(|panic| text_of(&*panic)));
    };
    let verdict = match thread::Builder::new().stack_size(32 << 20).spawn(work) {
        Err(why) => Verdict::Undecided(why.to_string()),
        Ok(_) => match receiver.recv_timeout(DEADLINE) {
            Ok(outcome) => judged(outcome, &drawn),
            Err(RecvTimeoutError::Timeout) => Verdict::Wrong(format!("no end within {DEADLINE:?}")),
            Err(RecvTimeoutError::Disconnected) => Verdict::Wrong("its thread is gone".to_owned()),
        },
    };
    let numbers = drawn.lock().map(|drawn| drawn.clone()).unwrap_or_default();
    Case { family: call.name.to_owned(), text: format!("{} with {numbers:?}", call.name), verdict }
}

fn judged(outcome: Result<Outcome, String>, drawn: &Mutex<Vec<f64>>) -> Verdict {
    let has_nan = drawn.lock().is_ok_and(|drawn| drawn.iter().any(|own| own.is_nan()));
    match outcome {
        Err(panic) => Verdict::Wrong(format!("panics: {panic}")),
        Ok(Outcome::Accepted) if has_nan => Verdict::Wrong("takes what is no number for one".to_owned()),
        Ok(Outcome::Refused(words)) if words.is_empty() => {
            Verdict::Wrong("an error without words".to_owned())
        }
        Ok(Outcome::Refused(words)) => Verdict::Stopped(words),
        Ok(_) => Verdict::Right(0.0),
    }
}

fn text_of(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// The outcome of a result whose errors refuse numbers.
pub(crate) fn refusing<T, E: std::fmt::Display>(result: Result<T, E>) -> Outcome {
    result.map_or_else(|error| Outcome::Refused(error.to_string()), |_| Outcome::Accepted)
}

/// The outcome of a result whose errors are about something else than numbers.
pub(crate) fn ended<T, E: std::fmt::Display>(result: Result<T, E>) -> Outcome {
    result.map_or_else(|error| Outcome::Refused(error.to_string()), |_| Outcome::Done)
}
