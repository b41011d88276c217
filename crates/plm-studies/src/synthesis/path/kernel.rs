//! Residuals of a coupler point and their derivatives.

use super::{Crank, Path};
use crate::synthesis::four_bar::{FourBar, Image, Vector, dyad, point, unit, vector};

/// Unknowns but for free angles of the crank: the pivot's coordinates, the angle of the ground, four numbers of the shape, the coupler
/// point, and the first angle of the crank.
pub(super) const UNKNOWNS: usize = 10;
pub(super) const GROUND_ANGLE: usize = 2;
pub(super) const SHAPE: usize = 3;
pub(super) const COUPLER_POINT: usize = 7;
pub(super) const FIRST_ANGLE: usize = 9;

pub(super) type Unknowns = [f64; UNKNOWNS];

/// Lengths by the numbers of the shape, and the reverse: a linear map for each motion of the crank.
impl Crank {
    /// Derivatives of ground, crank, coupler and rocker by the shape.
    pub(crate) fn lengths_by_shape(self) -> [[f64; 4]; 4] {
        match self {
            Self::Turns => {
                [[1.0, 0.5, 0.5, 0.0], [1.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.5, 0.5], [1.0, 0.5, 0.0, 0.5]]
            }
            Self::Any => {
                [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]
            }
        }
    }

    pub(super) fn lengths(self, unknowns: &Unknowns) -> [f64; 4] {
        self.lengths_of(&unknowns[SHAPE..COUPLER_POINT])
    }

    /// Ground, crank, coupler and rocker of the four numbers of a shape.
    pub(crate) fn lengths_of(self, shape: &[f64]) -> [f64; 4] {
        self.lengths_by_shape().map(|row| row.iter().zip(shape).map(|(a, b)| a * b).sum())
    }
}

/// Derivatives of a point by the unknowns, and by the angle of its crank.
#[derive(Clone, Copy, Debug)]
pub(super) struct Derivatives {
    pub(super) by_unknowns: [Vector; UNKNOWNS],
    pub(super) by_angle: Vector,
}

/// A linkage at which points are computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Linkage {
    crank: Crank,
    origin: Vector,
    ground: Vector,
    lengths: [f64; 4],
    coupler_point: Vector,
    image: Image,
}

impl Linkage {
    pub(super) fn new(crank: Crank, unknowns: &Unknowns, image: Image) -> Self {
        let pair = |k: usize| Vector::new(unknowns[k], unknowns[k + 1]);
        Self {
            crank,
            origin: pair(0),
            ground: unit(unknowns[GROUND_ANGLE]),
            lengths: crank.lengths(unknowns),
            coupler_point: pair(COUPLER_POINT),
            image,
        }
    }

    /// Unit vectors of crank and coupler from the line of the pivots. `None` where the loop does not close.
    pub(super) fn directions(&self, angle: f64) -> Option<[Vector; 2]> {
        let [ground, crank, coupler, rocker] = self.lengths;
        let along_crank = unit(angle);
        let bar = dyad(Vector::from(ground) - along_crank * crank, coupler, rocker, self.image)?;
        Some([along_crank, bar / coupler])
    }

    /// The coupler point at an angle of the crank from the line of the pivots.
    pub(super) fn point(&self, angle: f64) -> Option<Vector> {
        let [crank, coupler] = self.directions(angle)?;
        Some(self.origin + self.ground * (crank * self.lengths[1] + self.coupler_point * coupler))
    }

    /// The coupler point with its derivatives. With the unit vectors e2, e3, e4 of crank, coupler and rocker, the closure `r2 e2 + r3 e3 =
    /// r1 + r4 e4` gives the derivative of the coupler's angle: its part along e4 has no share of the rocker's angle.
    pub(super) fn differentiated(&self, angle: f64) -> Option<(Vector, Derivatives)> {
        let [e2, e3] = self.directions(angle)?;
        let [r1, r2, r3, r4] = self.lengths;
        let i = Vector::new(0.0, 1.0);
        let e4 = (e2 * r2 + e3 * r3 - r1) / r4;
        let denominator = -r3 * (e4.conj() * e3).im;
        if denominator == 0.0 {
            return None;
        }
        let turn_by_lengths =
            [e4.re, -(e4.conj() * e2).re, -(e4.conj() * e3).re, 1.0].map(|share| share / denominator);
        let turn_by_angle = r2 * (e4.conj() * e2).im / denominator;
        let arm = self.coupler_point * e3;
        let local = e2 * r2 + arm;
        let by_length = |k: usize| {
            let direct = if k == 1 { e2 } else { Vector::from(0.0) };
            self.ground * (direct + i * arm * turn_by_lengths[k])
        };
        let by_lengths = [0, 1, 2, 3].map(by_length);
        let by_angle = self.ground * (i * e2 * r2 + i * arm * turn_by_angle);
        let map = self.crank.lengths_by_shape();
        let by_shape = |n: usize| (0..4).map(|k| by_lengths[k] * map[k][n]).sum::<Vector>();
        let along = self.ground * e3;
        let by_unknowns = [
            Vector::from(1.0),
            i,
            i * self.ground * local,
            by_shape(0),
            by_shape(1),
            by_shape(2),
            by_shape(3),
            along,
            i * along,
            by_angle,
        ];
        Some((self.origin + self.ground * local, Derivatives { by_unknowns, by_angle }))
    }
}

/// The linkage of unknowns, with lengths inside their bounds.
pub(super) fn four_bar(path: &Path, unknowns: &Unknowns, image: Image) -> FourBar {
    let lengths = path.crank.lengths(unknowns);
    let [ground, crank, coupler, rocker] =
        std::array::from_fn(|k| lengths[k].clamp(path.bounds.lengths[k][0], path.bounds.lengths[k][1]));
    let pivot = [unknowns[0], unknowns[1]];
    let other = point(vector(pivot) + unit(unknowns[GROUND_ANGLE]) * ground);
    FourBar {
        pivots: [pivot, other],
        crank,
        coupler,
        rocker,
        point: [unknowns[COUPLER_POINT], unknowns[COUPLER_POINT + 1]],
        image,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_differences() {
        let unknowns: Unknowns = [0.3, -0.2, 0.4, 0.5, 0.3, 0.7, 0.4, 0.6, 0.25, 0.0];
        for crank in [Crank::Turns, Crank::Any] {
            for image in [Image::Left, Image::Right] {
                let point = |x: &Unknowns| Linkage::new(crank, x, image).point(1.1 + x[FIRST_ANGLE]).unwrap();
                let (value, derivatives) = Linkage::new(crank, &unknowns, image).differentiated(1.1).unwrap();
                assert_eq!(value, point(&unknowns));
                assert_eq!(derivatives.by_angle, derivatives.by_unknowns[FIRST_ANGLE]);
                for (k, exact) in derivatives.by_unknowns.into_iter().enumerate() {
                    let beside = |h: f64| {
                        let mut x = unknowns;
                        x[k] += h;
                        point(&x)
                    };
                    let h = 1e-5;
                    let difference = (beside(h) - beside(-h)) / (2.0 * h);
                    assert!((difference - exact).norm() < 1e-8, "{k} {difference} {exact}");
                }
            }
        }
    }
}
