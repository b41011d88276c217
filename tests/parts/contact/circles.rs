//! Points and circles on circles and lines, and what rolls.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _, Moment as _, Sim};

use super::{G, near, opens};
use crate::scene::{Given as _, Named as _, Scene};

scene! {
    /// A ball that slides and one that rolls on a cylinder of 1 m.
    pub Leaving {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body slider { mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m; start y: 1.1 m; start vx: 0.1 m/s; }
        circle_on_circle smooth(ground.o, slider.c) { radius_a: 1 m; radius_b: 0.1 m; }
        body roller {
            mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m;
            start y: 1.1 m; start vx: 0.1 m/s; start omega: -1 rad/s;
        }
        circle_on_circle rough(ground.o, roller.c) { radius_a: 1 m; radius_b: 0.1 m; friction: 1e6; }
        output smooth.push, rough.push, rough.slip;
    }
}

scene! {
    /// A ball in a bowl, a bead in a ring, a ball and a block on a floor.
    pub Rubbing {
        param fall: m/s^2 = 9.81 m/s^2;
        gravity: fall;
        ground { port o: (0, 0) m; }
        body marble {
            mass: 1 kg; inertia: sphere(1 kg, 0.1 m); port c: (0, 0) m;
            start x: -0.9 m*sin(60 deg); start y: -0.9 m*cos(60 deg);
        }
        circle_on_circle bowl(ground.o, marble.c) { side: inside; radius_a: 1 m; radius_b: 0.1 m; friction: 10; }
        body bead { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start x: -1 m; start vy: -3 m/s; }
        point_on_circle ring(ground.o, bead.c) { side: inside; radius: 1 m; friction: 0.2; }
        body ball { mass: 3 kg; inertia: sphere(3 kg, 0.1 m); port c: (0, 0) m; start y: 0.1 m; start vx: 5 m/s; }
        circle_on_line bowling(ground.o, ball.c) { radius: 0.1 m; friction: 0.2; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: 1 m; start vx: 5 m/s; }
        point_on_line floor(ground.o, block.c) { restitution: 0.5; friction: 0.1; }
        output bowl.push, ring.push, ring.lost, bowling.push, bowling.slip, bowling.drag, bowling.lost, floor.gap, floor.lost;
    }
}

fn leaving() -> Sim<Scene> {
    Leaving::new().start_with(Dop853::new(1e-10)).unwrap()
}

fn rubbing(fall: f64) -> Sim<Scene> {
    Rubbing::new().with("fall", fall).start_with(Dop853::new(1e-10)).unwrap()
}

/// A ball that slides off leaves at cos = 2/3 + v^2/(3 g R), one that rolls at (10 + 7 v^2/(g R))/17, with R between the centres.
#[test]
fn balls_leave_a_cylinder() {
    let share = 0.01 / (G * 1.1);
    let mut sim = leaving();
    near(sim.value_of("smooth.push"), G - 0.01 / 1.1, 1e-12);
    opens(&mut sim, "smooth.contact");
    near(sim.state_of("slider").y / 1.1, 2.0 / 3.0 + share / 3.0, 1e-9);
    near(sim.value_of("smooth.push"), 0.0, 1e-7);
    assert_eq!((sim.state_of("slider").omega, sim.contact("smooth.rub")), (0.0, None));

    let mut sim = leaving();
    near(sim.value_of("rough.push"), G - 0.01 / 1.1, 1e-12);
    sim.step(0.5).unwrap();
    near(sim.value_of("rough.slip"), 0.0, 1e-9);
    opens(&mut sim, "rough.contact");
    // Just before, a friction of a million times the push is not enough.
    near(sim.state_of("roller").y / 1.1, (10.0 + 7.0 * share) / 17.0, 3e-8);
}

/// A ball that rolls in a bowl keeps its energy and turns back at its height; it passes the bottom with N = m g (17 - 10 cos)/7.
#[test]
fn a_ball_rolls_in_a_bowl() {
    let mut sim = rubbing(G);
    let lowest = |sim: &Sim<Scene>| {
        let marble = sim.state_of("marble");
        0.5 * (marble.vx * marble.vx + marble.vy * marble.vy)
            + 0.5 * 0.004 * marble.omega * marble.omega
            + G * marble.y
    };
    let energy = lowest(&sim);
    let mut saved = sim.save();
    while sim.state_of("marble").x < 0.0 {
        saved = sim.save();
        sim.step(0.05).unwrap();
    }
    let (mut low, mut high) = (sim.time() - 0.05, sim.time());
    for _ in 0..35 {
        let half = 0.5 * (low + high);
        sim.resume(&saved);
        sim.step_to(half).unwrap();
        *(if sim.state_of("marble").x < 0.0 { &mut low } else { &mut high }) = half;
    }
    near(sim.value_of("bowl.push"), G * (17.0 - 10.0 * 0.5) / 7.0, 1e-7);
    near(lowest(&sim), energy, 1e-9);
    // Equal arcs: 0.9 m of the centre's circle are 9 of its own angles.
    near(sim.state_of("marble").angle, -9.0 * 60_f64.to_radians(), 1e-8);
    sim.step_to(2.0 * low).unwrap();
    near(sim.state_of("marble").y, -0.45, 1e-8);
    assert_eq!(sim.contact("bowl.rub"), Some(Mode::Sticks));
}

