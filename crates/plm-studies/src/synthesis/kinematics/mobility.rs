//! Mobility: by counting, and by the rank of the velocity equations at a pose.

use nalgebra::DMatrix;

use crate::synthesis::four_bar::{Point, vector};
use crate::synthesis::numbers::rank;

/// Link of a joint: the ground, or a body by its number from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// The ground.
    Ground,
    /// A body.
    Body(usize),
}

/// Joint between two links, at a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Joint {
    /// Revolute joint at a point, m.
    Revolute([Link; 2], Point),
    /// Prismatic joint along a direction.
    Prismatic([Link; 2], Point),
    /// Pin in a slot: a point, m, of one link moves along a direction of the other.
    PinInSlot([Link; 2], Point, Point),
}

impl Joint {
    fn links(&self) -> [Link; 2] {
        match *self {
            Self::Revolute(links, _) | Self::Prismatic(links, _) | Self::PinInSlot(links, ..) => links,
        }
    }
}

/// Mobility at a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mobility {
    /// Degrees of freedom by counting: three a body less the rows of the joints.
    pub counted: isize,
    /// Degrees of freedom of the velocities at the pose: three a body less the rank of the rows. In a singular pose they are more than
    /// those of the motion.
    pub at_pose: usize,
    /// Rows that others imply at the pose.
    pub redundant: usize,
}

/// Formula of Grübler and Chebyshev: degrees of freedom of so many links, the ground among them, with joints of one and of two freedoms.
pub fn gruebler(links: usize, one_freedom: usize, two_freedoms: usize) -> isize {
    3 * (links as isize - 1) - 2 * one_freedom as isize - two_freedoms as isize
}

/// Mobility of bodies with joints at a pose, by counting and by rank. Singular values below 1e-9 of the largest one count as zero, with
/// lengths in units of the extent of the joints. None where a joint names a body that is not there.
pub fn mobility(bodies: usize, joints: &[Joint]) -> Option<Mobility> {
    let is_missing = |link: &Link| matches!(*link, Link::Body(body) if body >= bodies);
    if joints.iter().any(|joint| joint.links().iter().any(is_missing)) {
        return None;
    }
    let places = joints.iter().filter_map(|joint| match joint {
        Joint::Revolute(_, place) | Joint::PinInSlot(_, place, _) => Some(*place),
        Joint::Prismatic(..) => None,
    });
    let extent = places.flatten().map(f64::abs).fold(f64::MIN_POSITIVE, f64::max);
    let rows: Vec<Vec<f64>> = joints.iter().flat_map(|joint| rows(joint, bodies, extent)).collect();
    let counted = 3 * bodies as isize - rows.len() as isize;
    let matrix = DMatrix::from_fn(rows.len(), 3 * bodies, |row, column| rows[row][column]);
    let rank = if matrix.is_empty() { 0 } else { rank(matrix.clone(), 1e-9 * matrix.norm()) };
    Some(Mobility { counted, at_pose: 3 * bodies - rank, redundant: rows.len() - rank })
}

/// Rows of a joint in the velocities of all bodies: of the point of each that passes the origin, and the rate of turning times the extent.
fn rows(joint: &Joint, bodies: usize, extent: f64) -> Vec<Vec<f64>> {
    // Velocity of a point along a direction: v·n + omega (p × n).
    let along = |links: [Link; 2], place: Point, direction: Point| {
        let mut row = vec![0.0; 3 * bodies];
        let moment = (vector(place).conj() * vector(direction)).im / extent;
        for (link, sign) in links.into_iter().zip([1.0, -1.0]) {
            if let Link::Body(body) = link {
                row[3 * body] += sign * direction[0];
                row[3 * body + 1] += sign * direction[1];
                row[3 * body + 2] += sign * moment;
            }
        }
        row
    };
    let turning = |links: [Link; 2]| {
        let mut row = vec![0.0; 3 * bodies];
        for (link, sign) in links.into_iter().zip([1.0, -1.0]) {
            if let Link::Body(body) = link {
                row[3 * body + 2] += sign;
            }
        }
        row
    };
    let normal = |direction: Point| {
        let length = direction[0].hypot(direction[1]);
        [-direction[1] / length, direction[0] / length]
    };
    match *joint {
        Joint::Revolute(links, place) => {
            vec![along(links, place, [1.0, 0.0]), along(links, place, [0.0, 1.0])]
        }
        Joint::Prismatic(links, direction) => {
            vec![along(links, [0.0, 0.0], normal(direction)), turning(links)]
        }
        Joint::PinInSlot(links, place, direction) => vec![along(links, place, normal(direction))],
    }
}
