//! URDF: the format of ROS (wiki.ros.org/urdf/XML), with what Drake adds.

use std::collections::BTreeMap;

use crate::drake::{self, Frame};
use crate::notice::{Notices, Told};
use crate::space::{IDENTITY, Pose, Vector, roll_pitch_yaw, turned, unit};
use crate::spatial::{Drive, Inertial, Joint, Kind, Link, Quantity, Shape, Solid, Spatial};
use crate::xml::Element;

/// URDF says nothing of gravity; its simulators take this.
const GRAVITY: Vector = [0.0, 0.0, -9.81];
/// An effort that bounds nothing.
const UNBOUNDED: f64 = 1e9;

/// The mechanism of a `<robot>`.
pub(crate) fn read(robot: &Element, notices: &mut Notices) -> Option<Spatial> {
    let mut spatial = Spatial::new(robot.get("name").unwrap_or("robot"), &robot.place, GRAVITY);
    spatial.links.extend(robot.all("link").map(|link| self::link(link, notices)));
    let numbers: BTreeMap<String, usize> =
        spatial.links.iter().enumerate().map(|(k, link)| (link.name.clone(), k)).collect();
    let joints: Vec<Drawn<'_>> =
        robot.all("joint").filter_map(|joint| drawn(joint, &numbers, notices)).collect();
    place_links(robot, &mut spatial, &joints, notices)?;
    let held = spatial.joints.len();
    for drawn in &joints {
        let joint = joint(drawn, &spatial, notices);
        spatial.joints.extend(joint);
    }
    if spatial.joints.len() < held + joints.len() {
        return None;
    }
    let names: BTreeMap<String, usize> =
        spatial.joints.iter().enumerate().map(|(k, joint)| (joint.name.clone(), k)).collect();
    for (k, drawn) in joints.iter().enumerate() {
        super::mimic::read(drawn.element, held + k, |name| names.get(name).copied(), &mut spatial, notices);
    }
    drives(robot, &names, &joints, &mut spatial, notices);
    for frame in robot.all("frame") {
        self::frame(frame, &numbers, &mut spatial, notices);
    }
    for element in &robot.children {
        other(element, &names, &mut spatial, notices);
    }
    Some(spatial)
}

/// An element that is no link, joint or frame.
fn other(element: &Element, joints: &BTreeMap<String, usize>, spatial: &mut Spatial, notices: &mut Notices) {
    let frames = frames(spatial);
    let frame_of = |asking: &Element, name: &str, notices: &mut Notices| {
        frames.get(name).copied().ok_or_else(|| {
            notices.error(&asking.place, format!("{}: there is no link or frame `{name}`", asking.shown()));
            Told
        })
    };
    match element.name.as_str() {
        "link" | "joint" | "transmission" | "material" | "frame" => {}
        "gazebo" => gazebo(element, notices),
        name if name.starts_with("xacro:") => {
            let why = "the file is a template, which `xacro` expands first";
            notices.error(&element.place, format!("{}: {why}", element.shown()));
        }
        _ if drake::tie(element, &frame_of, spatial, notices) => {}
        _ => {
            let is_link = |name: &str| frames.contains_key(name);
            drake::left_out(element, &is_link, &|name| joints.contains_key(name), notices);
        }
    }
}

/// Links and frames by their names, each with its pose in the world.
fn frames(spatial: &Spatial) -> BTreeMap<String, Frame> {
    let mut frames = BTreeMap::from([("world".to_owned(), (None, Pose::HERE))]);
    for (k, link) in spatial.links.iter().enumerate() {
        let points = link.points.iter().map(|(name, pose)| (name.clone(), (Some(k), link.pose.of(pose))));
        frames.extend(points);
        frames.insert(link.name.clone(), (Some(k), link.pose));
    }
    frames
}

/// Reports an element of Gazebo: an error if it constrains or moves something; its joints close loops.
fn gazebo(element: &Element, notices: &mut Notices) {
    let acts = |child: &&Element| {
        let is_on = matches!(child.text.as_str(), "true" | "1");
        match child.name.as_str() {
            "joint" | "link" | "model" | "include" => true,
            "turnGravityOff" | "kinematic" | "static" => is_on,
            "gravity" => !is_on,
            "springStiffness" => child.text.parse() != Ok(0.0),
            "plugin" => child.attributes.iter().any(|attribute| attribute.value.contains("mimic")),
            _ => false,
        }
    };
    match element.children.iter().find(acts) {
        Some(child) => notices.error(&child.place, format!("{} of <gazebo> is not taken", child.shown())),
        None => notices.warn(&element.place, format!("{} is not taken", element.shown())),
    }
}

fn link(element: &Element, notices: &mut Notices) -> Link {
    let mut shapes = Vec::new();
    for child in &element.children {
        match child.name.as_str() {
            "inertial" => {}
            "visual" => shapes.extend(shape(child, notices)),
            "collision" => notices.warn(
                &child.place,
                format!(
                    "collision of link `{}`: contacts are left out",
                    element.get("name").unwrap_or_default()
                ),
            ),
            _ => notices.warn(&child.place, format!("{} is not taken", child.shown())),
        }
    }
    Link {
        name: element.get("name").unwrap_or("link").to_owned(),
        place: element.place.clone(),
        pose: Pose::HERE,
        inertial: element.child("inertial").and_then(|inertial| self::inertial(inertial, notices)),
        shapes,
        points: Vec::new(),
        touches: element.child("collision").is_some(),
    }
}

