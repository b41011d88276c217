//! Sources and their tokens: those of proc-macro2, numbered in their order.
//!
//! A [`Span`] is a range of these numbers. So places in the declaration, in parts and in texts outside rustc are told
//! apart and ordered in one way: spans of proc-macro2 have no order, and inside rustc all tokens of a text share one.

use crate::collect::{CollectVec, PushAll};
use crate::sorted::SortedMap;
use std::cell::OnceCell;
use std::ops::Range;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::LitStr;

use crate::span::Span;
use crate::text::{LexicalError, Recovered, locate, recover};

/// Brackets within brackets that are read: more than the grammar ever enters.
const DEEPEST: u32 = 128;

/// The stream without what stands in more than 128 brackets. syn recurses over brackets, and a stack overflow cannot be
/// caught; the parser says what is too deep.
pub fn shallow(stream: TokenStream) -> TokenStream {
    if is_shallow(stream.clone(), DEEPEST) { stream } else { cut(stream, DEEPEST) }
}

fn is_shallow(stream: TokenStream, levels: u32) -> bool {
    stream.into_iter().all(|tree| match tree {
        TokenTree::Group(group) => levels > 0 && is_shallow(group.stream(), levels - 1),
        _ => true,
    })
}

fn cut(stream: TokenStream, levels: u32) -> TokenStream {
    let cut = |tree| match tree {
        TokenTree::Group(group) => {
            let inner = if levels == 0 { TokenStream::new() } else { cut(group.stream(), levels - 1) };
            let mut short = Group::new(group.delimiter(), inner);
            short.set_span(group.span());
            TokenTree::Group(short)
        }
        leaf => leaf,
    };
    stream.into_iter().map(cut).collect()
}

/// A leaf of the tree, or one bracket of a group.
#[derive(Clone, Debug)]
struct Token {
    /// As written; a raw identifier stands without `r#`.
    text: String,
    span: proc_macro2::Span,
}

/// Appends the tokens of a stream. Brackets that nobody sees, around what a `macro_rules!` has captured, are none.
fn flatten(stream: TokenStream, tokens: &mut Vec<Token>) {
    for tree in stream {
        let span = tree.span();
        let text = match tree {
            TokenTree::Group(group) => {
                let brackets = match group.delimiter() {
                    Delimiter::Parenthesis => Some(("(", ")")),
                    Delimiter::Bracket => Some(("[", "]")),
                    Delimiter::Brace => Some(("{", "}")),
                    Delimiter::None => None,
                };
                let token = |text: &str, span| Token { text: text.to_owned(), span };
                tokens.push_all(brackets.map(|(open, _)| token(open, group.span_open())));
                flatten(group.stream(), tokens);
                tokens.push_all(brackets.map(|(_, close)| token(close, group.span_close())));
                continue;
            }
            TokenTree::Ident(ident) => {
                let text = ident.to_string();
                text.strip_prefix("r#").map(str::to_owned).unwrap_or(text)
            }
            TokenTree::Punct(mark) => mark.as_char().to_string(),
            TokenTree::Literal(literal) => literal.to_string(),
        };
        tokens.push(Token { text, span });
    }
}

/// A stream of tokens with a name, and its text where there is one.
#[derive(Clone, Debug)]
pub struct Source {
    /// Its index in [`Sources`]; spans carry it.
    pub id: u32,
    /// Its name in messages: `declaration`, `revolute.plm`.
    pub name: String,
    /// Its tokens as a tree.
    pub(crate) stream: TokenStream,
    /// Lexical errors of its text; the tokens are those after recovery.
    pub(crate) lexical_errors: Vec<LexicalError>,
    tokens: Vec<Token>,
    text: Option<String>,
    /// Of an excerpt: the text with blanks for what does not belong to it.
    masked: Option<String>,
    ranges: OnceCell<Vec<Range<usize>>>,
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
    /// The number of its tokens, brackets among them.
    pub(crate) fn count(&self) -> usize {
        self.tokens.len()
    }

    /// A token as written, without the `r#` of a raw identifier; `None` after the last.
    pub(crate) fn token(&self, at: usize) -> Option<&str> {
        self.tokens.get(at).map(|token| token.text.as_str())
    }

