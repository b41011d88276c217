//! Impacts within fixed steps: they take place at their share of a step, whatever the share is.

use plm_runtime::contact::ImpactLaw;
use plm_runtime::method::Gauss;
use plm_runtime::{Dop853, Mechanism, Method, MoreauJean, Rk4, Sim};

use crate::bodies::rocking;
use crate::impacts::{Ball, Cradle};
use crate::oscillator::Oscillator;

const GRAVITY: f64 = 9.81;

fn by<M: Mechanism<S = f64> + Copy, I: Method<M>>(scene: M, method: I, t: f64) -> Sim<M, I> {
    let mut sim = scene.start_with(method).unwrap();
    sim.step(t).unwrap();
    sim
}

fn at<M: Mechanism<S = f64> + Copy>(scene: M, h: f64, t: f64) -> Sim<M, MoreauJean<f64>> {
    by(scene, MoreauJean::new(h), t)
}

/// Height at a time of a ball that falls from `height`, by its closed form; before the bounces end.
fn bounces(height: f64, restitution: f64, t: f64) -> f64 {
    let mut left = t - (2.0 * height / GRAVITY).sqrt();
    if left < 0.0 {
        return height - 0.5 * GRAVITY * t * t;
    }
    let mut speed = restitution * (2.0 * GRAVITY * height).sqrt();
    while left > 2.0 * speed / GRAVITY {
        left -= 2.0 * speed / GRAVITY;
        speed *= restitution;
    }
    speed * left - 0.5 * GRAVITY * left * left
}

/// A ball strikes at the beginning of a step, at its end, in its middle, and by rounding beside these: its motion is a parabola, which a
/// step has exactly, so that nothing is left but rounding. The shortest rest of a step is 1.5e-8 of it.
#[test]
fn the_share_of_an_impact_does_not_matter() {
    for h in [1e-2, 1e-3, 1.0 / 128.0] {
        for share in [0.0, 1e-15, 1e-12, 1e-9, 1e-6, 0.25, 0.5, 0.75, 1.0 - 1e-6, 1.0 - 1e-9, 1.0 - 1e-12] {
            for restitution in [1.0, 0.8, 0.5] {
                let time = (20.0 + share) * h;
                let height = 0.5 * GRAVITY * time * time;
                let ball = Ball { height, angle: 0.0, restitution };
                for steps in [21.0, 22.0, 30.0, 50.0] {
                    let until = steps * h;
                    let known = bounces(height, restitution, until);
                    let found = at(ball, h, until).x[1];
                    assert!(
                        (found - known).abs() < 1e-9,
                        "{h} {share:e} {restitution} {steps}: {found} {known}"
                    );
                }
            }
        }
    }
}

/// A ball that touches the ground at the start and has a rate: it bounces at once. One that rests, stays.
#[test]
fn an_impact_at_the_start_is_at_once() {
    let h = 1e-3;
    for (speed, restitution) in [(-1.0, 0.5), (-2.0, 1.0), (-1.0, 0.0), (0.0, 0.5), (0.5, 0.5)] {
        let ball = Ball { height: 0.0, angle: 0.0, restitution };
        let mut sim = ball.start_with(MoreauJean::new(h)).unwrap();
        sim.x[3] = speed;
        let mut sim = Sim::<Ball, _>::new(*sim.state(), MoreauJean::new(h));
        sim.step(h).unwrap();
        let back = if speed < 0.0 { -restitution * speed } else { speed };
        let known = if back > 0.0 { back * h - 0.5 * GRAVITY * h * h } else { 0.0 };
        assert!((sim.x[1] - known).abs() < 1e-10, "{speed} {restitution}: {:?} {known:e}", sim.x);
    }
}

/// A rocking block without restitution, after two impacts of its corners: of order 2, by the run that locates events.
#[test]
fn a_rocking_block_is_of_order_2_through_its_impacts() {
    let block = rocking(0.5 * 0.2_f64.atan());
    let mut by_events = block.start_with(Dop853::new(1e-12)).unwrap();
    by_events.step(1.2).unwrap();
    let found = [4e-3, 2e-3, 1e-3, 5e-4].map(|h| (at(block, h, 1.2).x[2] - by_events.x[2]).abs());
    assert!(found[0] < 1e-5 && found[2] < 5e-7 && found[3] < 2e-7, "{found:?}");
    assert!((found[0] / found[3]).log2() > 3.0 * 1.6, "{found:?}");
}

/// Formulas of order 4 keep their order through the impacts of the block, until what is left is the time by which its impacts are late,
/// 1e-8 of a step.
#[test]
fn formulas_keep_their_order_through_impacts() {
    let block = rocking(0.5 * 0.2_f64.atan());
    let mut by_events = block.start_with(Dop853::new(1e-12)).unwrap();
    by_events.step(1.2).unwrap();
    let off = |x: [f64; 6]| (x[2] - by_events.x[2]).abs();
    for h in [1e-2, 4e-3, 1e-3] {
        let found = [off(by(block, Rk4::new(h), 1.2).x), off(by(block, Gauss::<_, 2>::new(h), 1.2).x)];
        let most = 2e-7 * h + h.powi(4);
        assert!(found.iter().all(|off| *off < most), "{h}: {found:?} {most:e}");
    }
    // In intervals of a step, of which each is a run of its own, to 1e-12.
    let mut sim = block.start_with(Rk4::new(1e-2)).unwrap();
    for _ in 0..120 {
        sim.step(1e-2).unwrap();
    }
    assert!(off(sim.x) < 1e-8, "{:?}", sim.x);
}

/// A mass on a belt that sticks, breaks away and is caught again: each slip is a harmonic motion, of which `Rk4` has order 4. Its place
/// 0.1 s after it is caught is known.
#[test]
fn a_mass_on_a_belt_sticks_at_every_length_of_steps() {
    let caught = 0.3924 + 0.433_536_962_770_418_6;
    for h in [1e-2, 7e-3, 4e-3, 1e-3, 2.5e-4, 1e-4] {
        let found = by(Oscillator::ON_BELT, Rk4::new(h), caught + 0.1).x[0];
        assert!((found - 0.01981).abs() < 1e-6 * h + 10.0 * h.powi(4), "{h}: {found}");
    }
}

/// Balls that meet one after the other, in one step or in several: the first stands, the last one leaves, where they met.
#[test]
fn balls_in_a_row_hand_their_motion_on() {
    for (h, gap) in [(1e-3, 0.01), (1e-2, 0.025), (7e-3, 0.0331), (1e-2, 0.03), (4e-3, 0.5)] {
        for law in [ImpactLaw::Poisson, ImpactLaw::Newton, ImpactLaw::Sequential] {
            let sim = at(Cradle { gap, restitution: 1.0, law }, h, 1.0);
            // 0.1 s to the first ball, `gap` seconds to the second one.
            let known = [0.0, gap, gap + 1.0 - 0.1 - gap];
            for i in 0..3 {
                assert!((sim.x[i] - known[i]).abs() < 1e-9, "{h} {gap} {law:?}: {:?} {known:?}", sim.x);
            }
        }
    }
}
