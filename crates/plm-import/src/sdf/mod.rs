//! SDF: the format of Gazebo (sdformat.org/spec), with loops.

mod frames;
mod link;

use std::collections::BTreeMap;

use self::frames::{Declared, Frames, Kind as Named};
use crate::drake;
use crate::notice::{Notices, Told};
use crate::space::{turned, unit};
use crate::spatial::{Joint, Kind, Link, Spatial};
use crate::urdf::drive;
use crate::xml::Element;

/// The gravity of a world that does not say it.
const GRAVITY: [f64; 3] = [0.0, 0.0, -9.8];
/// Prefix of the names of the world, so that the frame of a model is not given in itself.
const WORLD: &str = "world::";
/// A limit that bounds nothing.
const UNBOUNDED: f64 = 1e9;
/// Before this version an axis is given in the frame of the model.
const AXES_OF_JOINTS: f64 = 1.5;

struct Reader<'a> {
    version: f64,
    frames: Frames<'a>,
    links: BTreeMap<String, usize>,
    joints: BTreeMap<String, usize>,
    /// Axes of joints that may follow others, with the numbers of these joints and their scopes.
    axes: Vec<(&'a Element, usize, String)>,
    spatial: Spatial,
    notices: &'a mut Notices,
}

/// The mechanism of an `<sdf>`.
pub(crate) fn read(root: &Element, notices: &mut Notices) -> Option<Spatial> {
    let world = root.child("world");
    let outer = world.unwrap_or(root);
    let models: Vec<&Element> = outer.all("model").collect();
    let Some(first) = models.first() else {
        notices.error(&root.place, "there is no model in it");
        return None;
    };
    let name = world.unwrap_or(first).get("name").unwrap_or("model");
    let mut spatial = Spatial::new(name, &root.place, GRAVITY);
    if let Some(gravity) = world.and_then(|world| world.child("gravity")) {
        spatial.gravity = gravity.text_numbers(notices)?;
    }
    let version = root.number("version", notices).unwrap_or(AXES_OF_JOINTS);
    let (frames, links, joints) = (Frames::default(), BTreeMap::new(), BTreeMap::new());
    let mut reader = Reader { version, frames, links, joints, axes: Vec::new(), spatial, notices };
    // The names of a single model need no name in front, unless the world speaks of them.
    let is_alone = models.len() == 1 && world.is_none_or(|world| world.child("joint").is_none());
    let scope = |model: &Element| {
        if is_alone { String::new() } else { format!("{}::", model.get("name").unwrap_or("model")) }
    };
    if let Some(world) = world {
        reader.frames.world(world);
    }
    for model in &models {
        reader.frames.model(model, WORLD, &scope(model));
    }
    for model in &models {
        reader.links(model, &scope(model), false);
    }
    for model in &models {
        reader.joints(model, &scope(model));
    }
    for joint in world.into_iter().flat_map(|world| world.all("joint")) {
        reader.joint(joint, "");
    }
    reader.follow();
    reader.points();
    for element in outer.children.iter().filter(|child| !WITHOUT_NOTICE.contains(&child.name.as_str())) {
        reader.tell(element, "the world");
    }
    (!reader.notices.has_errors()).then_some(reader.spatial)
}

/// Elements of a world that are read elsewhere, or say nothing of its motion.
const WITHOUT_NOTICE: &[&str] = &[
    "model",
    "gravity",
    "joint",
    "frame",
    "light",
    "scene",
    "physics",
    "gui",
    "magnetic_field",
    "atmosphere",
    "wind",
    "spherical_coordinates",
    "world",
];

/// Elements of a model that are read elsewhere, or say nothing of its motion.
const OF_A_MODEL: &[&str] = &[
    "link",
    "joint",
    "model",
    "frame",
    "pose",
    "static",
    "self_collide",
    "allow_auto_disable",
    "enable_wind",
];

impl<'a> Reader<'a> {
    fn tell(&mut self, element: &Element, of: &str) {
        match element.name.as_str() {
            "include" => self.notices.error(&element.place, "<include>: models of other files are not taken"),
            _ => self.notices.warn(&element.place, format!("{} of {of} is not taken", element.shown())),
        }
    }

    /// An element of a model that is no link, joint or frame.
    fn other(&mut self, element: &Element, scope: &str) {
        if element.name == "include" {
            return self.tell(element, "a model");
        }
        let (frames, links, joints) = (&self.frames, &self.links, &self.joints);
        let frame_of = |asking: &Element, name: &str, notices: &mut Notices| {
            let link = frames.link(scope, name, asking, notices)?.and_then(|link| links.get(&link).copied());
            Ok((link, frames.pose(scope, name, asking, notices).ok_or(Told)?))
        };
        if drake::tie(element, &frame_of, &mut self.spatial, self.notices) {
            return;
        }
        let is_link = |name: &str| {
            name == "world"
                || frames.get(scope, name).is_some_and(|own| matches!(own.kind, Named::Link | Named::Frame))
        };
        let is_joint = |name: &str| joints.contains_key(&format!("{scope}{name}"));
        drake::left_out(element, &is_link, &is_joint, self.notices);
    }

