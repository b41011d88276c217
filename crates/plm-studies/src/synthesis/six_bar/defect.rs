//! Defects of a six-bar between its positions.

use std::f64::consts::PI;

use super::{Chain, SixBar, SixBarPose};
use crate::synthesis::four_bar::{Defect, Demands, FourBar, Image};

/// Largest step of the crank between two checks of a motion, rad.
const STEP: f64 = PI / 180.0;

/// Halvings of the bracket of a least angle: to the rounding.
const HALVINGS: usize = 40;

impl SixBar {
    /// Defects at angles of the crank from the x-axis, rad, which the crank passes in their order, by way of all angles between.
    ///
    /// The motion stops if a loop opens between two positions, to the accuracy of checks at every degree and at the minima between them.
    /// Positions behind are named as well: a position that the linkage reaches through dead points of its crank lies on another branch of
    /// the circuit, one that it does not reach on another circuit.
    pub fn defects(&self, angles: &[f64], demands: &Demands) -> Vec<Defect> {
        if self.chain == Chain::StephensonTwo {
            return self.moving_defects(angles, demands);
        }
        let positions: Vec<_> = angles.iter().map(|&angle| (angle, self.four_bar.image)).collect();
        let mut defects = self.four_bar.defects(&positions, demands);
        defects.retain(|defect| !matches!(defect, Defect::Open { .. } | Defect::Transmission { .. }));
        let open = angles.iter().enumerate().filter(|(_, angle)| self.pose(**angle).is_none());
        defects.extend(open.map(|(position, _)| Defect::Open { position }));
        let mut least = f64::INFINITY;
        for (before, pair) in angles.windows(2).enumerate() {
            let position = before + 1;
            match self.least_between(pair[0], pair[1]) {
                Ok(angle) => least = least.min(angle),
                Err(angle) => {
                    defects.push(Defect::Stop { position, angle });
                    let named = Defect::Circuit { position };
                    // The four-bar alone may have reported it.
                    let after = self.pose(pair[1]).filter(|_| !defects.contains(&named));
                    let name = |_| {
                        if self.reaches(pair[0], pair[1]) { Defect::Branch { position } } else { named }
                    };
                    let after = after.map(name);
                    defects.extend(after);
                }
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

/// Motion of the crank between two dead points, on images of both dyads.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    images: [Image; 2],
    from: f64,
    /// 1 or -1.
    way: f64,
}

impl SixBar {
    /// Does the linkage, moved by hand through dead points of its crank, come from one angle to another on the same images? A dyad that is
    /// stretched at a dead point goes on as its mirror image, and the crank goes back (W. L. Mirth, T. R. Chase, Mechanism and Machine
    /// Theory 28, 1993: circuits and branches of a linkage).
    fn reaches(&self, from: f64, to: f64) -> bool {
        // A circuit has a sweep on each pair of images between each two dead points, and each dyad at most two of them on each image.
        const MOST: usize = 64;

        if self.pose(from).is_none() {
            return false;
        }
        let begin = Sweep { images: [self.four_bar.image, self.image], from, way: 1.0 };
        // Both ways from the start: a circuit closes on itself, and a dead point is passed whichever way it is met.
        [1.0, -1.0].into_iter().any(|way| {
            let mut sweep = Sweep { way, ..begin };
            for _ in 0..MOST {
                let Some((end, flat)) = self.end(sweep) else {
                    // The crank turns fully.
                    return sweep.images == begin.images;
                };
                let turns = ((to - sweep.from) * sweep.way).rem_euclid(2.0 * PI);
                if sweep.images == begin.images && turns <= (end - sweep.from) * sweep.way {
                    return true;
                }
                let mut images = sweep.images;
                images[flat] = images[flat].mirrored();
                sweep = Sweep { images, from: end, way: -sweep.way };
            }
            false
        })
    }

    /// The angle of the crank at which a sweep ends, and the dyad that is flat there. `None` of a crank that turns fully.
    fn end(&self, sweep: Sweep) -> Option<(f64, usize)> {
        let four_bar = FourBar { image: sweep.images[0], ..self.four_bar };
        let dimensions = Self { four_bar, image: sweep.images[1], ..*self }.dimensions();
        let ground = four_bar.ground_angle();
        let cosines = |angle: f64| dimensions.solve(angle - ground).map(|pose| pose.cosines());
        let at = |k: usize| sweep.from + sweep.way * STEP * k as f64;
        let open = (1..=(2.0 * PI / STEP).ceil() as usize).find(|k| cosines(at(*k)).is_none())?;
        let (mut closed, mut beyond, mut last) = (at(open - 1), at(open), cosines(at(open - 1)));
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(closed, beyond);
            match cosines(middle) {
                Some(found) => (closed, last) = (middle, Some(found)),
                None => beyond = middle,
            }
        }
        // A sweep begins at a dead point, where rounding decides whether a loop closes: one of no length has the dyad of the one before.
        let [first, second] = last.map_or([1.0, 0.0], |cosines| cosines.map(f64::abs));
        Some((closed, usize::from(second > first)))
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
