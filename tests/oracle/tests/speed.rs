//! Bounds, tables and pictures of the programs in `speed`.
#![allow(clippy::unwrap_used, unreachable_pub, reason = "tests")]

#[path = "../speed/src/work_precision/beside.rs"]
mod beside;
#[path = "../speed/src/contact_peers/chart.rs"]
mod chart;
#[path = "../speed/src/work_precision/measure.rs"]
#[allow(dead_code, reason = "the program measures more")]
mod measure;
#[path = "../speed/src/work_precision/report.rs"]
#[allow(dead_code, reason = "the program draws as well")]
mod report;
#[path = "../speed/src/contact_peers/runs.rs"]
mod runs;
#[path = "../speed/src/contact_peers/steps.rs"]
mod steps;
#[path = "../speed/src/work_precision/stored.rs"]
mod stored;
#[path = "../speed/src/work_precision/summary.rs"]
#[allow(dead_code, reason = "the program draws as well")]
mod summary;
#[path = "../speed/src/contact_peers/tables.rs"]
mod tables;

use measure::{Bench, Effort, Line, Look, Outcome, Point, Scene};
use plm_peers::{Peer, Run, Setting};
use report::{Result as Measured, outcome};

/// Errors up to 10 have to do with the scene.
static SCENE: Scene = Scene {
    id: "S0",
    title: "",
    facts: "",
    until: 1.0,
    fewest_steps: 1,
    relative: false,
    hopeless: 10.0,
    run: |_| Vec::new(),
};
static RELATIVE: Scene = Scene { relative: true, ..SCENE };

/// A line in a formulation whose runs end with these errors; the longest takes so many seconds.
fn line(formulation: &'static str, errors: &[f64], seconds: f64) -> Line {
    let outcome =
        |&error: &f64| Point { setting: 1e-3, outcome: Ok(Outcome { error, seconds, evaluations: 1 }) };
    let points = errors.iter().map(outcome).collect();
    Line { method: "RK4".to_owned(), formulation, look: Look::Peer, facts: String::new(), points }
}

#[test]
fn a_line_has_to_come_within_a_ten_thousandth_of_what_is_hopeless() {
    let far = |line: Line| Measured { scene: &SCENE, lines: vec![line] }.far(0.02).len();
    assert_eq!(far(line("tree", &[2.0, 0.9e-3], 1e-4)), 0);
    assert_eq!(far(line("tree", &[2.0, 1.1e-3], 1e-4)), 1);
    assert_eq!(far(line("tree", &[2.0, 9e-3], 1e-4)), 1);
    assert_eq!(far(line("tree", &[f64::NAN], 1e-4)), 1);
    assert_eq!(far(line("tree", &[], 1e-4)), 1, "no run came to its end");
    // Finer settings were left out, and other programs are not ours.
    assert_eq!(far(line("tree", &[2.0], 0.03)), 0);
    assert_eq!(far(line("", &[2.0], 1e-4)), 0);
}

#[test]
fn the_program_fails_if_one_line_is_far() {
    let lines =
        vec![line("tree", &[1e-6], 1e-4), line("absolute", &[1.0], 1e-4), line("loops", &[1e-6], 1e-4)];
    let far = Measured { scene: &SCENE, lines }.far(0.02);
    assert_eq!(outcome(&far), Err("S0: RK4, absolute never comes near".to_owned()));
    assert_eq!(outcome(&[]), Ok(()));
}

/// The largest error of all numbers, by their own size where the scene says so.
#[test]
fn errors_are_those_of_the_number_that_is_farthest_off() {
    let effort = Effort { per_decade: 1, fewest_runs: 1, most_runs: 1, spent: 0.0, longest_run: 1.0 };
    let run = |_: f64| Some(Run { seconds: 1e-3, evaluations: 7, measured: vec![4.0, 100.5, -0.2] });
    let peer = Peer { scene: "S0", name: "other", setting: Setting::Step, run };
    for (scene, expected) in [(&SCENE, 0.5), (&RELATIVE, 0.25)] {
        let bench = Bench { scene, reference: vec![4.0, 100.0, -0.16], effort: &effort };
        for point in bench.peer(&peer).points {
            let error = point.outcome.unwrap().error;
            assert!((error - expected).abs() < 1e-12, "{}: {error}", scene.relative);
        }
    }
    // What is not a number must not be lost among numbers.
    let bench = Bench { scene: &SCENE, reference: vec![4.0, f64::NAN, -0.2], effort: &effort };
    assert!(bench.peer(&peer).points.iter().all(|point| point.outcome.as_ref().unwrap().error.is_nan()));
}

