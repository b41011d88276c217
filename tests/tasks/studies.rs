//! Tasks of design: gradients, fits, linkages, tolerances, studies, and motions from files.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, Matrix2, Vector2};

use super::{G, check};

/// Torque at the crank of a slider-crank at 37 deg by the rates of its energies: radius, length of the rod, mass of the slider, speed.
fn torque([r, l, load, speed]: [Complex<f64>; 4]) -> Complex<f64> {
    let (sin, cos) = 37_f64.to_radians().sin_cos();
    // The rod leans by b; b1, b2 are derivatives by the angle, x1, x2 those of a place along the rod, y1, y2 those of its middle.
    let sin_b = r / l * sin;
    let cos_b = (-sin_b * sin_b + 1.0).sqrt();
    let b1 = r * cos / (l * cos_b);
    let b2 = (l * sin_b * b1 * b1 - r * sin) / (l * cos_b);
    let x1 = |part: f64| -r * sin - l * part * sin_b * b1;
    let x2 = |part: f64| -r * cos - l * part * (cos_b * b1 * b1 + sin_b * b2);
    let (y1, y2) = (r * 0.5 * cos, -r * 0.5 * sin);
    let slider = load * x1(1.0) * x2(1.0);
    let rod = (x1(0.5) * x2(0.5) + y1 * y2) * 1.2 + b1 * b2 * 0.01;
    (slider + rod) * speed * speed + y1 * 1.2 * G
}

/// A step along the imaginary axis gives derivatives to rounding: W. Squire, G. Trapp, SIAM Review 40, 1998.
#[test]
fn a_press_and_its_gradient() {
    let at = [0.1, 0.4, 3.0, 300.0 * TAU / 60.0];
    let moved =
        |k: usize| torque(core::array::from_fn(|i| Complex::new(at[i], if i == k { 1e-20 } else { 0.0 })));
    let [radius, length, load, speed] = [0, 1, 2, 3].map(|k| moved(k).im / 1e-20);
    check(
        "gradients",
        &[
            ("torque", moved(0).re, 1e-10),
            ("by the radius", radius * 1e-3, 1e-10),
            ("by the length of the rod", length * 1e-3, 1e-10),
            ("by the mass of the slider", load, 1e-10),
            ("by the speed", speed * TAU / 60.0, 1e-10),
        ],
    );
}

/// After an impact the share k = (I + m l^2 cos 2a)/(I + m l^2) of the speed is left, whose square grows by c between two impacts: on the
/// cycle z = k^2 (z + c). The time is the integral of 1/speed over the lean, by Simpson's rule.
#[test]
fn a_rimless_wheel_and_its_limit_cycle() {
    let (half, slope, own, about_foot) = (PI / 8.0, 5_f64.to_radians(), 2.0 * 0.64, 0.6 + 2.0 * 0.64);
    let share = (0.6 + own * (2.0 * half).cos()) / about_foot;
    let pull = 2.0 * 2.0 * G * 0.8 / about_foot;
    let speed_on =
        |slope: f64| share * (2.0 * pull * slope.sin() * half.sin() / (1.0 - share * share)).sqrt();
    let speed = speed_on(slope);
    let slowness = |lean: f64| {
        let square = speed * speed + pull * ((slope - half).cos() - (slope + lean).cos());
        1.0 / square.sqrt()
    };
    let (parts, width) = (2000, half / 1000.0);
    let simpson = |k: i32| {
        let from = -half + width * f64::from(k);
        width / 6.0 * (slowness(from) + 4.0 * slowness(from + 0.5 * width) + slowness(from + width))
    };
    let time: f64 = (0..parts).map(simpson).sum();
    check(
        "limit_cycle",
        &[
            ("speed after an impact", speed, 1e-10),
            ("time of a step", time, 1e-10),
            ("part of a disturbance that a step leaves", share * share, 1e-9),
            ("change of the speed with the slope", 0.5 * speed / slope.tan(), 1e-9),
        ],
    );
}

/// Readings of `examples/tasks/fit.rs`, mm.
const READINGS: [f64; 20] = [
    31.9, 12.2, -10.6, -29.2, -34.2, -26.9, -8.4, 11.1, 25.7, 28.9, 21.4, 5.8, -11.1, -22.3, -24.9, -17.2,
    -3.4, 10.5, 19.6, 21.4,
];

