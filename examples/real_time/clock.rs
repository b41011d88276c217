//! A loop against the clock, and how well it keeps to it.

use std::error::Error;
use std::hint::spin_loop;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::{self, sleep};
use std::time::{Duration, Instant};

use plm::Fault;

use super::plants::Made;

/// A number that one thread sets and another reads, without a lock.
#[derive(Default)]
struct Wire(AtomicU64);

impl Wire {
    fn set(&self, value: f64) {
        self.0.store(value.to_bits(), Ordering::Release);
    }

    fn get(&self) -> f64 {
        f64::from_bits(self.0.load(Ordering::Acquire))
    }
}

/// What goes into the loop and comes out of it.
#[derive(Default)]
struct Wires {
    /// Set from outside, read before each step.
    input: Wire,
    /// Set after each step.
    output: Wire,
    /// The loop has ended.
    done: AtomicBool,
}

/// What happened at a step.
#[derive(Clone, Copy, Debug)]
pub struct Beat {
    /// What the input was.
    pub input: f64,
    /// How long after its time the step began.
    pub late: Duration,
    /// How long it took.
    pub took: Duration,
    /// What came of it.
    pub made: Made,
}

/// Runs what `plant` makes so many times a second in a thread of its own, while this one sets the input to a sine of some amplitude.
/// Then the inputs are played again. Where the host is busy both threads stand still for a while, and the next step finds an input
/// that has jumped; what comes of it is told, and the loop goes on.
///
/// # Errors
/// The plant cannot be made; or the run that was played again ends with other bits.
pub fn measured<P>(
    rate: u32,
    seconds: f64,
    amplitude: f64,
    plant: impl Fn() -> Result<P, Fault>,
) -> Result<Vec<Beat>, Box<dyn Error>>
where
    P: FnMut(f64) -> (f64, Made) + Send,
{
    let period = Duration::from_secs_f64(1.0 / f64::from(rate));
    let mut beats = memory((seconds * f64::from(rate)) as usize);
    let mut step = plant()?;
    let wires = Wires::default();
    thread::scope(|scope| {
        let looping = scope.spawn(|| {
            keep_pace(period, &wires, &mut beats, &mut step);
            wires.done.store(true, Ordering::Release);
        });
        let begun = Instant::now();
        while !wires.done.load(Ordering::Acquire) {
            wires.input.set(amplitude * (6.0 * begun.elapsed().as_secs_f64()).sin());
            sleep(Duration::from_millis(3));
        }
        looping.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    });
    let mut replayed = plant()?;
    let mut last = f64::NAN;
    for beat in &beats {
        (last, _) = replayed(beat.input);
    }
    if last.to_bits() != wires.output.get().to_bits() {
        return Err(format!("played again the run ends at {last}, not at {}", wires.output.get()).into());
    }
    Ok(beats)
}

/// Makes a step every `period`, one for each entry of `beats`, which gets what happened. A step that comes too late is made up
/// for: none is left out, so that the time of the mechanism stays that of the clock.
fn keep_pace(period: Duration, wires: &Wires, beats: &mut [Beat], step: &mut impl FnMut(f64) -> (f64, Made)) {
    let mut due = Instant::now() + period;
    for beat in beats {
        wait_for(due);
        let begun = Instant::now();
        let input = wires.input.get();
        let (output, made) = step(input);
        wires.output.set(output);
        *beat = Beat { input, late: begun - due, took: begun.elapsed(), made };
        due += period;
    }
}

/// Sleeps as long as the system can be trusted to wake it in time, and looks at the clock from then on.
fn wait_for(due: Instant) {
    /// A sleep of an ordinary kernel ends up to some 100 µs late.
    const AWAKE: Duration = Duration::from_micros(300);

    let left = due.saturating_duration_since(Instant::now());
    if let Some(asleep) = left.checked_sub(AWAKE) {
        sleep(asleep);
    }
    while Instant::now() < due {
        spin_loop();
    }
}

/// Memory for so many beats, all of it written once: a page that is touched for the first time costs a fault of the kernel.
fn memory(count: usize) -> Vec<Beat> {
    vec![Beat { input: f64::NAN, late: Duration::MAX, took: Duration::MAX, made: Made::Whole }; count]
}

/// So many are told of each run.
const MOST_TOLD: usize = 3;

/// The periods that were not made by one step, in words, at most a few of them: when, how late, and what the input did.
pub fn failed_periods(period: f64, beats: &[Beat]) -> Vec<String> {
    let failure = |at: usize| {
        let Beat { input, late, made, .. } = beats[at];
        let before = at.checked_sub(1).map_or(0.0, |before| beats[before].input);
        let (fault, outcome) = match made {
            Made::Whole => return None,
            Made::InParts(parts, fault) => (fault, format!("made by {parts} shorter steps")),
            Made::Held(fault) => (fault, "it stands still for this period".to_owned()),
        };
        let (time, late) = (period * at as f64, 1e3 * late.as_secs_f64());
        Some(format!(
            "at {time:.4} s, {late:.2} ms late, input {before:.3} to {input:.3}: {outcome} ({})",
            fault.cause
        ))
    };
    let mut lines: Vec<String> = (0..beats.len()).filter_map(failure).collect();
    let more = lines.len().saturating_sub(MOST_TOLD);
    lines.truncate(MOST_TOLD);
    if more > 0 {
        lines.push(format!("and {more} periods more"));
    }
    lines
}

/// Mean, what 99 % stay below, and the most, us.
pub fn distribution(times: impl Iterator<Item = Duration>) -> [f64; 3] {
    let mut times: Vec<f64> = times.map(|time| 1e6 * time.as_secs_f64()).collect();
    times.sort_by(f64::total_cmp);
    let last = times.len().saturating_sub(1);
    let share = |part: f64| times.get((part * last as f64).ceil() as usize).copied().unwrap_or(f64::NAN);
    let mean = times.iter().sum::<f64>() / times.len() as f64;
    [mean, share(0.99), share(1.0)]
}
