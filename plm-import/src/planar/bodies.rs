//! Bodies of a planar mechanism: mass, ports and outlines of the links that they carry.

use super::hosts::{Hosts, Role};
use super::{Body, Host, Planar, Port};
use crate::names::Names;
use crate::notice::Notices;
use crate::outline::Outline;
use crate::space::{dot, tensor, turned};
use crate::spatial::{Link, Spatial};

/// Adds the bodies, in the order of their links; what they carry follows.
pub(super) fn add(
    planar: &mut Planar,
    spatial: &Spatial,
    hosts: &Hosts,
    names: &mut Names,
    notices: &mut Notices,
) {
    for (number, link) in spatial.links.iter().enumerate() {
        if hosts.roles[number] != Role::Body {
            continue;
        }
        let Some(inertial) = link.inertial else { continue };
        let at = planar.plane.flat(link.pose.at);
        let angle = angle_of(planar, link);
        let normal = planar.plane.normal;
        let inertia = dot(normal, turned(&tensor(&link.pose.turn, &inertial.tensor), normal));
        let mut body = Body {
            name: names.give(&link.name, "body"),
            mass: inertial.mass,
            inertia,
            centre: [0.0; 2],
            drawn: [at[0], at[1], angle],
            start: [at[0], at[1], angle],
            given: [false, false, true],
            locked: [false; 3],
            depth: dot(link.pose.point(inertial.centre), normal),
            ports: Vec::new(),
            port_names: Names::of_ports(),
            outlines: Vec::new(),
        };
        if inertia < 0.0 || !inertia.is_finite() || !inertial.mass.is_finite() {
            notices.error(&link.place, format!("the inertia of `{}` is negative or no number", link.name));
        }
        let centre = planar.plane.flat(link.pose.point(inertial.centre));
        body.depth = if body.depth.abs() < 1e-9 { 0.0 } else { body.depth };
        planar.bodies.push(body);
        let host = Host::Body(planar.bodies.len() - 1);
        let centre = planar.local(host, centre);
        if let Some(body) = planar.bodies.last_mut() {
            body.centre = centre;
        }
        for (k, carried) in spatial.links.iter().enumerate() {
            if k == number || hosts.roles[k] == Role::Part(number) {
                carry(planar, host, carried);
            }
        }
        if let Some(body) = planar.bodies.last_mut() {
            body.outlines.sort_by(|a, b| b.area().abs().total_cmp(&a.area().abs()));
        }
    }
}

/// The angle of a body: that of the first axis of its link that lies in the plane.
fn angle_of(planar: &Planar, link: &Link) -> f64 {
    let columns = crate::space::transposed(&link.pose.turn);
    let within = columns.into_iter().find(|axis| dot(*axis, planar.plane.normal).abs() < 1e-4);
    within.map_or(0.0, |axis| {
        let [x, y] = planar.plane.flat(axis);
        let angle = y.atan2(x);
        if angle.abs() < 1e-12 { 0.0 } else { angle }
    })
}

/// Outlines and named points of a link.
fn carry(planar: &mut Planar, host: Host, link: &Link) {
    let Host::Body(number) = host else { return };
    for shape in &link.shapes {
        let outline = Outline::of(shape, &link.pose, &planar.plane);
        let local = match outline {
            Some(Outline::Circle { at, radius }) => Outline::Circle { at: planar.local(host, at), radius },
            Some(Outline::Polygon(points)) => {
                Outline::Polygon(points.into_iter().map(|point| planar.local(host, point)).collect())
            }
            None => continue,
        };
        planar.bodies[number].outlines.push(local);
    }
    for (name, pose) in &link.points {
        let pose = link.pose.of(pose);
        let at = planar.local(host, planar.plane.flat(pose.at));
        let body = &mut planar.bodies[number];
        let name = body.port_names.give(name, "port");
        body.ports.push(Port { name, at, angle: 0.0 });
    }
}