/// What another program has written: a line for each of its methods in each scene; a row that is no run is told.
#[test]
fn runs_of_another_program_are_lines_beside() {
    let file = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("beside.csv");
    let read = |rows: &str| {
        std::fs::write(&file, format!("scene,method,setting,error,seconds,evaluations\n{rows}")).unwrap();
        beside::read(&file).map_err(|error| error.to_string())
    };
    let lines = read("S1,a,1e-3,1e-4,2e-5,7\nS1,a,1e-4,1e-5,3e-5,8\nS2,a,1e-3,1e-4,2e-5,9\n").unwrap();
    let counts: Vec<(&str, usize)> =
        lines.iter().map(|(scene, line)| (scene.as_str(), line.points.len())).collect();
    assert_eq!(counts, [("S1", 2), ("S2", 1)]);
    assert_eq!(lines[0].1.points[1].outcome.as_ref().unwrap().evaluations, 8);
    let said = read("S1,a,1e-3,1e-4,2e-5,7\nS1,a,fine\n").err().unwrap();
    assert!(said.ends_with(".csv:3: `S1,a,fine` is no run"), "{said}");
}

/// A line of a table of the book: its name, and microseconds to the errors of the columns where it comes to them.
type Row = (String, Vec<Option<f64>>);

/// The errors of a table's columns, and its lines.
fn table(mark: &str) -> (Vec<f64>, Vec<Row>) {
    let tables = include_str!("../../../docs/src/images/work-precision/tables.txt");
    let (_, table) = tables.split_once(&format!("<!-- ANCHOR: {mark} -->\n")).unwrap();
    let (table, _) = table.split_once("<!-- ANCHOR_END").unwrap();
    let cells = |row: &str| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    let mut rows = table.lines().map(cells).filter(|row: &Vec<String>| !row[1].starts_with("---"));
    let columns = rows.next().unwrap()[1..].iter().map(|error| error.parse().unwrap()).collect();
    let time = |cell: &String| cell.split(' ').next()?.trim_matches('*').parse().ok();
    (columns, rows.map(|row| (row[0].clone(), row[1..].iter().map(time).collect())).collect())
}

#[test]
fn in_the_book_the_cheapest_line_is_ours_to_every_error() {
    for mark in ["s1", "s2", "s5", "s6"] {
        let (columns, lines) = table(mark);
        let (ours, others): (Vec<_>, Vec<_>) = lines.iter().partition(|(name, _)| name.contains(", "));
        assert!(ours.len() > 10 && others.iter().any(|(name, _)| name == "heyoka"), "{lines:?}");
        for (k, error) in columns.iter().enumerate() {
            let least = |lines: &[&Row]| {
                lines.iter().filter_map(|(_, times)| times[k]).reduce(f64::min).unwrap_or(f64::INFINITY)
            };
            assert!(least(&ours) < least(&others), "{mark} to {error}");
        }
    }
}

/// The summary is drawn of the runs that the tables are made of.
#[test]
fn the_summary_shows_the_stored_runs() {
    let stored = stored::read(include_str!("../../../docs/src/images/work-precision/runs.csv")).unwrap();
    let compared = summary::compare(&stored).unwrap();
    for scene in &compared {
        let (columns, lines) = table(&scene.scene.to_lowercase());
        let k = columns.iter().position(|&error| error == summary::GOALS[1]).unwrap();
        let least = lines.iter().filter(|(name, _)| name.contains(", ")).filter_map(|(_, times)| times[k]);
        let plm = least.reduce(f64::min).unwrap();
        assert!((1e6 * scene.plm[1] / plm - 1.0).abs() < 0.05, "{}: {plm}", scene.scene);
        assert!(scene.others.len() >= 3);
        for (name, multiples) in &scene.others {
            let (_, times) = lines.iter().find(|(of, _)| of == name).unwrap();
            let expected = times[k].map(|time| time / plm);
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < 0.06;
            assert!(
                expected.is_none() && multiples[1].is_none()
                    || near(expected.unwrap(), multiples[1].unwrap()),
                "{}: {name}",
                scene.scene
            );
        }
    }
    let drawn =
        summary::svg(&compared, include_str!("../../../docs/src/images/work-precision/elsewhere.csv"))
            .unwrap();
    assert!(
        drawn == include_str!("../../../docs/src/images/work-precision/summary.svg"),
        "the summary is not that of the runs; `--redraw docs/src/images/work-precision` of the program draws it"
    );
}

fn contact_runs() -> Vec<runs::Run> {
    runs::read(include_str!("../../../docs/src/images/contact-peers/runs.csv")).unwrap()
}

#[test]
fn the_picture_and_tables_of_contact_are_those_of_the_runs() {
    let runs = contact_runs();
    let is_same = chart::svg(&runs) == include_str!("../../../docs/src/images/contact-peers/chart.svg")
        && tables::all(&runs) == include_str!("../../../docs/src/images/contact-peers/tables.txt");
    assert!(is_same, "the program contact_peers draws them: `-- docs/src/images/contact-peers`");
}

