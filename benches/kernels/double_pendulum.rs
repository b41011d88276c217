//! S1: the double pendulum in the absolute angles of its bars.
//!
//! With delta the angle from the first bar to the second, all moments over m L^2 = 10 kg m^2:
//!
//! ```text
//! 1.251 a1 + cos(delta) a2 =  sin(delta) v2^2 - 1.5 g cos(q1)
//! cos(delta) a1 + 1.001 a2 = -sin(delta) v1^2 -     g cos(q2)
//! ```

use plm::Scalar;

use super::lanes::Lanes;

const INERTIA_1: f64 = (0.01 + 10.0 * 0.25 + 10.0) / 10.0;
const INERTIA_2: f64 = (0.01 + 10.0) / 10.0;
const WEIGHT_1: f64 = -1.5 * 9.81;
const WEIGHT_2: f64 = -9.81;

/// Angles and angular velocities.
pub(crate) type State = [[f64; 2]; 2];

/// What depends on the angles alone: `a = inverse (right-hand side)`.
struct Pose<const N: usize> {
    sin_delta: Lanes<N>,
    weights: [Lanes<N>; 2],
    /// Entries 11, 12, 22 of the inverse.
    inverse: [Lanes<N>; 3],
}

#[inline(always)]
fn pose<const N: usize>(q1: Lanes<N>, q2: Lanes<N>) -> Pose<N> {
    let [(s1, c1), (s, c)] = Lanes::sin_cos_of_two([q1, q2 - q1]);
    let c2 = c1.times_plus(c, -(s1 * s));
    let reciprocal = c.times_plus(-c, INERTIA_1 * INERTIA_2).under(1.0);
    Pose {
        sin_delta: s,
        weights: [c1 * WEIGHT_1, c2 * WEIGHT_2],
        inverse: [reciprocal * INERTIA_2, -(c * reciprocal), reciprocal * INERTIA_1],
    }
}

impl<const N: usize> Pose<N> {
    #[inline(always)]
    fn acceleration(&self, lane: usize, [v1, v2]: [f64; 2]) -> [f64; 2] {
        let of = |lanes: Lanes<N>| lanes.0[lane];
        let s = of(self.sin_delta);
        let r1 = Scalar::mul_add(s, v2 * v2, of(self.weights[0]));
        let r2 = Scalar::mul_add(-s, v1 * v1, of(self.weights[1]));
        let [i11, i12, i22] = self.inverse.map(of);
        [Scalar::mul_add(i11, r1, i12 * r2), Scalar::mul_add(i22, r2, i12 * r1)]
    }
}

/// One step, poses in pairs: see [`super::crank`].
#[inline(always)]
pub(crate) fn paired_step([q, v]: State, h: f64) -> State {
    let half = 0.5 * h;
    let q2 = along(q, half, v);
    let first = pose(Lanes([q[0], q2[0]]), Lanes([q[1], q2[1]]));
    let k1 = first.acceleration(0, v);
    let v2 = along(v, half, k1);
    let k2 = first.acceleration(1, v2);
    let v3 = along(v, half, k2);
    let (q3, q4) = (along(q, half, v2), along(q, h, v3));
    let last = pose(Lanes([q3[0], q4[0]]), Lanes([q3[1], q4[1]]));
    let k3 = last.acceleration(0, v3);
    let v4 = along(v, h, k3);
    let k4 = last.acceleration(1, v4);
    end([q, v], h, [k1, k2, k3, k4])
}

/// One step, pose by pose.
#[inline(always)]
pub(crate) fn plain_step([q, v]: State, h: f64) -> State {
    let acceleration = |q: [f64; 2], v| pose(Lanes([q[0]]), Lanes([q[1]])).acceleration(0, v);
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

/// `x + h rate`.
#[inline(always)]
fn along(x: [f64; 2], h: f64, rate: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|i| Scalar::mul_add(h, rate[i], x[i]))
}

#[inline(always)]
fn end([q, v]: State, h: f64, [k1, k2, k3, k4]: [[f64; 2]; 4]) -> State {
    let sixth = h * (1.0 / 6.0);
    let middle = [0, 1].map(|i| k2[i] + k3[i]);
    let mean = [0, 1].map(|i| Scalar::mul_add(sixth, k1[i] + middle[i], v[i]));
    let sum = [0, 1].map(|i| Scalar::mul_add(2.0, middle[i], k1[i] + k4[i]));
    [along(q, h, mean), along(v, sixth, sum)]
}
