//! Scatter of estimates over thousands of noisy readings beside the covariance that one fit states.

use std::error::Error;

use plm::Mechanism;
use plm::dynamic::{Compiled, Dynamic};
use plm::optimise::{ByDop853, Experiment, Fit, Identification, Unknown};

/// A mechanism of few bodies.
type Few = Dynamic<f64, 9, 8, 32, 9>;

/// A throw, whose height is linear in the unknowns, and a pendulum.
const CASES: [Case; 2] = [
    Case {
        text: "pub Throw {
            param g: m/s^2 = 9.81 m/s^2;
            gravity: g;
            body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; start vy: 2 m/s, locked; }
            output ball.y;
        }",
        output: ("ball.y", "m"),
        unknowns: &["ball.y", "ball.vy", "g"],
        every: 0.1,
        sigma: 0.02,
    },
    Case {
        text: "pub Pendulum {
            param length: m = 1 m;
            param damping: N*m*s/rad = 0.2 N*m*s/rad;
            gravity: 9.81 m/s^2;
            ground { port o: (0, 0) m; }
            body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0 m, length); start angle: 60 deg, locked; start omega: 0 rad/s, locked; }
            revolute hinge(ground.o, bob.pivot) { damping: damping; }
            output bob.angle;
        }",
        output: ("bob.angle", "rad"),
        unknowns: &["length", "damping"],
        every: 0.25,
        sigma: 5e-3,
    },
];

struct Case {
    text: &'static str,
    output: (&'static str, &'static str),
    /// Those with a point are start values.
    unknowns: &'static [&'static str],
    /// Between readings, s.
    every: f64,
    /// Standard deviation of a reading.
    sigma: f64,
}

/// Readings of a run.
const READINGS: usize = 12;

impl Case {
    fn fit(&self, own: &Few, readings: Vec<f64>) -> Result<Fit<Few>, Box<dyn Error>> {
        let (name, unit) = self.output;
        let times: Vec<f64> = (0..READINGS).map(|k| k as f64 * self.every).collect();
        let experiment = Experiment::new(times).measured(name, unit, readings).deviation(name, self.sigma);
        let of = self.unknowns.iter().fold(Identification::new(*own), |of, name| {
            of.find(if name.contains('.') { Unknown::start(*name) } else { Unknown::parameter(*name) })
        });
        Ok(of.experiment(experiment).run_by(ByDop853(1e-9))?)
    }

    /// Lines with the standard deviation of each unknown as it is stated, and that of so many fits.
    fn lines(&self, count: usize) -> Result<String, Box<dyn Error>> {
        let own: Few = Compiled::new("scatter", self.text)?.mechanism()?;
        let mut sim = own.start()?;
        let mut truth = Vec::new();
        for k in 0..READINGS {
            sim.step_to(k as f64 * self.every)?;
            truth.push(sim.output(0).ok_or("there is no output")?);
        }
        let exact = self.fit(&own, truth.clone())?;
        let mut draw = normal(0x2545_f491_4f6c_dd1d);
        let mut squares = vec![0.0; self.unknowns.len()];
        for _ in 0..count {
            let noisy = truth.iter().map(|own| own + self.sigma * draw()).collect();
            let fit = self.fit(&own, noisy)?;
            for (square, (found, exact)) in squares.iter_mut().zip(fit.estimates.iter().zip(&exact.estimates))
            {
                *square += (found.value - exact.value).powi(2);
            }
        }
        let line = |(estimate, square): (&plm::optimise::Estimate, &f64)| {
            let found = (square / count as f64).sqrt();
            let stated = estimate.standard_error;
            let off = 100.0 * (found / stated - 1.0);
            format!("{}: {stated:.4e} stated, {found:.4e} of {count} fits, {off:+.2} %\n", estimate.name)
        };
        Ok(exact.estimates.iter().zip(&squares).map(line).collect())
    }
}

/// What the fits of all cases say.
pub fn report(count: usize) -> Result<String, Box<dyn Error>> {
    CASES.iter().map(|case| case.lines(count)).collect()
}

/// Normal numbers by the polar method of Marsaglia, of a xorshift generator.
fn normal(mut state: u64) -> impl FnMut() -> f64 {
    let mut uniform = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    };
    move || loop {
        let (a, b) = (uniform(), uniform());
        let square = a * a + b * b;
        if square > 0.0 && square < 1.0 {
            return a * (-2.0 * square.ln() / square).sqrt();
        }
    }
}
