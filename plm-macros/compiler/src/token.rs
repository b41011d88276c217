//! Tokens: what the parser reads, whether they came from rustc or from text.
//!
//! The two lexers agree with rustc's: `0..64` is a number, two points and a number; `0.5m` is one number with a
//! suffix; a punctuation mark is one character that says whether the next one touches it.

use std::collections::BTreeMap;

use crate::span::Span;

/// Kinds of brackets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// `( )`
    Paren,
    /// `[ ]`
    Bracket,
    /// `{ }`
    Brace,
    /// Brackets that nobody sees, around an expression that a `macro_rules!` has captured: it stays one operand.
    Captured,
}

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A name or a keyword.
    Ident,
    /// A number as written, with its suffix if it has one.
    Number,
    /// A string literal as written, with its quotes.
    Str,
    /// One character of punctuation; `joint` if the next character is punctuation too and touches it.
    Punct {
        /// Does the next mark touch this one?
        joint: bool,
    },
    /// An opening bracket.
    Open(Delimiter),
    /// A closing bracket.
    Close(Delimiter),
    /// A line of documentation, the text after `///`.
    Doc,
    /// What no rule of the language begins with.
    Other,
}

/// A token: its kind and its text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// Its kind.
    pub kind: TokenKind,
    /// Its text as written; a raw identifier stands without `r#`.
    pub text: String,
}

impl Token {
    /// A token of a kind with a text.
    pub fn new(kind: TokenKind, text: impl Into<String>) -> Token {
        Token { kind, text: text.into() }
    }

    /// A name, without the `r#` of a raw identifier: names of the language may be keywords of Rust.
    pub fn ident(text: &str) -> Token {
        Token::new(TokenKind::Ident, text.strip_prefix("r#").unwrap_or(text))
    }

    /// A mark of punctuation.
    pub fn punct(mark: char, joint: bool) -> Token {
        Token::new(TokenKind::Punct { joint }, mark)
    }

    /// An opening bracket.
    pub fn open(delimiter: Delimiter) -> Token {
        let text = match delimiter {
            Delimiter::Paren => "(",
            Delimiter::Bracket => "[",
            Delimiter::Brace => "{",
            Delimiter::Captured => "",
        };
        Token::new(TokenKind::Open(delimiter), text)
    }

    /// A closing bracket.
    pub fn close(delimiter: Delimiter) -> Token {
        let text = match delimiter {
            Delimiter::Paren => ")",
            Delimiter::Bracket => "]",
            Delimiter::Brace => "}",
            Delimiter::Captured => "",
        };
        Token::new(TokenKind::Close(delimiter), text)
    }

    /// A literal of rustc: a number, a string, or what the language has no use for.
    pub fn literal(text: &str) -> Token {
        let kind = match text.as_bytes().first() {
            Some(b'0'..=b'9') => TokenKind::Number,
            Some(b'"') => TokenKind::Str,
            Some(b'r') if text.contains('"') => TokenKind::Str,
            _ => TokenKind::Other,
        };
        Token::new(kind, text)
    }

    /// Is it this punctuation mark?
    pub fn is_punct(&self, mark: char) -> bool {
        matches!(self.kind, TokenKind::Punct { .. }) && self.text.starts_with(mark)
    }

    /// Is it this word?
    pub fn is_word(&self, word: &str) -> bool {
        self.kind == TokenKind::Ident && self.text == word
    }

    /// Does it open this kind of bracket?
    pub fn is_open(&self, delimiter: Delimiter) -> bool {
        self.kind == TokenKind::Open(delimiter)
    }
}

/// Tokens as a person would write them in one line.
pub(crate) fn written(tokens: &[Token]) -> String {
    let is_word = |token: &Token| matches!(token.kind, TokenKind::Ident | TokenKind::Number);
    let ends_operand = |token: &Token| is_word(token) || matches!(token.kind, TokenKind::Close(_));
    let mut text = String::new();
    let mut is_joined = true;
    for (k, token) in tokens.iter().enumerate() {
        let previous = k.checked_sub(1).and_then(|k| tokens.get(k));
        let is_binary = (token.is_punct('+') || token.is_punct('-')) && previous.is_some_and(ends_operand);
        let is_apart = previous.is_some_and(|previous| {
            previous.is_punct(',') || is_binary || (is_word(previous) && is_word(token))
        });
        text.push_str(if is_apart || !is_joined { " " } else { "" });
        text.push_str(&token.text);
        is_joined = !is_binary;
    }
    text
}

