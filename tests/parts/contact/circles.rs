//! Points and circles on circles and lines, and what rolls.

use plm::runtime::contact::Mode;
use plm::{Dop853, Sim};

use super::{G, near};

plm::mechanism! {
    /// Balls on a cylinder of 1 m and within it, a bead in a ring, a log on a log, a disc on a slope, a ball and a block on a floor.
    pub Circles {
        param fall: m/s^2 = 9.81 m/s^2;
        gravity: fall;
        ground { port o: (0, 0) m; port slope: (0, 0) m, axis: -20 deg; }

        body slider { mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m; start y: 1.1 m; start vx: 0.1 m/s; }
        circle_on_circle smooth(ground.o, slider.c) { radius_a: 1 m; radius_b: 0.1 m; }
        body roller {
            mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m;
            start y: 1.1 m; start vx: 0.1 m/s; start omega: -1 rad/s;
        }
        circle_on_circle rough(ground.o, roller.c) { radius_a: 1 m; radius_b: 0.1 m; friction: 1e4; }
        body marble {
            mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m;
            start x: -0.9 m*sin(60 deg); start y: -0.9 m*cos(60 deg);
        }
        circle_on_circle bowl(ground.o, marble.c) { side: inside; radius_a: 1 m; radius_b: 0.1 m; friction: 10; }
        body bead { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: -1 m; start vy: -3 m/s; }
        point_on_circle ring(ground.o, bead.c) { side: inside; radius: 1 m; friction: 0.2; }
        body log {
            mass: 1 kg; inertia: disc(1 kg, 0.5 m); port c: (0, 0) m;
            start x: 1.5 m*cos(80 deg); start y: 1.5 m*sin(80 deg); start angle: -30 deg, locked;
        }
        rolling_on_circle pile(ground.o, log.c) { radius_a: 1 m; radius_b: 0.5 m; origin: 90 deg; }
        body hoop {
            mass: 1 kg; inertia: thin_cylinder(1 kg, 0.1 m); port c: (0, 0) m;
            start x: 0.9 m*sin(20 deg); start y: -0.9 m*cos(20 deg); start angle: -9*20 deg, locked;
        }
        rolling_on_circle pipe(ground.o, hoop.c) { side: inside; radius_a: 1 m; radius_b: 0.1 m; origin: -90 deg; }
        body disc {
            mass: 2 kg; inertia: disc(2 kg, 0.1 m); port c: (0, 0) m;
            start x: 0.1 m*sin(20 deg); start y: 0.1 m*cos(20 deg); start angle: -20 deg, locked;
        }
        rolling tyre(ground.slope, disc.c) { radius: 0.1 m; }
        body ball { mass: 3 kg; inertia: sphere(3 kg, 0.1 m); port c: (0, 0) m; start y: 0.1 m; start vx: 5 m/s; }
        circle_on_line bowling(ground.o, ball.c) { radius: 0.1 m; friction: 0.2; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: 1 m; start vx: 5 m/s; }
        point_on_line floor(ground.o, block.c) { restitution: 0.5; friction: 0.1; }

        output smooth.push, rough.push, rough.slip, bowl.push, bowl.gap, ring.push, ring.lost, pile.load, pile.traction;
        output pipe.load, pipe.traction, tyre.traction, tyre.load, tyre.speed, bowling.push, bowling.slip, bowling.drag, bowling.lost;
        output floor.gap, floor.lost;
        allow(W0002);
    }
}

fn run(mechanism: Circles) -> Sim<Circles> {
    mechanism.start_with(Dop853::new(1e-10)).unwrap()
}

