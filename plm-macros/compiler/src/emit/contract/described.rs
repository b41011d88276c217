//! `Described`: bodies, parts, parameters and observed quantities by number.

use crate::collect::CollectVec;
use crate::emit::template::quote;
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::super::item::{state::unwrapped_pose, tables};
use super::super::lower::{Bindings, inline};
use super::super::{Emission, number, quoted, table_compression};
use crate::model::Step;
use crate::tables::{Entry, NumericTable};

/// `Described`.
pub(crate) fn described(emission: &Emission) -> TokenStream {
    let Emission { name, fields, .. } = emission;
    let table = NumericTable::new(emission.model);
    let tables = tables::tables(emission, &table);
    let (function, parameters) = (entries(emission, &table), &fields.params);
    let numbers: Vec<_> = (0..parameters.len()).map(number).collect_vec();
    let unwrapped = unwrapped_pose(emission, &quote!(state));
    let declaration = emission.text(format!("{:?}", emission.model.text));
    let file = |name: &String| format!("({name:?}, concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/\", {name:?}))");
    let files = emission.list(emission.model.files.iter().map(file));
    let (steps, shapes, holes) =
        (steps(emission), tables::shapes(emission, &table), tables::holes(emission, &table));
    quote! {
        impl<S: Real> rt::Described for #name<S> {
            const TABLES: &'static described::Tables = &#tables;
            const OBSERVED: &'static [(&'static str, &'static str)] = &State::<S>::OBSERVED;
            const DECLARATION: &'static str = #declaration;
            const FILES: &'static [(&'static str, &'static str)] = &[#files];
            #steps
            #shapes
            #holes

            #function

            fn parameter(&self, index: usize) -> Option<S> {
                match index {
                    #(#numbers => Some(self.#parameters),)*
                    _ => None,
                }
            }

            fn parameter_mut(&mut self, index: usize) -> Option<&mut S> {
                match index {
                    #(#numbers => Some(&mut self.#parameters),)*
                    _ => None,
                }
            }

            fn poses(state: &State<S>, each: &mut impl FnMut(BodyState<S>)) {
                let (q, v) = #unwrapped;
                for (q, v) in q.as_chunks::<3>().0.iter().zip(v.as_chunks::<3>().0) {
                    each(BodyState::of(*q, *v));
                }
            }

            fn observed(state: &State<S>, index: usize) -> Option<S> {
                (index < State::<S>::OBSERVED.len()).then(|| state.column_(index, &Common::<S>::new()))
            }

            fn observe(
                state: &State<S>,
                quantities: impl IntoIterator<Item = usize>,
                each: &mut impl FnMut(Option<S>),
            ) {
                let common = &Common::<S>::new();
                for index in quantities {
                    each((index < State::<S>::OBSERVED.len()).then(|| state.column_(index, common)));
                }
            }
        }
    }
}

/// The steps that the declaration orders, where there are some.
fn steps(emission: &Emission) -> Option<TokenStream> {
    let steps = &emission.model.steps;
    let ordered = |step| Step::NAMES.iter().find(|(_, known)| known == step).map(|(name, _)| name);
    let names = emission.text(quoted(steps.iter().filter_map(ordered)));
    (!steps.is_empty()).then(|| quote!(const STEPS: &'static [&'static str] = &[#names];))
}

/// The entries of the numeric table: constants, and those that are worked out, in blocks as everything that is long.
fn entries(emission: &Emission, table: &NumericTable) -> TokenStream {
    const BLOCK: usize = 200;
    let Emission { model, fields, name, .. } = emission;
    let params = model.params.iter().zip(&fields.params);
    let mut bindings: Bindings =
        params.map(|(param, field)| (param.symbol, format!("mechanism.{field}"))).collect();
    bindings.insert(model.time, "t".to_owned());
    let (mut constants, mut varying) = (Vec::new(), Vec::new());
    for (index, entry) in table.all.iter().enumerate() {
        constants.push(match entry {
            Entry::Constant(value) => tables::literal(*value),
            Entry::Varying(expr) => {
                varying.push(format!("{index} => {}", inline(*expr, &bindings)));
                tables::literal(f64::NAN)
            }
        });
    }
    let constants = emission.text(table_compression::constants(&constants));
    let blocks = varying.chunks(BLOCK).enumerate();
    let (blocks, arms): (Vec<Ident>, Vec<_>) =
        blocks.map(|(k, arms)| (format_ident!("block_{k}"), emission.values(arms.to_vec()))).unzip();
    let (literals, arms): (Vec<_>, Vec<TokenStream>) = arms.into_iter().unzip();
    quote! {
        fn figure(&self, t: S, index: usize) -> Option<S> {
            let constants: &[f64] = const { &#constants };
            #(
                fn #blocks<S: Real>(mechanism: &#name<S>, t: S, index: usize) -> Option<S> {
                    #literals
                    Some(match index {
                        #arms
                        _ => return None,
                    })
                }
                if let Some(varying) = #blocks(self, t, index) {
                    return Some(varying);
                }
            )*
            constants.get(index).copied().map(S::lit)
        }
    }
}
