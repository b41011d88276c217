//! Stiffness and the limits of explicit steps.

use plm_runtime::linalg::Lu;
use plm_runtime::method::RadauIia5;
use plm_runtime::{Dopri5, Rk4};

use crate::scenes::indices::{A, Index, STAGES, found_orders, orders};
use crate::scenes::stiff::{bounce, growth_of_oscillation, limit, oscillator, stabilised};
use crate::text::{By as _, Named as _};

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

/// The formula that the orders are those of is what `RadauIia5` computes, by eigenvalues of the same matrix: a step of an
/// oscillator, where its Newton iteration is exact.
#[test]
fn steps_of_radau_iia_are_those_of_the_tableau() {
    const SIZE: usize = 2 * STAGES;
    // 1 kg on 1e8 N/m: x' = w v, v' = -w x with the speed over w.
    let w = 1e4;
    for wh in [0.1, 0.7, 2.0, 9.0] {
        // The tolerance lets every step pass; the first ones grow to the longest.
        let method = RadauIia5::new(1e12).with_longest_step(wh / w);
        let mut sim = oscillator().by(method).unwrap();
        sim.step(10.0 * wh / w).unwrap();
        let (before, ram) = (sim.stats().steps, sim.body_of("ram"));
        // Y_i = y + w h sum a_ij (V_j, -X_j); the last stage is the end.
        let mut matrix = [[0.0; SIZE]; SIZE];
        let mut stages = [0.0; SIZE];
        for i in 0..STAGES {
            (matrix[2 * i][2 * i], matrix[2 * i + 1][2 * i + 1]) = (1.0, 1.0);
            (stages[2 * i], stages[2 * i + 1]) = (ram.x, ram.vx / w);
            for j in 0..STAGES {
                matrix[2 * i][2 * j + 1] -= wh * A[i][j];
                matrix[2 * i + 1][2 * j] += wh * A[i][j];
            }
        }
        Lu::new(matrix, SIZE).unwrap().solve(&mut stages);
        sim.step(wh / w).unwrap();
        let ram = sim.body_of("ram");
        assert_eq!(sim.stats().steps - before, 1, "w h = {wh}");
        for (found, known) in [ram.x, ram.vx / w].iter().zip(&stages[SIZE - 2..]) {
            // From 1 mm.
            assert!((found - known).abs() < 1e-15, "w h = {wh}: {found:e} instead of {known:e}");
        }
    }
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
