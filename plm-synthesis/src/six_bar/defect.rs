//! Defects of a six-bar between its positions.

use std::f64::consts::PI;

use super::{SixBar, SixBarPose};
use crate::four_bar::{Defect, Demands, FourBar};

/// Largest step of the crank between two looks at a motion, rad.
const STEP: f64 = PI / 180.0;

/// Halvings of the bracket of a least angle: to the rounding.
const HALVINGS: usize = 40;

impl SixBar {
    /// Defects at angles of the crank from the x-axis, rad, which the crank passes in their order, by way of all angles between.
    ///
    /// Where a loop opens between two positions, to the accuracy of looks at every degree and at the minima between them, the motion
    /// stops: another circuit or branch of any kind is behind it.
    pub fn defects(&self, angles: &[f64], demands: &Demands) -> Vec<Defect> {
        let positions: Vec<_> = angles.iter().map(|&angle| (angle, self.four_bar.image)).collect();
        let mut defects = self.four_bar.defects(&positions, demands);
        defects.retain(|defect| !matches!(defect, Defect::Open { .. } | Defect::Transmission { .. }));
        let open = angles.iter().enumerate().filter(|(_, angle)| self.pose(**angle).is_none());
        defects.extend(open.map(|(position, _)| Defect::Open { position }));
        let mut least = f64::INFINITY;
        for (position, pair) in angles.windows(2).enumerate() {
            match self.least_between(pair[0], pair[1]) {
                Ok(angle) => least = least.min(angle),
                Err(angle) => defects.push(Defect::Stop { position: position + 1, angle }),
            }
        }
        if let (true, Some(&last)) = (demands.turns, angles.last()) {
            match self.least_between(last, last + 2.0 * PI) {
                Ok(angle) => least = least.min(angle),
                Err(angle) => defects.push(Defect::Stop { position: 0, angle }),
            }
        }
        if least < demands.transmission {
            defects.push(Defect::Transmission { angle: least });
        }
        defects
    }

    /// Least transmission angle of both dyads between two angles of the crank, folded to a quarter turn, rad; the angle of the crank
    /// where a loop is open as an error.
    fn least_between(&self, from: f64, to: f64) -> Result<f64, f64> {
        let count = ((to - from).abs() / STEP).ceil().max(1.0) as usize;
        let at = |k: usize| from + (to - from) * k as f64 / count as f64;
        let look = |angle: f64| self.pose(angle).map(|pose| transmission(&pose)).ok_or(angle);
        let values = (0..=count).map(|k| look(at(k))).collect::<Result<Vec<f64>, f64>>()?;
        let mut least = values.iter().copied().fold(f64::INFINITY, f64::min);
        for k in 1..count {
            if values[k] <= values[k - 1] && values[k] <= values[k + 1] {
                least = least.min(minimum(look, at(k - 1), at(k + 1))?);
            }
        }
        Ok(least)
    }
}

/// Transmission angle of both dyads of a pose, the smaller one, folded to a quarter turn, rad.
fn transmission(pose: &SixBarPose) -> f64 {
    let folded = |angle: f64| angle.min(PI - angle);
    let [first, second] = pose.angles;
    let difference = (first - second).sin().atan2((first - second).cos()).abs();
    folded(FourBar::transmission_angle(&pose.four_bar)).min(folded(difference))
}

/// Least value between two angles with one minimum, by sections of both thirds; an angle without a value as an error.
fn minimum(of: impl Fn(f64) -> Result<f64, f64>, mut from: f64, mut to: f64) -> Result<f64, f64> {
    let mut least = f64::INFINITY;
    for _ in 0..HALVINGS {
        let third = (to - from) / 3.0;
        let [one, other] = [of(from + third)?, of(to - third)?];
        least = least.min(one).min(other);
        if one <= other {
            to -= third;
        } else {
            from += third;
        }
    }
    Ok(least)
}
