//! Chains of joints whose links between have no mass: slides and a hinge of one body.

use super::hosts::{Hosts, Role};
use super::pairs::wrapped;
use super::{Host, Pair, PairKind, Planar};
use crate::names::Names;
use crate::notice::Notices;
use crate::space::{cross, dot, norm};
use crate::spatial::{Joint, Kind, Spatial};

/// The joints from a link with mass to the next one with mass, beginning with `number`.
pub(super) fn from(spatial: &Spatial, hosts: &Hosts, number: usize) -> Vec<usize> {
    let mut chain = vec![number];
    loop {
        let child = spatial.joints[chain[chain.len() - 1]].child;
        let is_between = child.is_some_and(|link| hosts.roles[link] == Role::Between);
        let mut next =
            (0..spatial.joints.len()).filter(|&k| spatial.joints[k].parent == child && !chain.contains(&k));
        match (is_between, next.next(), next.next()) {
            (true, Some(only), None) => chain.push(only),
            _ => return chain,
        }
    }
}

/// Form of a chain in the declaration.
#[derive(Clone, Copy, Debug)]
enum Shape {
    /// Nothing is constrained: two slides and a hinge.
    Free,
    /// Two slides.
    Upright,
    /// A slide with a hinge after it.
    Slot,
}

/// Adds the pairs of a chain; reports one that is not taken.
pub(super) fn add(
    planar: &mut Planar,
    spatial: &Spatial,
    chain: &[usize],
    [parent, child]: [Host; 2],
    names: &mut Names,
    notices: &mut Notices,
) {
    let joints: Vec<&Joint> = chain.iter().map(|&k| &spatial.joints[k]).collect();
    let last = joints[joints.len() - 1];
    let Some(shape) = shape(&joints) else {
        let why = "and the joints before it stand on links without mass, which is not taken";
        notices.error(&last.place, format!("`{}` {why}", last.name));
        return;
    };
    let acting: Vec<usize> = chain.iter().copied().filter(|&k| acts(spatial, k)).collect();
    // The force of a slide on the ground is one on the body, at the hinge after it: the body feels no torque of it.
    let is_force = |k: usize| {
        spatial.joints[k].kind == Kind::Prismatic && spatial.joints[k].start == spatial.joints[k].drawn
    };
    let comes_first = joints[..joints.len().min(2)].iter().all(|joint| joint.kind == Kind::Prismatic);
    // Along slides that are not perpendicular the coordinates are no projections.
    let is_square = comes_first && joints.len() > 1 && dot(joints[0].axis, joints[1].axis).abs() < 1e-9;
    let are_forces = parent == Host::Ground && is_square && acting.iter().all(|&k| is_force(k));
    if !acting.is_empty() && !are_forces {
        let why = "acts, starts elsewhere or ends, and joins a link without mass, which is taken of two perpendicular slides on the ground alone";
        notices
            .error(&spatial.joints[acting[0]].place, format!("`{}` {why}", spatial.joints[acting[0]].name));
        return;
    }
    let at = planar.plane.flat(last.at);
    for number in acting {
        let joint = &spatial.joints[number];
        let name = names.give(&joint.name, "joint");
        let (zero, along) = planar.slide(joint, at);
        let a = planar.add_port(parent, &name, zero, along);
        let b = planar.add_port(child, &name, at, 0.0);
        planar.pairs.push(Pair { name, kind: PairKind::Slide, a, b, joint: number });
    }
    let (name, kind, along) = match shape {
        Shape::Free => return,
        Shape::Upright => (format!("{}_upright", last.name), PairKind::Upright, planar.angle(child)),
        Shape::Slot => {
            let axis = planar.plane.flat(joints[0].axis);
            (last.name.clone(), PairKind::Slot, axis[1].atan2(axis[0]))
        }
    };
    let name = names.give(&name, "joint");
    let a = planar.add_port(parent, &name, at, wrapped(along - planar.angle(parent)));
    let b = planar.add_port(child, &name, at, 0.0);
    planar.pairs.push(Pair { name, kind, a, b, joint: chain[chain.len() - 1] });
}

/// Does anything act in a joint, does it end, or does it start elsewhere than the file draws it?
fn acts(spatial: &Spatial, number: usize) -> bool {
    let joint = &spatial.joints[number];
    !joint.is_plain()
        || joint.start != joint.drawn
        || spatial.drives.iter().any(|drive| drive.joint == number)
        || spatial.couplings.iter().any(|coupling| coupling.joint == number || coupling.of == Some(number))
}

fn shape(joints: &[&Joint]) -> Option<Shape> {
    let slides: Vec<&&Joint> = joints.iter().filter(|joint| joint.kind == Kind::Prismatic).collect();
    let hinges = joints.iter().filter(|joint| joint.kind == Kind::Revolute).count();
    match (&slides[..], hinges, joints.len()) {
        ([a, b], 1, 3) if norm(cross(a.axis, b.axis)) > 1e-3 => Some(Shape::Free),
        ([a, b], 0, 2) if norm(cross(a.axis, b.axis)) > 1e-3 => Some(Shape::Upright),
        ([_], 1, 2) if joints[0].kind == Kind::Prismatic => Some(Shape::Slot),
        _ => None,
    }
}
