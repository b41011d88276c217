//! The motion by its Taylor series, one after the other, in absolute coordinates.
//!
//! The equations are solved at accepted states only. So a pose in which the rank falls is passed by analytic continuation,
//! if no state lies next to it; a near miss is a pair of poles beside the real axis, and steps are as short as it asks for.
//! Step lengths as in Jorba, Zou (2005), section 3.2.

use super::dd::{Dd, Sum, horner, horner_rate, summed};
use super::linear::Factor;
use super::model::Model;

/// How exact a run is.
#[derive(Clone, Copy, Debug)]
pub struct Accuracy {
    /// Order of the series.
    pub order: usize,
    /// Bound of its last two terms, as a fraction of the size.
    pub tolerance: f64,
}

/// Why a reference has no motion to show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stop {
    /// The joints cannot be closed from the start values.
    Open,
    /// Steps become too short or too many.
    Creeps { time: f64 },
}

/// No motion needs more steps than this in a run that is worth comparing.
const MOST_STEPS: usize = 20_000;
/// A state lies at least so much of a step away from a pose in which the rank falls.
const CLEAR: f64 = 0.3;
/// Projections of a state: each doubles the digits.
const PROJECTIONS: usize = 3;

/// A motion while it is followed.
pub struct Motion {
    pub model: Model,
    accuracy: Accuracy,
    /// Time, s; in whole steps.
    pub time: Dd,
    pub q: Vec<Dd>,
    pub v: Vec<Dd>,
    /// Series of the coordinates from `begin` on.
    series: Vec<Vec<Dd>>,
    begin: Dd,
    pub steps: usize,
}

impl Motion {
    pub fn new(model: Model, accuracy: Accuracy, q: Vec<Dd>, v: Vec<Dd>) -> Self {
        let series = q.iter().map(|_| vec![Dd::ZERO; accuracy.order + 1]).collect();
        let mut motion = Self { model, accuracy, time: Dd::ZERO, q, v, series, begin: Dd::ZERO, steps: 0 };
        motion.model.tape.reserve(accuracy.order);
        motion
    }

    /// Follows the motion to `end`; `observe` sees each step with its end, s.
    ///
    /// # Errors
    /// [`Stop::Creeps`] if steps become too short or too many.
    pub fn advance(&mut self, end: f64, mut observe: impl FnMut(&Self, f64)) -> Result<(), Stop> {
        while self.time.hi < end {
            self.expand();
            let stop = self.model.next_knot(self.time.hi, end);
            let left = (Dd::from(stop) - self.time).hi;
            let mut h = self.length();
            if h < left {
                // Two halves rather than a whole and a splinter.
                h = self.clear(if h > 0.5 * left { 0.5 * left } else { h }, left);
            }
            self.steps += 1;
            if !(h > 1e-14 * end) || self.steps > MOST_STEPS {
                return Err(Stop::Creeps { time: self.time.hi });
            }
            self.begin = self.time;
            let (to, step) = if h < left {
                (self.time + Dd::from(h), Dd::from(h))
            } else {
                (Dd::from(stop), Dd::from(stop) - self.time)
            };
            observe(self, to.hi);
            (self.q, self.v) = self.at_step(step);
            self.time = to;
            self.project();
        }
        Ok(())
    }

    /// Place and velocity at a time within the present step.
    pub fn at(&self, time: f64) -> (Vec<Dd>, Vec<Dd>) {
        self.at_step(Dd::from(time) - self.begin)
    }

    fn at_step(&self, h: Dd) -> (Vec<Dd>, Vec<Dd>) {
        (
            self.series.iter().map(|s| horner(s, h)).collect(),
            self.series.iter().map(|s| horner_rate(s, h)).collect(),
        )
    }

    /// The series from the present state on.
    fn expand(&mut self) {
        let (order, n) = (self.accuracy.order, self.q.len());
        for i in 0..n {
            self.series[i].fill(Dd::ZERO);
            (self.series[i][0], self.series[i][1]) = (self.q[i], self.v[i]);
        }
        self.model.tape.evaluate(0, &self.series);
        self.model.tape.evaluate(1, &self.series);
        let first = self.model.derivatives();
        let factor = Factor::new(&first, &self.model.inverse);
        let mut multipliers: Vec<Vec<Dd>> = vec![Vec::with_capacity(order); first.len()];
        let mut forces = vec![Dd::ZERO; n];
        for k in 0..=order - 2 {
            self.model.tape.evaluate(k + 2, &self.series);
            self.model.applied(self.time, k, &mut forces);
            self.react(&multipliers, k, &mut forces);
            let scale = Dd::from(((k + 1) * (k + 2)) as f64);
            let per_scale = Dd::ONE / scale;
            let (inverse, tape) = (&self.model.inverse, &self.model.tape);
            let free: Vec<Dd> =
                forces.iter().zip(inverse).map(|(force, inverse)| *force * *inverse).collect();
            let mut r: Vec<Dd> = (self.model.rows.iter().zip(&first))
                .map(|(row, of)| {
                    let start = Sum::from(Dd::ZERO).plus(scale, tape.series[row.residual][k + 2]);
                    of.iter().fold(start, |sum, (i, entry)| sum.plus(*entry, free[*i])).value()
                })
                .collect();
            factor.solve(&mut r);
            for ((row, of), kept) in r.iter().zip(&first).zip(&mut multipliers) {
                for (i, entry) in of {
                    forces[*i] -= *entry * *row;
                }
                kept.push(*row);
            }
            for i in 0..n {
                self.series[i][k + 2] = forces[i] * self.model.inverse[i] * per_scale;
            }
            self.model.tape.correct(k + 2, &self.series);
        }
    }

