//! Writes the Rust of a mechanism. No algebra happens here.
//!
//! One function writes each item: what users see in `item`, what the runtime asks for in `contract`, the straight-line
//! functions in `function`, whose statements `lower` makes of tapes.
//!
//! The type of a mechanism is defined in a module of its own, so that it may have any name. One outer module, whose name no crate
//! has, holds everything, so that a mechanism can stand in a block.

mod bindings;
mod code;
mod contract;
mod docs;
mod fields;
mod function;
mod indexed_accessors;
mod item;
mod lower;
mod print;
mod table_compression;
mod template;

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::quote;
use plm_cas::algebra;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

pub use self::code::Code;
use self::code::Texts;
use self::fields::Fields;
pub(crate) use self::fields::METHODS;
pub(crate) use self::lower::names;
#[cfg(feature = "lowered")]
pub(crate) use self::lower::{MOST_TERMS, is_pair, uses};
use crate::derive::Equations;
use crate::facts;
use crate::formulate::{Absolute, Chart, Function, Program, Reduced};
use crate::model::Model;
use crate::report::Report;
use crate::span::Span;

/// Map from a span of the declaration to the span that rustc has for it.
pub(crate) type Place<'a> = &'a dyn Fn(Span) -> proc_macro2::Span;

/// Everything that emission reads, and the texts that it has written.
pub(crate) struct Emission<'a> {
    model: &'a Model,
    equations: &'a Equations,
    program: &'a Absolute,
    form: Form<'a>,
    /// Joint coordinates, if they are taken.
    reduced: Option<&'a Reduced>,
    report: &'a Report,
    /// The name of the mechanism's type in the code.
    name: Ident,
    /// The name of the type as users see it.
    shown: Ident,
    fields: Fields,
    sizes: Sizes,
    /// May the constraints come to depend on each other?
    may_be_singular: bool,
    /// Is what repeats itself written as loops?
    rerolled: bool,
    texts: Texts,
}

/// Form of the state.
#[derive(Clone, Copy)]
enum Form<'a> {
    /// Absolute coordinates of all bodies.
    Absolute,
    /// Joint coordinates of a tree.
    Tree(&'a Chart),
    /// Independent coordinates of loops, in charts.
    Loops(&'a Reduced),
}

/// Lengths of the arrays in signatures.
struct Sizes {
    /// Coordinates of all bodies.
    nq: Literal,
    /// Constraint rows.
    nc: Literal,
    /// First-order states.
    nx: Literal,
    /// Numbers of the state.
    length: Literal,
    /// Numbers of the state that stand before the first-order ones.
    second_order: usize,
    /// Numbers of the state in absolute coordinates.
    full: Literal,
}

/// Emits a mechanism; `place` tells where rustc has the names of the declaration.
pub(crate) fn emit(
    model: &Model,
    equations: &Equations,
    program: &Program,
    report: &Report,
    place: Place,
) -> Code {
    let reduced = program.reduced();
    let form = match reduced.and_then(|reduced| Some((reduced, reduced.first()?))) {
        None => Form::Absolute,
        Some((reduced, _)) if reduced.has_loops() => Form::Loops(reduced),
        Some((_, chart)) => Form::Tree(chart),
    };
    let (shown, span) = (names::type_name(&model.name.text), place(model.name.span));
    let emission = Emission {
        model,
        equations,
        program: &program.absolute,
        form,
        reduced,
        report,
        name: names::token(names::free(&shown), span),
        shown: names::token(&shown, span),
        fields: Fields::new(model, place),
        sizes: Sizes::new(equations, reduced),
        may_be_singular: facts::may_be_singular(model, equations, reduced),
        rerolled: report.rerolls(),
        texts: Texts::default(),
    };
    let structure = module(&emission);
    emission.texts.with(structure)
}

/// The emitted code, item by item.
///
/// The one name of the user's own that is a type is that of the mechanism, and it may be any: `Option`, `State`, `S`. So the
/// type is defined in a module by itself, and the code has it under a name that nothing else in it has. The outer module has
/// a name that no crate has, so that the `use` in front of it means the same at module level and within a function.
fn module(emission: &Emission) -> TokenStream {
    let Emission { model, name, shown, .. } = emission;
    let module = names::token(&names::module_name(&model.name.text), name.span());
    let outer = format_ident!("plm_{module}_");
    let [visibility, path] = [&model.visibility, &model.crate_path].map_each(|text| emission.text(text));
    let allowed = emission.text(docs::ALLOWED);
    let docs = docs::module(emission);
    let definition = item::mechanism::definition(emission);
    let import = if name == shown { quote!(#name) } else { quote!(#shown as #name) };
    let items: &[fn(&Emission) -> TokenStream] = &[
        item::start::values,
        item::input::inputs,
        item::input::held,
        item::state::state,
        item::constants::sizes,
        item::constants::files,
        item::outputs::outputs,
        item::mechanism::constructors,
        item::mechanism::runs,
        item::input::declared,
        contract::charted::charted,
        contract::rate::rate,
        contract::contact::contacts,
        contract::system::system,
        contract::sets::sets,
        contract::singular::extended,
        item::state::pose,
        contract::moment::moment,
        contract::moment::mechanism,
        item::start::assembled,
        contract::absolute::absolute,
        contract::conditional::conditional,
        item::solved::solved,
        contract::pack::pack,
        contract::linear::linear,
        contract::ports::ports,
        contract::described::described,
        contract::statics::start_values,
        item::start::placed,
        contract::statics::statics,
        function::dynamics,
        function::motion,
        contract::linear::augmented,
        item::step::steps,
        function::instants,
    ];
    let items = items.iter().map(|item| item(emission));
    quote! {
        #[doc(inline)]
        #[allow(unreachable_pub)]
        #visibility use #outer::#module::#shown;
        #[doc(inline)]
        #[allow(unreachable_pub, unused_imports)]
        #visibility use #outer::#module;

        #allowed
        mod #outer {
            #docs
            pub mod #module {
                pub use super::code_::*;
                // By itself it goes before one of the same kind that comes with all others.
                pub use super::type_::#shown;
            }
            mod type_ {
                #definition
            }
            mod code_ {
                use super::type_::#import;
                use #path::runtime::generated::{
                    BodyStart, BodyState, Fault, Method, Operations, Real, Scalar, Sim, Start
                };
                use #path::runtime::generated as rt;
                use #path::runtime::generated::{absolute, described};
                use #path::runtime::generated::lanes::Two;

                #(#items)*
            }
        }
    }
}

