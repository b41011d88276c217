//! Parts that are shared between mechanisms and crates.
//!
//! A proc macro sees its own tokens only. So `parts! { pub valves { … } }` leaves a `macro_rules!` after that carries
//! the definitions, and `mechanism! { use valves; pub Press { … } }` calls it with what follows the `use`; it calls
//! `mechanism!` again with the definitions in front, as `parts { … }`.

use plm_compiler::syntax::rust;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser, Result};
use syn::{Token, braced, token};

syn::custom_keyword!(parts);

/// If the declaration begins with `use path;` (after parts that were carried here before): the call of `path!`.
pub(crate) fn carried(input: &TokenStream) -> Option<TokenStream> {
    // Most declarations begin with something else: they are not read twice.
    let begins = input.clone().into_iter().next()?;
    let may_carry = matches!(begins, TokenTree::Ident(word) if word == "use" || word == "parts");
    may_carry.then(|| call.parse2(input.clone()).ok()).flatten()
}

fn call(input: ParseStream) -> Result<TokenStream> {
    let mut rest = TokenStream::new();
    while input.peek(parts) && input.peek2(token::Brace) {
        rest.extend([input.parse::<TokenTree>()?, input.parse()?]);
    }
    input.parse::<Token![use]>()?;
    let path = input.call(rust::path)?;
    input.parse::<Token![;]>()?;
    rest.extend(input.parse::<TokenStream>()?);
    Ok(quote!(#path! { #rest }))
}

/// `pub name { definitions }` as a `macro_rules!` by that name.
pub(crate) fn shared(input: ParseStream) -> Result<TokenStream> {
    let attributes = input.call(rust::attributes)?;
    let visibility = input.call(rust::visibility)?;
    if !input.peek(Ident::peek_any) || input.peek2(Ident::peek_any) {
        return Err(input.error("expected a name for the parts: `pub name { joint … part … }`"));
    }
    let name = input.call(Ident::parse_any)?;
    if !input.peek(token::Brace) {
        return Err(input.error("expected `{` and definitions: `pub name { joint … part … }`"));
    }
    let definitions;
    braced!(definitions in input);
    let definitions: TokenStream = definitions.parse()?;
    if !input.is_empty() {
        return Err(input.error("something stands after the parts: each `parts!` holds one list of them"));
    }
    let hidden = format_ident!("__plm_parts_{}", name.unraw());
    // A macro that leaves the crate must be exported from its root; one that stays must not.
    let is_public = visibility.clone().into_iter().count() == 1;
    let export = is_public.then(|| quote!(#[macro_export]));
    let visibility = if visibility.is_empty() { quote!(pub(self)) } else { visibility };
    // What is said of the parts (documentation, `cfg`) is said of the macro and of its name.
    Ok(quote! {
        #attributes
        #[doc(hidden)]
        #export
        macro_rules! #hidden {
            ($($rest:tt)*) => { ::plm::mechanism! { parts { #definitions } $($rest)* } };
        }
        #attributes
        #[doc(hidden)]
        #[allow(unused_imports)]
        #visibility use #hidden as #name;
    })
}
