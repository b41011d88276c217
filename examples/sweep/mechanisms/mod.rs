//! The mechanisms, each declared once; every number is a parameter.

#[macro_use]
mod declare;

pub mod bars;
pub mod groups;
pub mod ladders;
pub mod redundant;
pub mod six_bars;
pub mod trees;

use plm::{BodyState, Mechanism};

use crate::run::{self, Order, Outcome};
use crate::scene::Shape;

/// A declared mechanism that takes its numbers from a scene.
pub trait Build: Mechanism {
    /// With parameters in the order of `Scene::numbers`, and with start values: of each body x, y, angle, vx, vy, omega,
    /// and whether they are locked.
    fn build(numbers: &[f64], starts: &[(f64, bool)]) -> Self;
    /// Gives `each` the bodies in their order.
    fn bodies(state: &Self::State, each: impl FnMut(BodyState<Self::S>));
    /// Kinetic energy and that of gravity, J.
    fn energies(state: &Self::State) -> [Self::S; 2];
}

/// A mechanism by the ways in which it can be run.
pub struct Entry {
    pub shape: &'static Shape,
    pub default: Runner,
    pub absolute: Runner,
    pub single: Runner,
    /// Whether `default` knows all methods and the others those of fixed steps, or all only the one that `start()` takes.
    pub every_method: bool,
}

/// Runs a case.
pub type Runner = fn(&Order) -> Outcome;

macro_rules! entry {
    ($file:ident::$module:ident $default:ident $other:ident $every:literal) => {
        Entry {
            shape: &$file::$module::SHAPE,
            default: run::$default::<$file::$module::loops::Linkage<f64>>,
            absolute: run::$other::<$file::$module::absolute::Linkage<f64>>,
            single: run::$other::<$file::$module::loops::Linkage<f32>>,
            every_method: $every,
        }
    };
}

/// Every mechanism that is compiled. All methods for all of them would cost minutes of compilation and show nothing more.
pub static ENTRIES: &[Entry] = &[
    entry!(trees::tree_3 any fixed true),
    entry!(bars::four_bar any fixed true),
    entry!(bars::slider_crank any fixed true),
    entry!(redundant::third_crank usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(trees::tree_2 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(trees::tree_4 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(trees::tree_5 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(bars::shaper usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(six_bars::watt_1 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(six_bars::watt_2 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(six_bars::stephenson_1 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(six_bars::stephenson_2 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(six_bars::stephenson_3 any fixed true),
    #[cfg(feature = "sweep-all")]
    entry!(groups::butterfly usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(groups::platform usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(ladders::ladder_2 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(ladders::ladder_3 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(ladders::ladder_4 usual usual false),
    #[cfg(feature = "sweep-all")]
    entry!(ladders::ladder_5 usual usual false),
];
