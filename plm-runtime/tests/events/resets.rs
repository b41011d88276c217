//! Events that reset the state, and a mode of three sides, against closed forms.

use plm_runtime::method::{Gauss, Method};
use plm_runtime::singular::Never;
use plm_runtime::{
    Adams, At, Constraints, Dop853, Dopri5, Events, Fault, Health, Labels, Mechanism, Rate, Rk4, Vern9,
};

const GRAVITY: f64 = 9.81;

/// A ball that falls on the ground.
#[derive(Clone, Copy, Debug)]
struct Ball {
    restitution: f64,
}

impl Rate for Ball {
    type S = f64;
    type X = [f64; 2];
    type U = ();
    const NQ: usize = 1;

    fn rate(&self, _t: f64, _u: &(), x: &[f64; 2], dx: &mut [f64; 2]) -> Health<f64> {
        *dx = [x[1], -GRAVITY];
        Health::perfect()
    }
}

impl Constraints for Ball {}

impl Events for Ball {
    type G = [f64; 1];
    fn guards(&self, _t: f64, _u: &(), x: &[f64; 2], g: &mut [f64; 1]) {
        g[0] = x[0];
    }
    fn switch(&self, _t: f64, _u: &mut (), x: &mut [f64; 2], _index: usize) -> Result<(), Fault> {
        // Flights that are lower than rounding are no flights.
        assert!(x[1] < 0.0 || x[1] * x[1] < 1e-11, "it strikes the ground on its way down: {x:?}");
        x[1] = self.restitution * x[1].abs();
        Ok(())
    }
}

impl Labels for Ball {}

impl Mechanism for Ball {
    type State = At<Self>;
    type Rescue = Never<Self>;

    fn start_state(&self, _t: f64) -> Result<((), [f64; 2]), Fault> {
        Ok(((), [1.0, 0.0]))
    }
}

impl Ball {
    /// Height and velocity at any time, and how often it has bounced.
    fn exact(self, time: f64) -> ([f64; 2], u64) {
        let (mut since, mut speed, mut height, mut bounces) = (time, 0.0_f64, 1.0_f64, 0);
        loop {
            let flight = (speed + (speed * speed + 2.0 * GRAVITY * height).sqrt()) / GRAVITY;
            if since < flight {
                let (x, v) =
                    (height + speed * since - 0.5 * GRAVITY * since * since, speed - GRAVITY * since);
                return ([x, v], bounces);
            }
            speed = self.restitution * (GRAVITY * flight - speed);
            (since, height, bounces) = (since - flight, 0.0, bounces + 1);
        }
    }
}

fn a_ball_bounces(method: &impl Method<Ball>, tolerance: f64) {
    for restitution in [1.0, 0.9, 0.5] {
        let ball = Ball { restitution };
        let mut sim = ball.start_with(method.clone()).unwrap();
        for k in 1..=60 {
            let time = 0.02 * f64::from(k);
            sim.step_to(time).unwrap();
            let (exact, bounces) = ball.exact(time);
            let off = (sim.x[0] - exact[0]).abs().max((sim.x[1] - exact[1]).abs());
            assert!(off < tolerance, "{restitution} after {time} s: {:?}, {exact:?}", sim.x);
            assert_eq!(sim.stats().switches, bounces, "{restitution} after {time} s");
        }
    }
}

#[test]
fn a_bouncing_ball_keeps_its_closed_form() {
    a_ball_bounces(&Dop853::default(), 1e-11);
    a_ball_bounces(&Vern9::default(), 1e-11);
    a_ball_bounces(&Dopri5::default(), 1e-11);
    a_ball_bounces(&Adams::default(), 1e-9);
}

/// Steps of fixed length reset at their end: a bounce is late by a step at most, and no bounce is made twice.
#[test]
fn fixed_steps_bounce_once_at_the_end_of_a_step() {
    fn runs(method: impl Method<Ball>) {
        let ball = Ball { restitution: 0.9 };
        let mut sim = ball.start_with(method).unwrap();
        sim.step(1.2).unwrap();
        let (exact, bounces) = ball.exact(1.2);
        assert!((sim.x[0] - exact[0]).abs() < 0.02, "{:?}, {exact:?}", sim.x);
        assert_eq!(sim.stats().switches, bounces);
    }
    runs(Rk4::new(1e-3));
    runs(Gauss::<_, 2>::new(1e-3));
}

