//! The scenes whose steps are counted.
//!
//! The limits are the instructions of one Runge-Kutta 4 step of CasADi's generated C with the same scene in absolute
//! coordinates (gcc, AVX2, callgrind).

#[path = "../../examples/firmware/src/arm.rs"]
mod arm;
mod chain;
pub(crate) mod count;
#[path = "../../tests/support/standard.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;
mod steps;

use declared::{s1, s2, s5, s6};
use steps::steps;

/// The same in the coordinates that the limits were taken in.
#[allow(unreachable_pub, reason = "the macros declare for tests too")]
mod absolute {
    use super::declared::{andrews, double_pendulum, four_bar, slider_crank};

    double_pendulum!(s1: formulation: absolute; output shoulder.force, elbow.force;);
    four_bar!(s2: formulation: absolute; output drive.force;);
    slider_crank!(s6: formulation: absolute; output drive.force;);
    andrews!(s5: formulation: absolute; output r1.force, r2.force, r4.force;);
}

pub(crate) use steps::{Level, Steps};

chain::chain!(Chain4, 4);
chain::chain!(Chain16, 16);
chain::chain!(Chain64, 64);

/// A mechanism, its step, its limit.
pub(crate) struct Scene {
    /// As in the table; a name that begins with `chain` takes part in the check of growth.
    pub(crate) name: &'static str,
    pub(crate) bodies: u32,
    /// Length of a step, s.
    pub(crate) h: f64,
    /// Instructions that a step may need.
    pub(crate) limit: Option<u32>,
    /// Instructions that a step of `Sim` may need. In absolute coordinates some project every step, and loops are looked at for
    /// turns next to flat poses (580 instructions of S2). What depends on parameters alone, a loop over the formula computes
    /// once, and `Sim` in each step (the arm: 216 instructions).
    pub(crate) with_sim: u32,
    pub(crate) steps: fn(f64, Level) -> Steps,
}

const fn scene(
    name: &'static str,
    bodies: u32,
    h: f64,
    (limit, with_sim): (Option<u32>, u32),
    steps: fn(f64, Level) -> Steps,
) -> Scene {
    Scene { name, bodies, h, limit, with_sim, steps }
}

pub(crate) const SCENES: &[Scene] = &[
    scene("S1", 2, 1e-3, (Some(2066), 600), |h, level| steps(s1::DoublePendulum::new(), h, level)),
    scene("S2", 3, 1e-3, (Some(3200), 670), |h, level| steps(s2::FourBar::new(), h, level)),
    scene("S6", 3, 1e-3, (Some(2389), 585), |h, level| steps(s6::SliderCrank::new(), h, level)),
    scene("S5", 7, 1e-5, (Some(9026), 1370), |h, level| steps(s5::Andrews::new(), h, level)),
    scene("arm on jack", 1, 1e-5, (None, 1660), |h, level| steps(arm::Arm::new(), h, level)),
    scene("S1 absolute", 2, 1e-3, (Some(2066), 1480), |h, level| {
        steps(absolute::s1::DoublePendulum::new(), h, level)
    }),
    scene("S2 absolute", 3, 1e-3, (Some(3200), 3820), |h, level| {
        steps(absolute::s2::FourBar::new(), h, level)
    }),
    scene("S6 absolute", 3, 1e-3, (Some(2389), 2320), |h, level| {
        steps(absolute::s6::SliderCrank::new(), h, level)
    }),
    scene("S5 absolute", 7, 1e-5, (Some(9026), 30_300), |h, level| {
        steps(absolute::s5::Andrews::new(), h, level)
    }),
    scene("chain 4", 4, 1e-3, (None, 1515), |h, level| steps(Chain4::new(), h, level)),
    scene("chain 16", 16, 1e-3, (None, 8600), |h, level| steps(Chain16::new(), h, level)),
    scene("chain 64", 64, 1e-4, (None, 36_300), |h, level| steps(Chain64::new(), h, level)),
];

/// The scene of this name.
pub(crate) fn named(name: &str) -> &'static Scene {
    SCENES.iter().find(|scene| scene.name == name).expect("a scene of the table")
}