    fn links(&mut self, model: &Element, scope: &str, is_static: bool) {
        let is_static =
            is_static || model.child("static").is_some_and(|text| matches!(text.text.as_str(), "true" | "1"));
        if model.get("placement_frame").is_some() {
            self.notices.error(&model.place, format!("{}: placement_frame is not taken", model.shown()));
        }
        for element in &model.children {
            match element.name.as_str() {
                "link" => self.link(element, scope, is_static),
                "model" => {
                    let inner = format!("{scope}{}::", element.get("name").unwrap_or("model"));
                    self.links(element, &inner, is_static);
                }
                // Joints, and what ties links to each other, are read when all links are known.
                _ => {}
            }
        }
    }

    fn link(&mut self, element: &Element, scope: &str, is_static: bool) {
        let own = element.get("name").unwrap_or_default();
        let full = format!("{scope}{own}");
        let Some(pose) = self.frames.pose(scope, own, element, self.notices) else { return };
        let shapes = link::shapes(element, self.notices);
        let inertial = link::inertial(element, is_static || self.is_held(&full), self.notices);
        let number = self.spatial.links.len();
        let (name, place) = (full.replace("::", "_"), element.place.clone());
        if is_static {
            let held = Joint::fixed(&format!("{name}_held"), &place, [None, Some(number)], pose.at);
            self.spatial.joints.push(held);
        }
        self.links.insert(full, number);
        let touches = element.child("collision").is_some();
        self.spatial.links.push(Link { name, place, pose, inertial, shapes, points: Vec::new(), touches });
    }

    /// Is a link welded to the world, so that its mass does not matter?
    fn is_held(&self, link: &str) -> bool {
        self.frames.all().any(|(_, declared)| {
            let text = |name: &str| declared.element.child(name).map_or("", |child| child.text.as_str());
            declared.kind == Named::Joint
                && declared.element.get("type") == Some("fixed")
                && text("parent") == "world"
                && format!("{}{}", declared.scope, text("child")) == link
        })
    }

    fn joints(&mut self, model: &'a Element, scope: &str) {
        for element in &model.children {
            match element.name.as_str() {
                "joint" => self.joint(element, scope),
                "model" => {
                    self.joints(element, &format!("{scope}{}::", element.get("name").unwrap_or("model")));
                }
                _ => {}
            }
        }
        let is_other = |element: &&Element| !OF_A_MODEL.contains(&element.name.as_str());
        for element in model.children.iter().filter(is_other) {
            self.other(element, scope);
        }
    }

    fn joint(&mut self, element: &'a Element, scope: &str) {
        let kind = match element.get("type").unwrap_or_default() {
            "revolute" | "continuous" => Kind::Revolute,
            "prismatic" => Kind::Prismatic,
            "fixed" => Kind::Fixed,
            other => {
                self.notices.error(
                    &element.place,
                    format!("{}: a joint of type `{other}` is not planar", element.shown()),
                );
                return;
            }
        };
        let own = element.get("name").unwrap_or("joint");
        let mut end = |tag: &str| {
            let name = element.child(tag).map_or("", |child| child.text.as_str());
            let link = self.frames.link(scope, name, element, self.notices)?;
            Ok::<_, Told>(link.and_then(|link| self.links.get(&link).copied()))
        };
        let (Ok(parent), Ok(child)) = (end("parent"), end("child")) else { return };
        let Some(pose) = self.frames.pose(scope, own, element, self.notices) else { return };
        let mut joint = Joint::new(
            &format!("{scope}{own}").replace("::", "_"),
            &element.place,
            kind,
            [parent, child],
            pose.at,
            [0.0, 0.0, 1.0],
        );
        self.far_from_parent(element, scope, &joint);
        if kind != Kind::Fixed && !self.axis(element, scope, &pose, &mut joint) {
            return;
        }
        for child in &element.children {
            if !matches!(child.name.as_str(), "parent" | "child" | "pose" | "axis" | "drake:mimic") {
                self.tell(child, &element.shown());
            }
        }
        let number = self.spatial.joints.len();
        self.joints.insert(format!("{scope}{own}"), number);
        self.spatial.joints.push(joint);
        let Some(axis) = element.child("axis") else { return };
        let effort = axis.child("limit").and_then(|limit| limit.child_number("effort", self.notices));
        if let Some(effort) = effort.filter(|effort| *effort > 0.0) {
            let name = self.spatial.joints[number].name.clone();
            self.spatial.drives.push(drive(&name, element, number, 1.0, Some(effort)));
        }
        self.spatial.joints[number].armature += drake::rotor(axis, self.notices);
        self.axes.push((axis, number, scope.to_owned()));
        self.axes.push((element, number, scope.to_owned()));
    }

