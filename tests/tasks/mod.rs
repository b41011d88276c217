//! The tasks of `examples/tasks`: each answer beside a closed form, a published figure, another formulation or a conservation law.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

#[path = "../support/compass.rs"]
mod compass;

mod catches;
mod contact;
mod control;
mod linkages;
mod machines;
mod studies;
mod swings;
mod trains;

use super::{TASKS, Task};

/// Acceleration of gravity of the tasks, m/s^2.
const G: f64 = 9.81;

/// Runs a task and compares all of its answers, in their order, with numbers that are known from elsewhere: name, number, and how far
/// the answer may be from it.
#[track_caller]
fn check(task: &str, known: &[(&str, f64, f64)]) {
    let answers = (Task::find(task).unwrap().run)().unwrap();
    let names: Vec<&str> = answers.iter().map(|answer| answer.name).collect();
    assert_eq!(names, known.iter().map(|(name, ..)| *name).collect::<Vec<_>>(), "{task}");
    for (answer, (name, value, within)) in answers.iter().zip(known) {
        let error = (answer.value - value).abs();
        assert!(error <= *within, "{task}, {name}: {} instead of {value}, by {error:e}", answer.value);
    }
}

/// A file to copy is short, asks its question first, and is no workaround that has to be explained at length.
#[test]
fn tasks_are_short() {
    for task in TASKS {
        let lines = task.source.lines().count();
        assert!(lines <= 60, "{} has {lines} lines", task.name);
        assert!(task.question().ends_with('?'), "{}: {}", task.name, task.question());
    }
}

/// Every task is looked at by a test of this folder.
#[test]
fn tasks_are_checked() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/tasks");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let tests: String = files.map(|file| std::fs::read_to_string(file).unwrap()).collect();
    for task in TASKS {
        assert!(tests.contains(&format!("\"{}\",", task.name)), "{} is checked by nobody", task.name);
    }
}
