//! End states of the benchmark scenes against references of 16 digits and more.
//!
//! The references were computed in quadruple precision by two independent formulations that agree to 1e-14 or better.

use plm::runtime::Drift;
use plm::{BodyState, Dop853, Mechanism as _, Method};

use crate::scene::{Named as _, Scene};

use crate::scenes::{s1, s1_baumgarte, s2, s2_baumgarte, s5, s6, s6_baumgarte};

/// (x, y, theta) of G per body.
pub(crate) type Poses<const N: usize> = [[f64; 3]; N];

pub(crate) const S1_1: Poses<2> = [
    [-0.199_994_334_590_935_58, -0.458_260_042_041_119_82, -1.982_300_809_959_603_42],
    [-1.058_243_825_387_687_04, -1.669_314_976_020_579_61, -2.289_294_911_020_306_69],
];
pub(crate) const S2_1: Poses<3> = [
    [-0.022_535_000_136_674_7, 0.148_297_585_175_349_606, -4.561_584_698_981_446_17],
    [0.365_848_726_453_367_483, 0.480_023_085_416_246_889, 0.419_843_543_133_026_636],
    [0.888_383_726_590_042_183, 0.331_725_500_240_897_283, 1.895_368_829_230_258_38],
];
pub(crate) const S2_10: Poses<3> = [
    [-0.014_876_835_729_037_176_2, 0.149_260_442_712_365_164, -4.613_046_756_763_087_39],
    [0.380_568_709_204_476_186, 0.483_278_954_064_281_147, 0.423_082_914_369_726_524],
    [0.895_445_544_933_513_362, 0.334_018_511_351_915_983, 1.874_154_808_886_296_25],
];
pub(crate) const S5_003: Poses<7> = [
    [-9.151_423_246_975_861_98e-4, -9.441_676_518_022_482_52e-5, 15.810_771_195_153_707_1],
    [-1.844_602_721_758_067_67e-2, -1.343_681_483_975_811_77e-3, 5.440_013_674_186_762_74e-2],
    [-2.516_389_303_546_853_05e-2, 1.443_127_023_594_095_06e-2, 4.082_224_011_964_580_49e-2],
    [-3.477_497_166_038_277_06e-2, 1.196_840_220_297_247_41e-2, -1.032_015_046_212_552_44e-2],
    [-5.394_793_488_853_295_19e-2, 1.721_528_500_187_664_40e-2, 0.524_409_965_879_954_069],
    [-3.475_089_602_296_661_5e-2, -1.644_981_549_520_750_57e-2, 1.582_810_857_384_017_48],
    [-5.931_895_962_632_549_94e-2, 6.128_645_713_993_752_3e-3, 1.048_080_741_041_937_86],
];
pub(crate) const S6_1: Poses<3> = [
    [5.074_900_614_529_553_9e-3, -9.987_114_389_928_978_66e-2, 17.329_530_409_860_604_6],
    [0.293_038_038_199_505_36, -9.987_114_389_928_978_66e-2, 0.339_381_371_009_183_368],
    [0.575_926_275_169_951_607, 0.0, 0.0],
];

/// Largest difference of positions (m) and angles (rad).
pub(crate) fn difference<const N: usize>(found: &[BodyState<f64>], expected: &Poses<N>) -> f64 {
    assert_eq!(found.len(), N);
    let pairs = found.iter().zip(expected);
    let of_body = |(body, [x, y, angle]): (&BodyState<f64>, &[f64; 3])| {
        (body.x - x).abs().max((body.y - y).abs()).max((body.angle - angle).abs())
    };
    pairs.map(of_body).fold(0.0, f64::max)
}

fn tight() -> Dop853<Scene> {
    Dop853::new(1e-13)
}

/// Runs a scene to an end and gives the poses there and the largest drift of phi and phi_dot on the way.
pub(crate) fn run<I: Method<Scene>>(
    scene: Scene,
    method: I,
    until: f64,
) -> (Vec<BodyState<f64>>, Drift<f64>) {
    let mut sim = scene.start_with(method).unwrap();
    let mut drift = sim.drift();
    for _ in 0..100 {
        sim.step(until / 100.0).unwrap();
        let now = sim.drift();
        drift.phi = drift.phi.max(now.phi);
        drift.phi_dot = drift.phi_dot.max(now.phi_dot);
    }
    (sim.bodies(), drift)
}

#[test]
fn s1_meets_its_reference() {
    let (poses, drift) = run(s1::DoublePendulum::new(), tight(), 1.0);
    assert!(difference(&poses, &S1_1) < 1e-9, "{:e}", difference(&poses, &S1_1));
    assert!(drift.phi < 1e-13 && drift.phi_dot < 1e-13, "{drift:?}");
    let (poses, _) = run(s1_baumgarte::DoublePendulum::new(), tight(), 1.0);
    assert!(difference(&poses, &S1_1) < 1e-9, "{:e}", difference(&poses, &S1_1));
}

#[test]
fn s2_meets_its_references() {
    let (poses, drift) = run(s2::FourBar::new(), tight(), 1.0);
    assert!(difference(&poses, &S2_1) < 1e-9, "{:e}", difference(&poses, &S2_1));
    assert!(drift.phi < 1e-13 && drift.phi_dot < 1e-13, "{drift:?}");
    let (poses, drift) = run(s2::FourBar::new(), tight(), 10.0);
    assert!(difference(&poses, &S2_10) < 1e-9, "{:e}", difference(&poses, &S2_10));
    assert!(drift.phi < 1e-13 && drift.phi_dot < 1e-13, "{drift:?}");
    let (poses, _) = run(s2_baumgarte::FourBar::new(), tight(), 1.0);
    assert!(difference(&poses, &S2_1) < 1e-9, "{:e}", difference(&poses, &S2_1));
}

#[test]
fn s6_meets_its_reference() {
    let (poses, drift) = run(s6::SliderCrank::new(), tight(), 1.0);
    assert!(difference(&poses, &S6_1) < 1e-9, "{:e}", difference(&poses, &S6_1));
    // The scene moves at some 27 rad/s and 5.5 m/s: phi_dot is judged against that.
    assert!(drift.phi < 1e-13 && drift.phi_dot < 27.0 * 1e-13, "{drift:?}");
    let (poses, _) = run(s6_baumgarte::SliderCrank::new(), tight(), 1.0);
    assert!(difference(&poses, &S6_1) < 1e-9, "{:e}", difference(&poses, &S6_1));
}

#[test]
fn s5_meets_its_reference() {
    let (poses, _) = run(s5::Andrews::new(), tight(), 0.03);
    assert!(difference(&poses, &S5_003) < 1e-9, "{:e}", difference(&poses, &S5_003));
}
