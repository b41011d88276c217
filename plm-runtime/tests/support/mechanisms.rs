//! The mechanisms that the tests run.
#![allow(dead_code, reason = "each uses its part")]

use core::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4};

use plm_runtime::Real;

use crate::linkage;
use crate::linkage::{Linkage, Row, pose, revolute};

linkage!(Pendulum, 3, 2,
    parts ["pivot"; 2], rows ["pivot.x", "pivot.y"], coordinates ["arm.x", "arm.y", "arm.angle"]);
linkage!(DoublePendulum, 6, 4,
    parts ["shoulder", "shoulder", "elbow", "elbow"],
    rows ["shoulder.x", "shoulder.y", "elbow.x", "elbow.y"],
    coordinates ["arm.x", "arm.y", "arm.angle", "forearm.x", "forearm.y", "forearm.angle"]);
linkage!(FourBar, 9, 8,
    parts ["a", "a", "b", "b", "c", "c", "d", "d"],
    rows ["a.x", "a.y", "b.x", "b.y", "c.x", "c.y", "d.x", "d.y"],
    coordinates ["crank.x", "crank.y", "crank.angle", "coupler.x", "coupler.y", "coupler.angle", "rocker.x",
        "rocker.y", "rocker.angle"]);
linkage!(Parallelogram, 12, 12,
    parts ["a1", "a1", "b1", "b1", "a2", "a2", "b2", "b2", "a3", "a3", "b3", "b3"],
    rows ["a1.x", "a1.y", "b1.x", "b1.y", "a2.x", "a2.y", "b2.x", "b2.y", "a3.x", "a3.y", "b3.x", "b3.y"],
    coordinates ["bar.x", "bar.y", "bar.angle", "crank1.x", "crank1.y", "crank1.angle", "crank2.x", "crank2.y",
        "crank2.angle", "crank3.x", "crank3.y", "crank3.angle"]);

linkage!(Ladder, 15, 14,
    parts ["a"; 14], rows ["a"; 14], coordinates ["bar"; 15]);

/// S4 of the benchmarks with two windows: five bars of 1 m and 1 kg; the three cranks upright with the angular velocity
/// of -1 rad/s.
pub fn ladder() -> Ladder<f64> {
    let crank = |x: f64| {
        let mut start = pose(x, 0.5, FRAC_PI_2);
        (start.vx.value, start.omega.value) = (0.5, -1.0);
        (1.0, 1.0 / 12.0, start)
    };
    let window = |x: f64| {
        let mut start = pose(x + 0.5, 1.0, 0.0);
        start.vx.value = 1.0;
        (1.0, 1.0 / 12.0, start)
    };
    let (low, high) = ([-0.5, 0.0], [0.5, 0.0]);
    let joints = [
        revolute(None, [0.0, 0.0], 0, low),
        revolute(Some(0), high, 1, low),
        revolute(Some(1), high, 2, high),
        revolute(None, [1.0, 0.0], 2, low),
        revolute(Some(2), high, 3, low),
        revolute(Some(3), high, 4, high),
        revolute(None, [2.0, 0.0], 4, low),
    ];
    Ladder(Linkage::new(&[crank(0.0), window(0.0), crank(1.0), window(1.0), crank(2.0)], &joints, 1.0))
}

/// A uniform bar of 1 m and 1 kg that hangs from its end at the origin, at an angle.
pub fn pendulum<S: Real>(angle: f64) -> Pendulum<S> {
    let (s, c) = angle.sin_cos();
    let bar = (1.0, 1.0 / 12.0, pose(0.5 * c, 0.5 * s, angle));
    Pendulum(Linkage::new(&[bar], &[revolute(None, [0.0; 2], 0, [-0.5, 0.0])], 1.0))
}

