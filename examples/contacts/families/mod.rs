//! Kinds of mechanisms: each is a declaration with parameters, the same mechanism for the reference, and how its numbers are drawn.

#[macro_use]
mod declare;

pub mod blocks;
mod laws;
#[cfg(feature = "sweep-all")]
pub mod linkages;
pub mod pendulums;
pub mod slides;

use crate::random::Random;
use crate::reference::world::World;
use crate::run::{Runner, runner};

/// The numbers of a case.
#[derive(Clone, Debug)]
pub struct Draft {
    /// Parameters in the order of the declaration.
    pub numbers: Vec<f64>,
    /// x, y, angle, vx, vy, omega of each body.
    pub starts: Vec<[f64; 6]>,
    pub world: World,
}

/// A kind.
pub struct Family {
    pub name: &'static str,
    pub draw: fn(&mut Random) -> Draft,
    /// One for each formulation that is declared.
    pub runners: &'static [(&'static str, Runner)],
    /// The declaration of each.
    #[cfg(feature = "jit")]
    pub declarations: &'static [&'static str],
}

macro_rules! family {
    ($file:ident::$module:ident: $($formulation:ident)*) => {
        Family {
            name: stringify!($module),
            draw: $file::$module::draw,
            runners: &[$((stringify!($formulation), runner::<$file::$module::$formulation::Model>)),*],
            #[cfg(feature = "jit")]
            declarations: &[$(<$file::$module::$formulation::Model as plm::runtime::Described>::DECLARATION),*],
        }
    };
}

/// Every kind that is compiled.
pub static FAMILIES: &[Family] = &[
    family!(blocks::block: tree),
    family!(pendulums::ropes: tree),
    family!(slides::belt: tree),
    #[cfg(feature = "sweep-all")]
    family!(linkages::slider_crank: loops absolute),
    #[cfg(feature = "sweep-all")]
    family!(blocks::crate_in_corner: tree),
    #[cfg(feature = "sweep-all")]
    family!(blocks::wedge: tree absolute),
    #[cfg(feature = "sweep-all")]
    family!(blocks::stack: tree),
    #[cfg(feature = "sweep-all")]
    family!(blocks::drawer: tree),
    #[cfg(feature = "sweep-all")]
    family!(blocks::shaken: tree),
    #[cfg(feature = "sweep-all")]
    family!(pendulums::pendulum: tree absolute),
    #[cfg(feature = "sweep-all")]
    family!(pendulums::arm: tree absolute),
    #[cfg(feature = "sweep-all")]
    family!(slides::train: tree absolute),
    #[cfg(feature = "sweep-all")]
    family!(linkages::four_bar: loops absolute),
];
