//! Bodies whose mass follows from their contour.

use std::f64::consts::{PI, TAU};

use plm::Mechanism as _;

use crate::declared::Plates;
use crate::scene::{Given as _, Named as _};

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within * known.abs().max(found.abs()), "{found} is not {known}");
}

/// Area and polar second moment of a regular polygon about its centre, from its triangles: with the angle a of one,
/// N R^2 sin(a)/2 and N R^4 sin(a) (2 + cos(a))/12.
fn polygon(corners: f64, radius: f64) -> (f64, f64) {
    let (sin, cos) = (TAU / corners).sin_cos();
    (corners * radius.powi(2) * sin / 2.0, corners * radius.powi(4) * sin * (2.0 + cos) / 12.0)
}

#[test]
fn mass_centre_and_inertia_are_those_of_the_contour() {
    let state = Plates::new().start().unwrap();
    let surface = 7850.0 * 5e-3;
    let (area, second) = polygon(48.0, 0.03);
    near(1.0 / state.value_of("disc.ax"), surface * area, 1e-13);
    near(1.0 / state.value_of("disc.alpha"), surface * second, 1e-12);
    near(state.vector_of("disc.position")[0], 0.02, 1e-13);
    near(state.vector_of("disc.position")[1], -0.01, 1e-13);
    // A disc, but for (2 pi/48)^2/6 of its area and twice that of its second moment.
    near(area, PI * 0.03 * 0.03, 0.0029);
    near(second, PI / 2.0 * 0.03_f64.powi(4), 0.0058);

    let parts = [
        (0.2 * 0.1, 0.2 * 0.1 * (0.2 * 0.2 + 0.1 * 0.1) / 12.0, [0.0, 0.0]),
        (-area, -second, [0.02, -0.01]),
        (-0.02 * 0.03, -0.02 * 0.03 * (0.02 * 0.02 + 0.03 * 0.03) / 12.0, [-0.07, 0.025]),
    ];
    let whole: f64 = parts.iter().map(|part| part.0).sum();
    let centre = [0, 1].map(|k| parts.iter().map(|part| part.0 * part.2[k]).sum::<f64>() / whole);
    let steiner = |at: [f64; 2]| (at[0] - centre[0]).powi(2) + (at[1] - centre[1]).powi(2);
    let inertia: f64 = parts.iter().map(|part| part.1 + part.0 * steiner(part.2)).sum();
    near(1.0 / state.value_of("plate.ax"), surface * whole, 1e-13);
    near(1.0 / state.value_of("plate.alpha"), surface * inertia, 1e-12);
    for k in 0..2 {
        near(state.vector_of("plate.position")[k], centre[k], 1e-12);
        near(state.vector_of("plate.corner.position")[k], [0.1, 0.05][k], 1e-12);
    }

    // A right triangle with legs 3 and 6 m: m (a^2 + b^2)/18 about its centre.
    near(1.0 / state.value_of("drawn.ax"), 90.0, 1e-13);
    near(1.0 / state.value_of("drawn.alpha"), 90.0 * 45.0 / 18.0, 1e-12);
    near(state.vector_of("drawn.position")[0], 1001.0, 1e-15);
    near(state.vector_of("drawn.position")[1], 2002.0, 1e-15);
}

#[test]
fn parameters_change_a_plate() {
    let mechanism = Plates::new().with("width", 0.4).with("density", 2700.0);
    let state = mechanism.start().unwrap();
    let (area, _) = polygon(48.0, 0.03);
    near(1.0 / state.value_of("plate.ax"), 2700.0 * 5e-3 * (0.4 * 0.1 - area - 0.02 * 0.03), 1e-13);
}
