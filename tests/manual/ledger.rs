//! The balance can fail: a ledger that forgets something does not close.

use plm::Dop853;

use crate::demos::balance::{self, Balance, Ledger, RTOL};
use crate::demos::connect_plm_hyd::{ConnectPlmHyd, at_rest};
use crate::demos::plmpiv00::Plmpiv00;
use crate::demos::plmtrpi00::Plmtrpi00;

#[test]
fn a_forgotten_damper_is_noticed() {
    let mut sim = Plmpiv00::new().start_with(Dop853::new(RTOL)).unwrap();
    let found = balance::run(&mut sim, (1000, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        loads: s.load_power(),
        ..Ledger::default()
    })
    .unwrap();
    assert!(found.energy.abs() > 1e6 * Balance::ENERGY && found.power > 1e6 * Balance::POWER, "{found:?}");
}

#[test]
fn a_forgotten_drive_is_noticed() {
    let mut sim = Plmtrpi00::new().start_with(Dop853::new(RTOL)).unwrap();
    let found = balance::run(&mut sim, (500, 1e-3), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })
    .unwrap();
    assert!(found.energy.abs() > 1e6 * Balance::ENERGY && found.power > 1e6 * Balance::POWER, "{found:?}");
}

#[test]
fn forgotten_compression_of_the_oil_is_noticed() {
    let mut sim = at_rest(&ConnectPlmHyd::new()).unwrap().start_with(Dop853::new(RTOL)).unwrap();
    let found = balance::run(&mut sim, (3000, 5e-4), |s| Ledger {
        kinetic: s.kinetic_energy(),
        gravity: s.gravity_energy(),
        supplied: s.supplied(),
        lost: s.lost(),
        loads: s.load_power(),
        ..Ledger::default()
    })
    .unwrap();
    assert!(found.energy.abs() > 1e6 * Balance::ENERGY && found.power > 1e6 * Balance::POWER, "{found:?}");
}