impl Sizes {
    fn new(equations: &Equations, reduced: Option<&Reduced>) -> Sizes {
        let (nq, nx) = (equations.q.len(), equations.x.len());
        let second_order = 2 * reduced.map_or(nq, Reduced::freedom);
        Sizes {
            nq: number(nq),
            nc: number(equations.phi.len()),
            nx: number(nx),
            length: number(second_order + nx),
            second_order,
            full: number(2 * nq + nx),
        }
    }
}

/// A count, without a suffix.
fn number(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

/// Strings in a list.
fn quoted<T: AsRef<str>>(names: impl IntoIterator<Item = T>) -> String {
    let names: Vec<String> = names.into_iter().map(|name| format!("{:?}", name.as_ref())).collect_vec();
    names.join(", ")
}

impl Emission<'_> {
    /// Placeholder of a text in the structure.
    fn text(&self, text: impl Into<String>) -> TokenStream {
        self.texts.add(text.into())
    }

    /// A line for each entry of a list.
    fn lines(&self, entries: impl IntoIterator<Item = String>) -> TokenStream {
        self.text(entries.into_iter().map(|entry| entry + ",\n").collect::<String>())
    }

    /// Entries of a list, in one line.
    fn list(&self, entries: impl IntoIterator<Item = String>) -> TokenStream {
        self.text(entries.into_iter().collect_vec().join(", "))
    }

    /// Entries of a list, a line for each, after what it takes to read their constants.
    fn values(&self, entries: Vec<String>) -> (Option<TokenStream>, TokenStream) {
        let literals = entries.iter().any(|entry| entry.contains("lit("));
        (literals.then(|| quote!(let lit = S::lit;)), self.lines(entries))
    }

    /// Is the state in other coordinates than those of all bodies?
    fn is_reduced(&self) -> bool {
        !matches!(self.form, Form::Absolute)
    }

    /// The mechanism, if its loops are solved in charts.
    fn loops(&self) -> Option<&Reduced> {
        match self.form {
            Form::Loops(reduced) => Some(reduced),
            _ => None,
        }
    }

    /// The argument for what is remembered of loops, where there are some: as declared, and as handed over.
    fn memory_argument(&self) -> [Option<TokenStream>; 2] {
        let declared = self.loops().map(|reduced| memory(reduced, &quote!(S)));
        [declared.map(|memory| quote!(m: &#memory,)), self.loops().map(|_| quote!(m,))]
    }

    /// Accelerations and multipliers of a tree; where there are none, absolute coordinates give them.
    fn reactions(&self) -> Option<&Function> {
        match self.form {
            Form::Tree(chart) => chart.reactions.as_ref(),
            _ => None,
        }
    }

    /// Does the rate depend on the time?
    pub(in crate::emit) fn rate_knows_time(&self) -> bool {
        let rates: Vec<&Function> = match self.form {
            Form::Absolute => vec![&self.program.dynamics],
            Form::Tree(chart) => vec![&chart.rate],
            Form::Loops(reduced) => reduced.charts.iter().map(|chart| &chart.rate).collect_vec(),
        };
        rates.iter().any(|rate| algebra::symbols(&rate.roots()).contains(&self.model.time))
    }

    /// Does an output or an event read accelerations or multipliers?
    fn reads_solution(&self) -> bool {
        facts::reads_solution(self.model, self.equations, self.program)
    }

    /// Does a condition of an event read accelerations or reactions of joints?
    fn events_read_solution(&self) -> bool {
        facts::conditions::read_solution(self.model, self.equations)
    }
}

/// The type of what is remembered of loops, of numbers `scalar`.
fn memory(reduced: &Reduced, scalar: &TokenStream) -> TokenStream {
    let counts = [reduced.freedom(), reduced.turning.len(), reduced.areas, reduced.followed.len()];
    let counts = counts.map_each(number);
    quote!(rt::charts::Continuation<#scalar, #(#counts),*>)
}

/// Pose and velocity of all bodies, where `self` is the mechanism, at time `t` and state `x`; `held` is a place.
fn pose_at(held: &str) -> TokenStream {
    let held = format_ident!("{held}");
    quote!(<State<S> as rt::Moment>::new(*self, *#held, t, *x).pose_())
}
