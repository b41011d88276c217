//! Grounds and bodies that move beneath others, and let them go.

use plm::runtime::contact::Mode;
use plm::{Dop853, Mechanism as _};

use super::points::Stack;
use crate::near;
use crate::scene::{Given as _, Named as _};

const G: f64 = 9.81;

scene! {
    /// A ball on a table that shakes, and a block on a wedge that is pulled away from under it.
    pub Shaken {
        part pull(on: body) {
            param rise: N/s;
            force on on: (rise*t, 0 N);
        }
        gravity: 9.81 m/s^2;
        param e = 0.5;
        body ball { mass: 0.1 kg; inertia: 1 kg*m^2; start y: 0.3 m; }
        unilateral table: ball.y - (20 mm)*sin(30 rad/s*t) >= 0 m { restitution: e; }
        body wedge { mass: 3 kg; inertia: 1 kg*m^2; }
        body block { mass: 2 kg; inertia: 1 kg*m^2; }
        constraint wedge_y: wedge.y = 0;
        constraint wedge_level: wedge.angle = 0;
        constraint block_level: block.angle = 0;
        pull hand(wedge) { rise: 100 N/s; }
        // Its face falls to the left, by 30 deg; the wedge goes to the right.
        unilateral face: (block.y - wedge.y)*cos(30 deg) - (block.x - wedge.x)*sin(30 deg) >= 0 m;
        output push = reaction(face);
    }
}

/// The next time, after `after`, at which a ball is on the table that flies from `y` with the velocity `v` at the time `t`.
fn lands(t: f64, [y, v]: [f64; 2], after: f64) -> f64 {
    let gap = |at: f64| {
        let s = at - t;
        y + v * s - 0.5 * G * s * s - 0.02 * (30.0 * at).sin()
    };
    let mut low = after;
    while gap(low + 1e-4) > 0.0 {
        low += 1e-4;
    }
    let mut high = low + 1e-4;
    for _ in 0..60 {
        let half = 0.5 * (low + high);
        *(if gap(half) > 0.0 { &mut low } else { &mut high }) = half;
    }
    high
}

/// Flights are parabolas; the table gives back e times the speed of approach, and goes on itself.
#[test]
fn a_ball_bounces_on_a_table_that_shakes() {
    let mut sim = Shaken::new().start_with(Dop853::new(1e-11)).unwrap();
    let (mut t, mut state) = (0.0, [0.3, 0.0]);
    for _ in 0..12 {
        let at = lands(t, state, t + 1e-3);
        let s = at - t;
        let speed = 0.6 * (30.0 * at).cos();
        let strikes = state[1] - G * s;
        state = [0.02 * (30.0 * at).sin(), speed - 0.5 * (strikes - speed)];
        t = at;
        sim.step_to(t - 1e-10).unwrap();
        near(sim.state_of("ball").vy, strikes, 1e-8);
        sim.step_to(t + 1e-10).unwrap();
        near(sim.state_of("ball").vy, state[1], 1e-8);
        near(sim.state_of("ball").y, state[0], 1e-9);
    }
    assert_eq!(sim.contact_stats().impacts, 12);
}

/// Without a bounce it rests from its first touch on until the table falls faster than it would: sin(w t) = g/(a w^2).
#[test]
fn a_ball_is_thrown_by_a_table() {
    let mut sim = Shaken::new().with("e", 0.0).start_with(Dop853::new(1e-11)).unwrap();
    let leaves = (G / (0.02 * 900.0)).asin() / 30.0;
    let period = core::f64::consts::TAU / 30.0;
    let first = lands(0.0, [0.3, 0.0], 0.01);
    for k in (0..20).map(|k| leaves + f64::from(k) * period).filter(|k| *k > first) {
        sim.step_to(k - 1e-10).unwrap();
        assert_eq!(sim.contact("table"), Some(Mode::Closed), "before {k} s");
        sim.step_to(k + 1e-10).unwrap();
        assert_eq!(sim.contact("table"), Some(Mode::Open), "after {k} s");
    }
}

/// The block stays on the face until the wedge is as fast as it needs to fall beside it: A = g cot a with the pull M A. Frictionless,
/// accelerations are linear in time.
#[test]
fn a_wedge_is_pulled_from_under_a_block() {
    let mut sim = Shaken::new().start_with(Dop853::new(1e-11)).unwrap();
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let (wedge, block) = (3.0, 2.0);
    let leaves = wedge * G * cos / sin / 100.0;
    // M A = F + N sin a, m x'' = -N sin a, m y'' = N cos a - m g, y'' cos a = (x'' - A) sin a.
    // N (cos^2 a/m + sin^2 a/m + sin^2 a/M) = g cos a - F sin a/M
    let push = |t: f64| (G * cos - 100.0 * t * sin / wedge) / (1.0 / block + sin * sin / wedge);
    for t in [0.1, 0.3, 0.5] {
        sim.step_to(t).unwrap();
        near(sim.value_of("push"), push(t), 1e-9);
        // The mean push over the time is that in the middle.
        near(sim.state_of("block").vx, -push(0.5 * t) * sin / block * t, 1e-10);
        near(sim.state_of("wedge").vx, (50.0 * t * t + push(0.5 * t) * sin * t) / wedge, 1e-10);
    }
    sim.step_to(leaves - 1e-10).unwrap();
    assert_eq!(sim.contact("face"), Some(Mode::Closed));
    let begun = sim.state_of("block");
    sim.step_to(leaves + 1e-10).unwrap();
    assert_eq!(sim.contact("face"), Some(Mode::Open));
    sim.step_to(leaves + 0.2).unwrap();
    near(sim.state_of("block").vx, begun.vx, 1e-8);
    near(sim.state_of("block").vy, begun.vy - G * 0.2, 1e-8);
}

/// The table takes the lower block along, which takes the upper one along; both stick and slip in turn.
#[test]
fn two_blocks_ride_on_a_table_that_shakes() {
    for (amplitude, rough_table, rough_block) in [(0.05, 0.3, 0.15), (0.03, 0.25, 0.4), (0.08, 0.5, 0.2)] {
        let known = super::reference::Shaken { amplitude, rough_table, rough_block };
        let mut sim = Stack::new()
            .with("amplitude", amplitude)
            .with("rough_table", rough_table)
            .with("rough_block", rough_block)
            .start_with(Dop853::new(1e-11))
            .unwrap();
        for t in [0.2, 0.7, 1.3, 2.0] {
            let state = known.run(t);
            sim.step_to(t).unwrap();
            let found = [
                sim.state_of("lower").x,
                sim.state_of("upper").x,
                sim.state_of("lower").vx,
                sim.state_of("upper").vx,
            ];
            found.iter().zip(state).for_each(|(found, known)| near(*found, known, 1e-11));
        }
        assert!(sim.stats().switches > 12, "{:?}", sim.stats());
    }
}
