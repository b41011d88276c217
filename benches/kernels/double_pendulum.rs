//! S1: the double pendulum in the absolute angles of its bars.
//!
//! With delta the angle from the first bar to the second, all moments over m L^2 = 10 kg m^2:
//!
//! ```text
//! 1.251 a1 + cos(delta) a2 =  sin(delta) v2^2 - 1.5 g cos(q1)
//! cos(delta) a1 + 1.001 a2 = -sin(delta) v1^2 -     g cos(q2)
//! ```

use super::lanes::Lanes;

const INERTIA_1: f64 = (0.01 + 10.0 * 0.25 + 10.0) / 10.0;
const INERTIA_2: f64 = (0.01 + 10.0) / 10.0;
const WEIGHT_1: f64 = -1.5 * 9.81;
const WEIGHT_2: f64 = -9.81;

/// Angles and angular velocities.
pub(crate) type State = [[f64; 2]; 2];

/// Angles, or angular velocities, of trajectories side by side.
type Side<const N: usize> = [Lanes<N>; 2];

/// What depends on the angles alone: `a = inverse (right-hand side)`.
struct Pose<const N: usize> {
    sin_delta: Lanes<N>,
    weights: [Lanes<N>; 2],
    /// Entries 11, 12, 22 of the inverse.
    inverse: [Lanes<N>; 3],
}

#[inline(always)]
fn pose<const N: usize>(q1: Lanes<N>, q2: Lanes<N>) -> Pose<N> {
    let [(s1, c1), (s, c)] =
        if N > 2 { [q1.sin_cos(), (q2 - q1).sin_cos()] } else { Lanes::sin_cos_of_two([q1, q2 - q1]) };
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
    fn acceleration(&self, [v1, v2]: Side<N>) -> Side<N> {
        let s = self.sin_delta;
        let r1 = s.times_plus(v2 * v2, self.weights[0]);
        let r2 = (-s).times_plus(v1 * v1, self.weights[1]);
        let [i11, i12, i22] = self.inverse;
        [i11.times_plus(r1, i12 * r2), i22.times_plus(r2, i12 * r1)]
    }

    /// One of the poses.
    #[inline(always)]
    fn of(&self, lane: usize) -> Pose<1> {
        let of = |lanes: Lanes<N>| Lanes([lanes.0[lane]]);
        Pose { sin_delta: of(self.sin_delta), weights: self.weights.map(of), inverse: self.inverse.map(of) }
    }
}

/// One step, poses in pairs: see [`super::crank`].
#[inline(always)]
pub(crate) fn paired_step([q, v]: State, h: f64) -> State {
    let [q, v] = [q, v].map(|x| x.map(Lanes::from));
    let half = 0.5 * h;
    let first = poses(q, along(q, half, v));
    let k1 = first.of(0).acceleration(v);
    let v2 = along(v, half, k1);
    let k2 = first.of(1).acceleration(v2);
    let v3 = along(v, half, k2);
    let last = poses(along(q, half, v2), along(q, h, v3));
    let k3 = last.of(0).acceleration(v3);
    let v4 = along(v, h, k3);
    let k4 = last.of(1).acceleration(v4);
    end([q, v], h, [k1, k2, k3, k4]).map(|x| x.map(|Lanes([x])| x))
}

/// Two poses.
#[inline(always)]
fn poses(first: Side<1>, second: Side<1>) -> Pose<2> {
    let [q1, q2] = [0, 1].map(|i| Lanes([first[i].0[0], second[i].0[0]]));
    pose(q1, q2)
}

/// One step, pose by pose; of N trajectories side by side.
#[inline(always)]
pub(crate) fn plain_step<const N: usize>([q, v]: [Side<N>; 2], h: f64) -> [Side<N>; 2] {
    let acceleration = |q: Side<N>, v| pose(q[0], q[1]).acceleration(v);
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
fn along<const N: usize>(x: Side<N>, h: f64, rate: Side<N>) -> Side<N> {
    [0, 1].map(|i| rate[i].times_plus(h, x[i]))
}

#[inline(always)]
fn end<const N: usize>([q, v]: [Side<N>; 2], h: f64, [k1, k2, k3, k4]: [Side<N>; 4]) -> [Side<N>; 2] {
    let sixth = h * (1.0 / 6.0);
    let middle = [0, 1].map(|i| k2[i] + k3[i]);
    let mean = [0, 1].map(|i| (k1[i] + middle[i]).times_plus(sixth, v[i]));
    let sum = [0, 1].map(|i| middle[i].times_plus(2.0, k1[i] + k4[i]));
    [along(q, h, mean), along(v, sixth, sum)]
}
