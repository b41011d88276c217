//! The scenes whose steps are counted.
//!
//! The limits are the instructions of one Runge-Kutta 4 step of CasADi's generated C with the same scene in absolute
//! coordinates (gcc, AVX2, callgrind).

mod chain;
#[path = "../../tests/it/scenes.rs"]
#[allow(dead_code, unused_imports, unreachable_pub)] // The tests use more of it.
mod declared;

use super::{Level, run};
use declared::{s1, s2, s5, s6};

chain::chain!(Chain4, 4);
chain::chain!(Chain16, 16);
chain::chain!(Chain64, 64);

/// A mechanism, its step, its limit.
pub(crate) struct Scene {
    /// As in the table; a name that begins with `chain` takes part in the check of growth.
    pub(crate) name: &'static str,
    pub(crate) bodies: u32,
    /// Instructions that a step may need.
    pub(crate) limit: Option<u32>,
    pub(crate) run: fn(Level, u32),
}

const fn scene(name: &'static str, bodies: u32, limit: Option<u32>, run: fn(Level, u32)) -> Scene {
    Scene { name, bodies, limit, run }
}

pub(crate) const SCENES: &[Scene] = &[
    scene("S1", 2, Some(2066), |level, steps| run(s1::DoublePendulum::new(), 1e-3, level, steps)),
    scene("S2", 3, Some(3200), |level, steps| run(s2::FourBar::new(), 1e-3, level, steps)),
    scene("S6", 3, Some(2389), |level, steps| run(s6::SliderCrank::new(), 1e-3, level, steps)),
    scene("S5", 7, Some(9026), |level, steps| run(s5::Andrews::new(), 1e-5, level, steps)),
    scene("chain 4", 4, None, |level, steps| run(Chain4::new(), 1e-3, level, steps)),
    scene("chain 16", 16, None, |level, steps| run(Chain16::new(), 1e-3, level, steps)),
    scene("chain 64", 64, None, |level, steps| run(Chain64::new(), 1e-4, level, steps)),
];
