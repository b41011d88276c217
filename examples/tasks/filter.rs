//! How well does a Kalman filter know place and speed of a stage in gusts, if a noisy sensor tells its place alone?
use std::error::Error;

use nalgebra::DVector;

use super::{Answer, Answers};

plm::mechanism! {
    /// A stage on springs. Gusts push it with 3 N, the sensor is wrong by 2 mm, both as standard deviations.
    pub Stage {
        /// What a motor would push with: gusts act at the same place.
        input push: N = 0 N;
        ground { port rail: (0, 0) m; }
        body stage { mass: 2 kg; inertia: 0.01 kg*m^2; port shoe: (0, 0) m; }
        prismatic rail(ground.rail, stage.shoe) { stiffness: 200 N/m; damping: 2 N*s/m; drive: push + 3 N*gusts.value; }
        noise gusts() { period: 10 ms; seed: 12345; }
        noise hiss() { period: 10 ms; seed: 67890; next: 5 ms; }
        output measured = rail.displacement + 2 mm*hiss.value;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Stage::new().start()?;
    let system = plm::linearise(&sim)?.sampled(0.01);
    let filter = system.estimator(&[("push", 3.0_f64.powi(2))], &[("measured", 2e-3_f64.powi(2))])?;
    // The covariance after the correction. The states are place and speed; the noises have none.
    let p = &filter.covariance - &filter.gains * &system.c * &filter.covariance;

    let mut x = DVector::zeros(2);
    let (mut errors, mut raw, mut last) = ([0.0; 2], 0.0, 0.0);
    for _ in 0..1500 {
        sim.step(0.01)?;
        x = &system.a * x;
        x += filter.gains.column(0) * (sim.measured() - (&system.c * &x)[0]);

        let stage = sim.stage();
        errors[0] += (x[0] - stage.x).powi(2) / 1500.0;
        errors[1] += (x[1] - stage.vx).powi(2) / 1500.0;
        raw += ((sim.measured() - last) / 0.01 - stage.vx).powi(2) / 1500.0;
        last = sim.measured();
    }
    Ok(vec![
        Answer::new("error of the place, predicted", p[(0, 0)].sqrt() * 1e3, "mm"),
        Answer::new("error of the place, found", errors[0].sqrt() * 1e3, "mm"),
        Answer::new("error of the speed, predicted", p[(1, 1)].sqrt() * 1e3, "mm/s"),
        Answer::new("error of the speed, found", errors[1].sqrt() * 1e3, "mm/s"),
        Answer::new("error of a difference quotient", raw.sqrt() * 1e3, "mm/s"),
    ])
}
