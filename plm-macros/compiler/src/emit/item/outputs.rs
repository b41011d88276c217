//! Readable quantities of a state: poses, the user's outputs, energies.

use crate::collect::{CollectVec, MapEach};
use crate::emit::template::{joined, quote};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::super::bindings::Origin;
use super::super::lower::{Around, Bindings, statements};
use super::super::{Emission, docs, indexed_accessors, number, table_compression};
use super::state::unwrapped_pose;
use crate::formulate::Function;
use crate::model::Output;
use crate::units::DisplayUnit;

/// The accessors of `State`.
pub(crate) fn outputs(emission: &Emission) -> TokenStream {
    let (bindings, functions) = (emission.bindings(Origin::State), &emission.program.outputs);
    let poses = poses(emission);
    let user = (0..emission.model.outputs.len()).map(|index| user_output(emission, &bindings, index));
    let power = body(emission, &bindings, &functions.load_power);
    let energies =
        if emission.model.has_masses() { energies(emission, &bindings) } else { unknown_energies() };
    let indexed_accessors = indexed_accessors::accessors(emission);
    let branches = branches(emission, &bindings);
    let table = table(emission);
    let observed = observed(emission);
    quote! {
        impl<S: Real> State<S> {
            /// Time, s.
            pub fn time(&self) -> S {
                self.time
            }
            #poses
            #(#user)*

            #energies

            /// Power of all forces and torques but gravity and reactions, W.
            pub fn load_power(&self) -> S {
                #power
            }
            #indexed_accessors
            #branches
            #table
            #observed
        }
    }
}

/// Kinetic energy, and potential energy of gravity.
fn energies(emission: &Emission, bindings: &Bindings) -> TokenStream {
    let functions = &emission.program.outputs;
    let [kinetic, gravity] = [&functions.kinetic_energy, &functions.gravity_energy]
        .map_each(|function| body(emission, bindings, function));
    quote! {
        /// Kinetic energy of all bodies, J.
        pub fn kinetic_energy(&self) -> S {
            #kinetic
        }

        /// Potential energy of gravity above the origin, J.
        pub fn gravity_energy(&self) -> S {
            #gravity
        }
    }
}

/// Energies where a body has no mass: who calls them reads why there are none.
fn unknown_energies() -> TokenStream {
    quote! {
        /// Not known: a body is declared without mass.
        pub fn kinetic_energy(&self) -> S where Self: rt::HasMasses {
            S::lit(f64::NAN)
        }

        /// Not known: a body is declared without mass.
        pub fn gravity_energy(&self) -> S where Self: rt::HasMasses {
            S::lit(f64::NAN)
        }
    }
}

