//! Indexed accessors, for bodies and outputs of repetitions: `sim.bar(3)` beside `sim.bar_3()`.

use crate::collect::{CollectVec, PushAll};
use crate::emit::template::{joined, quote};
use proc_macro2::{Ident, Span, TokenStream};

use super::item::{outputs::kind, state::unwrapped_pose};
use super::names::{Names, token};
use super::{Emission, docs, number, table_compression};
use crate::model::{Model, Output};

/// Names of the indices; what has more of them is read by its own name alone.
const INDICES: [&str; 6] = ["i", "j", "k", "l", "m", "n"];

/// Bodies, or outputs of one shape, whose names differ in their indices alone.
#[derive(Clone)]
pub(super) struct IndexedAccessor {
    /// Name of the accessor.
    name: String,
    /// The path with names of indices in it, `bar[i].angle`.
    path: String,
    /// Indices of each member, and which of the bodies or outputs it is.
    members: Vec<(Vec<usize>, usize)>,
    are_bodies: bool,
}

/// The indexed accessors of a model whose names are free.
pub(super) fn find(model: &Model, accessors: &mut Names) -> Vec<IndexedAccessor> {
    let bodies = model.bodies.iter().map(|body| body.name.text.as_str()).enumerate();
    let outputs = model.outputs.iter().enumerate().filter(|(_, output)| output.declared);
    let outputs = outputs.map(|(k, output)| (k, output.name.text.as_str()));
    let mut found = grouped(bodies, true);
    found.push_all(grouped(outputs, false).into_iter().filter(|accessor| is_of_one_shape(model, accessor)));
    found.retain_mut(|accessor| {
        let name = accessors.free(&accessor.name);
        name.map(|name| accessor.name = name).is_some()
    });
    found
}

/// Paths that differ in their indices alone, in the order of their first members.
fn grouped<'a>(paths: impl Iterator<Item = (usize, &'a str)>, are_bodies: bool) -> Vec<IndexedAccessor> {
    let mut found: Vec<IndexedAccessor> = Vec::new();
    for (member, path) in paths {
        let Some((name, path, indices)) = split(path) else { continue };
        match found.iter_mut().find(|accessor| accessor.path == path) {
            Some(accessor) => accessor.members.push((indices, member)),
            None => found.push(IndexedAccessor { name, path, members: vec![(indices, member)], are_bodies }),
        }
    }
    found
}

/// A path without its indices, with names for them, and the indices; none if it has none, or negative ones.
fn split(path: &str) -> Option<(String, String, Vec<usize>)> {
    let (mut name, mut named, mut indices) = (String::new(), String::new(), Vec::new());
    let mut parts = path.split('[');
    let first = parts.next()?;
    name.push_str(first);
    named.push_str(first);
    for part in parts {
        let (index, rest) = part.split_once(']')?;
        named.extend(["[", INDICES.get(indices.len())?, "]", rest]);
        name.push_str(rest);
        indices.push(index.parse().ok()?);
    }
    (!indices.is_empty()).then_some((name, named, indices))
}

fn is_of_one_shape(model: &Model, accessor: &IndexedAccessor) -> bool {
    let shape = |member: usize| {
        let Output { components, unit, .. } = &model.outputs[member];
        (components.len(), unit.dimension)
    };
    let mut shapes = accessor.members.iter().map(|(_, member)| shape(*member));
    let first = shapes.next();
    shapes.all(|shape| Some(shape) == first)
}

/// Their accessors.
pub(super) fn accessors(emission: &Emission) -> TokenStream {
    let indexed = emission.fields.indexed_accessors.iter();
    let accessors = indexed.map(|accessor| {
        if accessor.are_bodies { bodies(emission, accessor) } else { outputs(emission, accessor) }
    });
    joined(accessors.collect_vec())
}

impl IndexedAccessor {
    /// Its name as an identifier.
    fn ident(&self) -> Ident {
        token(&self.name, Span::call_site())
    }

    fn indices(&self) -> Vec<Ident> {
        let count = self.members.first().map_or(0, |(indices, _)| indices.len());
        INDICES.iter().take(count).map(|name| Ident::new(name, Span::call_site())).collect_vec()
    }

    /// The first of many bodies whose numbers are those of their indices, but for the first's.
    fn in_a_row(&self) -> Option<usize> {
        let (_, first) = self.members.first()?;
        let is_next = |(k, (indices, member)): (usize, &(Vec<usize>, usize))| {
            indices.as_slice() == [k] && *member == first + k
        };
        let in_a_row = self.members.iter().enumerate().all(is_next);
        (self.are_bodies && table_compression::is_long(self.members.len()) && in_a_row).then_some(*first)
    }

    /// `match (i, j) { (0, 1) => …, _ => return None }`
    fn chosen(&self, emission: &Emission, value: impl Fn(usize) -> String) -> TokenStream {
        if let (Some(first), [index]) = (self.in_a_row(), self.indices().as_slice()) {
            let (first, count) = (number(first), number(self.members.len()));
            return quote!(if #index < #count { #first + #index } else { return None });
        }
        let arms = self.members.iter().map(|(indices, member)| {
            let indices: Vec<String> = indices.iter().map(usize::to_string).collect_vec();
            match indices.as_slice() {
                [index] => format!("{index} => {}", value(*member)),
                many => format!("({}) => {}", many.join(", "), value(*member)),
            }
        });
        let arms = emission.lines(arms);
        let of = match self.indices().as_slice() {
            [index] => quote!(#index),
            many => quote!((#(#many),*)),
        };
        quote!(match #of { #arms _ => return None })
    }
}

fn bodies(emission: &Emission, accessor: &IndexedAccessor) -> TokenStream {
    let (name, indices) = (accessor.ident(), accessor.indices());
    let nq = &emission.sizes.nq;
    let pose = unwrapped_pose(emission, &quote!(self));
    let body = accessor.chosen(emission, |body| body.to_string());
    let docs = docs::docs(
        emission,
        &format!(
            "Pose and velocity of G of body `{}`, m, m, rad; m/s, m/s, rad/s; none if there is no such body.",
            accessor.path
        ),
    );
    quote! {
        #docs
        pub fn #name(&self, #(#indices: usize),*) -> Option<BodyState<S>> {
            let body = #body;
            let (q, v): ([S; #nq], [S; #nq]) = #pose;
            BodyState::among(&q, &v, body)
        }
    }
}

fn outputs(emission: &Emission, accessor: &IndexedAccessor) -> TokenStream {
    let first = accessor.members.first().and_then(|(_, member)| emission.model.outputs.get(*member));
    let Some(first) = first else { return TokenStream::new() };
    let (name, indices, kind) = (accessor.ident(), accessor.indices(), kind(first));
    let output = accessor.chosen(emission, |output| format!("self.{}()", emission.fields.outputs[output]));
    let unit = docs::si(&first.unit);
    let docs = docs::docs(
        emission,
        &format!("Output `{}`, {unit}; none if there is no such output.", accessor.path),
    );
    quote! {
        #docs
        pub fn #name(&self, #(#indices: usize),*) -> Option<#kind> {
            Some(#output)
        }
    }
}
