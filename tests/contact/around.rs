//! What is around a run: methods, paces, samples, states at other times, saved runs, whole turns, many runs.

use core::f64::consts::PI;
use std::thread;

use plm::{Adams, Dop853, Dopri5, Mechanism as _, Method, Moment as _, RadauIia5, Vern9, batch};

use crate::declared::{Ball, Oscillator};
use crate::friction::Clutch;
use crate::near;
use crate::scene::{Given as _, Named as _, Scene, State};

/// Height and velocity of a ball that was let go at 1 m, with e = 0.5.
fn ball(t: f64) -> [f64; 2] {
    let first = f64::sqrt(2.0 / 9.81);
    if t < first {
        return [1.0 - 0.5 * 9.81 * t * t, -9.81 * t];
    }
    let (mut since, mut speed) = (t - first, 0.5 * 9.81 * first);
    // Two thousandths of a microsecond before bouncing ends nothing is told apart.
    while speed > 1e-7 {
        let flight = 2.0 * speed / 9.81;
        if since < flight {
            return [speed * since - 0.5 * 9.81 * since * since, speed - 9.81 * since];
        }
        (since, speed) = (since - flight, 0.5 * speed);
    }
    [0.0, 0.0]
}

/// Displacement and velocity of 1 kg on 100 N/m from 0.1 m, with a friction of 0.981 N (J. P. Den Hartog).
fn oscillator(t: f64) -> [f64; 2] {
    let half = (t * 10.0 / PI).floor();
    if half >= 5.0 {
        return [-0.0019, 0.0];
    }
    let side = if half % 2.0 == 0.0 { 1.0 } else { -1.0 };
    let reach = 0.1 - 0.00981 * (2.0 * half + 1.0);
    let angle = 10.0 * t - PI * half;
    [side * (0.00981 + reach * angle.cos()), -side * reach * 10.0 * angle.sin()]
}

/// A mechanism with its state in closed form.
#[derive(Clone, Copy)]
struct Known {
    scene: Scene,
    state: fn(&State) -> [f64; 2],
    at: fn(f64) -> [f64; 2],
}

impl Known {
    fn check(self, state: &State, within: f64) {
        let t = state.time();
        for (found, known) in (self.state)(state).into_iter().zip((self.at)(t)) {
            assert!((found - known).abs() <= within, "t = {t}: {found} is not {known}: {:e}", found - known);
        }
    }

    /// The state as bits.
    fn bits(self, state: &State) -> [u64; 2] {
        (self.state)(state).map(f64::to_bits)
    }
}

const UNTIL: f64 = 1.9;

/// By one method: with samples, in one go, by steps of three lengths, from saved moments, and at times ahead and behind.
fn at_every_pace(known: Known, method: &impl Method<Scene>, within: f64) {
    let start = || known.scene.start_with(method.clone()).unwrap();
    let (mut sampled, mut whole) = (start(), start());
    let mut samples = 0;
    sampled
        .run(UNTIL, 0.0037, |state| {
            known.check(state, within);
            samples += 1;
        })
        .unwrap();
    assert_eq!(samples, 514);
    whole.step_to(UNTIL).unwrap();
    assert_eq!(known.bits(sampled.state()), known.bits(whole.state()), "samples change no bit");
    for pace in [0.019, 0.19, 0.95] {
        let (mut sim, mut resumed) = (start(), start());
        while sim.state().time() < UNTIL - 1e-9 {
            let saved = sim.save();
            // What is asked of another time moves nothing.
            known.check(&sim.at(sim.state().time() + 0.3 * pace).unwrap(), within);
            sim.step(pace).unwrap();
            known.check(sim.state(), within);
            if let Ok(before) = sim.at(sim.state().time() - 1e-3) {
                known.check(&before, within);
            }
            resumed.resume(&saved);
            resumed.step(pace).unwrap();
            assert_eq!(
                known.bits(sim.state()),
                known.bits(resumed.state()),
                "a saved run goes on to the bit"
            );
        }
    }
}

#[test]
fn methods_with_error_control_agree_at_every_pace() {
    fn scene(known: Known) {
        at_every_pace(known, &Dop853::new(1e-11), 1e-9);
        at_every_pace(known, &Vern9::new(1e-11), 1e-9);
        at_every_pace(known, &Adams::new(1e-11), 1e-9);
        at_every_pace(known, &Dopri5::new(1e-11), 1e-9);
        // Between its ends a step is known to a lower order.
        at_every_pace(known, &RadauIia5::new(1e-11), 1e-8);
    }
    let ball = Known {
        scene: Ball::new(),
        state: |state| [state.state_of("ball").y, state.state_of("ball").vy],
        at: ball,
    };
    let oscillator = Known {
        scene: Oscillator::new(),
        state: |state| [state.state_of("mass").x, state.state_of("mass").vx],
        at: oscillator,
    };
    // The runs of all methods beside each other take more of the stack than threads of tests have, without optimisation.
    for known in [ball, oscillator] {
        thread::Builder::new().stack_size(8 << 20).spawn(move || scene(known)).unwrap().join().unwrap();
    }
}

