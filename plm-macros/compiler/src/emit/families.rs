//! Bodies and outputs of repetitions by their indices: `sim.bar(3)` beside `sim.bar_3()`.

use super::names::Names;
use super::{Emission, docs, push};
use crate::model::{Model, Output};

/// Names of the indices; what has more of them is read by its own name alone.
const INDICES: [&str; 6] = ["i", "j", "k", "l", "m", "n"];

/// Bodies, or outputs of one shape, whose names differ in their indices alone.
#[derive(Clone, Debug)]
pub(crate) struct Family {
    /// Its accessor.
    name: String,
    /// The path with names of indices in it, `bar[i].angle`.
    path: String,
    /// Indices of each member, and which of the bodies or outputs it is.
    members: Vec<(Vec<usize>, usize)>,
    are_bodies: bool,
}

/// The families of a model that have a name of their own.
pub(crate) fn find(model: &Model, accessors: &mut Names) -> Vec<Family> {
    let bodies = model.bodies.iter().map(|body| body.name.text.as_str()).enumerate();
    let outputs = model.outputs.iter().enumerate().filter(|(_, output)| output.declared);
    let outputs = outputs.map(|(k, output)| (k, output.name.text.as_str()));
    let mut families = gathered(bodies, true);
    families.extend(gathered(outputs, false).into_iter().filter(|family| is_of_one_shape(model, family)));
    families.retain_mut(|family| {
        let name = accessors.free(&family.name);
        name.map(|name| family.name = name).is_some()
    });
    families
}

/// Families of paths, in the order of their first members.
fn gathered<'a>(paths: impl Iterator<Item = (usize, &'a str)>, are_bodies: bool) -> Vec<Family> {
    let mut families: Vec<Family> = Vec::new();
    for (member, path) in paths {
        let Some((name, path, indices)) = split(path) else { continue };
        match families.iter_mut().find(|family| family.path == path) {
            Some(family) => family.members.push((indices, member)),
            None => families.push(Family { name, path, members: vec![(indices, member)], are_bodies }),
        }
    }
    families
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
        push(&mut named, format_args!("[{}]{rest}", INDICES.get(indices.len())?));
        name.push_str(rest);
        indices.push(index.parse().ok()?);
    }
    (!indices.is_empty()).then_some((name, named, indices))
}

fn is_of_one_shape(model: &Model, family: &Family) -> bool {
    let shape = |member: usize| {
        let Output { components, unit, .. } = &model.outputs[member];
        (components.len(), unit.dimension)
    };
    let mut shapes = family.members.iter().map(|(_, member)| shape(*member));
    let first = shapes.next();
    shapes.all(|shape| Some(shape) == first)
}

/// Their accessors.
pub(crate) fn emit(text: &mut String, emission: &Emission) {
    for family in &emission.fields.families {
        if family.are_bodies {
            bodies(text, emission, family);
        } else {
            outputs(text, emission, family);
        }
    }
}

impl Family {
    /// `i: usize, j: usize`
    fn arguments(&self) -> String {
        let names = self.indices().iter().map(|name| format!("{name}: usize"));
        names.collect::<Vec<_>>().join(", ")
    }

    fn indices(&self) -> &'static [&'static str] {
        let count = self.members.first().map_or(0, |(indices, _)| indices.len());
        INDICES.get(..count).unwrap_or_default()
    }

    /// `match (i, j) { (0, 1) => …, _ => return None }`
    fn chosen(&self, value: impl Fn(usize) -> String) -> String {
        let tuple = |items: Vec<String>| match items.len() {
            1 => items.concat(),
            _ => format!("({})", items.join(", ")),
        };
        let arms = self.members.iter().map(|(indices, member)| {
            let indices = tuple(indices.iter().map(usize::to_string).collect());
            format!("                {indices} => {},\n", value(*member))
        });
        let of = tuple(self.indices().iter().map(ToString::to_string).collect());
        format!(
            "match {of} {{\n{}                _ => return None,\n            }}",
            arms.collect::<String>()
        )
    }
}

fn bodies(text: &mut String, emission: &Emission, family: &Family) {
    let pose = if emission.reduced.is_some() { "self.pose_()" } else { "absolute::split(&self.x)" };
    let nq = emission.equations.q.len();
    push(
        text,
        format_args!(
            "        /// Pose and velocity of G of body `{}`, m, m, rad; m/s, m/s, rad/s; none if there is no such body.
        pub fn {}(&self, {}) -> Option<BodyState<S>> {{
            let body = {};
            let (q, v): ([S; {nq}], [S; {nq}]) = {pose};
            BodyState::among(&q, &v, body)
        }}

",
            family.path,
            family.name,
            family.arguments(),
            family.chosen(|body| body.to_string()),
        ),
    );
}

fn outputs(text: &mut String, emission: &Emission, family: &Family) {
    let Some(Output { components, unit, .. }) =
        family.members.first().and_then(|(_, member)| emission.model.outputs.get(*member))
    else {
        return;
    };
    let kind = if components.len() == 1 { "S".to_owned() } else { format!("[S; {}]", components.len()) };
    push(
        text,
        format_args!(
            "        /// Output `{}`, {}; none if there is no such output.
        pub fn {}(&self, {}) -> Option<{kind}> {{
            Some({})
        }}

",
            family.path,
            docs::si(unit),
            family.name,
            family.arguments(),
            family.chosen(|output| format!("self.{}()", emission.fields.outputs[output])),
        ),
    );
}
