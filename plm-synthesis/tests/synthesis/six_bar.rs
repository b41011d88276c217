//! Six-bars: chains, their declarations, synthesis.

use plm_dynamic::Mechanism;
use plm_synthesis::function::{Pair, Scales};
use plm_synthesis::path::{Crank, Search, Timing};
use plm_synthesis::six_bar::{Bounds, Chain, Found, NoSixBar, Problem, SixBar, Task};
use plm_synthesis::{Defect, Demands, FourBar, Image};

const CHAINS: [Chain; 4] = [Chain::WattOne, Chain::WattTwo, Chain::StephensonOne, Chain::StephensonThree];

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
