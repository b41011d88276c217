//! Time stepping of Moreau and Jean: error, creep and energy against the step, in scenes with contact.

use plm_runtime::{Dop853, Mechanism, Moment, MoreauJean, Sim, Vector};

use crate::oscillator::Oscillator;
use crate::scenes::{Ball, Block, Crank, Rope, Shaken};
use crate::{clock, gain, reference};

/// Steps, s.
const STEPS: [f64; 7] = [1e-2, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4];
/// Shares of a step that positions make with the velocity at its end.
const THETAS: [f64; 2] = [0.5, 1.0];

// Ends of the scenes whose reference is an event-driven run, s.
/// The mass on the belt slips for the third time.
const BELT_END: f64 = 2.0;
/// The rope is taut.
const ROPE_END: f64 = 1.5;
/// The ball flies after its sixth bounce.
const SHAKEN_END: f64 = 1.8;

/// The first coordinate of an event-driven run with this tolerance.
fn by_events<M: Mechanism<S = f64, X: Vector<f64>>>(scene: M, time: f64, tolerance: f64) -> f64 {
    let mut sim = scene.start_with(Dop853::new(tolerance)).unwrap();
    sim.step_to(time).unwrap();
    sim.state().x().at(0)
}

/// The row of an event-driven run with 1e-8.
fn row_by_events<M: Mechanism<S = f64, X: Vector<f64>>>(name: &str, scene: M, time: f64) {
    let error = (by_events(scene, time, 1e-8) - by_events(scene, time, 1e-12)).abs();
    println!("{name},plm,DOP853,1e-8,{error:.3e},0e0,0,,");
}

/// All rows.
pub fn all() {
    row_by_events("belt", Oscillator::ON_BELT, BELT_END);
    row_by_events("rope", Rope, ROPE_END);
    row_by_events("shaken", Shaken, SHAKEN_END);
    for theta in THETAS {
        for h in STEPS {
            let by = Stepped::<1> { theta, h };
            by.block();
            by.oscillator();
            by.ball();
            by.rocking();
            by.crank();
            by.row_against_events("belt", (Oscillator::ON_BELT, BELT_END), f64::NAN);
            by.rope();
            by.row_against_events("shaken", (Shaken, SHAKEN_END), f64::NAN);
        }
    }
    // Two evaluations make a difference where forces or rows depend on velocities.
    for h in STEPS {
        let by = Stepped::<2> { theta: 0.5, h };
        by.rocking();
        by.crank();
        by.rope();
    }
}

/// Runs by steps of a length.
#[derive(Clone, Copy)]
struct Stepped<const EVALUATIONS: usize> {
    theta: f64,
    h: f64,
}

type Run<M, const EVALUATIONS: usize> = Sim<M, MoreauJean<f64, EVALUATIONS>>;

impl<const EVALUATIONS: usize> Stepped<EVALUATIONS> {
    fn start<M: Mechanism<S = f64>>(self, scene: M) -> Run<M, EVALUATIONS> {
        let method = MoreauJean::new(self.h).with_theta(self.theta).with_evaluations::<EVALUATIONS>();
        scene.start_with(method).unwrap()
    }

    /// A run to a time.
    fn to<M: Mechanism<S = f64>>(self, scene: M, time: f64) -> Run<M, EVALUATIONS> {
        let mut sim = self.start(scene);
        sim.step_to(time).unwrap();
        sim
    }

    fn row<M: Mechanism<S = f64>>(
        self,
        scene: &str,
        error: f64,
        (mechanism, time): (M, f64),
        [creep, gain]: [f64; 2],
    ) {
        let seconds = clock::seconds(|| self.to(mechanism, time).stats().steps);
        let steps = self.to(mechanism, time).stats().steps;
        let number = |value: f64| if value.is_nan() { String::new() } else { format!("{value:.3e}") };
        let settings =
            if EVALUATIONS == 1 { format!("theta {}", self.theta) } else { "two evaluations".into() };
        println!(
            "{scene},plm,{settings},{:.0e},{error:.3e},{seconds:.3e},{steps},{},{}",
            self.h,
            number(creep),
            number(gain)
        );
    }

    /// An hour under 99 % of what friction can bear; a minute by steps below 1 ms.
    fn block(self) {
        let time = if self.h < 1e-3 { 60.0 } else { 3600.0 };
        let mut sim = self.to(Block::pushed(), 0.5 * time);
        let half = sim.x[0];
        sim.step_to(time).unwrap();
        let start = self.start(Block::pushed()).x[0];
        let creep = 1e6 * (sim.x[0] - half).abs() / (0.5 * time);
        self.row("block", (sim.x[0] - start).abs(), (Block::pushed(), time), [creep, f64::NAN]);
    }

    fn oscillator(self) {
        let mut sim = self.to(Oscillator::RELEASED, 2.0);
        let rest = sim.x[0];
        sim.step_to(12.0).unwrap();
        let error = (rest - reference("oscillator", "x")).abs();
        let creep = 1e5 * (sim.x[0] - rest).abs();
        self.row("oscillator", error, (Oscillator::RELEASED, 2.0), [creep, f64::NAN]);
    }

    fn ball(self) {
        let mut sim = self.start(Ball);
        let mut energies = vec![9.81];
        let impact = |k: usize| reference("ball", &format!("impact_{k}"));
        for k in 0..5 {
            sim.step_to(0.5 * (impact(k) + impact(k + 1))).unwrap();
            energies.push(9.81 * sim.x[0] + 0.5 * sim.x[1] * sim.x[1]);
        }
        let error = (self.to(Ball, 3.0).x[0] - reference("ball", "y")).abs();
        self.row("ball", error, (Ball, 3.0), [f64::NAN, gain(&energies, 0.64)]);
    }

    fn rocking(self) {
        let mut sim = self.start(Block::rocking());
        let mut energies = vec![Block::rocking().energy(&sim.x)];
        let impact = |k: usize| reference("rocking", &format!("impact_{k}"));
        for k in 0..3 {
            sim.step_to(0.5 * (impact(k) + impact(k + 1))).unwrap();
            energies.push(Block::rocking().energy(&sim.x));
        }
        let error = (self.to(Block::rocking(), 1.2).x[2].abs() - reference("rocking", "angle")).abs();
        let gain = gain(&energies, reference("rocking", "energy_ratio"));
        self.row("rocking", error, (Block::rocking(), 1.2), [f64::NAN, gain]);
    }

    fn crank(self) {
        let error = (self.to(Crank, 1.0).x[0] - reference("slider-crank", "angle")).abs();
        self.row("slider-crank", error, (Crank, 1.0), [f64::NAN; 2]);
    }

    fn rope(self) {
        let energy = Rope::energy(&self.to(Rope, ROPE_END).x);
        self.row_against_events("rope", (Rope, ROPE_END), energy / Rope::energy_when_taut() - 1.0);
    }

    /// The row of a scene whose reference is an event-driven run: the error of the first coordinate.
    fn row_against_events<M: Mechanism<S = f64, X: Vector<f64>>>(
        self,
        name: &str,
        (scene, end): (M, f64),
        gain: f64,
    ) {
        let error = (self.to(scene, end).state().x().at(0) - by_events(scene, end, 1e-12)).abs();
        self.row(name, error, (scene, end), [f64::NAN, gain]);
    }
}
