//! Bodies with revolute joints in absolute coordinates, written by hand: what generated code is, but with loops.
#![allow(dead_code, reason = "each uses its part")]

use plm_runtime::absolute::accelerate;
use plm_runtime::{BodyStart, Fault, Health, Real, Start};

/// One constraint row.
#[derive(Clone, Copy, Debug)]
pub enum Row {
    /// x (axis 0) or y (axis 1) of a point of body `b` less that of a point of body `a` (none: the ground).
    Coincide { axis: usize, a: Option<usize>, pa: [f64; 2], b: usize, pb: [f64; 2] },
    /// A coordinate keeps its value.
    Keep { coordinate: usize, value: f64 },
}

/// Both rows of a revolute joint.
pub fn revolute(a: Option<usize>, pa: [f64; 2], b: usize, pb: [f64; 2]) -> [Row; 2] {
    [0, 1].map(|axis| Row::Coincide { axis, a, pa, b, pb })
}

/// A linkage of `NQ / 3` bodies whose origins are their centres of gravity.
#[derive(Clone, Copy, Debug)]
pub struct Linkage<S, const NQ: usize, const NC: usize> {
    /// m, m, J of every body.
    pub mass: [f64; NQ],
    pub rows: [Row; NC],
    /// Applied forces: gravity and constant torques.
    pub force: [f64; NQ],
    pub start: [BodyStart<S>; NQ],
    pub length: f64,
    /// alpha = beta of Baumgarte's stabilisation, instead of projection.
    pub alpha: Option<f64>,
}

impl<S: Real, const NQ: usize, const NC: usize> Linkage<S, NQ, NC> {
    /// Of bodies (m, J, start) with gravity.
    pub fn new(bodies: &[(f64, f64, BodyStart<S>)], rows: &[[Row; 2]], length: f64) -> Self {
        let mut linkage = Self {
            mass: [1.0; NQ],
            rows: core::array::from_fn(|j| rows[j / 2][j % 2]),
            force: [0.0; NQ],
            start: core::array::from_fn(|b| bodies.get(b).map_or_else(zero_start, |body| body.2)),
            length,
            alpha: None,
        };
        for (b, (m, inertia, _)) in bodies.iter().enumerate() {
            linkage.mass[3 * b..3 * b + 3].copy_from_slice(&[*m, *m, *inertia]);
            linkage.force[3 * b + 1] = -9.81 * m;
        }
        linkage
    }

    /// The same in other numbers.
    pub fn map<T>(&self, f: impl Fn(S) -> T) -> Linkage<T, NQ, NC> {
        let Self { mass, rows, force, start, length, alpha } = *self;
        Linkage { mass, rows, force, start: start.map(|start| start.map(&f)), length, alpha }
    }

    pub fn phi(&self, q: &[S; NQ]) -> [S; NC] {
        self.rows.map(|row| match row {
            Row::Keep { coordinate, value } => q[coordinate] - S::lit(value),
            Row::Coincide { axis, a, pa, b, pb } => {
                let ground = S::lit(pa[axis]);
                let [from, to] =
                    [a.map_or(ground, |a| q[3 * a + axis] + arm(q, a, pa)[axis]), arm(q, b, pb)[axis]];
                q[3 * b + axis] + to - from
            }
        })
    }

    pub fn phi_q(&self, q: &[S; NQ]) -> [[S; NQ]; NC] {
        let mut out = [[S::lit(0.0); NQ]; NC];
        for (row, out) in self.rows.iter().zip(&mut out) {
            match *row {
                Row::Keep { coordinate, .. } => out[coordinate] = S::lit(1.0),
                Row::Coincide { axis, a, pa, b, pb } => {
                    let sides = [(Some(b), pb, S::lit(1.0)), (a, pa, S::lit(-1.0))];
                    for (body, p, sign) in
                        sides.into_iter().filter_map(|(body, p, s)| body.map(|b| (b, p, s)))
                    {
                        let [x, y] = arm(q, body, p);
                        out[3 * body + axis] = sign;
                        out[3 * body + 2] = sign * if axis == 0 { -y } else { x };
                    }
                }
            }
        }
        out
    }

    pub fn phi_dot(&self, q: &[S; NQ], v: &[S; NQ]) -> [S; NC] {
        self.phi_q(q).map(|row| dot(&row, v))
    }

    fn gamma(&self, q: &[S; NQ], v: &[S; NQ]) -> [S; NC] {
        let turning = |body: usize, p, axis: usize| arm(q, body, p)[axis] * v[3 * body + 2] * v[3 * body + 2];
        let mut gamma = self.rows.map(|row| match row {
            Row::Keep { .. } => S::lit(0.0),
            Row::Coincide { axis, a, pa, b, pb } => {
                turning(b, pb, axis) - a.map_or(S::lit(0.0), |a| turning(a, pa, axis))
            }
        });
        if let Some(alpha) = self.alpha.map(S::lit) {
            let (phi, phi_dot) = (self.phi(q), self.phi_dot(q, v));
            for j in 0..NC {
                gamma[j] = gamma[j] - alpha * (phi_dot[j] + phi_dot[j] + alpha * phi[j]);
            }
        }
        gamma
    }