/// A list of tokens with a name, and its text where there is one.
#[derive(Clone, Debug)]
pub struct Source {
    /// Its index in [`Sources`]; spans carry it.
    pub id: u32,
    /// What messages call it: `declaration`, `revolute.plm`.
    pub name: String,
    /// Its tokens.
    pub tokens: Vec<Token>,
    /// The text behind the tokens; `None` if they came from rustc, which shows them by itself.
    pub text: Option<SourceText>,
}

/// The text of a source.
#[derive(Clone, Debug)]
pub struct SourceText {
    /// All of it.
    pub text: String,
    /// Byte range of each token.
    pub ranges: Vec<(u32, u32)>,
}

/// A place in a text, as people count: both from 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Line.
    pub line: usize,
    /// Column in characters.
    pub column: usize,
}

impl Source {
    /// Byte range of a span of this source; `None` without text.
    pub fn range(&self, span: Span) -> Option<(usize, usize)> {
        let text = self.text.as_ref()?;
        let end_of_text = (text.text.len() as u32, text.text.len() as u32);
        let at = |token: u32| text.ranges.get(token as usize).copied().unwrap_or(end_of_text);
        Some((at(span.first).0 as usize, at(span.last).1 as usize))
    }

    /// Where a span begins, and the line that it begins in; `None` without text.
    pub fn place(&self, span: Span) -> Option<(Place, &str)> {
        let (start, _) = self.range(span)?;
        let text = &self.text.as_ref()?.text;
        let before = text.get(..start)?;
        let line_start = before.rfind('\n').map_or(0, |at| at + 1);
        let line = text.get(line_start..)?.lines().next().unwrap_or("");
        let place = Place {
            line: before.matches('\n').count() + 1,
            column: text.get(line_start..start)?.chars().count() + 1,
        };
        Some((place, line))
    }
}

/// All sources of one compilation: the declaration first, then what it loads.
#[derive(Clone, Debug, Default)]
pub struct Sources {
    list: Vec<Source>,
    files: Files,
    /// Where rustc has the tokens of the declaration; nothing where they are those of a text.
    places: Vec<proc_macro2::Span>,
}

/// Files that a declaration names, by their names: what is in them, or why they cannot be read.
pub type Files = BTreeMap<String, Result<String, String>>;

impl Sources {
    /// No source yet.
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Adds a text, lexed here; gives its index.
    pub fn add_text(&mut self, name: &str, text: &str) -> u32 {
        let (tokens, ranges) = crate::lex::lex(text);
        let text = SourceText { text: text.to_string(), ranges };
        self.add(name, tokens, Some(text))
    }

    /// Adds tokens that were lexed elsewhere (by rustc); gives their index.
    pub fn add_tokens(&mut self, name: &str, tokens: Vec<Token>) -> u32 {
        self.add(name, tokens, None)
    }

    /// Hands over where rustc has each token of the declaration.
    pub fn add_places(&mut self, places: Vec<proc_macro2::Span>) {
        self.places = places;
    }

    /// Where rustc has what stands at a span; the call of the macro where it has it not.
    pub fn place_in_rust(&self, span: Span) -> proc_macro2::Span {
        let here = proc_macro2::Span::call_site();
        let place = self.places.get(span.first as usize).filter(|_| span.source == 0);
        place.map_or(here, |place| place.resolved_at(here))
    }

    fn add(&mut self, name: &str, tokens: Vec<Token>, text: Option<SourceText>) -> u32 {
        let id = self.list.len() as u32;
        self.list.push(Source { id, name: name.to_string(), tokens, text });
        id
    }

    /// The files that the declaration names, in order, for who can read them: the compiler cannot.
    pub fn named_files(&self) -> Vec<String> {
        let tokens = self.get(0).map_or(&[][..], |source| &source.tokens);
        let names = tokens.windows(3).filter_map(|three| match three {
            [word, colon, file]
                if word.is_word("contour") && colon.is_punct(':') && file.kind == TokenKind::Str =>
            {
                Some(crate::syntax::file_name(&file.text).to_string())
            }
            _ => None,
        });
        names.collect()
    }

    /// Hands over what is in a file that the declaration names, or why it cannot be read.
    pub fn add_file(&mut self, name: &str, content: Result<String, String>) {
        self.files.insert(name.to_string(), content);
    }

    /// The files that were handed over.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// A source by its index.
    pub fn get(&self, id: u32) -> Option<&Source> {
        self.list.get(id as usize)
    }
}
