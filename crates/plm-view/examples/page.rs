//! A results file becomes a page, a live one if there is a module of WebAssembly:
//! `cargo run -p plm-view --example page -- results.npz page.html [title [module.wasm]]`.

use std::process::ExitCode;

use plm_view::Page;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [results, html, rest @ ..] = arguments.as_slice() else {
        eprintln!("usage: page RESULTS.npz PAGE.html [TITLE [MODULE.wasm]]");
        return ExitCode::FAILURE;
    };
    if let Err(message) = write(results, html, rest) {
        eprintln!("{message}");
        return ExitCode::FAILURE;
    }
    println!("wrote {html}");
    ExitCode::SUCCESS
}

fn write(results: &str, html: &str, rest: &[String]) -> Result<(), String> {
    let read = |path: &str| std::fs::read(path).map_err(|error| format!("cannot read {path}: {error}"));
    let title = rest.first().map_or(results, String::as_str);
    let mut page = Page::new(&read(results)?, title);
    if let Some(module) = rest.get(1) {
        page = page.with_module(&read(module)?);
    }
    page.write_html(html).map_err(|error| error.to_string())
}