/// The pose of every body.
fn poses(emission: &Emission) -> TokenStream {
    let Emission { model, fields, equations, .. } = emission;
    let nq = equations.q.len();
    let pose = |(k, (body, field)): (usize, (&crate::model::Body, &Ident))| {
        let docs =
            format!("Pose and velocity of G of body `{}`: m, m, rad; m/s, m/s, rad/s.", body.name.text);
        let docs = docs::docs(emission, &docs);
        if emission.rerolled {
            let k = number(k);
            return quote! {
                #docs
                pub fn #field(&self) -> BodyState<S> {
                    self.body_(#k)
                }
            };
        }
        let reduced = emission.is_reduced();
        let (q, v, i, j) =
            if reduced { ("q", "v", 3 * k, 3 * k) } else { ("self.x", "self.x", 3 * k, nq + 3 * k) };
        let triple = |array: &str, k: usize| [k, k + 1, k + 2].map_each(|k| format!("{array}[{k}]"));
        let ([x, y, mut angle], rates) = (triple(q, i), triple(v, j).join(", "));
        if let Some(count) = model.turns.iter().position(|counted| counted.bodies.contains(&k)) {
            angle = format!("rt::turns::whole({angle}, self.held.turns[{count}])");
        }
        let body = format!("BodyState::of([{x}, {y}, {angle}], [{rates}])");
        let pose = arrays(&body, ["q", "v"], "self.pose_()");
        let body = emission.text(pose + &body);
        quote! {
            #docs
            pub fn #field(&self) -> BodyState<S> {
                #body
            }
        }
    };
    let bodies = joined(model.bodies.iter().zip(&fields.bodies).enumerate().map(pose).collect_vec());
    let unwrapped = unwrapped_pose(emission, &quote!(self));
    let nq = number(nq);
    let by_number = emission.rerolled.then(|| {
        quote! {
            /// The body with this number.
            fn body_(&self, body: usize) -> BodyState<S> {
                let (q, v): ([S; #nq], [S; #nq]) = #unwrapped;
                let none = [S::lit(f64::NAN); 3];
                BodyState::among(&q, &v, body).unwrap_or(BodyState::of(none, none))
            }
        }
    });
    quote!(#bodies #by_number)
}

/// The line that gives an accessor of `State` two arrays, as far as it reads them.
fn arrays(text: &str, [first, second]: [&str; 2], from: &str) -> String {
    match [first, second].map_each(|array| if reads(text, array) { array } else { "_" }) {
        ["_", "_"] => String::new(),
        [first, second] => format!("let ({first}, {second}) = {from};\n"),
    }
}

/// Does the text read this array?
fn reads(text: &str, array: &str) -> bool {
    text.match_indices(array).any(|(at, _)| {
        let (before, after) = (&text[..at], &text[at + array.len()..]);
        !before.ends_with(|c: char| c.is_alphanumeric() || c == '_') && after.starts_with(['[', ';'])
    })
}

/// The type of an output.
pub(crate) fn kind(output: &Output) -> TokenStream {
    match output.components.len() {
        1 => quote!(S),
        count => {
            let count = number(count);
            quote!([S; #count])
        }
    }
}

fn user_output(emission: &Emission, bindings: &Bindings, index: usize) -> TokenStream {
    let (output, laid_out) = (&emission.model.outputs[index], &emission.program.outputs.user[index]);
    let (name, kind) = (&emission.fields.outputs[index], kind(output));
    let what = if output.declared { "Output" } else { "Observed:" };
    let own = if output.docs.is_empty() { String::new() } else { format!("\n\n{}", output.docs) };
    let docs = format!("{what} `{}`, {}.{own}", output.name.text, docs::si(&output.unit));
    let docs = docs::docs(emission, &docs);
    let many = output.components.len() > 1;
    let value = many.then(|| {
        let count = number(output.components.len());
        quote!(let mut value = [S::lit(0.0); #count];)
    });
    let body = body(emission, bindings, &laid_out.function);
    let result = many.then(|| quote!(value));
    quote! {
        #docs
        pub fn #name(&self) -> #kind {
            #value
            #body
            #result
        }
    }
}

fn body(emission: &Emission, bindings: &Bindings, function: &Function) -> TokenStream {
    let reserved = ["lit", "by", "value", "a", "lambda", "q", "v", "contact"];
    let rerolled = emission.rerolled;
    let around = Around { reserved: &reserved, by_reference: false, scalar: "S", direct: None, rerolled };
    let (text, _) = statements(function, bindings, &around);
    let solved = arrays(&text, ["a", "lambda"], "self.solved_()");
    let pose = arrays(&text, ["q", "v"], "self.pose_()");
    let contact = if reads(&text, "contact") { "let contact = self.loaded_().contact.lambda;\n" } else { "" };
    emission.text(contact.to_owned() + &solved + &pose + &text)
}

/// The turns that tell the mirror images of loops apart.
fn branches(emission: &Emission, bindings: &Bindings) -> TokenStream {
    let Emission { model, equations, program, .. } = emission;
    let count = number(equations.branches.len());
    let joints = equations.branches.iter().map(|branch| model.parts[branch.part].name.text.clone());
    let joints = joints.collect_vec();
    let joints = if table_compression::is_long(joints.len()) {
        let names = table_compression::names(emission, &joints);
        quote!({
            let names: &[&str; #count] = const { &#names };
            core::array::from_fn(|k| (names[k], value[k]))
        })
    } else {
        let joints = joints.iter().enumerate().map(|(k, name)| format!("({name:?}, value[{k}])"));
        let joints = emission.list(joints);
        quote!([#joints])
    };
    let body = body(emission, bindings, &program.outputs.branches);
    quote! {
        /// Which of the mirror images of its loops the mechanism is in: for each revolute between two bodies, how far
        /// the second turns from the first, rad, positive to the left.
        pub fn branches(&self) -> [(&'static str, S); #count] {
            let mut value = [S::lit(0.0); #count];
            #body
            #joints
        }
    }
}

/// The outputs as a row of a table, with names and units.
fn table(emission: &Emission) -> TokenStream {
    let (names, values): (Vec<String>, Vec<String>) =
        columns_of(emission, "self", Columns::Declared).into_iter().unzip();
    let count = number(names.len());
    let (names, values) = (emission.list(names), emission.list(values));
    quote! {
        /// Names and units of the columns of [`State::outputs`].
        pub const OUTPUTS: [(&'static str, &'static str); #count] = [#names];

        /// The declared outputs, in the units of [`State::OUTPUTS`].
        pub fn outputs(&self) -> [S; #count] {
            [#values]
        }
    }
}

/// All that can be read by name, and the reading of it by number: a match in blocks, as everything that is long.
fn observed(emission: &Emission) -> TokenStream {
    const BLOCK: usize = 200;
    let (names, values): (Vec<String>, Vec<String>) =
        columns_of(emission, "state", Columns::All).into_iter().unzip();
    let (count, names) = (number(names.len()), emission.lines(names));
    let blocks: Vec<Ident> =
        (0..values.len().div_ceil(BLOCK)).map(|block| format_ident!("block_{block}")).collect_vec();
    let contents = values.chunks(BLOCK).enumerate().map(|(block, values)| {
        let arms = values.iter().zip(block * BLOCK..);
        emission.lines(arms.map(|(value, k)| format!("{k} => {value}")))
    });
    let (numbers, block) = ((0..blocks.len()).map(number), number(BLOCK));
    quote! {
        /// Names and SI units of the outputs and of all that is observed.
        pub const OBSERVED: [(&'static str, &'static str); #count] = [#names];

        /// The quantities of these names; `Err` with the first that is not in [`State::OBSERVED`].
        pub fn find<'n, const K: usize>(names: [&'n str; K]) -> Result<[rt::Observed; K], &'n str> {
            rt::Observed::find(&Self::OBSERVED, names)
        }

        /// The values of these quantities, SI; each is worked out when it is asked for.
        pub fn observed<const K: usize>(&self, quantities: [rt::Observed; K]) -> [S; K] {
            quantities.map(|quantity| self.column_(quantity.column()))
        }

        /// The value of a quantity by its number.
        fn column_(&self, column: usize) -> S {
            #(
                fn #blocks<S: Real>(state: &State<S>, column: usize) -> S {
                    match column {
                        #contents
                        _ => S::lit(f64::NAN),
                    }
                }
            )*
            match column / #block {
                #(#numbers => #blocks(self, column),)*
                _ => S::lit(f64::NAN),
            }
        }
    }
}

/// Which outputs make columns, and in which units.
#[derive(Clone, Copy, PartialEq)]
enum Columns {
    /// Those that are declared, in the units that they ask for.
    Declared,
    /// Those and what is observed, in SI.
    All,
}

/// Name with unit, and how `state` reads it, of each number of the outputs that are asked for.
fn columns_of(emission: &Emission, state: &str, wanted: Columns) -> Vec<(String, String)> {
    let mut columns = Vec::new();
    let outputs = emission.model.outputs.iter().zip(&emission.fields.outputs);
    for (output, accessor) in outputs.filter(|(output, _)| wanted == Columns::All || output.declared) {
        let shown = wanted == Columns::Declared;
        let unit = if shown { output.unit.clone() } else { DisplayUnit::si(output.unit.dimension) };
        let scale = unit.factor.to_f64();
        let read = |value: String| if scale == 1.0 { value } else { format!("{value} / S::lit({scale:?})") };
        if output.components.len() == 1 {
            columns.push((column(&output.name.text, &unit.text), read(format!("{state}.{accessor}()"))));
        } else {
            for (axis, k) in ["x", "y"].into_iter().zip(0..) {
                let name = column(&format!("{}.{axis}", output.name.text), &unit.text);
                columns.push((name, read(format!("{state}.{accessor}()[{k}]"))));
            }
        }
    }
    columns
}

fn column(name: &str, unit: &str) -> String {
    format!("({name:?}, {unit:?})")
}
