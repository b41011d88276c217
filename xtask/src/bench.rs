//! Benchmarks.

use crate::Result;
use crate::place::Place;

/// A name, what it measures, and the command.
const BENCHES: [(&str, &str, &str); 7] = [
    (
        "instructions",
        "instructions of a step beside their limits, by valgrind",
        "bash benches/instructions.sh",
    ),
    ("contact", "instructions of a slider-crank with friction, by valgrind", "bash benches/contact.sh"),
    ("kernels", "generated code beside kernels written by hand", "bash benches/kernels.sh"),
    ("implicit", "linear systems of implicit methods along a chain", "cargo bench --quiet --bench implicit"),
    (
        "lanes",
        "eight trajectories side by side",
        "cargo bench --quiet --bench lanes --features lanes --target-dir target/x86-64-v3",
    ),
    ("first-build", "what a user's first build takes, by crate", "bash benches/first_build.sh"),
    ("scale", "what mechanisms of many bodies cost", "bash benches/scale.sh"),
];

pub(crate) fn usage() -> String {
    let lines = BENCHES.map(|(name, what, _)| format!("cargo xtask bench {name:<16}{what}\n"));
    lines.concat()
}

/// Runs those that are named, or counts instructions. What stands after `--` goes to each of them.
pub(crate) fn run(place: &Place, words: &[String]) -> Result {
    let mut parts = words.splitn(2, |word| word == "--");
    let (names, more) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
    if let Some(unknown) = names.iter().find(|name| BENCHES.iter().all(|bench| bench.0 != name.as_str())) {
        return Err(format!("`{unknown}` is no benchmark:\n{}", usage()));
    }
    let default = [BENCHES[0].0.to_owned()];
    for name in if names.is_empty() { &default } else { names } {
        for (_, _, command) in BENCHES.iter().filter(|bench| bench.0 == name.as_str()) {
            let task = if name == "lanes" {
                place.command(command).set("RUSTFLAGS", "-C target-cpu=x86-64-v3")
            } else {
                place.command(command)
            };
            let after = (!more.is_empty() && command.starts_with("cargo")).then_some("--");
            task.args(after).args(more).run()?;
        }
    }
    Ok(())
}
