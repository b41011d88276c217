//! Frames of SDF by name: links, frames, joints and models, each given in another one (sdformat.org, pose frame semantics).

use std::collections::BTreeMap;

use crate::notice::{Notices, Told};
use crate::space::{IDENTITY, Pose, quaternion, roll_pitch_yaw};
use crate::xml::Element;

/// Frames that are given in frames that are given in frames.
const DEEPEST: usize = 64;

/// The kind of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Model,
    Link,
    Frame,
    Joint,
}

/// A frame as its element declares it.
#[derive(Clone, Debug)]
pub(super) struct Declared<'a> {
    pub(super) element: &'a Element,
    pub(super) kind: Kind,
    /// Prefix of the names within its model: `arm::`, or nothing.
    pub(super) scope: String,
}

/// All frames of a file.
#[derive(Debug, Default)]
pub(super) struct Frames<'a> {
    declared: BTreeMap<String, Declared<'a>>,
}

impl<'a> Frames<'a> {
    /// Adds a model, and all within it; its own names have `scope` in front.
    pub(super) fn model(&mut self, model: &'a Element, outer: &str, scope: &str) {
        let own = Declared { element: model, kind: Kind::Model, scope: outer.to_owned() };
        self.declared.insert(format!("{scope}__model__"), own.clone());
        if let Some(name) = model.get("name") {
            self.declared.entry(format!("{outer}{name}")).or_insert(own);
        }
        for element in &model.children {
            let kind = match element.name.as_str() {
                "link" => Kind::Link,
                "frame" => Kind::Frame,
                "joint" => Kind::Joint,
                "model" => {
                    let name = element.get("name").unwrap_or("model");
                    self.model(element, scope, &format!("{scope}{name}::"));
                    continue;
                }
                _ => continue,
            };
            let name = element.get("name").unwrap_or_default();
            self.declared
                .insert(format!("{scope}{name}"), Declared { element, kind, scope: scope.to_owned() });
        }
    }

    /// Adds the joints and frames of a world, whose names have nothing in front.
    pub(super) fn world(&mut self, world: &'a Element) {
        for (tag, kind) in [("joint", Kind::Joint), ("frame", Kind::Frame)] {
            for element in world.children.iter().filter(|child| child.name == tag) {
                let name = element.get("name").unwrap_or_default().to_owned();
                self.declared.insert(name, Declared { element, kind, scope: String::new() });
            }
        }
    }

    pub(super) fn get(&self, scope: &str, name: &str) -> Option<&Declared<'a>> {
        self.declared.get(&format!("{scope}{name}"))
    }

    /// All frames by their full names, in the order of the alphabet.
    pub(super) fn all(&self) -> impl Iterator<Item = (&String, &Declared<'a>)> {
        self.declared.iter()
    }

    /// The pose in the world of a name within a scope.
    pub(super) fn pose(
        &self,
        scope: &str,
        name: &str,
        asking: &Element,
        notices: &mut Notices,
    ) -> Option<Pose> {
        self.pose_within(scope, name, asking, notices, 0)
    }

    fn pose_within(
        &self,
        scope: &str,
        name: &str,
        asking: &Element,
        notices: &mut Notices,
        depth: usize,
    ) -> Option<Pose> {
        if name == "world" || (name == "__model__" && self.get(scope, name).is_none()) {
            return Some(Pose::HERE);
        }
        let Some(declared) = self.get(scope, name).filter(|_| depth < DEEPEST) else {
            let why = if depth < DEEPEST { "there is no frame" } else { "it is given in itself: the frame" };
            notices.error(&asking.place, format!("{}: {why} `{name}`", asking.shown()));
            return None;
        };
        let element = declared.element;
        let own = pose_of(element, notices);
        let relative =
            element.child("pose").and_then(|pose| pose.get("relative_to")).filter(|name| !name.is_empty());
        let otherwise = match declared.kind {
            Kind::Frame => element.get("attached_to").filter(|name| !name.is_empty()).unwrap_or("__model__"),
            Kind::Joint => element.child("child").map_or("__model__", |child| child.text.as_str()),
            Kind::Link | Kind::Model => "__model__",
        };
        let outer =
            self.pose_within(&declared.scope, relative.unwrap_or(otherwise), element, notices, depth + 1)?;
        Some(outer.of(&own))
    }

    /// The full name of the link that carries a name; none for the world.
    pub(super) fn link(
        &self,
        scope: &str,
        name: &str,
        asking: &Element,
        notices: &mut Notices,
    ) -> Result<Option<String>, Told> {
        let (mut scope, mut name) = (scope.to_owned(), name.to_owned());
        for _ in 0..DEEPEST {
            if name == "world" {
                return Ok(None);
            }
            let Some(declared) = self.get(&scope, &name) else { break };
            match declared.kind {
                Kind::Link => return Ok(Some(format!("{scope}{name}"))),
                Kind::Frame => {
                    let next = declared.element.get("attached_to").filter(|next| !next.is_empty());
                    (scope, name) = (declared.scope.clone(), next.unwrap_or("__model__").to_owned());
                }
                Kind::Joint => {
                    let child = declared.element.child("child").map(|child| child.text.clone());
                    (scope, name) = (declared.scope.clone(), child.unwrap_or_default());
                }
                // The frame of a model is that of its first link.
                Kind::Model => {
                    let inner = if name == "__model__" { scope.clone() } else { format!("{scope}{name}::") };
                    let first = declared.element.child("link").and_then(|link| link.get("name"));
                    (scope, name) = (inner, first.unwrap_or_default().to_owned());
                }
            }
        }
        notices.error(&asking.place, format!("{}: there is no link `{name}`", asking.shown()));
        Err(Told)
    }
}

/// The `<pose>` of an element, in the frame that it names.
pub(super) fn pose_of(element: &Element, notices: &mut Notices) -> Pose {
    let Some(pose) = element.child("pose").filter(|pose| !pose.text.is_empty()) else { return Pose::HERE };
    if pose.get("rotation_format") == Some("quat_xyzw") {
        let Some([x, y, z, qx, qy, qz, qw]) = pose.text_numbers(notices) else { return Pose::HERE };
        return Pose { turn: quaternion([qw, qx, qy, qz]).unwrap_or(IDENTITY), at: [x, y, z] };
    }
    let Some([x, y, z, roll, pitch, yaw]) = pose.text_numbers(notices) else { return Pose::HERE };
    let unit = if pose.get("degrees") == Some("true") { std::f64::consts::PI / 180.0 } else { 1.0 };
    Pose { turn: roll_pitch_yaw([roll, pitch, yaw].map(|angle| angle * unit)), at: [x, y, z] }
}