/// It comes to rest in finite time with infinitely many bounces, which nothing here closes: the run ends, and says why.
#[test]
fn bouncing_that_does_not_end_is_a_fault() {
    let mut sim = Ball { restitution: 0.5 }.start().unwrap();
    let fault = sim.step(2.0).unwrap_err();
    assert!(fault.to_string().contains("switch"), "{fault}");
    // (1 + 2 e / (1 - e)) sqrt(2 h / g)
    let rest = 3.0 * (2.0 / GRAVITY).sqrt();
    assert!((fault.time - rest).abs() < 1e-5, "{} {rest}", fault.time);
}

/// How a block moves against its belt.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Slip {
    Forwards,
    Sticks,
    Back,
}

/// A block of unit mass on a belt that moves at `SPEED`, on a spring of unit stiffness.
#[derive(Clone, Copy, Debug)]
struct Block;

const SPEED: f64 = 0.5;
const STATIC: f64 = 1.0;
const KINETIC: f64 = 0.6;

impl Rate for Block {
    type S = f64;
    type X = [f64; 2];
    type U = Slip;
    const NQ: usize = 1;

    fn rate(&self, _t: f64, u: &Slip, x: &[f64; 2], dx: &mut [f64; 2]) -> Health<f64> {
        *dx = match u {
            Slip::Sticks => [SPEED, 0.0],
            Slip::Forwards => [x[1], -x[0] - KINETIC],
            Slip::Back => [x[1], -x[0] + KINETIC],
        };
        Health::perfect()
    }
}

impl Constraints for Block {}

impl Events for Block {
    type G = [f64; 1];
    fn guards(&self, _t: f64, u: &Slip, x: &[f64; 2], g: &mut [f64; 1]) {
        g[0] = match u {
            Slip::Sticks => STATIC - x[0].abs(),
            Slip::Forwards => x[1] - SPEED,
            Slip::Back => SPEED - x[1],
        };
    }
    fn switch(&self, _t: f64, u: &mut Slip, x: &mut [f64; 2], _index: usize) -> Result<(), Fault> {
        *u = match u {
            Slip::Sticks if x[0] > 0.0 => Slip::Back,
            Slip::Forwards | Slip::Back if x[0].abs() < STATIC => {
                x[1] = SPEED;
                Slip::Sticks
            }
            Slip::Forwards => Slip::Back,
            Slip::Sticks | Slip::Back => Slip::Forwards,
        };
        Ok(())
    }
}

impl Labels for Block {}

impl Mechanism for Block {
    type State = At<Self>;
    type Rescue = Never<Self>;

    fn start_state(&self, _t: f64) -> Result<(Slip, [f64; 2]), Fault> {
        Ok((Slip::Sticks, [0.0, SPEED]))
    }
}

/// Stick-slip: the block is carried to x = 1, slips about 0.6 with v = 0.5 at both ends, and sticks at x = 0.2.
#[test]
fn a_mode_of_three_sides_keeps_its_cycle() {
    let (spring, radius) = (STATIC - KINETIC, ((STATIC - KINETIC).powi(2) + SPEED * SPEED).sqrt());
    let (half, phase) = (core::f64::consts::PI, SPEED.atan2(spring));
    let slips = half + 2.0 * phase;
    let sticks = 2.0 * spring / SPEED;
    let (first, period) = (STATIC / SPEED, slips + sticks);
    let mut sim = Block.start_with(Dop853::new(1e-12)).unwrap();
    for k in 0..20_u32 {
        let begun = first + f64::from(k) * period;
        // It turns at its lowest place; then it is carried.
        sim.step_to(begun + phase + half).unwrap();
        assert_eq!(sim.held, Slip::Back);
        assert!((sim.x[0] - (KINETIC - radius)).abs() < 1e-9, "{k}: {:?}", sim.x);
        sim.step_to(begun + slips + 0.5 * sticks).unwrap();
        assert_eq!((sim.held, sim.x[1]), (Slip::Sticks, SPEED));
        assert!((sim.x[0] - KINETIC).abs() < 1e-9, "{k}: {:?}", sim.x);
    }
    assert_eq!(sim.stats().switches, 40);
}
