//! Random declarations, compiled by rustc and run from their text: the bits are the same, by steps and by machine code.
//!
//! ```console
//! cargo run --release -p plm-oracle --bin random_declarations -- 200             # so many
//! cargo run --release -p plm-oracle --bin random_declarations -- 200 --seed 7    # others
//! cargo run --release -p plm-oracle --bin random_declarations -- --print 123     # the text of one
//! ```
//!
//! Trees and loops of one to five bodies, with springs, dampers, drives, frictions, parameters, inputs, tables, conditions, events, states
//! and contact, at decimal places. A package in `target/random-declarations` has a program for each fifty of them. They run half a second
//! by Dop853, by Rk4 and by MoreauJean in turn. Declarations that the compiler refuses are counted, and so are runs that end with a fault
//! or do not begin: both ways have the same one. The program fails where bits, counts of steps or faults differ.
#![allow(missing_docs, reason = "the modules are private to a program")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]

mod draw;
mod package;

use std::collections::BTreeMap;
use std::error::Error;
use std::process::ExitCode;

use plm_dynamic::Mechanism;
use plm_program::{Arguments, Known};

const KNOWN: [Known; 3] = [
    Known::word("COUNT", "how many; 100 if nothing is said"),
    Known::value("seed", "N", "of the random declarations; 1 if nothing is said"),
    Known::value("print", "N", "the text of this one, which is not run"),
];

fn main() -> ExitCode {
    run().unwrap_or_else(|error| {
        eprintln!("{error}");
        ExitCode::FAILURE
    })
}

fn run() -> Result<ExitCode, Box<dyn Error>> {
    let given = Arguments::from_args(&KNOWN)?;
    if let Some(help) = given.help() {
        println!("{help}");
        return Ok(ExitCode::SUCCESS);
    }
    let (seed, count) = (given.number("seed")?.unwrap_or(1), given.number("COUNT")?.unwrap_or(100));
    if let Some(number) = given.number("print")? {
        let text = draw::declaration(seed, number);
        print!("{text}");
        Mechanism::from_text(&text)?;
        return Ok(ExitCode::SUCCESS);
    }
    let all = (0..count).map(|number| (number, draw::declaration(seed, number)));
    let (mut taken, mut refused) = (Vec::new(), BTreeMap::<String, Vec<u64>>::new());
    for (number, text) in all {
        match Mechanism::from_text(&text) {
            Ok(_) => taken.push((number, text)),
            Err(error) => refused.entry(code(&error.to_string())).or_default().push(number),
        }
    }
    println!("seed {seed}: {count} declarations");
    for (code, numbers) in &refused {
        println!("the compiler refuses {} with {code}: {numbers:?}", numbers.len());
    }
    let [compared, faults, open, differ] = package::compared(&taken)?;
    println!(
        "{compared} compared, of which {open} cannot be assembled and {faults} end with a fault; {differ} differ"
    );
    Ok(if differ == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The code of a diagnostic, `E0503`.
fn code(message: &str) -> String {
    message
        .split_once('[')
        .and_then(|(_, rest)| rest.split_once(']'))
        .map_or(message, |(code, _)| code)
        .to_owned()
}
