//! A compass that walks down a slope: two legs on a hip, without knees.

use plm::{Dop853, Sim, mechanism};

use crate::compass::{SLOPE, State, step, walked};
use crate::near;

mechanism! {
    /// A. Goswami, B. Thuilot, B. Espiau, A study of the passive gait of a compass-like biped robot, Int. J. Robotics Research 17,
    /// 1998: 10 kg at the hip, 5 kg in the middle of each leg of 1 m. Each leg has half of the hip here. The slope lies along x.
    pub Compass {
        gravity: 9.81 m/s^2*(sin(3 deg), -cos(3 deg));
        discrete left_is_on: 1 = 1;
        discrete right_is_on: 1 = 0;
        discrete struck: s = 0 s;
        discrete steps: 1 = 0;
        body left {
            mass: 10 kg; inertia: 0.625 kg*m^2; port hip: (0, 250) mm; port foot: (0, -750) mm;
            start angle: 0 rad, locked; start omega: 0 rad/s, locked;
        }
        body right {
            mass: 10 kg; inertia: 0.625 kg*m^2; port hip: (0, 250) mm; port foot: (0, -750) mm;
            start angle: 0 rad, locked; start omega: 0 rad/s, locked;
        }
        revolute hip(left.hip, right.hip);
        unilateral left_foot: left.foot.y >= 0 m { when: left_is_on > 0.5; }
        unilateral right_foot: right.foot.y >= 0 m { when: right_is_on > 0.5; }
        friction left_grips: rate(left.foot.x) within 100*reaction(left_foot) { when: left_is_on > 0.5; }
        friction right_grips: rate(right.foot.x) within 100*reaction(right_foot) { when: right_is_on > 0.5; }
        // The leg that swings passes the ground beside the other foot; what is ahead and above can strike again.
        when right.foot.x > left.foot.x + 0.1 m and right.foot.y > 0.1 mm { right_is_on = 1; }
        when left.foot.x > right.foot.x + 0.1 m and left.foot.y > 0.1 mm { left_is_on = 1; }
        when right_is_on > 0.5 and is_open(left_foot) and not is_open(right_foot) { left_is_on = 0; struck = t; steps = steps + 1; }
        when left_is_on > 0.5 and is_open(right_foot) and not is_open(left_foot) { right_is_on = 0; struck = t; steps = steps + 1; }
        output struck, steps, right.foot.x, left.foot.x;
    }
}

/// The start of a step with the left leg.
fn start([s, n, w, u]: State) -> Sim<Compass> {
    let mut compass = Compass::new();
    let [(left, sl, cl), (right, sr, cr)] =
        [s + SLOPE, n + SLOPE].map(|angle| (angle, angle.sin(), angle.cos()));
    let hip = [-sl, cl];
    let bodies = &mut compass.start;
    (bodies.left.angle.value, bodies.left.omega.value) = (left, w);
    (bodies.right.angle.value, bodies.right.omega.value) = (right, u);
    (bodies.left.x.value, bodies.left.y.value) = (-0.75 * sl, 0.75 * cl);
    (bodies.right.x.value, bodies.right.y.value) = (hip[0] + 0.25 * sr, hip[1] - 0.25 * cr);
    (bodies.left.vx.value, bodies.left.vy.value) = (-0.75 * cl * w, -0.75 * sl * w);
    (bodies.right.vx.value, bodies.right.vy.value) = (-cl * w + 0.25 * cr * u, -sl * w + 0.25 * sr * u);
    compass.start_with(Dop853::new(1e-12)).unwrap()
}

/// From a state near the cycle to the cycle: the period is 0.734 s by the paper, and every state behind a heel strike that of the equations.
#[test]
fn a_compass_walks_down_a_slope() {
    let mut x = [0.22, -0.22 - 2.0 * SLOPE, -1.1, -0.4];
    let mut sim = start(x);
    let (mut time, mut last) = (0.0, 0.0);
    for k in 1..=28 {
        let (period, next) = walked(x);
        (x, time, last) = (next, time + period, period);
        sim.step_to(time + 1e-6).unwrap();
        near(sim.steps(), f64::from(k), 0.0);
        near(sim.struck(), time, 1e-9);
        let behind = step(x, 1e-6);
        let (left, right) = (sim.left(), sim.right());
        let found = [left.angle - SLOPE, right.angle - SLOPE, left.omega, right.omega];
        let found = if k % 2 == 0 { found } else { [found[1], found[0], found[3], found[2]] };
        for (found, known) in found.into_iter().zip(behind) {
            near(found, known, 1e-8);
        }
    }
    near(last, 0.734, 5e-4);
    let (_, next) = walked(x);
    for (next, x) in next.into_iter().zip(x) {
        near(next, x, 1e-8);
    }
    assert_eq!(sim.contact_stats().impacts, 28);
}
