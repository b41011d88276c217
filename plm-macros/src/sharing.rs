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
    let start = trees.first().map_or_else(Span::call_site, TokenTree::span);
    let (head, definitions) = match trees.split_last() {
        Some((TokenTree::Group(group), head)) if group.delimiter() == Delimiter::Brace => {
            (head, group.stream())
        }
        _ => return Err((start, "expected `pub name { joint … part … }`")),
    };
    let Some((TokenTree::Ident(name), before)) = head.split_last() else {
        return Err((start, "expected a name for the parts: `pub name { … }`"));
    };
    let is_public = before.iter().any(|tree| is_word(Some(tree), "pub"))
        && !before.iter().any(|tree| matches!(tree, TokenTree::Group(_)));
    // A macro that leaves the crate must be exported from its root; one that stays must not.
    let export = if is_public { "#[macro_export]" } else { "" };
    let hidden = format!("__plm_parts_{name}");
    let item = format!(
        "#[doc(hidden)] {export} macro_rules! {hidden} {{ ($($rest:tt)*) => {{ ::plm::mechanism! {{ parts DEFINITIONS $($rest)* }} }}; }}"
    );
    let item: TokenStream = item.parse().map_err(|_| (name.span(), "expected a name"))?;
    let group = Group::new(Delimiter::Brace, definitions);
    let mut output = with_definitions(item, &group);
    let visibility: TokenStream = match (before.is_empty(), is_public) {
        (true, _) => "pub(self)".parse().unwrap_or_default(),
        (false, _) => before.iter().cloned().collect(),
    };
    output.extend("#[doc(hidden)] #[allow(unused_imports)]".parse::<TokenStream>().unwrap_or_default());
    output.extend(visibility);
    output.extend(format!("use {hidden} as").parse::<TokenStream>().unwrap_or_default());
    output.extend([
        TokenTree::Ident(Ident::new(&name.to_string(), name.span())),
        TokenTree::Punct(Punct::new(';', Spacing::Alone)),
    ]);
    Ok(output)
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

fn is_mark(tree: &TokenTree, mark: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == mark)
}
