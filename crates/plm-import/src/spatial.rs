//! A mechanism in space, as URDF, SDF and MJCF have it in common.
//!
//! All poses are those in which the file draws the mechanism, in the frame of the world.

use crate::notice::Place;
use crate::space::{Matrix, Pose, Vector, tensor};

/// A mechanism in space.
#[derive(Debug)]
pub(crate) struct Spatial {
    pub(crate) name: String,
    pub(crate) place: Place,
    /// Acceleration of gravity, m/s².
    pub(crate) gravity: Vector,
    pub(crate) links: Vec<Link>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) drives: Vec<Drive>,
    pub(crate) couplings: Vec<Coupling>,
    pub(crate) ties: Vec<Tie>,
}

impl Spatial {
    /// A mechanism without links.
    pub(crate) fn new(name: &str, place: &Place, gravity: Vector) -> Spatial {
        Spatial {
            name: name.to_owned(),
            place: place.clone(),
            gravity,
            links: Vec::new(),
            joints: Vec::new(),
            drives: Vec::new(),
            couplings: Vec::new(),
            ties: Vec::new(),
        }
    }
}

/// A rigid body, or a frame without mass.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) pose: Pose,
    pub(crate) inertial: Option<Inertial>,
    pub(crate) shapes: Vec<Shape>,
    /// Named frames, in the axes of the link.
    pub(crate) points: Vec<(String, Pose)>,
    /// True if it could touch others: contacts are left out.
    pub(crate) touches: bool,
}

/// Mass, centre of gravity, and inertia about it, in the axes of the link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inertial {
    pub(crate) mass: f64,
    pub(crate) centre: Vector,
    pub(crate) tensor: Matrix,
}

impl Inertial {
    /// Mass with its inertia `xx yy zz xy xz yz` in the axes of `pose`, which stands at the centre of gravity; none of a mass of zero.
    pub(crate) fn new(mass: f64, pose: &Pose, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Option<Inertial> {
        let own = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
        (mass > 0.0).then(|| Inertial { mass, centre: pose.at, tensor: tensor(&pose.turn, &own) })
    }
}

/// A solid at a place of a link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape {
    pub(crate) solid: Solid,
    pub(crate) pose: Pose,
}

/// A solid about its centre; cylinders and capsules stand along z. Lengths are halves, m.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Solid {
    Box(Vector),
    Cylinder { radius: f64, half: f64 },
    Capsule { radius: f64, half: f64 },
    Ellipsoid(Vector),
}

/// A kinematic pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Revolute,
    Prismatic,
    Fixed,
    /// Two points coincide, and nothing else: closes a loop.
    Point,
    /// Nothing is constrained.
    Free,
}

/// A joint between two links; `None` is the world.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) kind: Kind,
    pub(crate) parent: Option<usize>,
    pub(crate) child: Option<usize>,
    /// A point of the axis, in the world.
    pub(crate) at: Vector,
    /// The point of the child that coincides with `at`, if the pose does not close the joint.
    pub(crate) at_child: Vector,
    /// Unit vector, in the world.
    pub(crate) axis: Vector,
    /// The joint's coordinate in the pose of the file, rad or m.
    pub(crate) drawn: f64,
    /// The joint's coordinate at the start.
    pub(crate) start: f64,
    pub(crate) damping: f64,
    pub(crate) stiffness: f64,
    /// The coordinate at which the spring is free.
    pub(crate) rest: f64,
    /// Dry friction, N m or N.
    pub(crate) friction: f64,
    /// Inertia of a rotor on the joint, kg m² or kg.
    pub(crate) armature: f64,
    pub(crate) lower: Option<f64>,
    pub(crate) upper: Option<f64>,
    /// Stiffness and damping of limits that give way.
    pub(crate) soft: Option<[f64; 2]>,
}

impl Joint {
    /// A joint without springs, dampers and limits.
    pub(crate) fn new(
        name: &str,
        place: &Place,
        kind: Kind,
        pair: [Option<usize>; 2],
        at: Vector,
        axis: Vector,
    ) -> Joint {
        Joint {
            name: name.to_owned(),
            place: place.clone(),
            kind,
            parent: pair[0],
            child: pair[1],
            at,
            at_child: at,
            axis,
            drawn: 0.0,
            start: 0.0,
            damping: 0.0,
            stiffness: 0.0,
            rest: 0.0,
            friction: 0.0,
            armature: 0.0,
            lower: None,
            upper: None,
            soft: None,
        }
    }

    /// A joint that holds its links to each other.
    pub(crate) fn fixed(name: &str, place: &Place, pair: [Option<usize>; 2], at: Vector) -> Joint {
        Joint::new(name, place, Kind::Fixed, pair, at, [0.0, 0.0, 1.0])
    }

    /// Is it without springs, dampers, friction, rotor and limits?
    pub(crate) fn is_plain(&self) -> bool {
        [self.damping, self.stiffness, self.friction, self.armature].iter().all(|value| *value == 0.0)
            && self.lower.is_none()
            && self.upper.is_none()
    }
}

/// A drive of a joint: `gear clamp(gain clamp(input) + bias · (1, gear q, gear dq/dt))`.
#[derive(Clone, Debug)]
pub(crate) struct Drive {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) joint: usize,
    pub(crate) gear: f64,
    pub(crate) gain: f64,
    pub(crate) bias: [f64; 3],
    /// Unit of the input in the language: none of a number, else that of the coordinate, its rate or the force.
    pub(crate) input: Quantity,
    pub(crate) input_range: Option<[f64; 2]>,
    pub(crate) force_range: Option<[f64; 2]>,
}

/// Quantity that the input of a drive sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Quantity {
    Number,
    Coordinate,
    Rate,
    Force,
}

/// The coordinate of one joint as a polynomial of another's, by rising powers.
#[derive(Clone, Debug)]
pub(crate) struct Coupling {
    pub(crate) name: String,
    pub(crate) place: Place,
    pub(crate) joint: usize,
    pub(crate) of: Option<usize>,
    pub(crate) coefficients: [f64; 5],
}

/// Springs and dampers between two frames.
#[derive(Clone, Debug)]
pub(crate) struct Tie {
    pub(crate) name: String,
    pub(crate) place: Place,
    /// Link (none is the world) and the pose of the frame in the world.
    pub(crate) ends: [(Option<usize>, Pose); 2],
    pub(crate) law: TieLaw,
}

/// The law of a tie.
#[derive(Clone, Copy, Debug)]
pub(crate) enum TieLaw {
    /// Along the line between both points.
    Spring { free_length: f64, stiffness: f64, damping: f64 },
    /// Along and about the three axes that stand halfway between both frames.
    Bushing { stiffness: Vector, damping: Vector, turning_stiffness: Vector, turning_damping: Vector },
}
