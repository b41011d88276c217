//! Pictures of an identification and of a swing-up, for the book.
//!
//! ```console
//! cargo run --release -p plm-studies --example pictures          # the answers
//! cargo run --release -p plm-studies --example pictures -- --draw # the pictures of the book too
//! cargo run --release -p plm-studies --example pictures -- --time # error and time beside SciPy's
//! cargo run --release -p plm-studies --example pictures -- --scatter 20000 # stated deviations beside those of so many fits
//! ```
#![allow(missing_docs, unreachable_pub, reason = "modules of a program with public mechanisms")]

mod scatter;
mod swing;
mod swing_up;
mod time;

use std::error::Error;
use std::path::Path;

/// Pictures of the book, with what makes them.
type Picture = fn() -> Result<String, Box<dyn Error>>;
const PICTURES: [(&str, Picture); 2] = [
    ("docs/src/images/identification.svg", swing::picture),
    ("docs/src/images/swing_up.svg", swing_up::picture),
];

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().collect();
    if let Some(count) = words.iter().skip_while(|word| *word != "--scatter").nth(1) {
        print!("{}", scatter::report(count.parse()?)?);
        return Ok(());
    }
    if words.iter().any(|word| word == "--time") {
        print!("{}", time::report()?);
        return Ok(());
    }
    print!("{}", swing::identified()?);
    let found = swing_up::best()?;
    println!("swing-up: {:.4} N^2 s after {} iterations", found.cost, found.iterations);
    println!("{:.4?}", found.inputs[0]);
    if words.iter().any(|word| word == "--draw") {
        for (path, picture) in PICTURES {
            std::fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path), picture()?)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::PICTURES;

    #[test]
    fn pictures_are_those_of_the_book() {
        for (path, picture) in PICTURES {
            let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path);
            assert!(
                std::fs::read_to_string(file).unwrap() == picture().unwrap(),
                "{path} is stale: run the example with --draw"
            );
        }
    }
}
