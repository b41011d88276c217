//! Mechanisms of the scenes, from their declarations as machine code: the bits are those of compiled ones (`tests/bits`).

use plm_dynamic::Dynamic;
use plm_oracle::mechanism;
use plm_runtime::{BodyState, Described, Mechanism, Moment, StartValues as _, Statics};

#[path = "../../support/by.rs"]
mod by;

pub(crate) use by::By;

/// A mechanism of at most 8 bodies.
pub type Scene = Dynamic<f64, 24, 32, 64>;
/// It at one moment.
pub type State = <Scene as Mechanism>::State;
/// A mechanism of at most 81 bodies and 242 rows, which runs on a [thread of its own](deep).
pub type Large = Dynamic<f64, 243, 242, 486, 81>;
/// It at one moment.
pub type LargeState = <Large as Mechanism>::State;

const TAKEN: &str = "the declaration is right, and there is room for it";

/// The mechanism of a declaration, with its defaults.
pub fn scene(declaration: &str) -> Scene {
    mechanism(declaration).expect(TAKEN)
}

/// The same of one that is large.
pub fn large(declaration: &str) -> Large {
    mechanism(declaration).expect(TAKEN)
}

/// A declaration in absolute coordinates.
pub fn absolute(declaration: &str) -> String {
    declaration.replacen(" {\n", " {\n    formulation: absolute;\n", 1)
}

/// Does work on a thread whose stack has room for matrices of large mechanisms.
pub fn deep<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> T {
    let thread = std::thread::Builder::new().stack_size(256 << 20).spawn(work);
    thread.expect("a thread").join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

/// Numbers that are given to a mechanism by their names, SI.
pub trait Given: Sized {
    /// A parameter.
    fn with(self, name: &str, value: f64) -> Self;
    /// A parameter as it is set.
    fn parameter_of(&self, name: &str) -> f64;
    /// A start value, as `crank.angle` is one; whether it is locked stays.
    fn with_start(self, name: &str, value: f64) -> Self;
}

impl<M: Described<S = f64> + Statics> Given for M {
    fn with(mut self, name: &str, value: f64) -> Self {
        let index = parameter(&self, name);
        *self.parameter_mut(index).expect(name) = value;
        self
    }

    fn parameter_of(&self, name: &str) -> f64 {
        self.parameter(parameter(self, name)).expect(name)
    }

    fn with_start(mut self, name: &str, value: f64) -> Self {
        let mut is_found = false;
        self.starts_mut().each(&mut |own, start| {
            if own == name {
                start.value = value;
                is_found = true;
            }
        });
        assert!(is_found, "there is no start value `{name}`");
        self
    }
}

fn parameter<M: Described>(of: &M, name: &str) -> usize {
    of.tables().parameters.iter().position(|own| own.name == name).expect(name)
}

/// Bodies by their names.
pub trait Named {
    /// Pose and velocity of a body.
    fn body_of(&self, body: &str) -> BodyState<f64>;
}

impl<M: Described<S = f64, State = T>, T: Moment<M = M>> Named for T {
    fn body_of(&self, body: &str) -> BodyState<f64> {
        let number = self.mechanism().tables().bodies.iter().position(|own| own.name == body);
        number.and_then(|number| M::pose(self, number)).expect(body)
    }
}
