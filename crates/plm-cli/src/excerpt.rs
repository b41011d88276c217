//! Declarations of a file: all of a `.plm` file, and each `mechanism! { … }` of a Rust file.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use crate::layout::formatted;
use crate::lexer::{Kind, Token, tokens};

/// One declaration of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Excerpt {
    /// Its range in the file, without the brackets of a macro.
    pub(crate) range: Range<usize>,
    /// Ranges of a Rust file that belong to it; `None` if the file is the declaration.
    kept: Option<Vec<Range<usize>>>,
}

impl Excerpt {
    /// The file with a blank for each byte outside the declaration; `None` if the file is the declaration.
    pub(crate) fn masked(&self, text: &str) -> Option<String> {
        self.kept.as_ref().map(|kept| masked(text, kept))
    }

    /// The text of the declaration by itself, from its margin on, with the parts that it uses in front.
    pub(crate) fn own_text(&self, text: &str) -> String {
        let Some([parts @ .., own]) = self.kept.as_deref() else { return from_margin(text) };
        let of = |range: &Range<usize>| text.get(range.clone()).unwrap_or_default();
        let own = from_margin(of(own));
        if parts.is_empty() {
            return own;
        }
        let parts: Vec<&str> = parts.iter().map(of).collect();
        let parts = parts.join(" ") + "\n";
        formatted("parts.plm", &parts).unwrap_or(parts) + &own
    }
}

/// Declarations of a file that are read.
const MOST: usize = 500;

/// Declarations of a file.
#[derive(Debug, Default)]
pub(crate) struct Excerpts {
    /// Those that can be read, in their order.
    pub(crate) found: Vec<Excerpt>,
    /// Others, each with its place and the reason.
    pub(crate) left_out: Vec<(usize, String)>,
}

/// Is a file of this name Rust?
pub(crate) fn is_rust(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "rs")
}

/// The declarations of a file, by its name. Lines of the text end as on Unix.
pub(crate) fn excerpts(name: &str, text: &str) -> Excerpts {
    if !is_rust(name) {
        let whole = Excerpt { range: 0..text.len(), kept: None };
        return Excerpts { found: vec![whole], left_out: Vec::new() };
    }
    let rust = Rust::new(text);
    let (calls, shared) = (rust.calls("mechanism"), rust.shared());
    let mut excerpts = Excerpts::default();
    for call in calls.iter().take(MOST) {
        match rust.excerpt(call, &shared) {
            Ok(excerpt) => excerpts.found.push(excerpt),
            Err(path) => {
                let why = format!("the parts of `use {path};` stand in another file");
                excerpts.left_out.push((call.inside.start, why));
            }
        }
    }
    if let Some(call) = calls.get(MOST) {
        excerpts.left_out.push((call.inside.start, format!("more than {MOST} declarations in a file")));
    }
    excerpts
}

/// The texts of the declarations of a file, by its name, each from its margin on.
pub fn declarations(name: &str, text: &str) -> Vec<String> {
    let text = text.replace("\r\n", "\n");
    excerpts(name, &text).found.iter().map(|excerpt| excerpt.own_text(&text)).collect()
}

/// Lines without the blanks that all of them begin with.
fn from_margin(text: &str) -> String {
    let filled = || text.lines().filter(|line| !line.trim().is_empty());
    let margin = filled().map(|line| line.len() - line.trim_start().len()).min().unwrap_or_default();
    let lines = text.trim_matches('\n').lines().map(|line| line.get(margin..).unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n").trim_end().to_owned() + "\n"
}

/// Contents of the calls of `mechanism!` and of `parts!` in a Rust file, in their order.
pub(crate) fn calls(text: &str) -> Vec<Range<usize>> {
    let rust = Rust::new(text);
    let mut calls = [rust.calls("mechanism"), rust.calls("parts")].concat();
    calls.sort_by_key(|call| call.inside.start);
    calls.into_iter().map(|call| call.inside).collect()
}

/// A Rust file without its comments.
struct Rust<'a> {
    text: &'a str,
    tokens: Vec<Token>,
}

/// Definitions by the name of their `parts!`.
type Shared<'a> = BTreeMap<&'a str, Vec<Range<usize>>>;

/// A call of a macro.
#[derive(Clone)]
struct Call {
    /// Range within its brackets.
    inside: Range<usize>,
    /// Indices of the tokens within.
    tokens: Range<usize>,
    /// Index of the token that is its name.
    name: usize,
}

