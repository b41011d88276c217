//! Files for other programs: a compiled mechanism as MJCF or URDF.
//!
//! The plane of the mechanism is that of x and z in the file: its x is x, its y is z, and the axis of its hinges is −y. Bodies and joints
//! keep their names, and joints their coordinates. [`to_mjcf`] draws the assembled start; [`to_urdf`] draws all joints at zero, because URDF
//! has no other pose.

mod frames;
mod mjcf;
mod pairs;
mod pictures;
mod tags;
mod tree;
mod urdf;

use plm_compiler::span::Span;
use plm_compiler::{Assembled, AssembledPart, FieldValue, InputTerm};

use crate::notice::{Notice, Notices, Place};
use crate::number;
use pairs::{Kind, Pair};
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
}

fn exported(
    mechanism: &Assembled,
    place: PlaceOf,
    text: impl FnOnce(&Export, &mut Notices) -> String,
) -> Exported {
    let mut notices = Notices::default();
    let pairs = pairs(mechanism, place, &mut notices);
    let tree = Tree::new(mechanism, &pairs);
    for body in &mechanism.bodies {
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
    let text = text(&Export { mechanism, place, pairs, tree }, &mut notices);
    Exported { text: (!notices.has_errors()).then_some(text), notices: notices.0 }
}

/// The joints that both formats have; tells of all other parts.
fn pairs(mechanism: &Assembled, place: PlaceOf, notices: &mut Notices) -> Vec<Pair> {
    let mut pairs = Vec::new();
    for part in &mechanism.parts {
        let at = place(part.span);
        let AssembledPart { name, kind, frames, .. } = part;
        match (Kind::named(kind).filter(|_| part.of_library), &frames[..]) {
            (Some(kind), &[a, b]) => {
                let mut pair = Pair::new(name, part.span, kind, [a, b]);
                for (field, value) in &part.fields {
                    if let Err(why) = pair.set(field, value) {
                        notices.error(&at, format!("`{field}` of {} `{name}` {why}", part.kind));
                    }
                }
                pairs.push(pair);
            }
            _ if part.acts => notices
                .error(&at, format!("the {kind} `{name}` is not written: what it does would be missing")),
            // Of a part that is made of others these are written.
            _ if mechanism
                .parts
                .iter()
                .any(|other| other.name.strip_prefix(name).is_some_and(|rest| rest.starts_with('.'))) => {}
            _ => notices.warn(&at, format!("the {kind} `{name}` is not written")),
        }
    }
    pairs
}

/// A drive of a joint, by an input.
struct Drive<'a> {
    name: String,
    joint: &'a str,
    span: Span,
    factor: f64,
    /// The values of the input beyond which nothing changes.
    range: Option<[f64; 2]>,
}

/// The drives in the order of the joints.
fn drives<'a>(export: &'a Export, notices: &mut Notices) -> Vec<Drive<'a>> {
    let mut drives: Vec<Drive> = Vec::new();
    for joint in export.tree.joints(export) {
        let Some(InputTerm { input, factor, range }) = &joint.acting.drive else { continue };
        let is_shared = drives.iter().any(|known| known.name == *input);
        let name = if is_shared { format!("{input}_of_{}", joint.name) } else { input.clone() };
        if is_shared {
            notices.warn(
                &(export.place)(joint.span),
                format!("the input `{input}` drives several joints: for `{}` it is `{name}`", joint.name),
            );
        }
        drives.push(Drive { name, joint: joint.label, span: joint.span, factor: *factor, range: *range });
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
