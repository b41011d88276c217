//! Parts that are shared between mechanisms and crates.
//!
//! A proc macro sees its own tokens only. So `parts! { pub valves { … } }` leaves a `macro_rules!` behind that carries
//! the definitions, and `mechanism! { use valves; pub Press { … } }` calls it with what follows the `use`; it calls
//! `mechanism!` again with the definitions in front, as `parts { … }`.

use proc_macro::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};

/// If the declaration begins with `use path;` (behind parts that were carried here before): the call of `path!`.
pub(crate) fn carried(input: &TokenStream) -> Option<TokenStream> {
    let trees: Vec<TokenTree> = input.clone().into_iter().collect();
    let mut start = 0;
    while is_word(trees.get(start), "parts") && matches!(trees.get(start + 1), Some(TokenTree::Group(_))) {
        start += 2;
    }
    if !is_word(trees.get(start), "use") {
        return None;
    }
    let end = start + trees[start..].iter().position(|tree| is_mark(tree, ';'))?;
    let path = &trees[start + 1..end];
    let is_path = |tree: &TokenTree| matches!(tree, TokenTree::Ident(_)) || is_mark(tree, ':');
    if path.is_empty() || !path.iter().all(is_path) {
        return None;
    }
    let rest = trees[..start].iter().chain(&trees[end + 1..]).cloned();
    let mut call: TokenStream = path.iter().cloned().collect();
    call.extend([
        TokenTree::Punct(Punct::new('!', Spacing::Alone)),
        TokenTree::Group(Group::new(Delimiter::Brace, rest.collect())),
    ]);
    Some(call)
}

/// `pub name { definitions }` as a `macro_rules!` by that name; `Err` says what was expected and where.
pub(crate) fn shared(input: TokenStream) -> Result<TokenStream, (Span, &'static str)> {
    let trees: Vec<TokenTree> = input.into_iter().collect();
    let Head { attributes, visibility, name, definitions } = Head::of(&trees)?;
    let is_public = matches!(visibility, [_]);
    // A macro that leaves the crate must be exported from its root; one that stays must not.
    let export = if is_public { "#[macro_export]" } else { "" };
    let word = name.to_string();
    let hidden = format!("__plm_parts_{}", word.strip_prefix("r#").unwrap_or(&word));
    let item = format!(
        "#[doc(hidden)] {export} macro_rules! {hidden} {{ ($($rest:tt)*) => {{ ::plm::mechanism! {{ parts DEFINITIONS $($rest)* }} }}; }}"
    );
    let item: TokenStream = item.parse().map_err(|_| (name.span(), "expected a name"))?;
    // What is said of the parts (documentation, `cfg`) is said of the macro and of its name.
    let mut output: TokenStream = attributes.iter().cloned().collect();
    output.extend(with_definitions(item, definitions));
    output.extend(attributes.iter().cloned());
    output.extend("#[doc(hidden)] #[allow(unused_imports)]".parse::<TokenStream>().unwrap_or_default());
    output.extend::<TokenStream>(match visibility {
        [] => "pub(self)".parse().unwrap_or_default(),
        some => some.iter().cloned().collect(),
    });
    output.extend(format!("use {hidden} as").parse::<TokenStream>().unwrap_or_default());
    output.extend([TokenTree::Ident(name.clone()), TokenTree::Punct(Punct::new(';', Spacing::Alone))]);
    Ok(output)
}

/// `#[…] pub(…) name { definitions }`, taken apart.
struct Head<'a> {
    attributes: &'a [TokenTree],
    visibility: &'a [TokenTree],
    name: &'a Ident,
    definitions: &'a Group,
}

impl<'a> Head<'a> {
    fn of(trees: &'a [TokenTree]) -> Result<Head<'a>, (Span, &'static str)> {
        let is_attribute = |two: &[TokenTree]| is_mark(&two[0], '#') && is_group(&two[1], Delimiter::Bracket);
        let count = 2 * trees.chunks_exact(2).take_while(|two| is_attribute(two)).count();
        let (attributes, trees) = trees.split_at(count);
        let visible = match trees {
            [pub_, group, ..] if is_word(Some(pub_), "pub") && is_group(group, Delimiter::Parenthesis) => 2,
            [pub_, ..] if is_word(Some(pub_), "pub") => 1,
            _ => 0,
        };
        let (visibility, rest) = trees.split_at(visible);
        let place = |at: usize| rest.get(at).or(trees.last()).map_or_else(Span::call_site, TokenTree::span);
        let unnamed = Err((place(0), "expected a name for the parts: `pub name { joint … part … }`"));
        let Some(TokenTree::Ident(name)) = rest.first() else { return unnamed };
        match &rest[1..] {
            [TokenTree::Ident(_), ..] => unnamed,
            [TokenTree::Group(definitions)] if definitions.delimiter() == Delimiter::Brace => {
                Ok(Head { attributes, visibility, name, definitions })
            }
            [TokenTree::Group(_), behind, ..] => Err((
                behind.span(),
                "something stands behind the parts: each `parts!` holds one list of them",
            )),
            _ => Err((place(1), "expected `{` and definitions: `pub name { joint … part … }`")),
        }
    }
}

/// Puts the definitions where their place was kept.
fn with_definitions(item: TokenStream, definitions: &Group) -> TokenStream {
    let fill = |tree| match tree {
        TokenTree::Ident(word) if word.to_string() == "DEFINITIONS" => TokenTree::Group(definitions.clone()),
        TokenTree::Group(group) => {
            TokenTree::Group(Group::new(group.delimiter(), with_definitions(group.stream(), definitions)))
        }
        other => other,
    };
    item.into_iter().map(fill).collect()
}

fn is_word(tree: Option<&TokenTree>, word: &str) -> bool {
    matches!(tree, Some(TokenTree::Ident(ident)) if ident.to_string() == word)
}

fn is_group(tree: &TokenTree, delimiter: Delimiter) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == delimiter)
}

fn is_mark(tree: &TokenTree, mark: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == mark)
}
