//! S3: the chain of uniform bars in their absolute angles, by articulated bodies in work that grows with their number.
//!
//! Method: R. Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 7, in the frames (u, n) of the bars, u along and
//! n across. In units of a bar's mass and length, the outer part of the chain answers an acceleration of bar i's
//! outer end by the articulated mass A with the entries nn, un, uu; write `D = 1/3 + A_nn`, `tau = A_un`,
//! `V = A_uu + 2/3`, r = 1/D. One bar further in, everything is turned by the joint's angle (s, c), and because
//! `A_nn + 1 - (A_nn + 1/2)^2 / D = 1/3 - r/36` the whole recursion is
//!
//! ```text
//! x = s tau + c/6,   y = c tau - s/6
//! D' = 2/3 + s^2 V - r x^2,   tau' = s c V - r x y,   V' = 1 + c^2 V - r y^2
//! ```
//!
//! from D = 1/3, tau = 0, V = 2/3 at the tip. With omega^2 = e, the centrifugal forces (P, nu) of the outer part and,
//! inwards to outwards, the acceleration (f, mu) of a bar's outer end along u and n are
//!
//! ```text
//! P = p + e (V - 1/6),   nu = p_n + e tau,       p' = c P - r y nu,   p_n' = s P - r x nu
//! f' = c f + s mu - e',   mu' = r nu - r y f - r x mu
//! ```
//!
//! beginning with f = 0, mu = g at the fixed end: gravity is an upward acceleration of all. The angular acceleration
//! is mu' less the acceleration `c mu - s f` of the bar's inner end along n.

use plm::Scalar;

use super::lanes::Lanes;

/// Angles and angular velocities.
#[derive(Clone, Copy)]
pub(crate) struct State<const BARS: usize> {
    pub(crate) q: [f64; BARS],
    pub(crate) v: [f64; BARS],
}

impl<const BARS: usize> State<BARS> {
    /// Horizontal, at rest.
    pub(crate) const START: Self = Self { q: [0.0; BARS], v: [0.0; BARS] };
}

/// What depends on the angles alone, of one bar and the joint at its inner end.
#[derive(Clone, Copy)]
struct Link<const N: usize> {
    s: Lanes<N>,
    c: Lanes<N>,
    r: Lanes<N>,
    rx: Lanes<N>,
    ry: Lanes<N>,
    tau: Lanes<N>,
    /// V - 1/6.
    along: Lanes<N>,
}

type Pose<const BARS: usize, const N: usize> = [Link<N>; BARS];

/// The pose, of lanes `q[lane]`.
#[inline(always)]
fn pose<const BARS: usize, const N: usize>(q: [&[f64; BARS]; N]) -> Pose<BARS, N> {
    let zero = Lanes([0.0; N]);
    let mut links = [Link { s: zero, c: zero, r: zero, rx: zero, ry: zero, tau: zero, along: zero }; BARS];
    let [sines, cosines] = of_joints(q);
    let (mut d, mut tau, mut v) = (Lanes::from(1.0 / 3.0), zero, Lanes::from(2.0 / 3.0));
    for i in (0..BARS).rev() {
        let (s, c) = (Lanes(sines[i]), Lanes(cosines[i]));
        let r = d.under(1.0);
        let (x, y) = (s.times_plus(tau, c * (1.0 / 6.0)), c.times_plus(tau, s * (-1.0 / 6.0)));
        let (rx, ry) = (r * x, r * y);
        links[i] = Link { s, c, r, rx, ry, tau, along: v - 1.0 / 6.0 };
        let (sv, cv) = (s * v, c * v);
        d = rx.times_plus(-x, s.times_plus(sv, 2.0 / 3.0));
        tau = rx.times_plus(-y, c * sv);
        v = ry.times_plus(-y, c.times_plus(cv, 1.0));
    }
    links
}

/// Sines and cosines of the angles from bar to bar.
#[inline]
fn of_joints<const BARS: usize, const N: usize>(q: [&[f64; BARS]; N]) -> [[[f64; N]; BARS]; 2] {
    let mut angles = [[0.0; N]; BARS];
    for lane in 0..N {
        angles[0][lane] = q[lane][0];
        for i in 1..BARS {
            angles[i][lane] = q[lane][i] - q[lane][i - 1];
        }
    }
    let (mut sines, mut cosines) = ([[0.0; N]; BARS], [[0.0; N]; BARS]);
    // Numbers of bars are multiples of four.
    let (fours, _) = angles.as_flattened().as_chunks::<4>();
    let (of_sines, _) = sines.as_flattened_mut().as_chunks_mut();
    let (of_cosines, _) = cosines.as_flattened_mut().as_chunks_mut();
    for ((angles, s), c) in fours.iter().zip(of_sines).zip(of_cosines) {
        (*s, *c) = f64::sin_cos_all(*angles);
    }
    [sines, cosines]
}

