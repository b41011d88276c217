//! The double pendulum S1 in absolute coordinates, written by hand: two bars of 10 kg and 0.01 kg*m^2, the first 1 m
//! long with its centre of gravity in the middle, the second with its centre of gravity 1 m from the joint.

use plm_runtime::absolute::{accelerate, assemble, drift, join, settle_state, split};
use plm_runtime::{Absolute, Drift, Fault, Health, Mechanism, Moment, Real, Start, System, Vector};

/// The mechanism; its parameter is the start angle of the second bar in rad.
#[derive(Clone, Copy)]
pub struct Pendulum<S> {
    /// From the x axis, rad.
    pub start_angle: S,
    /// Whether assembly must keep both angles.
    pub locked: bool,
}

/// The mechanism at a moment.
#[derive(Clone, Copy)]
pub struct State<S> {
    mechanism: Pendulum<S>,
    time: S,
    x: [S; 12],
}

impl<S: Real> Pendulum<S> {
    /// Horizontal second bar, angles locked.
    pub fn new() -> Self {
        Self { start_angle: S::lit(0.0), locked: true }
    }

    /// Accelerations without joints: gravity.
    fn free(&self) -> [S; 6] {
        [0.0, -9.81, 0.0, 0.0, -9.81, 0.0].map(S::lit)
    }

    /// What phi_q a must be.
    fn gamma(&self, q: &[S; 6], v: &[S; 6]) -> [S; 4] {
        let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
        let (w1, w2) = (S::lit(0.5) * v[2] * v[2], v[5] * v[5]);
        [-(c1 * w1), -(s1 * w1), -(c1 * w1) - c2 * w2, -(s1 * w1) - s2 * w2]
    }
}

