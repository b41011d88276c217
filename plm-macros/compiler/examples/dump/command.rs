//! The command: its words, what it reads, and what it writes where.

#[path = "json.rs"]
pub(crate) mod json;

use std::error::Error;
use std::io::{Read, Write};
use std::path::Path;

use plm_compiler::compile;
use plm_compiler::token::Sources;

const DOUBLE_PENDULUM: &str = include_str!("../double_pendulum.plm");

/// What is asked for on the command line.
#[derive(Default)]
struct Wanted {
    file: Option<String>,
    /// Diagnostics alone.
    check: bool,
    json: bool,
}

impl Wanted {
    fn of(words: impl Iterator<Item = String>) -> Result<Wanted, Box<dyn Error>> {
        let (mut wanted, mut words) = (Wanted::default(), words);
        while let Some(word) = words.next() {
            match word.as_str() {
                "--check" => wanted.check = true,
                "--message-format" => match words.next().as_deref() {
                    Some("json") => wanted.json = true,
                    Some("human") => wanted.json = false,
                    _ => return Err("--message-format takes `human` or `json`".into()),
                },
                option if option.len() > 1 && option.starts_with('-') => {
                    return Err(format!("there is no option {option}").into());
                }
                _ if wanted.file.is_none() => wanted.file = Some(word),
                second => return Err(format!("one file at a time; what is {second}?").into()),
            }
        }
        Ok(wanted)
    }

    /// The declaration, and its name in messages.
    fn read(&self, input: &mut dyn Read) -> Result<(String, String), Box<dyn Error>> {
        Ok(match self.file.as_deref() {
            None => ("double_pendulum.plm".to_owned(), DOUBLE_PENDULUM.to_owned()),
            Some("-") => {
                let mut text = String::new();
                input.read_to_string(&mut text)?;
                ("<stdin>".to_owned(), text)
            }
            Some(path) => {
                (path.to_owned(), std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?)
            }
        })
    }
}

/// Compiles what the words ask for. Is there an error in the declaration?
pub(crate) fn run(
    words: impl Iterator<Item = String>,
    input: &mut dyn Read,
    output: &mut dyn Write,
    errors: &mut dyn Write,
) -> Result<bool, Box<dyn Error>> {
    let wanted = Wanted::of(words)?;
    let (name, text) = wanted.read(input)?;
    let mut sources = Sources::new();
    sources.add_text(&name, &text);
    for file in sources.named_files() {
        let content = std::fs::read_to_string(Path::new(&name).with_file_name(&file));
        sources.add_file(&file, content.map_err(|error| error.to_string()));
    }
    let expansion = compile(&mut sources);
    for diagnostic in expansion.diagnostics.sorted() {
        if wanted.json {
            writeln!(output, "{}", json::line(diagnostic, &sources, &text))?;
        } else {
            writeln!(errors, "{}", diagnostic.render(&sources))?;
        }
    }
    if !wanted.json && !wanted.check {
        if let Some(report) = &expansion.report {
            writeln!(errors, "{report}")?;
        }
        if let Some(code) = &expansion.code {
            writeln!(output, "{}", code.text())?;
        }
    }
    Ok(expansion.diagnostics.has_errors())
}
