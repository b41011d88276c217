//! Springs and dampers between two frames, in the plane.

use super::hosts::Hosts;
use super::pairs::{host, wrapped};
use super::{End, Host, Planar};
use crate::names::Names;
use crate::notice::Notices;
use crate::number::short;
use crate::space::{dot, norm, sub, transposed};
use crate::spatial::{Spatial, Tie, TieLaw};

/// A tie between two ports.
#[derive(Debug)]
pub(crate) struct PlanarTie {
    pub(crate) name: String,
    pub(crate) a: End,
    pub(crate) b: End,
    pub(crate) law: PlanarLaw,
}

/// The law of a tie in the plane; stiffness and damping along x, along y and about the normal.
#[derive(Clone, Copy, Debug)]
pub(crate) enum PlanarLaw {
    Spring { free_length: f64, stiffness: f64, damping: f64 },
    Bushing { stiffness: [f64; 3], damping: [f64; 3] },
}

/// Sine of an angle, and length, m, that count as rounding of the file.
const SMALL: f64 = 2e-5;

/// Adds the ties, in the order of the file.
pub(super) fn add(
    planar: &mut Planar,
    spatial: &Spatial,
    hosts: &Hosts,
    names: &mut Names,
    notices: &mut Notices,
) {
    for tie in &spatial.ties {
        let [(link_a, _), (link_b, _)] = tie.ends;
        let (Some(a), Some(b)) = (host(hosts, link_a), host(hosts, link_b)) else {
            notices.error(&tie.place, format!("`{}` acts on a link without mass", tie.name));
            continue;
        };
        if a == b {
            continue;
        }
        let name = names.give(&tie.name, "part");
        match tie.law {
            TieLaw::Spring { free_length, stiffness, damping } => {
                let law = PlanarLaw::Spring { free_length, stiffness, damping };
                spring(planar, tie, name, [a, b], law, notices);
            }
            TieLaw::Bushing { .. } => bushing(planar, tie, name, [a, b], notices),
        }
    }
}

fn spring(
    planar: &mut Planar,
    tie: &Tie,
    name: String,
    [a, b]: [Host; 2],
    law: PlanarLaw,
    notices: &mut Notices,
) {
    let [at_a, at_b] = tie.ends.map(|(_, pose)| pose.at);
    let across = dot(sub(at_b, at_a), planar.plane.normal).abs();
    if across > 1e-6 * (1.0 + norm(at_a)) {
        let across = short(across);
        notices
            .error(&tie.place, format!("the ends of `{}` are {across} m apart across the plane", tie.name));
        return;
    }
    let a = planar.add_port(a, &name, planar.plane.flat(at_a), 0.0);
    let b = planar.add_port(b, &name, planar.plane.flat(at_b), 0.0);
    planar.ties.push(PlanarTie { name, a, b, law });
}

/// A bushing whose frames have one axis across the plane in common.
fn bushing(planar: &mut Planar, tie: &Tie, name: String, [a, b]: [Host; 2], notices: &mut Notices) {
    let TieLaw::Bushing { stiffness, damping, turning_stiffness, turning_damping } = tie.law else { return };
    let normal = planar.plane.normal;
    let [frame_a, frame_b] = tie.ends.map(|(_, pose)| transposed(&pose.turn));
    let stands = |k: &usize| {
        norm(sub(frame_a[*k], frame_b[*k])) < SMALL && dot(frame_a[*k], normal).abs() > 1.0 - SMALL
    };
    let Some(k) = (0..3).find(stands) else {
        let why = "no axis of its frames stands across the plane on both of them";
        notices.error(&tie.place, format!("`{}` is not planar: {why}", tie.name));
        return;
    };
    // In the order that keeps their hand; seen from the other side y points the other way, along which the springs are the same.
    let [i, j] = [(k + 1) % 3, (k + 2) % 3];
    let angle = |frame: &[crate::space::Vector; 3]| {
        let [x, y] = planar.plane.flat(frame[i]);
        y.atan2(x)
    };
    let (along_a, along_b) = (angle(&frame_a), angle(&frame_b));
    // The angle between both frames is the one below half a turn.
    let along_b = along_a + wrapped(along_b - along_a);
    let pick = |of: [f64; 3], turning: [f64; 3]| [of[i], of[j], turning[k]];
    let law = PlanarLaw::Bushing {
        stiffness: pick(stiffness, turning_stiffness),
        damping: pick(damping, turning_damping),
    };
    let [at_a, at_b] = tie.ends.map(|(_, pose)| planar.plane.flat(pose.at));
    let a = planar.add_port(a, &name, at_a, along_a - planar.angle(a));
    let b = planar.add_port(b, &name, at_b, along_b - planar.angle(b));
    planar.ties.push(PlanarTie { name, a, b, law });
}
