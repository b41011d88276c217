//! The limit cycle of a rimless wheel, and its derivatives by the implicit function theorem, against closed forms.

use plm::runtime::Seen;
use plm::{By, Dop853, Dual, Moment, Sim, mechanism, with_derivatives};

use super::are_slopes;

mechanism! {
    /// A wheel of spokes without a rim on a slope that lies along x, from just after an impact: it stands on one spoke, and the next
    /// one comes. T. McGeer, Passive dynamic walking, Int. J. Robotics Research 9, 1990; M. J. Coleman, A stability study of a
    /// three-dimensional passive-dynamic model of human gait, thesis, Cornell 1998.
    pub Wheel {
        param slope: rad = 0.1 rad;
        /// Half the angle between two spokes.
        param half: rad = 22.5 deg;
        param mass: kg = 2 kg;
        param inertia: kg*m^2 = 0.6 kg*m^2;
        param length: m = 0.8 m;
        param speed: rad/s = 1 rad/s;
        gravity: 9.81 m/s^2*(sin(slope), -cos(slope));
        body hub {
            mass: mass; inertia: inertia;
            start x: -length*sin(half), locked; start y: length*cos(half), locked; start angle: half, locked;
            start vx: length*speed*cos(half), locked; start vy: length*speed*sin(half), locked;
            start omega: -speed, locked;
        }
        repeat i in 0..2 {
            let foot = hub.position + turn((0 m, -length), hub.angle + 2*i*half);
            unilateral tip[i]: foot.y >= 0 m;
            friction grip[i]: rate(foot.x) within 100*reaction(tip[i]);
        }
    }
}

/// What the cycle depends on: slope, half, mass, inertia, length.
const NAMES: [&str; 5] = ["slope", "half", "mass", "inertia", "length"];
const VALUES: [f64; 5] = [0.1, std::f64::consts::PI / 8.0, 2.0, 0.6, 0.8];

/// Speed after the next impact and the time of the step, by the speed and by the parameters.
fn step(speed: f64) -> [Dual<f64, 6>; 2] {
    let wheel = Wheel { speed, ..Wheel::new() };
    let mut by = [By::Parameter("speed"); 6];
    for (by, name) in by[1..].iter_mut().zip(NAMES) {
        *by = By::Parameter(name);
    }
    let mut sim = with_derivatives(&wheel, by).unwrap().start_with(Dop853::new(1e-13.into())).unwrap();
    let mut after = None;
    while after.is_none() {
        Sim::watch_towards(&mut sim, 5.0.into(), |seen| {
            if let Seen::Switched(state) = seen {
                after = Some([-state.hub().omega, Moment::time(state)]);
            }
        })
        .unwrap();
    }
    after.unwrap()
}

/// Share of the speed that is left after an impact, and what the square of the speed grows by between two.
fn share_and_gain([slope, half, mass, inertia, length]: [f64; 5]) -> [f64; 2] {
    let (own, about_foot) = (mass * length * length, inertia + mass * length * length);
    let share = (inertia + own * (2.0 * half).cos()) / about_foot;
    [share, 4.0 * mass * 9.81 * length * slope.sin() * half.sin() / about_foot]
}

/// The speed after each impact on the cycle: its square z is share^2 (z + gain).
fn speed_of(at: [f64; 5]) -> f64 {
    let [share, gain] = share_and_gain(at);
    share * (gain / (1.0 - share * share)).sqrt()
}

/// The time of a step on the cycle, by the energy: the integral over the lean of 1/speed, by points and weights of C. F. Gauss.
fn period_of(at: [f64; 5]) -> f64 {
    let ([slope, half, mass, inertia, length], speed) = (at, speed_of(at));
    let pull = 2.0 * mass * 9.81 * length / (inertia + mass * length * length);
    let at_lean = |lean: f64| {
        let square = speed * speed + pull * ((slope - half).cos() - (slope + lean).cos());
        1.0 / square.sqrt()
    };
    let (nodes, parts) = ((0.6_f64).sqrt(), 2000);
    let width = half / f64::from(parts);
    (0..parts)
        .map(|k| {
            let middle = -half + width * f64::from(2 * k + 1);
            let [a, b, c] = [-nodes, 0.0, nodes].map(|node| at_lean(middle + width * node));
            width * (5.0 * a + 8.0 * b + 5.0 * c) / 9.0
        })
        .sum()
}

/// Newton's method on P(v) - v, with the derivative of the run: the multiplier of the cycle is the square of the share.
#[test]
fn of_a_walker_s_limit_cycle() {
    let mut speed = 2.0;
    let mut newton = 0;
    let [after, time] = loop {
        let [after, time] = step(speed);
        let off = after.value - speed;
        if off.abs() < 1e-13 || newton > 8 {
            break [after, time];
        }
        speed -= off / (after.tangents[0] - 1.0);
        newton += 1;
    };
    assert!(newton <= 6, "{newton}");
    assert!((speed - speed_of(VALUES)).abs() < 1e-11, "{speed} {}", speed_of(VALUES));
    assert!((time.value - period_of(VALUES)).abs() < 1e-11);
    let [share, _] = share_and_gain(VALUES);
    let [multiplier, by_parameters @ ..] = after.tangents;
    assert!((multiplier - share * share).abs() < 1e-10, "{multiplier}");
    // v(p) = P(v(p), p): dv/dp = P_p/(1 - P_v); the period goes along.
    let by_speed = by_parameters.map(|by| by / (1.0 - multiplier));
    are_slopes(by_speed, speed_of, VALUES, 1e-9);
    let [along, by_parameters @ ..] = time.tangents;
    let by_period: [f64; 5] = core::array::from_fn(|k| by_parameters[k] + along * by_speed[k]);
    are_slopes(by_period, period_of, VALUES, 1e-9);
}