    /// The tokens of a span as a person would write them in one line.
    pub(crate) fn written(&self, span: Span) -> String {
        let tokens = self.tokens.get(span.first as usize..=span.last as usize).unwrap_or_default();
        let is_word = |text: &str| text.starts_with(|c: char| c == '_' || c.is_alphanumeric());
        let ends_operand = |text: &str| is_word(text) || [")", "]", "}"].contains(&text);
        let compares = |text: &str| ["<", ">", "=", "!"].contains(&text);
        let joins = |text: &str| ["and", "or", "within"].contains(&text);
        let (mut line, mut before, mut was_binary) = (String::new(), "", false);
        for Token { text, .. } in tokens {
            let is_sum = ["+", "-"].contains(&text.as_str()) && ends_operand(before);
            let is_binary = is_sum || compares(text) || joins(text);
            // A comparison of two characters is two tokens.
            let is_apart = before == "," || (is_word(before) && is_word(text)) || is_binary || was_binary;
            let is_apart = is_apart && !line.is_empty() && !(compares(before) && compares(text));
            line.push_str(if is_apart { " " } else { "" });
            line.push_str(text);
            (before, was_binary) = (text, is_binary);
        }
        line
    }

    /// All of it: the text, or the tokens in one line, with what reads as the same tokens.
    pub fn whole(&self) -> String {
        let all = Span { source: self.id, first: 0, last: self.count().saturating_sub(1) as u32 };
        let excerpt = self.masked.is_some().then(|| self.text(all)).flatten().map(str::to_owned);
        excerpt.or_else(|| self.text.clone()).unwrap_or_else(|| self.written(all))
    }

    fn ranges(&self) -> Option<&[Range<usize>]> {
        let text = self.masked.as_ref().or(self.text.as_ref())?;
        let tokens = || self.tokens.iter().map(|token| token.text.as_str());
        Some(self.ranges.get_or_init(|| locate(text, tokens())))
    }

    /// The text that ranges are ranges of, brackets that were missing included; of an excerpt, all of its file.
    pub fn file(&self) -> Option<&str> {
        self.text.as_deref()
    }

    /// The token at a byte of the text, or the one after it.
    pub(crate) fn token_at(&self, byte: usize) -> Span {
        let before = self.ranges().unwrap_or_default().partition_point(|range| range.start < byte);
        let at = before.min(self.tokens.len().saturating_sub(1)) as u32;
        Span { source: self.id, first: at, last: at }
    }

    /// Byte range of a span of this source; `None` without text.
    pub fn range(&self, span: Span) -> Option<Range<usize>> {
        let end = self.text.as_ref()?.len();
        let ranges = self.ranges()?;
        let start = ranges.get(span.first as usize).map_or(end, |range| range.start);
        Some(start..ranges.get(span.last as usize).map_or(end, |range| range.end))
    }

    /// The text of a span of this source; `None` without text.
    pub fn text(&self, span: Span) -> Option<&str> {
        self.text.as_ref()?.get(self.range(span)?)
    }

    /// Line and column at which a span begins, with the text of that line; `None` without text.
    pub fn place(&self, span: Span) -> Option<(Place, &str)> {
        let start = self.range(span)?.start;
        let text = self.text.as_ref()?;
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
}

/// Files that a declaration names, by their names: what is in them, or why they cannot be read.
pub type Files = SortedMap<String, Result<String, String>>;

impl Sources {
    /// No source yet.
    pub fn new() -> Sources {
        Sources::default()
    }

    /// Adds a text; gives its index. What is no token, and brackets without partners, are errors of its parser. Lines may end as on
    /// Windows.
    pub fn add_text(&mut self, name: &str, text: &str) -> u32 {
        // rustc reads its sources in the same way.
        let text = &text.replace("\r\n", "\n");
        if let Ok(stream) = text.parse() {
            return self.add(name, stream, Some(text.to_owned()));
        }
        let recovered = recover(text);
        let shown = recovered.shown.clone();
        self.add_recovered(name, recovered, shown)
    }

    /// Adds the part of a file that is a declaration; gives its index. `masked` is the file, whose lines end as on Unix, with a blank
    /// for each byte of what does not belong to the declaration. Places and quoted lines are those of the file.
    pub fn add_excerpt(&mut self, name: &str, file: &str, masked: &str) -> u32 {
        let id = if let Ok(stream) = masked.parse() {
            self.add(name, stream, Some(file.to_owned()))
        } else {
            let recovered = recover(masked);
            let shown = unmasked(file, masked, &recovered.shown);
            self.add_recovered(name, recovered, shown)
        };
        if let Some(source) = self.list.last_mut() {
            source.masked = Some(masked.to_owned());
        }
        id
    }

