//! Covariance of estimates against their scatter over many noisy readings.

use nalgebra::DMatrix;
use plm::optimise::{ByDop853, Experiment, Fit, Identification, Unknown};

use super::identify::{PENDULUM, readings, times};
use super::{Few, mechanism};

const THROW: &str = "pub Throw {
    param g: m/s^2 = 9.81 m/s^2;
    gravity: g;
    body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; start vy: 2 m/s, locked; }
    output ball.y;
}";

/// An identification, and its readings without noise.
struct Case {
    of: Identification<Few>,
    output: &'static str,
    times: Vec<f64>,
    truth: Vec<f64>,
    /// Standard deviation of a reading.
    sigma: f64,
}

impl Case {
    /// Height, speed and gravity of a throw, in which the readings are linear.
    fn throw() -> Self {
        let (truth, times) = (mechanism(THROW), times(6, 0.1));
        let of = Identification::new(truth)
            .find(Unknown::start("ball.y"))
            .find(Unknown::start("ball.vy"))
            .find(Unknown::parameter("g"));
        let heights = readings(&truth, &["ball.y"], &times).remove(0);
        Self { of, output: "ball.y", times, truth: heights, sigma: 0.02 }
    }

    /// Length and damping of a pendulum.
    fn pendulum() -> Self {
        let (truth, times) = (mechanism(PENDULUM), times(6, 0.25));
        let of = Identification::new(truth)
            .find(Unknown::parameter("length").within(0.1, 3.0))
            .find(Unknown::parameter("damping"));
        let angles = readings(&truth, &["bob.angle"], &times).remove(0);
        Self { of, output: "bob.angle", times, truth: angles, sigma: 5e-3 }
    }

    fn fit(&self, noise: &[f64]) -> Fit<Few> {
        let noisy: Vec<f64> =
            self.truth.iter().zip(noise).map(|(own, noise)| own + self.sigma * noise).collect();
        let unit = if self.output == "ball.y" { "m" } else { "rad" };
        let experiment = Experiment::new(self.times.clone())
            .measured(self.output, unit, noisy)
            .deviation(self.output, self.sigma);
        self.of.clone().experiment(experiment).run_by(ByDop853(1e-8)).unwrap()
    }

    /// Stated covariance, and that of the estimates about the true values.
    fn scatter(&self, noises: impl Iterator<Item = Vec<f64>>) -> [DMatrix<f64>; 2] {
        let exact = self.fit(&vec![0.0; self.times.len()]);
        let value = |of: &Fit<Few>, k: usize| of.estimates[k].value;
        let size = exact.estimates.len();
        let (mut sum, mut count) = (DMatrix::zeros(size, size), 0.0);
        for noise in noises {
            let fit = self.fit(&noise);
            sum += DMatrix::from_fn(size, size, |i, k| {
                (value(&fit, i) - value(&exact, i)) * (value(&fit, k) - value(&exact, k))
            });
            count += 1.0;
        }
        [exact.covariance, sum / count]
    }
}

/// Noise of one reading at a time, to both sides and of the size by which its covariance is the identity: that of a linear estimate is
/// its covariance then, and that of another one to the second order of the noise.
#[test]
fn covariance_by_noise_of_one_reading_at_a_time() {
    for (case, most) in [(Case::throw(), 1e-6), (Case::pendulum(), 0.01)] {
        let count = case.times.len();
        let size = (count as f64).sqrt();
        let noises = (0..2 * count).map(|k| {
            let mut noise = vec![0.0; count];
            noise[k / 2] = if k % 2 == 0 { size } else { -size };
            noise
        });
        let [stated, found] = case.scatter(noises);
        for (i, k) in (0..stated.nrows()).flat_map(|i| (0..=i).map(move |k| (i, k))) {
            let scale = (stated[(i, i)] * stated[(k, k)]).sqrt();
            assert!((stated[(i, k)] - found[(i, k)]).abs() < most * scale, "{stated} {found}");
        }
    }
}
