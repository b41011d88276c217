//! The mechanisms, each declared once; every number is a parameter.

#[macro_use]
mod declare;

pub mod bars;
pub mod groups;
pub mod ladders;
pub mod redundant;
pub mod six_bars;
pub mod trees;

use plm_oracle::{Text, with_numbers};

use crate::run::{self, Order, Outcome};
use crate::scene::Shape;

/// A mechanism of at most eight bodies.
pub type Eight = Text<24, 32, 64, 192>;
/// One of at most twelve.
type Twelve = Text<36, 40, 76, 192>;

/// A mechanism with its declarations.
pub struct Entry {
    pub shape: &'static Shape,
    /// In the formulation that the compiler takes, and in absolute coordinates.
    pub declarations: [&'static str; 2],
    #[cfg(feature = "compiled")]
    pub compiled: crate::compiled::Runners,
}

impl Entry {
    /// May it be run by any method? Those of more than eight bodies are run by the usual one.
    pub fn every_method(&self) -> bool {
        self.shape.bodies.len() <= 8
    }

    /// A run of the declaration of this number.
    pub fn run(&self, declaration: usize, order: &Order) -> Outcome {
        let (text, expected) =
            (self.declarations[declaration], "the declaration has the numbers of its shape");
        if self.every_method() {
            let built: Eight = with_numbers(text, order.numbers, order.starts).expect(expected);
            run::any(built, order)
        } else {
            let built: Twelve = with_numbers(text, order.numbers, order.starts).expect(expected);
            run::usual(built, order)
        }
    }
}

macro_rules! entries {
    ($($file:ident::$module:ident),* $(,)?) => {
        /// Every mechanism.
        pub static ENTRIES: &[Entry] = &[$(Entry {
            shape: &$file::$module::SHAPE,
            declarations: [$file::$module::loops::TEXT, $file::$module::absolute::TEXT],
            #[cfg(feature = "compiled")]
            compiled: crate::compiled::runners!($file::$module),
        }),*];
    };
}

entries![
    trees::tree_3,
    bars::four_bar,
    bars::slider_crank,
    redundant::third_crank,
    trees::tree_2,
    trees::tree_4,
    trees::tree_5,
    bars::shaper,
    six_bars::watt_1,
    six_bars::watt_2,
    six_bars::stephenson_1,
    six_bars::stephenson_2,
    six_bars::stephenson_3,
    groups::butterfly,
    groups::platform,
    ladders::ladder_2,
    ladders::ladder_3,
    ladders::ladder_4,
    ladders::ladder_5,
];
