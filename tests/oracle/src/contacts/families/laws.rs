//! Rows that families share.

use crate::reference::world::{At, Bound, Law, Place, World};

/// A point of a body on a line of the ground, with friction.
pub fn foot(world: &mut World, sole: At, floor: At, angle: f64, [mu, e]: [f64; 2]) {
    let along = |angle| Place::Along { a: sole, b: floor, angle, turns: true, swing: [0.0; 2] };
    let gap = world.row(along(angle + std::f64::consts::FRAC_PI_2), Law::Gap { restitution: e });
    let bound = Bound { by: Some((gap, mu)), adhesion: 1.0, ..Bound::default() };
    world.row(along(angle), Law::Rub(bound));
}

/// A friction with a bound of its own.
pub fn dry(own: f64) -> Law {
    Law::Rub(Bound { own: [own; 2], adhesion: 1.0, ..Bound::default() })
}

/// A friction bounded by the force of a pin whose rows begin with `pin`.
pub fn loaded(pin: usize, share: f64) -> Law {
    Law::Rub(Bound { joint: Some((pin, Some(pin + 1), share)), adhesion: 1.0, ..Bound::default() })
}

/// A sum of coordinates.
pub fn sum<const N: usize>(terms: [(usize, f64); N], offset: f64) -> Place {
    Place::Sum { terms: terms.to_vec(), offset, rate: 0.0 }
}
