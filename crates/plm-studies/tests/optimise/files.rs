//! Readings from files, the recording of a fit, and stiff mechanisms.

use std::path::PathBuf;

use plm::Dop853;
use plm::Mechanism;
use plm::optimise::{ByDop853, ByRadau, Experiment, Identification, Unknown};
use plm_view::{Recorder, Role};

use super::identify::{YARD, set};
use super::mechanism;

fn scratch(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("readings").join(name)
}

/// What a run writes is read back: outputs in their units, rows before and after impacts at one time.
#[test]
fn readings_of_a_file_give_the_truth() {
    let truth = mechanism(YARD);
    let mut sim = truth.start_with(Dop853::new(1e-13)).unwrap();
    let mut recorder = Recorder::new(&sim);
    recorder.run(&mut sim, 1.2, 0.05).unwrap();
    let times = recorder.recording().times();
    assert!(times.windows(2).any(|pair| pair[0] == pair[1]), "an impact has two rows");
    let path = scratch("yard.csv");
    recorder.recording().write_csv(&path).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.starts_with("time (s),ball.y (mm),rail.displacement (m)\n"), "{text}");

    let mut guess = truth;
    set(&mut guess, "e", 0.75);
    set(&mut guess, "stiffness", 60.0);
    let fit = Identification::new(guess)
        .find(Unknown::parameter("e").within(0.0, 1.0))
        .find(Unknown::parameter("stiffness"))
        .find(Unknown::parameter("damping").from(0.5))
        .experiment(Experiment::from_csv(&path).unwrap())
        .run_by(ByDop853(1e-11))
        .unwrap();
    for (name, value) in [("e", 0.8), ("stiffness", 50.0), ("damping", 0.7)] {
        assert!((fit.value(name).unwrap() / value - 1.0).abs() < 1e-8, "{fit}");
    }

    let recording = fit.recording(0, ByDop853(1e-11)).unwrap();
    let column = |name: &str| recording.columns().iter().position(|own| own.name == name).unwrap();
    let [model, measured, residual] = ["ball.y", "ball.y measured", "ball.y residual"].map(column);
    assert_eq!(recording.columns()[residual].unit, "mm");
    let roles = [model, measured, residual].map(|column| recording.columns()[column].role);
    assert_eq!(roles, [Role::Motion, Role::Reading, Role::Residual]);
    let mut read = Vec::new();
    for (time, row) in recording.times().iter().zip(recording.rows()) {
        assert_eq!(row[measured].is_nan(), row[residual].is_nan());
        if row[measured].is_finite() {
            read.push(*time);
            assert!(
                (row[model] - row[measured]).abs() < 1e-5 && row[residual] == row[model] - row[measured],
                "{row:?}"
            );
        }
    }
    // An output has no reading where it may jump.
    let alone = |k: usize| times.iter().filter(|time| **time == times[k]).count() == 1;
    let expected: Vec<f64> = (0..times.len()).filter(|k| alone(*k)).map(|k| times[k]).collect();
    assert_eq!(read, expected);
    // Between readings the motion is a curve: no two rows are further apart than a thousandth of it.
    let apart = recording.times().windows(2).map(|pair| pair[1] - pair[0]);
    assert!(recording.len() > 1000 && apart.clone().all(|apart| apart > 0.0 && apart < 1.01 * 1.2e-3));
    let chart = fit.chart(ByDop853(1e-11)).unwrap().to_svg();
    assert_eq!(chart.matches(">model - reading<").count(), 2, "residuals have a panel of each output");
    assert!(fit.recording(1, ByDop853(1e-11)).unwrap().is_empty());
}

#[test]
fn wrong_files_are_told_with_line_and_column() {
    let path = scratch("wrong.csv");
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    for (text, problem) in [
        (
            "time (s),ball.y (mm)\n0,1000\n0.1,95O\n",
            "line 3, column 2 (`ball.y (mm)`): found `95O`, expected a number",
        ),
        (
            "time (s),ball.y (mm)\n0,1000\n,950\n",
            "line 3, column 1 (`time (s)`): found nothing, expected a number",
        ),
        ("time (s),ball.y (mm)\n0,1000\n0.1\n", "line 3: found 1 field, expected 2 fields, as in line 1"),
        (
            "moment,ball.y (mm)\n0,1000\n",
            "line 1: found `moment`, `ball.y (mm)`, expected a column of the time",
        ),
    ] {
        std::fs::write(&path, text).unwrap();
        let error = Experiment::from_csv(&path).unwrap_err().to_string();
        assert!(error.contains("wrong.csv") && error.contains(problem), "{error}");
    }
    for (text, problem) in [
        ("time (s),ball.z (mm)\n0,1000\n", "there is no output `ball.z`; there are ball.y, "),
        ("time (s),ball.y (cm)\n0,1000\n", "`ball.y` is in `mm` or `m`, not in `cm`"),
        ("time (s),ball.y\n0,1000\n", "`ball.y` is in `mm` or `m`, and no unit is given"),
        ("time (s),ball.y (mm),push (kN)\n0,1000,1\n", "`push` is in `N`, not in `kN`"),
        ("time (s),ball.y (mm)\n0.1,1000\n0.05,990\n", "experiment 0: the times do not ascend from 0 s on"),
        (
            "time (s),ball.y (mm),push (N)\n0,1,NaN\n",
            "experiment 0: `push` has 1 values at 1 times, which are to be numbers",
        ),
    ] {
        std::fs::write(&path, text).unwrap();
        let of = Identification::new(mechanism(YARD)).find(Unknown::parameter("e"));
        let error = of.experiment(Experiment::from_csv(&path).unwrap()).run().unwrap_err().to_string();
        assert!(error.starts_with(problem), "{error}");
    }
}

const STIFF: &str = "pub Stiff {
    param stiffness: N/m = 50 N/m;
    param damping: N*s/m = 100 N*s/m;
    ground { port rail: (0, 0) m; }
    body mass { mass: 1 gram; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 0.1 m, locked; start vx: 0 m/s, locked; }
    prismatic rail(ground.rail, mass.shoe) { stiffness: stiffness; damping: damping; }
    output mass.x;
}";

/// A gram on a spring with a damper: m x'' + c x' + k x = 0 has a time of 10 us beside one of 2 s. Readings by its closed form.
#[test]
fn stiff_mechanism_by_radau() {
    let (m, c, k, x0) = (1e-3, 100.0, 50.0, 0.1);
    let root = f64::sqrt(c * c - 4.0 * k * m);
    let fast = -(c + root) / (2.0 * m);
    let slow = -2.0 * k / (c + root);
    let times: Vec<f64> = (0..=20).map(|k| 0.1 * f64::from(k)).collect();
    let places: Vec<f64> = times
        .iter()
        .map(|t| x0 * (fast * f64::exp(slow * t) - slow * f64::exp(fast * t)) / (fast - slow))
        .collect();
    let mut guess = mechanism(STIFF);
    set(&mut guess, "damping", 130.0);
    let fit = Identification::new(guess)
        .find(Unknown::parameter("damping").within(10.0, 1000.0))
        .experiment(Experiment::new(times).measured("mass.x", "m", places))
        .run_by(ByRadau(1e-10))
        .unwrap();
    assert!((fit.value("damping").unwrap() / c - 1.0).abs() < 1e-7, "{fit}");
}
