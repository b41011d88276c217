//! Grashof's classes, limits of crank and rocker, extremes of the transmission angle: closed forms of the lengths.

use std::f64::consts::PI;

use super::{FourBar, unit};

/// Kind of motion of a four-bar by Grashof's rule: the shortest and the longest link together against the two others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// The crank is the shortest link and turns; the rocker swings.
    CrankRocker,
    /// The rocker is the shortest link and turns; the crank swings.
    RockerCrank,
    /// The ground is the shortest link; crank and rocker turn.
    DoubleCrank,
    /// The coupler is the shortest link and turns; crank and rocker swing.
    DoubleRocker,
    /// No link turns: the shortest and the longest link are longer than the two others.
    TripleRocker,
    /// The sums are equal: the links can come to lie in one line.
    ChangePoint,
}

/// Range of the angle between a link and the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limits {
    /// The link turns without a limit.
    Turns,
    /// The link swings through the direction of the ground: the angle stays within ± this angle, rad.
    Around(f64),
    /// The link swings through the opposite direction: from this angle to a revolution less it, rad.
    Opposite(f64),
    /// One of two ranges, mirror images: from the first to the second angle, or the negative ones, rad.
    Between(f64, f64),
}

impl Limits {
    /// First and last angle, rad; of two ranges the positive one.
    pub fn range(self) -> (f64, f64) {
        match self {
            Self::Turns => (0.0, 2.0 * PI),
            Self::Around(angle) => (-angle, angle),
            Self::Opposite(angle) => (angle, 2.0 * PI - angle),
            Self::Between(from, to) => (from, to),
        }
    }

    /// Dead points: the angles at which the links beyond are in line, rad.
    pub fn dead_points(self) -> Vec<f64> {
        match self {
            Self::Turns => Vec::new(),
            Self::Around(angle) | Self::Opposite(angle) => vec![-angle, angle],
            Self::Between(from, to) => vec![-to, -from, from, to],
        }
    }
}

/// Limits of a link at the ground by the law of cosines: the two others reach from the difference to the sum of their lengths.
/// `None` where the loop closes at no angle.
fn limits(ground: f64, link: f64, others: [f64; 2]) -> Option<Limits> {
    let squares = ground * ground + link * link;
    let cosine = |side: f64| (squares - side * side) / (2.0 * ground * link);
    let [most, least] = [cosine((others[0] - others[1]).abs()), cosine(others[0] + others[1])];
    if most < -1.0 || least > 1.0 {
        return None;
    }
    // Of equal lengths rounding decides nothing.
    let one = 1.0 - 16.0 * f64::EPSILON;
    Some(match (most >= one, least <= -one) {
        (true, true) => Limits::Turns,
        (true, false) => Limits::Around(least.acos()),
        (false, true) => Limits::Opposite(most.acos()),
        (false, false) => Limits::Between(most.acos(), least.acos()),
    })
}

impl FourBar {
    /// Class by Grashof's rule. `None` where one link is longer than the three others, so that the loop never closes.
    pub fn class(&self) -> Option<Class> {
        let lengths = self.lengths();
        let sum: f64 = lengths.iter().sum();
        let longest = lengths.iter().copied().fold(0.0, f64::max);
        let shortest = lengths.iter().copied().fold(f64::INFINITY, f64::min);
        if longest > sum - longest {
            return None;
        }
        // Shortest and longest against the two others; the rounding of the sums counts as equal.
        let excess = 2.0 * (shortest + longest) - sum;
        Some(if excess.abs() <= 8.0 * f64::EPSILON * sum {
            Class::ChangePoint
        } else if excess > 0.0 {
            Class::TripleRocker
        } else {
            match lengths.iter().position(|&length| length == shortest) {
                Some(0) => Class::DoubleCrank,
                Some(1) => Class::CrankRocker,
                Some(2) => Class::DoubleRocker,
                _ => Class::RockerCrank,
            }
        })
    }

    /// Limits of the crank: of the angle from the line of the pivots to the crank. `None` where the loop closes at no angle.
    pub fn crank_limits(&self) -> Option<Limits> {
        let [ground, crank, coupler, rocker] = self.lengths();
        limits(ground, crank, [coupler, rocker])
    }

    /// Limits of the rocker: of the angle from the line from its pivot to the crank's pivot to the rocker. A crank and a coupler in line
    /// are dead points of the rocker, which a rocker that drives cannot leave. `None` where the loop closes at no angle.
    pub fn rocker_limits(&self) -> Option<Limits> {
        let [ground, crank, coupler, rocker] = self.lengths();
        limits(ground, rocker, [coupler, crank])
    }

    /// Least and largest transmission angle over all angles of the crank, rad: 0 or pi where the crank has a dead point. `None` where
    /// the loop closes at no angle.
    pub fn transmission_extremes(&self) -> Option<[f64; 2]> {
        self.class()?;
        let [ground, crank, coupler, rocker] = self.lengths();
        let angle = |side: f64| {
            let cosine = (coupler * coupler + rocker * rocker - side * side) / (2.0 * coupler * rocker);
            cosine.clamp(-1.0, 1.0).acos()
        };
        Some([angle((ground - crank).abs()), angle(ground + crank)])
    }

    /// Circuit of a pose: linkages of Grashof's classes have two, which no motion connects. The sign of the angle between the two links
    /// at a joint that is not at the shortest link; `None` where there is one circuit alone (Chase and Mirth, 1993).
    pub(crate) fn circuit(&self, angles: [f64; 3]) -> Option<bool> {
        let [crank, coupler, rocker] = angles;
        let turned = |from: f64, to: f64| (unit(from).conj() * unit(to)).im > 0.0;
        match self.class()? {
            Class::CrankRocker | Class::DoubleCrank => Some(turned(coupler, rocker)),
            Class::DoubleRocker | Class::RockerCrank => Some(turned(self.ground_angle(), crank)),
            Class::TripleRocker | Class::ChangePoint => None,
        }
    }
}
