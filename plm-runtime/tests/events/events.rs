//! Switching, against solutions that can be written down.

use core::f64::consts::{LN_2, PI, SQRT_2};

use plm_runtime::method::Method;
use plm_runtime::{
    Adams, Cause, Constraints, Dop853, Dopri5, Events, Fault, Health, Labels, Mechanism, Rate, Rk4, Sim,
    Vern9,
};

use crate::linkage::At;

/// Equations that switch.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    pub(crate) rate: fn(f64, &Held, &[f64; 3]) -> [f64; 3],
    pub(crate) guards: fn(&Held, &[f64; 3]) -> [f64; 2],
    pub(crate) switch: fn(&mut Held, &[f64; 3], usize),
    pub(crate) start: [f64; 3],
    pub(crate) band: f64,
    pub(crate) instants: &'static [f64],
}

/// A side of each condition, and how many of the known times have passed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Held {
    pub(crate) side: [f64; 2],
    pub(crate) passed: usize,
}

impl Rate for Scene {
    type S = f64;
    type X = [f64; 3];
    type U = Held;
    const NQ: usize = 1;

    fn rate(&self, t: f64, u: &Held, x: &[f64; 3], dx: &mut [f64; 3]) -> Health<f64> {
        *dx = (self.rate)(t, u, x);
        Health::perfect()
    }
}

impl Constraints for Scene {}

impl Events for Scene {
    type G = [f64; 2];
    fn guards(&self, _t: f64, u: &Held, x: &[f64; 3], g: &mut [f64; 2]) {
        *g = (self.guards)(u, x);
    }
    fn band(&self, _index: usize) -> f64 {
        self.band
    }
    fn switch(&self, _t: f64, u: &mut Held, x: &mut [f64; 3], index: usize) -> Result<(), Fault> {
        (self.switch)(u, x, index);
        Ok(())
    }
    fn next_time_event(&self, t: f64, _u: &Held) -> Option<f64> {
        self.instants.iter().copied().find(|instant| *instant > t)
    }
    fn switch_at_time(&self, t: f64, u: &mut Held, _x: &mut [f64; 3]) -> Result<(), Fault> {
        u.passed += 1;
        assert_eq!(t, self.instants[u.passed - 1]);
        Ok(())
    }
}

impl Labels for Scene {
    fn guard_name(&self, index: usize) -> &'static str {
        ["first", "second"][index]
    }
}

impl Mechanism for Scene {
    type State = At<Self>;
    type Rescue = plm_runtime::singular::Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Held, [f64; 3]), Fault> {
        Ok((Held { side: [1.0; 2], passed: 0 }, self.start))
    }
}

/// Nothing switches.
pub(crate) const SMOOTH: Scene = Scene {
    rate: |_, _, x| [x[1], -x[0], 0.0],
    guards: |_, _| [1.0; 2],
    switch: |held, _, index| held.side[index] = -held.side[index],
    start: [1.0, 0.0, 0.0],
    band: 0.0,
    instants: &[],
};

/// x'' = -1 where x > 0 and 2 elsewhere: parabolas; from 1 at rest the period is 3 sqrt(2).
const FORCE: Scene = Scene {
    rate: |_, held, x| [x[1], if held.side[0] > 0.0 { -1.0 } else { 2.0 }, 0.0],
    guards: |held, x| [held.side[0] * x[0], 1.0],
    ..SMOOTH
};

/// FORCE at any time.
fn force(t: f64) -> [f64; 2] {
    let t = t.rem_euclid(3.0 * SQRT_2);
    let (down, up) = (SQRT_2, 2.0 * SQRT_2);
    if t < down {
        [1.0 - t * t / 2.0, -t]
    } else if t < up {
        let s = t - down;
        [-SQRT_2 * s + s * s, -SQRT_2 + 2.0 * s]
    } else {
        let s = t - up;
        [SQRT_2 * s - s * s / 2.0, SQRT_2 - s]
    }
}

pub(crate) fn run<I: Method<Scene>>(scene: Scene, method: I, t: f64) -> Sim<Scene, I> {
    let mut sim = scene.start_with(method).unwrap();
    sim.step(t).unwrap();
    sim
}

