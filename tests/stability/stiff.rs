//! Stiffness and the limits of explicit steps.

use plm::{Dopri5, Rk4};

use crate::scenes::indices::{Index, found_orders, orders};
use crate::scenes::stiff::{bounce, growth_of_oscillation, limit, stabilised};

#[test]
fn an_end_stop_gives_the_speed_back() {
    let after = bounce(Dopri5::default()).unwrap();
    assert!((after + 1.0).abs() < 1e-4, "{after}");
    // Contact lasts pi sqrt(m/k) = 3.1416e-4 s: thirty steps resolve it.
    let after = bounce(Rk4::new(1e-5)).unwrap();
    assert!((after + 1.0).abs() < 1e-2, "{after}");
    // One step does not: Runge-Kutta 4 sees the stop as a random kick.
    let after = bounce(Rk4::new(4e-4)).unwrap_or(f64::INFINITY);
    assert!((after + 1.0).abs() > 0.1, "{after}");
}

#[test]
fn runge_kutta_4_needs_two_point_eight_three_over_w_on_a_spring() {
    // |R(i y)| = 1 at y = sqrt(8) (Hairer, Wanner, Solving Ordinary Differential Equations II, IV.2); w = 1e4 rad/s.
    let found = limit(2e-4, 4e-4, |h| growth_of_oscillation(h) < 2.0);
    assert!((found / 8_f64.sqrt() * 1e4 - 1.0).abs() < 2e-3, "{found:e}");
}

#[test]
fn baumgartes_gains_are_limited_by_the_step() {
    // R(z) = 1 + z + z^2/2 + z^3/6 + z^4/24 leaves [-1, 1] at z = -2.785; the pendulum is nearly at rest.
    let found = limit(2.0, 3.5, |h_alpha| stabilised(1e-3, h_alpha, 1e-4, 3000) < 1e-6);
    assert!((found / 2.785 - 1.0).abs() < 5e-3, "{found}");
}

#[test]
fn the_order_of_radau_iia_falls_with_the_index() {
    for index in [Index::One, Index::Two, Index::Three] {
        let found = found_orders(index).unwrap();
        for (found, known) in found.into_iter().zip(orders(index)) {
            assert!((found - known).abs() < 0.2, "{index:?}: {found}, known {known}");
        }
    }
}
