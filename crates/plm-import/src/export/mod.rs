//! Files for other programs: a compiled mechanism as MJCF or URDF, and its links as drawings.
//!
//! The plane of the mechanism is that of x and z in the file: its x is x, its y is z, and the axis of its hinges is −y. Bodies and joints
//! keep their names, and joints their coordinates. [`to_mjcf`] draws the assembled start; [`to_urdf`] draws all joints at zero, because URDF
//! has no other pose.

mod couplings;
mod frames;
mod links;
mod mjcf;
mod pairs;
mod pictures;
mod tags;
mod tree;
mod urdf;

pub use links::{Cutting, Drawing, Links, to_links};

use plm_compiler::span::Span;
use plm_compiler::{Assembled, AssembledPart, FieldValue};

use crate::notice::{Notice, Notices, Place};
use crate::number;
use couplings::{Coupling, Rotor, couplings, is_inside, rotors};
use frames::Posed;
use pairs::{Kind, Law, Pair};
use tree::Tree;

/// Result of an export.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Exported {
    /// The text; none where a notice is an error.
    pub text: Option<String>,
    /// Elements of the declaration that the format does not have, in their order.
    pub notices: Vec<Notice>,
}

/// The place of a span in its file.
pub type PlaceOf<'a> = &'a dyn Fn(Span) -> Place;

/// A mechanism as a model of MuJoCo, of the file with this name. Loops are points that coincide (`equality/connect`).
pub fn to_mjcf(mechanism: &Assembled, file: &str, place: PlaceOf) -> Exported {
    exported(mechanism, place, |export, notices| mjcf::text(export, file, notices))
}

/// A mechanism as a robot of ROS, of the file with this name. URDF has no loops, no springs and no gravity.
pub fn to_urdf(mechanism: &Assembled, file: &str, place: PlaceOf) -> Exported {
    exported(mechanism, place, |export, notices| urdf::text(export, file, notices))
}

/// A mechanism on its way to a file.
struct Export<'a> {
    mechanism: &'a Assembled,
    place: PlaceOf<'a>,
    pairs: Vec<Pair>,
    tree: Tree,
    rotors: Vec<Rotor>,
    couplings: Vec<Coupling>,
}

fn exported(
    mechanism: &Assembled,
    place: PlaceOf,
    text: impl FnOnce(&Export, &mut Notices) -> String,
) -> Exported {
    let mut notices = Notices::default();
    let mut pairs = pairs(mechanism);
    let rotors = rotors(mechanism, &mut pairs);
    pairs.retain(|pair| !rotors.iter().any(|rotor| rotor.has(&pair.name, mechanism)));
    let carried: Vec<usize> = rotors.iter().map(|rotor| rotor.body).collect();
    let tree = Tree::new(mechanism, &pairs, &carried);
    let couplings = couplings(mechanism, &pairs, &tree);
    let export = Export { mechanism, place, pairs, tree, rotors, couplings };
    export.tell_of_parts(&mut notices);
    let bodies = mechanism.bodies.iter().enumerate().filter(|(k, _)| !carried.contains(k));
    for (_, body) in bodies {
        if body.mass.is_none() {
            notices.error(&place(body.span), format!("`{}` has no mass", body.name));
        }
        if body.velocity.iter().any(|part| part.abs() > 1e-12) {
            notices
                .warn(&place(body.span), format!("`{}` starts at rest: its velocity is left out", body.name));
        }
    }
    for event in &mechanism.events {
        notices.error(&place(*event), "an event that sets states is not written");
    }
    let text = text(&export, &mut notices);
    Exported { text: (!notices.has_errors()).then_some(text), notices: notices.0 }
}

/// The joints that both formats have.
fn pairs(mechanism: &Assembled) -> Vec<Pair> {
    let posed = Posed { mechanism, poses: &[] };
    let of = |(number, part): (usize, &AssembledPart)| {
        let kind = Kind::named(&part.kind).filter(|_| part.of_library)?;
        let [a, b] = part.frames[..] else { return None };
        let offset = posed.port(b)[2] - posed.port(a)[2];
        let mut pair = Pair::new(&part.name, (number, part.span), kind, [a, b], offset);
        for (field, value) in &part.fields {
            pair.set(field, value);
        }
        Some(pair)
    };
    mechanism.parts.iter().enumerate().filter_map(of).collect()
}

/// A drive of a joint, by an input.
struct Drive<'a> {
    name: String,
    joint: &'a str,
    span: Span,
    law: &'a Law,
}

/// The drives in the order of the joints.
fn drives<'a>(export: &'a Export, notices: &mut Notices) -> Vec<Drive<'a>> {
    let mut drives: Vec<Drive> = Vec::new();
    for joint in export.tree.joints(export) {
        let Some(law) = &joint.acting.drive else { continue };
        let input = law.input();
        let is_shared = drives.iter().any(|known| known.name == input);
        let name = if is_shared { format!("{input}_of_{}", joint.name) } else { input.to_owned() };
        if is_shared {
            notices.warn(
                &(export.place)(joint.span),
                format!("the input `{input}` drives several joints: for `{}` it is `{name}`", joint.name),
            );
        }
        drives.push(Drive { name, joint: joint.label, span: joint.span, law });
    }
    for input in &export.mechanism.inputs {
        let (at, name) = ((export.place)(input.span), &input.name);
        if !drives.iter().any(|known| known.name == *name) {
            notices.warn(&at, format!("the input `{name}` drives no joint: it is left out"));
        } else if input.start != 0.0 {
            notices.warn(
                &at,
                format!("the input `{name}` starts at 0 and not at {}", number::short(input.start)),
            );
        }
    }
    drives
}

impl Export<'_> {
    /// Reports what the format lacks of the parts, in their order.
    fn tell_of_parts(&self, notices: &mut Notices) {
        let parts = &self.mechanism.parts;
        for (number, AssembledPart { name, kind, span, acts, .. }) in parts.iter().enumerate() {
            let at = (self.place)(*span);
            let is_rotor = |rotor: &Rotor| rotor.part == number || rotor.has(name, self.mechanism);
            let is_coupling = |coupling: &Coupling| coupling.part == number;
            let is_property = self.rotors.iter().any(is_rotor) || self.couplings.iter().any(is_coupling);
            // Of a part that is made of others these are written.
            let has_parts = || parts.iter().any(|other| is_inside(&other.name, name));
            if let Some(pair) = self.pairs.iter().find(|pair| pair.part == number) {
                for (field, why) in &pair.missing {
                    notices.error(&at, format!("`{field}` of {kind} `{name}` {why}"));
                }
            } else if *acts && !is_property {
                notices
                    .error(&at, format!("the {kind} `{name}` is not written: what it does would be missing"));
            } else if !acts && !has_parts() {
                notices.warn(&at, format!("the {kind} `{name}` is not written"));
            }
        }
    }

    /// A comment at the head of a file.
    fn comment(file: &str, more: &str) -> String {
        // Two hyphens would end it.
        let file = file.replace("--", "- -");
        format!(
            "From {file}, by plm export. Parameters have their declared values. The plane of the mechanism is that of x and z.{more}"
        )
    }
}

/// Is it a number other than zero, or none at all?
fn counts(value: &FieldValue) -> bool {
    *value != FieldValue::Number(0.0)
}