/// S1 of the benchmarks, the manual's double pendulum without damping: 45 deg and 0 deg at rest, assembled.
pub fn double_pendulum<S: Real>() -> DoublePendulum<S> {
    let (s, c) = FRAC_PI_4.sin_cos();
    let mut m = unassembled_double_pendulum();
    m.0.start[0] = pose(0.5 * c, 0.5 * s, FRAC_PI_4);
    m.0.start[1] = pose(c + 1.0, s, 0.0);
    m
}

/// As the manual declares it in section 2.2: both centres at (0, 0), the angles 45 deg and 0 deg, nothing locked.
pub fn unassembled_double_pendulum<S: Real>() -> DoublePendulum<S> {
    let bodies = [(10.0, 0.01, pose(0.0, 0.0, FRAC_PI_4)), (10.0, 0.01, pose(0.0, 0.0, 0.0))];
    let joints = [revolute(None, [0.0; 2], 0, [-0.5, 0.0]), revolute(Some(0), [0.5, 0.0], 1, [-1.0, 0.0])];
    DoublePendulum(Linkage::new(&bodies, &joints, 2.0))
}

/// S2 of the benchmarks: ground 1, crank 0.3, coupler 0.9, rocker 0.7; 1 kg/m; crank at 60 deg, elbow up.
pub fn four_bar() -> FourBar<f64> {
    bars([0.3, 0.9, 0.7], [FRAC_PI_3, 0.5, 1.5])
}

/// A four-bar between (0, 0) and (1, 0) with uniform bars of 1 kg/m, from rough angles that assembly closes.
pub fn bars([crank, coupler, rocker]: [f64; 3], [alpha, beta, gamma]: [f64; 3]) -> FourBar<f64> {
    let bar = |l: f64, x: f64, y: f64, angle: f64| {
        (l, l * l * l / 12.0, pose(x + 0.5 * l * angle.cos(), y + 0.5 * l * angle.sin(), angle))
    };
    let (x, y) = (crank * alpha.cos(), crank * alpha.sin());
    let mut bodies = [bar(crank, 0.0, 0.0, alpha), bar(coupler, x, y, beta), bar(rocker, 1.0, 0.0, gamma)];
    bodies[0].2.angle.locked = true;
    let [p, q, r] = [crank, coupler, rocker].map(|l| 0.5 * l);
    let joints = [
        revolute(None, [0.0; 2], 0, [-p, 0.0]),
        revolute(Some(0), [p, 0.0], 1, [-q, 0.0]),
        revolute(Some(2), [r, 0.0], 1, [q, 0.0]),
        revolute(None, [1.0, 0.0], 2, [-r, 0.0]),
    ];
    FourBar(Linkage::new(&bodies, &joints, 1.0))
}

/// A bar of 2 m on three parallel cranks of 0.5 m at (-1, 0), (0, 0), (1, 0): the third says nothing new.
pub fn parallelogram(angle: f64) -> Parallelogram<f64> {
    let (s, c) = angle.sin_cos();
    let crank = |x: f64| (0.5, 0.5 * 0.25 / 12.0, pose(x + 0.25 * c, 0.25 * s, angle));
    let bodies = [(2.0, 8.0 / 12.0, pose(0.5 * c, 0.5 * s, 0.0)), crank(-1.0), crank(0.0), crank(1.0)];
    let joint = |k: usize, x: f64| {
        [revolute(None, [x, 0.0], k, [-0.25, 0.0]), revolute(Some(0), [x, 0.0], k, [0.25, 0.0])]
    };
    let joints = [joint(1, -1.0), joint(2, 0.0), joint(3, 1.0)].concat();
    Parallelogram(Linkage::new(&bodies, &joints, 2.0))
}

/// A mechanism whose rows are wrong on purpose: the first row asks for a coordinate to be somewhere else.
pub fn contradictory_pendulum() -> Pendulum<f64> {
    let mut m = pendulum(0.3);
    m.0.rows = [Row::Keep { coordinate: 0, value: 1.0 }, Row::Keep { coordinate: 0, value: 1.25 }];
    m
}