/// Angular accelerations in one lane of a pose.
#[inline(always)]
fn accelerations<const BARS: usize, const N: usize>(
    pose: &Pose<BARS, N>,
    lane: usize,
    v: &[f64; BARS],
) -> [f64; BARS] {
    let of = |lanes: Lanes<N>| lanes.0[lane];
    let mut r_nu = [0.0; BARS];
    let (mut p, mut p_n) = (0.0, 0.0);
    for i in (0..BARS).rev() {
        let (link, e) = (&pose[i], v[i] * v[i]);
        let along = Scalar::mul_add(e, of(link.along), p);
        let nu = Scalar::mul_add(e, of(link.tau), p_n);
        r_nu[i] = of(link.r) * nu;
        p = Scalar::mul_add(-nu, of(link.ry), of(link.c) * along);
        p_n = Scalar::mul_add(-nu, of(link.rx), of(link.s) * along);
    }
    let (mut f, mut mu) = (0.0, 9.81 * BARS as f64);
    let mut a = [0.0; BARS];
    for i in 0..BARS {
        let (link, e) = (&pose[i], v[i] * v[i]);
        let inner = Scalar::mul_add(of(link.c), mu, -(of(link.s) * f));
        let next = Scalar::mul_add(-mu, of(link.rx), Scalar::mul_add(-f, of(link.ry), r_nu[i]));
        f = Scalar::mul_add(of(link.s), mu, Scalar::mul_add(of(link.c), f, -e));
        mu = next;
        a[i] = next - inner;
    }
    a
}

/// Angular accelerations in a state.
pub(crate) fn accelerations_at<const BARS: usize>(State { q, v }: &State<BARS>) -> [f64; BARS] {
    accelerations(&pose([q]), 0, v)
}

/// One step, poses in pairs: see [`super::crank`].
#[inline(always)]
pub(crate) fn paired_step<const BARS: usize>(State { q, v }: &mut State<BARS>, h: f64) {
    let half = 0.5 * h;
    let q2 = along(q, half, v);
    let first = pose([&*q, &q2]);
    let k1 = accelerations(&first, 0, v);
    let v2 = along(v, half, &k1);
    let k2 = accelerations(&first, 1, &v2);
    let v3 = along(v, half, &k2);
    let last = pose([&along(q, half, &v2), &along(q, h, &v3)]);
    let k3 = accelerations(&last, 0, &v3);
    let k4 = accelerations(&last, 1, &along(v, h, &k3));
    end(q, v, h, [&k1, &k2, &k3, &k4]);
}

/// One step, pose by pose.
#[inline(always)]
pub(crate) fn plain_step<const BARS: usize>(State { q, v }: &mut State<BARS>, h: f64) {
    let half = 0.5 * h;
    let k1 = accelerations(&pose([&*q]), 0, v);
    let v2 = along(v, half, &k1);
    let k2 = accelerations(&pose([&along(q, half, v)]), 0, &v2);
    let v3 = along(v, half, &k2);
    let k3 = accelerations(&pose([&along(q, half, &v2)]), 0, &v3);
    let k4 = accelerations(&pose([&along(q, h, &v3)]), 0, &along(v, h, &k3));
    end(q, v, h, [&k1, &k2, &k3, &k4]);
}

/// `x + h rate`.
#[inline(always)]
fn along<const BARS: usize>(x: &[f64; BARS], h: f64, rate: &[f64; BARS]) -> [f64; BARS] {
    let mut sum = *x;
    for i in 0..BARS {
        sum[i] = Scalar::mul_add(h, rate[i], x[i]);
    }
    sum
}

#[inline(always)]
fn end<const BARS: usize>(
    q: &mut [f64; BARS],
    v: &mut [f64; BARS],
    h: f64,
    [k1, k2, k3, k4]: [&[f64; BARS]; 4],
) {
    let sixth = h * (1.0 / 6.0);
    for i in 0..BARS {
        let middle = k2[i] + k3[i];
        let mean = Scalar::mul_add(sixth, k1[i] + middle, v[i]);
        q[i] = Scalar::mul_add(h, mean, q[i]);
        v[i] = Scalar::mul_add(sixth, Scalar::mul_add(2.0, middle, k1[i] + k4[i]), v[i]);
    }
}
