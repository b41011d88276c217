//! Chores of the repository, by `cargo xtask`: what CI runs, expected texts anew, benchmarks, the picture of the architecture, the formulas of
//! the book, and the files of a release.

mod architecture;
mod bench;
mod beside;
mod bless;
mod ci;
mod math;
mod place;
mod release;
mod workspace;

use std::process::ExitCode;

use place::Place;

/// Result whose error says in a sentence what went wrong.
type Result<T = ()> = std::result::Result<T, String>;

const USAGE: &str = "\
cargo xtask ci                    everything that must hold before a change lands
cargo xtask ci --more             what takes longer than that
cargo xtask ci --only NAME...     some of the stages, of both
cargo xtask ci --list             the names of all stages
cargo xtask bless [NAME...]       expected texts anew: what `cargo test` compares, or what is named
cargo xtask bench [NAME...]       instruction counts beside their limits, or what is named
cargo xtask architecture          the picture of the architecture
cargo xtask release STEP...       the files of a release, their checksums, the crates: each step by its name
cargo xtask math                  a preprocessor of mdBook: formulas become MathML
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let done = Place::new().and_then(|place| match words.split_first() {
        Some((first, rest)) if first == "ci" => ci::run(place, rest),
        Some((first, rest)) if first == "bless" => bless::run(&place, rest),
        Some((first, rest)) if first == "bench" => bench::run(&place, rest),
        Some((first, rest)) if first == "release" => release::run(&place, rest),
        Some((first, rest)) if first == "math" => math::run(rest),
        Some((first, [])) if first == "architecture" => draw(&place),
        _ => Err(format!("these are the commands:\n{USAGE}\n{}{}", bless::usage(), bench::usage())),
    });
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn draw(place: &Place) -> Result {
    let path = architecture::PICTURE;
    let picture = architecture::picture(&place.root)?;
    std::fs::write(place.root.join(path), picture).map_err(|why| format!("{path}: {why}"))
}
