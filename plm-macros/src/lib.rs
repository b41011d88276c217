//! The `mechanism!` and `parts!` macros: a shim between rustc and the compiler.
//!
//! Everything that can be tested without rustc stands in `plm-compiler`; use this crate through `plm`.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod diagnostics;
mod files;
mod sharing;

use plm_compiler::token::{Sources, shallow};
use plm_compiler::{Code, Expansion, compile, names_only, without_panic};
use proc_macro2::TokenStream;
use syn::parse::Parser;

/// Declares a planar mechanism.
///
/// A declaration is a name, which becomes a type, and items in any order. `plm`'s front page has one with its program.
///
/// | item | meaning |
/// |---|---|
/// | `gravity: 9.81 m/s^2;`, `gravity: (0, -9.81) m/s^2;` | acceleration of gravity; without it there is none |
/// | `formulation: absolute;`, `loops` or `tree` | orders a formulation; without it the least one that the mechanism allows is taken |
/// | `stabilisation: projection;` or `baumgarte(0.1 s);` | how constraints are kept; projection unless said otherwise, `baumgarte` alone has 0.1 s |
/// | `impacts: poisson;`, `newton` or `sequential` | the law of impact of contacts |
/// | `code: rolled;` or `unrolled` | orders whether what repeats itself stands in loops; without it the number of operations decides |
/// | `emit: step(rk4, linearly_implicit);` | the code holds a step of fixed length by itself; `semi_implicit_euler` and, with contact, `moreau_jean` are the others |
/// | `param k: N/m = 1e4 N/m;` | a number that can change between runs; without a default `new` takes it |
/// | `input drive: N*m = 0;` | a number that can change while it runs |
/// | `let span = 0.3 m + offset;` | a name for an expression |
/// | `state p: Pa = 0;` and `rate p = …;` | a first-order state |
/// | `discrete n: 1 = 0;` and `when t > 1 s { n = 1; }` | a state that only events change, and an event |
/// | `ground { port o: (0, 0) m; }` | points of the ground |
/// | `body arm { … }` | a body |
/// | `revolute pin(arm.a, rod.b) { … }` | a part in use: its kind, its name, what it joins, its parameters |
/// | `constraint name: a = b;` | a constraint of the mechanism itself |
/// | `unilateral tip: rod.b.y >= 0;` | a gap that pushes where it is closed |
/// | `friction slip: rate(rod.b.x) within 3 N;` | a friction that sticks and slips |
/// | `require loaded: rod.y < 2 m;` | a requirement: where it stops to hold, the run ends |
/// | `node port: oil = pressure;` | a node |
/// | `domain heat { … }` | a domain of your own |
/// | `repeat i in 0..8 { … }` | items several times |
/// | `output arm.angle in deg;` | what to look at |
/// | `observe arm, shoulder;`, `observe all;` | everything by name |
/// | `joint name(…) { … }`, `part name(…) { … }` | parts of your own |
/// | `allow(W0001);` | switches a warning off |
///
/// Each number has its unit, as in `0.3 m` or `50 kN*s/m`; an expression whose units do not agree is an error. The kinds of parts are
/// those of the parts library (joints, springs, dampers, stops, cylinders, sensors, shafts, hydraulics, signals); a misspelt one is
/// answered with those that exist.
#[proc_macro]
pub fn mechanism(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let input = shallow(input.into());
    sharing::carried(&input).unwrap_or_else(|| expanded(input)).into()
}

/// Names parts that several mechanisms share: `parts! { pub valves { joint … part … } }`, then
/// `mechanism! { use valves; pub Press { … } }`, in this crate or, by its path, in another.
#[proc_macro]
pub fn parts(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    sharing::shared.parse2(shallow(input.into())).unwrap_or_else(|error| diagnostics::error(&error)).into()
}

fn expanded(input: TokenStream) -> TokenStream {
    let mut sources = Sources::new();
    sources.add_tokens("declaration", input);
    files::read(&mut sources);
    match without_panic(|| compile(&mut sources)) {
        Ok(expansion) => emit(&expansion, &sources),
        Err(what) => {
            let mut output = diagnostics::bug(&what);
            let names = without_panic(|| names_only(&mut sources)).ok().flatten();
            output.extend(names.and_then(|code| code.tokens(lexed).ok()));
            output
        }
    }
}

/// Code and diagnostics as tokens of rustc.
fn emit(expansion: &Expansion, sources: &Sources) -> TokenStream {
    let sorted = expansion.diagnostics.sorted();
    let mut output: TokenStream =
        sorted.into_iter().map(|diagnostic| diagnostics::tokens(diagnostic, sources)).collect();
    match expansion.code.as_ref().map(|code| Code::tokens(code, lexed)) {
        Some(Ok(code)) => output.extend(code),
        Some(Err(error)) => {
            output.extend(diagnostics::bug(&format!("the emitted code does not lex: {error}")));
        }
        None => {}
    }
    output
}

/// Tokens of rustc's lexer. proc-macro2 would read the text with its own before, for mistakes that rustc does not forgive:
/// 0.1 s for a chain of 64 bars.
fn lexed(text: &str) -> Result<TokenStream, proc_macro::LexError> {
    text.parse::<proc_macro::TokenStream>().map(TokenStream::from)
}
