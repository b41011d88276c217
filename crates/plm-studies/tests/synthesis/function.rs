//! Function generation.

use plm_dynamic::Mechanism;
use plm_studies::synthesis::function::{Generator, NoGenerator, Pair, Scales, chebyshev, generators};

fn pairs(degrees: &[[f64; 2]]) -> Vec<Pair> {
    degrees.iter().map(|d| Pair { crank: d[0].to_radians(), rocker: d[1].to_radians() }).collect()
}

/// Angle of the rocker beyond the demanded one, with the loop closed by the law of cosines in the triangles on both sides of the diagonal
/// from pin to pivot: no formula of the crate.
fn error_by_diagonal(generator: &Generator, pair: &Pair) -> f64 {
    let [ground, crank, coupler, rocker] = generator.four_bar.lengths();
    let angle = pair.crank + generator.crank_zero;
    let diagonal = (ground * ground + crank * crank - 2.0 * ground * crank * angle.cos()).sqrt();
    let to_pin = (crank * angle.sin()).atan2(crank * angle.cos() - ground);
    let at_pivot =
        ((rocker * rocker + diagonal * diagonal - coupler * coupler) / (2.0 * rocker * diagonal)).acos();
    let off = |angle: f64| {
        let difference = angle - pair.rocker - generator.rocker_zero;
        difference.sin().atan2(difference.cos()).abs()
    };
    off(to_pin + at_pivot).min(off(to_pin - at_pivot))
}

fn assert_met(generator: &Generator, pairs: &[Pair]) {
    for pair in pairs {
        let error = error_by_diagonal(generator, pair);
        assert!(error < 1e-9, "{error:e} {pair:?} {generator:?}");
    }
    assert!(generator.errors.iter().all(|error| error.abs() < 1e-9), "{:?}", generator.errors);
}

#[test]
fn three_pairs_are_met() {
    let demanded = [
        [[40.0, 50.0], [90.0, 80.0], [160.0, 110.0]],
        [[30.0, 60.0], [75.0, 90.0], [120.0, 120.0]],
        [[20.0, 35.0], [35.0, 45.0], [50.0, 60.0]],
    ];
    for pairs in demanded.map(|degrees| pairs(&degrees)) {
        let found = generators(&pairs, 0.4, Scales::Given).unwrap();
        assert_met(&found[0], &pairs);
    }
}

#[test]
fn freudensteins_three_pairs_have_the_lengths_of_exact_arithmetic() {
    // The equations of Freudenstein (Trans. ASME 77, 1955) for three pairs, by Cramer's rule in 40 digits: lengths over that of the ground.
    let pairs = pairs(&[[45.0, 60.0], [90.0, 80.0], [135.0, 100.0]]);
    let [ground, crank, coupler, rocker] =
        generators(&pairs, 1.0, Scales::Given).unwrap()[0].four_bar.lengths();
    assert!((ground - 1.0).abs() < 1e-14);
    assert!((crank - 0.113_497_352_180_388).abs() < 1e-13, "{crank}");
    assert!((coupler - 1.050_144_155_532_31).abs() < 1e-13, "{coupler}");
    assert!((rocker - 0.244_310_503_613_715).abs() < 1e-13, "{rocker}");
}

#[test]
fn free_scales_meet_four_and_five_pairs() {
    // y = x^1.5 of 1 <= x <= 4: the crank turns by 90 degrees, the rocker by 60.
    let pair = |x: f64| Pair {
        crank: (x - 1.0) / 3.0 * 90_f64.to_radians(),
        rocker: (x.powf(1.5) - 1.0) / 7.0 * 60_f64.to_radians(),
    };
    for (count, scales) in [(4, Scales::FreeCrank), (5, Scales::FreeBoth)] {
        let pairs: Vec<Pair> = chebyshev(count, 1.0, 4.0).into_iter().map(pair).collect();
        let found = generators(&pairs, 1.0, scales).unwrap();
        for generator in &found {
            assert_met(generator, &pairs);
        }
    }
}

