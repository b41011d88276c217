//! Many runs of a mechanism, over a list or a grid of parameter values, on all cores.
//!
//! Runs are independent: the other runs, their order and the number of threads do not change the bits of a result. A run that fails, by a
//! fault or by a panic, is reported with its place and its parameters, and the results of the others are unaffected. The book has an
//! example (`docs/src/running/batch.md`).

use std::any::Any;
use std::fmt;
use std::ops::Deref;
use std::panic::{AssertUnwindSafe, catch_unwind};

use indicatif::{ProgressBar, ProgressStyle};
use plm_runtime::lanes::Pack;
use plm_runtime::method::{Embedded, Pair};
use plm_runtime::{Fault, Sim};
use rayon::prelude::*;

use crate::together::{TOGETHER, together};

/// Points of a batch, one for each run.
#[derive(Clone, Debug)]
pub struct Points<P> {
    list: Vec<P>,
    threads: usize,
    stack: usize,
    shows_progress: bool,
}

/// Bytes of stack that each thread has where nothing else is said: what programs give their main thread.
pub(crate) const STACK: usize = 8 << 20;

/// No more threads are started: no machine has more cores to give them.
pub(crate) const MOST_THREADS: usize = 1024;

/// One run for each element.
pub fn points<P>(list: impl IntoIterator<Item = P>) -> Points<P> {
    Points { list: list.into_iter().collect(), threads: 0, stack: STACK, shows_progress: true }
}

/// One run for each pair; the second varies fastest.
pub fn grid<A: Copy, B: Copy>(a: &[A], b: &[B]) -> Points<(A, B)> {
    points(a.iter().flat_map(|&a| b.iter().map(move |&b| (a, b))))
}

/// One run for each triple; the last varies fastest.
pub fn grid3<A: Copy, B: Copy, C: Copy>(a: &[A], b: &[B], c: &[C]) -> Points<(A, B, C)> {
    points(a.iter().flat_map(|&a| b.iter().flat_map(move |&b| c.iter().map(move |&c| (a, b, c)))))
}

impl<P: Clone + Send> Points<P> {
    /// On so many threads, or fewer where the system has no more to give, 1024 at most; one for each core where this is not said.
    #[must_use]
    pub fn threads(self, threads: usize) -> Self {
        Self { threads, ..self }
    }

    /// With so many bytes of stack for each thread, 8 MiB where this is not said. Very large mechanisms need more, above all in
    /// builds without optimisation, and those that run by rank [`Mechanism::WORKSPACE`](plm_runtime::Mechanism::WORKSPACE)
    /// besides: a stack that overflows ends the program, with all runs.
    #[must_use]
    pub fn stack(self, bytes: usize) -> Self {
        Self { stack: bytes, ..self }
    }

    /// Without a progress bar. There is none either where standard error is no terminal.
    #[must_use]
    pub fn quiet(self) -> Self {
        Self { shows_progress: false, ..self }
    }

    /// Runs all points; `run` builds, starts and steps a mechanism, and returns its result.
    pub fn run<T: Send>(self, run: impl Fn(P) -> Result<T, Fault> + Sync) -> Runs<P, T> {
        let Points { list, threads, stack, shows_progress } = self;
        let bar = if shows_progress { progress_bar(list.len()) } else { ProgressBar::hidden() };
        let one = |(index, parameters): (usize, P)| {
            let point = parameters.clone();
            let result = match caught(|| run(point)) {
                Ok(result) => result.map_err(Failure::Fault),
                Err(words) => Err(Failure::Panic(words)),
            };
            bar.inc(1);
            Run { index, parameters, result }
        };
        // A run can take a second: threads take them one by one.
        let all = || list.into_par_iter().enumerate().with_max_len(1).map(one).collect();
        let runs = on_threads(threads, stack, all);
        bar.finish_and_clear();
        Runs { runs }
    }
}

