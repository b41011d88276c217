//! Events of conditions whose guards are violated at a state.

use super::guards;
use super::heeded::refresh;
use crate::fault::Fault;
use crate::scalar::{Real, Scalar};
use crate::system::System;
use crate::vector::Vector;

/// Switches every condition whose guard is past its band at the state `x`; how many did.
///
/// A condition may switch another one: it is repeated until none is past, but not for ever.
///
/// # Errors
/// Those of [`System::switch`].
pub fn switch_where_due<M: System<S: Real>>(
    system: &M,
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
) -> Result<u32, Fault> {
    let mut switched = 0;
    switch_each((system, M::G::fill(M::S::ZERO)), t, u, x, |_| switched += 1)?;
    Ok(switched)
}

/// The same, where guards are violated below their `edges`; gives `each` that switches. A guard that its own event leaves violated, as
/// that of a ball which has bounced, triggers it again only below where it was left.
pub(crate) fn switch_each<M: System<S: Real>>(
    (system, mut edges): (&M, M::G),
    t: M::S,
    u: &mut M::U,
    x: &mut M::X,
    mut each: impl FnMut(usize),
) -> Result<(), Fault> {
    refresh(system, t, u, x);
    for _ in 0..=M::G::LEN {
        let mut any = false;
        for i in 0..M::G::LEN {
            if is_below(system, &guards(system, t, u, x), &edges, i) {
                system.switch(t, u, x, i)?;
                edges.set(i, guards(system, t, u, x).at(i).min(M::S::ZERO));
                each(i);
                any = true;
            }
        }
        if !any {
            break;
        }
    }
    Ok(())
}

/// The guard `index` is beyond its band.
pub(super) fn is_past<M: System<S: Real>>(system: &M, g: &M::G, index: usize) -> bool {
    g.at(index) < -system.band(index)
}

/// The guard `index` is beyond its band below its edge.
pub(super) fn is_below<M: System<S: Real>>(system: &M, g: &M::G, edges: &M::G, index: usize) -> bool {
    g.at(index) < edges.at(index) - system.band(index)
}
