//! Motion generation.

use nalgebra::{Matrix4, Vector4};
use plm_dynamic::Mechanism;
use plm_studies::synthesis::motion::{
    BodyPose, NoDyads, burmester_curves, centre_point, circle_point, five_pose_dyads, guides,
};
use plm_studies::synthesis::{Demands, FourBar, Image};

fn coupler_poses(four_bar: &FourBar, angles: &[f64]) -> Vec<BodyPose> {
    let pose = |&angle: &f64| {
        let pose = four_bar.pose(angle).unwrap();
        BodyPose { place: pose.point, angle: pose.angles[1] + 0.4 }
    };
    angles.iter().map(pose).collect()
}

const KNOWN: FourBar = FourBar {
    pivots: [[0.1, -0.2], [1.3, 0.1]],
    crank: 0.5,
    coupler: 1.1,
    rocker: 0.9,
    point: [0.6, 0.4],
    image: Image::Left,
};

#[test]
fn the_dyads_of_a_linkage_are_found_from_five_of_its_poses() {
    let poses = coupler_poses(&KNOWN, &[0.2, 0.9, 1.7, 2.6, 3.4]);
    let dyads = five_pose_dyads(&poses).unwrap();
    for (pivot, length) in [(KNOWN.pivots[0], KNOWN.crank), (KNOWN.pivots[1], KNOWN.rocker)] {
        let is_there = dyads.iter().any(|dyad| {
            (dyad.centre[0] - pivot[0]).hypot(dyad.centre[1] - pivot[1]) < 1e-9
                && (dyad.length - length).abs() < 1e-9
        });
        assert!(is_there, "{pivot:?} {dyads:#?}");
    }
    for dyad in &dyads {
        assert!(dyad.deviations(&poses).iter().all(|off| off.abs() < 1e-10));
    }
    let guides = guides(&poses, &dyads, &Demands { order: true, turns: true, ..Demands::default() });
    let clean: Vec<_> = guides.iter().filter(|guide| guide.defects.is_empty()).collect();
    assert!(!clean.is_empty(), "{guides:#?}");
    for guide in clean {
        let first = guide.positions[0].0;
        let text = guide.four_bar.declaration("Guide", first).unwrap();
        let mut run = Mechanism::from_text(&text).unwrap().start().unwrap();
        let mut time = 0.0;
        for (pose, (angle, _)) in poses.iter().zip(&guide.positions) {
            time += (angle - first - time).rem_euclid(std::f64::consts::TAU);
            run.step_to(time).unwrap();
            let [x, y] =
                ["x", "y"].map(|axis| run.output(&format!("coupler.tracer.position.{axis}")).unwrap());
            assert!((x - pose.place[0]).hypot(y - pose.place[1]) < 1e-9);
            let turned = run.output("coupler.angle").unwrap() + guide.body_angle - pose.angle;
            assert!((0.5 * turned).sin().abs() < 1e-9);
        }
    }
}

#[test]
fn three_and_four_poses_leave_families() {
    let poses = coupler_poses(&KNOWN, &[0.2, 0.9, 1.7, 2.6]);
    let three = &poses[..3];
    let dyad = centre_point(three, [0.3, 0.2]).unwrap().unwrap();
    assert!(dyad.deviations(three).iter().all(|off| off.abs() < 1e-12));
    let back = circle_point(three, dyad.centre).unwrap().unwrap();
    assert!((back.circle[0] - 0.3).hypot(back.circle[1] - 0.2) < 1e-10);
    let curve = burmester_curves(&poses, poses[0].place, 90).unwrap();
    assert!(curve.len() > 90);
    for point in &curve {
        let size = point.dyad.length.max(1.0);
        assert!(point.dyad.deviations(&poses).iter().all(|off| off.abs() < 1e-8 * size), "{point:?}");
    }
}

