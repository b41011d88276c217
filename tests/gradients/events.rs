//! Derivatives across impacts, sticking, and events that reset.

use plm::runtime::Seen;
use plm::{By, Cause, Dop853, Dual, Mechanism as _, Moment, Rk4, Sim, mechanism, with_derivatives};

use super::{are_slopes, body};
use crate::scene::Given as _;

mechanism! {
    part spring_to_origin(on: body) {
        force on on: (-(100 N/m)*on.x, 0 N);
    }
    /// A ball that bounces, a block that slides to rest, and a mass on a belt.
    pub Yard {
        param height: m = 1 m;
        param e: 1 = 0.5;
        param g: m/s^2 = 9.81 m/s^2;
        param mu: 1 = 0.3;
        param kinetic: N = 2.4525 N;
        param adhesion: N = 3.924 N;
        param belt: m/s = 0.1 m/s;
        gravity: g;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: height; }
        unilateral floor: ball.y >= 0 m { restitution: e; }
        body block { mass: 10 kg; inertia: 1 kg*m^2; start vx: 3 m/s, locked; }
        constraint level: block.angle = 0;
        unilateral table: block.y >= 0 m;
        friction slip: rate(block.x) within mu*reaction(table);
        body mass { mass: 1 kg; inertia: 1 kg*m^2; start x: 1 m/s*0 s; start vx: belt, locked; }
        constraint upright: mass.angle = 0;
        constraint height: mass.y = 0;
        spring_to_origin spring(mass);
        friction grip: rate(mass.x - belt*t) within kinetic { static: adhesion; }
    }
}

/// Height of a ball that has fallen from `h` and bounced: flights of 2 e^n sqrt(2 h/g).
pub fn bounced([h, e, g]: [f64; 3], t: f64) -> f64 {
    let fall = (2.0 * h / g).sqrt();
    if t < fall {
        return h - 0.5 * g * t * t;
    }
    let (mut began, mut speed) = (fall, e * (2.0 * g * h).sqrt());
    while t > began + 2.0 * speed / g {
        (began, speed) = (began + 2.0 * speed / g, e * speed);
    }
    speed * (t - began) - 0.5 * g * (t - began) * (t - began)
}