#[test]
fn a_known_linkage_is_among_those_of_its_own_pairs() {
    let known = plm_studies::synthesis::FourBar {
        pivots: [[0.0, 0.0], [1.0, 0.0]],
        crank: 0.35,
        coupler: 0.8,
        rocker: 0.7,
        point: [0.0, 0.0],
        image: plm_studies::synthesis::Image::Left,
    };
    let zeros = [0.3, 1.1];
    let pair = |k: usize| {
        let crank = 0.25 * k as f64;
        let rocker = known.pose(crank + zeros[0]).unwrap().angles[2] - zeros[1];
        Pair { crank, rocker }
    };
    let pairs: Vec<Pair> = (0..5).map(pair).collect();
    let found = generators(&pairs, 1.0, Scales::FreeBoth).unwrap();
    let is_known = |generator: &Generator| {
        let lengths = generator.four_bar.lengths();
        known.lengths().iter().zip(lengths).all(|(a, b)| (a - b).abs() < 1e-8)
    };
    assert!(found.iter().any(is_known), "{found:#?}");
    for generator in &found {
        assert_met(generator, &pairs);
    }
    // Least squares of many exact pairs are exact.
    let pair = |k: usize| {
        let crank = 0.1 * k as f64 + zeros[0];
        Pair { crank, rocker: known.pose(crank).unwrap().angles[2] }
    };
    let many: Vec<Pair> = (0..30).map(pair).collect();
    let fitted = generators(&many, 1.0, Scales::Given).unwrap();
    assert!(is_known(&fitted[0]), "{fitted:#?}");
}

#[test]
fn a_generator_runs_as_a_declaration() {
    let pairs = pairs(&[[40.0, 60.0], [70.0, 75.0], [100.0, 100.0]]);
    let found = &generators(&pairs, 1.0, Scales::Given).unwrap()[0];
    assert!(found.defects.is_empty(), "{found:?}");
    let begin = pairs[0].crank + found.crank_zero;
    let text = found.four_bar.declaration("Generator", begin).unwrap();
    let mut run = Mechanism::from_text(&text).unwrap().start().unwrap();
    for (pair, error) in pairs.iter().zip(&found.errors) {
        run.step_to(pair.crank - pairs[0].crank).unwrap();
        let off = run.output("rocker.angle").unwrap() - pair.rocker - found.rocker_zero;
        assert!(off.sin().abs() < 1e-9 && error.abs() < 1e-9, "{off}");
    }
}

/// A gap in a table is told with its place; a decomposition of what is no number has no end.
#[test]
fn what_is_no_number_is_told() {
    for wrong in [f64::NAN, f64::INFINITY] {
        for scales in [Scales::Given, Scales::FreeCrank, Scales::FreeBoth] {
            let count = [(Scales::Given, 3), (Scales::FreeCrank, 4), (Scales::FreeBoth, 5)];
            let count = count.into_iter().find(|(own, _)| *own == scales).unwrap().1;
            let mut own: Vec<Pair> =
                (0..count).map(|k| Pair { crank: 0.3 * f64::from(k), rocker: 0.2 * f64::from(k) }).collect();
            own[1].rocker = wrong;
            assert_eq!(generators(&own, 1.0, scales), Err(NoGenerator::NoNumber { pair: 1 }));
        }
        let own = pairs(&[[40.0, 50.0], [90.0, 80.0], [160.0, 110.0]]);
        assert_eq!(generators(&own, wrong, Scales::Given), Err(NoGenerator::Ground));
    }
}

/// A rocker that turns by twice the angle of the crank makes Freudenstein's equation hold with a ratio of 0 alone: of a link without an
/// end. One that turns by twice the angle the other way is met in three positions.
#[test]
fn links_without_an_end_are_none() {
    for cranks in [&[10.0, 20.0, 30.0][..], &[10.0, 20.0, 30.0, 45.0, 70.0]] {
        let twice: Vec<[f64; 2]> = cranks.iter().map(|crank| [*crank, 2.0 * crank]).collect();
        let found = generators(&pairs(&twice), 1.0, Scales::Given);
        assert_eq!(found, Err(NoGenerator::NoLengths), "{found:?}");
    }
    let back = pairs(&[10.0, 20.0, 30.0].map(|crank| [crank, -2.0 * crank]));
    let found = generators(&back, 1.0, Scales::Given).unwrap();
    assert!(found[0].errors.iter().all(|error| error.abs() < 1e-12), "{found:?}");
}
