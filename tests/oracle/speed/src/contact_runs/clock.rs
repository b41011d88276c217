//! CPU time of a run.

use std::fs::read_to_string;
use std::time::Instant;

/// Runs are repeated for so long, s: the scheduler's count is some ms coarse.
const SPENT: f64 = 0.25;

/// CPU time of this thread where the system tells it, s; else the time on the clock.
fn now(begin: Instant) -> f64 {
    let counted = read_to_string("/proc/thread-self/schedstat").ok();
    let nanos = counted.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanos.map_or_else(|| begin.elapsed().as_secs_f64(), |nanos| 1e-9 * nanos)
}

/// CPU time of one run, s: the least of three means over as many runs as take a quarter of a second.
pub fn seconds<T>(run: impl Fn() -> T) -> f64 {
    let begin = Instant::now();
    let mean = || {
        let start = now(begin);
        let mut runs = 0_u32;
        loop {
            std::hint::black_box(run());
            runs += 1;
            let spent = now(begin) - start;
            if spent > SPENT {
                return spent / f64::from(runs);
            }
        }
    };
    let first = mean();
    // A long run is its own mean.
    if first > SPENT { first } else { first.min(mean()).min(mean()) }
}
