//! A page in which declarations are typed, from its module and its script: `bash examples/playground/build.sh` calls
//! `cargo run -p plm-cli --example playground -- page.html module.lzma script.lzma machine.rs…`. With `--book ADDRESS` in front of these,
//! codes of diagnostics lead to their pages of the book there. `--script FILE` alone writes the script of the page, to which that of the
//! editor is added.

use std::path::Path;
use std::process::ExitCode;

use plm_cli::declarations;
use plm_view::Page;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (book, files) = match arguments.as_slice() {
        [word, book, files @ ..] if word == "--book" => (book.as_str(), files),
        files => ("", files),
    };
    let written = match files {
        [word, script] if word == "--script" => std::fs::write(script, Page::editor_script())
            .map(|()| script)
            .map_err(|error| format!("cannot write {script}: {error}")),
        [html, module, script, gallery @ ..] => {
            write(html, book, (module, script), gallery).map(|()| html)
        }
        _ => Err("usage: playground --script SCRIPT.js | [--book ADDRESS] PAGE.html MODULE.lzma SCRIPT.lzma MACHINE.rs…".to_owned()),
    };
    match written {
        Ok(path) => {
            println!("wrote {path}");
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

fn write(html: &str, book: &str, (module, script): (&str, &str), gallery: &[String]) -> Result<(), String> {
    let read = |path: &str| std::fs::read(path).map_err(|error| format!("cannot read {path}: {error}"));
    let text = |path: &str| String::from_utf8(read(path)?).map_err(|error| format!("{path}: {error}"));
    let of_machine = |path: &String| match declarations(path, &text(path)?).into_iter().next() {
        Some(declaration) => Ok((named(path), declaration)),
        None => Err(format!("{path}: there is no `mechanism! {{…}}`")),
    };
    let texts = gallery.iter().map(of_machine).collect::<Result<Vec<_>, String>>()?;
    let page = Page::new(&[], "plm").with_editor(&read(script)?, &read(module)?, &texts).with_book(book);
    page.write_html(html).map_err(|error| error.to_string())
}

/// `machines/four_bar.rs` as it is shown: `Four bar`.
fn named(path: &str) -> String {
    let stem = Path::new(path).file_stem().unwrap_or_default().to_string_lossy().replace('_', " ");
    let mut letters = stem.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