/// The least squares of the damped oscillation in closed form, whose derivatives are differences; and what the readings were made from.
#[test]
fn a_stand_is_found_by_its_readings() {
    let place = |[stiffness, damping]: [f64; 2], time: f64| {
        let beta = 0.5 * damping / 5.0;
        let omega = f64::sqrt(stiffness / 5.0 - beta * beta);
        40.0 * f64::exp(-beta * time) * (f64::cos(omega * time) + beta / omega * f64::sin(omega * time))
    };
    let mut found = [900.0, 5.0];
    let (mut squares, mut inverse) = (0.0, Matrix2::zeros());
    for _ in 0..30 {
        let (mut normal, mut right) = (Matrix2::zeros(), Vector2::zeros());
        squares = 0.0;
        for (k, reading) in (1..).zip(READINGS) {
            let time = 0.05 * f64::from(k);
            let slope = Vector2::from([0, 1].map(|i| {
                let [mut before, mut after] = [found; 2];
                let h = 1e-5 * found[i];
                before[i] -= h;
                after[i] += h;
                (place(after, time) - place(before, time)) / (2.0 * h)
            }));
            let error = reading - place(found, time);
            normal += slope * slope.transpose();
            right += slope * error;
            squares += error * error;
        }
        inverse = normal.try_inverse().unwrap();
        let change = inverse * right;
        found = [found[0] + change[0], found[1] + change[1]];
    }
    // Of twenty readings and two unknowns.
    let error = |k: usize| (squares / 18.0 * inverse[(k, k)]).sqrt();
    assert!((found[0] - 823.0).abs() < 10.0 && (found[1] - 6.4).abs() < 0.3, "{found:?}");
    check(
        "fit",
        &[
            ("stiffness", found[0], 1e-4),
            ("damping", found[1], 1e-6),
            ("readings are off by (rms)", (squares / 20.0).sqrt(), 1e-6),
            ("standard error of the stiffness", error(0), 1e-6),
            ("standard error of the damping", error(1), 1e-6),
        ],
    );
}

/// Freudenstein's ratios by elimination, and the pointer's angle by the triangle of its pin, coupler and axle.
#[test]
fn a_linkage_through_three_points() {
    let dials = |pressure: f64| {
        [70.0 + 60.0 * (pressure - 0.25) / 0.75, 20.0 + 60.0 * (pressure.sqrt() - 0.5) / 0.5]
            .map(f64::to_radians)
    };
    let points = [0, 1, 2].map(|k| dials(0.625 - 0.375 * (PI * f64::from(2 * k + 1) / 6.0).cos()));
    let [first, second, third] = points.map(|[a, b]| [b.cos(), -a.cos(), (a - b).cos()]);
    let less = |x: [f64; 3]| [x[0] - third[0], x[1] - third[1], x[2] - third[2]];
    let ([p, q, r], [u, v, w]) = (less(first), less(second));
    let (k1, k2) = ((r * v - q * w) / (p * v - q * u), (p * w - r * u) / (p * v - q * u));
    let k3 = third[2] - k1 * third[0] - k2 * third[1];
    let (crank, rocker) = (100.0 / k1, 100.0 / k2);
    let coupler = f64::sqrt(1e4 + crank * crank + rocker * rocker - 2.0 * crank * rocker * k3);
    let error = |[angle, pointer]: [f64; 2]| {
        let (x, y) = (crank * angle.cos() - 100.0, crank * angle.sin());
        let squares = x * x + y * y;
        let corner =
            f64::acos((squares + rocker * rocker - coupler * coupler) / (2.0 * squares.sqrt() * rocker));
        let found = [y.atan2(x) + corner, y.atan2(x) - corner];
        found.map(|found| (found - pointer).abs()).into_iter().fold(f64::INFINITY, f64::min).to_degrees()
    };
    assert!(points.into_iter().all(|point| error(point) < 1e-9));
    let largest = (25..=100).map(|percent| error(dials(f64::from(percent) / 100.0))).fold(0.0, f64::max);
    check(
        "synthesis",
        &[
            ("length of the crank", crank, 1e-8),
            ("length of the coupler", coupler, 1e-8),
            ("length of the pointer", rocker, 1e-8),
            ("error at the three points", 0.0, 1e-9),
            ("greatest error between", largest, 1e-8),
        ],
    );
}

