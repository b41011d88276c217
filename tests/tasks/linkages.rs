//! Tasks of linkages: motions and forces beside closed forms of their loops.

use std::f64::consts::{PI, TAU};

use super::{G, check};

/// An angle and its derivatives by the time.
type Motion = [f64; 3];

/// A four-bar linkage by its lengths: crank, coupler, rocker and ground, which lies along x.
struct FourBar([f64; 4]);

impl FourBar {
    /// Motions of coupler and rocker, with the wrist to the left of the line from the crank's pin to the rocker's pivot: the law of
    /// cosines, and R. L. Norton, Design of Machinery, equations 6.18 and 7.12.
    fn at(&self, [angle, speed, gain]: Motion) -> [Motion; 2] {
        let Self([a, b, c, d]) = *self;
        let (sin, cos) = angle.sin_cos();
        let (x, y) = (d - a * cos, -a * sin);
        let squares = b * b - c * c + x * x + y * y;
        let coupler = y.atan2(x) + (squares / (2.0 * b * x.hypot(y))).acos();
        let rocker = (b * coupler.sin() - y).atan2(b * coupler.cos() - x);
        let between = (coupler - rocker).sin();
        let coupler_speed = -a * speed / b * (angle - rocker).sin() / between;
        let rocker_speed = -a * speed / c * (angle - coupler).sin() / between;
        // The loop's second derivative along the rocker, and along the coupler.
        let along = |to: f64| {
            a * (gain * (angle - to).sin() + speed * speed * (angle - to).cos())
                + b * coupler_speed * coupler_speed * (coupler - to).cos()
                - c * rocker_speed * rocker_speed * (rocker - to).cos()
        };
        [
            [coupler, coupler_speed, -along(rocker) / (b * between)],
            [rocker, rocker_speed, -along(coupler) / (c * between)],
        ]
    }
}

/// Place, velocity and acceleration of a point.
type Point = [[f64; 2]; 3];

/// A point at a place of a bar, in the bar's axes from a point of it that is known.
fn point(from: Point, [angle, speed, gain]: Motion, [x, y]: [f64; 2]) -> Point {
    let (sin, cos) = angle.sin_cos();
    let arm = [x * cos - y * sin, x * sin + y * cos];
    let across = [-arm[1], arm[0]];
    let [place, velocity, acceleration] = from;
    [0, 1]
        .map(|k| {
            [
                place[k] + arm[k],
                velocity[k] + speed * across[k],
                acceleration[k] + gain * across[k] - speed * speed * arm[k],
            ]
        })
        .transposed()
}

/// Rows and columns of numbers that belong to x and y.
trait Transposed {
    fn transposed(self) -> Point;
}

impl Transposed for [[f64; 3]; 2] {
    fn transposed(self) -> Point {
        [0, 1, 2].map(|k| [self[0][k], self[1][k]])
    }
}

/// A point of the ground.
const fn pivot(x: f64) -> Point {
    [[x, 0.0], [0.0; 2], [0.0; 2]]
}

/// Where crank and coupler are in line, the wiper turns round; where crank and ground are, its transmission angle is extreme.
#[test]
fn a_wiper() {
    let [a, b, c, d] = [60.0, 280.0, 100.0, 300.0_f64];
    let angle = |one: f64, other: f64, opposite: f64| {
        ((one * one + other * other - opposite * opposite) / (2.0 * one * other)).acos()
    };
    let swept = angle(c, d, b + a) - angle(c, d, b - a);
    // From crank and coupler stretched to folded.
    let leftwards = PI + angle(d, b - a, c) - angle(d, b + a, c);
    let turn = TAU / (45.0 * TAU / 60.0);
    let [to_left, to_right] = [leftwards / TAU * turn, (1.0 - leftwards / TAU) * turn];
    check(
        "wiper",
        &[
            ("swept angle", swept.to_degrees(), 1e-9),
            ("way to the left", to_left, 1e-9),
            ("way to the right", to_right, 1e-9),
            ("transmission angle, crank towards the pivot", angle(b, c, d - a).to_degrees(), 1e-9),
            ("transmission angle, crank away from it", angle(b, c, d + a).to_degrees(), 1e-9),
        ],
    );
}

