//! Templates whose words `@word@` are replaced.

/// A template with its words replaced, one after the other: a replacement may have words that come later.
pub(crate) fn fill(template: &str, words: &[(&str, String)]) -> String {
    words.iter().fold(template.to_owned(), |text, (word, replacement)| {
        text.replace(&format!("@{word}@"), replacement)
    })
}

/// Lines with an indentation.
pub(crate) fn indented(lines: &str, by: usize) -> String {
    let indentation = " ".repeat(by);
    lines.lines().map(|line| format!("{indentation}{line}\n")).collect::<Vec<_>>().concat()
}
