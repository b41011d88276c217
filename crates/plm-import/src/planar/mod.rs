//! A mechanism in its plane: bodies with ports, and pairs that join them.

mod bodies;
mod chain;
mod hosts;
mod pairs;
mod start;
mod ties;

use crate::names::Names;
use crate::notice::Notices;
use crate::outline::Outline;
use crate::plane::Plane;
use crate::spatial::Spatial;

pub(crate) use self::ties::{PlanarLaw, PlanarTie};

/// A mechanism in its plane.
#[derive(Debug)]
pub(crate) struct Planar {
    pub(crate) plane: Plane,
    pub(crate) gravity: [f64; 2],
    /// The ports of the ground.
    pub(crate) ground: Vec<Port>,
    ground_names: Names,
    pub(crate) bodies: Vec<Body>,
    pub(crate) pairs: Vec<Pair>,
    pub(crate) ties: Vec<PlanarTie>,
    /// A group of bodies has no joint to the ground.
    pub(crate) floats: bool,
}

/// A body of the declaration.
#[derive(Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) mass: f64,
    pub(crate) inertia: f64,
    /// Centre of gravity, in the axes of the body.
    pub(crate) centre: [f64; 2],
    /// Pose of the origin as the file draws it: x, y, angle.
    pub(crate) drawn: [f64; 3],
    /// Pose of the origin at the start.
    pub(crate) start: [f64; 3],
    /// Coordinates that the start gives, and those that it locks: x, y, angle.
    pub(crate) given: [bool; 3],
    pub(crate) locked: [bool; 3],
    /// Place along the normal.
    pub(crate) depth: f64,
    pub(crate) ports: Vec<Port>,
    pub(crate) port_names: Names,
    /// In the axes of the body, the largest first.
    pub(crate) outlines: Vec<Outline>,
}

/// A port.
#[derive(Clone, Debug)]
pub(crate) struct Port {
    pub(crate) name: String,
    pub(crate) at: [f64; 2],
    pub(crate) angle: f64,
}

/// Owner of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Host {
    Ground,
    Body(usize),
}

/// A port of a body or of the ground, by numbers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End {
    pub(crate) host: Host,
    pub(crate) port: usize,
}

/// Kinds of pairs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PairKind {
    Revolute,
    Prismatic,
    Weld,
    /// A slide with a hinge after it.
    Slot,
    /// Two slides: `b` does not turn.
    Upright,
    /// Forces along one of two slides on the ground.
    Slide,
}

/// Two ports that a joint of the declaration joins.
#[derive(Debug)]
pub(crate) struct Pair {
    pub(crate) name: String,
    pub(crate) kind: PairKind,
    pub(crate) a: End,
    pub(crate) b: End,
    /// The joint of the file whose values it has.
    pub(crate) joint: usize,
}

impl Planar {
    /// Lays a mechanism into its plane.
    pub(crate) fn of(spatial: &Spatial, names: &mut Names, notices: &mut Notices) -> Option<Planar> {
        let plane = Plane::of(spatial, notices)?;
        let mut planar = Planar {
            gravity: plane.flat(spatial.gravity),
            plane,
            ground: Vec::new(),
            ground_names: Names::of_ports(),
            bodies: Vec::new(),
            pairs: Vec::new(),
            ties: Vec::new(),
            floats: false,
        };
        let hosts = hosts::Hosts::of(spatial);
        bodies::add(&mut planar, spatial, &hosts, names, notices);
        pairs::add(&mut planar, spatial, &hosts, names, notices);
        ties::add(&mut planar, spatial, &hosts, names, notices);
        planar.find_driven(spatial, notices);
        if planar.bodies.is_empty() && !notices.has_errors() {
            notices.error(&spatial.place, "nothing in it moves");
        }
        if notices.has_errors() {
            return None;
        }
        for body in start::set(&mut planar, spatial) {
            planar.tell_of_fall(body, spatial, &hosts, notices);
        }
        planar.size_up(spatial, notices);
        Some(planar)
    }

