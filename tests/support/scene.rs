//! Mechanisms of tests from text. Rustc compiles none of them, so that a change of one costs milliseconds; they have the bits of those that
//! it does compile (`tests/contact/from_text.rs`, `plm-dynamic/tests/bits.rs`).

use std::collections::BTreeMap;
use std::sync::{LazyLock, Mutex};

use plm::BodyState;
use plm::dynamic::{self, Small};
use plm::runtime::{Described, Moment, Ports, Start, StartValues, Statics};

/// Declares a mechanism by its text: `scene! { pub Ball { … } }`, of which `Ball::new()` is one as declared.
macro_rules! scene {
    ($(#[$docs:meta])* $visibility:vis $name:ident $items:tt) => {
        $(#[$docs])*
        $visibility struct $name;

        impl $name {
            /// What it is declared by.
            $visibility const TEXT: &'static str = concat!("pub ", stringify!($name), stringify!($items));

            /// The mechanism as declared.
            #[allow(clippy::new_ret_no_self, reason = "as of compiled mechanisms")]
            $visibility fn new() -> $crate::scene::Scene {
                $crate::scene::of_text(Self::TEXT)
            }
        }
    };
}

/// A mechanism from text, of at most 8 bodies.
pub(crate) type Scene = Small;
/// It at one moment.
pub(crate) type State = <Scene as plm::Mechanism>::State;

/// Those that were read, by their texts: tables are never freed.
static READ: LazyLock<Mutex<BTreeMap<String, dynamic::Mechanism>>> = LazyLock::new(Mutex::default);

/// The mechanism of a declaration, with its defaults.
#[track_caller]
pub(crate) fn of_text(text: &str) -> Scene {
    let mut read = READ.lock().unwrap();
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
    /// A start value, as `ball.y` is one; whether it is locked stays.
    fn with_start(self, name: &str, value: f64) -> Self;
    /// A start value that assembly keeps.
    fn with_lock(self, name: &str, value: f64) -> Self;
}

impl Given for Scene {
    #[track_caller]
    fn with(mut self, name: &str, value: f64) -> Self {
        let index = place(name, self.tables().parameters.iter().map(|own| own.name));
        *self.parameter_mut(index).unwrap() = value;
        self
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
}

#[track_caller]
fn change_start(scene: &mut Scene, name: &str, change: impl Fn(&mut Start<f64>)) {
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
    /// An output, or what else is observed, SI.
    fn value_of(&self, output: &str) -> f64;
    /// A first-order state, SI.
    fn number_of(&self, state: &str) -> f64;
    /// Sets an input, SI.
    fn set_input(&mut self, name: &str, value: f64);
}

impl Named for State {
    #[track_caller]
    fn state_of(&self, body: &str) -> BodyState<f64> {
        let bodies = self.mechanism().tables().bodies;
        self.body(place(body, bodies.iter().map(|own| own.name))).unwrap()
    }

    #[track_caller]
    fn value_of(&self, output: &str) -> f64 {
        let outputs = self.mechanism().observables();
        self.output(place(output, outputs.iter().map(|(own, _)| *own))).unwrap()
    }

    #[track_caller]
    fn number_of(&self, state: &str) -> f64 {
        let states = self.mechanism().tables().states;
        Scene::state(self, place(state, states.iter().map(|own| own.name))).unwrap()
    }

    #[track_caller]
    fn set_input(&mut self, name: &str, value: f64) {
        let index = place(name, self.mechanism().input_names().iter().map(|(own, _)| *own));
        *Scene::input(Scene::inputs(self.in_place().held), index).unwrap() = value;
    }
}
