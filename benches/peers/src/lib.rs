//! Other simulators on the scenes of the charts of accuracy against speed (`tests/oracle/speed`).
//!
//! With the feature `peers`: diffsol on equations of motion in minimal coordinates, which are written by hand, and rapier2d
//! with impulse joints. Without it the list is empty, and nothing of theirs is compiled.

#[cfg(feature = "peers")]
mod diffsol;
#[cfg(feature = "peers")]
mod minimal;
#[cfg(feature = "peers")]
mod rapier;

/// What one run did and where it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Time from the first step to the last, without any preparation, s.
    pub seconds: f64,
    /// Evaluations of the right-hand side; steps, where a program does not evaluate one.
    pub evaluations: u64,
    /// What errors are measured by: x and y of the centre of gravity of each body, m; of S5 angles, rad.
    pub measured: Vec<f64>,
}

/// What the setting of a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// A relative tolerance; the absolute one is the same, in SI units.
    Tolerance,
    /// A step size, s.
    Step,
}

/// A program with one of its methods on one scene.
#[derive(Clone, Copy)]
pub struct Peer {
    /// The scene, such as `S1`.
    pub scene: &'static str,
    /// Program and method.
    pub name: &'static str,
    /// What its setting is.
    pub setting: Setting,
    /// A run with a setting over the scene's 1 s; nothing if the program gives up.
    pub run: fn(f64) -> Option<Run>,
}

/// Every program on every scene that it holds.
pub fn peers() -> Vec<Peer> {
    #[cfg(feature = "peers")]
    return [diffsol::PEERS, rapier::PEERS].concat();
    #[cfg(not(feature = "peers"))]
    Vec::new()
}