/// Real solutions of five poses from many starts: Newton's iteration on the distances themselves, with numeric derivatives. Nothing of
/// the crate is used.
fn by_many_starts(poses: &[BodyPose]) -> Vec<[f64; 4]> {
    let place = |pose: &BodyPose, [x, y]: [f64; 2]| {
        let (sin, cos) = (pose.angle - poses[0].angle).sin_cos();
        let [dx, dy] = [x - poses[0].place[0], y - poses[0].place[1]];
        [pose.place[0] + dx * cos - dy * sin, pose.place[1] + dx * sin + dy * cos]
    };
    let residuals = |z: &Vector4<f64>| {
        let square = |pose: &BodyPose| {
            let [x, y] = place(pose, [z[2], z[3]]);
            (x - z[0]).powi(2) + (y - z[1]).powi(2)
        };
        let first = square(&poses[0]);
        Vector4::from_fn(|row, _| square(&poses[row + 1]) - first)
    };
    let mut found: Vec<[f64; 4]> = Vec::new();
    let mut seed = 1_u64;
    let mut chance = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 11) as f64 / (1_u64 << 53) as f64 * 8.0 - 4.0
    };
    for _ in 0..200 {
        let mut z = Vector4::from_fn(|_, _| chance());
        for _ in 0..60 {
            let h = 1e-6;
            let column = |k: usize| {
                let mut step = Vector4::zeros();
                step[k] = h;
                (residuals(&(z + step)) - residuals(&(z - step))) / (2.0 * h)
            };
            let jacobian = Matrix4::from_columns(&[0, 1, 2, 3].map(column));
            let Some(step) = jacobian.lu().solve(&residuals(&z)) else { break };
            z -= step;
        }
        let converged = residuals(&z).norm() < 1e-9 * (1.0 + z.norm_squared()) && z.norm() < 1e4;
        let is_known = |other: &[f64; 4]| (Vector4::from(*other) - z).norm() < 1e-5 * (1.0 + z.norm());
        if converged && !found.iter().any(is_known) {
            found.push(z.into());
        }
    }
    found
}

#[test]
fn all_real_dyads_of_five_poses_are_found() {
    let mut chance = 0.37_f64;
    let mut next = |from: f64, to: f64| {
        chance = (chance * 911.0 + 0.123).fract();
        from + (to - from) * chance
    };
    let mut counts = [0; 5];
    for _ in 0..30 {
        let poses: Vec<BodyPose> = (0..5)
            .map(|_| BodyPose { place: [next(-1.0, 1.0), next(-1.0, 1.0)], angle: next(-2.0, 2.0) })
            .collect();
        let dyads = five_pose_dyads(&poses).unwrap();
        for dyad in &dyads {
            let size = 1.0 + dyad.length;
            assert!(dyad.deviations(&poses).iter().all(|off| off.abs() < 1e-9 * size), "{dyad:?}");
        }
        for [gx, gy, wx, wy] in by_many_starts(&poses) {
            let is_there = dyads.iter().any(|dyad| {
                let off = (dyad.centre[0] - gx).hypot(dyad.centre[1] - gy)
                    + (dyad.circle[0] - wx).hypot(dyad.circle[1] - wy);
                off < 1e-4 * (1.0 + gx.abs() + gy.abs() + wx.abs() + wy.abs())
            });
            assert!(is_there, "{gx} {gy} {wx} {wy} {dyads:?} {poses:?}");
        }
        counts[dyads.len()] += 1;
    }
    // Real roots of a quartic: none, two or four.
    assert!(
        counts[1] == 0 && counts[3] == 0 && counts[0] > 0 && counts[2] > 0 && counts[4] > 0,
        "{counts:?}"
    );
}

#[test]
fn poses_that_leave_families_are_refused() {
    let pose = |x: f64, angle: f64| BodyPose { place: [x, 0.3 * x * x], angle };
    let twice = [pose(0.0, 0.0), pose(1.0, 0.4), pose(1.0, 0.4), pose(2.0, 0.9), pose(3.0, 1.0)];
    assert_eq!(five_pose_dyads(&twice), Err(NoDyads::Dependent));
    assert_eq!(five_pose_dyads(&twice[..4]), Err(NoDyads::Count { needed: 5, given: 4 }));
}
