//! Roles of links: ground, body, part of another link, or without mass between joints.

use crate::spatial::{Joint, Kind, Spatial};

/// Role of a link in the declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// It is fixed to the world.
    Ground,
    /// A body of the declaration.
    Body,
    /// It has no mass, and is fixed to the link with this number.
    Part(usize),
    /// It has no mass, and stands between two joints.
    Between,
}

/// Roles of all links.
#[derive(Debug)]
pub(super) struct Hosts {
    pub(super) roles: Vec<Role>,
}

impl Hosts {
    pub(super) fn of(spatial: &Spatial) -> Hosts {
        let fixed = || spatial.joints.iter().filter(|joint| joint.kind == Kind::Fixed);
        let count = spatial.links.len();
        let has_mass = |link: usize| spatial.links[link].inertial.is_some();
        let mut roles: Vec<Role> =
            (0..count).map(|link| if has_mass(link) { Role::Body } else { Role::Between }).collect();
        // A link that is fixed to the world is ground, with or without mass.
        for _ in 0..count {
            for joint in fixed() {
                let is_ground = |end: Option<usize>| end.is_none_or(|link| roles[link] == Role::Ground);
                let (of_parent, of_child) = (is_ground(joint.parent), is_ground(joint.child));
                for end in [joint.parent, joint.child].into_iter().flatten().filter(|_| of_parent || of_child)
                {
                    roles[end] = Role::Ground;
                }
            }
        }
        // What has no mass is part of what it is fixed to.
        for _ in 0..count {
            for (own, other) in fixed().flat_map(ends) {
                if roles[own] == Role::Between {
                    match roles[other] {
                        Role::Body => roles[own] = Role::Part(other),
                        Role::Part(of) => roles[own] = Role::Part(of),
                        Role::Ground | Role::Between => {}
                    }
                }
            }
        }
        Hosts { roles }
    }

    /// The link that carries what stands at this one; none is the ground.
    pub(super) fn carrier(&self, link: Option<usize>) -> Option<usize> {
        let link = link?;
        match self.roles[link] {
            Role::Ground => None,
            Role::Part(of) => Some(of),
            Role::Body | Role::Between => Some(link),
        }
    }
}

/// Both ends of a joint between links, either way.
fn ends(joint: &Joint) -> Vec<(usize, usize)> {
    match (joint.parent, joint.child) {
        (Some(parent), Some(child)) => vec![(parent, child), (child, parent)],
        _ => Vec::new(),
    }
}
