//! Where methods fail: a picture and lines of a table for each scene, the known value beside what `plm` does by default.
//!
//! ```sh
//! cargo run --release -p plm-oracle --example stability                       # to target/plm/stability
//! cargo run --release -p plm-oracle --example stability -- --out DIR          # to DIR; the book has docs/src/images/stability
//! cargo run --release -p plm-oracle --example stability -- --quick            # long runs a hundred times shorter
//! ```
//!
//! The program fails if a value is not as near to the known one as it has to be.
#![allow(missing_docs, reason = "the modules are private to a program")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]
#![allow(dead_code, reason = "the tests show more of the scenes")]
#![allow(clippy::excessive_precision, reason = "references keep the digits that they were computed with")]

mod figures;
mod scenes;
// In a program of their own all scenes would be compiled twice.
#[cfg(test)]
mod tests;
mod text;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use figures::{
    Figure, Page, dead, dyads, extremes, flat, indices, long, near_singular, short_events, stiff, theory,
    waiting,
};
use plm_program::{Arguments, Known};
use plm_runtime::Fault;

const KNOWN: [Known; 2] = [
    Known::value("out", "DIR", "where pictures and tables go; target/plm/stability if nothing is said"),
    Known::flag("quick", "long runs a hundred times shorter"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::from_args(&KNOWN)?;
    if let Some(help) = arguments.help() {
        println!("{help}");
        return Ok(());
    }
    let folder = arguments.value("out").map_or(PathBuf::from("target/plm/stability"), PathBuf::from);
    let shorter = if arguments.flag("quick") { 100 } else { 1 };

    let mut page = Page::default();
    for make in all(shorter) {
        let Figure { slug, chart, rows } = make()?;
        chart.write_svg(folder.join(format!("{slug}.svg")))?;
        println!("{slug}\n{}", page.add(slug, &rows));
    }
    fs::write(folder.join("tables.txt"), &page.text)?;
    println!("written: {}", folder.display());
    Ok(page.outcome()?)
}

/// Every picture; the long runs are so many times shorter.
fn all(shorter: u32) -> Vec<Box<dyn Fn() -> Result<Figure, Fault>>> {
    let steps = 1_000_000 / shorter;
    let seconds = 2000.0 / f64::from(shorter);
    vec![
        Box::new(flat::ladders),
        Box::new(flat::folded),
        Box::new(flat::parallelogram),
        Box::new(near_singular::turns),
        Box::new(near_singular::errors),
        Box::new(dead::triple_rocker),
        Box::new(dead::crank_rocker),
        Box::new(dead::quadrorhomb),
        Box::new(dyads::six_bar),
        Box::new(waiting::pushed),
        Box::new(short_events::conditions),
        Box::new(move || long::drift_of_the_four_bar(steps)),
        Box::new(move || long::drift_of_the_quadrorhomb(steps)),
        Box::new(move || long::a01(seconds)),
        Box::new(long::chaos),
        Box::new(|| Ok(stiff::baumgarte())),
        Box::new(|| Ok(stiff::end_stop())),
        Box::new(stiff::stiff_spring),
        Box::new(|| Ok(indices::order_reduction())),
        Box::new(theory::kapitza),
        Box::new(theory::laguerre),
        Box::new(extremes::fast_crank),
        Box::new(extremes::masses),
        Box::new(extremes::precision),
    ]
}