impl<P: Clone + Send + Sync> Points<P> {
    /// Runs the simulation of each point to a time, s: `start` assembles it, and `result` looks at it there. With the feature `lanes` each core
    /// has eight of them side by side in vector registers, which have the bits of runs one by one; those with conditions, kinks or rows of
    /// contact, and in absolute coordinates, go alone.
    pub fn run_to<M: Pack<S = f64, State: Send> + Send, Q: Pair + Send, T: Send>(
        self,
        until: f64,
        start: impl Fn(P) -> Result<Sim<M, Embedded<M, Q>>, Fault> + Sync,
        result: impl Fn(&Sim<M, Embedded<M, Q>>) -> T + Sync,
    ) -> Runs<P, T> {
        let Points { list, threads, stack, shows_progress } = self;
        let bar = if shows_progress { progress_bar(list.len()) } else { ProgressBar::hidden() };
        let some = |(part, points): (usize, &[P])| {
            let mut runs = Vec::new();
            together(points.iter().cloned(), until, (&start, &result), |place, result| {
                bar.inc(1);
                runs.push(Run { index: part * TOGETHER + place, parameters: points[place].clone(), result });
            });
            runs.sort_unstable_by_key(|run| run.index);
            runs
        };
        let all = || list.par_chunks(TOGETHER).enumerate().with_max_len(1).flat_map_iter(some).collect();
        let runs = on_threads(threads, stack, all);
        bar.finish_and_clear();
        Runs { runs }
    }
}

/// Does it on so many threads with so many bytes of stack, or on those that there are where the system has none to give.
pub(crate) fn on_threads<T: Send>(threads: usize, stack: usize, all: impl FnOnce() -> T + Send) -> T {
    let threads = threads.min(MOST_THREADS);
    match rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(stack).build() {
        Ok(pool) => pool.install(all),
        Err(_) => all(),
    }
}

/// A bar on a terminal, and nothing elsewhere.
pub(crate) fn progress_bar(length: usize) -> ProgressBar {
    let bar = ProgressBar::new(length as u64);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} runs, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// Result of a run, or the message of its panic.
pub(crate) fn caught<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|payload| text_of(payload.as_ref()))
}

/// Message of a panic.
fn text_of(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().map(ToString::to_string);
    text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap_or_default()
}

/// A run and its result.
#[derive(Clone, Debug, PartialEq)]
pub struct Run<P, T> {
    /// Its place in the list or the grid.
    pub index: usize,
    /// The point.
    pub parameters: P,
    /// Result of the run.
    pub result: Result<T, Failure>,
}

/// Why a run gave nothing.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
#[derive(Clone, PartialEq)]
pub enum Failure {
    /// The simulation stopped.
    Fault(Fault),
    /// The program panicked, with this message. A program that is built with `panic = "abort"` ends instead.
    Panic(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Failure::Fault(fault) => fault.fmt(f),
            Failure::Panic(words) => write!(f, "panic: {words}"),
        }
    }
}

impl std::error::Error for Failure {}

impl fmt::Debug for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// All runs, in the order of the points. `Display` lists those that failed, a line each.
#[derive(Clone, Debug, PartialEq)]
pub struct Runs<P, T> {
    runs: Vec<Run<P, T>>,
}

impl<P, T> Runs<P, T> {
    /// The points that gave something, and what.
    pub fn values(&self) -> impl Iterator<Item = (&P, &T)> {
        self.runs.iter().filter_map(|run| Some((&run.parameters, run.result.as_ref().ok()?)))
    }

    /// The runs that failed.
    pub fn failed(&self) -> impl Iterator<Item = &Run<P, T>> {
        self.runs.iter().filter(|run| run.result.is_err())
    }

    /// All values; none where a run failed.
    ///
    /// # Errors
    /// The first run that failed.
    pub fn all(self) -> Result<Vec<T>, Failure> {
        self.runs.into_iter().map(|run| run.result).collect()
    }
}

impl<P, T> Deref for Runs<P, T> {
    type Target = [Run<P, T>];

    fn deref(&self) -> &[Run<P, T>] {
        &self.runs
    }
}

impl<P: fmt::Debug, T> fmt::Display for Runs<P, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {} runs failed", self.failed().count(), self.runs.len())?;
        for Run { index, parameters, result } in &self.runs {
            if let Err(failure) = result {
                write!(f, "\nrun {index}, {parameters:?}: {failure}")?;
            }
        }
        Ok(())
    }
}
