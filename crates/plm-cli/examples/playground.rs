//! A page in which declarations are typed, from its module and its editor: `bash examples/playground/build.sh` calls
//! `cargo run -p plm-cli --example playground -- page.html module.lzma editor.js machine.rs…`. With `--book ADDRESS` in front of these,
//! codes of diagnostics lead to their pages of the book there.

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
    let [html, module, editor, gallery @ ..] = files else {
        eprintln!("usage: playground [--book ADDRESS] PAGE.html MODULE.lzma EDITOR.js MACHINE.rs…");
        return ExitCode::FAILURE;
    };
    if let Err(message) = write(html, book, (module, editor), gallery) {
        eprintln!("{message}");
        return ExitCode::FAILURE;
    }
    println!("wrote {html}");
    ExitCode::SUCCESS
}

fn write(html: &str, book: &str, (module, editor): (&str, &str), gallery: &[String]) -> Result<(), String> {
    let read = |path: &str| std::fs::read(path).map_err(|error| format!("cannot read {path}: {error}"));
    let text = |path: &str| String::from_utf8(read(path)?).map_err(|error| format!("{path}: {error}"));
    let of_machine = |path: &String| match declarations(path, &text(path)?).into_iter().next() {
        Some(declaration) => Ok((named(path), declaration)),
        None => Err(format!("{path}: there is no `mechanism! {{…}}`")),
    };
    let texts = gallery.iter().map(of_machine).collect::<Result<Vec<_>, String>>()?;
    let page = Page::new(&[], "plm").with_editor(&text(editor)?, &read(module)?, &texts).with_book(book);
    page.write_html(html).map_err(|error| error.to_string())
}

/// `machines/four_bar.rs` as it is shown: `Four bar`.
fn named(path: &str) -> String {
    let stem = Path::new(path).file_stem().unwrap_or_default().to_string_lossy().replace('_', " ");
    let mut letters = stem.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
