//! Six-bars: chains, their declarations, synthesis.

use std::f64::consts::{PI, TAU};

use plm_dynamic::Mechanism;
use plm_studies::synthesis::function::{Pair, Scales};
use plm_studies::synthesis::path::{Crank, Search, Timing};
use plm_studies::synthesis::six_bar::{Bounds, Chain, Found, NoSixBar, Problem, SixBar, SixBarPose, Task};
use plm_studies::synthesis::{Defect, Demands, FourBar, Image};

const CHAINS: [Chain; 4] = [Chain::WattOne, Chain::WattTwo, Chain::StephensonOne, Chain::StephensonThree];

/// A six-bar of Stephenson's second chain.
fn moving() -> SixBar {
    SixBar {
        four_bar: FourBar {
            pivots: [[0.1, -0.2], [0.9, 0.3]],
            crank: 0.5,
            coupler: 0.8,
            rocker: 0.7,
            point: [0.0; 2],
            image: Image::Left,
        },
        chain: Chain::StephensonTwo,
        ends: [[0.4, 0.5], [0.3, -0.4]],
        bars: [1.2, 1.0],
        image: Image::Right,
        point: [0.3, 0.2],
    }
}

/// By how much the crank turns between two angles of the first link that are near each other.
fn turn(six_bar: &SixBar, from: f64, to: f64) -> f64 {
    let [from, to] = [from, to].map(|angle| six_bar.pose(angle).unwrap().crank);
    (to - from + PI).rem_euclid(TAU) - PI
}

/// Angles of the first link, so many of 5 deg from a whole number of them on, if the crank turns one way on it, by 1 deg at least between
/// two: at a dead point another motion begins.
fn way_of_moving(known: &SixBar, from: i32, count: i32) -> Option<Vec<f64>> {
    let angles: Vec<f64> = (from..=from + count).map(|k| (5.0 * f64::from(k)).to_radians()).collect();
    let is_good = known.defects(&angles, &Demands { order: true, ..Demands::default() }).is_empty();
    let turns = is_good && angles.windows(2).all(|pair| turn(known, pair[0], pair[1]).abs() > 0.02);
    turns.then_some(angles)
}

/// Its declaration runs by the crank through the poses that the four-bar's first link gives.
#[test]
fn a_four_bar_that_moves_runs_as_its_declaration_says() {
    let six_bar = moving();
    let mut count = 0;
    for angles in (0..72).filter_map(|from| way_of_moving(&six_bar, from, 8)) {
        count += 1;
        let text = six_bar.declaration("Six", angles[0]).unwrap();
        let mut mechanism = Mechanism::from_text(&text).unwrap();
        let way = turn(&six_bar, angles[0], angles[1]).signum();
        mechanism.set_parameter("speed", way).unwrap();
        let (mut run, mut time) = (mechanism.start().unwrap(), 0.0);
        for pair in angles.windows(2) {
            let pose = six_bar.pose(pair[1]).unwrap();
            time += way * turn(&six_bar, pair[0], pair[1]);
            run.step_to(time).unwrap();
            let [x, y, arm] = ["coupler.tracer.position.x", "coupler.tracer.position.y", "arm.angle"]
                .map(|name| run.output(name).unwrap());
            assert!((pose.point[0] - x).hypot(pose.point[1] - y) < 1e-8, "{pair:?}");
            assert!((0.5 * (pose.angles[0] - arm)).sin().abs() < 1e-8, "{pair:?}");
        }
    }
    assert!(count > 3, "{count}");
}

fn six_bar(chain: Chain) -> SixBar {
    let four_bar = FourBar {
        pivots: [[0.1, -0.2], [1.2, 0.1]],
        crank: 0.3,
        coupler: 1.0,
        rocker: 0.7,
        point: [0.0; 2],
        image: Image::Left,
    };
    let (ends, bars) = match chain {
        Chain::StephensonTwo => return moving(),
        Chain::WattOne => ([[0.7, 0.8], [0.6, -0.6]], [0.9, 1.0]),
        Chain::WattTwo => ([[0.5, -0.4], [2.0, 0.2]], [0.8, 0.6]),
        Chain::StephensonOne => ([[0.2, 0.2], [0.5, 0.5]], [1.0, 1.1]),
        Chain::StephensonThree => ([[0.6, 0.5], [1.3, 1.3]], [1.2, 0.9]),
    };
    SixBar { four_bar, chain, ends, bars, image: Image::Right, point: [0.4, 0.3] }
}

