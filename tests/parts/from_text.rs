//! Parts of the library from text: the bits of compiled ones.

use crate::beside_text::same;
use crate::{belts, brakes, bristles, catches, functions, gears, hydraulics, joints, loose, motors};
use crate::{plates, pneumatics, ropes, screws, signals};

#[test]
fn transmissions_and_drives_have_the_bits_of_compiled_code() {
    same!(
        belts::Belts: 0.5,
        ropes::Ropes: 0.5,
        gears::Meshes: 0.5,
        gears::Play: 0.5,
        screws::Shafts: 0.5,
        motors::Motors: 0.5,
        brakes::Brakes: 0.5,
    );
}

#[test]
fn what_catches_and_rubs_has_the_bits_of_compiled_code() {
    same!(
        catches::Catches: 1.0,
        joints::Limits: 0.5,
        joints::Frictions: 0.5,
        loose::Loose: 0.5,
        bristles::Bristles: 0.5,
        functions::Jumps: 0.5,
        functions::Slide: 0.5,
        plates::Plates: 0.5,
    );
}

#[test]
fn oil_air_and_signals_have_the_bits_of_compiled_code() {
    same!(
        hydraulics::Circuit: 0.05,
        hydraulics::Valves: 0.05,
        pneumatics::Air: 0.05,
        signals::Signals: 0.5,
        signals::Hiss: 0.2,
    );
}
