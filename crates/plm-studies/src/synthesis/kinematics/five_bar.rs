//! The five-bar with two driven cranks: its workspace and its singular poses.

use crate::synthesis::four_bar::{Image, Point, Vector, dyad, point, unit, vector};

/// Five-bar whose two cranks are driven: a point of two degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveBar {
    /// Pivots of the cranks, m.
    pub pivots: [Point; 2],
    /// Lengths of the cranks, m.
    pub cranks: [f64; 2],
    /// Lengths of the bars from the cranks to the common pin, m.
    pub bars: [f64; 2],
}

/// Pose of a five-bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FiveBarPose {
    /// Angles of the cranks from the x-axis, rad.
    pub cranks: [f64; 2],
    /// Common pin of the bars, m.
    pub pin: Point,
    /// Sine of the angle from each crank to its bar: zero where the pin is at a limit of its reach.
    pub reach: [f64; 2],
    /// Sine of the angle from the first bar to the second: zero where the cranks do not hold the pin.
    pub hold: f64,
}

/// Kind of a singular pose (Gosselin and Angeles, IEEE Trans. Robotics and Automation 6, 1990).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Singularity {
    /// First kind: a crank and its bar are in line, the pin is at the border of its workspace.
    Reach,
    /// Second kind: the two bars are in line, the pin moves while the cranks are locked.
    Hold,
    /// Both at once.
    Both,
}

impl FiveBarPose {
    /// Kind of singularity where a sine is at most a tolerance. `None` for a regular pose.
    pub fn singularity(&self, tolerance: f64) -> Option<Singularity> {
        let reach = self.reach.iter().any(|sine| sine.abs() <= tolerance);
        match (reach, self.hold.abs() <= tolerance) {
            (true, true) => Some(Singularity::Both),
            (true, false) => Some(Singularity::Reach),
            (false, true) => Some(Singularity::Hold),
            (false, false) => None,
        }
    }
}

impl FiveBar {
    /// Poses at angles of the cranks from the x-axis, rad: up to two.
    pub fn poses(&self, cranks: [f64; 2]) -> Vec<FiveBarPose> {
        let pins: [Vector; 2] =
            std::array::from_fn(|k| vector(self.pivots[k]) + unit(cranks[k]) * self.cranks[k]);
        let on = |image| dyad(pins[1] - pins[0], self.bars[0], self.bars[1], image);
        let bars = [Image::Left, Image::Right].into_iter().filter_map(on);
        bars.map(|bar| self.pose(cranks, pins, pins[0] + bar)).collect()
    }

    fn pose(&self, cranks: [f64; 2], pins: [Vector; 2], pin: Vector) -> FiveBarPose {
        let bars: [Vector; 2] = std::array::from_fn(|k| (pin - pins[k]) / self.bars[k]);
        let reach = std::array::from_fn(|k| (unit(cranks[k]).conj() * bars[k]).im);
        FiveBarPose { cranks, pin: point(pin), reach, hold: (bars[0].conj() * bars[1]).im }
    }

    /// Poses whose pin is at a place, m: up to four, by the image of each crank and bar. Empty outside the workspace.
    pub fn poses_at(&self, pin: Point) -> Vec<FiveBarPose> {
        let arms: [Vec<Vector>; 2] = std::array::from_fn(|k| {
            let span = vector(pin) - vector(self.pivots[k]);
            let on = |image| dyad(span, self.cranks[k], self.bars[k], image);
            [Image::Left, Image::Right].into_iter().filter_map(on).collect()
        });
        let pairs = arms[0].iter().flat_map(|&one| arms[1].iter().map(move |&other| [one, other]));
        let pose = |arms: [Vector; 2]| {
            let pins = std::array::from_fn(|k| vector(self.pivots[k]) + arms[k]);
            self.pose(arms.map(Vector::arg), pins, vector(pin))
        };
        pairs.map(pose).collect()
    }

    /// True for a place that the pin reaches, m: between the circles of least and greatest reach of both arms.
    pub fn reaches(&self, pin: Point) -> bool {
        (0..2).all(|k| {
            let distance = (vector(pin) - vector(self.pivots[k])).norm();
            let [least, most] = self.reach_circles()[k];
            (least..=most).contains(&distance)
        })
    }

    /// Radii of the circles about each pivot that bound the workspace, m: where the singularities of the first kind lie.
    pub fn reach_circles(&self) -> [[f64; 2]; 2] {
        std::array::from_fn(|k| [(self.cranks[k] - self.bars[k]).abs(), self.cranks[k] + self.bars[k]])
    }

    /// Singularities of the second kind at so many angles of the first crank: poses with both bars in line, stretched or folded. They are
    /// those of the four-bar that the two bars in line make.
    pub fn hold_singularities(&self, count: usize) -> Vec<FiveBarPose> {
        let [first, second] = self.bars;
        let mut found = Vec::new();
        for k in 0..count {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            let pin = vector(self.pivots[0]) + unit(angle) * self.cranks[0];
            let pivot = vector(self.pivots[1]);
            for (length, side) in [(first + second, 1.0), ((first - second).abs(), (first - second).signum())]
            {
                for image in [Image::Left, Image::Right] {
                    let Some(bar) = dyad(pivot - pin, length, self.cranks[1], image).filter(|_| length > 0.0)
                    else {
                        continue;
                    };
                    let other = pin + bar;
                    let common = pin + bar / length * (side * first);
                    let cranks = [angle, (other - pivot).arg()];
                    found.push(self.pose(cranks, [pin, other], common));
                }
            }
        }
        found
    }
}