fn a_switched_force_keeps_its_period(method: impl Method<Scene>) {
    let mut sim = FORCE.start_with(method).unwrap();
    let mut worst: f64 = 0.0;
    sim.run(44.0, 0.1, |moment| {
        let exact = force(moment.time);
        worst = worst.max((moment.x[0] - exact[0]).abs()).max((moment.x[1] - exact[1]).abs());
    })
    .unwrap();
    // Parabolas are integrated to rounding, so that what remains is how well the crossings were found, on dense output
    // with coefficients up to 500: 1e-13 s each, which adds up over 10 periods.
    assert!(worst < 1e-11, "{worst:e}");
    assert_eq!(sim.stats().switches, 21);
}

#[test]
fn switched_forces_are_located_to_rounding() {
    a_switched_force_keeps_its_period(Dop853::new(1e-6));
    a_switched_force_keeps_its_period(Vern9::new(1e-6));
    a_switched_force_keeps_its_period(Adams::new(1e-6));
    a_switched_force_keeps_its_period(Dopri5::new(1e-6));
}

/// A relay that heats up to 1.5 and then rests down to 0.5: x' = 2 - x or -x; each way takes ln 3.
const RELAY: Scene = Scene {
    rate: |_, held, x| [0.0, 0.0, if held.side[0] > 0.0 { 2.0 - x[2] } else { -x[2] }],
    guards: |held, x| [if held.side[0] > 0.0 { 1.5 - x[2] } else { x[2] - 0.5 }, 1.0],
    start: [0.0, 0.0, 0.5],
    ..SMOOTH
};

#[test]
fn a_relay_switches_at_both_ends_of_its_band() {
    let ln3 = 3.0_f64.ln();
    let sim = run(RELAY, Dop853::new(1e-11), 40.0 * ln3 + LN_2);
    assert!((sim.x[2] - (2.0 - 1.5 / 2.0)).abs() < 1e-9, "{}", sim.x[2] - 1.25);
    assert_eq!(sim.stats().switches, 40);
    let sim = run(RELAY, Dop853::new(1e-11), 41.0 * ln3 + LN_2);
    assert!((sim.x[2] - 1.5 / 2.0).abs() < 1e-9, "{}", sim.x[2] - 0.75);
}

/// x'' = -x - 0.3 sign(v), as a sign alone.
const RUBBING: Scene = Scene {
    rate: |_, held, x| [x[1], -x[0] + 0.3 * held.side[0], 0.0],
    guards: |held, x| [-held.side[0] * x[1], 1.0],
    ..SMOOTH
};

/// The same with sticking (side 0) as a third case: it lasts while the spring is weaker than the friction.
const STICKING: Scene = Scene {
    rate: |_, held, x| if held.side[0] == 0.0 { [0.0; 3] } else { [x[1], -x[0] + 0.3 * held.side[0], 0.0] },
    guards: |held, x| [if held.side[0] == 0.0 { 0.3 - x[0].abs() } else { -held.side[0] * x[1] }, 1.0],
    switch: |held, x, _| {
        let slides = x[0].abs() > 0.3;
        held.side[0] = if slides { x[0].signum() } else { 0.0 };
    },
    ..SMOOTH
};

#[test]
fn dry_friction_takes_the_same_from_every_swing() {
    // Half swings of pi about 0.3 and -0.3: 1, -0.4, -0.2, where the spring is too weak.
    for scene in [RUBBING, STICKING] {
        let sim = run(scene, Dop853::new(1e-11), 1.5 * PI);
        assert!((sim.x[0] + 0.3).abs() < 1e-10 && (sim.x[1] - 0.1).abs() < 1e-10, "{:?}", sim.x);
        assert_eq!(sim.stats().switches, 1);
    }
    let sim = run(STICKING, Dop853::new(1e-11), 50.0);
    assert!((sim.x[0] + 0.2).abs() < 1e-10 && sim.x[1].abs() < 1e-10, "{:?}", sim.x);
    assert_eq!(sim.stats().switches, 2);
}

#[test]
fn a_sign_that_must_stick_is_zeno() {
    let mut sim = RUBBING.start_with(Dop853::new(1e-11)).unwrap();
    let fault = sim.step(50.0).unwrap_err();
    assert!((fault.time - 2.0 * PI).abs() < 1e-6, "{fault}");
    assert!(
        matches!(fault.cause, Cause::Zeno { events, within, .. } if events > 100 && within < 1e-6),
        "{fault}"
    );
    assert_eq!(fault.part, "first");
    assert!(fault.to_string().contains("first: switches without end: 101 times within "), "{fault}");
    assert!((sim.x[0] + 0.2).abs() < 1e-9, "the state is that of the last step: {:?}", sim.x);
}

