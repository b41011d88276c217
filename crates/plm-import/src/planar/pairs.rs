//! Pairs of a planar mechanism: its joints, and chains of joints whose links between have no mass.

use super::chain;
use super::hosts::{Hosts, Role};
use super::{End, Host, Pair, PairKind, Planar, Port};
use crate::names::Names;
use crate::notice::Notices;
use crate::space::{dot, norm, sub};
use crate::spatial::{Joint, Kind, Spatial};

/// The owner of the ports of a link; none of a link between two joints.
pub(super) fn host(hosts: &Hosts, link: Option<usize>) -> Option<Host> {
    let Some(carrier) = hosts.carrier(link) else { return Some(Host::Ground) };
    let is_body = |link: &usize| hosts.roles[*link] == Role::Body;
    // Bodies have the order of their links.
    is_body(&carrier).then(|| Host::Body((0..carrier).filter(is_body).count()))
}

/// Adds the pairs, in the order of the joints.
pub(super) fn add(
    planar: &mut Planar,
    spatial: &Spatial,
    hosts: &Hosts,
    names: &mut Names,
    notices: &mut Notices,
) {
    let host = |link: Option<usize>| host(hosts, link);
    let mut done = vec![false; spatial.joints.len()];
    for (number, joint) in spatial.joints.iter().enumerate() {
        let (Some(a), false) = (host(joint.parent), done[number]) else { continue };
        let chain = chain::from(spatial, hosts, number);
        for &k in &chain {
            done[k] = true;
        }
        let last = &spatial.joints[chain[chain.len() - 1]];
        let Some(b) = host(last.child) else {
            let link = last.child.map_or("", |link| spatial.links[link].name.as_str());
            notices.error(&last.place, format!("link `{link}` moves and has no mass"));
            continue;
        };
        if a == b {
            if joint.kind != Kind::Fixed {
                notices.warn(
                    &joint.place,
                    format!("joint `{}` joins what is fixed already: it is left out", joint.name),
                );
            }
            continue;
        }
        match &chain[..] {
            [number] => single(planar, joint, *number, [a, b], names, notices),
            _ => chain::add(planar, spatial, &chain, [a, b], names, notices),
        }
    }
    for (joint, _) in spatial.joints.iter().zip(done).filter(|(_, done)| !done) {
        notices.error(
            &joint.place,
            format!("joint `{}` hangs on a link without mass that others hold too", joint.name),
        );
    }
}

impl Planar {
    /// Adds a port with this name to a host.
    pub(super) fn add_port(&mut self, host: Host, name: &str, at: [f64; 2], angle: f64) -> End {
        let at = self.local(host, at);
        let angle = if angle.abs() < 1e-12 { 0.0 } else { angle };
        let (ports, names) = match host {
            Host::Ground => (&mut self.ground, &mut self.ground_names),
            Host::Body(body) => {
                let body = &mut self.bodies[body];
                (&mut body.ports, &mut body.port_names)
            }
        };
        let name = names.give(name, "port");
        ports.push(Port { name, at, angle });
        End { host, port: ports.len() - 1 }
    }

    /// The point of a slide at which its coordinate is zero, where it is drawn at `at`, and the angle of its direction.
    pub(super) fn slide(&self, joint: &Joint, at: [f64; 2]) -> ([f64; 2], f64) {
        let axis = self.plane.flat(joint.axis);
        let zero = [at[0] - joint.drawn * axis[0], at[1] - joint.drawn * axis[1]];
        (zero, axis[1].atan2(axis[0]))
    }

    pub(super) fn angle(&self, host: Host) -> f64 {
        self.pose(host)[2]
    }
}

/// An angle between −π and π.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - std::f64::consts::TAU * (angle / std::f64::consts::TAU).round()
}

fn single(
    planar: &mut Planar,
    joint: &Joint,
    number: usize,
    [parent, child]: [Host; 2],
    names: &mut Names,
    notices: &mut Notices,
) {
    let at = planar.plane.flat(joint.at);
    let turn = planar.angle(child) - planar.angle(parent);
    let name = names.give(&joint.name, "joint");
    let (kind, a, b) = match joint.kind {
        Kind::Revolute => {
            // The angle is that of the file where the axis points to the reader; else the bodies change places.
            let is_left = dot(joint.axis, planar.plane.normal) > 0.0;
            let angle = if is_left { turn - joint.drawn } else { turn + joint.drawn };
            let (of_parent, of_child) =
                (planar.add_port(parent, &name, at, angle), planar.add_port(child, &name, at, 0.0));
            if is_left {
                (PairKind::Revolute, of_parent, of_child)
            } else {
                (PairKind::Revolute, of_child, of_parent)
            }
        }
        Kind::Prismatic => {
            let (zero, along) = planar.slide(joint, at);
            let along = wrapped(along - planar.angle(parent));
            let a = planar.add_port(parent, &name, zero, along);
            // Not wrapped: a whole turn between both axes would be an error of the start, as in a weld.
            (PairKind::Prismatic, a, planar.add_port(child, &name, at, along - turn))
        }
        Kind::Fixed => {
            let a = planar.add_port(parent, &name, at, turn);
            (PairKind::Weld, a, planar.add_port(child, &name, at, 0.0))
        }
        Kind::Point => {
            let at_child = planar.plane.flat(joint.at_child);
            let away = dot(sub(joint.at_child, joint.at), planar.plane.normal).abs();
            if away > 1e-6 * (1.0 + norm(joint.at)) {
                let away = crate::number::short(away);
                notices.warn(
                    &joint.place,
                    format!("the points of `{name}` are {away} m apart across the plane, which is not taken"),
                );
            }
            let a = planar.add_port(parent, &name, at, 0.0);
            (PairKind::Revolute, a, planar.add_port(child, &name, at_child, 0.0))
        }
        Kind::Free => return,
    };
    planar.pairs.push(Pair { name, kind, a, b, joint: number });
}
