//! Mechanisms from text with rows of contact: the bits of compiled ones.

use std::iter::once;
use std::ops::ControlFlow;

use plm::runtime::Described;
use plm::view::Recorder;
use plm::{Dop853, dynamic};

use crate::beside_text::same;
use crate::contact_scenes as scenes;

/// Bouncing to its end, frictions that stick, rows that begin to exist, bodies that are released, known times, the laws of impact.
#[test]
fn trees_have_the_bits_of_compiled_code() {
    same!(
        scenes::Ball: 3.0,
        scenes::Oscillator: 1.0,
        scenes::Stairs: 1.0,
        scenes::Released: 1.0,
        scenes::Dog: 1.0,
        scenes::Timed: 1.0,
        scenes::Newton: 0.5,
        scenes::Sequential: 0.5,
    );
}

/// Constraints with a condition that hold at the start, frictions that reactions along a line and in the plane bound.
#[test]
fn absolute_coordinates_have_the_bits_of_compiled_code() {
    same!(scenes::HungInBodies: 1.2, scenes::CollarInAbsolute: 0.5, scenes::RubbingInAbsolute: 0.3);
}

/// Loops in charts; one of them locks up.
#[test]
fn loops_have_the_bits_of_compiled_code() {
    same!(scenes::FourBarInCharts: 0.5, scenes::InThreePins: 0.2, scenes::LinkageInCharts: 0.6);
}

/// Samples of a run from text, those before and after impacts too, are the rows of the CSV of a compiled program.
#[test]
fn samples_are_those_of_compiled_programs() {
    let mut sim = scenes::Ball::new().start_with(Dop853::new(1e-9)).unwrap();
    let mut recorder = Recorder::observing_all(&sim);
    recorder.run(&mut sim, 3.0, 0.25).unwrap();
    let mut csv = Vec::new();
    recorder.recording().write_csv_to(&mut csv).unwrap();
    let csv = String::from_utf8(csv).unwrap();
    let text = dynamic::Mechanism::from_text(<scenes::Ball>::DECLARATION).unwrap();
    let mut run = text.start_with("Dop853:1e-9".parse().unwrap()).unwrap();
    let mut lines = csv.lines().skip(1);
    let mut samples = 0;
    run.record(3.0, 0.25, |sample| {
        let numbers: Vec<f64> = lines.next().unwrap().split(',').map(|text| text.parse().unwrap()).collect();
        let own: Vec<f64> = once(sample.time).chain(sample.values.iter().copied()).collect();
        let known = once(&numbers[0]).chain(&numbers[numbers.len() - sample.values.len()..]);
        assert!(own.iter().zip(known).all(|(own, known)| own == known), "{own:?} {numbers:?}");
        samples += 1;
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(lines.next().is_none() && samples > 15, "{samples}");
}
