//! Points in relative and in absolute axes: the manual's coordinate calculator PLMCALCUL, section 4.8.
//!
//! `origin` and `angle` (counter-clockwise, rad) say where the relative axes lie in the absolute ones, in both
//! directions. The manual's own formula for relative to absolute (flag 0) holds -theta: its theta is `-angle` there, and
//! `angle` in the other direction (flag 1).

use crate::scalar::Scalar;

/// The point that stands at `point` in the relative axes, in absolute axes: origin + R(angle) point, m.
pub fn to_absolute<S: Scalar>(point: [S; 2], origin: [S; 2], angle: S) -> [S; 2] {
    let [x, y] = turned(point, angle);
    [origin[0] + x, origin[1] + y]
}

/// The point that stands at `point` in absolute axes, in the relative ones: R(-angle) (point - origin), m.
pub fn to_relative<S: Scalar>(point: [S; 2], origin: [S; 2], angle: S) -> [S; 2] {
    turned([point[0] - origin[0], point[1] - origin[1]], -angle)
}

/// A vector of turned axes in those that they are turned from: R(angle) v.
pub(crate) fn turned<S: Scalar>([x, y]: [S; 2], angle: S) -> [S; 2] {
    let (s, c) = angle.sin_cos();
    [c * x - s * y, s * x + c * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The manual's figures 108 and 109, all printed digits. Its theta is -30 deg in the first case and 30 deg in the second.
    #[test]
    fn the_manuals_points_come_out() {
        let theta = core::f64::consts::FRAC_PI_6;
        let [x, y] = to_absolute([0.2, 0.1], [1.0, 0.5], theta);
        assert!((x - 1.12321).abs() < 5e-6 && (y - 0.686_603).abs() < 5e-7, "{x} {y}");
        let [x, y] = to_relative([1.5, 0.75], [1.0, 0.5], theta);
        assert!((x - 0.558_013).abs() < 5e-7 && (y + 0.03349).abs() < 5e-6, "{x} {y}");
    }

    #[test]
    fn there_and_back_is_where_it_was() {
        let [x, y] = to_relative(to_absolute([0.3, -2.0], [5.0, 7.0], 4.0), [5.0, 7.0], 4.0);
        assert!((x - 0.3_f64).abs() < 1e-14 && (y + 2.0).abs() < 1e-14, "{x} {y}");
    }
}
