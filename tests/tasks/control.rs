//! Tasks of control.

use std::f64::consts::{PI, TAU};

use nalgebra::{Complex, Matrix2, RowVector2, Vector2};

use super::{G, check};

/// State of a cart with a pole: place, angle, and their rates.
type State = [f64; 4];

/// Lagrange's equations of a cart of 1 kg and a rod of 0.2 kg and 0.6 m.
fn rate([_, angle, v, omega]: State, push: f64) -> State {
    let (sin, cos) = angle.sin_cos();
    let [all, arm, inertia] = [1.2, 0.2 * 0.3, 0.2 * 0.36 / 3.0];
    let (f, h) = (push - arm * sin * omega * omega, arm * G * sin);
    let determinant = all * inertia - (arm * cos).powi(2);
    [v, omega, (inertia * f + arm * cos * h) / determinant, (all * h + arm * cos * f) / determinant]
}

/// The method of W. Kutta.
fn step(x: State, push: f64, h: f64) -> State {
    let at = |k: State, h: f64| -> State { core::array::from_fn(|i| x[i] + h * k[i]) };
    let a = rate(x, push);
    let b = rate(at(a, 0.5 * h), push);
    let c = rate(at(b, 0.5 * h), push);
    let d = rate(at(c, h), push);
    core::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]))
}

/// With all poles at p the characteristic polynomial of the closed loop is det (s - p)^4, whose coefficients give the gains.
#[test]
fn a_pole_on_a_cart() {
    let ([all, arm, inertia], p) = ([1.2, 0.2 * 0.3, 0.2 * 0.36 / 3.0], -4.0_f64);
    let determinant = all * inertia - arm * arm;
    let place = -determinant * p.powi(4) / (arm * G);
    let speed = 4.0 * determinant * p.powi(3) / (arm * G);
    let angle = (6.0 * determinant * p * p - place * inertia + all * arm * G) / arm;
    let omega = (-4.0 * determinant * p - speed * inertia) / arm;

    let mut x = [0.0, PI / 9.0, 0.0, 0.0];
    let (mut farthest, mut strongest, mut settled) = (0.0_f64, 0.0_f64, 0.0);
    for sample in 1..=1000 {
        let push = -(place * x[0] + angle * x[1] + speed * x[2] + omega * x[3]);
        farthest = farthest.max(x[0].abs());
        strongest = strongest.max(push.abs());
        for _ in 0..20 {
            x = step(x, push, 5e-3 / 20.0);
        }
        settled = if x[1].abs() > PI / 360.0 { f64::from(sample) * 5e-3 } else { settled };
    }
    check(
        "cart_pole",
        &[
            ("gain of the place", place, 1e-8),
            ("gain of the angle", angle, 1e-8),
            ("gain of the cart's speed", speed, 1e-8),
            ("gain of the pole's rate", omega, 1e-8),
            ("the cart goes by up to", farthest, 1e-7),
            ("the motor gives up to", strongest, 1e-6),
            ("within half a degree from", settled, 1e-9),
        ],
    );
}

/// A constant torque moves the axis by T^2/2 J and changes its speed by T/J in a sample; the controller is that of the book, line by line.
#[test]
fn an_axis_with_a_digital_controller() {
    let (inertia, period, wanted) = (0.02, 4e-3, PI / 6.0);
    let (mut angle, mut speed, mut value, mut sum, mut last) = (0.0, 0.0, 0.0, 0.0, 0.0);
    let mut held = 0.0;
    let (mut overshoot, mut settled, mut moved) = (0.0_f64, 0.0, 0.0_f64);
    for sample in 1..=500 {
        held = value;
        let torque: f64 = value - if sample > 150 { 2.0 } else { 0.0 };
        angle += period * (speed + 0.5 * period * torque / inertia);
        speed += period * torque / inertia;
        let error: f64 = wanted - angle;
        let asked: f64 = 40.0 * error + 200.0 * (sum + period * error) + 1.6 * (error - last) / period;
        value = asked.clamp(-10.0, 10.0);
        sum += if value == asked { period * error } else { 0.0 };
        last = error;
        let time = f64::from(sample) * period;
        if sample < 150 {
            overshoot = overshoot.max(-error.to_degrees());
            settled = if error.abs().to_degrees() > 0.6 { time } else { settled };
        } else {
            moved = moved.max(error.to_degrees());
        }
    }
    check(
        "pid",
        &[
            ("overshoot", overshoot, 1e-7),
            ("within 2 % from", settled, 1e-9),
            ("the load moves it by", moved, 1e-7),
            ("error after 2 s", (wanted - angle).to_degrees(), 1e-7),
            // The sample at 2 s acts from then on.
            ("torque after 2 s", held, 1e-7),
        ],
    );
}

/// The covariance of a Kalman filter, in its information form, for the sampled equations of a damped oscillator in closed form. What the
/// filter is off by in 60 s is that but for chance.
#[test]
fn a_filter_of_a_stage_in_gusts() {
    let (mass, stiffness, damping, period) = (2.0, 200.0, 2.0, 0.01);
    let beta = 0.5 * damping / mass;
    let omega = f64::sqrt(stiffness / mass - beta * beta);
    let (sin, cos) = f64::sin_cos(omega * period);
    let decay = f64::exp(-beta * period);
    let a = Matrix2::new(
        cos + beta / omega * sin,
        sin / omega,
        -stiffness / mass / omega * sin,
        cos - beta / omega * sin,
    ) * decay;
    let b = Vector2::new(1.0 - a[(0, 0)], -a[(1, 0)]) / stiffness;
    let c = RowVector2::new(1.0, 0.0);
    let pushed = b * b.transpose() * 9.0;
    let told = c.transpose() * c / 4e-6;
    let mut p = Matrix2::identity();
    for _ in 0..2000 {
        let before = a * p * a.transpose() + pushed;
        p = (before.try_inverse().unwrap() + told).try_inverse().unwrap();
    }
    let [place, speed] = [0, 1].map(|k| p[(k, k)].sqrt() * 1e3);
    let quotient = 2_f64.sqrt() * 2.0 / period;
    check(
        "filter",
        &[
            ("error of the place, predicted", place, 1e-7),
            ("error of the place, found", place, 0.1 * place),
            ("error of the speed, predicted", speed, 1e-6),
            ("error of the speed, found", speed, 0.1 * speed),
            ("error of a difference quotient", quotient, 0.05 * quotient),
        ],
    );
}

