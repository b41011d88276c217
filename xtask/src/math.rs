//! Formulas of the book, as MathML when it is built: `cargo xtask math` is a preprocessor of mdBook.
//!
//! A page has `$…$` within a line, and blocks that are fenced as `math`, as GitHub shows both. A formula that cannot be read is
//! an error.

use std::fmt::Write as _;
use std::io::Read as _;

use pulldown_latex::config::DisplayMode;
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};
use serde_json::Value;

use crate::Result;

/// Preprocessor of mdBook: answers `supports html`; without words it reads a book from the standard input, and prints it with MathML.
pub(crate) fn run(words: &[String]) -> Result {
    match words.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["supports", "html"] => Ok(()),
        [] => {
            let mut input = String::new();
            std::io::stdin().read_to_string(&mut input).map_err(|why| why.to_string())?;
            let mut pair: Value = serde_json::from_str(&input).map_err(|why| why.to_string())?;
            let mut wrong = String::new();
            typeset_chapters(&mut pair[1], &mut wrong);
            if !wrong.is_empty() {
                return Err(wrong);
            }
            println!("{}", pair[1]);
            Ok(())
        }
        _ => Err("`cargo xtask math` is called by mdBook".to_owned()),
    }
}

/// All chapters of the book, wherever they stand in it.
fn typeset_chapters(part: &mut Value, wrong: &mut String) {
    match part {
        Value::Array(parts) => parts.iter_mut().for_each(|part| typeset_chapters(part, wrong)),
        Value::Object(parts) => {
            let path = parts.get("source_path").and_then(Value::as_str).unwrap_or("a page").to_owned();
            if let Some(content @ Value::String(_)) = parts.get_mut("content") {
                match typeset(content.as_str().unwrap_or_default()) {
                    Ok(page) => *content = page.into(),
                    Err(why) => drop(write!(wrong, "{path}:{why}")),
                }
            }
            parts.values_mut().for_each(|part| typeset_chapters(part, wrong));
        }
        _ => {}
    }
}

/// A page with its formulas as MathML; all lines that are wrong, with their numbers.
fn typeset(page: &str) -> std::result::Result<String, String> {
    let (mut made, mut wrong) = (String::new(), String::new());
    let mut lines = page.lines().enumerate();
    while let Some((at, line)) = lines.next() {
        let number = at + 1;
        let text = line.trim_start();
        let fence = &text[..text.len() - text.trim_start_matches('`').len()];
        if fence.len() < 3 {
            match typeset_line(line) {
                Ok(line) => made.extend([line.as_str(), "\n"]),
                Err(why) => drop(writeln!(wrong, "{number}: {why}")),
            }
            continue;
        }
        let inside: Vec<&str> =
            lines.by_ref().map(|(_, line)| line).take_while(|line| line.trim() != fence).collect();
        if text != "```math" {
            made.extend([line, "\n"]);
            made.extend(inside.iter().flat_map(|line| [*line, "\n"]));
            let indent = &line[..line.len() - text.len()];
            made.extend([indent, fence, "\n"]);
            continue;
        }
        match mathml(&inside.join("\n"), DisplayMode::Block) {
            Ok(formula) => made.extend(["<div class=\"math\">", &formula, "</div>\n"]),
            Err(why) => drop(writeln!(wrong, "{number}: {why}")),
        }
    }
    if wrong.is_empty() { Ok(made) } else { Err(wrong) }
}

/// A line with its formulas as MathML. What stands between backticks is code.
fn typeset_line(line: &str) -> std::result::Result<String, String> {
    let (mut made, mut rest) = (String::new(), line);
    while let Some(at) = rest.find(['`', '$', '\\']) {
        made.push_str(&rest[..at]);
        rest = &rest[at..];
        let length = if rest.starts_with('`') {
            let run = rest.len() - rest.trim_start_matches('`').len();
            let code = rest[run..].find(&rest[..run]).map(|code| run + code + run);
            code.unwrap_or(run)
        } else if let Some(after) = rest.strip_prefix('\\') {
            1 + after.chars().next().map_or(0, char::len_utf8)
        } else {
            let formula = rest[1..].split_once('$').map(|(formula, _)| formula);
            let formula = formula.ok_or("a `$` has no partner in its line")?;
            if formula.is_empty() || formula.starts_with(' ') || formula.ends_with(' ') {
                return Err(format!("`${formula}$` is empty or has blanks at its ends"));
            }
            // GitHub reads Markdown first, which takes such a backslash for its own.
            if formula.split('\\').skip(1).any(|word| !word.starts_with(|c: char| c.is_ascii_alphabetic())) {
                return Err(format!("`${formula}$` has a backslash in front of a mark"));
            }
            made.push_str(&mathml(formula, DisplayMode::Inline)?);
            rest = &rest[formula.len() + 2..];
            continue;
        };
        made.push_str(&rest[..length]);
        rest = &rest[length..];
    }
    made.push_str(rest);
    Ok(made)
}

