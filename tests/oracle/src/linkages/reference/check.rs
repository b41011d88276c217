//! Is the reference right? Against states that were computed elsewhere in quadruple precision by two formulations
//! (S1, S2, S6 of the benchmark scenes), against the conservation of energy, and against a table of nearly flat four-bars.
#![allow(clippy::excessive_precision, reason = "references keep the digits that they were computed with")]

use super::dd::Dd;
use super::{Accuracy, Begin, Course, Stop, assemble, follow, spring_energy};
use crate::scene::{Joint, JointShape, Kind, Load, Port, Scene, Shape};

const EXACT: Accuracy = Accuracy { order: 30, tolerance: 1e-25 };

macro_rules! joints {
    ($($kind:ident $name:ident($a:ident.$pa:ident, $b:ident.$pb:ident)),*) => {
        &[$(JointShape {
            kind: Kind::$kind,
            name: stringify!($name),
            a: (stringify!($a), stringify!($pa)),
            b: (stringify!($b), stringify!($pb)),
        }),*]
    };
}

static PENDULUM: Shape = Shape {
    name: "double pendulum",
    ground: &["o"],
    bodies: &[("one", &["o", "p"]), ("two", &["p"])],
    joints: joints![Revolute o(ground.o, one.o), Revolute p(one.p, two.p)],
};
static FOUR_BAR: Shape = Shape {
    name: "four-bar",
    ground: &["a", "d"],
    bodies: &[("one", &["a", "b"]), ("two", &["b", "c"]), ("three", &["d", "c"])],
    joints: joints![
        Revolute a(ground.a, one.a), Revolute b(one.b, two.b), Revolute c(two.c, three.c), Revolute d(ground.d, three.d)
    ],
};
static SLIDER_CRANK: Shape = Shape {
    name: "slider-crank",
    ground: &["o"],
    bodies: &[("one", &["o", "p"]), ("two", &["p", "w"]), ("slider", &["w"])],
    joints: joints![
        Revolute o(ground.o, one.o), Revolute p(one.p, two.p), Revolute w(two.w, slider.w), Prismatic g(ground.o, slider.w)
    ],
};

/// A scene of bars: mass, moment of inertia, half the length; the last ports may be fewer.
fn bars(shape: &'static Shape, ground: &[[f64; 2]], bodies: &[[f64; 3]]) -> Scene {
    let mut scene = Scene::of(shape);
    for (port, place) in scene.ground.iter_mut().zip(ground) {
        *port = [place[0], place[1], 0.0];
    }
    for (body, [mass, inertia, half]) in scene.bodies.iter_mut().zip(bodies) {
        (body.mass, body.inertia) = (*mass, *inertia);
        let places: [Port; 2] = [[-half, 0.0, 0.0], [*half, 0.0, 0.0]];
        body.ports.iter_mut().zip(places).for_each(|(port, place)| *port = place);
    }
    scene.gravity = 9.81;
    scene
}

/// Says how far something is off; whether that is near enough.
fn told(what: &str, off: f64, allowed: f64) -> bool {
    let holds = off <= allowed;
    println!("{what}: off by {off:.1e}, allowed {allowed:.0e}{}", if holds { "" } else { "  WRONG" });
    holds
}

/// The largest difference between the end of a run and known places and velocities.
fn off(course: &Course, places: &[f64], velocities: &[f64]) -> f64 {
    let Some(end) = course.samples.last() else { return f64::INFINITY };
    let pairs = end.q.iter().zip(places).chain(end.v.iter().zip(velocities));
    pairs.fold(0.0, |worst: f64, (found, known)| worst.max((*found - Dd::from(*known)).abs().hi))
}

/// The largest change of energy, springs included, as a fraction of the kinetic energy.
fn lost(scene: &Scene, course: &Course) -> f64 {
    let total = |s: &super::Sample| s.energy[0] + s.energy[1] + spring_energy(scene, &s.q);
    let first = total(&course.samples[0]);
    let most = course.samples.iter().fold(0.0_f64, |most, s| most.max(s.energy[0].hi));
    course.samples.iter().fold(0.0_f64, |worst, s| worst.max((total(s) - first).abs().hi)) / most
}

fn run(scene: &Scene, begin: &Begin, until: f64) -> Result<Course, Stop> {
    let times: Vec<f64> = (1..=20).map(|k| until * f64::from(k) / 20.0).collect();
    follow(scene, assemble(scene, begin)?, &times, EXACT)
}

