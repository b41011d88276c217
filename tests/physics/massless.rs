//! Bodies without mass: their motion is that of bodies with any mass, to the bit.

use plm::{Described as _, Dop853, Mechanism as _, Stabilise as _};

use crate::declared::driven;
use crate::scene::{Given as _, Named as _};

driven!(without);
driven!(heavy mass: 7 kg; inertia: 0.3 kg*m^2;);
driven!(light mass: 0.05 kg; inertia: 1e-3 kg*m^2;);

/// Runs three mechanisms that are declared alike, and compares: outputs that read no acceleration to the bit, those after them to
/// rounding.
macro_rules! compare {
    ($name:ident, $exact:expr, $accelerations:expr) => {
        let mut runs = (
            without::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
            heavy::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
            light::$name::new().start_with(Dop853::new(1e-9)).unwrap(),
        );
        for step in 0..40 {
            let found = runs.0.outputs();
            for other in [runs.1.outputs(), runs.2.outputs()] {
                for k in 0..$exact {
                    assert_eq!(found[k].to_bits(), other[k].to_bits(), "output {k} at step {step}");
                }
                for k in $exact..$exact + $accelerations {
                    let scale = 1.0 + found[k].abs();
                    assert!((found[k] - other[k]).abs() < 1e-11 * scale, "output {k} at step {step}");
                }
            }
            runs.0.step(0.05).unwrap();
            runs.1.step(0.05).unwrap();
            runs.2.step(0.05).unwrap();
        }
    };
}

#[test]
fn a_driven_linkage_needs_no_masses() {
    compare!(FourBar, 6, 3);
    compare!(Plate, 6, 3);
}

#[test]
fn a_driven_crank_needs_no_mass_where_a_pendulum_hangs() {
    compare!(Hanging, 8, 3);
}

#[test]
fn equilibria_and_linearisations_need_no_masses_of_driven_bodies() {
    let free = (without::Hanging::new().released("bob.angle"), heavy::Hanging::new().released("bob.angle"));
    let hangs =
        (free.0.stabilise().unwrap().balanced().unwrap(), free.1.stabilise().unwrap().balanced().unwrap());
    assert!(hangs.0.residuals.is_empty(), "{}", hangs.0);
    let hangs = (hangs.0.start().unwrap(), hangs.1.start().unwrap());
    assert!(
        hangs.0.state_of("bob").angle.abs() < 1e-9 && (hangs.0.state_of("bob").y + 0.2).abs() < 1e-12,
        "{:?}",
        hangs.0.state_of("bob")
    );
    let found = (plm::linearise(&hangs.0).unwrap(), plm::linearise(&hangs.1).unwrap());
    assert_eq!(found.0.a.shape(), (2, 2));
    assert!((&found.0.a - &found.1.a).amax() < 1e-9, "{}{}", found.0.a, found.1.a);
    assert!((&found.0.c - &found.1.c).amax() < 1e-9, "{}{}", found.0.c, found.1.c);
}

#[test]
fn a_body_without_mass_says_so() {
    let (without, heavy) = (without::FourBar::new(), heavy::FourBar::new());
    let known = |k| (without.mass(k), without.inertia(k), heavy.mass(k), heavy.inertia(k));
    assert_eq!(known(1), (None, None, Some(7.0), Some(0.3)));
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("massless.npz");
    plm::view::Recorder::new(&without.start().unwrap()).recording().write(&path).unwrap();
    let run = &plm::view::Results::read(&path).unwrap().runs[0];
    let crank = &run.about.mechanism.bodies[0];
    assert!(crank.mass.is_nan() && crank.inertia.is_nan() && crank.ports[0].x == -0.05);
    assert_eq!(without.tables().parameters.len(), 1);
}
