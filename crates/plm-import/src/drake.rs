//! Elements by which Drake adds to URDF and SDF (drake.mit.edu, A Guide to MultibodyPlant parsing): what closes loops, springs, rotors.

use crate::notice::{Notices, Told};
use crate::space::{IDENTITY, Pose};
use crate::spatial::{Joint, Kind, Spatial, Tie, TieLaw};
use crate::xml::Element;

/// A frame: its link (none is the world) and its pose in the world.
pub(crate) type Frame = (Option<usize>, Pose);

/// Gives the frame of a name; reports a name that has none.
pub(crate) type FrameOf<'a> = &'a dyn Fn(&Element, &str, &mut Notices) -> Result<Frame, Told>;

/// Reads an element of a model that ties two frames; false for all others. Mistakes in it are reported.
pub(crate) fn tie(
    element: &Element,
    frame_of: FrameOf<'_>,
    spatial: &mut Spatial,
    notices: &mut Notices,
) -> bool {
    let count = spatial.joints.len() + spatial.ties.len() + 1;
    match element.name.as_str() {
        "drake:ball_constraint" => {
            if let Ok(joint) = ball(element, count, frame_of, notices) {
                spatial.joints.push(joint);
            }
        }
        "drake:linear_bushing_rpy" => spatial.ties.extend(bushing(element, count, frame_of, notices).ok()),
        "drake:linear_spring_damper" => spatial.ties.extend(spring(element, count, frame_of, notices).ok()),
        _ => return false,
    }
    true
}

/// A child whose tag begins like that of its parent; a missing one is reported.
fn part<'a>(
    element: &'a Element,
    prefix: &str,
    tag: &str,
    notices: &mut Notices,
) -> Result<&'a Element, Told> {
    let name = format!("{prefix}_{tag}");
    element.child(&name).ok_or_else(|| {
        notices.error(&element.place, format!("{} has no <{name}>", element.shown()));
        Told
    })
}

/// The frame that a child names, in an attribute (URDF) or as its text (SDF).
fn frame(
    element: &Element,
    prefix: &str,
    tag: &str,
    frame_of: FrameOf<'_>,
    notices: &mut Notices,
) -> Result<Frame, Told> {
    let part = part(element, prefix, tag, notices)?;
    frame_of(element, part.get("name").unwrap_or(&part.text), notices)
}

/// Numbers of a child, in an attribute (URDF) or as its text (SDF).
fn numbers<const N: usize>(
    element: &Element,
    prefix: &str,
    tag: &str,
    notices: &mut Notices,
) -> Result<[f64; N], Told> {
    let part = part(element, prefix, tag, notices)?;
    let found =
        if part.get("value").is_some() { part.exactly("value", notices) } else { part.text_numbers(notices) };
    found.ok_or(Told)
}

fn name(element: &Element, kind: &str, count: usize) -> String {
    element.get("name").map_or_else(|| format!("{kind}_{count}"), str::to_owned)
}

/// A point of one body coincides with a point of another one.
fn ball(
    element: &Element,
    count: usize,
    frame_of: FrameOf<'_>,
    notices: &mut Notices,
) -> Result<Joint, Told> {
    let of = "drake:ball_constraint";
    let (parent, pose_a) = frame(element, of, "body_A", frame_of, notices)?;
    let (child, pose_b) = frame(element, of, "body_B", frame_of, notices)?;
    let at = pose_a.point(numbers(element, of, "p_AP", notices)?);
    let at_child = pose_b.point(numbers(element, of, "p_BQ", notices)?);
    let pair = [parent, child];
    let joint =
        Joint::new(&name(element, "ball", count), &element.place, Kind::Point, pair, at, [0.0, 0.0, 1.0]);
    Ok(Joint { at_child, ..joint })
}