/// The double pendulum S1 at 1 s.
fn s1() -> Result<bool, Stop> {
    let mut scene = bars(&PENDULUM, &[[0.0, 0.0]], &[[10.0, 0.01, 0.5], [10.0, 0.01, 1.0]]);
    scene.load.push = 0.0;
    let angle = std::f64::consts::FRAC_PI_4;
    let half = 0.5 * angle.cos();
    let q = vec![half, half, angle, 2.0 * half + 1.0, 2.0 * half, 0.0];
    let course = run(&scene, &Begin { q, v: vec![0.0; 6], locked: vec![2, 5] }, 1.0)?;
    let places = [
        -1.999_943_345_909_355_78e-1,
        -4.582_600_420_411_198_24e-1,
        -1.982_300_809_959_603_42,
        -1.058_243_825_387_687_04,
        -1.669_314_976_020_579_61,
        -2.289_294_911_020_306_69,
    ];
    let velocities = [
        -3.790_005_506_244_012_62,
        1.654_038_231_090_720_93,
        -8.270_425_432_169_654_84,
        -6.354_540_096_468_085_16,
        2.236_506_293_614_911_52,
        1.627_894_834_494_063_15,
    ];
    Ok(told("S1, 1 s", off(&course, &places, &velocities), 2e-14)
        & told("  energy", lost(&scene, &course), 1e-20))
}

