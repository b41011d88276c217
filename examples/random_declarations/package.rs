//! A package of declarations, whose programs compare each with its text.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::{fs, io};

/// Declarations of a program.
const PER_PROGRAM: usize = 50;
/// s.
const TIME: f64 = 0.5;

const PLM: &str = env!("CARGO_MANIFEST_DIR");

/// Builds the programs of numbered declarations, and runs them: has each found the same bits?
pub fn built(declarations: &[(u64, String)]) -> io::Result<Vec<bool>> {
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
    let cargo = |words: &[&str]| {
        let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.args(words).current_dir(&folder).env_remove("CARGO_TARGET_DIR").status()
    };
    if !cargo(&["build", "--quiet"])?.success() {
        return Err(io::Error::other("rustc refuses what the compiler takes"));
    }
    names.iter().map(|name| Ok(cargo(&["run", "--quiet", "--bin", name])?.success())).collect()
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
         [features]\njit = []\ndefault = [\"jit\"]\n\n[profile.dev]\ndebug = false\n\n{optimised}\
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
        let (method, name) = if number % 2 == 0 {
            ("plm::Dop853::new(1e-8)", "Dop853:1e-8")
        } else {
            ("plm::Rk4::new(1e-3)", "Rk4:1e-3")
        };
        let _ = writeln!(
            calls,
            "    compare({number}, || beside_text::same_bits(m{number}::Drawn::new(), ({method}, {name:?}), (4, {:?})), &mut wrong);",
            TIME / 4.0
        );
    }
    text + &format!(
        "fn compare(number: u64, same: fn(), wrong: &mut u32) {{\n    \
             let thread = std::thread::Builder::new().stack_size(16 << 20).spawn(same);\n    \
             if thread.unwrap().join().is_err() {{\n        println!(\"{{number}}: other bits\");\n        *wrong += 1;\n    }}\n}}\n\n\
         fn main() {{\n    let mut wrong = 0;\n{calls}    println!(\"{} compared, {{wrong}} differ\");\n    \
         std::process::exit(i32::from(wrong > 0));\n}}\n",
        declarations.len()
    )
}
