//! Oscillations that theory knows, and the known values themselves beside published ones.

use std::f64::consts::FRAC_PI_2;

use crate::scenes::theory::{agm, ladder_period, laguerre_zeros, quadrorhomb, quadrorhomb_limit, sn};
use crate::scenes::{theory, trees};

#[test]
fn the_known_values_are_those_of_the_tables() {
    // Gauss, 1799: 1/AGM(1, sqrt 2).
    assert!((1.0 / agm(1.0, 2_f64.sqrt()) - 0.834_626_841_674_073_2).abs() < 1e-15);
    // Abramowitz, Stegun, table 25.9.
    let zeros =
        [0.263_560_319_718, 1.413_403_059_107, 3.596_425_771_041, 7.085_810_005_859, 12.640_800_844_276];
    for (found, known) in laguerre_zeros(5).into_iter().zip(zeros) {
        assert!((found - known).abs() < 1e-11, "{found} {known}");
    }
    // sn(u | 0) = sin u, and sn(K/2) = (1 + k')^-1/2 (the same, 16.5.1).
    assert!((sn(0.7, 0.0) - 0.7_f64.sin()).abs() < 1e-15);
    let (k, k1) = (0.8, 0.6);
    let quarter = FRAC_PI_2 / agm(1.0, k1);
    assert!((sn(0.5 * quarter, k) - 1.0 / f64::sqrt(1.0 + k1)).abs() < 1e-15);
}

#[test]
fn quadrorhombs_closed_form_is_the_published_pose() {
    let poses = quadrorhomb(0.0);
    let a = [0.4625, 0.189_983_551_919_633_3];
    assert!((poses[1][0] - 0.5 * a[0]).abs() < 1e-15 && (poses[1][1] - 0.5 * a[1]).abs() < 1e-15);
    // The tip G stands at 1.6 m, b4 ends there.
    assert!((poses[12][0] + 0.125 * poses[12][2].cos() - 1.6).abs() < 1e-14);
    assert!((quadrorhomb_limit().to_degrees() - 67.1146).abs() < 5e-5);
}

#[test]
fn a_ladder_turns_in_the_time_of_its_quadrature() {
    // theta' = sqrt(1 + 2 w^2 (1 - sin theta)) from upright all around, by equal intervals.
    let w2 = 9.81 * (1.0 + 1.0) / (2.0 / 3.0 + 1.0);
    let count = 400;
    let times = (0..count).map(|i| {
        let theta = std::f64::consts::TAU * f64::from(i) / f64::from(count);
        1.0 / (1.0 + 2.0 * w2 * (1.0 - theta.sin())).sqrt()
    });
    let turn = times.sum::<f64>() * std::f64::consts::TAU / f64::from(count);
    assert!((ladder_period(1, 1.0) - turn).abs() < 1e-13, "{turn}");
}

#[test]
fn the_time_of_a_way_is_its_integral() {
    // Abramowitz, Stegun, table 17.1: E(1/2).
    let known = 1.350_643_881_047_676;
    let found = theory::time_between([0.0, FRAC_PI_2], 1.0, 0.0, |s| 1.0 - 0.5 * s.sin().powi(2));
    assert!((found - known).abs() < 1e-13, "{found}");
    // The integral of 1/sqrt(1 + (s/d)^2) is d asinh(s/d), however small d is.
    for d in [1e-2, 1e-5, 1e-8] {
        let found = theory::time_between([-1.0, 4.0], 1.0, 0.0, |s| 1.0 / (1.0 + (s / d).powi(2)));
        let known = d * ((1.0 / d).asinh() + (4.0 / d).asinh()) * (1.0 + 1.0 / (d * d)).sqrt();
        assert!((found / known - 1.0).abs() < 1e-10, "{d:e}: {found} {known}");
    }
    // Parallel cranks: both turn, and the coupler moves in a circle.
    let known = 2.0 * (0.1 + 0.0625) + 0.25;
    assert!((theory::four_bar_inertia([0.5, 2.0, 0.5, 2.0], 1.0) - known).abs() < 1e-14);
}

#[test]
fn kapitzas_pendulum_stands_from_the_limit_of_mathieus_equation_on() {
    for a in [0.02, 0.05, 0.1] {
        let (found, known) = (trees::kapitza_limit(a).unwrap(), theory::kapitza_limit(a));
        // The trace is found to 1e-9 or better; near the limit it changes by some e^2 per unit of the ratio.
        assert!((found - known).abs() < 2e-6, "a/l = {a}: {found} {known}");
    }
}

#[test]
fn a_chain_of_points_swings_at_the_zeros_of_laguerres_polynomial() {
    for mode in 0..5 {
        // The inertia about its point lowers a frequency by less than w^2 J/(2 g m l) (Rayleigh's quotient).
        for (inertia, tolerance) in [(1e-3, 5e-3), (1e-6, 5e-6)] {
            let error = trees::frequency_error(mode, inertia).unwrap();
            assert!(error.abs() < tolerance, "mode {mode}, {inertia:e} kg m^2: {error:e}");
        }
    }
}
