//! Linkages that come to poses in which the coordinate of their chart turns back.

use std::process::Command;

/// The case of this number of seed 31 is right in both formulations.
fn is_right(number: &str, by: &[&str]) {
    let mut program = Command::new(env!("CARGO_BIN_EXE_linkages"));
    let output = program.args(["--seed", "31", "--case", number]).args(by).output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}

/// A group of eight unknowns is left where what elimination leaves of a column vanishes.
#[test]
fn iterated_groups_leave_a_chart_that_turns_back() {
    is_right("151", &[]);
}

/// A fixed step that begins and ends at the same distance from a flat pose has gone to it.
#[test]
fn fixed_steps_do_not_pass_over_a_flat_pose() {
    is_right("191", &["--by", "rk4"]);
}