/// Runs to where a row opens, by bisection.
fn opens(sim: &mut Sim<Circles>, row: &str) {
    while sim.contact(row) == Some(Mode::Closed) {
        let saved = sim.save();
        sim.step(0.1).unwrap();
        if sim.contact(row) == Some(Mode::Open) {
            let time = sim.time() - 0.1;
            let (mut low, mut high) = (0.0, 0.1);
            for _ in 0..40 {
                let half = 0.5 * (low + high);
                sim.resume(&saved);
                sim.step_to(time + half).unwrap();
                *(if sim.contact(row) == Some(Mode::Closed) { &mut low } else { &mut high }) = half;
            }
            sim.resume(&saved);
            sim.step_to(time + low).unwrap();
            return;
        }
        assert!(sim.time() < 10.0, "{row} does not open");
    }
}

/// A ball that slides off leaves at cos = 2/3 + v^2/(3 g R), one that rolls at (10 + 7 v^2/(g R))/17, with R between the centres.
#[test]
fn balls_leave_a_cylinder() {
    let share = 0.01 / (G * 1.1);
    let mut sim = run(Circles::new());
    near(sim.smooth_push(), G - 0.01 / 1.1, 1e-12);
    opens(&mut sim, "smooth.contact");
    near(sim.slider().y / 1.1, 2.0 / 3.0 + share / 3.0, 1e-9);
    near(sim.smooth_push(), 0.0, 1e-7);
    assert_eq!((sim.slider().omega, sim.contact("smooth.rub")), (0.0, None));

    let mut sim = run(Circles::new());
    near(sim.rough_push(), G - 0.01 / 1.1, 1e-12);
    sim.step(0.5).unwrap();
    near(sim.rough_slip(), 0.0, 1e-9);
    opens(&mut sim, "rough.contact");
    near(sim.roller().y / 1.1, (10.0 + 7.0 * share) / 17.0, 1e-7);
}

/// A ball that rolls in a bowl keeps its energy and turns back at its height; it passes the bottom with N = m g (17 - 10 cos)/7.
#[test]
fn a_ball_rolls_in_a_bowl() {
    let mut sim = run(Circles::new());
    let lowest = |sim: &Sim<Circles>| {
        let marble = sim.marble();
        0.5 * (marble.vx * marble.vx + marble.vy * marble.vy) + 0.5 * 0.004 * marble.omega * marble.omega + G * marble.y
    };
    let energy = lowest(&sim);
    let saved = sim.save();
    let (mut low, mut high) = (0.2, 1.0);
    for _ in 0..45 {
        let half = 0.5 * (low + high);
        sim.resume(&saved);
        sim.step_to(half).unwrap();
        *(if sim.marble().x < 0.0 { &mut low } else { &mut high }) = half;
    }
    near(sim.bowl_push(), G * (17.0 - 10.0 * 0.5) / 7.0, 1e-7);
    near(lowest(&sim), energy, 1e-9);
    // Equal arcs: 0.9 m of the centre's circle are 9 of its own angles.
    near(sim.marble().angle, -9.0 * 60_f64.to_radians(), 1e-8);
    sim.step_to(2.0 * low).unwrap();
    near(sim.marble().y, -0.45, 1e-8);
    assert_eq!(sim.contact("bowl.rub"), Some(Mode::Sticks));
}

/// Without gravity the speed of a bead in a ring falls by exp(-mu angle).
#[test]
fn a_bead_rubs_on_a_ring() {
    let mut sim = run(Circles { fall: 0.0, ..Circles::new() });
    near(sim.ring_push(), 9.0, 1e-12);
    near(sim.ring_lost(), 0.2 * 9.0 * 3.0, 1e-12);
    let (mu, speed, way) = (0.2, 3.0, std::f64::consts::FRAC_PI_2);
    // theta = ln(1 + mu v t)/mu
    sim.step_to(((mu * way).exp() - 1.0) / (mu * speed)).unwrap();
    near(sim.bead().x, 0.0, 1e-9);
    near(sim.bead().vx, 3.0 * (-mu * way).exp(), 1e-9);
}

