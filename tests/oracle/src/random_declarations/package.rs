//! A package of declarations, whose programs compare each with its text.

use std::env::consts::EXE_SUFFIX;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::{fs, io};

/// Declarations of a program.
const PER_PROGRAM: usize = 50;
/// s.
const TIME: f64 = 0.5;

/// The root of the workspace.
const PLM: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../..");

/// Counts of runs: compared, and of these ended with a fault, not begun, different.
pub type Found = [u64; 4];

/// Builds the programs of numbered declarations, and runs them.
pub fn compared(declarations: &[(u64, String)]) -> io::Result<Found> {
    let folder = Path::new(PLM).join("target/random-declarations");
    let sources = folder.join("src/bin");
    if sources.exists() {
        fs::remove_dir_all(&sources)?;
    }
    fs::create_dir_all(&sources)?;
    fs::write(folder.join("Cargo.toml"), manifest())?;
    let names: Vec<String> = declarations
        .chunks(PER_PROGRAM)
        .enumerate()
        .map(|(k, part)| {
            let name = format!("part{k}");
            fs::write(sources.join(format!("{name}.rs")), program(part)).map(|()| name)
        })
        .collect::<io::Result<_>>()?;
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.args(["build", "--quiet", "--target-dir", "target"]).current_dir(&folder);
    if !cargo.status()?.success() {
        return Err(io::Error::other("rustc refuses what the compiler takes"));
    }
    let mut all = Found::default();
    for name in names {
        let program = folder.join("target/debug").join(name + EXE_SUFFIX);
        let output = Command::new(program).output()?;
        let text = String::from_utf8_lossy(&output.stdout);
        let (told, counts) = text.trim_end().rsplit_once('\n').unwrap_or(("", text.trim_end()));
        if !told.is_empty() {
            println!("{told}");
        }
        let counts = counts.split(' ').map(str::parse).collect::<Result<Vec<u64>, _>>();
        let Ok(counts) = counts else {
            return Err(io::Error::other(String::from_utf8_lossy(&output.stderr)));
        };
        all.iter_mut().zip(counts).for_each(|(all, count)| *all += count);
    }
    Ok(all)
}

/// The compiler and the runtime are optimised, the mechanisms are not: bits do not depend on it.
fn manifest() -> String {
    let optimised = [
        "plm-compiler",
        "plm-cas",
        "plm-math",
        "plm-runtime",
        "plm-dynamic",
        "plm-jit",
        "syn",
        "proc-macro2",
    ]
    .map(|package| format!("[profile.dev.package.{package}]\nopt-level = 1\n\n"))
    .concat();
    format!(
        "[package]\nname = \"random-declarations\"\nversion = \"0.0.0\"\nedition = \"2024\"\npublish = false\n\n\
         [dependencies]\nplm = {{ package = \"plm-planar\", path = {PLM:?}, features = [\"jit\"] }}\n\n\
         [features]\njit = []\ndefault = [\"jit\"]\n\n[profile.dev]\ndebug = false\nincremental = false\n\n{optimised}\
         # It stands by itself.\n[workspace]\n"
    )
}

fn program(declarations: &[(u64, String)]) -> String {
    let mut text = format!(
        "#![allow(dead_code, unused_imports)]\n#[path = \"{PLM}/tests/support/beside_text.rs\"]\nmod beside_text;\n\n"
    );
    let mut calls = String::new();
    for (number, declaration) in declarations {
        let _ = write!(text, "mod m{number} {{ plm::mechanism! {{\n{declaration}}} }}\n\n");
        let (method, name) = match number % 3 {
            0 => ("plm::Dop853::new(1e-8)", "Dop853:1e-8"),
            1 => ("plm::Rk4::new(1e-3)", "Rk4:1e-3"),
            _ => ("plm::MoreauJean::new(1e-3)", "MoreauJean:1e-3"),
        };
        let _ = writeln!(
            calls,
            "    compare({number}, || beside_text::beside(m{number}::Drawn::new(), ({method}, {name:?}), (4, {:?})), &mut counts);",
            TIME / 4.0
        );
    }
    text + &format!("{COMPARE}\nfn main() {{\n    let mut counts = [0; 4];\n{calls}{END}}}\n")
}

/// Compares one, on the stack of a program.
const COMPARE: &str = r#"fn compare(number: u64, run: fn() -> Result<beside_text::Course, String>, counts: &mut [u64; 4]) {
    counts[0] += 1;
    let thread = std::thread::Builder::new().stack_size(16 << 20).spawn(run).unwrap();
    match thread.join() {
        Ok(Ok(course)) if course.moments.is_empty() => {
            println!("{number}: no start: {}", course.fault.unwrap_or_default());
            counts[2] += 1;
        }
        Ok(Ok(course)) => counts[1] += u64::from(course.fault.is_some()),
        Ok(Err(difference)) => {
            println!("{number}: {difference}");
            counts[3] += 1;
        }
        Err(_) => {
            println!("{number}: a panic");
            counts[3] += 1;
        }
    }
}
"#;

const END: &str = r#"    println!("{} {} {} {}", counts[0], counts[1], counts[2], counts[3]);
"#;
