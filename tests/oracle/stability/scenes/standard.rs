//! Benchmark scenes, declared beside the other tests.

#[path = "../../../support/scenes.rs"]
#[allow(unused_imports, unused_macros, reason = "there are more of them")]
mod shared;

use plm_dynamic::Dynamic;

use self::shared::{double_pendulum, four_bar};
use crate::text::{Scene, scene};

/// Keeps a declaration as its text.
macro_rules! declared {
    ($(#[$docs:meta])* pub $name:ident $items:tt) => {
        pub const TEXT: &str = concat!("pub ", stringify!($name), stringify!($items));
    };
}

double_pendulum!([declared] of_double_pendulum:);
four_bar!([declared] of_four_bar:);

/// S1.
pub fn double_pendulum() -> Scene {
    scene(of_double_pendulum::TEXT)
}

/// S2.
pub fn four_bar() -> Scene {
    scene(of_four_bar::TEXT)
}

/// S2 in single precision.
pub fn four_bar_in_f32() -> Dynamic<f32, 24, 32, 64> {
    four_bar().map(&|number| number as f32)
}
