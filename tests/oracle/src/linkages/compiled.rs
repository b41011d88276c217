//! Mechanisms that rustc has compiled: in f32, and the bits of those from text.

use plm_oracle::Look;
use plm_runtime::{Linear, Start};

use crate::run::{self, Order, Outcome};

/// A compiled mechanism that takes its numbers from a scene.
pub trait Build: Look {
    /// With parameters in the order of `Scene::numbers`, and with start values: of each body x, y, angle, vx, vy, omega.
    fn build(numbers: &[f64], starts: &[Start<f64>]) -> Self;
}

/// Runs a case.
pub type Runner = fn(&Order) -> Outcome;

/// The declarations of an entry, and the first of them in f32.
pub struct Runners {
    pub declarations: [Runner; 2],
    pub single: Runner,
}

macro_rules! runners {
    ($file:ident::$module:ident) => {
        $crate::compiled::Runners {
            declarations: [
                $crate::compiled::run::<$file::$module::loops::Linkage<f64>>,
                $crate::compiled::run::<$file::$module::absolute::Linkage<f64>>,
            ],
            single: $crate::compiled::single::<$file::$module::loops::Linkage<f32>>,
        }
    };
}
pub(crate) use runners;

pub fn run<M: Build<S = f64> + Linear>(order: &Order) -> Outcome {
    run::any(M::build(order.numbers, order.starts), order)
}

pub fn single<M: Build<S = f32> + Linear>(order: &Order) -> Outcome {
    run::fixed(M::build(order.numbers, order.starts), order)
}