    /// Takes off what the multipliers found so far do in order `k`.
    fn react(&self, multipliers: &[Vec<Dd>], k: usize, forces: &mut [Dd]) {
        for (row, lambda) in self.model.rows.iter().zip(multipliers) {
            for (index, entry) in &row.entries {
                let super::model::Entry::Node(node) = entry else { continue };
                let series = &self.model.tape.series[*node];
                let products = series[1..=k].iter().copied().zip(lambda[..k].iter().rev().copied());
                forces[*index] -= summed(Dd::ZERO, products);
            }
        }
    }

    /// How far the series holds.
    fn length(&self) -> f64 {
        let Accuracy { order, tolerance } = self.accuracy;
        let mut h = f64::INFINITY;
        for k in [order - 1, order] {
            let mut largest = 0.0_f64;
            for (i, series) in self.series.iter().enumerate() {
                let size = if i % 3 == 2 { 1.0 } else { self.model.size };
                largest = largest.max(series[k].hi.abs() / size);
            }
            // The rate loses a factor of the order over the step.
            h = h.min((tolerance / largest).powf(1.0 / k as f64));
        }
        h
    }

    /// A step like `h` that does not end next to a pose in which the rank falls.
    fn clear(&mut self, h: f64, left: f64) -> f64 {
        const APART: f64 = 1e-3;
        let mut health = |h: f64| {
            let (q, _) = self.at_step(Dd::from(h));
            self.model.pose(&q);
            Factor::new(&self.model.derivatives(), &self.model.inverse).least
        };
        let slope = (health(h) / health(h * (1.0 - APART))).ln() / (h * APART);
        // The pivot goes with the square of the distance in time.
        let distance = 2.0 / slope;
        let flat = h - distance;
        let shorter = if distance.abs() < CLEAR * h && flat > 0.0 { 0.72 * flat } else { h };
        shorter.min(left)
    }

    /// Puts the state onto its constraints, by the shortest way in the metric of the masses.
    pub fn project(&mut self) {
        let weights = self.model.inverse.clone();
        for _ in 0..PROJECTIONS {
            self.model.pose(&self.q);
            if !(self.model.correct_pose(&weights, &mut self.q) > 1e-29 * self.model.size) {
                break;
            }
        }
        self.model.pose(&self.q);
        self.model.correct_velocity(&weights, &mut self.v);
    }
}

impl Model {
    /// Order zero of the tape at a pose.
    pub fn pose(&mut self, q: &[Dd]) {
        let series: Vec<Vec<Dd>> = q.iter().map(|q| vec![*q]).collect();
        if self.tape.series.iter().any(Vec::is_empty) {
            self.tape.reserve(1);
        }
        self.tape.evaluate(0, &series);
    }

    /// One Newton step onto the constraints at the pose on the tape; the largest residual before it.
    pub fn correct_pose(&self, weights: &[Dd], q: &mut [Dd]) -> f64 {
        let mut r: Vec<Dd> = self.rows.iter().map(|row| self.tape.series[row.residual][0]).collect();
        let largest = r.iter().fold(0.0_f64, |largest, r| largest.max(r.hi.abs()));
        self.move_by(weights, &mut r, q);
        largest
    }

    /// Takes from a velocity what the constraints forbid; what that was at most.
    pub fn correct_velocity(&self, weights: &[Dd], v: &mut [Dd]) -> f64 {
        let rows = self.derivatives();
        let dot = |row: &Vec<(usize, Dd)>| row.iter().fold(Dd::ZERO, |sum, (i, entry)| sum + *entry * v[*i]);
        let mut r: Vec<Dd> = rows.iter().map(dot).collect();
        let largest = r.iter().fold(0.0_f64, |largest, r| largest.max(r.hi.abs()));
        self.move_by(weights, &mut r, v);
        largest
    }

    /// `x -= W phi_q^T (phi_q W phi_q^T)^-1 r`.
    fn move_by(&self, weights: &[Dd], r: &mut [Dd], x: &mut [Dd]) {
        let rows = self.derivatives();
        Factor::new(&rows, weights).solve(r);
        for (row, r) in rows.iter().zip(r) {
            for (i, entry) in row {
                x[*i] -= weights[*i] * *entry * *r;
            }
        }
    }
}
