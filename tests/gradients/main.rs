//! Derivatives of runs by parameters and start values, against closed forms.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[macro_use]
#[path = "../support/scene.rs"]
mod scene;

mod adjoint;
mod closed;
mod cycle;
mod events;
mod loops;
mod many;
mod rough;
mod sides;
mod step;

use plm::BodyState;
use plm::runtime::{Described, Moment, Rate};

/// A body of a mechanism from text, in any numbers.
#[track_caller]
fn body<T: Moment<M: Described<State = T>>>(state: &T, name: &str) -> BodyState<<T::M as Rate>::S> {
    let bodies = state.mechanism().tables().bodies;
    let place = bodies.iter().position(|own| own.name == name).unwrap();
    T::M::pose(state, place).unwrap()
}

/// The derivative of a function of one number, by five points: good to 1e-11 of what is of size 1.
fn slope(f: impl Fn(f64) -> f64, at: f64) -> f64 {
    let h = 1e-3 * at.abs();
    (8.0 * (f(at + h) - f(at - h)) - (f(at + 2.0 * h) - f(at - 2.0 * h))) / (12.0 * h)
}

/// Asserts that derivatives are those of a function of so many numbers.
#[track_caller]
fn are_slopes<const K: usize>(found: [f64; K], f: impl Fn([f64; K]) -> f64, at: [f64; K], within: f64) {
    for (k, found) in found.into_iter().enumerate() {
        let along = |value| f(core::array::from_fn(|i| if i == k { value } else { at[i] }));
        let known = slope(along, at[k]);
        assert!(
            (found - known).abs() <= within,
            "direction {k}: {found} is not {known}: {:e}",
            found - known
        );
    }
}