    /// Reports drives and couplings whose joints are no pairs.
    fn find_driven(&self, spatial: &Spatial, notices: &mut Notices) {
        let is_pair = |joint: usize| self.pairs.iter().any(|pair| pair.joint == joint);
        for drive in spatial.drives.iter().filter(|drive| !is_pair(drive.joint)) {
            notices.warn(&drive.place, format!("`{}` drives a joint that is left out", drive.name));
        }
        for coupling in &spatial.couplings {
            if !is_pair(coupling.joint) || coupling.of.is_some_and(|of| !is_pair(of)) {
                notices.error(
                    &coupling.place,
                    format!("`{}` speaks of a joint that is left out", coupling.name),
                );
            }
        }
    }

    /// Reports a group of bodies that only contact supports, of which `first` is one: contacts are left out.
    fn tell_of_fall(&self, first: usize, spatial: &Spatial, hosts: &hosts::Hosts, notices: &mut Notices) {
        let bodies = self.group(first);
        let touches = |link: &usize| {
            let host = pairs::host(hosts, Some(*link));
            spatial.links[*link].touches && matches!(host, Some(Host::Body(body)) if bodies.contains(&body))
        };
        let is_pulled = self.gravity.iter().any(|part| part.abs() > 1e-9);
        let Some(link) = (0..spatial.links.len()).find(touches).filter(|_| is_pulled) else { return };
        // The best link to be fixed is the root from which the others hang.
        let root =
            (0..spatial.links.len()).find(|link| pairs::host(hosts, Some(*link)) == Some(Host::Body(first)));
        let (link, root) = (&spatial.links[link], &spatial.links[root.unwrap_or(link)].name);
        let message = format!(
            "nothing but contact holds `{root}`, and contacts are left out: it falls; `--fix {root}` joins it to the world"
        );
        notices.warn(&link.place, message);
    }

    /// The bodies that joints and ties hold together with this one, without the ground.
    fn group(&self, first: usize) -> Vec<usize> {
        let mut group = vec![first];
        let ties = self.ties.iter().map(|tie| [tie.a.host, tie.b.host]);
        let links: Vec<[Host; 2]> =
            self.pairs.iter().map(|pair| [pair.a.host, pair.b.host]).chain(ties).collect();
        let mut next = 0;
        while let Some(&body) = group.get(next) {
            next += 1;
            for hosts in links.iter().filter(|hosts| hosts.contains(&Host::Body(body))) {
                for host in hosts {
                    match host {
                        Host::Body(other) if !group.contains(other) => group.push(*other),
                        _ => {}
                    }
                }
            }
        }
        group
    }

    pub(crate) fn port(&self, end: End) -> &Port {
        match end.host {
            Host::Ground => &self.ground[end.port],
            Host::Body(body) => &self.bodies[body].ports[end.port],
        }
    }

    /// A port as the declaration names it.
    pub(crate) fn path(&self, end: End) -> String {
        let host = match end.host {
            Host::Ground => "ground",
            Host::Body(body) => &self.bodies[body].name,
        };
        format!("{host}.{}", self.port(end).name)
    }

    /// The pose of a host in the plane, as the file draws it.
    fn pose(&self, host: Host) -> [f64; 3] {
        match host {
            Host::Ground => [0.0; 3],
            Host::Body(body) => self.bodies[body].drawn,
        }
    }

    /// A point of the plane in the axes of a host.
    fn local(&self, host: Host, at: [f64; 2]) -> [f64; 2] {
        local(self.pose(host), at)
    }

    /// Gives an inertia to points of mass, of which the language asks one.
    fn size_up(&mut self, spatial: &Spatial, notices: &mut Notices) {
        for body in &mut self.bodies {
            if body.inertia > 0.0 {
                continue;
            }
            let away = |port: &Port| (port.at[0] - body.centre[0]).hypot(port.at[1] - body.centre[1]);
            let reach = body.ports.iter().map(away).fold(0.0, f64::max);
            body.inertia = 1e-12 * body.mass * if reach > 0.0 { reach * reach } else { 1.0 };
            notices.warn(
                &spatial.place,
                format!(
                    "`{}` has no inertia across the plane: {} kg*m^2 is written",
                    body.name,
                    crate::number::short(body.inertia)
                ),
            );
        }
    }
}

/// A point in the axes of a frame whose pose, x, y and angle, is given in the same axes as the point.
pub(crate) fn local([x, y, angle]: [f64; 3], at: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    let d = [at[0] - x, at[1] - y];
    [cos * d[0] + sin * d[1], -sin * d[0] + cos * d[1]]
}