/// Without gravity the speed of a bead in a ring falls by exp(-mu angle).
#[test]
fn a_bead_rubs_on_a_ring() {
    let mut sim = rubbing(0.0);
    near(sim.value_of("ring.push"), 9.0, 1e-12);
    near(sim.value_of("ring.lost"), 0.2 * 9.0 * 3.0, 1e-12);
    let (mu, speed, way) = (0.2, 3.0, std::f64::consts::FRAC_PI_2);
    // theta = ln(1 + mu v t)/mu
    sim.step_to(((mu * way).exp() - 1.0) / (mu * speed)).unwrap();
    near(sim.state_of("bead").x, 0.0, 1e-9);
    near(sim.state_of("bead").vx, 3.0 * (-mu * way).exp(), 1e-9);
}

/// A ball that is thrown without spin rolls at 2 v/(7 mu g) with 5/7 of its speed; 2/7 of its energy are lost.
#[test]
fn a_bowling_ball_begins_to_roll() {
    let mut sim = rubbing(G);
    near(sim.value_of("bowling.drag"), -0.2 * 3.0 * G, 1e-12);
    near(sim.value_of("bowling.lost"), 0.2 * 3.0 * G * 5.0, 1e-9);
    let time = 2.0 * 5.0 / (7.0 * 0.2 * G);
    sim.step_to(time - 1e-9).unwrap();
    assert_eq!(sim.contact("bowling.rub"), Some(Mode::Forwards));
    sim.step_to(time + 1e-9).unwrap();
    assert_eq!(sim.contact("bowling.rub"), Some(Mode::Sticks));
    let ball = sim.state_of("ball");
    near(ball.vx, 5.0 * 5.0 / 7.0, 1e-8);
    let energy = 0.5 * 3.0 * ball.vx * ball.vx + 0.5 * 0.4 * 3.0 * 0.01 * ball.omega * ball.omega;
    near(energy / (0.5 * 3.0 * 25.0), 5.0 / 7.0, 1e-8);
    sim.step(1.0).unwrap();
    near(sim.state_of("ball").vx, 25.0 / 7.0, 1e-8);
    near(sim.value_of("bowling.slip"), 0.0, 1e-12);
    near(sim.value_of("bowling.push"), 3.0 * G, 1e-9);
}

/// Bounces end at t (1 + e)/(1 - e), and each takes mu (1 + e) v of the speed along the floor; then it slides to rest.
#[test]
fn a_block_bounces_and_slides() {
    let mut sim = rubbing(G);
    let (first, e, mu) = ((2.0 / G).sqrt(), 0.5, 0.1);
    let end = first * (1.0 + e) / (1.0 - e);
    // All impulses together: mu (1 + e)/(1 - e) times the first speed.
    let left = 5.0 - mu * G * end;
    sim.step_to(end + 1e-6).unwrap();
    near(sim.state_of("block").vx, left, 1e-5);
    let rest = end + left / (mu * G);
    sim.step_to(rest - 1e-6).unwrap();
    assert_eq!(sim.contact("floor.rub"), Some(Mode::Forwards));
    sim.step_to(rest + 1e-6).unwrap();
    assert_eq!(sim.contact("floor.rub"), Some(Mode::Sticks));
    assert_eq!((sim.value_of("floor.gap").abs() < 1e-9, sim.value_of("floor.lost")), (true, 0.0));
}

/// A ball that loops in the ring rolls on over every cut of an angle: its energy stays, and its angle is -9 times that of its way.
#[test]
fn a_ball_loops_in_a_ring() {
    let thrown = [("marble.x", 0.0), ("marble.y", -0.9), ("marble.vx", 10.0), ("marble.omega", -100.0)];
    let mechanism = thrown.into_iter().fold(Rubbing::new(), |own, (name, value)| own.with_start(name, value));
    let mut sim = mechanism.start_with(Dop853::new(1e-10)).unwrap();
    let energy = |sim: &Sim<Scene>| {
        let marble = sim.state_of("marble");
        0.5 * (marble.vx * marble.vx + marble.vy * marble.vy)
            + 0.002 * marble.omega * marble.omega
            + G * marble.y
    };
    let before = energy(&sim);
    let mut way = 0.0;
    let mut last = -std::f64::consts::FRAC_PI_2;
    for _ in 0..100 {
        sim.step(0.01).unwrap();
        let angle = sim.state_of("marble").y.atan2(sim.state_of("marble").x);
        way += (angle - last).rem_euclid(std::f64::consts::TAU);
        last = angle;
        assert_eq!(sim.contact("bowl.rub"), Some(Mode::Sticks));
        near(sim.state_of("marble").angle, -9.0 * way, 1e-7);
    }
    assert!(way > 1.5 * std::f64::consts::TAU, "{way} rad");
    near(energy(&sim), before, 1e-7);
}