    /// Joints that follow others, which may be declared after them.
    fn follow(&mut self) {
        for (axis, number, scope) in std::mem::take(&mut self.axes) {
            let number_of = |name: &str| self.joints.get(&format!("{scope}{name}")).copied();
            crate::mimic::read(axis, number, number_of, &mut self.spatial, self.notices);
        }
    }

    /// Reads axis, spring, damper and limits; returns true if there is an axis.
    fn axis(&mut self, element: &Element, scope: &str, pose: &crate::space::Pose, joint: &mut Joint) -> bool {
        let Some(axis) = element.child("axis") else {
            self.notices.error(&element.place, format!("{} has no <axis>", element.shown()));
            return false;
        };
        let xyz = axis.child("xyz");
        let direction = xyz.and_then(|xyz| xyz.text_numbers(self.notices)).unwrap_or([0.0, 0.0, 1.0]);
        let of_model = axis
            .child("use_parent_model_frame")
            .is_some_and(|text| matches!(text.text.as_str(), "true" | "1"));
        let frame = match xyz.and_then(|xyz| xyz.get("expressed_in")).filter(|name| !name.is_empty()) {
            Some(name) => self.frames.pose(scope, name, axis, self.notices),
            None if of_model || self.version < AXES_OF_JOINTS => {
                self.frames.pose(scope, "__model__", axis, self.notices)
            }
            None => Some(*pose),
        };
        let Some(direction) = frame.and_then(|frame| unit(turned(&frame.turn, direction))) else {
            self.notices.error(&axis.place, format!("{}: its axis has no direction", element.shown()));
            return false;
        };
        joint.axis = direction;
        if let Some(dynamics) = axis.child("dynamics") {
            let mut number = |name| dynamics.child_number(name, self.notices).unwrap_or_default();
            joint.damping = number("damping");
            joint.friction = number("friction");
            joint.rest = number("spring_reference");
            joint.stiffness = number("spring_stiffness");
        }
        if let Some(start) = axis.child_number("initial_position", self.notices) {
            joint.start = start;
        }
        if let Some(limit) = axis.child("limit").filter(|_| element.get("type") != Some("continuous")) {
            let mut number = |name| limit.child_number(name, self.notices);
            joint.lower = number("lower").filter(|lower| *lower > -UNBOUNDED);
            joint.upper = number("upper").filter(|upper| *upper < UNBOUNDED);
            joint.soft =
                number("stiffness").map(|stiffness| [stiffness, number("dissipation").unwrap_or(1.0)]);
        }
        true
    }

    /// Reports a parent that is a frame away from the joint: SDF places a joint at its child.
    fn far_from_parent(&mut self, element: &Element, scope: &str, joint: &Joint) {
        let name = element.child("parent").map_or("", |parent| parent.text.as_str());
        let is_frame =
            self.frames.get(scope, name).is_some_and(|declared: &Declared<'_>| declared.kind == Named::Frame);
        let Some(frame) = self.frames.pose(scope, name, element, self.notices).filter(|_| is_frame) else {
            return;
        };
        let away = crate::space::norm(crate::space::sub(frame.at, joint.at));
        if away > 1e-9 {
            let away = crate::number::short(away);
            self.notices.warn(
                &element.place,
                format!(
                    "{}: the frame `{name}` is {away} m away from the joint, which SDF places at its child",
                    element.shown()
                ),
            );
        }
    }

    /// Frames that are attached to links, as points of these.
    fn points(&mut self) {
        let frames: Vec<(String, Declared<'_>)> =
            self.frames.all().map(|(name, declared)| (name.clone(), declared.clone())).collect();
        for (full, declared) in frames.iter().filter(|(_, declared)| declared.kind == Named::Frame) {
            let name = declared.element.get("name").unwrap_or_default();
            let link = self.frames.link(&declared.scope, name, declared.element, self.notices);
            let Some(&link) = link.ok().flatten().and_then(|link| self.links.get(&link)) else { continue };
            let Some(pose) = self.frames.pose(&declared.scope, name, declared.element, self.notices) else {
                continue;
            };
            let link = &mut self.spatial.links[link];
            link.points.push((full.replace("::", "_"), link.pose.inverse().of(&pose)));
        }
    }
}
