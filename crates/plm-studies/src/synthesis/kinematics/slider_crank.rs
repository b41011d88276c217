//! The slider-crank by its lengths: limits, stroke, transmission angle.

use crate::synthesis::four_bar::{Image, Vector, unit};

/// Slider-crank: the crank's pivot is the origin, the slider moves along a line parallel to the x-axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderCrank {
    /// Length of the crank, m.
    pub crank: f64,
    /// Length of the rod, m.
    pub rod: f64,
    /// Height of the slider's line over the pivot, m.
    pub offset: f64,
}

/// Pose of a slider-crank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliderPose {
    /// Place of the slider along its line, m.
    pub slider: f64,
    /// Angle of the rod from the x-axis, from the crank's pin to the slider, rad.
    pub rod_angle: f64,
    /// Angle between the rod and the normal of the slider's line, 0 to pi/2, rad: the transmission angle.
    pub transmission_angle: f64,
    /// Velocity of the slider per rate of the crank, m/rad.
    pub slider_ratio: f64,
    /// Rate of the rod per rate of the crank.
    pub rod_ratio: f64,
}

impl SliderCrank {
    /// Pose at an angle of the crank from the x-axis, rad; on the right the slider lies beyond the pin in the direction of x, on the left
    /// before it. `None` where the rod does not reach.
    pub fn pose(&self, angle: f64, image: Image) -> Option<SliderPose> {
        let pin = unit(angle) * self.crank;
        let height = self.offset - pin.im;
        let along = (height.abs() <= self.rod)
            .then(|| -image.sign() * (self.rod * self.rod - height * height).sqrt())?;
        let rod = Vector::new(along, height);
        // The velocity of the pin has no other part along the rod than the slider's.
        let rod_ratio = -pin.re / rod.re;
        Some(SliderPose {
            slider: pin.re + along,
            rod_angle: rod.arg(),
            transmission_angle: (height.abs() / self.rod).acos(),
            slider_ratio: -pin.im - rod.im * rod_ratio,
            rod_ratio,
        })
    }

    /// True where the crank turns: the rod is at least as long as crank and offset together.
    pub fn turns(&self) -> bool {
        self.rod >= self.crank + self.offset.abs()
    }

    /// Dead points of the slider on the right: angles of the crank, rad, at which crank and rod are in line, with the place of the slider,
    /// m; the far one first. `None` where crank and rod do not come to lie in line.
    pub fn dead_points(&self) -> Option<[(f64, f64); 2]> {
        let (sum, difference) = (self.rod + self.crank, self.rod - self.crank);
        if difference < self.offset.abs() {
            return None;
        }
        let place = |side: f64| (side * side - self.offset * self.offset).sqrt();
        let inner = std::f64::consts::PI + (self.offset / difference).asin();
        Some([((self.offset / sum).asin(), place(sum)), (inner, place(difference))])
    }

    /// Stroke of the slider, m. `None` as for the dead points.
    pub fn stroke(&self) -> Option<f64> {
        self.dead_points().map(|[(_, far), (_, near)]| far - near)
    }

    /// Ratio of the slower to the faster stroke of a crank that turns evenly. `None` as for the dead points.
    pub fn time_ratio(&self) -> Option<f64> {
        let [(far, _), (near, _)] = self.dead_points()?;
        let way = near - far;
        let back = std::f64::consts::TAU - way;
        Some(way.max(back) / way.min(back))
    }

    /// Least transmission angle over a turn, rad. `None` where the crank does not turn.
    pub fn least_transmission_angle(&self) -> Option<f64> {
        self.turns().then(|| ((self.crank + self.offset.abs()) / self.rod).acos())
    }
}
