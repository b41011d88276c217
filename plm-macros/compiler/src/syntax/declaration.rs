//! Contents of `mechanism!`: headers, then the mechanism.

use proc_macro2::Delimiter;
use syn::ext::IdentExt;
use syn::{LitStr, Token, token};

use super::domain::Domain;
use super::input::{Input, Reported, Result};
use super::item::{Context, Item};
use super::keyword as kw;
use super::name::Ident;
use super::part::Definition;
use super::rust;
use crate::collect::PushAll;
use crate::diag::Code;
use crate::span::Span;

/// Contents of `mechanism!`.
#[derive(Clone, Debug, Default)]
pub struct Declaration {
    /// `crate = path;`: the path of the runtime crate in emitted code.
    pub crate_path: Option<String>,
    /// Parts and domains that were declared before the mechanism: its own, or carried here by `plm::parts!`.
    pub shared: Shared,
    /// The mechanism; `None` if its head could not be read.
    pub mechanism: Option<Mechanism>,
    /// Spans of the groups of parts that `parts!` has carried here, perhaps from another crate.
    pub carried: Vec<Span>,
}

/// Definitions: parts and domains.
#[derive(Clone, Debug, Default)]
pub struct Shared {
    /// Parts.
    pub parts: Vec<Definition>,
    /// Domains.
    pub domains: Vec<Domain>,
}

/// `pub Name { … }`
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Documentation lines.
    pub docs: Vec<String>,
    /// Visibility as written.
    pub visibility: String,
    /// Its name.
    pub name: Ident,
    /// Its items.
    pub items: Vec<Item>,
}

impl Declaration {
    pub(super) fn parse(input: Input) -> Declaration {
        let mut declaration = Declaration::default();
        while !input.is_empty() && declaration.mechanism.is_none() {
            let start = input.position();
            if declaration.header(input).is_err() {
                input.recover(start);
            }
        }
        if declaration.mechanism.is_some() && !input.is_empty() {
            input
                .error(Code::UnexpectedToken, input.here(), "something stands after the mechanism")
                .help("a declaration holds one mechanism; parts stand before it or inside");
        } else if declaration.mechanism.is_none() && !input.has_errors() {
            input
                .error(Code::NoMechanism, input.here(), "no mechanism is declared")
                .help("write `pub Name { body … }`");
        }
        declaration
    }

    fn header(&mut self, input: Input) -> Result<()> {
        let docs = input.docs();
        if input.peek(Token![crate]) && input.peek2(Token![=]) {
            self.crate_path = Some(crate_path(input)?);
        } else if input.peek(kw::parts) {
            let start = input.position();
            input.advance();
            let definitions = |input: Input| {
                input.all(|input| self.shared.definition(input));
                Ok(())
            };
            let read = input.group(Delimiter::Brace, "`{`", definitions);
            self.carried.push(input.span_from(start));
            read?;
        } else if input.peek(Token![use]) {
            let message = "`use` must be the first word of the declaration";
            input.error(Code::MisplacedItem, input.here(), message);
            return Err(Reported);
        } else if input.begins_item_without_name() {
            return Err(input.items_without_name());
        } else if !self.shared.add(input, &docs)? {
            self.mechanism = Some(Mechanism::parse(input, docs)?);
        }
        Ok(())
    }
}

impl Shared {
    /// Definitions and nothing else.
    pub(super) fn parse(input: Input) -> Shared {
        let mut shared = Shared::default();
        input.all(|input| shared.definition(input));
        shared
    }

    fn definition(&mut self, input: Input) -> Result<()> {
        let docs = input.docs();
        if self.add(input, &docs)? { Ok(()) } else { Err(input.expected("`joint`, `part` or `domain`")) }
    }

    /// Reads a definition if one begins here.
    fn add(&mut self, input: Input, docs: &[String]) -> Result<bool> {
        if !input.peek2(syn::Ident::peek_any) {
            return Ok(false);
        }
        let is_joint = input.peek(kw::joint);
        if is_joint || input.peek(kw::part) {
            input.advance();
            self.parts.push(Definition::parse(input, is_joint, docs.to_vec())?);
        } else if input.eat(kw::domain) {
            self.domains.push(Domain::parse(input, docs.to_vec())?);
        } else {
            return Ok(false);
        }
        Ok(true)
    }
}

impl Mechanism {
    /// `pub Name { items }`
    fn parse(input: Input, docs: Vec<String>) -> Result<Mechanism> {
        let visibility = visibility(input)?;
        input.skip_word_of_types(&visibility);
        let name = Ident::parse(input, "the name of the mechanism")?;
        input.skip_generics();
        let items = Item::block(input, Context::Mechanism)?;
        Ok(Mechanism { docs, visibility, name, items })
    }
}

/// `pub`, `pub(crate)`, `pub(in path)`, or nothing.
fn visibility(input: Input) -> Result<String> {
    let start = input.position();
    match input.call(rust::visibility) {
        Ok(visibility) if visibility.is_empty() => Ok(String::new()),
        Ok(_) => Ok(input.text_of(input.span_from(start))),
        Err(_) => Err(input.expected("a visibility")),
    }
}

/// `crate = path;`
fn crate_path(input: Input) -> Result<String> {
    input.advance();
    input.expect(Token![=], "`=`")?;
    let start = input.position();
    if input.call(rust::path).is_err() {
        return Err(input.expected("the path of a crate"));
    }
    let path = input.text_of(input.span_from(start));
    input.semicolon()?;
    Ok(path)
}

impl Input<'_> {
    /// Documentation: `#[doc = "…"]`, which is what `///` stands for. Other attributes are mistakes.
    pub(super) fn docs(self) -> Vec<String> {
        let mut docs = Vec::new();
        while let Some(attribute) = self.attribute() {
            match attribute {
                Ok(text) if text.is_empty() => docs.push(String::new()),
                Ok(text) => docs.push_all(text.lines().map(|line| line.trim().to_string())),
                Err(Reported) => {}
            }
        }
        docs
    }

    /// The documentation of an attribute that stands here. `syn::Attribute` would read the value as an expression, and
    /// the depth of those has no bound.
    fn attribute(self) -> Option<Result<String>> {
        let is_inner = self.peek2(Token![!]) && self.peek3(token::Bracket);
        if !self.peek(Token![#]) || !(is_inner || self.peek2(token::Bracket)) {
            return None;
        }
        let start = self.position();
        self.advance();
        self.eat(Token![!]);
        let [_, name, equals] = self.ahead();
        let is_documentation = !is_inner && name == "doc" && equals == "=";
        let text = self.group(Delimiter::Bracket, "`[`", |input| {
            input.advance();
            input.advance();
            let text = input.parse::<LitStr>();
            input.advance_to(|_| false);
            text.map(|text| text.value()).map_err(|_| Reported)
        });
        let text = text.ok().filter(|_| is_documentation);
        Some(text.ok_or_else(|| self.attribute_without_meaning(self.span_from(start), name)))
    }
}
