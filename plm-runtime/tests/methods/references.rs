//! The double pendulum S1 and the four-bar S2 against quadruple-precision references
//! (benchmarks, references.json: "S1@1", "S2@1": two formulations that agree to 21 digits).

// The digits of the source.
#![allow(clippy::excessive_precision)]

use plm_runtime::{Dopri5, Mechanism, Rk4};

use crate::mechanisms::{double_pendulum, four_bar};

/// Positions and angles of S1 after 1 s.
const S1: [f64; 6] = [
    -1.999_943_345_909_355_78e-1,
    -4.582_600_420_411_198_24e-1,
    -1.982_300_809_959_603_42,
    -1.058_243_825_387_687_04,
    -1.669_314_976_020_579_61,
    -2.289_294_911_020_306_69,
];

/// Positions and angles of S2 after 1 s.
const S2: [f64; 9] = [
    -2.253_500_013_667_469_97e-2,
    1.482_975_851_753_496_06e-1,
    -4.561_584_698_981_446_17,
    3.658_487_264_533_674_83e-1,
    4.800_230_854_162_468_89e-1,
    4.198_435_431_330_266_36e-1,
    8.883_837_265_900_421_83e-1,
    3.317_255_002_408_972_83e-1,
    1.895_368_829_230_258_38,
];

fn worst(x: &[f64], reference: &[f64]) -> f64 {
    x.iter().zip(reference).fold(0.0, |worst, (a, b)| f64::max(worst, (a - b).abs()))
}

#[test]
fn s1_with_projection() {
    let mut sim = double_pendulum().start_with(Dopri5::new(1e-12)).unwrap();
    let mut drift: f64 = 0.0;
    let mechanism = sim.mechanism;
    sim.run(1.0, 1e-3, |moment| {
        let here = plm_runtime::Constraints::drift(&mechanism, moment.time, &moment.held, &moment.x);
        drift = drift.max(here.phi).max(here.phi_dot);
    })
    .unwrap();
    let error = worst(&sim.x, &S1);
    println!("S1, dopri5 1e-12: error {error:e}, drift {drift:e}, {:?}", sim.stats());
    assert!(error < 1e-9, "{error:e}");
    // 1e-13 of the size, 2 m.
    assert!(drift < 2e-13, "{drift:e}");
}

#[test]
fn s1_with_baumgarte() {
    let mut mechanism = double_pendulum();
    mechanism.0.alpha = Some(10.0);
    let mut sim = mechanism.start_with(Dopri5::new(1e-13)).unwrap();
    sim.step(1.0).unwrap();
    let error = worst(&sim.x, &S1);
    println!("S1, dopri5 1e-13, Baumgarte: error {error:e}, {:?}", sim.stats());
    assert!(error < 1e-9, "{error:e}");
    assert_eq!(sim.stats().projected, 0);
    assert_eq!(sim.notice(), None);
}

#[test]
fn s1_with_rk4() {
    let error = |h: f64| {
        let mut sim = double_pendulum().start_with(Rk4::new(h)).unwrap();
        sim.step(1.0).unwrap();
        println!("S1, rk4 {h}: error {:e}, drift {:?}, {:?}", worst(&sim.x, &S1), sim.drift(), sim.stats());
        worst(&sim.x, &S1)
    };
    let (coarse, fine) = (error(2e-3), error(1e-3));
    // Benchmarks, scenes.md: 1.4e-9 with projection at 1 ms.
    assert!(fine < 2e-9, "{fine:e}");
    assert!(((coarse / fine).log2() - 4.0).abs() < 0.5, "{coarse:e} {fine:e}");
}

#[test]
fn s2_with_projection() {
    let mut sim = four_bar().start_with(Dopri5::new(1e-12)).unwrap();
    sim.step(1.0).unwrap();
    let mut x = sim.x;
    // The references count the crank's turns from its start at 60 deg.
    assert!(x[..9].iter().all(|x| x.is_finite()));
    for i in [2, 5, 8] {
        let turns = ((x[i] - S2[i]) / core::f64::consts::TAU).round();
        x[i] -= turns * core::f64::consts::TAU;
        assert_eq!(turns, 0.0);
    }
    let error = worst(&x, &S2);
    println!("S2, dopri5 1e-12: error {error:e}, drift {:?}, {:?}", sim.drift(), sim.stats());
    assert!(error < 1e-9, "{error:e}");
}
