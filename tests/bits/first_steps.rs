//! The bits of the first steps of eight mechanisms, as they are emitted.
//!
//! Beside each declaration, `tests/snapshots/*.plm`, stands its emitted code, which the test `emitted` compares and writes; here it
//! is compiled. `PLM_BLESS=1 cargo test --test bits` writes the bits anew.

use plm::Rk4;
use plm::runtime::{Mechanism, Moment, Vector};

use crate::blessed::blessed;
use crate::emitted::{
    arm_on_jack, bouncer, chain, double_pendulum, driven_crank, four_bar, plate_on_three_pins, slider_crank,
};

/// The bits of the state and the outputs after ten steps of a tenth of a millisecond.
fn bits<M: Mechanism<S = f64>, O: IntoIterator<Item = f64>>(
    name: &str,
    mechanism: M,
    outputs: impl Fn(&M::State) -> O,
) -> String {
    let mut sim = mechanism.start_with(Rk4::new(1e-4)).unwrap();
    sim.step(1e-3).unwrap();
    let state = sim.state();
    let values = (0..M::X::LEN).map(|k| state.x().at(k)).chain(outputs(state));
    let words: Vec<String> = values.map(|value| format!("{:016x}", value.to_bits())).collect();
    format!("{name}: {}\n", words.join(" "))
}

#[test]
#[allow(clippy::redundant_closure_for_method_calls, reason = "the method's own path is longer than the call")]
fn first_steps_have_the_bits_that_they_had() {
    let found = [
        bits("arm_on_jack", arm_on_jack::ArmOnJack::new(), |state| state.outputs()),
        bits("bouncer", bouncer::Bouncer::new(), |state| state.outputs()),
        bits("chain", chain::Chain::new(), |state| state.outputs()),
        bits("double_pendulum", double_pendulum::DoublePendulum::new(), |state| state.outputs()),
        bits("driven_crank", driven_crank::DrivenCrank::new(), |state| state.outputs()),
        bits("four_bar", four_bar::FourBar::new(), |state| state.outputs()),
        bits("plate_on_three_pins", plate_on_three_pins::PlateOnThreePins::new(), |state| state.outputs()),
        bits("slider_crank", slider_crank::SliderCrank::new(), |state| state.outputs()),
    ];
    blessed("bits.txt", &found.concat()).unwrap();
}
