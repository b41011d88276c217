//! Bodies whose mass follows from their contour.

use std::f64::consts::{PI, TAU};

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within * known.abs().max(found.abs()), "{found} is not {known}");
}

plm::mechanism! {
    pub Plates {
        allow(W0002);
        param width: m = 200 mm;
        param density: kg/m^3 = 7850 kg/m^3;
        // At the centre of gravity.
        part push(a: body) {
            force on a: (1 N, 0 N);
            torque on a: 1 N*m;
        }
        // A polygon of 48 corners, radius 30 mm, about (20, -10) mm.
        body disc { density: density; thickness: 5 mm; contour: "tests/contours/disc.csv"; start x: 0, locked; start y: 0, locked; }
        // A rectangle, drawn clockwise, with that as a hole.
        body plate {
            density: density;
            thickness: 5 mm;
            contour: (-100, -50) mm, (-100, 50) mm, (width - 0.1 m, 50 mm), (width - 0.1 m, -50 mm);
            hole: "tests/contours/disc.csv";
            hole: (-80, 10), (-60, 10), (-60, 40), (-80, 40) mm;
            port corner: (100, 50) mm;
            start x: 0, locked;
            start y: 0, locked;
        }
        // Drawn far away, in absolute axes.
        body drawn {
            coordinates: absolute;
            density: 1000 kg/m^3;
            thickness: 1 cm;
            contour: (1000, 2000), (1003, 2000), (1000, 2006) m;
        }
        push one(disc);
        push two(plate);
        push three(drawn);
        output disc.ax, disc.alpha, disc.position, plate.ax, plate.alpha, plate.position, plate.corner.position;
        output drawn.ax, drawn.alpha, drawn.position;
    }
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
    near(1.0 / state.disc_ax(), surface * area, 1e-13);
    near(1.0 / state.disc_alpha(), surface * second, 1e-12);
    near(state.disc_position()[0], 0.02, 1e-13);
    near(state.disc_position()[1], -0.01, 1e-13);
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
    near(1.0 / state.plate_ax(), surface * whole, 1e-13);
    near(1.0 / state.plate_alpha(), surface * inertia, 1e-12);
    for k in 0..2 {
        near(state.plate_position()[k], centre[k], 1e-12);
        near(state.plate_corner_position()[k], [0.1, 0.05][k], 1e-12);
    }

    // A right triangle with legs 3 and 6 m: m (a^2 + b^2)/18 about its centre.
    near(1.0 / state.drawn_ax(), 90.0, 1e-13);
    near(1.0 / state.drawn_alpha(), 90.0 * 45.0 / 18.0, 1e-12);
    near(state.drawn_position()[0], 1001.0, 1e-15);
    near(state.drawn_position()[1], 2002.0, 1e-15);
}

#[test]
fn parameters_change_a_plate() {
    let mut mechanism = Plates::new();
    (mechanism.width, mechanism.density) = (0.4, 2700.0);
    let state = mechanism.start().unwrap();
    let (area, _) = polygon(48.0, 0.03);
    near(1.0 / state.plate_ax(), 2700.0 * 5e-3 * (0.4 * 0.1 - area - 0.02 * 0.03), 1e-13);
}