/// Mass and inertia; none of a mass of zero.
fn inertial(element: &Element, notices: &mut Notices) -> Option<Inertial> {
    let pose = origin(element, notices);
    let mass = element.child("mass")?.number("value", notices)?;
    let inertia = element.child("inertia");
    let entries = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"]
        .map(|name| inertia.and_then(|inertia| inertia.number(name, notices)).unwrap_or_default());
    Inertial::new(mass, &pose, entries)
}

fn shape(visual: &Element, notices: &mut Notices) -> Option<Shape> {
    let pose = origin(visual, notices);
    let solid = visual.child("geometry")?.children.first()?;
    let solid = match solid.name.as_str() {
        "box" => Solid::Box(solid.exactly::<3>("size", notices)?.map(|size| size / 2.0)),
        "cylinder" => Solid::Cylinder {
            radius: solid.number("radius", notices)?,
            half: solid.number("length", notices)? / 2.0,
        },
        "capsule" => Solid::Capsule {
            radius: solid.number("radius", notices)?,
            half: solid.number("length", notices)? / 2.0,
        },
        "sphere" => Solid::Ellipsoid([solid.number("radius", notices)?; 3]),
        _ => {
            notices.warn(&solid.place, format!("{} is not drawn", solid.shown()));
            return None;
        }
    };
    Some(Shape { solid, pose })
}

fn origin(element: &Element, notices: &mut Notices) -> Pose {
    element.child("origin").map_or(Pose::HERE, |origin| placed(origin, notices))
}

/// The pose of `xyz` and `rpy`.
fn placed(element: &Element, notices: &mut Notices) -> Pose {
    let at = element.exactly("xyz", notices).unwrap_or_default();
    let turn = element.exactly("rpy", notices).map_or(IDENTITY, roll_pitch_yaw);
    Pose { turn, at }
}

/// A joint before its links have places.
struct Drawn<'a> {
    element: &'a Element,
    parent: Option<usize>,
    child: usize,
    origin: Pose,
}

fn drawn<'a>(
    element: &'a Element,
    links: &BTreeMap<String, usize>,
    notices: &mut Notices,
) -> Option<Drawn<'a>> {
    let mut end = |tag: &str| {
        let Some(end) = element.child(tag) else {
            notices.error(&element.place, format!("{} has no <{tag}>", element.shown()));
            return None;
        };
        let name = end.get("link").unwrap_or_default();
        let found = links.get(name).copied();
        if found.is_none() && name != "world" {
            notices.error(&end.place, format!("there is no link `{name}`"));
            return None;
        }
        Some(found)
    };
    let (parent, child) = (end("parent")?, end("child")?);
    let Some(child) = child else {
        notices.error(&element.place, format!("{} has the world as its child", element.shown()));
        return None;
    };
    Some(Drawn { element, parent, child, origin: origin(element, notices) })
}

