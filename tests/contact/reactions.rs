//! Reactions of joints that bound frictions, in coordinates of joints against absolute coordinates, and the rate of rows that slip against
//! that of a system of equations.

use plm::runtime::Rate as _;
use plm::runtime::contact::{self, Contacts};
use plm::{Dop853, Fault, Mechanism as _, Moment as _};

use crate::declared::{CollarInAbsolute, LinkageInCharts};
use crate::near;
use crate::scene::{Named as _, Scene, State};

linkage!(LinkageInAbsolute, absolute);
collar!(CollarInTree, tree);

/// The rate at a state by sweeps is that of the system of equations of all rows.
#[track_caller]
fn sweeps_solve_the_system(system: &Scene, state: &State) {
    let (t, u, x) = (state.time(), &state.held(), state.x());
    let (mut found, mut known) = (*x, *x);
    let _ = system.rate(t, u, x, &mut found);
    let _ = contact::rate(system, t, u, x, &mut known);
    let size = known.iter().fold(0.0, |size: f64, number| size.max(number.abs()));
    for (found, known) in found.iter().zip(known) {
        near(*found, known, 1e-13 * size);
    }
}

/// Outputs every 10 ms.
fn course(mechanism: Scene) -> Result<Vec<[f64; 5]>, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(1e-12))?;
    let (mut rows, mut swept) = (Vec::new(), 0);
    for k in 0..=40 {
        sim.step_to(0.01 * f64::from(k))?;
        let state = sim.state();
        sweeps_solve_the_system(&mechanism, state);
        let sizes = mechanism.sliding(state.time(), &state.held(), state.x());
        swept += u32::from(sizes.is_some());
        rows.push([
            sim.value_of("drags"),
            sim.value_of("torques"),
            sim.value_of("first"),
            sim.value_of("second"),
            sim.value_of("third"),
        ]);
    }
    assert!(sim.stats().switches > 0, "{:?}", sim.stats());
    assert!(swept > 20, "{swept}");
    Ok(rows)
}

#[track_caller]
fn agree(one: &[[f64; 5]], other: &[[f64; 5]]) {
    for (one, other) in one.iter().flatten().zip(other.iter().flatten()) {
        near(*one, *other, 1e-9 * (1.0 + other.abs()));
    }
}

#[test]
fn loops_pass_on_the_reactions_of_absolute_coordinates() {
    agree(&course(LinkageInCharts::new()).unwrap(), &course(LinkageInAbsolute::new()).unwrap());
}

#[test]
fn a_tree_passes_on_the_reactions_of_absolute_coordinates() {
    agree(&course(CollarInTree::new()).unwrap(), &course(CollarInAbsolute::new()).unwrap());
}
