//! Kinds of mechanisms: each is a declaration with parameters, the same mechanism for the reference, and how its numbers are drawn.

#[macro_use]
mod declare;

pub mod blocks;
mod laws;
pub mod linkages;
pub mod pendulums;
pub mod slides;

use crate::reference::world::World;
use crate::run::{Order, Outcome, run};
use plm_dynamic::Small;
use plm_oracle::Random;

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
    /// Formulations, with the declaration in each.
    pub declarations: &'static [(&'static str, &'static str)],
    #[cfg(feature = "compiled")]
    pub compiled: &'static [crate::compiled::Runner],
}

impl Family {
    /// A run of the declaration of this number.
    pub fn run(&self, number: usize, order: &Order) -> Outcome {
        let text = self.declarations[number].1;
        let built = plm_oracle::with_numbers(text, order.numbers, order.starts);
        let built: Small = built.expect("the declaration has the numbers of its kind");
        run(built, order)
    }
}

macro_rules! families {
    ($($file:ident::$module:ident: $($formulation:ident)*;)*) => {
        /// Every kind.
        pub static FAMILIES: &[Family] = &[$(Family {
            name: stringify!($module),
            draw: $file::$module::draw,
            declarations: &[$((stringify!($formulation), $file::$module::$formulation::TEXT)),*],
            #[cfg(feature = "compiled")]
            compiled: &[$(crate::compiled::runner::<$file::$module::$formulation::Model>),*],
        }),*];
    };
}

families! {
    blocks::block: tree;
    pendulums::ropes: tree;
    slides::belt: tree;
    linkages::slider_crank: loops absolute;
    blocks::crate_in_corner: tree;
    blocks::wedge: tree absolute;
    blocks::stack: tree;
    blocks::drawer: tree;
    blocks::shaken: tree;
    pendulums::pendulum: tree absolute;
    pendulums::arm: tree absolute;
    slides::train: tree absolute;
    linkages::four_bar: loops absolute;
}
