//! Shows what the compiler makes of a declaration: its report and the Rust source that it emits.
//!
//! `cargo run -p plm-compiler --example dump` takes the manual's double pendulum; a file with the inside of a
//! `mechanism!` call as argument takes that.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use plm_compiler::compile;
use plm_compiler::token::Sources;

const DOUBLE_PENDULUM: &str = include_str!("double_pendulum.plm");

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let files: Vec<String> = std::env::args().skip(1).collect();
    let (name, text) = match &files[..] {
        [] => ("double_pendulum.plm".to_owned(), DOUBLE_PENDULUM.to_owned()),
        [path] => (path.clone(), std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?),
        [_, second, ..] => return Err(format!("one file at a time; what is {second}?").into()),
    };
    let mut sources = Sources::new();
    sources.add_text(&name, &text);
    for file in sources.named_files() {
        let content = std::fs::read_to_string(Path::new(&name).with_file_name(&file));
        sources.add_file(&file, content.map_err(|error| error.to_string()));
    }
    let expansion = compile(&mut sources);
    for diagnostic in expansion.diagnostics.sorted() {
        eprintln!("{}", diagnostic.render(&sources));
    }
    if let Some(report) = &expansion.report {
        eprintln!("{report}");
    }
    if let Some(code) = &expansion.code {
        println!("{}", code.text());
    }
    Ok(if expansion.diagnostics.has_errors() { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}
