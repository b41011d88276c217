//! Contact beside other programs: gathers what their programs have written, and draws the book's picture and tables of it.
//!
//! ```sh
//! cargo run -p plm-speed --bin contact_peers -- docs/src/images/contact-peers                           # of the stored runs
//! cargo run -p plm-speed --bin contact_peers -- docs/src/images/contact-peers target/plm/contact-*.csv  # of new ones
//! cargo run -p plm-speed --bin contact_peers -- --steps docs/src/images/contact-steps                           # of MoreauJean by its step
//! cargo run -p plm-speed --bin contact_peers -- --steps docs/src/images/contact-steps target/plm/contact-steps.csv
//! ```
//!
//! The page `docs/src/running/contact-peers.md` names the programs that measure.
#![allow(missing_docs, unreachable_pub, reason = "a program")]

mod chart;
mod runs;
mod steps;
mod tables;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1).map(PathBuf::from).peekable();
    let by_step = arguments.next_if(|first| first.as_os_str() == "--steps").is_some();
    let folder = arguments.next().ok_or("say the folder of runs.csv")?;
    let files: Vec<PathBuf> = arguments.collect();
    let stored = folder.join("runs.csv");
    if !files.is_empty() {
        let mut rows = String::new();
        for file in files {
            rows += &fs::read_to_string(file)?;
        }
        fs::write(&stored, format!("{}\n{rows}", runs::HEAD))?;
    }
    let runs = runs::read(&fs::read_to_string(stored)?)?;
    if by_step {
        let peers = runs::read(include_str!("../../../../../docs/src/images/contact-peers/runs.csv"))?;
        fs::write(folder.join("chart.svg"), steps::svg(&runs, &peers))?;
        fs::write(folder.join("tables.txt"), steps::tables(&runs))?;
        return Ok(());
    }
    fs::write(folder.join("chart.svg"), chart::svg(&runs))?;
    fs::write(folder.join("tables.txt"), tables::all(&runs))?;
    Ok(())
}
