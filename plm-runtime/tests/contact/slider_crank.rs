//! A slider-crank in its crank angle: crank 0.1 m with 0.02 kg m^2, rod 0.3 m with 0.5 kg, slider 2 kg.

use plm_runtime::Scalar;

const CRANK: f64 = 0.1;
const ROD: f64 = 0.3;

/// The slider's place by the crank angle: first and second derivative.
pub(crate) fn slider<T: Scalar>(phi: T) -> [T; 2] {
    let (s, c) = phi.sin_cos();
    let (r, ratio) = (T::lit(CRANK), T::lit(CRANK / ROD));
    let sin = ratio * s;
    let cos = (T::lit(1.0) - sin * sin).sqrt();
    let first = -(r * s) - r * c * sin / cos;
    let second = -(r * c) + r * s * sin / cos - r * c * (ratio * c) / (cos * cos * cos);
    [first, second]
}

/// Angular rate of the rod over that of the crank, and its derivative by the crank angle.
fn rod<T: Scalar>(phi: T) -> [T; 2] {
    let (s, c) = phi.sin_cos();
    let ratio = T::lit(CRANK / ROD);
    let sin = ratio * s;
    let cos = (T::lit(1.0) - sin * sin).sqrt();
    let turn = -(ratio * c) / cos;
    [turn, ratio * s / cos - turn * turn * sin / cos]
}

/// Reduced inertia and half its derivative by the crank angle (Eksergian).
pub(crate) fn inertia<T: Scalar>(phi: T) -> [T; 2] {
    let (s, c) = phi.sin_cos();
    let (half, own) = (T::lit(0.5), T::lit(0.5 * ROD * ROD / 12.0));
    let (half_r, rod_mass, slider_mass) = (T::lit(0.5 * CRANK), T::lit(0.5), T::lit(2.0));
    let ([x, x_rate], [turn, turn_rate]) = (slider(phi), rod(phi));
    let g = [half * x - half_r * s, half_r * c];
    let g_rate = [half * x_rate - half_r * c, -(half_r * s)];
    let mass =
        T::lit(0.02) + slider_mass * x * x + rod_mass * (g[0] * g[0] + g[1] * g[1]) + own * turn * turn;
    let rate =
        slider_mass * x * x_rate + rod_mass * (g[0] * g_rate[0] + g[1] * g_rate[1]) + own * turn * turn_rate;
    [mass, rate]
}