impl<S: Real> Absolute<S, 6, 4> for Pendulum<S> {
    const ROWS: [&'static str; 4] = ["shoulder.x", "shoulder.y", "elbow.x", "elbow.y"];
    const PARTS: [&'static str; 4] = ["shoulder", "shoulder", "elbow", "elbow"];
    const COORDINATES: [&'static str; 6] =
        ["arm.x", "arm.y", "arm.angle", "forearm.x", "forearm.y", "forearm.angle"];

    fn phi(&self, _: S, q: &[S; 6]) -> [S; 4] {
        let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
        let (s1, c1) = (S::lit(0.5) * s1, S::lit(0.5) * c1);
        [q[0] - c1, q[1] - s1, q[3] - c2 - (q[0] + c1), q[4] - s2 - (q[1] + s1)]
    }

    fn phi_dot(&self, t: S, q: &[S; 6], v: &[S; 6]) -> [S; 4] {
        let mut rows = [[S::lit(0.0); 6]; 4];
        self.phi_q(t, q, &mut rows);
        rows.map(|row| dot(&row, v))
    }

    fn phi_q(&self, _: S, q: &[S; 6], out: &mut [[S; 6]; 4]) {
        let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
        let (s1, c1) = (S::lit(0.5) * s1, S::lit(0.5) * c1);
        let (zero, one) = (S::lit(0.0), S::lit(1.0));
        *out = [
            [one, zero, s1, zero, zero, zero],
            [zero, one, -c1, zero, zero, zero],
            [-one, zero, s1, one, zero, s2],
            [zero, -one, -c1, zero, one, -c2],
        ];
    }

    fn min_norm(&self, t: S, q: &[S; 6], w: &[S; 6], r: &[S; 4], dq: &mut [S; 6]) -> Health<S> {
        let mut rows = [[S::lit(0.0); 6]; 4];
        self.phi_q(t, q, &mut rows);
        let weighted = rows.map(|row| row.map2(w, |a, b| a * b));
        let matrix = weighted.map(|a| rows.map(|b| dot(&a, &b)));
        let (mu, health) = solve(matrix, *r);
        *dq = Vector::from_fn(|i| (0..4).fold(S::lit(0.0), |sum, j| sum + weighted[j][i] * mu[j]));
        health
    }

    fn inverse_mass(&self) -> [S; 6] {
        [0.1, 0.1, 100.0, 0.1, 0.1, 100.0].map(S::lit)
    }

    fn start_position(&self) -> [Start<S>; 6] {
        let angle = |value| Start { value, locked: self.locked };
        let origin = Start::free(S::lit(0.0));
        let first = angle(S::lit(core::f64::consts::FRAC_PI_4));
        [origin, origin, first, origin, origin, angle(self.start_angle)]
    }

    fn start_velocity(&self, _: &[S; 6]) -> [Start<S>; 6] {
        [Start::free(S::lit(0.0)); 6]
    }

    fn length(&self) -> S {
        S::lit(1.0)
    }
}

fn dot<S: Real>(a: &[S; 6], b: &[S; 6]) -> S {
    a.map2(b, |a, b| a * b).fold(S::lit(0.0), |sum, product| sum + product)
}

/// Gauss' elimination of a symmetric positive definite system, with its smallest pivot ratio.
#[allow(clippy::needless_range_loop)] // The loops read as the formulas that they stand for.
fn solve<S: Real>(mut a: [[S; 4]; 4], mut b: [S; 4]) -> ([S; 4], Health<S>) {
    let mut health = Health::perfect();
    let diagonal: [S; 4] = Vector::from_fn(|i| a[i][i]);
    for k in 0..4 {
        health = health.worst(Health(a[k][k] / diagonal[k]));
        for i in k + 1..4 {
            let factor = a[i][k] / a[k][k];
            for j in k..4 {
                a[i][j] = a[i][j] - factor * a[k][j];
            }
            b[i] = b[i] - factor * b[k];
        }
    }
    for k in [3, 2, 1, 0] {
        for j in k + 1..4 {
            b[k] = b[k] - a[k][j] * b[j];
        }
        b[k] = b[k] / a[k][k];
    }
    (b, health)
}

impl<S: Real> System for Pendulum<S> {
    type S = S;
    type X = [S; 12];
    type U = ();
    type G = [S; 0];
    const NQ: usize = 6;

    fn rate(&self, t: S, (): &(), x: &[S; 12], dx: &mut [S; 12]) -> Health<S> {
        let (q, v) = split(x);
        let (free, gamma) = (self.free(), self.gamma(&q, &v));
        let missing = gamma.map2(&self.phi_dot(t, &q, &free), |gamma, rate| gamma - rate);
        let mut a = free;
        let health = self.min_norm(t, &q, &self.inverse_mass(), &missing, &mut a);
        join(&v, &a.map2(&free, |a, b| a + b), dx);
        health
    }

    fn rate_by_rank(&self, t: S, (): &(), x: &[S; 12], dx: &mut [S; 12]) -> Result<(), Fault> {
        let (q, v) = split(x);
        let mut rows = [[S::lit(0.0); 6]; 4];
        self.phi_q(t, &q, &mut rows);
        let weight = self.free().map2(&self.inverse_mass(), |a, w| a / w);
        let found = accelerate(t, &self.inverse_mass(), &weight, &self.gamma(&q, &v), &rows)?;
        join(&v, &found.a, dx);
        Ok(())
    }

    fn settle(&self, t: S, x: &mut [S; 12]) -> Result<(), Fault> {
        settle_state(self, t, x)
    }

    fn drift(&self, t: S, x: &[S; 12]) -> Drift<S> {
        drift(self, t, x)
    }
}

impl<S: Real> Mechanism for Pendulum<S> {
    type State = State<S>;

    fn start_input(&self) {}

    fn start_state(&self, t: S) -> Result<[S; 12], Fault> {
        let start = assemble(self, t)?;
        let mut x = [S::lit(0.0); 12];
        join(&start.q, &start.v, &mut x);
        Ok(x)
    }
}

impl<S: Real> Moment for State<S> {
    type M = Pendulum<S>;

    fn new(mechanism: Pendulum<S>, (): (), time: S, x: [S; 12]) -> Self {
        Self { mechanism, time, x }
    }
    fn mechanism(&self) -> &Pendulum<S> {
        &self.mechanism
    }
    fn input(&self) -> &() {
        &()
    }
    fn time(&self) -> S {
        self.time
    }
    fn x(&self) -> &[S; 12] {
        &self.x
    }
    fn set(&mut self, time: S, x: &[S; 12]) {
        self.time = time;
        self.x = *x;
    }
}