/// Angles, speeds and accelerations beside those that Norton prints for this linkage: 20.30 and 57.33 deg, -4.121 and 6.998 rad/s,
/// 296.089 and 470.134 rad/s^2 (Design of Machinery, examples 4-1, 6-7 and 7-1); and all digits beside the closed form.
#[test]
fn a_four_bar() {
    let crank = [40_f64.to_radians(), 25.0, 15.0];
    let [coupler, rocker] = FourBar([0.04, 0.12, 0.08, 0.1]).at(crank);
    for (found, printed, digit) in [
        (coupler[0].to_degrees(), 20.30, 0.01),
        (rocker[0].to_degrees(), 57.33, 0.01),
        (coupler[1], -4.121, 1e-3),
        (rocker[1], 6.998, 1e-3),
        (coupler[2], 296.089, 1e-3),
        (rocker[2], 470.134, 1e-3),
    ] {
        assert!((found - printed).abs() < digit, "{found} instead of {printed}");
    }
    let pin = point(pivot(0.0), crank, [0.04, 0.0]);
    let [place, velocity, acceleration] = point(pin, coupler, [0.06, 0.04]);
    check(
        "kinematics",
        &[
            ("coupler angle", coupler[0].to_degrees(), 1e-9),
            ("coupler speed", coupler[1], 1e-9),
            ("coupler acceleration", coupler[2], 1e-8),
            ("rocker angle", rocker[0].to_degrees(), 1e-9),
            ("rocker speed", rocker[1], 1e-9),
            ("rocker acceleration", rocker[2], 1e-8),
            ("tracer x", place[0], 1e-12),
            ("tracer y", place[1], 1e-12),
            ("tracer speed along x", velocity[0], 1e-10),
            ("tracer speed along y", velocity[1], 1e-10),
            ("tracer acceleration along x", acceleration[0], 1e-8),
            ("tracer acceleration along y", acceleration[1], 1e-8),
        ],
    );
}

/// Inverse kinematics of each half: the elbow by the law of cosines, its motion by the constant length of the rod.
#[test]
fn a_five_bar() {
    let half = |t: f64, motor: f64, side: f64| -> Motion {
        let (arm, rod, rate) = (0.12, 0.16, PI);
        let (sin, cos) = (rate * t).sin_cos();
        let pen = [0.04 * cos - motor, 0.2 + 0.04 * sin];
        let (velocity, acceleration) =
            ([-0.04 * rate * sin, 0.04 * rate * cos], [-0.04 * rate * rate * cos, -0.04 * rate * rate * sin]);
        let reach = pen[0].hypot(pen[1]);
        let bend = ((arm * arm + reach * reach - rod * rod) / (2.0 * arm * reach)).acos();
        let angle = pen[1].atan2(pen[0]) + side * bend;
        let elbow = [arm * angle.cos(), arm * angle.sin()];
        let (across, along) = ([-elbow[1], elbow[0]], [pen[0] - elbow[0], pen[1] - elbow[1]]);
        let dot = |u: [f64; 2], v: [f64; 2]| u[0] * v[0] + u[1] * v[1];
        let speed = dot(along, velocity) / dot(along, across);
        let slip = [velocity[0] - speed * across[0], velocity[1] - speed * across[1]];
        let gain = (dot(along, acceleration) + speed * speed * dot(along, elbow) + dot(slip, slip))
            / dot(along, across);
        [angle, speed, gain]
    };
    let (left, right) = (half(0.3, -0.05, 1.0), half(0.3, 0.05, -1.0));
    let fastest = (0..=200).map(|k| half(0.01 * f64::from(k), -0.05, 1.0)[1].abs()).fold(0.0, f64::max);
    check(
        "five_bar",
        &[
            ("left motor at 0.3 s", left[0].to_degrees(), 1e-8),
            ("right motor at 0.3 s", right[0].to_degrees(), 1e-8),
            ("left motor turns with", left[1], 1e-9),
            ("right motor turns with", right[1], 1e-9),
            ("left motor speeds up by", left[2], 1e-8),
            ("right motor speeds up by", right[2], 1e-8),
            ("left motor turns with at most", fastest, 1e-9),
        ],
    );
}