scene! {
    /// A shaft that turns by a torque up to a stop after many turns, and is held by a brake as it rebounds.
    pub Winch {
        input torque: N*m = 2 N*m;
        input brake: N*m = 0 N*m;
        ground { port o: (0, 0) m; }
        body drum { mass: 1 kg; inertia: 0.5 kg*m^2; port o: (0, 0) m; start angle: 0 rad, locked; }
        revolute bearing(ground.o, drum.o) { drive: torque; }
        unilateral stop: drum.angle <= 100 rad { restitution: 0.5; }
        friction shoe: rate(drum.angle) within brake;
    }
}

/// Angles are brought back by whole turns; gaps and places count them.
#[test]
fn rows_count_whole_turns() {
    // 4 rad/s^2 from rest, 100 rad: sqrt(50) s, and then back at half the speed for half of that time.
    let mut sim = Winch::new().start_with(Dop853::new(1e-12)).unwrap();
    let (strikes, speed) = (50.0_f64.sqrt(), 800.0_f64.sqrt());
    sim.step_to(strikes - 1e-6).unwrap();
    near(sim.state_of("drum").angle, 100.0 - 1e-6 * speed, 1e-9);
    sim.step_to(1.5 * strikes).unwrap();
    near(sim.state_of("drum").angle, 75.0, 1e-8);
    assert_eq!(sim.contact_stats().impacts, 1);
    // It is caught where it is, and stays there.
    sim.set_input("brake", 100.0);
    sim.step(1.0).unwrap();
    let held = sim.state_of("drum").angle;
    sim.step(3600.0).unwrap();
    assert_eq!((sim.state_of("drum").angle.to_bits(), sim.state_of("drum").omega), (held.to_bits(), 0.0));

    // A clutch that locks after 81 rad of slip: both shafts turn on by some 2400 turns, beside each other.
    let mut sim = Clutch::new().with("engine", 0.0).start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(2.0).unwrap();
    let apart = sim.state_of("first").angle - sim.state_of("second").angle;
    sim.step_to(200.0).unwrap();
    assert!(sim.state_of("first").angle > 10_000.0, "{:?}", sim.state_of("first"));
    near(sim.state_of("first").angle - sim.state_of("second").angle, apart, 1e-10);
    near(sim.state_of("first").omega, (0.2 * 200.0 + 0.5 * 20.0) / 0.7, 1e-10);
}

scene! {
    /// A sledge that is braked by a force which grows from nothing, of the time or of a state.
    pub Sledge {
        param growth: N/s = 0 N/s;
        body sledge { mass: 2 kg; inertia: 1 kg*m^2; start vx: 3 m/s; }
        constraint level: sledge.angle = 0;
        constraint height: sledge.y = 0;
        state pressed: N = 0 N;
        rate pressed = growth;
        friction early: rate(sledge.x) within (2 N/s)*max(t - 1 s, 0 s);
        friction late: rate(sledge.x) within pressed;
    }
}

/// A bound that is zero at first: v = 3 - (t - 1)^2/2 to the stop at 1 + sqrt(6), with a state 3 - t^2/2 to sqrt(6).
#[test]
fn a_bound_grows_from_nothing() {
    let mut sim = Sledge::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(2.0).unwrap();
    near(sim.state_of("sledge").vx, 2.5, 1e-9);
    sim.step_to(4.0).unwrap();
    let way = 3.0 + 2.0 * 6.0_f64.sqrt();
    assert_eq!(sim.state_of("sledge").vx, 0.0);
    near(sim.state_of("sledge").x, way, 1e-9);

    let mut sim = Sledge::new().with("growth", 2.0).start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(1.0).unwrap();
    near(sim.state_of("sledge").vx, 2.5, 1e-9);
}

/// Each with the bits that it has alone.
#[test]
fn many_runs_are_as_one() {
    let place = |height: f64| {
        let ball = Ball::new().with_start("ball.y", height);
        let mut sim = ball.start()?;
        sim.step_to(1.1)?;
        Ok(sim.state_of("ball").y)
    };
    let heights: Vec<f64> = (1..9).map(|k| 0.2 * f64::from(k)).collect();
    let runs = batch::points(heights).quiet().threads(2).run(place);
    for run in runs.iter() {
        assert_eq!(run.result.clone().unwrap().to_bits(), place(run.parameters).unwrap().to_bits());
    }
}
