//! Tokens as text that can be read: lines, indentation, and spaces where people put them.

use proc_macro2::{Delimiter, Group, Spacing, TokenStream, TokenTree};

use super::code::text_of;

/// Contents of braces up to this length stand in one line, if they are no statements.
const SHORT: usize = 60;
/// Words that an opening bracket does not touch.
const KEYWORDS: &[&str] =
    &["as", "const", "else", "for", "if", "in", "let", "match", "mut", "return", "use", "where"];

/// The structure, with its texts in their places.
pub(super) fn text(structure: &TokenStream, texts: &[String]) -> String {
    let mut printer = Printer { texts, ..Printer::default() };
    printer.stream(structure.clone(), Delimiter::Brace);
    printer.line();
    printer.text
}

#[derive(Default)]
struct Printer<'a> {
    texts: &'a [String],
    text: String,
    indent: usize,
    /// Kind of the last token.
    last: Last,
    /// Angle brackets of types that are open.
    angles: usize,
    /// Are the arguments of a closure open?
    in_closure: bool,
    /// Is everything to stand in one line?
    is_flat: bool,
}

/// Kinds of tokens, by what the next one may touch.
#[derive(Clone, Copy, Default, PartialEq)]
enum Last {
    /// Nothing of this line, or what the next token touches: `.`, `&`, `::`, an opening bracket.
    #[default]
    Open,
    /// A binary operator or a separator.
    Apart,
    /// A keyword.
    Keyword,
    /// A name that generic arguments touch: of a type, or of a function that is defined.
    Generic,
    /// Any other operand: a name, a literal, a closed bracket.
    Operand,
}

