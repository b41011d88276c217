//! Defects: why a linkage that reaches every position is of no use all the same.

use std::f64::consts::TAU;

use super::{Class, FourBar, Image, Pose, unit, vector};

/// Why a linkage does not move through its positions as it should. Positions count from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Defect {
    /// The loop of this position does not close: it is not reached at all.
    Open {
        /// The position.
        position: usize,
    },
    /// The position lies on another circuit than the first one: the linkage has to be taken apart between them.
    Circuit {
        /// The position.
        position: usize,
    },
    /// The position lies on the circuit of the first one and on its other branch: the crank does not drive through the dead point
    /// between them.
    Branch {
        /// The position.
        position: usize,
    },
    /// A loop opens at this angle of the crank, before the position is reached from the one before it. Of a six-bar.
    Stop {
        /// The position.
        position: usize,
        /// The angle of the crank from the x-axis, rad.
        angle: f64,
    },
    /// The crank, which turns one way, meets this position before one that should come earlier.
    Order {
        /// The position.
        position: usize,
    },
    /// The crank does not turn.
    Crank {
        /// Class of the linkage, if its loop closes at all.
        class: Option<Class>,
    },
    /// The transmission angle, or what it lacks to half a turn, is below the least one that was demanded.
    Transmission {
        /// The least angle over the motion that is demanded, rad.
        angle: f64,
    },
}

/// Demands on a linkage beyond its positions.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demands {
    /// The crank turns.
    pub turns: bool,
    /// The positions come in their order while the crank turns one way.
    pub order: bool,
    /// Least transmission angle, rad: at the positions, and over the turn of a crank that has to turn.
    pub transmission: f64,
}

impl FourBar {
    /// Defects at positions, which are angles of the crank from the x-axis, rad, each with its image.
    pub fn defects(&self, positions: &[(f64, Image)], demands: &Demands) -> Vec<Defect> {
        let mut defects = Vec::new();
        let poses: Vec<Option<Pose>> =
            positions.iter().map(|&(angle, image)| self.pose_on(angle, image)).collect();
        let open = poses.iter().enumerate().filter(|(_, pose)| pose.is_none());
        defects.extend(open.map(|(position, _)| Defect::Open { position }));
        defects.extend(self.changes(positions, &poses));
        if demands.order {
            defects.extend(out_of_order(positions).map(|position| Defect::Order { position }));
        }
        let class = self.class();
        if demands.turns && !matches!(class, Some(Class::CrankRocker | Class::DoubleCrank)) {
            defects.push(Defect::Crank { class });
        }
        let angle = self.least_transmission(&poses, demands.turns);
        if angle < demands.transmission {
            defects.push(Defect::Transmission { angle });
        }
        defects
    }

    /// Positions on another circuit or branch than the first one.
    fn changes(&self, positions: &[(f64, Image)], poses: &[Option<Pose>]) -> Vec<Defect> {
        let mut known = poses.iter().enumerate().filter_map(|(k, pose)| Some((k, (*pose)?)));
        let Some((first, pose)) = known.next() else { return Vec::new() };
        let circuit = self.circuit(pose.angles);
        let change = |(position, pose): (usize, Pose)| {
            if self.circuit(pose.angles) != circuit {
                Some(Defect::Circuit { position })
            } else if positions[position].1 != positions[first].1 {
                Some(Defect::Branch { position })
            } else {
                None
            }
        };
        known.filter_map(change).collect()
    }

    /// Least transmission angle at poses, and over the turn, folded to a quarter turn, rad.
    fn least_transmission(&self, poses: &[Option<Pose>], turn: bool) -> f64 {
        let folded = |angle: f64| angle.min(std::f64::consts::PI - angle);
        let over_turn = self.transmission_extremes().filter(|_| turn).unwrap_or([TAU / 4.0; 2]);
        let at_poses = poses.iter().flatten().map(Self::transmission_angle);
        at_poses.chain(over_turn).map(folded).fold(f64::INFINITY, f64::min)
    }

    /// Image of a pose that is known by its pins.
    pub(crate) fn image_of(&self, pins: [[f64; 2]; 2]) -> Image {
        let [pin, other] = pins.map(vector);
        Image::of(((vector(self.pivots[1]) - pin).conj() * (other - pin)).im)
    }
}

/// Positions that a crank, which turns one way, meets too early. The way is that of fewer such positions.
fn out_of_order(positions: &[(f64, Image)]) -> impl Iterator<Item = usize> + use<> {
    let angles: Vec<f64> = positions.iter().map(|&(angle, _)| angle).collect();
    let found = [1.0, -1.0].map(|way| early(&angles, way));
    let [forward, backward] = found;
    if forward.len() <= backward.len() { forward } else { backward }.into_iter()
}

/// A position so near to the first one, rad, or nearer, counts as one after a whole turn: a closed path ends where it began.
const CLOSED: f64 = 0.01;

/// Positions before one that should come earlier, by the way turned since the first one.
fn early(angles: &[f64], way: f64) -> Vec<usize> {
    let Some(&first) = angles.first() else { return Vec::new() };
    let since = |angle: f64| {
        let turned = (unit(first).conj() * unit(angle)).arg() * way;
        if turned < CLOSED { turned + TAU } else { turned }
    };
    let mut farthest = 0.0;
    let mut found = Vec::new();
    for (position, &angle) in angles.iter().enumerate().skip(1) {
        let turned = since(angle);
        if turned < farthest {
            found.push(position);
        } else {
            farthest = turned;
        }
    }
    found
}
