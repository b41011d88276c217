//! FMUs with sources, by FMPy: validated, compiled, and simulated in both versions and both interfaces, beside runs from text. `fmu.py` says
//! what is looked at. Without FMPy it is skipped, which is said: `bash tests/fmu.sh` installs it.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

#[path = "support/scenes.rs"]
mod scenes;

use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use plm_dynamic::{Integrator, Mechanism};
use plm_source::{Failure, Interfaces, Version, fmu};
use scenes::scenes;

/// A mechanism, and how it is looked at.
struct Case {
    name: String,
    mechanism: Mechanism,
    /// Parameters and inputs, SI.
    values: &'static [(&'static str, f64)],
    /// How far model exchange may be off, relative to the largest value of an output: what a solver of relative tolerance 1e-10 makes of it.
    tolerance: f64,
    /// A word of the message with which steps end; none where they do not.
    failure: &'static str,
    /// The interfaces that it has.
    interfaces: Interfaces,
}

/// With all that a description tells: parameters, one of which moves the start, inputs, first-order states, units for display.
const DRIVEN: &str = r"
/// A bar on a pin, whose torque follows an <order>.
pub Driven {
    gravity: 9.81 m/s^2;
    /// Of the bearing.
    param friction: N*m*s/rad = 0.1 N*m*s/rad;
    param begins: deg = 30 deg;
    param lag: ms = 50 ms;
    input order: N*m = 0;
    state torque: N*m = 0;
    rate torque = (order - torque)/lag;
    ground { port o: (0, 0) m; }
    body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: begins, locked; }
    revolute hinge(ground.o, bar.pivot) { damping: friction; drive: torque; }
    output bar.angle in deg, hinge.force, torque;
}";

/// Conditions on the time and on the state, of which one begins at a time and one is left by the motion.
const CLOCKED: &str = r"
pub Clocked {
    param until: s = 0.7 s;
    input push: N = 1 N;
    ground { port o: (0, 0) m; }
    body block { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0.5 m; }
    prismatic rail(ground.o, block.o);
    force pulse(block.o) { x: push*(if t < 0.3 s then 0 else if t < until then 3 else 0); }
    force back(block.o) { x: if block.x < 0 m then -20 N/m*block.x else -5 N; }
    output block.x, block.vx;
}";

fn snapshot(name: &str) -> Mechanism {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/snapshots");
    Mechanism::from_file(root.join(format!("{name}.plm"))).unwrap()
}

fn cases() -> Vec<Case> {
    let case = |name: &str, mechanism, values, tolerance, failure| Case {
        name: name.to_owned(),
        mechanism,
        values,
        tolerance,
        failure,
        interfaces: Interfaces::Both,
    };
    let of_snapshot = |name, tolerance, failure| case(name, snapshot(name), &[], tolerance, failure);
    // Contact, and joints that are projected: a solver's steps have neither.
    let stepped = |(name, mechanism): (String, Mechanism)| Case {
        interfaces: Interfaces::CoSimulation,
        ..case(&name, mechanism, &[], 0.0, "")
    };
    let scenes = scenes().into_iter().chain([("slider_crank".to_owned(), snapshot("slider_crank"))]);
    let both = vec![
        of_snapshot("four_bar", 1e-6, ""),
        // Small differences grow.
        of_snapshot("double_pendulum", 1e-6, ""),
        of_snapshot("chain", 1e-6, ""),
        of_snapshot("bouncer", 1e-6, ""),
        // No states: outputs alone.
        of_snapshot("driven_crank", 1e-12, ""),
        of_snapshot("arm_on_jack", 1e-6, "above_vacuum"),
        case("driven", Mechanism::from_text(DRIVEN).unwrap(), &[("friction", 0.3), ("order", 2.0)], 1e-6, ""),
        case("clocked", Mechanism::from_text(CLOCKED).unwrap(), &[("until", 0.55), ("push", 4.0)], 1e-6, ""),
    ];
    both.into_iter().chain(scenes.map(stepped)).collect()
}

const H: f64 = 1e-3;
const EVERY: usize = 10;
const ROWS: usize = 150;

fn line(time: f64, values: impl Iterator<Item = f64>) -> String {
    let mut text = format!("{time:?}");
    values.for_each(|value| write!(text, ",{value:?}").unwrap());
    text + "\n"
}

/// The outputs after every tenth step from text, to the end or to the step that fails.
fn of_steps(mechanism: &Mechanism) -> String {
    let mut run = mechanism.steps().unwrap();
    let outputs: Vec<usize> = outputs(mechanism).map(|(k, _)| k).collect();
    let mut text = String::new();
    for row in 0..=ROWS {
        if row > 0 && (0..EVERY).any(|_| plm_source::step(&mut run, mechanism, H).is_err()) {
            break;
        }
        let values = outputs.iter().map(|output| run.output(*output).unwrap());
        text.push_str(&line(row as f64 * EVERY as f64 * H, values));
    }
    text
}