impl Rust<'_> {
    fn new(text: &str) -> Rust<'_> {
        Rust { text, tokens: tokens(text).into_iter().filter(|token| !token.kind.is_comment()).collect() }
    }

    fn is(&self, at: usize, word: &str) -> bool {
        self.tokens.get(at).is_some_and(|token| token.text(self.text) == word)
    }

    /// Calls of a macro in brackets, but not those within `macro_rules!`, whose tokens are not there yet.
    fn calls(&self, name: &str) -> Vec<Call> {
        let (mut calls, mut at) = (Vec::new(), 0);
        // A macro of the file's own has other rules.
        if (0..self.tokens.len()).any(|at| self.is(at, "macro_rules") && self.is(at + 2, name)) {
            return calls;
        }
        while at < self.tokens.len() {
            let is_bang = self.is(at + 1, "!");
            if is_bang && self.is(at, "macro_rules") {
                at = self.close(at + 3);
            } else if is_bang && self.is(at, name) && self.opens(at + 2) {
                let close = self.close(at + 2);
                let end = self.tokens.get(close).map_or(self.text.len(), |token| token.range.start);
                let call =
                    Call { inside: self.tokens[at + 2].range.end..end, tokens: at + 3..close, name: at };
                if !self.tokens[call.tokens.clone()].iter().any(|token| token.is_mark(self.text, '$')) {
                    calls.push(call);
                }
                at = close;
            }
            at += 1;
        }
        calls
    }

    fn opens(&self, at: usize) -> bool {
        ["{", "(", "["].iter().any(|open| self.is(at, open))
    }

    /// Index of the bracket that closes the one here; the number of tokens without one.
    fn close(&self, open: usize) -> usize {
        let mut depth = 0_usize;
        for (at, token) in self.tokens.iter().enumerate().skip(open) {
            match token.text(self.text) {
                "{" | "(" | "[" if token.kind == Kind::Mark => depth += 1,
                "}" | ")" | "]" if token.kind == Kind::Mark => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                return at;
            }
        }
        self.tokens.len()
    }

    /// The declaration of a call, with the parts of this file that it uses; else the path of those that are not in front of it.
    fn excerpt(&self, call: &Call, shared: &Shared) -> Result<Excerpt, String> {
        let (first, mut begin, mut kept) = (call.tokens.start, call.inside.start, Vec::new());
        if self.is(first, "use") {
            let end = call.tokens.clone().find(|at| self.is(*at, ";")).unwrap_or(call.tokens.end);
            let path: String =
                self.tokens[first + 1..end].iter().map(|token| token.text(self.text)).collect();
            let name = ["crate::", "self::"].iter().find_map(|home| path.strip_prefix(home)).unwrap_or(&path);
            let parts = shared.get(name).filter(|parts| parts.iter().all(|part| part.end < begin));
            kept.clone_from(parts.ok_or_else(|| path.clone())?);
            begin = self.tokens.get(end).map_or(call.inside.end, |token| token.range.end);
        }
        kept.push(begin..call.inside.end);
        Ok(Excerpt { range: call.inside.clone(), kept: Some(kept) })
    }

    /// Of each `parts! { pub name { … } }`: the ranges of the keyword and of the definitions in brackets, which a declaration has in front.
    fn shared(&self) -> Shared<'_> {
        let mut shared = BTreeMap::new();
        for call in self.calls("parts") {
            let Some(open) = call.tokens.clone().find(|at| self.is(*at, "{")) else { continue };
            let Some(name) = open.checked_sub(1).and_then(|at| self.tokens.get(at)) else { continue };
            let end = self.tokens.get(self.close(open)).map_or(call.inside.end, |token| token.range.end);
            let word = self.tokens[call.name].range.clone();
            let definitions = self.tokens[open].range.start..end;
            shared.insert(name.text(self.text), vec![word, definitions]);
        }
        shared
    }
}

/// The text with blanks for all bytes but line ends outside of some ranges.
fn masked(text: &str, kept: &[Range<usize>]) -> String {
    let blank =
        |text: &str| text.bytes().map(|byte| if byte == b'\n' { '\n' } else { ' ' }).collect::<String>();
    let (mut masked, mut at) = (String::new(), 0);
    let mut kept = kept.to_vec();
    kept.sort_by_key(|range| range.start);
    for range in kept {
        masked += &blank(text.get(at..range.start).unwrap_or_default());
        masked += text.get(range.clone()).unwrap_or_default();
        at = range.end;
    }
    masked + &blank(text.get(at..).unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use super::{declarations, excerpts};

    /// The declarations of a Rust file without blanks.
    fn found(text: &str) -> Vec<String> {
        let masked = excerpts("a.rs", text).found.into_iter().filter_map(|excerpt| excerpt.masked(text));
        masked
            .inspect(|masked| assert_eq!(masked.len(), text.len()))
            .map(|masked| masked.split_whitespace().collect::<Vec<_>>().join(" "))
            .collect()
    }

    #[test]
    fn calls_are_found_and_comments_strings_and_rules_are_not() {
        let text = "/// mechanism! { a }\n// mechanism! { b }\nconst S: &str = \"mechanism! { c }\"; macro_rules! d { () => { mechanism! { e } } }\n\
                    plm::mechanism! { pub F { '{'; } }\nfn g() { mechanism!(pub H { }); let é = r\"}\"; }";
        assert_eq!(found(text), ["pub F { '{'; }", "pub H { }"]);
    }

    #[test]
    fn texts_begin_at_their_margin() {
        let rust = "plm::mechanism! {\r\n    // }\n    pub A {\n        gravity: 0;\n\n    }\n}\nplm::mechanism! { pub B {} }";
        assert_eq!(declarations("a.rs", rust), ["// }\npub A {\n    gravity: 0;\n\n}\n", "pub B {}\n"]);
        assert_eq!(declarations("a.plm", "pub C {}"), ["pub C {}\n"]);
    }

    #[test]
    fn a_call_that_is_not_closed_takes_the_rest() {
        assert_eq!(found("mechanism! { pub F { (; "), ["pub F { (;"]);
        assert_eq!(found("mechanism!"), Vec::<String>::new());
        assert_eq!(found("mechanism! {"), [""]);
        assert_eq!(found("macro_rules! a"), Vec::<String>::new());
    }

    #[test]
    fn parts_of_the_same_file_stand_in_front() {
        let text = "plm::parts! { /// Doc.\n pub valves { part a() { } } }\nmechanism! { use valves; /// M.\n pub M { } }";
        assert_eq!(found(text), ["parts { part a() { } } /// M. pub M { }"]);
        assert_eq!(declarations("a.rs", text), ["parts { part a() {} }\n/// M.\npub M { }\n"]);
        let left_out = excerpts("a.rs", "mechanism! { use other::valves; pub M { } }").left_out;
        assert_eq!(left_out, [(12, "the parts of `use other::valves;` stand in another file".to_owned())]);
        assert_eq!(excerpts("a.rs", &"mechanism!{}".repeat(600)).left_out.len(), 1);
    }
}
