//! Chores of the repository, by `cargo xtask`: what CI runs, expected texts anew, benchmarks, the list of files, the picture, and
//! the formulas of the book.

mod architecture;
mod bench;
mod beside;
mod bless;
mod ci;
mod index;
mod math;
mod place;

use std::process::ExitCode;

use place::Place;

/// What went wrong, in a sentence.
type Result<T = ()> = std::result::Result<T, String>;

const USAGE: &str = "\
cargo xtask ci                    everything that must hold before a change lands
cargo xtask ci --more             what takes longer than that
cargo xtask ci --only NAME...     some of the stages, of both
cargo xtask ci --list             the names of all stages
cargo xtask bless [NAME...]       expected texts anew: what `cargo test` compares, or what is named
cargo xtask bench [NAME...]       instruction counts beside their limits, or what is named
cargo xtask index                 the book's list of source files and the picture of the architecture
cargo xtask math                  a preprocessor of mdBook: formulas become MathML
";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let done = Place::new().and_then(|place| match words.split_first() {
        Some((first, rest)) if first == "ci" => ci::run(place, rest),
        Some((first, rest)) if first == "bless" => bless::run(&place, rest),
        Some((first, rest)) if first == "bench" => bench::run(&place, rest),
        Some((first, rest)) if first == "math" => math::run(rest),
        Some((first, [])) if first == "index" => write_index(&place),
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

fn write_index(place: &Place) -> Result {
    let write = |path: &str, text: String| {
        std::fs::write(place.root.join(path), text).map_err(|why| format!("{path}: {why}"))
    };
    write(index::PAGE, index::page(&place.root)?)?;
    write(architecture::PICTURE, architecture::picture(&place.root)?)
}
