//! A compass that walks down a slope: two legs on a hip, without knees.

use plm::{Dop853, Mechanism as _, Sim};

use crate::compass::{Compass as Equations, PAPER, SLOPE, State};
use crate::near;
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A. Goswami, B. Thuilot, B. Espiau, A study of the passive gait of a compass-like biped robot, Int. J. Robotics Research 17,
    /// 1998: 10 kg at the hip, 5 kg in the middle of each leg of 1 m. Each leg has half of the hip here. The slope lies along x.
    pub Compass {
        param g: m/s^2 = 9.81 m/s^2;
        param slope: rad = 3 deg;
        param mass: kg = 10 kg;
        param inertia: kg*m^2 = 0.625 kg*m^2;
        // From the hip to the centre of a leg.
        param reach: m = 0.25 m;
        gravity: g*(sin(slope), -cos(slope));
        discrete left_is_on: 1 = 1;
        discrete right_is_on: 1 = 0;
        discrete struck: s = 0 s;
        discrete steps: 1 = 0;
        body left {
            mass: mass; inertia: inertia; port hip: (0 m, reach); port foot: (0 m, reach - 1 m);
            start angle: 0 rad, locked; start omega: 0 rad/s, locked;
        }
        body right {
            mass: mass; inertia: inertia; port hip: (0 m, reach); port foot: (0 m, reach - 1 m);
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

/// The start of a step with the left leg. Each leg has half of the hip.
fn start(equations: &Equations, [s, n, w, u]: State) -> Sim<Scene> {
    let Equations { hip, leg, from_foot, gravity, slope } = *equations;
    let (below, half) = (1.0 - from_foot, 0.5 * hip);
    let (mass, reach) = (leg + half, leg * below / (leg + half));
    let inertia = leg * half / (leg + half) * below * below;
    let [(left, sl, cl), (right, sr, cr)] =
        [s + slope, n + slope].map(|angle| (angle, angle.sin(), angle.cos()));
    let (hip, up) = ([-sl, cl], 1.0 - reach);
    let numbers = [("g", gravity), ("slope", slope), ("mass", mass), ("reach", reach), ("inertia", inertia)];
    let compass = numbers.into_iter().fold(Compass::new(), |own, (name, value)| own.with(name, value));
    let starts = [
        ("left.angle", left),
        ("left.omega", w),
        ("right.angle", right),
        ("right.omega", u),
        ("left.x", -up * sl),
        ("left.y", up * cl),
        ("right.x", hip[0] + reach * sr),
        ("right.y", hip[1] - reach * cr),
        ("left.vx", -up * cl * w),
        ("left.vy", -up * sl * w),
        ("right.vx", -cl * w + reach * cr * u),
        ("right.vy", -sl * w + reach * sr * u),
    ];
    let compass = starts.into_iter().fold(compass, |own, (name, value)| own.with_start(name, value));
    compass.start_with(Dop853::new(1e-12)).unwrap()
}

/// The state a time of 1e-6 s behind the step `number`, in which the left leg stands if it is even.
fn behind(sim: &Sim<Scene>, slope: f64, number: u32) -> State {
    let (left, right) = (sim.state_of("left"), sim.state_of("right"));
    let found = [left.angle - slope, right.angle - slope, left.omega, right.omega];
    if number.is_multiple_of(2) { found } else { [found[1], found[0], found[3], found[2]] }
}

/// From a state near the cycle to the cycle: the period is 0.734 s by the paper, and every state behind a heel strike that of the equations.
#[test]
fn a_compass_walks_down_a_slope() {
    let mut x = [0.22, -0.22 - 2.0 * SLOPE, -1.1, -0.4];
    let mut sim = start(&PAPER, x);
    let (mut time, mut last) = (0.0, 0.0);
    for k in 1..=28_u32 {
        let (period, next) = PAPER.walked(x);
        (x, time, last) = (next, time + period, period);
        sim.step_to(time + 1e-6).unwrap();
        near(sim.value_of("steps"), f64::from(k), 0.0);
        near(sim.value_of("struck"), time, 1e-9);
        for (found, known) in behind(&sim, SLOPE, k).into_iter().zip(PAPER.step(x, 1e-6)) {
            near(found, known, 1e-8);
        }
    }
    near(last, 0.734, 5e-4);
    let (_, next) = PAPER.walked(x);
    for (next, x) in next.into_iter().zip(x) {
        near(next, x, 1e-8);
    }
    assert_eq!(sim.contact_stats().impacts, 28);
}

/// The state behind the second of two steps on a cycle, which that of the equations is, and the time of that step.
fn on_cycle(equations: &Equations, mut x: State) -> (State, f64) {
    for _ in 0..30 {
        (_, x) = equations.walked(x);
    }
    let mut sim = start(equations, x);
    let (mut time, mut last) = (0.0, 0.0);
    for k in 1..=2 {
        let struck = sim.value_of("struck");
        let (period, next) = equations.walked(x);
        (x, time) = (next, time + period);
        sim.step_to(time + 1e-6).unwrap();
        near(sim.value_of("struck"), time, 1e-8);
        last = sim.value_of("struck") - struck;
        for (found, known) in behind(&sim, equations.slope, k).into_iter().zip(equations.step(x, 1e-6)) {
            near(found, known, 1e-7);
        }
    }
    (behind(&sim, equations.slope, 2), last)
}

/// M. Garcia, A. Chatterjee, A. Ruina, M. Coleman, The simplest walking model: stability, complexity, and scaling, J. Biomechanical
/// Engineering 120, 1998: a mass at the hip, feet without mass, slope 0.009, g = 1 m/s^2. Feet have 0.002 and 0.001 of the hip here; twice
/// the latter less the former is without mass but for the square of it. Angle and rate of the leg that strikes are 0.200310900 and
/// -0.199832473 there, and the step takes 3.882 s.
#[test]
fn the_simplest_walker_has_its_cycle() {
    let slope = 0.009;
    let cycles = [2e-3, 1e-3].map(|leg| {
        let simplest = Equations { hip: 1.0, leg, from_foot: 0.0, gravity: 1.0, slope };
        let x = [0.1913, -0.1913 - 2.0 * slope, -0.2, -0.184];
        on_cycle(&simplest, x)
    });
    let without = |number: fn(&(State, f64)) -> f64| 2.0 * number(&cycles[1]) - number(&cycles[0]);
    near(without(|(x, _)| x[0]) + slope, 0.200_310_900, 3e-6);
    near(without(|(x, _)| x[2]), -0.199_832_473, 3e-6);
    near(without(|(_, period)| *period), 3.882, 5e-4);
}
