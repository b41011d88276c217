//! How well does an extended Kalman filter know the swing of a load in gusts, if a sensor tells its horizontal place alone?
use plm::{Dual, Fault, Moment, Sim};

use super::{Answer, Answers};

plm::mechanism! {
    /// A load on a bar. Gusts turn it with 2 N m, the sensor is wrong by 5 mm, both as standard deviations.
    pub Swing {
        emit: step(rk4);
        gravity: 9.81 m/s^2;
        input gust: N*m = 0;
        ground { port o: (0, 0) m; }
        body load { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (0, 0.8) m; start angle: 70 deg, locked; }
        revolute hinge(ground.o, load.o) { damping: 0.1 N*m*s/rad; drive: gust; }
    }
}

const PERIOD: f32 = 0.01; // s
/// A number with its derivatives by angle, speed and gust.
type Number = Dual<f32, 3>;
/// Angle and speed with their covariance, in `f32` and without memory of their own, as on a board.
type Estimate = ([f32; 2], [[f32; 2]; 2]);

/// A period later, by a step on dual numbers; corrected by what the sensor says.
fn next(model: &mut Sim<Swing<Number>>, (x, p): Estimate, measured: f32) -> Result<Estimate, Fault> {
    let (time, held) = (model.time(), model.held());
    let numbers = |x: [f32; 2]| [0, 1].map(|k| Number::variable(x[k], k));
    model.set(time, &held, &numbers(x));
    model.input.gust = Number::variable(0.0, 2);
    model.step_rk4(Number::constant(PERIOD))?;
    let (x, f) = (model.x().map(|of| of.value), model.x().map(|of| of.tangents));
    let fp = f.map(|[a, b, _]| [a * p[0][0] + b * p[1][0], a * p[0][1] + b * p[1][1]]);
    let sum = |a: [f32; 2], b: [f32; 3], gust: f32| a[0] * b[0] + a[1] * b[1] + 4.0 * gust * b[2];
    let p = [0, 1].map(|i| f.map(|row| sum(fp[i], row, f[i][2])));
    model.set(time, &held, &numbers(x));
    let Dual { value, tangents: [h, ..] } = model.load().x;
    let (ph, size) = (p.map(|row| row[0] * h), h * p[0][0] * h + 25e-6);
    let row = |i: usize| [0, 1].map(|j| p[i][j] - ph[i] * ph[j] / size);
    Ok(([0, 1].map(|i| x[i] + ph[i] / size * (measured - value)), [0, 1].map(row)))
}

pub fn run() -> Result<Answers, Box<dyn std::error::Error>> {
    let (mut sim, mut model) = (Swing::new().start()?, Swing::<Number>::of().start()?);
    let (mut noise, mut sums) = (super::noise(1), [0.0; 3]);
    let mut estimate = ([0.9, 0.0], [[0.1, 0.0], [0.0, 1.0]]);
    for _ in 0..6000 {
        sim.input.gust = 2.0 * noise();
        sim.step(f64::from(PERIOD))?;
        estimate = next(&mut model, estimate, (sim.load().x + 5e-3 * noise()) as f32)?;
        let (x, [[aa, ab], [_, bb]]) = estimate;
        let (a, b) = (sim.load().angle as f32 - x[0], sim.load().omega as f32 - x[1]);
        let squares = [a * a, b * b, (a * a * bb - 2.0 * a * b * ab + b * b * aa) / (aa * bb - ab * ab)];
        sums = [0, 1, 2].map(|k| sums[k] + squares[k] / 6000.0);
    }
    Ok(vec![
        Answer::new("error of the angle", f64::from(sums[0]).sqrt().to_degrees(), "deg"),
        Answer::new("error of the speed", f64::from(sums[1]).sqrt().to_degrees(), "deg/s"),
        Answer::new("errors over their covariance", f64::from(sums[2]), ""),
    ])
}
