//! Derivatives of either side where there are none of both, against closed forms and differences of runs on that side.

use plm::{
    By, Cause, Dop853, Fault, Mechanism as _, Side, Term, Trace, with_derivatives, with_side, with_trace,
};

use super::body;
use super::events::Thrown;
use crate::scene::{Given as _, Scene};

/// The derivative after a place of what is smooth there, of three values beside it: its error is of second order.
fn beside(f: impl Fn(f64) -> f64, at: f64, side: Side) -> f64 {
    let h = if side == Side::Above { 1e-5 } else { -1e-5 };
    (-2.5 * f(at + h) + 4.0 * f(at + 2.0 * h) - 1.5 * f(at + 3.0 * h)) / h
}

/// Asserts that a derivative of a side is the known one, to 1e-10, and that of differences of runs.
#[track_caller]
fn is_slope(found: f64, known: f64, run: impl Fn(f64) -> f64, at: f64, side: Side) {
    assert!((found - known).abs() < 1e-10, "{side:?}: {found} is not {known}");
    let difference = beside(run, at, side);
    assert!((found - difference).abs() < 1e-7, "{side:?}: {found} is not {difference}");
}

scene! {
    /// A ball that is thrown up below a ceiling.
    pub Hall {
        param speed: m/s = 2 m/s;
        param height: m = 0.2 m;
        gravity: 10 m/s^2;
        body ball { mass: 1 kg; inertia: 1 kg*m^2; start vy: speed, locked; }
        unilateral ceiling: ball.y <= height { restitution: 0.5; }
    }
}

/// At 2 m/s it comes to 0.2 m: a slower ball, or below a higher ceiling, does not touch, and the other side has an infinite derivative.
#[test]
fn of_a_ball_that_touches_a_ceiling() {
    let hall = Hall::new().with("height", 0.2 - 5e-15);
    let t = 0.3;
    let run = |by, side| {
        let mut sim = with_side(&hall, by, side).unwrap().start_with(Dop853::new(1e-12.into()))?;
        sim.step_to(t.into())?;
        Ok::<_, Fault>((body(sim.state(), "ball").y.value(), side.derivative(body(sim.state(), "ball").y)))
    };
    let (speed, height) = (By::Parameter("speed"), By::Parameter("height"));
    let plain = |hall: Scene| {
        let mut sim = hall.start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(t).unwrap();
        body(sim.state(), "ball").y
    };
    let (y, slower) = run(speed, Side::Below).unwrap();
    assert!((y - (2.0 * t - 5.0 * t * t)).abs() < 1e-12, "{y}");
    is_slope(slower, t, |speed| plain(Hall::new().with("speed", speed)), 2.0, Side::Below);
    let (_, higher) = run(height, Side::Above).unwrap();
    is_slope(higher, 0.0, |height| plain(Hall::new().with("height", height)), 0.2, Side::Above);
    for outcome in [run(speed, Side::Above), run(height, Side::Below)] {
        assert_eq!(outcome.unwrap_err().cause, Cause::Grazes);
    }
}

scene! {
    /// Two masses come to their places at one time. The first adds to the speed of the second, which doubles its own.
    pub Pair {
        param place: m = 1 m;
        body a { mass: 1 kg; inertia: 1 kg*m^2; start vx: 2 m/s, locked; }
        constraint a_level: a.angle = 0;
        constraint a_flat: a.y = 0;
        body b { mass: 1 kg; inertia: 1 kg*m^2; start vx: 2 m/s, locked; }
        constraint b_level: b.angle = 0;
        constraint b_flat: b.y = 0;
        when a.x > place { b.vx = b.vx + 1 m/s; }
        when b.x > 1 m { b.vx = 2*b.vx; }
    }
}

/// Beyond 1 m the doubling comes first: 1 + 4 (p/2 - 1/2) + 5 (T - p/2). Before it the sum: at p/2 it is 3 m/s, at p/2 + (1 - p)/3 6 m/s.
#[test]
fn of_two_events_at_once() {
    let plain = |place| {
        let mut sim = Pair::new().with("place", place).start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.9).unwrap();
        body(sim.state(), "b").x
    };
    for (side, known, value) in [(Side::Above, -0.5, 1.0 + 5.0 * 0.4), (Side::Below, -1.0, 1.0 + 6.0 * 0.4)] {
        let own = with_side(&Pair::new(), By::Parameter("place"), side).unwrap();
        let mut sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(0.9.into()).unwrap();
        let x = body(sim.state(), "b").x;
        assert!((x.value() - value).abs() < 1e-12, "{side:?} {x:?}");
        is_slope(side.derivative(x), known, plain, 1.0, side);
    }
}

/// Where the two do not change each other both sides have the same derivative.
#[test]
fn of_two_events_that_do_not_meet() {
    for side in [Side::Above, Side::Below] {
        let own = with_side(&Thrown::new(), By::Parameter("turns"), side).unwrap();
        let mut sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(0.9.into()).unwrap();
        // turns - (0.9 - turns/2).
        let (a, b) = (side.derivative(body(sim.state(), "a").x), side.derivative(body(sim.state(), "b").x));
        assert!((a - 1.5).abs() < 1e-11 && b.abs() < 1e-11, "{a} {b}");
    }
}