fn bushing(
    element: &Element,
    count: usize,
    frame_of: FrameOf<'_>,
    notices: &mut Notices,
) -> Result<Tie, Told> {
    let of = "drake:bushing";
    let mut end = |tag| frame(element, of, tag, frame_of, notices);
    let ends = [end("frameA")?, end("frameC")?];
    let mut values = |tag| numbers(element, of, tag, notices);
    let law = TieLaw::Bushing {
        stiffness: values("force_stiffness")?,
        damping: values("force_damping")?,
        turning_stiffness: values("torque_stiffness")?,
        turning_damping: values("torque_damping")?,
    };
    Ok(Tie { name: name(element, "bushing", count), place: element.place.clone(), ends, law })
}

fn spring(
    element: &Element,
    count: usize,
    frame_of: FrameOf<'_>,
    notices: &mut Notices,
) -> Result<Tie, Told> {
    let of = "drake:linear_spring_damper";
    let mut end = |body, point| {
        let (link, pose) = frame(element, of, body, frame_of, notices)?;
        let at = numbers(element, of, point, notices)?;
        Ok::<_, Told>((link, pose.of(&Pose { turn: IDENTITY, at })))
    };
    let ends = [end("body_A", "p_AP")?, end("body_B", "p_BQ")?];
    let mut value = |tag| numbers::<1>(element, of, tag, notices).map(|[value]| value);
    let law = TieLaw::Spring {
        free_length: value("free_length")?,
        stiffness: value("stiffness")?,
        damping: value("damping")?,
    };
    Ok(Tie { name: name(element, "spring", count), place: element.place.clone(), ends, law })
}

/// The inertia that the rotor of a motor adds to its joint, by the square of its gear: `drake:rotor_inertia`, `drake:gear_ratio`.
pub(crate) fn rotor(element: &Element, notices: &mut Notices) -> f64 {
    let mut value = |tag: &str| {
        let part = element.child(tag)?;
        if part.get("value").is_some() {
            part.number("value", notices)
        } else {
            part.text_numbers::<1>(notices).map(|[value]| value)
        }
    };
    let (inertia, gear) = (value("drake:rotor_inertia"), value("drake:gear_ratio"));
    inertia.unwrap_or_default() * gear.unwrap_or(1.0).powi(2)
}

/// Reports an element that is not taken. One that names two links, or a joint, may constrain them: the motion would be another one without
/// it. `is_link` and `is_joint` know the names of the file.
pub(crate) fn left_out(
    element: &Element,
    is_link: &dyn Fn(&str) -> bool,
    is_joint: &dyn Fn(&str) -> bool,
    notices: &mut Notices,
) {
    let mut words = Vec::new();
    gather(element, &mut words);
    words.sort_unstable();
    words.dedup();
    let links = words.iter().filter(|word| is_link(word)).count();
    let joints = words.iter().filter(|word| is_joint(word)).count();
    let joins = links > 1 || joints > 0;
    if joins && !JOINS_NOTHING.contains(&element.name.as_str()) {
        let what = if links > 1 { "links" } else { "a joint" };
        notices.error(&element.place, format!("{} speaks of {what}, and is not taken", element.shown()));
    } else {
        notices.warn(&element.place, format!("{} is not taken", element.shown()));
    }
}

/// Elements that name links or joints, and hold nothing.
const JOINS_NOTHING: &[&str] = &[
    "plugin",
    "sensor",
    "gripper",
    "actor",
    "drake:collision_filter_group",
    "drake:member_group",
    "disable_collisions",
    "self_collision_checking",
    "group",
    "end_effector",
    "ros2_control",
];

/// All attributes and texts of an element and of those within it, but its own name.
fn gather<'a>(element: &'a Element, words: &mut Vec<&'a str>) {
    for attribute in element.attributes.iter().filter(|attribute| attribute.name != "name") {
        words.push(&attribute.value);
    }
    words.push(&element.text);
    for child in &element.children {
        words.extend(child.get("name"));
        gather(child, words);
    }
}
