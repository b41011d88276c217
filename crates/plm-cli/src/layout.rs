//! The layout of files: of a declaration, and of each `mechanism!` and `parts!` of a Rust file.

use plm_draw::layout;

use crate::excerpt::{calls, is_rust};

/// The text of a file in its layout; of a Rust file the contents of `mechanism!` and `parts!`. Line ends stay as they are.
///
/// # Errors
/// A bracket, a string or a comment has no end: a message with its line.
pub(crate) fn formatted(name: &str, text: &str) -> Result<String, String> {
    let is_windows = text.contains("\r\n");
    let unix = text.replace("\r\n", "\n");
    let formatted = if is_rust(name) { rust(&unix)? } else { layout::formatted(&unix)? };
    Ok(if is_windows { formatted.replace('\n', "\r\n") } else { formatted })
}

fn rust(text: &str) -> Result<String, String> {
    let (mut made, mut at) = (String::new(), 0);
    for inside in calls(text) {
        // With the brackets, which decide what stands beside them.
        let call = inside.start - 1..(inside.end + 1).min(text.len());
        let line = text[..call.start].rfind('\n').map_or(0, |end| end + 1);
        let indent = text[line..].len() - text[line..].trim_start().len();
        made += &text[at..call.start];
        made += &layout::laid_out(text, call.clone(), indent)?;
        at = call.end;
    }
    Ok(made + &text[at..])
}

#[cfg(test)]
mod tests {
    use super::formatted;

    #[test]
    fn a_rust_file_keeps_all_that_is_no_declaration() {
        let text = "fn  a( ) {\n    plm::mechanism! { pub P {\n  body b {mass:1 kg;}\n    }}\n    mechanism!(pub Q { } );\n}\nmacro_rules! m { () => { mechanism! { a  b } } }\n";
        let expected = "fn  a( ) {\n    plm::mechanism! { pub P {\n        body b { mass: 1 kg; }\n    }}\n    mechanism!(pub Q {});\n}\nmacro_rules! m { () => { mechanism! { a  b } } }\n";
        assert_eq!(formatted("a.rs", text).as_deref(), Ok(expected));
        assert_eq!(formatted("a.rs", &text.replace('\n', "\r\n")), Ok(expected.replace('\n', "\r\n")));
    }
}