/// The equation of a pendulum and its variation by hand, in double precision, under the same gusts and readings. A filter that knows its own
/// errors has two of them over their covariance, one for each number of the state.
#[test]
fn an_extended_filter_of_a_swing() {
    let (inertia, torque, damping, period) = (0.1 + 2.0 * 0.64, 2.0 * 9.81 * 0.8, 0.1, f64::from(0.01_f32));
    let rate = |[a, w]: [f64; 2], gust: f64| [w, (gust - torque * a.sin() - damping * w) / inertia];
    let vary = |[a, _]: [f64; 2], [da, dw]: [f64; 2], dg: f64| {
        [dw, (dg - torque * a.cos() * da - damping * dw) / inertia]
    };
    let along = |x: [f64; 2], y: [f64; 2], h: f64| [x[0] + h * y[0], x[1] + h * y[1]];
    // A step of Runge and Kutta of a state and of one of its variations.
    let step = |x: [f64; 2], d: [f64; 2], gust: f64, dg: f64, h: f64| {
        let (mut k, mut l, mut sums) = ([0.0; 2], [0.0; 2], [[0.0; 2]; 2]);
        for (part, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            let (at, varied) = (along(x, k, part * h), along(d, l, part * h));
            (k, l) = (rate(at, gust), vary(at, varied, dg));
            sums = [along(sums[0], k, weight / 6.0), along(sums[1], l, weight / 6.0)];
        }
        [along(x, sums[0], h), along(d, sums[1], h)]
    };
    let (mut truth, mut x, mut p) =
        ([70_f64.to_radians(), 0.0], [0.9, 0.0], Matrix2::new(0.1, 0.0, 0.0, 1.0));
    let (mut noise, mut errors, mut consistency) = (crate::noise(1), [0.0; 2], 0.0);
    for _ in 0..6000 {
        let gust = 2.0 * noise();
        for _ in 0..4 {
            [truth, _] = step(truth, [0.0; 2], gust, 0.0, 0.25 * period);
        }
        let measured = 0.8 * truth[0].sin() + 5e-3 * noise();
        let [next, a] = step(x, [1.0, 0.0], 0.0, 0.0, period);
        let [[_, b], [_, g]] = [step(x, [0.0, 1.0], 0.0, 0.0, period), step(x, [0.0; 2], 0.0, 1.0, period)];
        let (f, g) = (Matrix2::new(a[0], b[0], a[1], b[1]), Vector2::new(g[0], g[1]));
        p = f * p * f.transpose() + g * g.transpose() * 4.0;
        let h = RowVector2::new(0.8 * next[0].cos(), 0.0);
        let gain = p * h.transpose() / ((h * p * h.transpose())[0] + 25e-6);
        let moved = gain * (measured - 0.8 * next[0].sin());
        x = along(next, [moved[0], moved[1]], 1.0);
        p -= gain * h * p;
        let e = Vector2::new(truth[0] - x[0], truth[1] - x[1]);
        errors = along(errors, [e[0] * e[0], e[1] * e[1]], 1.0 / 6000.0);
        consistency += (e.transpose() * p.try_inverse().unwrap() * e)[0] / 6000.0;
    }
    let [angle, speed] = errors.map(|square| square.sqrt().to_degrees());
    assert!((consistency - 2.0).abs() < 0.3, "{consistency}");
    check(
        "extended_filter",
        &[
            ("error of the angle", angle, 1e-3 * angle),
            ("error of the speed", speed, 1e-3 * speed),
            ("errors over their covariance", consistency, 1e-2),
        ],
    );
}

/// Speed over torque of two inertias on a spring: (J2 s^2 + d s + k)/(s (J1 J2 s^2 + (J1 + J2) (d s + k))).
#[test]
fn a_drive_with_an_elastic_coupling() {
    let (motor, load, stiffness, damping) = (0.02, 0.1, 500.0, 0.2);
    let response = |frequency: f64| {
        let s = Complex::new(0.0, TAU * frequency);
        let coupling = s * damping + stiffness;
        (s * s * load + coupling) / (s * (s * s * motor * load + coupling * (motor + load)))
    };
    let grid = (0..5000).map(|k| 1.001_f64.powi(k)).filter(|frequency| *frequency < 100.0);
    let peak = grid.max_by(|a, b| response(*a).norm().total_cmp(&response(*b).norm())).unwrap();
    let notch = f64::sqrt(stiffness / load) / TAU;
    let reduced = motor * load / (motor + load);
    check(
        "bode",
        &[
            ("gain at 1 Hz", response(1.0).norm(), 1e-9),
            ("phase at 1 Hz", response(1.0).arg().to_degrees(), 1e-7),
            ("the motor stands still at", notch, 1e-3 * notch),
            ("resonance at", peak, 1e-6),
            ("gain there", response(peak).norm(), 1e-8),
            ("damping ratio of the mode", 0.5 * damping / f64::sqrt(stiffness * reduced), 1e-9),
        ],
    );
}
