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

/// The line that gives a text two arrays, as far as it reads them.
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
    let body = emission.text(with_common(emission, bindings, &laid_out.function));
    let result = many.then(|| quote!(value));
    let among = among(name);
    quote! {
        #docs
        pub fn #name(&self) -> #kind {
            self.#among(&Common::<S>::new())
        }

        #[inline]
        fn #among(&self, common: &Common<S>) -> #kind {
            #value
            #body
            #result
        }
    }
}

/// The accessor of an output among others, which have much in common with it.
fn among(accessor: &Ident) -> Ident {
    format_ident!("{accessor}_among_")
}

/// The statements of what is read by itself.
fn body(emission: &Emission, bindings: &Bindings, function: &Function) -> TokenStream {
    let text = with_common(emission, bindings, function);
    let common = if text.contains("common.") { "let common = &Common::<S>::new();\n" } else { "" };
    emission.text(common.to_owned() + &text)
}

/// The statements of a function, with the arrays of `common` that it reads.
fn with_common(emission: &Emission, bindings: &Bindings, function: &Function) -> String {
    let reserved = ["lit", "by", "value", "a", "lambda", "q", "v", "contact", "common"];
    let rerolled = emission.rerolled;
    let around = Around { reserved: &reserved, by_reference: true, scalar: "S", direct: None, rerolled };
    let (text, _) = statements(function, bindings, &around);
    let solved = arrays(&text, ["a", "lambda"], "common.solved.get_or_init(|| self.solved_(common))");
    let pose = arrays(&text, ["q", "v"], "common.pose.get_or_init(|| self.pose_())");
    let loaded = "let contact = &common.loaded.get_or_init(|| self.loaded_()).contact.lambda;\n";
    let contact = if reads(&text, "contact") { loaded } else { "" };
    contact.to_owned() + &solved + &pose + &text
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
    let declared = |(output, _): &(&Output, &Ident)| output.declared;
    let outputs = || emission.model.outputs.iter().zip(&emission.fields.outputs).filter(declared);
    let (mut names, mut values, mut read) = (Vec::new(), Vec::new(), Vec::new());
    for (output, accessor) in outputs() {
        let [among, own] = [among(accessor).to_string(), format!("own_{}", read.len())];
        read.push(format!("let {own} = self.{among}(common);\n"));
        for (name, value) in columns_of(output, &output.unit, |k| format!("{own}{k}")) {
            names.push(name);
            values.push(value);
        }
    }
    let common = if read.is_empty() { "" } else { "let common = &Common::<S>::new();\n" };
    let read = emission.text(common.to_owned() + &read.concat());
    let count = number(names.len());
    let (names, values) = (emission.list(names), emission.list(values));
    quote! {
        /// Names and units of the columns of [`State::outputs`].
        pub const OUTPUTS: [(&'static str, &'static str); #count] = [#names];

        /// The declared outputs, in the units of [`State::OUTPUTS`].
        pub fn outputs(&self) -> [S; #count] {
            #read
            [#values]
        }
    }
}

/// All that can be read by name, and the reading of it by number: a match in blocks, as everything that is long.
fn observed(emission: &Emission) -> TokenStream {
    const BLOCK: usize = 200;
    let (mut names, mut values) = (Vec::new(), Vec::new());
    for (output, accessor) in emission.model.outputs.iter().zip(&emission.fields.outputs) {
        let (first, among) = (names.len(), among(accessor));
        let read = |k: &str| match k {
            "" => format!("state.{among}(common)"),
            k => format!("common.vector({first}, || state.{among}(common)){k}"),
        };
        let si = DisplayUnit::si(output.unit.dimension);
        for (name, value) in columns_of(output, &si, read) {
            names.push(name);
            values.push(value);
        }
    }
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

        /// The values of these quantities, SI; each is worked out when it is asked for, and what they have in common once.
        pub fn observed<const K: usize>(&self, quantities: [rt::Observed; K]) -> [S; K] {
            let common = &Common::<S>::new();
            quantities.map(|quantity| self.column_(quantity.column(), common))
        }

        /// The value of a quantity by its number.
        fn column_(&self, column: usize, common: &Common<S>) -> S {
            #(
                fn #blocks<S: Real>(state: &State<S>, column: usize, common: &Common<S>) -> S {
                    match column {
                        #contents
                        _ => S::lit(f64::NAN),
                    }
                }
            )*
            match column / #block {
                #(#numbers => #blocks(self, column, common),)*
                _ => S::lit(f64::NAN),
            }
        }
    }
}

/// Name with unit, and how it is read, of each number of an output in a unit; `read` gives the text for "", or for "[0]" and "[1]".
fn columns_of(output: &Output, unit: &DisplayUnit, read: impl Fn(&str) -> String) -> Vec<(String, String)> {
    let scale = unit.factor.to_f64();
    let read = |k: &str| if scale == 1.0 { read(k) } else { format!("{} / S::lit({scale:?})", read(k)) };
    let name = &output.name.text;
    if output.components.len() == 1 {
        return vec![(column(name, &unit.text), read(""))];
    }
    let axes = [("x", "[0]"), ("y", "[1]")].into_iter();
    axes.map(|(axis, k)| (column(&format!("{name}.{axis}"), &unit.text), read(k))).collect_vec()
}

fn column(name: &str, unit: &str) -> String {
    format!("({name:?}, {unit:?})")
}