/// The outputs of a run with error control at these times.
fn of_run(mechanism: &Mechanism, rows: usize) -> String {
    let mut run = mechanism.start_with(Integrator::Dop853(1e-12)).unwrap();
    let names: Vec<&str> = outputs(mechanism).map(|(_, name)| name).collect();
    let mut text = String::new();
    for row in 0..rows {
        let time = row as f64 * EVERY as f64 * H;
        run.step_to(time).unwrap();
        text.push_str(&line(time, names.iter().map(|name| run.output(name).unwrap())));
    }
    text
}

fn outputs(mechanism: &Mechanism) -> impl Iterator<Item = (usize, &str)> {
    let all = mechanism.lowered().outputs.iter().enumerate();
    all.filter(|(_, output)| output.declared).map(|(k, output)| (k, output.name.as_str()))
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmu-source").join(name)
}

#[test]
fn importers_have_the_bits_of_steps_and_come_near_to_runs() {
    let Some(python) = python() else { return };
    for Case { name, mut mechanism, values, tolerance, failure, interfaces } in cases() {
        let plain = mechanism.clone();
        for (name, value) in values {
            mechanism.set_parameter(name, *value).or_else(|_| mechanism.set_input(name, *value)).unwrap();
        }
        let [steps, run] = ["steps", "run"].map(|kind| folder(&format!("{name}-{kind}.csv")));
        fs::create_dir_all(folder("")).unwrap();
        let rows = of_steps(&mechanism);
        let count = rows.lines().count();
        if interfaces.exchange() {
            fs::write(&run, of_run(&mechanism, count)).unwrap();
        }
        fs::write(&steps, rows).unwrap();
        for (version, number) in [(Version::Two, 2), (Version::Three, 3)] {
            let made = fmu(&plain, version, None).unwrap();
            assert_eq!(made.interfaces, interfaces, "{name}");
            let folder = folder(&format!("{name}{number}"));
            let _ = fs::remove_dir_all(&folder);
            for file in &made.files {
                let path = folder.join(&file.name);
                fs::create_dir_all(path.parent().unwrap()).unwrap();
                fs::write(path, &file.text).unwrap();
            }
            let check = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmu.py");
            let output = Command::new(&python)
                .arg(check)
                .args([&folder, &steps, &run])
                .args([format!("{tolerance:e}"), failure.to_owned()])
                .args(values.iter().map(|(name, value)| format!("{name}={value:?}")))
                .output()
                .unwrap();
            let said = String::from_utf8_lossy(&output.stdout);
            let errors = String::from_utf8_lossy(&output.stderr);
            print!("{said}");
            assert!(output.status.success(), "{name} {number}:\n{said}\n{errors}");
        }
    }
}

/// In absolute coordinates a solver's steps open the joints, and nothing in the states closes them.
#[test]
fn what_model_exchange_does_not_have_is_refused_by_name() {
    let slider_crank = snapshot("slider_crank");
    let refused = fmu(&slider_crank, Version::Three, Some(Interfaces::ModelExchange));
    let Err(Failure::Refused(all)) = refused else { panic!("{refused:?}") };
    assert!(all.iter().any(|refused| refused.part == "drive"), "{all:?}");
}

/// Interfaces that are not wanted are not described, and nothing of them is computed.
#[test]
fn an_fmu_has_the_interfaces_that_are_wanted() {
    for (wanted, own, other) in [
        (Interfaces::ModelExchange, "<ModelExchange ", "<CoSimulation "),
        (Interfaces::CoSimulation, "<CoSimulation ", "<ModelExchange "),
    ] {
        for version in [Version::Two, Version::Three] {
            let made = fmu(&snapshot("four_bar"), version, Some(wanted)).unwrap();
            let text = |name: &str| {
                made.files
                    .iter()
                    .find(|file| file.name.ends_with(name))
                    .map(|file| file.text.as_str())
                    .unwrap()
            };
            let described = text("modelDescription.xml");
            assert!(described.contains(own) && !described.contains(other), "{described}");
            // Functions of the other one are there in 3.0 alone, and do nothing.
            for (function, is_there) in
                [("_fmu_step(", wanted.co_simulation()), ("_fmu_rates(", wanted.exchange())]
            {
                assert_eq!(text("_fmi.c").contains(function), is_there, "{function}");
            }
            assert_eq!(described.contains("plm(step)"), wanted.co_simulation());
            assert!(!text("_fmi.c").contains('@'), "a word of a template is left");
        }
    }
}

fn python() -> Option<String> {
    let python = std::env::var("PLM_PYTHON").unwrap_or("python3".to_owned());
    let has_fmpy = Command::new(&python).args(["-c", "import fmpy"]).output();
    if has_fmpy.is_ok_and(|output| output.status.success()) {
        return Some(python);
    }
    println!(
        "skipped: {python} has no FMPy (bash tests/fmu.sh installs it; PLM_PYTHON names another Python)"
    );
    None
}