/// The four-bar S2 at 1 s and at 10 s.
fn s2() -> Result<bool, Stop> {
    let bodies = [
        [0.3, 0.3 * 0.3 * 0.3 / 12.0, 0.15],
        [0.9, 0.9 * 0.9 * 0.9 / 12.0, 0.45],
        [0.7, 0.7 * 0.7 * 0.7 / 12.0, 0.35],
    ];
    let scene = bars(&FOUR_BAR, &[[0.0, 0.0], [1.0, 0.0]], &bodies);
    let q = vec![0.075, 0.13, std::f64::consts::FRAC_PI_3, 0.543, 0.478, 0.507, 0.968, 0.348, 1.661];
    let begin = Begin { q, v: vec![0.0; 9], locked: vec![2] };
    let one = run(&scene, &begin, 1.0)?;
    let places = [
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
    let velocities = [
        1.402_278_713_920_952_74e-1,
        2.130_874_280_420_675_47e-2,
        -9.455_843_210_547_726_45e-1,
        2.704_141_891_094_618_97e-1,
        6.511_276_637_798_977_15e-2,
        5.474_386_857_169_650_77e-2,
        1.301_863_177_173_666_22e-1,
        4.380_402_357_378_301_68e-2,
        -3.924_519_448_243_382_41e-1,
    ];
    let holds =
        told("S2, 1 s", off(&one, &places, &velocities), 5e-15) & told("  energy", lost(&scene, &one), 1e-20);
    let ten = run(&scene, &begin, 10.0)?;
    let places = [
        -1.487_683_572_903_717_63e-2,
        1.492_604_427_123_651_60e-1,
        -4.613_046_756_763_087_39,
        3.805_687_092_044_761_86e-1,
        4.832_789_540_642_811_43e-1,
        4.230_829_143_697_245_26e-1,
        8.954_455_449_335_133_62e-1,
        3.340_185_113_519_159_83e-1,
        1.874_154_808_886_296_25,
    ];
    let velocities = [
        1.314_205_156_703_025_74e-2,
        1.309_872_453_493_988_96e-3,
        -8.804_778_632_712_397_86e-2,
        2.517_755_965_973_123_16e-2,
        5.077_226_499_194_911_84e-3,
        5.989_148_308_797_634_80e-3,
        1.203_550_809_270_097_42e-2,
        3.767_354_045_700_922_86e-3,
        -3.603_245_833_288_735_38e-2,
    ];
    Ok(holds
        & told("S2, 10 s", off(&ten, &places, &velocities), 5e-14)
        & told("  energy", lost(&scene, &ten), 1e-20))
}

/// The slider-crank S6 at 1 s, with 1 N m on its crank.
fn s6() -> Result<bool, Stop> {
    let bodies = [[0.2, 0.2 * 0.2 * 0.2 / 12.0, 0.1], [0.6, 0.6 * 0.6 * 0.6 / 12.0, 0.3], [0.5, 1e-3, 0.0]];
    let mut scene = bars(&SLIDER_CRANK, &[[0.0, 0.0]], &bodies);
    scene.load = Load { push: 1.0, begin: -2.0, rise: 1.0, turn: 1e9, fall: 1.0 };
    let q = vec![0.05, 0.0866, std::f64::consts::FRAC_PI_3, 0.387, 0.0866, -0.2928, 0.674, 0.0, 0.0];
    let course = run(&scene, &Begin { q, v: vec![0.0; 9], locked: vec![2] }, 1.0)?;
    let places = [
        5.074_900_614_529_553_90e-3,
        -9.987_114_389_928_978_66e-2,
        1.732_953_040_986_060_44e1,
        2.930_380_381_995_053_58e-1,
        -9.987_114_389_928_978_66e-2,
        3.393_813_710_091_833_68e-1,
        5.759_262_751_699_516_07e-1,
        0.0,
        0.0,
    ];
    let velocities = [
        2.723_424_913_682_796_22,
        1.383_894_309_051_986_93e-1,
        2.726_938_740_612_705_96e1,
        5.495_706_969_380_719_19,
        1.383_894_309_051_986_93e-1,
        -4.892_017_864_979_533_95e-1,
        5.544_564_111_395_845_93,
        0.0,
        0.0,
    ];
    Ok(told("S6, 1 s", off(&course, &places, &velocities), 2e-13))
}

/// Four-bars that come near to flat: cranks 0.5 m and 0.5 m + e, bars without mass but with moments of inertia.
fn nearly_flat() -> Result<bool, Stop> {
    // e, and the angles after 5 s to six places, by orthogonalised equations at a tolerance of 1e-9.
    let table = [
        (1e-11, [15.602_847, 0.0, 3.036_477]),
        (1e-10, [15.602_906, 0.0, 3.036_536]),
        (1e-9, [15.603_093, 0.0, 3.036_722]),
        (1e-8, [15.603_683, 0.0, 3.037_312]),
        (1e-6, [15.611_434, 0.000_005, 3.045_043]),
        (1e-4, [15.691_871, 0.002_292, 3.116_337]),
        (-1e-10, [3.036_508, 0.0, 15.602_879]),
        (-1e-6, [3.042_338, -0.000_005, 15.608_729]),
    ];
    let mut holds = true;
    for (e, known) in table {
        let bodies = [[1e-9, 0.1, 0.25], [1e-9, 0.2, 1.0], [1e-9, 0.15, 0.25]];
        let mut scene = bars(&FOUR_BAR, &[[0.0, 0.0], [2.0, 0.0]], &bodies);
        (scene.gravity, scene.bodies[2].ports[1][0]) = (0.0, 0.25 + e);
        let (s, c) = 1.0_f64.sin_cos();
        let q = vec![0.25 * c, 0.25 * s, 1.0, 0.5 * c + 1.0, 0.5 * s, 0.0, 2.0 + 0.25 * c, 0.25 * s, 1.0];
        let begin = Begin { q, v: vec![0.0, 0.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], locked: vec![2] };
        let course = run(&scene, &begin, 5.0)?;
        let end = &course.samples[20].q;
        let off =
            [2, 5, 8].iter().zip(known).fold(0.0_f64, |w, (i, known)| w.max((end[*i].hi - known).abs()));
        holds &= told(&format!("nearly flat, e = {e:e} m ({} steps)", course.steps), off, 3e-6);
        // Bars of 1e-9 kg beside moments of 0.1 kg m^2 take ten of the digits.
        holds &= told("  energy", lost(&scene, &course), 1e-12);
        // The same with bars that weigh something keeps them.
        scene.bodies.iter_mut().for_each(|body| body.mass = 1.0);
        holds &= told("  energy, 1 kg each", lost(&scene, &run(&scene, &begin, 5.0)?), 1e-18);
    }
    Ok(holds)
}

/// An exact parallelogram with springs passes its flat poses, by two accuracies.
fn parallelogram() -> Result<bool, Stop> {
    let bodies = [[1.0, 0.1, 0.25], [1.0, 0.1, 1.0], [1.0, 0.2, 0.25]];
    let mut scene = bars(&FOUR_BAR, &[[0.0, 0.0], [2.0, 0.0]], &bodies);
    scene.joints[0] = Joint { stiffness: 0.5, damping: 0.0, rest: 0.3 };
    let (s, c) = 1.0_f64.sin_cos();
    let q = vec![0.25 * c, 0.25 * s, 1.0, 0.5 * c + 1.0, 0.5 * s, 0.0, 2.0 + 0.25 * c, 0.25 * s, 1.0];
    let begin = Begin { q, v: vec![0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], locked: vec![2] };
    let course = run(&scene, &begin, 3.0)?;
    let turned = course.samples.iter().fold(0.0_f64, |worst, s| worst.max(s.q[5].abs().hi));
    Ok(told("parallelogram: the coupler turns", turned, 1e-20)
        & told("  energy", lost(&scene, &course), 1e-18))
}

/// Every check; whether all hold.
pub fn all() -> bool {
    [s1, s2, s6, nearly_flat, parallelogram].iter().fold(true, |holds, check| {
        let this = check().unwrap_or_else(|stop| {
            println!("{stop:?}  WRONG");
            false
        });
        holds & this
    })
}
