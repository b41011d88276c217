//! A results file becomes a page: `cargo run -p plm-view --example page -- results.npz page.html [title]`.

use std::process::ExitCode;

use plm_view::Page;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [results, html, title @ ..] = arguments.as_slice() else {
        eprintln!("usage: page RESULTS.npz PAGE.html [TITLE]");
        return ExitCode::FAILURE;
    };
    let title = title.first().unwrap_or(results);
    let written = std::fs::read(results)
        .map_err(|error| format!("cannot read {results}: {error}"))
        .and_then(|bytes| Page::new(&bytes, title).write_html(html).map_err(|error| error.to_string()));
    if let Err(message) = written {
        eprintln!("{message}");
        return ExitCode::FAILURE;
    }
    println!("wrote {html}");
    ExitCode::SUCCESS
}