scene! {
    /// A bar of two half lengths 0.5 m falls on two supports.
    pub Bar {
        param tilt: rad = 0 rad;
        gravity: 10 m/s^2;
        body bar {
            mass: 1 kg; inertia: 0.2 kg*m^2; start y: 0.2 m, locked; start angle: tilt, locked;
            port left: (-0.5, 0) m; port right: (0.5, 0) m;
        }
        unilateral left: bar.left.y >= 0 m { restitution: 0.5; }
        unilateral right: bar.right.y >= 0 m { restitution: 0.5; }
    }
}

/// Level, both ends strike at once. Tilted to either side the lower one is first, and the other has another speed when it strikes.
#[test]
fn of_two_impacts_at_once_in_either_order() {
    let plain = |tilt| {
        let mut sim = Bar::new().with("tilt", tilt).start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(0.25).unwrap();
        [body(sim.state(), "bar").y, body(sim.state(), "bar").angle]
    };
    for side in [Side::Above, Side::Below] {
        let own = with_side(&Bar::new(), By::Parameter("tilt"), side).unwrap();
        let mut sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(0.25.into()).unwrap();
        let [y, angle] = [body(sim.state(), "bar").y, body(sim.state(), "bar").angle];
        let near = plain(if side == Side::Above { 1e-9 } else { -1e-9 });
        assert!((y.value() - near[0]).abs() < 1e-7 && (angle.value() - near[1]).abs() < 1e-7, "{near:?}");
        for (k, found) in [y, angle].into_iter().enumerate() {
            let difference = beside(|tilt| plain(tilt)[k], 0.0, side);
            let found = side.derivative(found);
            assert!(
                (found - difference).abs() < 1e-4 * difference.abs().max(1.0),
                "{k} {side:?} {found} {difference}"
            );
        }
    }
}

scene! {
    pub Pushed {
        param push: N = 30 N;
        gravity: 10 m/s^2;
        ground { port o: (0, 0) m; }
        body block { mass: 10 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }
        constraint level: block.angle = 0;
        force hand(block.p) { x: push; }
        unilateral floor: block.y >= 0 m;
        friction slip: rate(block.x) within 0.3*reaction(floor);
    }
}

/// A push of what friction can hold: less moves nothing, more moves by (F - mu m g) t^2/(2 m).
#[test]
fn of_a_friction_at_its_limit() {
    let plain = |push| {
        let mut sim = Pushed::new().with("push", push).start_with(Dop853::new(1e-12)).unwrap();
        sim.step_to(2.0).unwrap();
        body(sim.state(), "block").x
    };
    for (side, known) in [(Side::Above, 4.0 / 20.0), (Side::Below, 0.0)] {
        let own = with_side(&Pushed::new(), By::Parameter("push"), side).unwrap();
        let mut sim = own.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(2.0.into()).unwrap();
        is_slope(side.derivative(body(sim.state(), "block").x), known, plain, 30.0, side);
    }
}

/// To both sides there is no derivative, which is said: at the limit, not beside it, nor by what changes nothing.
#[test]
fn of_a_friction_at_its_limit_there_is_none_to_both_sides() {
    let started = |push, by| {
        let pushed = Pushed::new().with("push", push);
        let own = with_derivatives(&pushed, [by]).unwrap();
        let mut sim = own.start_with(Dop853::new(1e-12.into()))?;
        sim.step_to(2.0.into())?;
        Ok::<_, Fault>(body(sim.state(), "block").x.tangents[0])
    };
    let fault = started(30.0, By::Parameter("push")).unwrap_err();
    assert_eq!((fault.cause, fault.part), (Cause::AtLimit, "slip"));
    assert!(fault.to_string().contains("at its limit"), "{fault}");
    // Recorded as well, where it may depend on what the run is derived by.
    let recorded = |by| {
        let (mut terms, by) = (vec![Term::EMPTY; 10_000], [by]);
        let trace = Trace::new(&mut terms, 1);
        with_trace(&Pushed::new(), &by, &trace).unwrap().start().map(|_| ()).map_err(|fault| fault.cause)
    };
    assert_eq!(recorded(By::Parameter("push")), Err(Cause::AtLimit));
    assert_eq!(recorded(By::Start("block.x")), Ok(()));
    assert!((started(30.0, By::Start("block.x")).unwrap() - 1.0).abs() < 1e-12);
    assert!(started(29.999, By::Parameter("push")).unwrap().abs() < 1e-12);
    assert!((started(30.001, By::Parameter("push")).unwrap() - 0.2).abs() < 1e-9);
}

/// Where there are derivatives of both sides they are these.
#[test]
fn of_what_is_smooth() {
    for side in [Side::Above, Side::Below] {
        let hall = Hall::new().with("height", 5.0);
        let found = with_side(&hall, By::Parameter("speed"), side).unwrap();
        let mut sim = found.start_with(Dop853::new(1e-12.into())).unwrap();
        sim.step_to(0.3.into()).unwrap();
        assert!((side.derivative(body(sim.state(), "ball").y) - 0.3).abs() < 1e-12);
    }
}