impl Printer<'_> {
    fn stream(&mut self, stream: TokenStream, within: Delimiter) {
        // Lists in `<…>` stay in their line.
        let angles = std::mem::take(&mut self.angles);
        self.trees(stream, within == Delimiter::Brace && !self.is_flat);
        self.angles = angles;
    }

    fn trees(&mut self, stream: TokenStream, is_block: bool) {
        let mut trees = stream.into_iter().peekable();
        while let Some(tree) = trees.next() {
            match (tree, trees.peek()) {
                (TokenTree::Punct(mark), Some(TokenTree::Group(attribute))) if mark.as_char() == '#' => {
                    self.attribute(attribute);
                    trees.next();
                }
                (TokenTree::Group(group), next) => {
                    self.group(&group);
                    let ends = is_block && group.delimiter() == Delimiter::Brace && !goes_on(next);
                    if ends {
                        self.line();
                    }
                    if ends && next.is_some_and(begins_item) {
                        self.text.push('\n');
                    }
                }
                (TokenTree::Punct(mark), next) => {
                    self.mark(mark.as_char(), mark.spacing());
                    if is_block && matches!(mark.as_char(), ';' | ',') && self.angles == 0 {
                        let line = self.text.rsplit('\n').next();
                        let is_constant = line.is_some_and(|line| line.contains("const "));
                        self.line();
                        let begins = next.is_some_and(begins_function);
                        if mark.as_char() == ';' && begins && !is_constant {
                            self.text.push('\n');
                        }
                    }
                }
                (TokenTree::Ident(word), _) => self.word(&word.to_string()),
                (TokenTree::Literal(literal), _) => self.operand(&literal.to_string(), Last::Operand),
            }
        }
    }

    /// Documentation becomes `///`.
    fn attribute(&mut self, group: &Group) {
        let text = group.stream().to_string();
        let literal = text.strip_prefix("doc").and_then(|rest| rest.trim_start().strip_prefix('='));
        let quoted = literal.and_then(|literal| literal.trim_start().strip_prefix("r\""));
        if let Some(doc) = quoted.and_then(|quoted| quoted.strip_suffix('"')) {
            self.put(&format!("///{doc}"));
        } else {
            self.put("#");
            self.last = Last::Open;
            self.group(group);
        }
        self.line();
    }

    fn group(&mut self, group: &Group) {
        if let Some(text) = text_of(group, self.texts) {
            return self.spliced(text);
        }
        let (open, close) = match group.delimiter() {
            Delimiter::Parenthesis => ("(", ")"),
            Delimiter::Bracket => ("[", "]"),
            Delimiter::Brace => return self.braces(group),
            Delimiter::None => ("", ""),
        };
        if matches!(self.last, Last::Apart | Last::Keyword) {
            self.put(" ");
        }
        self.put(open);
        self.last = Last::Open;
        let is_long = group.stream().into_iter().any(|tree| match &tree {
            TokenTree::Group(inner) => text_of(inner, self.texts).is_some_and(|text| text.ends_with('\n')),
            _ => false,
        });
        if is_long {
            self.indented(group);
        } else {
            self.stream(group.stream(), group.delimiter());
        }
        self.put(close);
        self.last = Last::Operand;
    }

    fn braces(&mut self, group: &Group) {
        if self.last != Last::Open {
            self.put(" ");
        }
        self.put("{");
        match self.flat(group) {
            Some(content) if content.is_empty() => self.put("}"),
            Some(content) => self.put(&format!(" {content} }}")),
            None => {
                self.indented(group);
                self.put("}");
            }
        }
        self.last = Last::Operand;
    }

    /// Contents of brackets, on lines of their own.
    fn indented(&mut self, group: &Group) {
        self.line();
        self.indent += 1;
        self.stream(group.stream(), group.delimiter());
        self.line();
        self.indent -= 1;
    }

    /// The content of braces that stands in one line.
    fn flat(&self, group: &Group) -> Option<String> {
        let mut flat = Printer { texts: self.texts, is_flat: true, ..Printer::default() };
        flat.stream(group.stream(), Delimiter::Brace);
        let line = self.text.rsplit('\n').next().unwrap_or_default();
        let is_body = line.contains("fn ") || line.contains("impl") || line.contains("match ");
        let content = flat.text.trim_end_matches(',');
        let is_list = !is_body && !content.contains([';', '\n']) && content.len() <= SHORT;
        (self.is_flat || is_list).then(|| content.to_owned())
    }

    /// A text, whose lines keep their indentation among themselves.
    fn spliced(&mut self, text: &str) {
        if self.last != Last::Open {
            self.put(" ");
        }
        for (k, line) in text.lines().enumerate() {
            if k > 0 {
                self.line();
            }
            self.put(line);
        }
        self.last = Last::Operand;
        if text.ends_with('\n') {
            self.line();
        }
    }

    fn word(&mut self, word: &str) {
        let defines = self.text.ends_with("fn");
        let last = match word {
            "static" => Last::Keyword,
            _ if KEYWORDS.contains(&word) => Last::Keyword,
            "impl" => Last::Generic,
            _ if defines || word.starts_with(char::is_uppercase) => Last::Generic,
            _ => Last::Operand,
        };
        self.operand(word, last);
    }

    fn operand(&mut self, text: &str, last: Last) {
        if self.last != Last::Open {
            self.put(" ");
        }
        self.put(text);
        self.last = last;
    }

    fn mark(&mut self, mark: char, spacing: Spacing) {
        let is_joined =
            self.text.ends_with(['-', '=', ':', '.', '<', '!', '&', '|']) && self.last == Last::Open;
        let is_prefix = matches!(self.last, Last::Apart | Last::Keyword | Last::Open);
        let (before, last) = match mark {
            ',' | ';' | '?' => (false, if mark == '?' { Last::Operand } else { Last::Apart }),
            '.' | '\'' => (matches!(self.last, Last::Apart | Last::Keyword), Last::Open),
            ':' if self.text.ends_with(':') && self.last == Last::Open => (false, Last::Open),
            ':' if spacing == Spacing::Joint => {
                (matches!(self.last, Last::Apart | Last::Keyword), Last::Open)
            }
            ':' => (false, Last::Apart),
            '<' if self.last == Last::Generic || is_prefix => {
                self.angles += 1;
                (matches!(self.last, Last::Apart | Last::Keyword), Last::Open)
            }
            '>' if self.angles > 0 && !self.text.ends_with(['-', '=']) => {
                self.angles -= 1;
                (false, Last::Generic)
            }
            '|' if is_prefix || self.in_closure => {
                let opens = !self.in_closure;
                self.in_closure = opens;
                (opens && self.last != Last::Open, if opens { Last::Open } else { Last::Apart })
            }
            '&' | '*' | '-' if is_prefix && spacing == Spacing::Alone => {
                (self.last != Last::Open, Last::Open)
            }
            '!' => (is_prefix && self.last != Last::Open, Last::Open),
            _ if spacing == Spacing::Joint => (!is_joined, Last::Open),
            _ => (!is_joined, Last::Apart),
        };
        if before {
            self.put(" ");
        }
        self.put(mark.encode_utf8(&mut [0; 4]));
        self.last = last;
    }

    /// Appends to the line, which begins with its indentation.
    fn put(&mut self, text: &str) {
        let begins = self.text.is_empty() || self.text.ends_with('\n');
        if begins && text == " " {
            return;
        }
        if begins {
            self.text.push_str(&"    ".repeat(self.indent));
        }
        self.text.push_str(text);
    }

    /// Ends the line, if it has begun.
    fn line(&mut self) {
        if !self.text.is_empty() && !self.text.ends_with('\n') {
            self.text.push('\n');
        }
        self.last = Last::Open;
    }
}

/// Does a statement go on after a block?
fn goes_on(next: Option<&TokenTree>) -> bool {
    match next {
        Some(TokenTree::Punct(mark)) => mark.as_char() != '#',
        Some(TokenTree::Ident(word)) => word == "else",
        Some(_) => false,
        None => true,
    }
}

/// Does a function or something documented begin here?
fn begins_function(tree: &TokenTree) -> bool {
    match tree {
        TokenTree::Punct(mark) => mark.as_char() == '#',
        TokenTree::Ident(word) => word == "fn" || word == "impl",
        _ => false,
    }
}

/// Does an item begin here, which an empty line stands above?
fn begins_item(tree: &TokenTree) -> bool {
    match tree {
        TokenTree::Punct(mark) => mark.as_char() == '#',
        TokenTree::Ident(word) => {
            ["pub", "fn", "impl", "mod", "const", "use"].iter().any(|item| word == item)
        }
        // Documentation.
        TokenTree::Group(group) => group.delimiter() == Delimiter::None,
        TokenTree::Literal(_) => false,
    }
}
