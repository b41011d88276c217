//! The pages of the book as texts for `plm mcp`: `pages.rs` in the folder of the build. In a clone they stand in `docs/src`, in a package in
//! `book`.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    if env::var_os("CARGO_FEATURE_MCP").is_none() {
        return Ok(());
    }
    let own = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").ok_or("no folder of the package")?);
    let out = PathBuf::from(env::var_os("OUT_DIR").ok_or("no folder of the build")?);
    let book = [own.join("../../docs/src"), own.join("book")];
    let book = book.iter().find(|folder| folder.join("SUMMARY.md").is_file()).ok_or("there is no book")?;
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed={}", book.display());
    let summary = fs::read_to_string(book.join("SUMMARY.md"))?;
    let mut table = "/// Name, title and text of each page, in the order of the book.\n\
                     pub(super) const PAGES: &[(&str, &str, &str)] = &[\n"
        .to_owned();
    for (title, file) in summary.lines().filter_map(link) {
        let text = with_programs(&fs::read_to_string(book.join(file))?, &book.join(file));
        let name = file.trim_end_matches(".md");
        let copy = out.join(name.replace('/', "-")).with_extension("md");
        fs::write(&copy, text)?;
        writeln!(table, "    ({name:?}, {title:?}, include_str!({:?})),", copy.display().to_string())?;
    }
    let language = book.join("llms.txt").canonicalize()?;
    let language = language.display().to_string();
    writeln!(
        table,
        "];\n\n/// The language in short.\npub(super) const LANGUAGE: &str = include_str!({language:?});"
    )?;
    fs::write(out.join("pages.rs"), table)?;
    Ok(())
}

/// Title and file of a line of the summary.
fn link(line: &str) -> Option<(&str, &str)> {
    let (title, rest) = line.trim_start_matches("- ").strip_prefix('[')?.split_once("](")?;
    Some((title, rest.strip_suffix(')')?))
}

/// A page with the files that it includes; of those that the package lacks the line stays, which names the file.
fn with_programs(text: &str, page: &Path) -> String {
    let line = |line: &str| included(line, page).unwrap_or_else(|| format!("{line}\n"));
    text.lines().map(line).collect()
}

/// The text that a line includes: a file, or what stands in it between the lines with the name of an anchor.
fn included(line: &str, page: &Path) -> Option<String> {
    let named = line.strip_prefix("{{#include ")?.strip_suffix("}}")?;
    let (file, anchor) = named.split_once(':').map_or((named, None), |(file, anchor)| (file, Some(anchor)));
    let text = fs::read_to_string(page.with_file_name(file)).ok()?;
    let Some(anchor) = anchor else { return Some(text) };
    let (from, to) = (format!("ANCHOR: {anchor}"), format!("ANCHOR_END: {anchor}"));
    let lines = text.lines().skip_while(|line| !line.trim_end().ends_with(&from)).skip(1);
    Some(lines.take_while(|line| !line.trim_end().ends_with(&to)).flat_map(|line| [line, "\n"]).collect())
}
