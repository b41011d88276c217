//! The known values: closed forms, quadratures, zeros.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

/// Gravity of all scenes, m/s^2.
pub const G: f64 = 9.81;

/// x, y, angle of a body.
pub type Pose = [f64; 3];

/// Arithmetic-geometric mean (M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 17.6).
pub fn agm(mut a: f64, mut b: f64) -> f64 {
    while (a - b).abs() > 4.0 * f64::EPSILON * a.abs() {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Jacobi's sn(u | k) by the descending arithmetic-geometric scale (Abramowitz, Stegun, 16.4).
pub fn sn(u: f64, k: f64) -> f64 {
    let mut scale = vec![(1.0, (1.0 - k * k).sqrt(), k)];
    while let Some(&(a, b, c)) = scale.last()
        && c.abs() > f64::EPSILON
    {
        scale.push((0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b)));
    }
    let last = scale.len() - 1;
    let mut phi = 2_f64.powi(last as i32) * scale[last].0 * u;
    for &(a, _, c) in scale[1..].iter().rev() {
        phi = 0.5 * (phi + (c / a * phi.sin()).asin());
    }
    phi.sin()
}

/// Period of a pendulum of small frequency `w` that swings to `amplitude` (rad) on both sides, s.
pub fn pendulum_period(w: f64, amplitude: f64) -> f64 {
    TAU / (w * agm(1.0, (0.5 * amplitude).cos()))
}

/// Angle from hanging of such a pendulum at the time `t` after it was released, rad.
pub fn pendulum_angle(w: f64, amplitude: f64, t: f64) -> f64 {
    let k = (0.5 * amplitude).sin();
    let period = pendulum_period(w, amplitude);
    2.0 * (k * sn(w * (0.25 * period - t % period), k)).asin()
}

/// Time of one turn of a ladder of so many windows whose tops pass the top at a speed, m/s; s.
///
/// All uprights turn alike: ((N + 1)/3 + N) theta'' = -g ((N + 1)/2 + N) cos theta, a pendulum of the small frequency w.
/// Its speed is W = sqrt(speed^2 + 4 w^2) at the bottom, and a turn takes 2 pi / AGM(W, speed).
pub fn ladder_period(windows: u32, speed: f64) -> f64 {
    let n = f64::from(windows);
    let w2 = G * (f64::midpoint(n, 1.0) + n) / ((n + 1.0) / 3.0 + n);
    TAU / agm((speed * speed + 4.0 * w2).sqrt(), speed)
}

/// Period of the swing: bars of `bars` kg and a beam of 1 kg, from 45 deg.
pub fn swing_period(bars: f64) -> f64 {
    pendulum_period((G * (bars + 1.0) / (2.0 / 3.0 * bars + 1.0)).sqrt(), 0.5 * FRAC_PI_2)
}

/// Laguerre's polynomial L_n(x) (Abramowitz, Stegun, 22.7.12).
pub fn laguerre(n: usize, x: f64) -> f64 {
    let (mut before, mut now) = (0.0, 1.0);
    for i in 0..n {
        let i = i as f64;
        (before, now) = (now, ((2.0 * i + 1.0 - x) * now - i * before) / (i + 1.0));
    }
    now
}

/// Zeros of L_n, ascending: w^2 l/g of a hanging chain of n equal points (all below 4 n + 2, Abramowitz, Stegun, 22.16).
pub fn laguerre_zeros(n: usize) -> Vec<f64> {
    let step = 0.01 / n as f64;
    let count = (4.0 * n as f64 + 2.0) / step;
    let brackets = (0..count as u32).map(|i| (f64::from(i) * step, f64::from(i + 1) * step));
    brackets
        .filter(|(low, high)| laguerre(n, *low) * laguerre(n, *high) < 0.0)
        .map(|(low, high)| bisect(low, high, |x| laguerre(n, x) * laguerre(n, low) > 0.0))
        .collect()
}

/// The place where a condition that holds at `low` ends, to rounding.
pub fn bisect(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    loop {
        let middle = 0.5 * (low + high);
        if !(low < middle && middle < high) {
            return middle;
        }
        if holds(middle) { low = middle } else { high = middle }
    }
}

/// Least (a w)^2/(2 g l) of the pivot's motion a cos(w t) that keeps a pendulum of length l upright.
///
/// It tends to 1 for small e = a/l. With s = w t/2 the motion near upright is Mathieu's y'' + (a - 2 q cos 2s) y = 0,
/// a = -4 g/(l w^2), q = 2 e, stable above a_0(q) = -q^2/2 + 7 q^4/128 - 29 q^6/2304 (Abramowitz, Stegun, 20.2.25).
pub fn kapitza_limit(a_over_l: f64) -> f64 {
    let e2 = a_over_l * a_over_l;
    1.0 / (1.0 - 7.0 / 16.0 * e2 + 29.0 / 72.0 * e2 * e2)
}

/// Angle of the direction from one point to another.
fn direction([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> f64 {
    (y1 - y0).atan2(x1 - x0)
}

/// Angles of coupler and rocker of a four-bar (crank, coupler, rocker, ground) that is closed above the line from the crank's
/// pin to the rocker's pivot: two circles meet.
pub fn four_bar([crank, coupler, rocker, ground]: [f64; 4], angle: f64) -> [f64; 2] {
    let (pin, pivot) = ([crank * angle.cos(), crank * angle.sin()], [ground, 0.0]);
    let (dx, dy) = (pivot[0] - pin[0], pivot[1] - pin[1]);
    let distance = dx.hypot(dy);
    let along = (coupler * coupler - rocker * rocker + distance * distance) / (2.0 * distance);
    // As products (Heron), which keep their digits where the triangle is nearly flat.
    let sides = [coupler - distance + rocker, rocker - coupler + distance, coupler + distance - rocker];
    let squared = sides.iter().product::<f64>() * (coupler + distance + rocker);
    let across = squared.max(0.0).sqrt() / (2.0 * distance);
    let (ux, uy) = (dx / distance, dy / distance);
    let tip = [pin[0] + along * ux - across * uy, pin[1] + along * uy + across * ux];
    [direction(pin, tip), direction(pivot, tip)]
}

/// Inertia of a four-bar about its crank, of 1 kg and 0.1 kg m^2 in the middle of each bar, kg m^2.
///
/// Kinematic coefficients: J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, chapter 3.
pub fn four_bar_inertia([crank, coupler, rocker, ground]: [f64; 4], angle: f64) -> f64 {
    let [along, beyond] = four_bar([crank, coupler, rocker, ground], angle);
    let sine = (beyond - along).sin();
    let turn = crank * (angle - beyond).sin() / (coupler * sine);
    let swing = crank * (angle - along).sin() / (rocker * sine);
    let half = 0.5 * coupler * turn;
    let centre = [-crank * angle.sin() - half * along.sin(), crank * angle.cos() + half * along.cos()];
    let cranks = 0.1 + 0.25 * crank * crank + (0.1 + 0.25 * rocker * rocker) * swing * swing;
    cranks + centre[0].powi(2) + centre[1].powi(2) + 0.1 * turn * turn
}

/// Time in which a linkage moves freely from an angle of its driver, at a speed, to a later angle, s.
///
/// I(s) s'^2 is constant, so that the time is the integral of sqrt(I). Next to the flat poses, `flat` + k pi, I may
/// change within any length: intervals are halved towards them (Gauss, Legendre: Abramowitz, Stegun, 25.4.30).
pub fn time_between([from, to]: [f64; 2], speed: f64, flat: f64, inertia: impl Fn(f64) -> f64) -> f64 {
    const NODES: [(f64, f64); 4] = [
        (0.183_434_642_495_649_8, 0.362_683_783_378_361_98),
        (0.525_532_409_916_328_99, 0.313_706_645_877_887_29),
        (0.796_666_477_413_626_74, 0.222_381_034_453_374_47),
        (0.960_289_856_497_536_23, 0.101_228_536_290_376_26),
    ];
    let over = |low: f64, high: f64| {
        let (low, high) = (low.max(from), high.min(to));
        let (middle, half) = (f64::midpoint(low, high), 0.5 * (high - low));
        let at = |s: f64| inertia(middle + half * s).sqrt();
        if half > 0.0 { half * NODES.iter().map(|(s, w)| w * (at(*s) + at(-s))).sum::<f64>() } else { 0.0 }
    };
    let poses = ((from - flat) / PI).round() as i32..=((to - flat) / PI).round() as i32;
    let widths: Vec<f64> = (0..45).map(|halved| FRAC_PI_2 * 0.5_f64.powi(halved)).collect();
    let near = |pose: f64| {
        let halves =
            widths.windows(2).map(|w| over(pose - w[0], pose - w[1]) + over(pose + w[1], pose + w[0]));
        halves.sum::<f64>() + over(pose - widths[44], pose + widths[44])
    };
    poses.map(|k| near(flat + PI * f64::from(k))).sum::<f64>() / (inertia(from).sqrt() * speed)
}

/// Angles of the crank, rad, between which Stephenson's six-bar can move: where the bars of its second dyad stretch.
pub fn stephenson_limits() -> [f64; 2] {
    let within = |crank: f64| {
        let [coupler, _] = four_bar([0.1, 0.3, 0.25, 0.4], crank);
        let ((s, c), (sin, cos)) = (crank.sin_cos(), coupler.sin_cos());
        let (x, y) = (0.1 * c + 0.15 * (cos - sin), 0.1 * s + 0.15 * (sin + cos));
        (x - 0.55).hypot(y - 0.25) < 0.3 + 0.2
    };
    // It starts at 60 deg.
    [-bisect(-FRAC_PI_3, FRAC_PI_2, |crank| within(-crank)), bisect(FRAC_PI_3, PI, within)]
}

/// The angle between two bars of a four-bar at which the other two stretch, rad: law of cosines.
pub fn dead_angle(bar: f64, ground: f64, stretched: f64) -> f64 {
    ((bar * bar + ground * ground - stretched * stretched) / (2.0 * bar * ground)).acos()
}

/// Poses of the thirteen bars of the Quadrorhomb at a crank angle, in the order of their declaration.
///
/// O, C and D lie on one line, A and B at equal distances from it, and each rhombus is the first one moved by D - C.
pub fn quadrorhomb(crank: f64) -> [Pose; 13] {
    let c = 0.3 * (0.5 * crank).cos();
    let (sin, cos) = (0.5 * crank).sin_cos();
    let along = (c * c + 0.25 - 0.0625) / (2.0 * c);
    let across = (0.25 - along * along).max(0.0).sqrt();
    // The node that is `n` rhombi on, `side` times the offset from the line.
    let node = |distance: f64, side: f64, n: f64| {
        let d = distance + n * 2.0 * (along - c);
        [d * cos - side * across * sin, d * sin + side * across * cos]
    };
    let (a, b) = (|n: f64| node(along, 1.0, n), |n: f64| node(along, -1.0, n));
    let (origin, q, pin, tip) = ([0.0, 0.0], [0.15, 0.0], node(c, 0.0, 0.0), node(c, 0.0, 4.0));
    [
        (q, pin),
        (origin, a(0.0)),
        (origin, b(0.0)),
        (pin, a(0.0)),
        (pin, b(0.0)),
        (a(0.0), b(1.0)),
        (b(0.0), a(1.0)),
        (a(1.0), b(2.0)),
        (b(1.0), a(2.0)),
        (a(2.0), b(3.0)),
        (b(2.0), a(3.0)),
        (a(3.0), tip),
        (b(3.0), tip),
    ]
    .map(|(from, to)| [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), direction(from, to)])
}

/// The crank angle at which the Quadrorhomb locks up, rad.
pub fn quadrorhomb_limit() -> f64 {
    2.0 * (0.25_f64 / 0.3).acos()
}

/// When it gets there in free fall from 0 deg at rest, s: the quadrature of sqrt(I/(2 (V_0 - V))) over the crank angle to
/// 50 deg and over the offset of A beyond, by Gauss and Legendre with 16, 32 and 64 points.
pub const QUADRORHOMB_FALL: f64 = 0.423_048_680_880_5;

/// Time of one turn of the free slider-crank (S6) that has the speed `omega` at the crank angle `start`, s.
///
/// I(theta) theta'^2 is constant; the integral of a periodic function by equal intervals converges exponentially.
pub fn slider_crank_turn(omega: f64, start: f64) -> f64 {
    let inertia = |theta: f64| {
        let (s, c) = theta.sin_cos();
        let rod_sin = -s / 3.0;
        let rod_cos = (1.0 - rod_sin * rod_sin).sqrt();
        // Rates per rate of the crank: rod angle, slider, centre of the rod.
        let rod = -c / (3.0 * rod_cos);
        let slider = -0.2 * s - 0.6 * rod_sin * rod;
        let centre = [-0.2 * s - 0.3 * rod_sin * rod, 0.2 * c + 0.3 * rod_cos * rod];
        let crank = 0.2 * 0.04 / 3.0;
        crank + 0.6 * (centre[0].powi(2) + centre[1].powi(2)) + 0.018 * rod * rod + 0.5 * slider * slider
    };
    let count = 256;
    let mean = (0..count).map(|i| inertia(TAU * f64::from(i) / f64::from(count)).sqrt()).sum::<f64>();
    mean / f64::from(count) * TAU / (inertia(start).sqrt() * omega)
}

/// An angle between -pi and pi.
pub fn wrapped(angle: f64) -> f64 {
    angle - TAU * ((angle + PI) / TAU).floor()
}

/// Angles of arm and forearm of S1 after 10 s, rad: Gragg's method with Richardson's extrapolation of order 28 on 45 digits,
/// with 1000 and 1400 steps, which agree to 4e-15.
pub const S1_AT_10: [f64; 2] = [-8.964_182_696_705_955_7, -29.454_140_439_687_699_8];