    pub fn inverse_mass(&self) -> [S; NQ] {
        self.mass.map(|m| S::lit(1.0 / m))
    }

    /// Accelerations without pivoting.
    pub fn acceleration(&self, q: &[S; NQ], v: &[S; NQ]) -> ([S; NQ], Health<S>) {
        let (w, jacobian, gamma) = (self.inverse_mass(), self.phi_q(q), self.gamma(q, v));
        let mut a: [S; NQ] = core::array::from_fn(|i| w[i] * S::lit(self.force[i]));
        let r = core::array::from_fn(|j| dot(&jacobian[j], &a) - gamma[j]);
        let (correction, health) = min_norm(&jacobian, &w, &r);
        for i in 0..NQ {
            a[i] = a[i] - correction[i];
        }
        (a, health)
    }

    /// Accelerations by rank.
    pub fn acceleration_by_rank(&self, t: S, q: &[S; NQ], v: &[S; NQ]) -> Result<[S; NQ], Fault> {
        let force = self.force.map(S::lit);
        let phi_q = |rows: &mut _| *rows = self.phi_q(q);
        Ok(accelerate(t, &self.inverse_mass(), &force, &self.gamma(q, v), phi_q)?.a)
    }

    pub fn start_position(&self) -> [Start<S>; NQ] {
        core::array::from_fn(|i| {
            let body = &self.start[i / 3];
            [body.x, body.y, body.angle][i % 3]
        })
    }

    pub fn start_velocity(&self) -> [Start<S>; NQ] {
        core::array::from_fn(|i| {
            let body = &self.start[i / 3];
            [body.vx, body.vy, body.omega][i % 3]
        })
    }
}

/// W J^T (J W J^T)^-1 r by L D L^T without pivoting.
pub fn min_norm<S: Real, const NQ: usize, const NC: usize>(
    jacobian: &[[S; NQ]; NC],
    w: &[S; NQ],
    r: &[S; NC],
) -> ([S; NQ], Health<S>) {
    let mut matrix: [[S; NC]; NC] = core::array::from_fn(|i| {
        core::array::from_fn(|j| (0..NQ).fold(S::lit(0.0), |s, k| s + jacobian[i][k] * w[k] * jacobian[j][k]))
    });
    let (mut y, mut health) = (*r, S::lit(1.0));
    let diagonal: [S; NC] = core::array::from_fn(|i| matrix[i][i]);
    for k in 0..NC {
        health = health.min(matrix[k][k] / diagonal[k]);
        for i in k + 1..NC {
            let factor = matrix[i][k] / matrix[k][k];
            for j in k..NC {
                matrix[i][j] = matrix[i][j] - factor * matrix[k][j];
            }
            y[i] = y[i] - factor * y[k];
        }
    }
    for k in (0..NC).rev() {
        for j in k + 1..NC {
            y[k] = y[k] - matrix[k][j] * y[j];
        }
        y[k] = y[k] / matrix[k][k];
    }
    let dq = core::array::from_fn(|i| w[i] * (0..NC).fold(S::lit(0.0), |s, j| s + jacobian[j][i] * y[j]));
    (dq, Health(health))
}

/// A point's offset from its body's centre, in absolute axes.
fn arm<S: Real, const NQ: usize>(q: &[S; NQ], body: usize, p: [f64; 2]) -> [S; 2] {
    let ((s, c), [x, y]) = (q[3 * body + 2].sin_cos(), p.map(S::lit));
    [c * x - s * y, s * x + c * y]
}

fn dot<S: Real, const N: usize>(a: &[S; N], b: &[S; N]) -> S {
    (0..N).fold(S::lit(0.0), |sum, i| sum + a[i] * b[i])
}

fn zero_start<S: Real>() -> BodyStart<S> {
    let zero = Start::free(S::lit(0.0));
    BodyStart { x: zero, y: zero, angle: zero, vx: zero, vy: zero, omega: zero }
}

/// A pose at rest, all free.
pub fn pose<S: Real>(x: f64, y: f64, angle: f64) -> BodyStart<S> {
    let [x, y, angle] = [x, y, angle].map(|value| Start::free(S::lit(value)));
    BodyStart { x, y, angle, ..zero_start() }
}

pub use plm_runtime::At;