/// x'' = -sign(x) - sign(v) / 2: every arc returns with 1 / sqrt(3) of its speed, and takes as much less time.
const ZENO: Scene = Scene {
    rate: |_, held, x| [x[1], -held.side[0] - 0.5 * held.side[1], 0.0],
    guards: |held, x| [held.side[0] * x[0], held.side[1] * x[1]],
    start: [0.0, 1.0, 0.0],
    ..SMOOTH
};

#[test]
fn times_with_a_limit_are_zeno() {
    let limit = (1.0 / 1.5 + (4.0_f64 / 3.0).sqrt()) / (1.0 - (1.0_f64 / 3.0).sqrt());
    // Arcs that begin exactly on the boundary are among these.
    for k in 0..100 {
        let rtol = 10.0_f64.powf(-3.0 - 0.09 * f64::from(k));
        let mut sim = ZENO.start_with(Dop853::new(rtol)).unwrap();
        let fault = sim.step(10.0).unwrap_err();
        assert!(matches!(fault.cause, Cause::Zeno { .. }), "{fault}");
        assert!((fault.time - limit).abs() < 1e-5, "{fault}, {limit}");
    }
    // Half an arc before, all is well: 0.57735^4 of the whole time is left after four arcs.
    let sim = run(ZENO, Dop853::new(1e-10), limit * (1.0 - 1.0 / 9.0));
    assert!(sim.x[0].abs() < 1e-9 && (sim.x[1].abs() - 1.0 / 9.0).abs() < 1e-9, "{:?}", sim.x);
}

/// The spool of the manual's valve: every 41.7 ms it crosses its middle with 0.0152 of the amplitude before; z counts
/// the time on one side less that on the other.
const SPOOL: Scene = Scene {
    rate: |_, held, x| {
        let (decay, frequency) = (0.0152_f64.ln() / 0.0417, PI / 0.0417);
        [x[1], 2.0 * decay * x[1] - (decay * decay + frequency * frequency) * x[0], held.side[0]]
    },
    guards: |held, x| [held.side[0] * x[0], 1.0],
    ..SMOOTH
};

#[test]
fn what_stays_in_its_band_does_not_switch() {
    // Amplitudes 0.0152^k: the fourth is the last above the band, and the fifth crossing switches nothing.
    let sim = run(Scene { band: 1e-9, ..SPOOL }, Dop853::new(1e-10), 10.0);
    assert_eq!(sim.stats().switches, 4);
    assert!(sim.x[0].abs() < 1e-9);
    // z: up to the first crossing, then 41.7 ms each way, and from the fourth on as it is.
    let (decay, frequency) = (-(0.0152_f64.ln()) / 0.0417, PI / 0.0417);
    let first = (PI - (frequency / decay).atan()) / frequency;
    let z = first + (10.0 - first - 3.0 * 0.0417) - 0.0417;
    assert!((sim.x[2] - z).abs() < 1e-7, "{} {z}", sim.x[2]);
}

/// Steps of equal length look at where they end: within the band they leave every condition as it is.
#[test]
fn fixed_steps_switch_nothing_within_the_band() {
    let switches = |band: f64| run(Scene { band, ..SPOOL }, Rk4::new(1e-3), 0.4).stats().switches;
    assert_eq!(switches(1e-9), 4);
    // Amplitudes 0.0152^k: the second crossing is the last that leads beyond 1e-5.
    assert_eq!(switches(1e-5), 2);
    assert_eq!(switches(0.1), 0);
}

/// A state that is set within the band stays on its side, and switches where it leaves it.
#[test]
fn a_state_that_is_set_within_the_band_holds_its_side() {
    for (x, switches) in [(-0.009, 0), (-0.011, 1)] {
        let mut sim =
            Scene { band: 0.01, rate: |_, _, _| [0.0; 3], ..FORCE }.start_with(Rk4::new(0.1)).unwrap();
        sim.x[0] = x;
        sim.step(0.1).unwrap();
        assert_eq!(sim.stats().switches, switches, "{x}");
    }
}