#[test]
fn of_a_ball_by_height_restitution_and_gravity() {
    let by = [By::Parameter("height"), By::Parameter("e"), By::Parameter("g")];
    let mut sim = with_derivatives(&Yard::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    // The first flight ends at 0.4515 s, the third at 1.2415 s.
    for t in [0.3, 0.6, 1.0, 1.2, 1.27] {
        sim.step_to(t.into()).unwrap();
        let Dual { value, tangents } = sim.ball().y;
        assert!((value - bounced([1.0, 0.5, 9.81], t)).abs() < 1e-12);
        are_slopes(tangents, |p| bounced(p, t), [1.0, 0.5, 9.81], 2e-10);
    }
    // It rests.
    sim.step_to(1.5.into()).unwrap();
    assert!(sim.ball().y.tangents.iter().chain(&sim.ball().vy.tangents).all(|tangent| tangent.abs() < 1e-12));
}

/// The impact falls on the end of a step that ends for another reason.
#[test]
fn of_an_impact_at_the_end_of_a_step() {
    let by = [By::Parameter("height"), By::Parameter("e"), By::Parameter("g")];
    let mut sim = with_derivatives(&Yard::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    let fall = (2.0_f64 / 9.81).sqrt();
    for t in [fall, 2.0 * fall, 2.0 * fall + 0.1] {
        sim.step_to(t.into()).unwrap();
    }
    let t = 2.0 * fall + 0.1;
    are_slopes(sim.ball().y.tangents, |p| bounced(p, t), [1.0, 0.5, 9.81], 2e-10);
}

#[test]
fn of_a_stopping_way_by_friction_and_speed() {
    let by = [By::Parameter("mu"), By::Start("block.vx"), By::Parameter("g")];
    let mut sim = with_derivatives(&Yard::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    sim.step_to(2.0.into()).unwrap();
    are_slopes(sim.block().x.tangents, |[mu, v, g]| v * v / (2.0 * mu * g), [0.3, 3.0, 9.81], 1e-10);
}

/// Place of a mass on a belt that sticks for the n-th time since it broke away first.
pub fn stuck([kinetic, adhesion, belt]: [f64; 3], t: f64, n: i32) -> f64 {
    let (k, w) = (100.0, 10.0);
    let lead = (adhesion - kinetic) / k;
    // From adhesion/k with the speed of the belt around kinetic/k, until it has that speed again.
    let slips = 2.0 / w * (core::f64::consts::PI - (lead * w / belt).atan());
    let sticks = 2.0 * lead / belt;
    let caught = adhesion / k / belt + f64::from(n) * slips + f64::from(n - 1) * sticks;
    kinetic / k - lead + belt * (t - caught)
}

#[test]
fn of_a_period_of_stick_and_slip_by_each_coefficient() {
    let by = [By::Parameter("kinetic"), By::Parameter("adhesion"), By::Parameter("belt")];
    let at = [2.4525, 3.924, 0.1];
    let mut sim = with_derivatives(&Yard::new(), by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    for (n, t) in [(1, 0.95), (2, 1.6), (3, 2.3), (5, 3.9)] {
        sim.step_to(t.into()).unwrap();
        let Dual { value, tangents } = sim.mass().x;
        assert!((value - stuck(at, t, n)).abs() < 1e-11, "{n} {value} {}", stuck(at, t, n));
        are_slopes(tangents, |p| stuck(p, t, n), at, 1e-9);
    }
}

/// Steps of one length switch at their ends: derivatives err by the length, as values do.
#[test]
fn of_steps_of_one_length() {
    let by = [By::Parameter("kinetic"), By::Parameter("adhesion"), By::Parameter("belt")];
    let mut sim = with_derivatives(&Yard::new(), by).unwrap().start_with(Rk4::new(1e-4.into())).unwrap();
    sim.step_to(1.6.into()).unwrap();
    are_slopes(sim.mass().x.tangents, |p| stuck(p, 1.6, 2), [2.4525, 3.924, 0.1], 1e-2);
}

scene! {
    /// A mass that is thrown back where it comes to `turns`, and two that are thrown back at once.
    pub Thrown {
        param turns: m = 1 m;
        param other: m = 1 m;
        gravity: 10 m/s^2;
        body a { mass: 1 kg; inertia: 1 kg*m^2; start vx: 2 m/s, locked; }
        constraint level: a.angle = 0;
        constraint flat: a.y = 0;
        when a.x > turns { a.vx = -0.5*a.vx; }
        body b { mass: 1 kg; inertia: 1 kg*m^2; start vx: 2 m/s, locked; }
        constraint level_of_b: b.angle = 0;
        constraint flat_of_b: b.y = 0;
        when b.x > other { b.vx = -0.5*b.vx; }
        param top: m = 5 m;
        body c { mass: 1 kg; inertia: 1 kg*m^2; start vy: 2 m/s, locked; }
        constraint level_of_c: c.angle = 0;
        when c.y > top { c.vx = 1 m/s; }
    }
}

#[test]
fn of_a_state_that_an_event_resets() {
    let thrown = Thrown::new().with("other", 5.0);
    let by = [By::Parameter("turns"), By::Start("a.vx")];
    let mut sim = with_derivatives(&thrown, by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    sim.step_to(0.9.into()).unwrap();
    let place = |[turns, v]: [f64; 2]| turns - 0.5 * v * (0.9 - turns / v);
    are_slopes(body(sim.state(), "a").x.tangents, place, [1.0, 2.0], 1e-10);
}

/// x = v t comes to the place where it is thrown back at t = turns/v.
#[test]
fn of_the_time_of_an_event() {
    let thrown = Thrown::new().with("other", 5.0);
    let by = [By::Parameter("turns"), By::Start("a.vx")];
    let mut sim = with_derivatives(&thrown, by).unwrap().start_with(Dop853::new(1e-12.into())).unwrap();
    let mut times = Vec::new();
    let see = |seen: Seen<'_, _>| {
        if let Seen::Switched(state) = seen {
            times.push(Moment::time(state));
        }
    };
    Sim::watch(&mut sim, 0.6.into(), 0.6.into(), see).unwrap();
    assert!((times[0].value - 0.5).abs() < 1e-13);
    are_slopes(times[0].tangents, |[turns, v]| turns / v, [1.0, 2.0], 1e-11);
}

/// Both are thrown at 0.5 s; only one by the parameter.
#[test]
fn of_two_events_at_once_there_are_none() {
    let mut sim = with_derivatives(&Thrown::new(), [By::Parameter("turns")])
        .unwrap()
        .start_with(Dop853::new(1e-12.into()))
        .unwrap();
    let fault = sim.step_to(0.9.into()).unwrap_err();
    assert!(matches!(fault.cause, Cause::AtOnce { .. }), "{fault}");
    assert!((fault.time - 0.5).abs() < 1e-12);
}

/// What is thrown up at 2 m/s turns round at 0.2 m: a micrometre below it passes at 2 mm/s, 5e-15 m below it only touches.
#[test]
fn of_a_graze_there_are_none() {
    let run = |below: f64| {
        let thrown = Thrown::new().with("other", 5.0).with("turns", 5.0).with("top", 0.2 - below);
        let by = with_derivatives(&thrown, [By::Parameter("top")]).unwrap();
        let mut sim = by.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(0.9.into()).map(|()| body(sim.state(), "c").x)
    };
    // x = 0.9 - (2 - sqrt(4 - 20 top))/10.
    let by_top = run(1e-6).unwrap().tangents[0];
    let known = -1.0 / (4.0 - 20.0 * (0.2 - 1e-6_f64)).sqrt();
    assert!((by_top / known - 1.0).abs() < 1e-8, "{by_top} {known}");
    let fault = run(5e-15).unwrap_err();
    assert!(fault.cause == Cause::Grazes && (fault.time - 0.2).abs() < 1e-6, "{fault}");
}

#[test]
fn by_a_name_that_is_not_there() {
    let unknown = |by| with_derivatives(&Yard::new(), [by]).map(|_| ()).unwrap_err().to_string();
    assert_eq!(unknown(By::Parameter("heigth")), "there is no parameter `heigth`");
    assert_eq!(unknown(By::Start("ball.z")), "there is no start value `ball.z`");
}
