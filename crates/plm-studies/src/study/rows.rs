//! Rows of points: by a function, one by one, or by simulations that run to a time side by side.

use std::fmt;

use plm_runtime::lanes::Pack;
use plm_runtime::method::{Embedded, Pair};
use plm_runtime::{Fault, Sim};

use crate::batch::{Failure, caught};
use crate::together::{TOGETHER, together};

/// Makes the rows of C numbers of points of P parameters. Functions of a point are such, and simulations of [`Study::to`](super::Study::to).
pub trait Rows<const P: usize, const C: usize>: Sync {
    /// Points that a thread takes at once.
    const AT_ONCE: usize;

    /// Gives `done` the place of each point among these and its row, or why it has none.
    fn rows(&self, points: &[[f64; P]], done: &mut dyn FnMut(usize, Result<[f64; C], String>));
}

impl<F, E, const P: usize, const C: usize> Rows<P, C> for F
where
    F: Fn([f64; P]) -> Result<[f64; C], E> + Sync,
    E: fmt::Display,
{
    /// A run can take a second: threads take them one by one.
    const AT_ONCE: usize = 1;

    fn rows(&self, points: &[[f64; P]], done: &mut dyn FnMut(usize, Result<[f64; C], String>)) {
        for (place, point) in points.iter().enumerate() {
            let row = caught(|| self(*point).map_err(|error| error.to_string()));
            done(place, row.unwrap_or_else(|words| Err(Failure::Panic(words).to_string())));
        }
    }
}

/// Simulations that run to a time, s.
#[derive(Clone, Debug)]
pub struct To<S, R> {
    pub(super) until: f64,
    pub(super) start: S,
    pub(super) row: R,
}

impl<S, R, M, Q, const P: usize, const C: usize> Rows<P, C> for To<S, R>
where
    S: Fn([f64; P]) -> Result<Sim<M, Embedded<M, Q>>, Fault> + Sync,
    R: Fn(&Sim<M, Embedded<M, Q>>) -> [f64; C] + Sync,
    M: Pack<S = f64>,
    Q: Pair,
{
    const AT_ONCE: usize = TOGETHER;

    fn rows(&self, points: &[[f64; P]], done: &mut dyn FnMut(usize, Result<[f64; C], String>)) {
        together(points.iter().copied(), self.until, (&self.start, &self.row), |place, row| {
            done(place, row.map_err(|failure| failure.to_string()));
        });
    }
}
