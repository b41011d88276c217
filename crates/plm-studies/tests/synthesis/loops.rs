//! Images of coupled loops, against closed forms and against a search from many starts.

use nalgebra::{DMatrix, DVector};
use plm_studies::synthesis::kinematics::{Loop, NoLoopImages, loop_images};
use plm_studies::synthesis::{FourBar, Image};

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [x * cos - y * sin, x * sin + y * cos]
}

/// Gaps of the loops at angles, and their derivatives.
fn gaps(loops: &[Loop], angles: &DVector<f64>) -> (DVector<f64>, DMatrix<f64>) {
    let n = angles.len();
    let (mut gap, mut by) = (DVector::zeros(n), DMatrix::zeros(n, n));
    for (k, l) in loops.iter().enumerate() {
        (gap[2 * k], gap[2 * k + 1]) = (l.known[0], l.known[1]);
        for &(body, way) in &l.vectors {
            let [x, y] = turned(way, angles[body]);
            gap[2 * k] += x;
            gap[2 * k + 1] += y;
            by[(2 * k, body)] -= y;
            by[(2 * k + 1, body)] += x;
        }
    }
    (gap, by)
}

/// Images by Newton's iteration from many starts: nothing of the crate.
fn by_many_starts(loops: &[Loop], starts: usize) -> Vec<DVector<f64>> {
    let mut seed = 5_u64;
    let mut chance = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 * std::f64::consts::TAU
    };
    let mut found: Vec<DVector<f64>> = Vec::new();
    for _ in 0..starts {
        let mut angles = DVector::from_fn(2 * loops.len(), |_, _| chance());
        for _ in 0..60 {
            let (gap, by) = gaps(loops, &angles);
            let Some(step) = by.lu().solve(&gap) else { break };
            let size = step.amax();
            angles -= step * (1.0_f64).min(1.0 / size);
        }
        let is_closed = gaps(loops, &angles).0.amax() < 1e-12;
        let is_other = |other: &DVector<f64>| (other - &angles).map(|d| (0.5 * d).sin()).amax() > 1e-6;
        if is_closed && found.iter().all(is_other) {
            found.push(angles);
        }
    }
    found
}

/// A plate on three bars: pivots, pins in the frame of the plate, lengths.
fn triad(pivots: [[f64; 2]; 3], pins: [[f64; 2]; 3], lengths: [f64; 3]) -> Vec<Loop> {
    let closed = |k: usize| Loop {
        vectors: vec![
            (1, [lengths[0], 0.0]),
            (0, [pins[k][0] - pins[0][0], pins[k][1] - pins[0][1]]),
            (k + 1, [-lengths[k], 0.0]),
        ],
        known: [pivots[0][0] - pivots[k][0], pivots[0][1] - pivots[k][1]],
    };
    vec![closed(1), closed(2)]
}

fn assert_all(loops: &[Loop], starts: usize) -> usize {
    let found = loop_images(loops).unwrap();
    assert!(found.is_complete, "{found:?}");
    assert_eq!(found.images.len() + found.complex + found.singular, found.paths);
    assert_eq!(found.complex % 2, 0);
    let expected = by_many_starts(loops, starts);
    assert_eq!(found.images.len(), expected.len(), "{found:?}");
    for image in &found.images {
        let image = DVector::from_column_slice(image);
        assert!(gaps(loops, &image).0.amax() < 1e-12);
        let is_same = |other: &DVector<f64>| (other - &image).map(|d| (0.5 * d).sin()).amax() < 1e-6;
        assert!(expected.iter().any(is_same));
    }
    found.images.len()
}

#[test]
fn a_single_loop_has_the_images_of_the_law_of_cosines() {
    let four_bar = FourBar {
        pivots: [[0.0, 0.0], [1.0, 0.1]],
        crank: 0.4,
        coupler: 0.9,
        rocker: 0.7,
        point: [0.0; 2],
        image: Image::Left,
    };
    for crank in [0.3, 1.9, 4.0] {
        let [x, y] = turned([four_bar.crank, 0.0], crank);
        let coupled = Loop { vectors: vec![(0, [0.9, 0.0]), (1, [-0.7, 0.0])], known: [x - 1.0, y - 0.1] };
        let found = loop_images(&[coupled]).unwrap();
        let poses = four_bar.images(crank);
        assert_eq!((found.images.len(), found.paths), (poses.len(), 2));
        for pose in poses {
            let is_same = |image: &Vec<f64>| {
                image.iter().zip(&pose.angles[1..]).all(|(a, b)| (0.5 * (a - b)).sin().abs() < 1e-12)
            };
            assert!(found.images.iter().any(is_same));
        }
    }
    // Too far apart: two complex solutions.
    let apart = Loop { vectors: vec![(0, [0.9, 0.0]), (1, [-0.7, 0.0])], known: [2.0, 0.0] };
    let found = loop_images(&[apart]).unwrap();
    assert_eq!((found.images.len(), found.complex, found.is_complete), (0, 2, true));
}

#[test]
fn a_plate_on_three_bars_has_up_to_six_images() {
    let pivots = [[0.0, 0.0], [2.7, 0.0], [0.6, 2.3]];
    let pins = [[0.0, 0.0], [3.0, 0.0], [0.2, 1.5]];
    let count = |lengths| assert_all(&triad(pivots, pins, lengths), 300);
    let counts = [[3.0, 2.8, 2.5], [1.0, 1.2, 1.1], [0.3, 0.3, 3.5]].map(count);
    assert_eq!((counts[0], counts[2]), (6, 0), "{counts:?}");
}

#[test]
fn three_coupled_loops_have_up_to_twenty_images() {
    // Two plates, one on the other: plate 0 on the ground by bars 2 and 3, plate 1 on the ground by bars 4 and 5 and on plate 0 by a pin.
    let loops = vec![
        Loop { vectors: vec![(2, [1.2, 0.0]), (0, [1.1, 0.0]), (3, [-1.3, 0.0])], known: [-1.5, 0.1] },
        Loop {
            vectors: vec![(2, [1.2, 0.0]), (0, [0.6, 0.9]), (1, [0.8, -0.2]), (4, [-1.4, 0.0])],
            known: [-2.6, -0.2],
        },
        Loop {
            vectors: vec![(2, [1.2, 0.0]), (0, [0.6, 0.9]), (1, [1.0, 0.7]), (5, [-1.6, 0.0])],
            known: [-1.9, -1.8],
        },
    ];
    assert_eq!(loop_images(&loops).unwrap().paths, 20);
    assert_eq!(assert_all(&loops, 800), 4);
}

#[test]
fn loops_that_are_no_group_have_a_name() {
    let single = Loop { vectors: vec![(0, [1.0, 0.0])], known: [1.0, 0.0] };
    assert_eq!(loop_images(&[single]), Err(NoLoopImages::Bodies { loops: 1, bodies: 1 }));
    let twice = Loop { vectors: vec![(0, [1.0, 0.0]), (3, [1.0, 0.0])], known: [1.0, 0.0] };
    assert_eq!(loop_images(&[twice.clone(), twice]), Err(NoLoopImages::Dependent));
}
