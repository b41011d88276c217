//! Contact of shapes: circles, lines, polygons, profiles; wheels, cams and indexing.

mod cams;
mod circles;
mod grounds;
mod polylines;
mod rolling;
mod wheels;

const G: f64 = 9.81;

/// Asserts that two numbers differ by `within` at most.
#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!((found - known).abs() <= within, "{found} is not {known}: {:e}", found - known);
}
