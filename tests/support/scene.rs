//! Mechanisms of tests from text. Rustc compiles none of them, so that a change of one costs milliseconds; they have the bits of those that
//! it does compile (`tests/bits`).
#![allow(dead_code, reason = "each program uses some of it")]

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::sync::{LazyLock, Mutex, PoisonError};

use plm::dynamic::{self, Small};
use plm::runtime::{Absolute as _, Described, Moment, Ports, Rate, Start, StartValues, Statics, absolute};
use plm::{BodyState, Fault, Mechanism};

#[path = "by.rs"]
mod by;

#[allow(unused_imports, reason = "each program uses some of it")]
pub(crate) use by::By;

/// Declares a mechanism by its text: `scene! { pub Ball { … } }`, of which `Ball::new()` is one as declared. A part may stand before it.
macro_rules! scene {
    (@ $text:expr, $(#[$docs:meta])* $visibility:vis $name:ident) => {
        $(#[$docs])*
        $visibility struct $name;

        impl $name {
            /// What it is declared by.
            $visibility const TEXT: &'static str = $text;

            /// The mechanism as declared.
            #[allow(clippy::new_ret_no_self, reason = "as of compiled mechanisms")]
            $visibility fn new() -> $crate::scene::Scene {
                $crate::scene::of_text(Self::TEXT)
            }
        }
    };
    (part $part:ident $places:tt $content:tt $(#[$docs:meta])* $visibility:vis $name:ident $items:tt) => {
        scene!(
            @ concat!(
                "part ", stringify!($part), stringify!($places), stringify!($content),
                "pub ", stringify!($name), stringify!($items)
            ),
            $(#[$docs])* $visibility $name
        );
    };
    ($(#[$docs:meta])* $visibility:vis $name:ident $items:tt) => {
        scene!(@ concat!("pub ", stringify!($name), stringify!($items)), $(#[$docs])* $visibility $name);
    };
}

/// A mechanism from text, of at most 8 bodies.
pub(crate) type Scene = Small;
/// It at one moment.
pub(crate) type State = <Scene as Mechanism>::State;

/// The numbers of a state without first-order states: coordinates, then their rates, each with unused room after.
pub(crate) fn numbers(coordinates: &[f64], rates: &[f64]) -> <Scene as Rate>::X {
    let mut x = [0.0; _];
    let (q, v) = x.split_at_mut(Scene::NQ);
    q[..coordinates.len()].copy_from_slice(coordinates);
    v[..rates.len()].copy_from_slice(rates);
    x
}

/// Those that were read, by their texts: tables are never freed.
static READ: LazyLock<Mutex<BTreeMap<String, dynamic::Mechanism>>> = LazyLock::new(Mutex::default);

/// The mechanism of a declaration, with its defaults.
#[track_caller]
pub(crate) fn of_text(text: &str) -> Scene {
    // A mistake in one declaration fails the test of that one alone.
    let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    if !read.contains_key(text) {
        let mechanism = dynamic::Mechanism::from_text(text).unwrap_or_else(|error| panic!("{error}"));
        read.insert(text.to_owned(), mechanism);
    }
    read[text].small().unwrap()
}

/// The place of a name in a list; a name that is not there is a mistake of the test.
#[track_caller]
fn place<'a>(name: &str, names: impl Iterator<Item = &'a str> + Clone) -> usize {
    let found = names.clone().position(|own| own == name);
    found.unwrap_or_else(|| panic!("there is no `{name}` among {:?}", names.collect::<Vec<_>>()))
}

/// Numbers that are given to a mechanism by their names, SI.
pub(crate) trait Given: Sized {
    /// A parameter.
    fn with(self, name: &str, value: f64) -> Self;
    /// A parameter as it is set.
    fn parameter_of(&self, name: &str) -> f64;
    /// A start value, as `ball.y` is one; whether it is locked stays.
    fn with_start(self, name: &str, value: f64) -> Self;
    /// A start value that assembly keeps.
    fn with_lock(self, name: &str, value: f64) -> Self;
    /// A start value that assembly keeps as it is set.
    fn locked(self, name: &str) -> Self;
    /// A start value that assembly may change.
    fn released(self, name: &str) -> Self;
    /// A start value as it is set.
    fn start_of(&self, name: &str) -> Start<f64>;
    /// All start values from text, as [`starts`](Named::starts) gives it; locks stay.
    fn with_starts(self, text: &str) -> Self;
    /// The start that the joints allow; coordinates of bodies in order, with unused room after.
    fn assemble(&self) -> Result<absolute::Assembly<f64, { Scene::NQ }, 32>, Fault>;
}

impl Given for Scene {
    #[track_caller]
    fn with(mut self, name: &str, value: f64) -> Self {
        let index = place(name, self.tables().parameters.iter().map(|own| own.name));
        *self.parameter_mut(index).unwrap() = value;
        self
    }

    #[track_caller]
    fn parameter_of(&self, name: &str) -> f64 {
        self.parameter(place(name, self.tables().parameters.iter().map(|own| own.name))).unwrap()
    }

    #[track_caller]
    fn with_start(mut self, name: &str, value: f64) -> Self {
        change_start(&mut self, name, |start| start.value = value);
        self
    }

    #[track_caller]
    fn with_lock(mut self, name: &str, value: f64) -> Self {
        change_start(&mut self, name, |start| *start = Start::locked(value));
        self
    }

    #[track_caller]
    fn locked(mut self, name: &str) -> Self {
        change_start(&mut self, name, |start| start.locked = true);
        self
    }

    #[track_caller]
    fn released(mut self, name: &str) -> Self {
        change_start(&mut self, name, |start| start.locked = false);
        self
    }

    #[track_caller]
    fn start_of(&self, name: &str) -> Start<f64> {
        let (mut own, mut found) = (*self, Start::free(f64::NAN));
        change_start(&mut own, name, |start| found = *start);
        found
    }

    #[track_caller]
    fn with_starts(mut self, text: &str) -> Self {
        let read = plm::read_starts(text, *self.starts_mut()).unwrap();
        *self.starts_mut() = read;
        self
    }

    fn assemble(&self) -> Result<absolute::Assembly<f64, { Scene::NQ }, 32>, Fault> {
        absolute::assemble(self, 0.0)
    }
}

#[track_caller]
fn change_start(scene: &mut Scene, name: &str, mut change: impl FnMut(&mut Start<f64>)) {
    let mut is_found = false;
    scene.starts_mut().each(&mut |own, start| {
        if own == name {
            change(start);
            is_found = true;
        }
    });
    assert!(is_found, "there is no start value `{name}`");
}

/// Numbers that are read and set at one moment by their names.
pub(crate) trait Named {
    /// A body.
    fn state_of(&self, body: &str) -> BodyState<f64>;
    /// All bodies.
    fn bodies(&self) -> Vec<BodyState<f64>>;
    /// An output, or what else is observed, SI.
    fn value_of(&self, output: &str) -> f64;
    /// A declared output that is a vector, SI.
    fn vector_of(&self, output: &str) -> [f64; 2];
    /// A first-order state, SI.
    fn number_of(&self, state: &str) -> f64;
    /// All first-order states, SI.
    fn numbers(&self) -> Vec<f64>;
    /// All declared outputs in their units, a vector as two.
    fn outputs(&self) -> Vec<f64>;
    /// Start values that lead here, SI, each on a line as `ball.y = 1`.
    fn starts(&self) -> String;
    /// Reactions that redundancy leaves undetermined, by constraint row.
    fn undetermined(&self) -> Vec<bool>;
    /// An input, SI.
    fn input_of(&self, name: &str) -> f64;
    /// Sets an input, SI.
    fn set_input(&mut self, name: &str, value: f64);
    /// Sets a parameter from here on, SI.
    fn set_parameter(&mut self, name: &str, value: f64);
}

impl Named for State {
    #[track_caller]
    fn state_of(&self, body: &str) -> BodyState<f64> {
        let bodies = self.mechanism().tables().bodies;
        self.body(place(body, bodies.iter().map(|own| own.name))).unwrap()
    }

    fn bodies(&self) -> Vec<BodyState<f64>> {
        let mut all = Vec::new();
        Scene::poses(self, &mut |body| all.push(body));
        all
    }

    #[track_caller]
    fn value_of(&self, output: &str) -> f64 {
        let outputs = self.mechanism().observables();
        self.output(place(output, outputs.iter().map(|(own, _)| *own))).unwrap()
    }

    #[track_caller]
    fn vector_of(&self, output: &str) -> [f64; 2] {
        ["x", "y"].map(|axis| self.value_of(&format!("{output}.{axis}")))
    }

    #[track_caller]
    fn number_of(&self, state: &str) -> f64 {
        let states = self.mechanism().tables().states;
        Scene::state(self, place(state, states.iter().map(|own| own.name))).unwrap()
    }

    fn numbers(&self) -> Vec<f64> {
        let states = self.mechanism().tables().states;
        (0..states.len()).map(|k| Scene::state(self, k).unwrap()).collect()
    }

    fn outputs(&self) -> Vec<f64> {
        let mut all = Vec::new();
        Scene::outputs(self, &mut |value| all.push(value));
        all
    }

    fn starts(&self) -> String {
        let mut text = String::new();
        let mut starts = self.mechanism().starts_at(&Scene::full(self));
        starts.each(&mut |name, start| writeln!(text, "{name} = {:?}", start.value).unwrap());
        text
    }

    fn undetermined(&self) -> Vec<bool> {
        let (own, time) = (self.mechanism(), self.time());
        let poses: Vec<f64> = self.bodies().iter().flat_map(|body| [body.x, body.y, body.angle]).collect();
        let q = *numbers(&poses, &[]).first_chunk().unwrap();
        // Which they are depends on no force.
        let (force, gamma) = ([0.0; Scene::NQ], own.phi(time, &q).map(|_| 0.0));
        let fill = |rows: &mut _| absolute::phi_q_matrix(own, time, &q, rows);
        let solution = absolute::accelerate(time, &own.inverse_mass(), &force, &gamma, fill).unwrap();
        solution.undetermined[..own.row_names().len()].to_vec()
    }

    #[track_caller]
    fn input_of(&self, name: &str) -> f64 {
        let index = place(name, self.mechanism().input_names().iter().map(|(own, _)| *own));
        *Scene::input(Scene::inputs(&mut self.held()), index).unwrap()
    }

    #[track_caller]
    fn set_input(&mut self, name: &str, value: f64) {
        let index = place(name, self.mechanism().input_names().iter().map(|(own, _)| *own));
        *Scene::input(Scene::inputs(self.in_place().held), index).unwrap() = value;
    }

    #[track_caller]
    fn set_parameter(&mut self, name: &str, value: f64) {
        let mechanism = self.mechanism().with(name, value);
        *self = Moment::new(mechanism, self.held(), self.time(), *self.x());
    }
}
