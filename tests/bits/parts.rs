//! Parts of the library from text: the bits of compiled ones.

use crate::beside_text::same;
use crate::part_scenes as scenes;

#[test]
fn transmissions_and_drives_have_the_bits_of_compiled_code() {
    same!(
        scenes::Belts: 0.5,
        scenes::Chains: 0.5,
        scenes::Ropes: 0.5,
        scenes::Meshes: 0.5,
        scenes::Play: 0.5,
        scenes::Shafts: 0.5,
        scenes::Screws: 0.5,
        scenes::Motors: 0.5,
        scenes::Springs: 0.5,
        scenes::Brakes: 0.5,
        scenes::Clutches: 0.5,
    );
}

#[test]
fn what_catches_and_rubs_has_the_bits_of_compiled_code() {
    same!(
        scenes::Catches: 1.0,
        scenes::Limits: 0.5,
        scenes::Frictions: 0.5,
        scenes::Loose: 0.5,
        scenes::Bristles: 0.5,
        scenes::Jumps: 0.5,
        scenes::Slide: 0.5,
        scenes::Plates: 0.5,
    );
}

#[test]
fn oil_air_and_signals_have_the_bits_of_compiled_code() {
    same!(
        scenes::Circuit: 0.05,
        scenes::Valves: 0.05,
        scenes::Air: 0.05,
        scenes::Signals: 0.5,
        scenes::Delays: 0.5,
        scenes::Hiss: 0.2,
    );
}