/// The equations of an arm of two links, by the angle of the second against the first (M. W. Spong, S. Hutchinson, M. Vidyasagar, Robot
/// Modeling and Control, two-link planar manipulator), and the motion of least jerk.
#[test]
fn an_arm() {
    let motion = |t: f64, from: f64, by: f64| -> Motion {
        let [s, v, a] = [
            t * t * t * (10.0 + t * (6.0 * t - 15.0)),
            30.0 * t * t * (1.0 + t * (t - 2.0)),
            60.0 * t * (1.0 + t * (2.0 * t - 3.0)),
        ];
        [from + by * s, by * v, by * a].map(f64::to_radians)
    };
    let (m1, l1, c1, i1) = (5.0, 0.5, 0.25, 5.0 * 0.25 / 12.0);
    // The second link with the load at its end.
    let (m2, c2) = (5.0, (3.0 * 0.2 + 2.0 * 0.4) / 5.0);
    let i2 = 3.0 * 0.16 / 12.0 + 3.0 * (0.2_f64 - c2).powi(2) + 2e-3 + 2.0 * (0.4_f64 - c2).powi(2);
    let torques = |t: f64| {
        let ([q1, v1, a1], [q2, v2, a2]) = (motion(t, -60.0, 90.0), motion(t, 90.0, -70.0));
        let coupling = m2 * l1 * c2;
        let (h, cos) = (-coupling * q2.sin(), q2.cos());
        let m12 = i2 + m2 * c2 * c2 + coupling * cos;
        let m11 = i1 + i2 + m1 * c1 * c1 + m2 * (l1 * l1 + c2 * c2) + 2.0 * coupling * cos;
        let hand = m2 * c2 * G * (q1 + q2).cos();
        let first =
            m11 * a1 + m12 * a2 + h * (2.0 * v1 * v2 + v2 * v2) + (m1 * c1 + m2 * l1) * G * q1.cos() + hand;
        let second = m12 * a1 + (i2 + m2 * c2 * c2) * a2 - h * v1 * v1 + hand;
        ([first, second], first * v1 + second * v2)
    };
    let ([shoulder, elbow], power) = torques(0.4);
    let most = |k: usize| (0..=100).map(|i| torques(0.01 * f64::from(i)).0[k].abs()).fold(0.0, f64::max);
    check(
        "inverse_open",
        &[
            ("shoulder at 0.4 s", shoulder, 1e-9),
            ("elbow at 0.4 s", elbow, 1e-9),
            ("shoulder at most", most(0), 1e-9),
            ("elbow at most", most(1), 1e-9),
            ("power of both at 0.4 s", power, 1e-8),
        ],
    );
}

/// The power of the motor is the rate of all energies, and the ground feels weights less masses times accelerations.
#[test]
fn a_four_bar_that_turns_steadily() {
    let (linkage, speed) = (FourBar([0.1, 0.28, 0.25, 0.3]), 240.0 * TAU / 60.0);
    let (mut torque, mut torque_at, mut shaking) = (0.0_f64, 0.0, 0.0_f64);
    for degree in 0..360 {
        let crank = [f64::from(degree).to_radians(), speed, 0.0];
        let [coupler, rocker] = linkage.at(crank);
        let pin = point(pivot(0.0), crank, [0.1, 0.0]);
        let bodies = [
            (1.0, point(pivot(0.0), crank, [0.05, 0.0])),
            (3.0, point(pin, coupler, [0.14, 0.0])),
            (2.0, point(pivot(0.3), rocker, [0.125, 0.0])),
        ];
        let turning = 0.04 * coupler[1] * coupler[2] + 2.0 * 0.0625 / 12.0 * rocker[1] * rocker[2];
        let (mut power, mut force) = (turning, [0.0, 0.0]);
        for (mass, [_, velocity, acceleration]) in bodies {
            let needed = [mass * acceleration[0], mass * (acceleration[1] + G)];
            power += needed[0] * velocity[0] + needed[1] * velocity[1];
            force = [force[0] - needed[0], force[1] - needed[1]];
        }
        if (power / speed).abs() > torque.abs() {
            (torque, torque_at) = (power / speed, f64::from(degree));
        }
        shaking = shaking.max(force[0].hypot(force[1]));
    }
    check(
        "inverse_closed",
        &[
            ("largest torque", torque, 1e-8),
            ("at a crank angle of", torque_at, 0.0),
            ("largest force on the ground", shaking, 1e-7),
        ],
    );
}

/// Virtual work: the force of the hand over that of the jaw is the ratio of the ways that they go.
#[test]
fn a_toggle_clamp() {
    let force = |degrees: f64| {
        let (handle, link, jaw) = (25.0_f64, 35.0_f64, 35.0_f64);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let pin = [handle * cos, handle * sin];
        // The knuckle is at both lengths from the pin and the pivot of the jaw; to the left of the line from pin to pivot.
        let (x, y) = (60.0 - pin[0], -35.0 - pin[1]);
        let far = x.hypot(y);
        let knee = ((link * link + far * far - jaw * jaw) / (2.0 * link * far)).acos();
        let direction = y.atan2(x) + knee;
        let along = [direction.cos(), direction.sin()];
        let knuckle = [pin[0] + link * along[0] - 60.0, pin[1] + link * along[1] + 35.0];
        // Along the link, pin and knuckle are equally fast.
        let by_handle = -along[0] * pin[1] + along[1] * pin[0];
        let by_jaw = -along[0] * knuckle[1] + along[1] * knuckle[0];
        2000.0 * 0.08 * by_handle / by_jaw / 0.15
    };
    check(
        "toggle",
        &[
            ("force of the hand at 30 deg", force(30.0), 1e-8),
            ("at 10 deg", force(10.0), 1e-8),
            ("at 2 deg", force(2.0), 1e-8),
            ("at 2 deg beyond the line, where it holds by itself", force(-2.0), 1e-8),
        ],
    );
}