#[test]
fn the_picture_of_steps_of_moreau_and_jean_is_that_of_the_runs() {
    let found = runs::read(include_str!("../../../docs/src/images/contact-steps/runs.csv")).unwrap();
    let is_same = steps::svg(&found, &contact_runs())
        == include_str!("../../../docs/src/images/contact-steps/chart.svg")
        && steps::tables(&found) == include_str!("../../../docs/src/images/contact-steps/tables.txt");
    assert!(is_same, "the program contact_peers draws it: `-- --steps docs/src/images/contact-steps`");
    // Impacts take place at their share of a step: of order 2 with the midpoint rule, and a parabola is exact.
    for (scene, most) in [("ball", 1e-9), ("rocking", 1.0), ("rope", 1.0), ("shaken", 1e-2)] {
        for run in runs::line(&found, scene, "plm", steps::LINES[0]) {
            let most = most * run.size * if scene == "ball" { 1.0 } else { run.size };
            assert!(run.error.is_some_and(|error| error < most), "{scene} {}", run.size);
        }
    }
    // Of order 1 with the semi-implicit Euler method, whose flights are low by g h t/2, without creep, and no impact gains.
    for theta in steps::LINES {
        for (scene, most) in [
            ("oscillator", 2.0),
            ("ball", 20.0),
            ("rocking", 10.0),
            ("slider-crank", 500.0),
            ("belt", 0.26),
            ("rope", 1.1),
            ("shaken", 11.0),
        ] {
            for run in runs::line(&found, scene, "plm", theta) {
                assert!(
                    run.error.is_some_and(|error| error < most * run.size),
                    "{scene} {theta} {}",
                    run.size
                );
            }
        }
        for scene in ["block", "oscillator"] {
            for run in runs::line(&found, scene, "plm", theta) {
                assert!(run.creep.is_some_and(|creep| creep < 1e-9), "{scene} {theta} {}", run.size);
            }
        }
    }
    // Of order 2 with two evaluations.
    for run in runs::line(&found, "slider-crank", "plm", "two evaluations") {
        assert!(run.error.is_some_and(|error| error < 1e3 * run.size * run.size), "{}", run.size);
    }
}

/// What the page says in words: plm sticks exactly, its errors follow the tolerance, and no other program comes as near.
#[test]
fn the_page_on_contact_says_what_was_measured() {
    let runs = contact_runs();
    let finest = |scene: &str, program: &str, settings: &str| {
        *runs::line(&runs, scene, program, settings).last().unwrap()
    };
    for scene in ["oscillator", "ball", "rocking", "slider-crank"] {
        let ours = runs::line(&runs, scene, "plm", "DOP853");
        assert_eq!(ours.len(), 5);
        let least = ours.last().unwrap().error.unwrap();
        for (program, settings, _) in &runs::LINES[1..] {
            for run in runs::line(&runs, scene, program, settings) {
                assert!(run.error.is_none_or(|error| error > 100.0 * least), "{scene}: {program}");
            }
        }
        // The longest run of ours is shorter than the finest of each other program.
        let slowest = ours.iter().map(|run| run.seconds).fold(0.0, f64::max);
        for (program, settings, _) in &runs::LINES[1..] {
            let line = runs::line(&runs, scene, program, settings);
            assert!(line.last().is_none_or(|run| run.seconds > slowest), "{scene}: {program}");
        }
    }
    for scene in ["block", "oscillator"] {
        assert!(runs::line(&runs, scene, "plm", "DOP853").iter().all(|run| run.creep == Some(0.0)));
    }
    let page = include_str!("../../../docs/src/running/contact-peers.md");
    let says = |figure: String| assert!(page.contains(&figure), "the page does not say `{figure}`");
    for scene in ["oscillator", "rocking", "slider-crank"] {
        says(format!("{:.0e}", finest(scene, "plm", "DOP853").error.unwrap()));
    }
    let block = |program: &str, settings: &str| runs::line(&runs, "block", program, settings);
    let creeps = block("MuJoCo", "stiff").iter().filter_map(|run| run.creep).collect::<Vec<_>>();
    says(format!("{:.0} µm/s", creeps[0]));
    says(format!("{:.0} µm/s", creeps[creeps.len() - 1]));
    assert!(block("Siconos", "Moreau-Jean").iter().all(|run| run.creep == Some(0.0)));
    says(format!("{:.2} %", 100.0 * finest("ball", "Siconos", "Moreau-Jean").gain.unwrap().abs()));
    says(format!("{:.2} %", 100.0 * finest("ball", "Rapier2D", "tight").gain.unwrap().abs()));
    says(format!("{:.0e} rad", finest("slider-crank", "Rapier2D", "tight").error.unwrap()));
    says(format!("{:.1} %", 100.0 * finest("ball", "Box2D", "tight").gain.unwrap()));
    says(format!("{:.0} %", 100.0 * finest("rocking", "Box2D", "tight").gain.unwrap().abs()));
    says(format!("{} steps", block("plm", "DOP853")[0].steps));
    says(format!("{} steps", block("plm", "DOP853")[4].steps));
}
