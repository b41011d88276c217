//! Declarations of plm from files of others, and back.
//!
//! URDF, SDF and MJCF describe mechanisms in space. Where all hinges of one are parallel and all slides stand across them, its motion is
//! planar, and [`mechanism`] writes the declaration that has the same motion. Each element of the file that could not be taken is a
//! [`Notice`] with its place: a warning where it is left out, an error where the motion would be another one without it.
//! [`to_mjcf`] and [`to_urdf`] write a compiled mechanism as a file for other programs, [`to_links`] draws its links in true size.
//! [`outline`] converts a DXF drawing to the contour of a body.

mod drake;
mod dxf;
mod export;
mod mimic;
mod mjcf;
mod names;
mod notice;
mod number;
mod outline;
mod planar;
mod plane;
mod sdf;
mod space;
mod spatial;
mod urdf;
mod write;
mod xml;

use std::rc::Rc;

pub use self::dxf::{Selection, drawing_text, outline};
pub use self::export::{Cutting, Drawing, Exported, Links, PlaceOf, to_links, to_mjcf, to_urdf};
pub use self::notice::{Level, Notice, Place};

use self::names::Names;
use self::notice::Notices;
use self::planar::Planar;
use self::spatial::{Joint, Spatial};

/// Parts of a file that are left out, and links that are fixed, on request.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// Joints get no limits.
    pub without_limits: bool,
    /// Joints get no dry friction.
    pub without_friction: bool,
    /// Links that are joined to the world where the file draws them, by their names in the file.
    pub fixed: Vec<String>,
}

/// Result of an import.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Imported {
    /// The text; none where a notice is an error.
    pub text: Option<String>,
    /// Elements that could not be taken, in the order in which they are found.
    pub notices: Vec<Notice>,
}

/// The declaration of the mechanism of a URDF, SDF or MJCF text, by its first element.
///
/// `name` is the name of the file in notices and in the declaration; `read` gives the text of a file that MJCF includes.
pub fn mechanism(
    name: &str,
    text: &str,
    options: &Options,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Imported {
    let mut notices = Notices::default();
    let text = declared(name, text, options, read, &mut notices).filter(|_| !notices.has_errors());
    Imported { text, notices: notices.0 }
}

fn declared(
    name: &str,
    text: &str,
    options: &Options,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
    notices: &mut Notices,
) -> Option<String> {
    let mut root = match xml::parse(&Rc::from(name), text) {
        Ok(root) => root,
        Err((place, why)) => {
            notices.error(&place, why);
            return None;
        }
    };
    let (format, spatial) = match root.name.as_str() {
        "robot" => ("URDF", urdf::read(&root, notices)),
        "sdf" => ("SDF", sdf::read(&root, notices)),
        "mujoco" => {
            mjcf::included(&mut root, read, notices);
            ("MJCF", mjcf::read(&root, notices))
        }
        other => {
            notices.error(&root.place, format!("<{other}> is no <robot> (URDF), <sdf> or <mujoco> (MJCF)"));
            return None;
        }
    };
    let mut spatial = spatial.filter(|_| !notices.has_errors())?;
    prepare(&mut spatial, options, notices);
    if notices.has_errors() {
        return None;
    }
    let mut names = Names::default();
    let planar = Planar::of(&spatial, &mut names, notices)?;
    Some(write::declaration(&planar, &spatial, &mut names, file_name(name), format))
}

/// The last part of a path.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// Joins a link to the world.
fn fix(spatial: &mut Spatial, name: &str, notices: &mut Notices) {
    let own = name.replace("::", "_");
    let Some(number) = spatial.links.iter().position(|link| link.name == own) else {
        let known: Vec<&str> = spatial.links.iter().map(|link| link.name.as_str()).collect();
        let message = format!("there is no link `{name}` to fix; links: {}", known.join(", "));
        return notices.error(&spatial.place, message);
    };
    let (place, at) = (spatial.links[number].place.clone(), spatial.links[number].pose.at);
    spatial.joints.push(Joint::fixed(&format!("{own}_held"), &place, [None, Some(number)], at));
}

/// Leaves out and fixes parts as the options say, and moves starts that lie outside of their limits to them.
fn prepare(spatial: &mut Spatial, options: &Options, notices: &mut Notices) {
    for name in &options.fixed {
        fix(spatial, name, notices);
    }
    for joint in &mut spatial.joints {
        if options.without_limits {
            (joint.lower, joint.upper) = (None, None);
        }
        if options.without_friction {
            joint.friction = 0.0;
        }
        if let (Some(lower), Some(upper)) = (joint.lower, joint.upper)
            && lower >= upper
        {
            notices.error(
                &joint.place,
                format!("joint `{}`: its lower limit is not below its upper one", joint.name),
            );
            continue;
        }
        let within =
            joint.start.max(joint.lower.unwrap_or(joint.start)).min(joint.upper.unwrap_or(f64::INFINITY));
        if within != joint.start && joint.soft.is_none() {
            let [was, is] = [joint.start, within].map(number::short);
            notices.warn(
                &joint.place,
                format!(
                    "joint `{}` would start at {was}, outside of its limits: it starts at {is}",
                    joint.name
                ),
            );
            joint.start = within;
        }
    }
}