    fn add_recovered(&mut self, name: &str, recovered: Recovered, shown: String) -> u32 {
        let Recovered { lexed, stream, lexical_errors, .. } = recovered;
        let id = self.add(name, stream, Some(shown));
        if let Some(source) = self.list.last_mut() {
            source.ranges =
                OnceCell::from(locate(&lexed, source.tokens.iter().map(|token| token.text.as_str())));
            source.lexical_errors = lexical_errors;
        }
        id
    }

    /// Adds tokens, those of rustc among them; gives their index.
    pub fn add_tokens(&mut self, name: &str, stream: TokenStream) -> u32 {
        self.add(name, stream, None)
    }

    /// Span that rustc has of the first token of a span; the call of the macro if the span is not of the declaration.
    pub fn place_in_rust(&self, span: Span) -> proc_macro2::Span {
        let here = proc_macro2::Span::call_site();
        self.ends(span).map_or(here, |[first, _]| first.resolved_at(here))
    }

    fn add(&mut self, name: &str, stream: TokenStream, text: Option<String>) -> u32 {
        let (id, stream, mut tokens) = (self.list.len() as u32, shallow(stream), Vec::new());
        flatten(stream.clone(), &mut tokens);
        let (name, lexical_errors, ranges) = (name.to_owned(), Vec::new(), OnceCell::new());
        self.list.push(Source { id, name, stream, lexical_errors, tokens, text, masked: None, ranges });
        id
    }

    /// The files that the declaration names, in order, for who can read them: the compiler cannot.
    pub fn named_files(&self) -> Vec<String> {
        let tokens = self.get(0).map_or(&[][..], |source| &source.tokens);
        let names = tokens
            .windows(3)
            .filter(|three| matches!(three[0].text.as_str(), "contour" | "hole") && three[1].text == ":");
        names.filter_map(|three| Some(syn::parse_str::<LitStr>(&three[2].text).ok()?.value())).collect_vec()
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

    /// Spans that rustc has of the first and the last token of a span of the declaration; `None` for another source.
    pub fn ends(&self, span: Span) -> Option<[proc_macro2::Span; 2]> {
        let declaration = self.get(0).filter(|_| span.source == 0)?;
        let at = |token: u32| declaration.tokens.get(token as usize).map(|token| token.span);
        Some([at(span.first)?, at(span.last)?])
    }
}

/// The file with the brackets that recovery has put into its masked text.
fn unmasked(file: &str, masked: &str, shown: &str) -> String {
    let mut originals = file.bytes().zip(masked.bytes()).peekable();
    let of = |byte| originals.next_if(|(_, mask)| *mask == byte).map_or(byte, |(original, _)| original);
    String::from_utf8_lossy(&shown.bytes().map(of).collect_vec()).into_owned()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::Sources;

    #[test]
    fn tokens_are_numbered_in_their_order() {
        let mut sources = Sources::new();
        let id = sources.add_text("text", "a(b[i-1], 0.5m) r#in");
        let source = sources.get(id).unwrap();
        let found: Vec<&str> = (0..source.count()).filter_map(|at| source.token(at)).collect();
        assert_eq!(found, ["a", "(", "b", "[", "i", "-", "1", "]", ",", "0.5m", ")", "in"]);
    }

    #[test]
    fn an_excerpt_has_the_places_of_its_file() {
        // A mark of one byte before the declaration, and one of two bytes within what is masked.
        let file = "m! { a(1; é } b\n";
        let read = |masked: &str| {
            let mut sources = Sources::new();
            let id = sources.add_excerpt("file", file, masked);
            let source = sources.get(id).unwrap();
            let last = source.count() as u32 - 1;
            let span = crate::span::Span { source: id, first: 0, last };
            (source.range(span).unwrap(), source.whole(), source.file().unwrap().to_owned())
        };
        assert_eq!(read("     a          \n"), (5..6, "a".to_owned(), file.to_owned()));
        let (range, whole, shown) = read("     a(1;      b\n");
        assert_eq!((range, shown.as_str()), (5..18, "m! { a(1; é } b\n)"));
        assert_eq!(whole, "a(1; é } b\n)");
    }
}
