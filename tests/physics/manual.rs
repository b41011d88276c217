//! Figures that the manual prints, section 2.2.
//!
//! The exact values after the printed ones come from an independent model.

use plm::Mechanism as _;

use crate::scene::{Given as _, Named as _};
use crate::scenes::s1;

scene! {
    /// The double pendulum of the manual with its dampers.
    pub DoublePendulum {
        gravity: 9.81 m/s^2;
        ground { port o0: (0, 0) m; }
        body arm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port o0: (-0.5, 0) m;
            port p12: (0.5, 0) m;
            start angle: 45 deg, locked;
        }
        body forearm {
            mass: 10 kg;
            inertia: 0.01 kg*m^2;
            port p12: (-1, 0) m;
            start angle: 0 deg, locked;
        }
        revolute shoulder(ground.o0, arm.o0) { damping: 1 N*m/(rev/min); }
        revolute elbow(arm.p12, forearm.p12) { damping: 1 N*m/(rev/min); }
        output shoulder.force, elbow.force;
    }
}

#[test]
fn locked_start_has_the_centres_of_table_2() {
    let found = s1::DoublePendulum::new().assemble().unwrap();
    let printed = [0.353_553_39, 0.353_553_39, 45.0_f64.to_radians(), 1.707_106_78, 0.707_106_78, 0.0];
    for (value, printed) in found.q.iter().zip(printed) {
        assert!((value - printed).abs() < 1e-8, "{value} {printed}");
    }
}

#[test]
fn pivot_forces_after_40_s_are_those_of_the_independent_model() {
    let mut sim = DoublePendulum::new().start_with(plm::Dop853::new(1e-9)).unwrap();
    sim.step(40.0).unwrap();
    let (shoulder, elbow) = (sim.vector_of("shoulder.force")[1].abs(), sim.vector_of("elbow.force")[1].abs());
    assert!((shoulder - 196.390_818_322_501_13).abs() < 1e-4, "{shoulder}");
    assert!((elbow - 98.262_865_078_837_82).abs() < 1e-4, "{elbow}");
}
