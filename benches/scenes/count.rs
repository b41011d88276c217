//! Instructions per step by valgrind: exact, and the same on every run.
//!
//! A bench runs itself under `valgrind --tool=callgrind` with some number of steps and with twice as many; the
//! difference over the number of steps is what one step costs, without start-up, assembly and printing.

use std::env;
use std::process::Command;

use super::Steps;

/// Steps of the shorter of two runs.
const STEPS: u32 = 200;

/// What the program was called with, without cargo's own `--bench`.
pub(crate) fn arguments() -> Vec<String> {
    env::args().skip(1).filter(|argument| argument != "--bench").collect()
}

/// Makes the steps that this program was called for by [`per_step`], if it was.
pub(crate) fn counted(find: impl FnOnce(&str, &str) -> Steps) -> bool {
    let arguments = arguments();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let ["count", scene, what, steps] = words[..] else { return false };
    find(scene, what)(steps.parse().expect("a number of steps"));
    true
}

/// Instructions per step of what `find` of [`counted`] gives for these two words.
#[allow(dead_code, reason = "some benches count runs")]
pub(crate) fn per_step(scene: &str, what: &str) -> f64 {
    between(scene, what, [STEPS, 2 * STEPS]) / f64::from(STEPS)
}

/// The instructions that a run of the second length takes more than one of the first.
pub(crate) fn between(scene: &str, what: &str, steps: [u32; 2]) -> f64 {
    let [fewer, more] = steps.map(|steps| instructions(scene, what, steps));
    more as f64 - fewer as f64
}

/// Instructions of a whole run of this program.
fn instructions(scene: &str, what: &str, steps: u32) -> u64 {
    let output = Command::new("valgrind")
        // One `rep movsb` is one instruction to a processor, but one per byte to callgrind: let libc copy by vectors.
        .env(
            "GLIBC_TUNABLES",
            "glibc.cpu.x86_rep_movsb_threshold=1000000:glibc.cpu.x86_rep_stosb_threshold=1000000",
        )
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(env::current_exe().expect("the program has a path"))
        .args(["count", scene, what, &steps.to_string()])
        .output()
        .expect("valgrind is installed");
    let report = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{scene} {what}: {report}");
    let count = report.lines().find_map(|line| line.split_once("Collected : ")?.1.trim().parse().ok());
    count.unwrap_or_else(|| panic!("valgrind counted nothing: {report}"))
}
