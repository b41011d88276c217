//! Links of SDF: mass, inertia and shapes.

use super::frames::pose_of;
use crate::notice::Notices;
use crate::space::Pose;
use crate::spatial::{Inertial, Shape, Solid};
use crate::xml::Element;

/// Elements of a link that are read elsewhere, or say nothing of its motion.
const WITHOUT_NOTICE: &[&str] =
    &["pose", "inertial", "self_collide", "must_be_base_link", "enable_wind", "light", "material"];

/// Shapes of a link; reports elements that are not taken.
pub(super) fn shapes(link: &Element, notices: &mut Notices) -> Vec<Shape> {
    let mut shapes = Vec::new();
    for child in &link.children {
        match child.name.as_str() {
            name if WITHOUT_NOTICE.contains(&name) => {}
            "visual" => shapes.extend(shape(child, notices)),
            "collision" => {
                let name = link.get("name").unwrap_or_default();
                notices.warn(&child.place, format!("collision of link `{name}`: contacts are left out"));
            }
            "gravity" if matches!(child.text.as_str(), "true" | "1") => {}
            "kinematic" if matches!(child.text.as_str(), "false" | "0") => {}
            "gravity" | "kinematic" | "velocity_decay" => {
                notices.error(&child.place, format!("<{}> of {} is not taken", child.name, link.shown()));
            }
            _ => notices.warn(&child.place, format!("{} of {} is not taken", child.shown(), link.shown())),
        }
    }
    shapes
}

/// Mass and inertia. SDF gives 1 kg and 1 kg m² to a link that does not say them.
pub(super) fn inertial(link: &Element, is_held: bool, notices: &mut Notices) -> Option<Inertial> {
    let Some(inertial) = link.child("inertial") else {
        if !is_held {
            notices.warn(
                &link.place,
                format!("{} has no <inertial>: 1 kg and 1 kg*m^2 as SDF says", link.shown()),
            );
        }
        return Inertial::new(1.0, &Pose::HERE, [1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    };
    if inertial.get("auto") == Some("true") {
        notices.error(&inertial.place, format!("{}: inertia by density is not taken", link.shown()));
    }
    let pose = pose_of(inertial, notices);
    let mass = inertial.child_number("mass", notices).unwrap_or(1.0);
    let inertia = inertial.child("inertia");
    let mut entry = |name: &str, otherwise: f64| {
        inertia.and_then(|inertia| inertia.child_number(name, notices)).unwrap_or(otherwise)
    };
    let [xx, yy, zz] = ["ixx", "iyy", "izz"].map(|name| entry(name, 1.0));
    let [xy, xz, yz] = ["ixy", "ixz", "iyz"].map(|name| entry(name, 0.0));
    Inertial::new(mass, &pose, [xx, yy, zz, xy, xz, yz])
}

fn shape(visual: &Element, notices: &mut Notices) -> Option<Shape> {
    let pose = pose_of(visual, notices);
    let solid = visual.child("geometry")?.children.first()?;
    let mut length = |name: &str| solid.child_number(name, notices);
    let solid = match solid.name.as_str() {
        "box" => Solid::Box(solid.child("size")?.text_numbers(notices)?.map(|size: f64| size / 2.0)),
        "cylinder" => Solid::Cylinder { radius: length("radius")?, half: length("length")? / 2.0 },
        "capsule" => Solid::Capsule { radius: length("radius")?, half: length("length")? / 2.0 },
        "sphere" => Solid::Ellipsoid([length("radius")?; 3]),
        "ellipsoid" => Solid::Ellipsoid(solid.child("radii")?.text_numbers(notices)?),
        _ => {
            notices.warn(&solid.place, format!("{} is not drawn", solid.shown()));
            return None;
        }
    };
    Some(Shape { solid, pose })
}
