//! Inverse dynamics against Newton's and Euler's equations of free bodies, closed forms, and runs by what was found.

mod followed;
mod linkages;
mod modes;
mod newton_euler;
mod runs;

use plm::dynamic::{Compiled, Small};
use plm::runtime::described::by_number;
use plm::runtime::{Described, Mechanism, Ports};
use plm::{Moment, Sim};

/// A run of a mechanism from text.
fn started(declaration: &str) -> Sim<Small> {
    let compiled =
        Compiled::new("mechanism.plm", declaration).unwrap_or_else(|refused| panic!("{refused:?}"));
    let mechanism: Small = compiled.mechanism().unwrap();
    mechanism.start().unwrap()
}

/// Angle and angular velocity of a body by its name.
fn angle(state: &<Small as Mechanism>::State, name: &str) -> [f64; 2] {
    let body = state.mechanism().tables().bodies.iter().position(|body| body.name == name).unwrap();
    let pose = <Small as Described>::pose(state, body).unwrap();
    [pose.angle, pose.omega]
}

/// Sets an input of a run.
fn set(sim: &mut Sim<Small>, name: &str, value: f64) {
    let mut names = sim.state().mechanism().input_names().iter();
    let index = names.position(|(own, _)| *own == name).unwrap();
    assert!(by_number::set_input(sim, index, value));
}

#[track_caller]
fn near(found: f64, known: f64, within: f64) {
    assert!(
        (found - known).abs() <= within * known.abs().max(1.0),
        "{found} is not {known}: {:e}",
        found - known
    );
}
