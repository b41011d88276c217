//! Runge-Kutta 4 for one degree of freedom.
//!
//! With one coordinate q and forces that depend on the pose alone, `m(q) a + m'(q) v^2 / 2 = Q(q)`, so that
//! `a = A(q) + B(q) v^2`. All that is dear depends on the pose alone, and of the four poses of a step
//!
//! ```text
//! q1 = q,   q2 = q + h/2 v,   q3 = q + h/2 v2,   q4 = q + h v3,   v2 = v + h/2 a1,   v3 = v + h/2 a2
//! ```
//!
//! the first two are known before any acceleration, and the last two before the third: they go in pairs.

use plm::Scalar;

use super::lanes::Lanes;

/// A mechanism with one degree of freedom.
pub(crate) trait Crank {
    /// The coefficients (A, B) of `a = A(q) + B(q) v^2`.
    fn coefficients<const N: usize>(q: Lanes<N>) -> (Lanes<N>, Lanes<N>);
}

/// One step of length h with the state (q, v), poses in pairs.
#[inline(always)]
pub(crate) fn paired_step<K: Crank>([q, v]: [f64; 2], h: f64) -> [f64; 2] {
    let half = 0.5 * h;
    let [[a1, a2], [b1, b2]] = pair::<K>(q, half.mul_add_to(v, q));
    let k1 = b1.mul_add_to(v * v, a1);
    let v2 = half.mul_add_to(k1, v);
    let k2 = b2.mul_add_to(v2 * v2, a2);
    let v3 = half.mul_add_to(k2, v);
    let [[a3, a4], [b3, b4]] = pair::<K>(half.mul_add_to(v2, q), h.mul_add_to(v3, q));
    let k3 = b3.mul_add_to(v3 * v3, a3);
    let v4 = h.mul_add_to(k3, v);
    let k4 = b4.mul_add_to(v4 * v4, a4);
    let [q, v] = end([q, v].map(Lanes::from), h, [k1, k2, k3, k4].map(Lanes::<1>::from));
    [q.0[0], v.0[0]]
}

/// The coefficients of two poses. Compilers begin to build vectors where results are stored, so it is never inlined.
#[inline(never)]
fn pair<K: Crank>(first: f64, second: f64) -> [[f64; 2]; 2] {
    let (Lanes(a), Lanes(b)) = K::coefficients(Lanes([first, second]));
    [a, b]
}

/// The same step, pose by pose, as methods for x' = f(x) take it; of N trajectories side by side.
#[inline(always)]
pub(crate) fn plain_step<K: Crank, const N: usize>([q, v]: [Lanes<N>; 2], h: f64) -> [Lanes<N>; 2] {
    let acceleration = |q: Lanes<N>, v: Lanes<N>| {
        let (a, b) = K::coefficients(q);
        b.times_plus(v * v, a)
    };
    let along = |x: Lanes<N>, h: f64, rate: Lanes<N>| rate.times_plus(h, x);
    let half = 0.5 * h;
    let k1 = acceleration(q, v);
    let v2 = along(v, half, k1);
    let k2 = acceleration(along(q, half, v), v2);
    let v3 = along(v, half, k2);
    let k3 = acceleration(along(q, half, v2), v3);
    let v4 = along(v, h, k3);
    let k4 = acceleration(along(q, h, v3), v4);
    end([q, v], h, [k1, k2, k3, k4])
}

/// The velocities of the stages are v, v2, v3, v4: their weighted sum is 6 v + h (k1 + k2 + k3).
#[inline(always)]
fn end<const N: usize>([q, v]: [Lanes<N>; 2], h: f64, [k1, k2, k3, k4]: [Lanes<N>; 4]) -> [Lanes<N>; 2] {
    let (sixth, middle) = (h * (1.0 / 6.0), k2 + k3);
    let mean = (k1 + middle).times_plus(sixth, v);
    [mean.times_plus(h, q), middle.times_plus(2.0, k1 + k4).times_plus(sixth, v)]
}

/// `Scalar::mul_add` under a name that `f64` does not have itself.
trait MulAddTo {
    fn mul_add_to(self, a: f64, b: f64) -> f64;
}

impl MulAddTo for f64 {
    #[inline(always)]
    fn mul_add_to(self, a: f64, b: f64) -> f64 {
        Scalar::mul_add(self, a, b)
    }
}
