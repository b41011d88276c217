//! Eight simulations side by side end with the bits of eight that run alone.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[path = "../it/scenes.rs"]
#[allow(dead_code, unused_imports)] // Other tests use more of it.
mod scenes;

use plm::runtime::lanes::Pack;
use plm::{Batch, Fault, Moment, Rk4, Sim, System};
use scenes::{s1, s2, s5, s6};

/// Eight angles in rad around zero.
const TURNS: [f64; 8] = [0.0, 0.3, -0.2, 0.45, -0.4, 0.1, -0.05, 0.22];

/// Runs eight mechanisms in a batch and alone, for `intervals` of `dt` with steps of `h`; what the last interval gave.
fn agree<M>(
    mechanisms: [M; 8],
    h: f64,
    dt: f64,
    intervals: usize,
) -> ([Sim<M, Rk4<f64>>; 8], [Result<(), Fault>; 8])
where
    M: Pack<S = f64, G = [f64; 0]> + System<S = f64>,
    M::U: std::fmt::Debug + PartialEq,
    M::X: PartialEq,
{
    let mut batch = Batch::start(&mechanisms, Rk4::new(h)).unwrap();
    let mut alone = mechanisms.map(|mechanism| mechanism.start_with(Rk4::new(h)).unwrap());
    let mut last = [Ok(()); 8];
    for interval in 0..intervals {
        let expected = alone.each_mut().map(|sim| sim.step(dt));
        last = batch.step(dt);
        assert_eq!(last, expected, "interval {interval}");
        for (lane, (one, other)) in batch.iter().zip(&alone).enumerate() {
            let moment = |sim: &Sim<M, Rk4<f64>>| (sim.state().time(), *sim.state().x(), sim.state().held());
            assert_eq!(moment(one), moment(other), "lane {lane}, interval {interval}");
            assert_eq!(one.stats(), other.stats(), "lane {lane}, interval {interval}");
        }
    }
    (alone, last)
}

#[test]
fn double_pendulums() {
    let mechanisms = TURNS.map(|turn| {
        let mut mechanism = s1::DoublePendulum::new();
        mechanism.start.arm.angle.value += turn;
        mechanism.start.forearm.angle.value -= 0.5 * turn;
        mechanism
    });
    agree(mechanisms, 1e-3, 0.25, 4);
}

#[test]
fn four_bars() {
    let mechanisms = TURNS.map(|turn| {
        let mut mechanism = s2::FourBar::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    agree(mechanisms, 1e-3, 0.25, 4);
}
#[test]
fn slider_cranks() {
    let mechanisms = TURNS.map(|turn| {
        let mut mechanism = s6::SliderCrank::new();
        mechanism.start.crank.angle.value += turn;
        mechanism
    });
    agree(mechanisms, 1e-3, 0.25, 4);
}
#[test]
fn andrews() {
    let mechanisms = TURNS.map(|_| s5::Andrews::new());
    agree(mechanisms, 1e-5, 0.01, 1);
}
