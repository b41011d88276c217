//! Springs and bushings between two frames.

use super::Lines;
use crate::number::short;
use crate::planar::{Planar, PlanarLaw};

/// Part for the law of Drake's bushing (drake.mit.edu, LinearBushingRollPitchYaw), whose axes stand halfway between both frames.
const BUSHING: &str = "\
/// Springs and dampers along axes that stand halfway between both frames, at the point halfway between them.
part halfway_bushing(a: frame, b: frame) {
    param stiffness_x: N/m = 0;
    param stiffness_y: N/m = 0;
    param stiffness_angle: N*m/rad = 0;
    param damping_x: N*s/m = 0;
    param damping_y: N*s/m = 0;
    param damping_angle: N*m*s/rad = 0;
    let between = b.position - a.position;
    let angle = b.angle - a.angle;
    let along = turn(a.axis, angle/2);
    let across = turn(a.normal, angle/2);
    let x = dot(between, along);
    let y = dot(between, across);
    let push = -(stiffness_x*x + damping_x*rate(x))*along - (stiffness_y*y + damping_y*rate(y))*across;
    let moment = -stiffness_angle*angle - damping_angle*rate(angle);
    force on b from a: push;
    torque on b from a: moment;
    torque on a: -cross(between, push)/2;
    torque on b: -cross(between, push)/2;
    output force = push;
    output torque = moment;
}";

/// The part that bushings are, where there are some.
pub(super) fn parts(planar: &Planar, lines: &mut Lines) {
    if planar.ties.iter().any(|tie| matches!(tie.law, PlanarLaw::Bushing { .. })) {
        lines.lines(BUSHING);
    }
}

pub(super) fn ties(planar: &Planar, lines: &mut Lines) {
    for tie in &planar.ties {
        let (part, fields): (&str, Vec<(&str, f64, &str)>) = match tie.law {
            PlanarLaw::Spring { free_length, stiffness, damping } => (
                "spring",
                vec![
                    ("stiffness", stiffness, "N/m"),
                    ("damping", damping, "N*s/m"),
                    ("free_length", free_length, "m"),
                ],
            ),
            PlanarLaw::Bushing { stiffness, damping } => (
                "halfway_bushing",
                vec![
                    ("stiffness_x", stiffness[0], "N/m"),
                    ("stiffness_y", stiffness[1], "N/m"),
                    ("stiffness_angle", stiffness[2], "N*m/rad"),
                    ("damping_x", damping[0], "N*s/m"),
                    ("damping_y", damping[1], "N*s/m"),
                    ("damping_angle", damping[2], "N*m*s/rad"),
                ],
            ),
        };
        let head = format!("{part} {}({}, {})", tie.name, planar.path(tie.a), planar.path(tie.b));
        lines.block(&head, |lines| {
            for (name, value, unit) in fields.into_iter().filter(|(_, value, _)| *value != 0.0) {
                lines.line(&format!("{name}: {} {unit};", short(value)));
            }
        });
    }
}
