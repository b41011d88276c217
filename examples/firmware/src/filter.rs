//! An extended Kalman filter of a load that swings, of which a sensor tells the horizontal place alone. A step of the model on dual numbers
//! gives the next estimate and the derivatives of the transition (A. Gelb, editor, Applied Optimal Estimation, MIT Press 1974, 6.1).

use plm::runtime::Mechanism;
use plm::{Dual, Fault, Moment, Real, Rk4};

plm::mechanism! {
    /// A load on a bar. Gusts turn it with 2 N m, the sensor is wrong by 5 mm, both as standard deviations.
    pub Swing {
        gravity: 9.81 m/s^2;
        emit: step(rk4);
        input gust: N*m = 0;
        ground { port o: (0, 0) m; }
        body load { mass: 2 kg; inertia: 0.1 kg*m^2; port o: (0, 0.8) m; start angle: 70 deg, locked; }
        revolute hinge(ground.o, load.o) { damping: 0.5 N*m*s/rad; drive: gust; }
    }
}

/// Time between two readings, s.
const PERIOD: f64 = 0.01;
/// Variances of gusts, N^2*m^2, and of readings, m^2.
const GUSTS: f64 = 4.0;
const SENSOR: f64 = 25e-6;
/// Readings of a load that is driven to and fro, until the same ones come again.
const READINGS: usize = 100;

/// A number with its derivatives by angle, speed and gust.
type Number<S> = Dual<S, 3>;

/// Estimate of the swing, with the model that predicts it and the readings that correct it.
pub struct Filter<S: Real> {
    model: <Swing<Number<S>> as Mechanism>::State,
    /// Angle, rad, and speed, rad/s, with their covariance.
    x: [S; 2],
    p: [[S; 2]; 2],
    readings: [S; READINGS],
    next: usize,
}

impl<S: Real> Filter<S> {
    /// # Errors
    /// If the load cannot be moved.
    pub fn new() -> Result<Self, Fault> {
        let period = S::lit(PERIOD);
        let mut load = *Swing::<S>::of().start_with(Rk4::new(period))?.state();
        let mut readings = [S::ZERO; READINGS];
        // Twenty periods of the drive, after which the start is forgotten.
        for _ in 0..20 {
            for (k, reading) in readings.iter_mut().enumerate() {
                load.input.gust = S::lit(if k < READINGS / 2 { 3.0 } else { -3.0 });
                load.step_rk4(period)?;
                *reading = load.load().x;
            }
        }
        let model = *Swing::<Number<S>>::of().start_with(Rk4::new(Number::constant(period)))?.state();
        let p = [[S::lit(0.1), S::ZERO], [S::ZERO, S::lit(1.0)]];
        Ok(Self { model, x: [S::lit(0.9), S::ZERO], p, readings, next: 0 })
    }

    /// Estimate and covariance.
    pub fn all(&self) -> [S; 6] {
        let ([angle, speed], [[aa, ab], [ba, bb]]) = (self.x, self.p);
        [angle, speed, aa, ab, ba, bb]
    }

    /// Goes on by a period, and takes the reading there.
    ///
    /// # Errors
    /// If the model cannot be moved.
    pub fn step(&mut self) -> Result<(), Fault> {
        let reading = self.readings.get(self.next).copied().unwrap_or(S::ZERO);
        self.next = (self.next + 1) % READINGS;
        self.predict()?;
        self.correct(reading);
        Ok(())
    }

    /// P <- F P F^T + G Q G^T, of the derivatives F by the state and G by the gust.
    fn predict(&mut self) -> Result<(), Fault> {
        self.put();
        self.model.input.gust = Number::variable(S::ZERO, 2);
        self.model.step_rk4(Number::constant(S::lit(PERIOD)))?;
        let [angle, speed] = *self.model.x();
        let ([f0, f1, f2], [g0, g1, g2]) = (angle.tangents, speed.tangents);
        let [[aa, ab], [ba, bb]] = self.p;
        // A row of F P.
        let row = |a: S, b: S| [a * aa + b * ba, a * ab + b * bb];
        let (f, g) = (row(f0, f1), row(g0, g1));
        let sum = |of: [S; 2], c: S, d: S, gusts: S| of[0] * c + of[1] * d + S::lit(GUSTS) * gusts;
        self.p = [
            [sum(f, f0, f1, f2 * f2), sum(f, g0, g1, f2 * g2)],
            [sum(g, f0, f1, g2 * f2), sum(g, g0, g1, g2 * g2)],
        ];
        self.x = [angle.value, speed.value];
        Ok(())
    }

    /// K = P H^T/(H P H^T + R), of the derivative H of the place by the angle.
    fn correct(&mut self, reading: S) {
        self.put();
        let Dual { value, tangents: [h, ..] } = self.model.load().x;
        let [[aa, ab], [ba, bb]] = self.p;
        let (ph, size) = ([aa * h, ba * h], h * aa * h + S::lit(SENSOR));
        let gain = [ph[0] / size, ph[1] / size];
        let gap = reading - value;
        self.x = [self.x[0] + gain[0] * gap, self.x[1] + gain[1] * gap];
        self.p = [[aa - gain[0] * ph[0], ab - gain[0] * ph[1]], [ba - gain[1] * ph[0], bb - gain[1] * ph[1]]];
    }

    /// Has the model stand at the estimate.
    fn put(&mut self) {
        let (time, held) = (self.model.time(), self.model.held());
        let [angle, speed] = self.x;
        self.model.set(time, &held, &[Number::variable(angle, 0), Number::variable(speed, 1)]);
    }
}