fn mathml(formula: &str, display_mode: DisplayMode) -> std::result::Result<String, String> {
    let storage = Storage::new();
    let events: std::result::Result<Vec<_>, _> = Parser::new(formula, &storage).collect();
    let events = events.map_err(|why| format!("`{formula}`: {why}"))?;
    let mut text = String::new();
    let config = RenderConfig { display_mode, ..RenderConfig::default() };
    let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
    push_mathml(&mut text, events, config).map_err(|why| format!("`{formula}`: {why}"))?;
    // A fraction within a line stands close, as TeX sets it.
    let text = text.replace("<mo>/</mo>", "<mo lspace=\"0\" rspace=\"0\">/</mo>");
    // The sign of micro stands for the letter mu; fonts have no italic one of it.
    let text = text.replace('\u{b5}', "\u{3bc}");
    Ok(without_marks(&text))
}

/// Signs that have names in MathML. mdBook takes numbers alone.
const NAMED: [(&str, char); 4] = [("&nbsp;", '\u{a0}'), ("&amp;", '&'), ("&lt;", '<'), ("&gt;", '>')];

/// MathML without a mark that Markdown or HTML would read: those between tags become numeric character references.
fn without_marks(mathml: &str) -> String {
    let (mut made, mut rest) = (String::new(), mathml);
    while let Some(letter) = rest.chars().next() {
        // A tag begins with a letter or a slash; else it is a sign of the formula.
        let is_tag = letter == '<' && rest[1..].starts_with(|c: char| c == '/' || c.is_ascii_alphabetic());
        let named = NAMED.into_iter().find(|(name, _)| rest.starts_with(name));
        let length = match named {
            Some((name, _)) => name.len(),
            None if is_tag => rest.find('>').map_or(rest.len(), |end| end + 1),
            None => letter.len_utf8(),
        };
        let letter = named.map_or(letter, |(_, letter)| letter);
        if is_tag {
            made.push_str(&rest[..length]);
        } else if letter.is_ascii_punctuation() || letter == '\n' {
            // Writing to a string does not fail.
            let _ = write!(made, "&#{};", u32::from(letter));
        } else {
            made.push(letter);
        }
        rest = &rest[length..];
    }
    made
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{typeset, typeset_line};

    #[test]
    fn formulas_become_mathml_and_code_stays() {
        let line = typeset_line("the rate $x_1$, not `$x`, and \\$5").unwrap();
        assert!(line.starts_with("the rate <math"), "{line}");
        assert!(line.contains("<msub>") && line.ends_with("</math>, not `$x`, and \\$5"), "{line}");
        let page = typeset("```sh\n$ cargo\n```\n\n```math\nM a = Q\n```\n").unwrap();
        assert!(page.starts_with("```sh\n$ cargo\n```\n\n<div class=\"math\"><math"), "{page}");
        assert!(page.ends_with("</math></div>\n"), "{page}");
    }

    #[test]
    fn markdown_reads_no_mark_of_a_formula() {
        let line = typeset_line("$a * b | [c] < d_\\text{a\'b}$").unwrap();
        let texts: String =
            line.split('<').skip(1).filter_map(|tag| tag.split_once('>')).map(|of| of.1).collect();
        assert!(!texts.contains(['*', '|', '[', '\'']), "{line}");
        assert!(texts.contains("&#60;") && texts.contains("&#124;"), "{line}");
    }

    #[test]
    fn a_wrong_formula_is_an_error_with_its_line() {
        for wrong in ["$x", "a $\\frac{1}$ b", "$\\nosuchword$", "$ x$", "$a\\,b$"] {
            let page = format!("first\n{wrong}\n");
            assert!(typeset(&page).unwrap_err().starts_with("2: "), "{wrong}");
        }
        assert!(typeset("```math\n\\frac{a}{\n```\n").is_err());
    }
}