/// A cylinder on a cylinder: N = m g (7 cos - 4 cos_0)/3, F = m g sin/3; a hoop in a pipe: N = m g (2 cos - cos_0), F = m g sin/2.
#[test]
fn what_rolls_without_slip_bears_its_load() {
    let mut sim = run(Circles::new());
    let start = 10_f64.to_radians().cos();
    for _ in 0..20 {
        sim.step(0.1).unwrap();
        let log = sim.log();
        let (sin, cos) = (log.x / 1.5, log.y / 1.5);
        near(sin.hypot(cos), 1.0, 1e-12);
        near(sim.pile_load(), G * (7.0 * cos - 4.0 * start) / 3.0, 1e-7);
        near(sim.pile_traction(), G * sin / 3.0, 1e-7);
        let hoop = sim.hoop();
        let (sin, cos) = (hoop.x / 0.9, -hoop.y / 0.9);
        near(sim.pipe_load(), G * (2.0 * cos - 20_f64.to_radians().cos()), 1e-7);
        near(sim.pipe_traction(), G * sin / 2.0, 1e-7);
        near(hoop.angle, -9.0 * sin.atan2(cos), 1e-9);
    }
    let (sin, cos) = 20_f64.to_radians().sin_cos();
    near(sim.tyre_speed(), 2.0 * 2.0 / 3.0 * G * sin, 1e-9);
    near(sim.tyre_traction(), -2.0 * G * sin / 3.0, 1e-9);
    near(sim.tyre_load(), 2.0 * G * cos, 1e-9);
}

/// A ball that is thrown without spin rolls at 2 v/(7 mu g) with 5/7 of its speed; 2/7 of its energy are lost.
#[test]
fn a_bowling_ball_begins_to_roll() {
    let mut sim = run(Circles::new());
    near(sim.bowling_drag(), -0.2 * 3.0 * G, 1e-12);
    near(sim.bowling_lost(), 0.2 * 3.0 * G * 5.0, 1e-9);
    let time = 2.0 * 5.0 / (7.0 * 0.2 * G);
    sim.step_to(time - 1e-9).unwrap();
    assert_eq!(sim.contact("bowling.rub"), Some(Mode::Forwards));
    sim.step_to(time + 1e-9).unwrap();
    assert_eq!(sim.contact("bowling.rub"), Some(Mode::Sticks));
    let ball = sim.ball();
    near(ball.vx, 5.0 * 5.0 / 7.0, 1e-8);
    let energy = 0.5 * 3.0 * ball.vx * ball.vx + 0.5 * 0.4 * 3.0 * 0.01 * ball.omega * ball.omega;
    near(energy / (0.5 * 3.0 * 25.0), 5.0 / 7.0, 1e-8);
    sim.step(1.0).unwrap();
    near(sim.ball().vx, 25.0 / 7.0, 1e-8);
    near(sim.bowling_slip(), 0.0, 1e-12);
    near(sim.bowling_push(), 3.0 * G, 1e-9);
}

/// Bounces end at t (1 + e)/(1 - e), and each takes mu (1 + e) v of the speed along the floor; then it slides to rest.
#[test]
fn a_block_bounces_and_slides() {
    let mut sim = run(Circles::new());
    let (first, e, mu) = ((2.0 / G).sqrt(), 0.5, 0.1);
    let end = first * (1.0 + e) / (1.0 - e);
    // All impulses together: mu (1 + e)/(1 - e) times the first speed.
    let left = 5.0 - mu * G * end;
    sim.step_to(end + 1e-6).unwrap();
    near(sim.block().vx, left, 1e-5);
    let rest = end + left / (mu * G);
    sim.step_to(rest - 1e-6).unwrap();
    assert_eq!(sim.contact("floor.rub"), Some(Mode::Forwards));
    sim.step_to(rest + 1e-6).unwrap();
    assert_eq!(sim.contact("floor.rub"), Some(Mode::Sticks));
    assert_eq!((sim.floor_gap().abs() < 1e-9, sim.floor_lost()), (true, 0.0));
}
