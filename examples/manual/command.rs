//! Command line of a program that has many mechanisms, each under a name and with a sheet of figures.

use std::error::Error;
use std::process::ExitCode;

use plm::view::Options;

use crate::sheet::{Demo, Sheet};

/// A run as the command line asks for it.
type Run = fn(&Options) -> Result<(), Box<dyn Error>>;

/// A program that the command line starts. A build of tests is without it: it compiles its mechanism with every method, which takes half of
/// the time of that build.
pub struct Command(Option<Run>);

impl Command {
    /// The program of a run.
    pub const fn new(run: Run) -> Self {
        Self(if cfg!(test) { None } else { Some(run) })
    }

    /// Starts it.
    ///
    /// # Errors
    /// Those of the run; in a build of tests, that there is none.
    pub fn start(&self, options: &Options) -> Result<(), Box<dyn Error>> {
        self.0.ok_or("a build of tests has no programs")?(options)
    }
}

/// The one with this name, whatever the case of the letters.
///
/// # Errors
/// There is none; the message tells all names.
pub fn find<'a, T>(all: &'a [T], name: impl Fn(&T) -> &'static str, wanted: &str) -> Result<&'a T, String> {
    let found = all.iter().find(|one| name(one).eq_ignore_ascii_case(wanted));
    found.ok_or_else(|| {
        let names: Vec<&str> = all.iter().map(name).collect();
        format!("nothing is called `{wanted}`; there are {}", names.join(", "))
    })
}

/// Prints the sheets with these names, or all where there are none, and a table of what holds.
///
/// # Errors
/// A name that there is not.
pub fn sheets(all: &[Demo], named: &[String]) -> Result<ExitCode, Box<dyn Error>> {
    for name in named {
        find(all, |(name, _)| name, name)?;
    }
    let is_wanted =
        |name: &str| named.is_empty() || named.iter().any(|wanted| wanted.eq_ignore_ascii_case(name));
    let (mut table, mut all_hold) = (Vec::new(), true);
    for (name, run) in all.iter().filter(|(name, _)| is_wanted(name)) {
        match run() {
            Ok(sheet) => {
                println!("{sheet}\n");
                all_hold &= sheet.holds();
                table.push(row(&sheet));
            }
            Err(fault) => {
                println!("{name}\n  {fault}\n");
                all_hold = false;
                table.push(format!("{name:<16} {fault}"));
            }
        }
    }
    println!("{:<16} {:>15} {:>15}", "demo", "manual figures", "other checks");
    println!("{}", table.join("\n"));
    Ok(if all_hold { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn row(sheet: &Sheet) -> String {
    let [printed, others] = sheet.counts().map(|(held, all)| format!("{held} of {all}"));
    format!("{:<16} {printed:>15} {others:>15}", sheet.demo)
}