/// Implements the contract of generated code for a linkage with names.
#[macro_export]
macro_rules! linkage {
    ($name:ident, $nq:literal, $nc:literal, parts $parts:expr, rows $rows:expr, coordinates $coordinates:expr) => {
        #[derive(Clone, Copy, Debug)]
        pub struct $name<S>(pub $crate::linkage::Linkage<S, $nq, $nc>);

        impl<S: plm_runtime::Real> plm_runtime::Absolute<S, $nq, $nc> for $name<S> {
            fn layout(&self) -> &'static plm_runtime::absolute::Layout {
                const ROWS: [&str; $nc] = $rows;
                const PARTS: [&str; $nc] = $parts;
                const COORDINATES: [&str; $nq] = $coordinates;
                const LAYOUT: plm_runtime::absolute::Layout = plm_runtime::absolute::Layout {
                    rows: &ROWS,
                    parts: &PARTS,
                    coordinates: &COORDINATES,
                    angular: &[],
                    given_angles: &[],
                };
                &LAYOUT
            }

            fn phi(&self, _t: S, q: &[S; $nq]) -> [S; $nc] {
                self.0.phi(q)
            }
            fn phi_dot(&self, _t: S, q: &[S; $nq], v: &[S; $nq]) -> [S; $nc] {
                self.0.phi_dot(q, v)
            }
            fn phi_q(&self, _t: S, q: &[S; $nq], each: &mut impl FnMut(usize, usize, S)) {
                for (i, row) in self.0.phi_q(q).into_iter().enumerate() {
                    for (j, entry) in row.into_iter().enumerate() {
                        each(i, j, entry);
                    }
                }
            }
            fn min_norm(
                &self,
                _t: S,
                q: &[S; $nq],
                w: &[S; $nq],
                r: &[S; $nc],
                dq: &mut [S; $nq],
            ) -> plm_runtime::Health<S> {
                let (correction, health) = $crate::linkage::min_norm(&self.0.phi_q(q), w, r);
                *dq = correction;
                health
            }
            fn inverse_mass(&self) -> [S; $nq] {
                self.0.inverse_mass()
            }
            fn start_position(&self) -> [plm_runtime::Start<S>; $nq] {
                self.0.start_position()
            }
            fn start_velocity(&self, _q: &[S; $nq]) -> [plm_runtime::Start<S>; $nq] {
                self.0.start_velocity()
            }
            fn length(&self) -> S {
                S::lit(self.0.length)
            }
        }

        impl<S: plm_runtime::Real> plm_runtime::Rate for $name<S> {
            type S = S;
            type X = [S; 2 * $nq];
            type U = ();
            const NQ: usize = $nq;

            fn rate(&self, _t: S, (): &(), x: &Self::X, dx: &mut Self::X) -> plm_runtime::Health<S> {
                let (q, v) = plm_runtime::absolute::split(x);
                let (a, health) = self.0.acceleration(&q, &v);
                plm_runtime::absolute::join(&v, &a, dx);
                health
            }
        }

        impl<S: plm_runtime::Real> plm_runtime::Constraints for $name<S> {
            fn rate_by_rank(
                &self,
                t: S,
                (): &(),
                x: &Self::X,
                dx: &mut Self::X,
            ) -> Result<(), plm_runtime::Fault> {
                let (q, v) = plm_runtime::absolute::split(x);
                plm_runtime::absolute::join(&v, &self.0.acceleration_by_rank(t, &q, &v)?, dx);
                Ok(())
            }
            fn project(&self, t: S, _u: &Self::U, x: &mut Self::X) -> Result<(), plm_runtime::Fault> {
                if self.0.alpha.is_some() { Ok(()) } else { plm_runtime::absolute::project_state(self, t, x) }
            }
            fn drift(&self, t: S, _u: &Self::U, x: &Self::X) -> plm_runtime::Drift<S> {
                if self.0.alpha.is_some() {
                    return plm_runtime::Drift { phi: S::lit(0.0), phi_dot: S::lit(0.0) };
                }
                plm_runtime::absolute::drift(self, t, x)
            }
            fn baumgarte_rate(&self) -> Option<f64> {
                self.0.alpha
            }
        }

        impl<S: plm_runtime::Real> plm_runtime::Events for $name<S> {
            type G = [S; 0];
        }

        impl<S: plm_runtime::Real> plm_runtime::Labels for $name<S> {
            fn part_of_state(&self, index: usize) -> &'static str {
                plm_runtime::Absolute::<S, $nq, $nc>::layout(self).coordinates[index % $nq]
            }
        }

        impl<S: plm_runtime::Real> plm_runtime::Linear for $name<S> {
            type Lifted<const K: usize> = $name<plm_runtime::Dual<S, K>>;
            type In<T: plm_runtime::Real> = $name<T>;
            type Derivatives = [[S; 2 * $nq]; 2 * $nq];

            fn lift<const K: usize>(&self, (): &()) -> (Self::Lifted<K>, ()) {
                self.in_numbers(&(), plm_runtime::Dual::constant)
            }
            fn in_numbers<T: plm_runtime::Real>(&self, (): &(), number: impl Fn(S) -> T) -> ($name<T>, ()) {
                ($name(self.0.map(number)), ())
            }
            fn constraints(&self, t: S, x: &Self::X, row: &mut impl FnMut(S)) {
                plm_runtime::absolute::residuals(self, t, x, row);
            }
        }

        impl<S: plm_runtime::Real> plm_runtime::Mechanism for $name<S> {
            type State = $crate::linkage::At<Self>;
            type Rescue = plm_runtime::singular::Never<Self>;

            fn start_state(&self, t: S) -> Result<(Self::U, Self::X), plm_runtime::Fault> {
                let assembly = plm_runtime::absolute::assemble(self, t)?;
                let mut x = [S::lit(0.0); 2 * $nq];
                plm_runtime::absolute::join(&assembly.q, &assembly.v, &mut x);
                Ok(((), x))
            }
        }
    };
}