/// Values of a run of a six-bar's declaration at angles of the crank: the arm's point, and the angle of the swing.
fn of_run(six_bar: &SixBar, angles: &[f64]) -> Vec<[f64; 3]> {
    let way = if angles[1] < angles[0] { -1.0 } else { 1.0 };
    let text = six_bar.declaration("Six", angles[0]).unwrap();
    let mut mechanism = Mechanism::from_text(&text).unwrap();
    mechanism.set_parameter("speed", way).unwrap();
    let mut run = mechanism.start().unwrap();
    let names = ["arm.tracer.position.x", "arm.tracer.position.y", "swing.angle"];
    let at = |angle: &f64| {
        run.step_to(((angle - angles[0]) * way).max(run.time())).unwrap();
        names.map(|name| run.output(name).unwrap())
    };
    angles.iter().map(at).collect()
}

#[test]
fn every_chain_runs_as_its_declaration_says() {
    let angles: Vec<f64> = (0..13).map(|k| 0.4 + 0.5 * f64::from(k)).collect();
    for chain in CHAINS {
        let six_bar = six_bar(chain);
        assert_eq!(six_bar.defects(&angles, &Demands { turns: true, ..Demands::default() }), [], "{chain:?}");
        for (angle, [x, y, swing]) in angles.iter().zip(of_run(&six_bar, &angles)) {
            let pose = six_bar.pose(*angle).unwrap();
            assert!((pose.point[0] - x).hypot(pose.point[1] - y) < 1e-9, "{chain:?} {angle}");
            assert!((0.5 * (pose.angles[1] - swing)).sin().abs() < 1e-9, "{chain:?} {angle}");
        }
    }
}

#[test]
fn a_six_bar_that_stops_says_where() {
    // The second dyad of two four-bars in series reaches the pin of the rocker but for a part of the turn.
    let mut six_bar = six_bar(Chain::WattTwo);
    six_bar.bars = [0.8, 0.3];
    let closes = |k: i32| six_bar.pose(0.001 * f64::from(k)).is_some();
    let open = (0..6283).find(|k| closes(*k) && !closes(k + 1)).unwrap();
    let begin = 0.001 * f64::from((0..open).rev().find(|k| !closes(*k)).map_or(1, |k| k + 1));
    let demands = Demands::default();
    let last = 0.001 * f64::from(open);
    assert_eq!(six_bar.defects(&[begin, last], &demands), []);
    let found = six_bar.defects(&[begin, last + 0.3], &demands);
    let Some(Defect::Stop { position: 1, angle }) = found.last() else { panic!("{found:?}") };
    assert!((angle - last).abs() < 0.02, "{angle} {last}");
}

/// Angles of crank, coupler, rocker, arm and swing.
fn all_angles(six_bar: &SixBar, angle: f64) -> [f64; 5] {
    let pose = six_bar.pose(angle).unwrap();
    let [crank, coupler, rocker] = pose.four_bar.angles;
    [crank, coupler, rocker, pose.angles[0], pose.angles[1]]
}

/// Poses on the way from a pose, found apart from dead points and dyads: Newton's method on the constraints of both loops, along the curve
/// that they leave, in steps of a fixed length.
fn traced(six_bar: &SixBar, angle: f64, length: f64, count: usize) -> Vec<[f64; 5]> {
    let FourBar { pivots, crank, coupler, rocker, .. } = six_bar.four_bar;
    let [[x0, y0], [x1, y1]] = pivots;
    let [_, [u, v]] = six_bar.ends;
    let [p, q] = six_bar.ends[0];
    // Crank, coupler, rocker, and both bars of a dyad between rocker and ground.
    let open = |x: &[f64; 5]| {
        let at = |k: usize, length: f64| [length * x[k].cos(), length * x[k].sin()];
        let ground = (y1 - y0).atan2(x1 - x0);
        let end = [x1 + p * x[2].cos() - q * x[2].sin(), y1 + p * x[2].sin() + q * x[2].cos()];
        let fixed = [x0 + u * ground.cos() - v * ground.sin(), y0 + u * ground.sin() + v * ground.cos()];
        let [a, b, c] = [at(0, crank), at(1, coupler), at(2, rocker)];
        let [d, e] = [at(3, six_bar.bars[0]), at(4, six_bar.bars[1])];
        [0, 1]
            .map(|k| [x0 - x1, y0 - y1][k] + a[k] + b[k] - c[k])
            .into_iter()
            .chain([0, 1].map(|k| end[k] + d[k] - fixed[k] - e[k]))
            .collect::<Vec<f64>>()
    };
    let matrix = |x: &[f64; 5]| {
        nalgebra::DMatrix::from_fn(4, 5, |row, column| {
            let beside = |h: f64| {
                let mut x = *x;
                x[column] += h;
                open(&x)[row]
            };
            (beside(1e-6) - beside(-1e-6)) / 2e-6
        })
    };
    let mut x = all_angles(six_bar, angle);
    let (mut way, mut all) = (nalgebra::DVector::zeros(5), vec![x]);
    for _ in 0..count {
        let square = matrix(&x).resize_vertically(5, 0.0);
        let right = square.svd(false, true).v_t.unwrap();
        let mut next = right.row(4).transpose();
        if next.dot(&way) < 0.0 {
            next = -next;
        }
        way = next;
        for k in 0..5 {
            x[k] += length * way[k];
        }
        for _ in 0..5 {
            let jacobian = matrix(&x);
            let normal = &jacobian * jacobian.transpose();
            let off = nalgebra::DVector::from_vec(open(&x));
            let back = jacobian.transpose() * normal.lu().solve(&off).unwrap();
            for k in 0..5 {
                x[k] -= back[k];
            }
        }
        all.push(x);
    }
    all
}