#[test]
fn fixed_steps_keep_their_grid() {
    let error = |steps: u32| {
        let sim = run(FORCE, Rk4::new(2.0 / f64::from(steps)), 2.0);
        assert_eq!((sim.stats().steps, sim.stats().switches), (u64::from(steps), 1));
        (sim.x[1] - force(2.0)[1]).abs()
    };
    // It switches at the end of the step: late by less than a step, with a jump of the force of 3.
    for steps in [100, 200, 400] {
        let (error, h) = (error(steps), 2.0 / f64::from(steps));
        assert!(error < 3.0 * h && error > 1e-4 * h, "{steps}: {error}");
    }
}

/// z' = 1 while x = t - t^2 / 2 is above 0.49: from 1 - sqrt(0.02) to 1 + sqrt(0.02).
const BRIEF: Scene = Scene {
    rate: |_, held, x| [x[1], -1.0, if held.side[0] > 0.0 { 0.0 } else { 1.0 }],
    guards: |held, x| [held.side[0] * (0.49 - x[0]), 1.0],
    start: [0.0, 1.0, 0.0],
    ..SMOOTH
};

#[test]
fn what_is_crossed_and_crossed_back_in_one_step_is_seen() {
    for end in [1.7, 2.0, 2.3, 3.0, 5.0, 10.0] {
        let sim = run(BRIEF, Dop853::new(1e-6), end);
        assert!((sim.x[2] - 2.0 * 0.02_f64.sqrt()).abs() < 1e-12, "{end}: {}", sim.x[2]);
        assert_eq!(sim.stats().switches, 2);
    }
}

#[test]
fn a_state_that_is_set_holds_its_side_at_once() {
    let mut sim = FORCE.start_with(Dop853::new(1e-9)).unwrap();
    sim.x[0] = -1.0;
    sim.step(0.5).unwrap();
    assert!((sim.x[0] - (-1.0 + 0.25)).abs() < 1e-13 && (sim.x[1] - 1.0).abs() < 1e-13, "{:?}", sim.x);
    assert_eq!(sim.stats().switches, 1);
}

#[test]
fn a_guard_that_is_not_a_number_is_named() {
    let scene = Scene { guards: |_, x| [1.0, (x[0] - 0.5).sqrt()], ..SMOOTH };
    let fault = scene.start_with(Dop853::new(1e-9)).unwrap().step(3.0).unwrap_err();
    assert_eq!((fault.part, fault.cause), ("second", Cause::NotFinite));
}

#[test]
fn runs_that_switch_resume_to_the_bit() {
    for scene in [FORCE, RELAY, STICKING] {
        let mut sim = scene.start_with(Dop853::new(1e-9)).unwrap();
        sim.step(1.3).unwrap();
        let saved = sim.save();
        sim.step(2.7).unwrap();
        let (x, stats) = (sim.x.map(f64::to_bits), sim.stats());
        sim.resume(&saved);
        sim.step(2.7).unwrap();
        assert_eq!((sim.x.map(f64::to_bits), sim.stats()), (x, stats));
    }
}

/// x'' = -|x| - x / 2: two half waves, of the frequencies sqrt(1.5) and (growing) sqrt(0.5).
const KINK: Scene = Scene { rate: |_, _, x| [x[1], -x[0].abs() - 0.5 * x[0], 0.0], ..SMOOTH };

#[test]
fn kinks_are_left_to_error_control() {
    let (fast, slow) = (1.5_f64.sqrt(), 0.5_f64.sqrt());
    let t = PI / (2.0 * fast) + 1.0;
    // Down from 1 with a quarter of a wave, then away from zero.
    let exact = -fast / slow * slow.sinh();
    let run = |rtol: f64| run(KINK, Dop853::new(rtol), t);
    let errors = [1e-6, 1e-9, 1e-12].map(|rtol| {
        let sim = run(rtol);
        assert_eq!(sim.stats().switches, 0);
        ((sim.x[0] - exact).abs(), sim.stats().evaluations)
    });
    for ((error, _), rtol) in errors.iter().zip([1e-6, 1e-9, 1e-12]) {
        assert!(*error < 30.0 * rtol, "{error:e} at {rtol:e}");
    }
    // What it costs: a few shorter steps.
    assert!(errors[1].1 < 400, "{errors:?}");
}
