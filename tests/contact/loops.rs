//! Contact on loops: joint coordinates against absolute coordinates, which know no charts.

use plm::{Dop853, Fault, Mechanism as _};

use crate::declared::FourBarInCharts;
use crate::near;
use crate::scene::{Named as _, Scene};

four_bar!(InAbsolute, absolute);

/// Crank, rocker, a reaction of a joint, push and drag, every 0.05 s; the last two, and all reactions, where they are determined.
fn course(mechanism: Scene) -> Result<Vec<[f64; 5]>, Fault> {
    let mut sim = mechanism.start_with(Dop853::new(1e-11))?;
    let mut rows = Vec::new();
    for k in 1..=80 {
        sim.step_to(0.05 * f64::from(k))?;
        let loads = [sim.value_of("joint"), sim.value_of("push"), sim.value_of("drag")];
        let [joint, push, drag] = loads.map(|load| if sim.is_undetermined() { 0.0 } else { load });
        rows.push([sim.state_of("crank").angle, sim.state_of("rocker").omega, joint, push, drag]);
    }
    assert!(sim.is_undetermined(), "buffer and bearing hold one freedom");
    assert!(sim.contact_stats().impacts > 9, "{:?}", sim.contact_stats());
    Ok(rows)
}

#[test]
fn a_linkage_strikes_and_rubs_the_same_in_all_coordinates() {
    let [charts, absolute] = [FourBarInCharts::new(), InAbsolute::new()].map(|bars| course(bars).unwrap());
    for (one, other) in charts.iter().flatten().zip(absolute.iter().flatten()) {
        near(*one, *other, 1e-8 * (1.0 + other.abs()));
    }
}