/// After a stop the position is on another branch where the motion of the constraints comes there, else on another circuit.
#[test]
fn what_is_after_a_stop_has_a_name() {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    println!("seed {state:#x}");
    let mut between = |least: f64, most: f64| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        least + (most - least) * (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut seen = [0, 0];
    for k in 0..400 {
        let mut six_bar = six_bar(Chain::WattTwo);
        let four_bar = &mut six_bar.four_bar;
        (four_bar.crank, four_bar.coupler) = (between(0.2, 1.4), between(0.4, 1.4));
        four_bar.rocker = between(0.4, 1.4);
        six_bar.bars = [between(0.3, 1.2), between(0.3, 1.2)];
        if seen.iter().all(|seen| *seen >= 3) {
            break;
        }
        let closed: Vec<f64> = (0..720)
            .map(|k| f64::from(k).to_radians() / 2.0)
            .filter(|a| six_bar.pose(*a).is_some())
            .collect();
        // Middles of the ranges in which the loops close on these images.
        let gaps: Vec<usize> = (1..closed.len()).filter(|k| closed[*k] - closed[k - 1] > 0.02).collect();
        let [gap] = gaps[..] else { continue };
        // A range that goes on at 360 deg is one.
        if six_bar.pose(0.0).is_some() {
            continue;
        }
        let middle = |range: &[f64]| f64::midpoint(range[0], range[range.len() - 1]);
        let (one, other) = (middle(&closed[..gap]), middle(&closed[gap..]));
        let defects = six_bar.defects(&[one, other], &Demands::default());
        let is_stop = |defect: &&Defect| matches!(defect, Defect::Stop { position: 1, .. });
        assert_eq!(defects.iter().filter(is_stop).count(), 1, "{defects:?}");
        let after: Vec<&Defect> = defects.iter().filter(|defect| !is_stop(defect)).collect();
        let target = all_angles(&six_bar, other);
        let is_near = |x: &[f64; 5]| x.iter().zip(target).all(|(a, b)| (0.5 * (a - b)).sin().abs() < 0.01);
        let comes = traced(&six_bar, one, 0.02, 2000).iter().any(is_near);
        match after[..] {
            [Defect::Branch { position: 1 }] => {
                seen[0] += 1;
                assert!(comes, "{k}");
            }
            [Defect::Circuit { position: 1 }] => {
                seen[1] += 1;
                assert!(!comes, "{k}");
            }
            _ => panic!("{defects:?}"),
        }
    }
    assert!(seen[0] >= 3 && seen[1] >= 3, "{seen:?}");
}

fn best(problem: &Problem, starts: u64) -> Found {
    problem.search(&Search { starts, ..Search::default() }).unwrap().swap_remove(0)
}

/// The error that a run of the declaration has.
fn error_of_run(found: &Found, task: &Task) -> f64 {
    let values = of_run(&found.six_bar, &found.angles);
    let square = |(k, [x, y, swing]): (usize, &[f64; 3])| match task {
        Task::Path { points, .. } => (x - points[k][0]).powi(2) + (y - points[k][1]).powi(2),
        Task::Function { pairs, .. } => 2.0 - 2.0 * (swing - found.output_zero - pairs[k].rocker).cos(),
    };
    values.iter().enumerate().map(square).sum()
}

/// Sum of squared chords of the dwell that starts 1 to 3000 reach with this least transmission angle. SciPy's `least_squares` on another
/// formulation (excesses as exponentials, open loops by a penalty, differences as derivatives) reaches 9.98e-5 and 1.639e-4 with 158 starts
/// in 150 s without a demand on the transmission angle, this search 6.03e-5 and 1.018e-4 with 1000 starts in 3 s.
const DWELL: f64 = 1.367_710e-4;

/// Rise and return of 40 deg with a dwell of 120 deg.
fn dwell() -> Task {
    let pair = |k: i32| {
        let crank = f64::from(10 * k);
        let way = (1.5 * (crank - 120.0)).to_radians();
        let rocker = if crank <= 120.0 { 0.0 } else { 20.0 * (1.0 - way.cos()) };
        Pair { crank: crank.to_radians(), rocker: rocker.to_radians() }
    };
    Task::Function { pairs: (0..36).map(pair).collect(), scales: Scales::FreeBoth }
}

fn problem(chain: Chain, task: Task) -> Problem {
    Problem { chain, task, bounds: Bounds::up_to(1.0), crank: Crank::Turns, transmission: 0.3 }
}

#[test]
fn a_dwell_is_found_and_runs() {
    let problem = problem(Chain::StephensonThree, dwell());
    let found = best(&problem, 12);
    assert_eq!(found.defects, []);
    assert!(found.error < DWELL * (1.0 + 1e-6), "{:e}", found.error);
    assert!((error_of_run(&found, &problem.task) - found.error).abs() < 1e-6 * found.error);
    assert!(found.greatest.to_degrees() < 0.31, "{}", found.greatest.to_degrees());
}

#[test]
fn points_of_a_known_six_bar_are_met() {
    let known = six_bar(Chain::WattOne);
    let steps: Vec<f64> = (0..12).map(|k| 0.5 * f64::from(k)).collect();
    let points = steps.iter().map(|step| known.pose(0.3 + step).unwrap().point).collect();
    let task = Task::Path { points, timing: Timing::Steps(steps) };
    let problem = Problem { bounds: Bounds::up_to(3.0), transmission: 0.05, ..problem(Chain::WattOne, task) };
    let found = best(&problem, 20);
    assert_eq!(found.defects, []);
    assert!(found.error < 1e-6, "{:e}", found.error);
    assert!((error_of_run(&found, &problem.task) - found.error).abs() < 1e-6 * found.error + 1e-14);
}

/// The crank meets its angles, and the arm, or the point of the coupler, what is wanted there.
#[test]
fn a_known_four_bar_that_moves_is_met() {
    let known = moving();
    let poses: Vec<_> = (0..72)
        .find_map(|from| way_of_moving(&known, from, 11))
        .unwrap()
        .iter()
        .map(|angle| known.pose(*angle).unwrap())
        .collect();
    let ground = known.four_bar.ground_angle();
    let pair = |pose: &SixBarPose| Pair { crank: pose.crank, rocker: pose.angles[0] };
    let points = poses.iter().map(|pose| pose.point).collect();
    let timing = Timing::Given(poses.iter().map(|pose| pose.crank - ground).collect());
    for task in [
        Task::Function { pairs: poses.iter().map(pair).collect(), scales: Scales::FreeBoth },
        Task::Path { points, timing },
    ] {
        let problem = Problem {
            bounds: Bounds::up_to(3.0),
            crank: Crank::Any,
            transmission: 0.0,
            ..problem(Chain::StephensonTwo, task)
        };
        let found = best(&problem, 20);
        assert_eq!(found.defects, []);
        assert!(found.error < 1e-7, "{:e}", found.error);
        // It runs by its crank, which the task gives.
        let text = found.six_bar.declaration("Six", found.angles[0]).unwrap();
        let mut mechanism = Mechanism::from_text(&text).unwrap();
        let turn = |pose: &SixBarPose| (pose.crank - poses[0].crank + PI).rem_euclid(TAU) - PI;
        let way = turn(&poses[1]).signum();
        mechanism.set_parameter("speed", way).unwrap();
        let mut run = mechanism.start().unwrap();
        let mut square = 0.0;
        for pose in &poses {
            run.step_to((turn(pose) * way).max(run.time())).unwrap();
            let [x, y, arm] = ["coupler.tracer.position.x", "coupler.tracer.position.y", "arm.angle"]
                .map(|name| run.output(name).unwrap());
            square += match &problem.task {
                Task::Path { .. } => (x - pose.point[0]).powi(2) + (y - pose.point[1]).powi(2),
                Task::Function { .. } => 2.0 - 2.0 * (arm + PI - found.output_zero - pose.angles[0]).cos(),
            };
        }
        assert!((square - found.error).abs() < 1e-5 * found.error, "{square:e} {:e}", found.error);
    }
}

#[test]
fn wrong_problems_have_a_name() {
    let few = Task::Path { points: vec![[0.0; 2]], timing: Timing::Free };
    let search = |problem: Problem| problem.search(&Search { starts: 1, ..Search::default() });
    assert_eq!(search(problem(Chain::WattOne, few)), Err(NoSixBar::TooFewPositions));
    let angles = Task::Path { points: vec![[0.0; 2]; 3], timing: Timing::Given(vec![0.0]) };
    assert_eq!(search(problem(Chain::WattOne, angles)), Err(NoSixBar::Angles { points: 3, angles: 1 }));
    let mut crossed = problem(Chain::WattOne, dwell());
    crossed.bounds.points = [1.0, -1.0];
    assert_eq!(search(crossed), Err(NoSixBar::Bounds));
}
