//! Tasks of machines: engine, loader, brakes and a lamp.

use std::f64::consts::{PI, TAU};

use super::{G, check};

/// Energy of a crank at an angle: that of its start, the areas below the polytropes of the indicator diagram, less the load's.
#[test]
fn an_engine() {
    let (r, l, n) = (0.04, 0.14, 1.3);
    let area = PI / 4.0 * 0.08 * 0.08;
    let (least, most) = (50e-6, 50e-6 + 2.0 * r * area);
    // Work of a polytrope that has a pressure at the least volume, between two volumes; the crankcase presses against it.
    let work = |pressure: f64, from: f64, to: f64| {
        let polytrope = |volume: f64| (volume / least).powf(1.0 - n);
        pressure * least / (n - 1.0) * (polytrope(from) - polytrope(to)) - 1e5 * (to - from)
    };
    let cycle = work(60e5, least, most) + work(16e5, most, least);
    let load = cycle / (4.0 * PI);
    // Of all bodies, and the volume, at an angle of the crank.
    let inertia = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let lean = (r / l * sin).asin();
        let rod = r * cos / (l * lean.cos());
        let piston = -r * sin - l * lean.sin() * rod;
        let middle = [-r * sin - 0.04 * lean.sin() * rod, r * cos - 0.04 * lean.cos() * rod];
        0.15 + 0.5 * (middle[0].powi(2) + middle[1].powi(2)) + 1.5e-3 * rod * rod + 0.4 * piston * piston
    };
    let volume =
        |angle: f64| least + area * (r + l - r * angle.cos() - (l * l - (r * angle.sin()).powi(2)).sqrt());
    let start = 0.5 * inertia(0.0) * (3000.0 * TAU / 60.0_f64).powi(2);
    let speed = |angle: f64| {
        let done = match angle {
            angle if angle < PI => work(60e5, least, volume(angle)),
            angle if angle < 3.0 * PI => work(60e5, least, most),
            angle => work(60e5, least, most) + work(16e5, most, volume(angle)),
        };
        (2.0 * (start + done - load * angle) / inertia(angle)).sqrt() * 60.0 / TAU
    };
    let speeds: Vec<f64> = (0..=100_000).map(|k| speed(4.0 * PI * f64::from(k) / 1e5)).collect();
    // Samples of 10 us are at most 1.6 mrad beside an extremum.
    check(
        "engine",
        &[
            ("work of a cycle", cycle, 1e-6),
            ("load that it carries", load, 1e-7),
            ("lowest speed", speeds.iter().copied().fold(f64::INFINITY, f64::min), 1e-2),
            ("highest speed", speeds.iter().copied().fold(0.0, f64::max), 1e-2),
        ],
    );
}

/// One freedom and one pressure: the boom's angle with the energies of all bodies, and the oil's volume, by the method of Runge and Kutta.
#[test]
fn a_loader() {
    let area = PI / 4.0 * 0.08 * 0.08;
    let inertia = (250.0 + 40.0) * (1.2 * 1.2 + 2.4 * 2.4 / 12.0) + 900.0 * 2.4 * 2.4;
    let weight = G * ((250.0 + 40.0) * 1.2 + 900.0 * 2.4);
    // Length of the cylinder, and its derivative by the angle.
    let cylinder = |angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (cos + 0.1 * sin - 0.4, 1.5 + sin - 0.1 * cos - 0.7);
        let length = x.hypot(y);
        [length, (x * (-sin + 0.1 * cos) + y * (cos + 0.1 * sin)) / length]
    };
    // Of the pump, which runs up and down in half a second.
    let flow = |t: f64| 20e-6 * 25.0 * f64::min(2.0 * t, 9.0 - 2.0 * t).clamp(0.0, 1.0);
    let rate = |t: f64, [angle, speed, pressure]: [f64; 3]| {
        let [length, slope] = cylinder(angle);
        let volume = 1e-3 + area * (length - 0.5);
        let push = pressure * area - 20e3 * slope * speed;
        let squeezed = 17000e5 / volume * (flow(t) - area * slope * speed);
        [speed, (push * slope - weight * angle.cos()) / inertia, squeezed]
    };
    let step = 2.5e-4;
    let mut state = [-25_f64.to_radians(), 0.0, 50e5];
    let mut highest = 50e5_f64;
    for k in 0..40_000 {
        let t = step * f64::from(k);
        let add = |by: f64, rate: [f64; 3]| [0, 1, 2].map(|i| state[i] + by * rate[i]);
        let k1 = rate(t, state);
        let k2 = rate(t + 0.5 * step, add(0.5 * step, k1));
        let k3 = rate(t + 0.5 * step, add(0.5 * step, k2));
        let k4 = rate(t + step, add(step, k3));
        state = [0, 1, 2].map(|i| state[i] + step / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
        // As often as the task looks.
        if k % 4 == 3 {
            highest = highest.max(state[2]);
        }
    }
    let lifted = 2.4 * (state[0].sin() + 25_f64.to_radians().sin());
    check(
        "bucket",
        &[
            ("highest pressure", highest / 1e5, 1e-4),
            ("pressure that holds it at the top", state[2] / 1e5, 1e-4),
            ("lifted by", lifted, 1e-7),
            ("stroke of the cylinder at the top", 1000.0 * (cylinder(state[0])[0] - 0.5), 1e-4),
        ],
    );
}

/// J omega/C of a disc; long shoes of a drum by J. E. Shigley, C. R. Mischke, Mechanical Engineering Design, with integrals by
/// Simpson's rule.
#[test]
fn brakes() {
    let (inertia, speed, force, mu) = (4.0, 1500.0 * TAU / 60.0, 2000.0, 0.35);
    let disc = 2.0 * mu * 0.11 * force;
    let heat = 0.5 * inertia * speed * speed;
    let (begin, end) = (20_f64.to_radians(), 130_f64.to_radians());
    let integral = |f: &dyn Fn(f64) -> f64| {
        let (n, width) = (1000, (end - begin) / 1000.0);
        let weight = |k: i32| if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
        (0..=n).map(|k| weight(k) * f(begin + width * f64::from(k))).sum::<f64>() * width / 3.0
    };
    let normal = 0.12 * integral(&|angle| angle.sin().powi(2));
    let rubbing = mu * integral(&|angle| angle.sin() * (0.15 - 0.12 * angle.cos()));
    let lining = mu * 0.15 * integral(&f64::sin) * 0.22 * force;
    let drum = lining / (normal - rubbing) + lining / (normal + rubbing);
    check(
        "brake",
        &[
            ("the disc brake stops after", inertia * speed / disc, 1e-9),
            ("turns until then", heat / disc / TAU, 1e-9),
            ("heat", heat, 1e-6),
            ("the disc gets warmer by", heat / (3.0 * 470.0), 1e-9),
            ("torque of the drum brake", drum, 1e-6),
            ("the drum brake stops after", inertia * speed / drum, 1e-9),
        ],
    );
}

/// With k h s = g sum(m l) a spring of no free length balances at every angle; 0.1 kg more have their weight on both levers.
#[test]
fn a_lamp() {
    let more = 0.1 * G * 0.4;
    check(
        "lamp",
        &[
            ("largest torque of four positions", 0.0, 1e-9),
            ("foot, with a bulb of 0.4 kg", more * 60_f64.to_radians().cos(), 1e-9),
            ("elbow, with a bulb of 0.4 kg", more * 20_f64.to_radians().cos(), 1e-9),
        ],
    );
}
