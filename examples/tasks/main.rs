//! Everyday tasks of engineers: each is a short file to copy, with a mechanism and the numbers that it gives.
//!
//! ```console
//! cargo run --example tasks                  # the names of all, and what they ask
//! cargo run --example tasks engine incline   # the answers of these
//! ```
//!
//! Each module begins with its question and ends with its answers; `tests/tasks` checks all of them.
#![allow(missing_docs, unreachable_pub, reason = "modules of a program with public mechanisms")]

mod bode;
mod bounce;
mod brake;
mod bucket;
mod cam;
mod cart_pole;
mod clearance;
mod crane;
mod door_stop;
mod engine;
mod extended_filter;
mod filter;
mod fit;
mod five_bar;
mod from_file;
mod gears;
mod geneva;
mod gradients;
mod gripper;
mod hopper;
mod incline;
mod inverse_closed;
mod inverse_open;
mod joint_friction;
mod kinematics;
mod lamp;
mod latch;
mod limit_cycle;
mod pid;
mod sweep;
mod synthesis;
mod toggle;
mod tolerances;
mod walker;
mod wheel;
mod wiper;
// They stand beside the other tests; in a program of their own all tasks would be compiled twice.
#[cfg(test)]
#[path = "../../tests/tasks/mod.rs"]
mod tests;

use std::error::Error;
use std::process::ExitCode;

/// A number that a task answers with, in its unit.
pub struct Answer {
    pub name: &'static str,
    pub value: f64,
    pub unit: &'static str,
}

impl Answer {
    pub const fn new(name: &'static str, value: f64, unit: &'static str) -> Self {
        Self { name, value, unit }
    }
}

pub type Answers = Vec<Answer>;

/// Normal numbers of variance 1, the same for the same seed: G. Marsaglia's xorshift (J. Statistical Software 8, 2003), by G. E. P. Box and M. E. Muller
/// (Ann. Math. Statist. 29, 1958).
pub fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut word = seed ^ 0x9E37_79B9_7F4A_7C15;
    let mut uniform = move || {
        word ^= word << 13;
        word ^= word >> 7;
        word ^= word << 17;
        ((word >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    };
    move || (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

/// A task: its name, its source, and what computes its answers.
pub struct Task {
    pub name: &'static str,
    pub source: &'static str,
    pub run: fn() -> Result<Answers, Box<dyn Error>>,
}

/// Tasks of modules by their names.
macro_rules! tasks {
    ($($name:ident),* $(,)?) => {
        &[$(Task {
            name: stringify!($name),
            source: include_str!(concat!(stringify!($name), ".rs")),
            run: $name::run,
        }),*]
    };
}

pub const TASKS: &[Task] = tasks![
    bode,
    bounce,
    brake,
    bucket,
    cam,
    cart_pole,
    clearance,
    crane,
    door_stop,
    engine,
    extended_filter,
    filter,
    fit,
    five_bar,
    from_file,
    gears,
    geneva,
    gradients,
    gripper,
    hopper,
    incline,
    inverse_closed,
    inverse_open,
    joint_friction,
    kinematics,
    lamp,
    latch,
    limit_cycle,
    pid,
    sweep,
    synthesis,
    toggle,
    tolerances,
    walker,
    wheel,
    wiper,
];

impl Task {
    /// The task of a name.
    ///
    /// # Errors
    /// There is none: the message lists all names.
    pub fn find(name: &str) -> Result<&'static Self, String> {
        let unknown = || {
            let names: Vec<&str> = TASKS.iter().map(|task| task.name).collect();
            format!("there is no task `{name}`; the tasks are {}", names.join(", "))
        };
        TASKS.iter().find(|task| task.name == name).ok_or_else(unknown)
    }

    /// What the task asks: the first paragraph of its documentation.
    pub fn question(&self) -> String {
        let lines = self.source.lines().map_while(|line| line.strip_prefix("//! "));
        lines.collect::<Vec<_>>().join(" ")
    }

    fn print(&self) -> Result<(), Box<dyn Error>> {
        println!("{}", self.question());
        let answers = (self.run)()?;
        let width = answers.iter().map(|answer| answer.name.len()).max().unwrap_or(0);
        for Answer { name, value, unit } in answers {
            // Six digits, whatever the size; counts have none after the point.
            let decimals =
                if value.fract() == 0.0 { 0.0 } else { 5.0 - value.abs().max(0.1).log10().floor() };
            println!("  {name:width$}  {value:.*} {unit}", decimals.max(0.0) as usize);
        }
        Ok(())
    }
}

fn main() -> ExitCode {
    let names: Vec<String> = std::env::args().skip(1).collect();
    if names.is_empty() {
        for task in TASKS {
            println!("{:16} {}", task.name, task.question());
        }
        return ExitCode::SUCCESS;
    }
    for name in names {
        let printed = Task::find(&name).map_err(Into::into).and_then(Task::print);
        if let Err(error) = printed {
            eprintln!("{name}: {error}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
