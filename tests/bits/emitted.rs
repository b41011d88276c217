//! The eight mechanisms of `tests/snapshots`, as they are emitted.
#![allow(
    unused_qualifications,
    reason = "emitted code qualifies where a name of the user's could stand in the way"
)]

#[path = "../snapshots/arm_on_jack.rs"]
pub(crate) mod arm_on_jack;
#[path = "../snapshots/bouncer.rs"]
pub(crate) mod bouncer;
#[path = "../snapshots/chain.rs"]
pub(crate) mod chain;
#[path = "../snapshots/double_pendulum.rs"]
pub(crate) mod double_pendulum;
#[path = "../snapshots/driven_crank.rs"]
pub(crate) mod driven_crank;
#[path = "../snapshots/four_bar.rs"]
pub(crate) mod four_bar;
#[path = "../snapshots/plate_on_three_pins.rs"]
pub(crate) mod plate_on_three_pins;
#[path = "../snapshots/slider_crank.rs"]
pub(crate) mod slider_crank;
