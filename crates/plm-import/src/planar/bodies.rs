//! Bodies of a planar mechanism: mass, ports and outlines of the links that they carry.

use super::hosts::{Hosts, Role};
use super::{Body, Planar, Port, local};
use crate::names::Names;
use crate::notice::Notices;
use crate::outline::Outline;
use crate::plane::Plane;
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
        let plane = &planar.plane;
        let [x, y] = plane.flat(link.pose.at);
        let pose = [x, y, angle_of(plane, link)];
        let normal = plane.normal;
        let centre = link.pose.point(inertial.centre);
        let depth = dot(centre, normal);
        let inertia = dot(normal, turned(&tensor(&link.pose.turn, &inertial.tensor), normal));
        let mut body = Body {
            name: names.give(&link.name, "body"),
            mass: inertial.mass,
            inertia,
            centre: local(pose, plane.flat(centre)),
            drawn: pose,
            start: pose,
            given: [false, false, true],
            locked: [false; 3],
            depth: if depth.abs() < 1e-9 { 0.0 } else { depth },
            ports: Vec::new(),
            port_names: Names::of_ports(),
            outlines: Vec::new(),
        };
        if inertia < 0.0 || !inertia.is_finite() || !inertial.mass.is_finite() {
            notices.error(&link.place, format!("the inertia of `{}` is negative or no number", link.name));
        }
        for (k, carried) in spatial.links.iter().enumerate() {
            if k == number || hosts.roles[k] == Role::Part(number) {
                carry(&mut body, plane, carried);
            }
        }
        body.outlines.sort_by(|a, b| b.area().abs().total_cmp(&a.area().abs()));
        planar.bodies.push(body);
    }
}

/// The angle of a body: that of the first axis of its link that lies in the plane.
fn angle_of(plane: &Plane, link: &Link) -> f64 {
    let columns = crate::space::transposed(&link.pose.turn);
    let within = columns.into_iter().find(|axis| dot(*axis, plane.normal).abs() < 1e-4);
    within.map_or(0.0, |axis| {
        let [x, y] = plane.flat(axis);
        let angle = y.atan2(x);
        if angle.abs() < 1e-12 { 0.0 } else { angle }
    })
}

/// Adds outlines and named points of a link to the body that carries it.
fn carry(body: &mut Body, plane: &Plane, link: &Link) {
    for shape in &link.shapes {
        let outline = Outline::of(shape, &link.pose, plane);
        let outline = match outline {
            Some(Outline::Circle { at, radius }) => Outline::Circle { at: local(body.drawn, at), radius },
            Some(Outline::Polygon(points)) => {
                Outline::Polygon(points.into_iter().map(|point| local(body.drawn, point)).collect())
            }
            None => continue,
        };
        body.outlines.push(outline);
    }
    for (name, pose) in &link.points {
        let pose = link.pose.of(pose);
        let at = local(body.drawn, plane.flat(pose.at));
        let name = body.port_names.give(name, "port");
        body.ports.push(Port { name, at, angle: 0.0 });
    }
}