/// x = r cos a + sqrt(l^2 - (r sin a - e)^2) and its derivatives by hand.
#[test]
fn a_press_with_tolerances() {
    let (crank, rod, offset) = (40.0, 120.0, 10.0);
    let (sin, cos) = (PI / 3.0).sin_cos();
    let high = crank * sin - offset;
    let along = f64::sqrt(rod * rod - high * high);
    let slopes =
        [cos - high * sin / along, rod / along, high / along, -crank * sin - high * crank * cos / along];
    let parts: Vec<f64> =
        slopes.iter().zip([0.02, 0.05, 0.05, PI / 1800.0]).map(|(slope, off)| slope * off).collect();
    let deviations = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    check(
        "tolerances",
        &[
            ("place of the ram", crank * cos + along, 1e-9),
            ("all tolerances at their worst", parts.iter().map(|part| part.abs()).sum(), 1e-9),
            ("three deviations, by gradients", deviations, 1e-9),
            // The deviation of a thousand is right but for one part in sqrt(2000).
            ("three deviations of 1000 presses", deviations, 0.1 * deviations),
        ],
    );
}

/// The wagon on spring and damper in closed form, with the same buffers.
#[test]
fn buffers_of_a_wagon() {
    let mass = 20e3;
    let run = |stiffness: f64, damping: f64| {
        let beta = 0.5 * damping / mass;
        let gamma = Complex::new(beta * beta - stiffness / mass, 0.0).sqrt();
        let (mut force, mut stroke) = (0.0_f64, 0.0_f64);
        // It meets the buffer at 0.05 s.
        for time in (0..=187).map(|k| 2e-3 + 4e-3 * f64::from(k)) {
            let decay = 2.0 * f64::exp(-beta * time);
            let place = decay * ((gamma * time).sinh() / gamma).re;
            let speed = decay * (gamma * time).cosh().re - beta * place;
            force = force.max(stiffness * place + damping * speed);
            stroke = stroke.max(place);
        }
        [force, stroke]
    };
    let grid = (10..=25).flat_map(|k| (6..=16).map(move |c| [f64::from(k) * 20e3, f64::from(c) * 5e3]));
    let runs: Vec<[f64; 4]> =
        grid.map(|[k, c]| [[k, c], run(k, c)]).map(|[[k, c], [f, s]]| [k, c, f, s]).collect();
    let fits = runs.iter().filter(|[.., stroke]| *stroke <= 0.3);
    let [stiffness, damping, force, stroke] = *fits.min_by(|a, b| a[2].total_cmp(&b[2])).unwrap();
    // No linear spring and damper stop a speed v within s with less than 0.52 m v^2/s: J. C. Snowdon, Vibration and Shock in Damped
    // Mechanical Systems, 1968.
    assert!(force * stroke / (mass * 4.0) > 0.519);
    check(
        "sweep",
        &[
            ("buffers tried", runs.len() as f64, 0.0),
            ("stiffness of the best", stiffness / 1e3, 1e-9),
            ("its damping", damping / 1e3, 1e-9),
            ("its greatest force", force / 1e3, 1e-6),
            ("its stroke", stroke * 1e3, 1e-5),
        ],
    );
}

/// Torque is inertia times acceleration and the moment of the weight; from rest to rest the energy lifts the arm.
#[test]
fn an_arm_that_moves_by_a_file() {
    let file = include_str!("../../examples/tasks/from_file.csv");
    let numbers = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
    let rows: Vec<Vec<f64>> = file.lines().skip(1).map(numbers).collect();
    let torque =
        |row: &Vec<f64>| (0.3 + 6.0 * 0.16) * row[3].to_radians() + 6.0 * G * 0.4 * row[1].to_radians().cos();
    let most = rows.iter().max_by(|a, b| torque(a).abs().total_cmp(&torque(b).abs())).unwrap();
    let [low, high] = [&rows[0], &rows[rows.len() - 1]].map(|row| row[1].to_radians().sin());
    check(
        "from_file",
        &[
            ("rows in the file", rows.len() as f64, 0.0),
            ("greatest torque", torque(most).abs(), 1e-7),
            ("at", most[0], 1e-12),
            ("energy of the motor", 6.0 * G * 0.4 * (high - low), 1e-3),
        ],
    );
}
