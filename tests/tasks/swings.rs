//! Tasks with what walks and what swings.

use super::compass::{PAPER, SLOPE};
use super::{G, check};

/// The cycle of the paper's equations, its period of 0.734 s, and the energy that the slope gives in a step.
#[test]
fn a_compass_walks() {
    let mut x = [0.22, -0.22 - 2.0 * SLOPE, -1.1, -0.4];
    let mut period = 0.0;
    for _ in 0..40 {
        (period, x) = PAPER.walked(x);
    }
    let length = 2.0 * (0.5 * (x[0] - x[1]).abs()).sin();
    assert!((period - 0.734).abs() < 5e-4);
    check(
        "walker",
        &[
            ("time of a step", period, 5e-6),
            ("length of a step", length, 5e-6),
            ("speed", length / period, 1e-5),
            ("energy that a step loses", 20.0 * G * length * SLOPE.sin(), 1e-4),
        ],
    );
}

/// A pendulum of 5 m under a trolley that moves by the polynomial of least jerk.
struct Pendulum {
    time: f64,
}

impl Pendulum {
    /// Acceleration of the trolley.
    fn trolley(&self, t: f64) -> f64 {
        let s = t / self.time;
        6.0 / self.time.powi(2) * (60.0 * s - 180.0 * s * s + 120.0 * s * s * s)
    }

    fn rate(&self, t: f64, [angle, omega]: [f64; 2]) -> [f64; 2] {
        [omega, -(G * angle.sin() + self.trolley(t) * angle.cos()) / 5.0]
    }

    /// The method of W. Kutta, from rest to the end of the way; calls back every 10 ms.
    fn run(&self, mut seen: impl FnMut(f64, [f64; 2])) -> [f64; 2] {
        let mut x = [0.0; 2];
        let count = (self.time / 0.01).round() as u32;
        for k in 0..count {
            let (t, h) = (0.01 * f64::from(k), 0.01);
            seen(t, x);
            let at = |k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
            let a = self.rate(t, x);
            let b = self.rate(t + 0.5 * h, at(a, 0.5 * h));
            let c = self.rate(t + 0.5 * h, at(b, 0.5 * h));
            let d = self.rate(t + h, at(c, h));
            x = core::array::from_fn(|i| x[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
        }
        seen(self.time, x);
        x
    }

    /// How far it swings behind.
    fn after(&self) -> f64 {
        let [angle, omega] = self.run(|_, _| ());
        (angle.cos() - 5.0 * omega * omega / (2.0 * G)).acos()
    }
}

#[test]
fn a_load_on_a_crane() {
    let six = Pendulum { time: 6.0 };
    let (mut swing, mut rope, mut drive) = (0.0_f64, 0.0_f64, 0.0_f64);
    six.run(|t, [angle, omega]| {
        let pushed = six.trolley(t);
        let tension = 500.0 * (G * angle.cos() + 5.0 * omega * omega - pushed * angle.sin());
        swing = swing.max(angle.abs());
        rope = rope.max(tension);
        drive = drive.max((200.0 * pushed - tension * angle.sin()).abs());
    });
    let times = (70..95).map(|tenth| f64::from(tenth) * 0.1);
    let rests = times.map(|time| (time, Pendulum { time }.after()));
    let (best, rest) = rests.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
    check(
        "crane",
        &[
            ("in 6 s the load swings by", swing.to_degrees(), 1e-5),
            ("and after by", six.after().to_degrees(), 1e-5),
            ("greatest pull of the rope", rope, 1e-2),
            ("greatest force of the trolley", drive, 1e-3),
            ("it hangs still after", best, 1e-9),
            ("but for", rest.to_degrees(), 1e-5),
        ],
    );
}