/// Poses of all links, from the root outwards. The root that is not named `world` is joined to it.
fn place_links(
    robot: &Element,
    spatial: &mut Spatial,
    joints: &[Drawn<'_>],
    notices: &mut Notices,
) -> Option<()> {
    let mut placed = vec![false; spatial.links.len()];
    for k in 0..spatial.links.len() {
        if joints.iter().any(|joint| joint.child == k) {
            continue;
        }
        let link = &spatial.links[k];
        if link.name != "world" {
            notices.warn(
                &link.place,
                format!("link `{}` is joined to nothing that holds it: it is taken as fixed", link.name),
            );
        }
        let (name, place) = (format!("{}_held", link.name), link.place.clone());
        spatial.joints.push(Joint::fixed(&name, &place, [None, Some(k)], [0.0; 3]));
        placed[k] = true;
    }
    // A joint more is passed in each round, or there is a circle.
    for _ in 0..=joints.len() {
        for joint in joints {
            let parent = match joint.parent {
                None => Pose::HERE,
                Some(parent) if placed[parent] => spatial.links[parent].pose,
                Some(_) => continue,
            };
            if !placed[joint.child] {
                spatial.links[joint.child].pose = parent.of(&joint.origin);
                placed[joint.child] = true;
            }
        }
    }
    if let Some(k) = placed.iter().position(|placed| !placed) {
        notices.error(
            &spatial.links[k].place,
            format!("link `{}` hangs in a circle of joints", spatial.links[k].name),
        );
        return None;
    }
    if spatial.links.is_empty() {
        notices.error(&robot.place, "there is no link in it");
        return None;
    }
    Some(())
}

fn joint(drawn: &Drawn<'_>, spatial: &Spatial, notices: &mut Notices) -> Option<Joint> {
    let element = drawn.element;
    let kind = match element.get("type").unwrap_or_default() {
        "revolute" | "continuous" => Kind::Revolute,
        "prismatic" => Kind::Prismatic,
        "fixed" => Kind::Fixed,
        "floating" | "planar" => Kind::Free,
        other => {
            notices.error(
                &element.place,
                format!("{}: a joint of type `{other}` is not planar", element.shown()),
            );
            return None;
        }
    };
    let pose = spatial.links[drawn.child].pose;
    let axis = element.child("axis").and_then(|axis| axis.exactly("xyz", notices)).unwrap_or([1.0, 0.0, 0.0]);
    let Some(axis) = unit(turned(&pose.turn, axis)) else {
        notices.error(&element.place, format!("{}: its axis has no direction", element.shown()));
        return None;
    };
    let name = element.get("name").unwrap_or("joint");
    let mut joint = Joint::new(name, &element.place, kind, [drawn.parent, Some(drawn.child)], pose.at, axis);
    if kind == Kind::Free && element.get("type") == Some("floating") {
        notices.warn(
            &element.place,
            format!("{}: its link moves freely in the plane, and not out of it", element.shown()),
        );
    }
    for child in &element.children {
        match child.name.as_str() {
            "parent" | "child" | "origin" | "axis" | "mimic" => {}
            "dynamics" => {
                joint.damping = child.number("damping", notices).unwrap_or_default();
                joint.friction = child.number("friction", notices).unwrap_or_default();
            }
            "limit" => limit(child, element, &mut joint, notices),
            _ => notices.warn(&child.place, format!("{} of {} is not taken", child.shown(), element.shown())),
        }
    }
    Some(joint)
}

fn limit(limit: &Element, element: &Element, joint: &mut Joint, notices: &mut Notices) {
    if element.get("type") == Some("continuous") || !matches!(joint.kind, Kind::Revolute | Kind::Prismatic) {
        return;
    }
    let finite = |value: Option<f64>| value.filter(|value| value.abs() < UNBOUNDED);
    joint.lower = finite(limit.number("lower", notices));
    joint.upper = finite(limit.number("upper", notices));
    if limit.get("lower").is_none() && limit.get("upper").is_none() {
        notices.warn(
            &limit.place,
            format!("{} has a <limit> without lower and upper: it is taken without limits", element.shown()),
        );
    }
}

/// Inputs of the joints that have a transmission; where there is none, of those that have an effort.
fn drives(
    robot: &Element,
    joints: &BTreeMap<String, usize>,
    drawn: &[Drawn<'_>],
    spatial: &mut Spatial,
    notices: &mut Notices,
) {
    let offset = spatial.joints.len() - drawn.len();
    for transmission in robot.all("transmission") {
        let name = transmission.child("joint").and_then(|joint| joint.get("name")).unwrap_or_default();
        let Some(&joint) = joints.get(name) else {
            notices
                .warn(&transmission.place, format!("{}: there is no joint `{name}`", transmission.shown()));
            continue;
        };
        let actuator = transmission.child("actuator");
        let within =
            |tag| actuator.and_then(|actuator| actuator.child(tag)).or_else(|| transmission.child(tag));
        let gear = within("mechanicalReduction").and_then(|reduction| reduction.text_numbers::<1>(notices));
        let name = actuator.and_then(|actuator| actuator.get("name")).unwrap_or(name);
        spatial.joints[joint].armature += actuator.map_or(0.0, |actuator| drake::rotor(actuator, notices));
        let effort = effort(drawn[joint - offset].element, notices);
        spatial.drives.push(drive(name, transmission, joint, gear.map_or(1.0, |[gear]| gear), effort));
    }
    if robot.child("transmission").is_some() {
        return;
    }
    for (k, drawn) in drawn.iter().enumerate() {
        if let Some(effort) = effort(drawn.element, notices) {
            let name = drawn.element.get("name").unwrap_or("joint");
            spatial.drives.push(drive(name, drawn.element, offset + k, 1.0, Some(effort)));
        }
    }
}

/// The greatest effort of a joint, where there is one.
fn effort(joint: &Element, notices: &mut Notices) -> Option<f64> {
    joint.child("limit")?.number("effort", notices).filter(|effort| *effort > 0.0)
}

/// A drive by a force or torque, of which the joint feels `gear` times as much, but not more than the effort.
pub(crate) fn drive(name: &str, element: &Element, joint: usize, gear: f64, effort: Option<f64>) -> Drive {
    let effort = effort.filter(|effort| *effort < UNBOUNDED);
    Drive {
        name: name.to_owned(),
        place: element.place.clone(),
        joint,
        gear: 1.0,
        gain: gear,
        bias: [0.0; 3],
        input: Quantity::Force,
        input_range: None,
        force_range: effort.map(|effort| [-effort, effort]),
    }
}

/// A frame that Drake adds: a port.
fn frame(element: &Element, links: &BTreeMap<String, usize>, spatial: &mut Spatial, notices: &mut Notices) {
    let (Some(name), Some(&link)) =
        (element.get("name"), element.get("link").and_then(|link| links.get(link)))
    else {
        notices.warn(&element.place, format!("{}: its link is not known", element.shown()));
        return;
    };
    let pose = placed(element, notices);
    spatial.links[link].points.push((name.to_owned(), pose));
}
