//! Packages of ROS 2: the node is compiled with headers that stand in for those of ROS (`ros2/include`), hears messages, and publishes the
//! numbers of steps from text.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use plm_dynamic::{Mechanism, Steps};
use plm_source::ros2;

/// A bar whose drive is an input, with a parameter that can change and one that moves the start.
const DRIVEN: &str = r"
/// A bar on a pin: less < more.
pub Driven {
    gravity: 9.81 m/s^2;
    param friction: N*m*s/rad = 0.1 N*m*s/rad;
    param begins: deg = 30 deg;
    input drive: N*m = 0;
    ground { port o: (0, 0) m; }
    body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: begins, locked; }
    revolute hinge(ground.o, bar.pivot) { damping: friction; drive: drive; }
    output bar.angle in deg, hinge.force;
}";

/// The compiled node of a mechanism.
fn node(name: &str, mechanism: &Mechanism) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("ros2-{name}"));
    for file in ros2(mechanism).unwrap() {
        let path = folder.join(file.name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, file.text).unwrap();
    }
    let stand_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ros2/include");
    let run = |compiler: &str, options: &[&str], input: &Path, output: &str| {
        let mut command = Command::new(compiler);
        command.args(["-O2", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off"]).args(options);
        command.arg("-I").arg(&stand_in).arg(input).arg("-o").arg(folder.join(output));
        let done = command.output().unwrap();
        assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    };
    let source = fs::read_dir(folder.join("src")).unwrap().map(|entry| entry.unwrap().path());
    let source = source.into_iter().find(|path| path.extension().is_some_and(|end| end == "c")).unwrap();
    run("cc", &["-std=c99", "-c"], &source, "mechanism.o");
    let object = folder.join("mechanism.o");
    run("c++", &["-std=c++17", object.to_str().unwrap()], &folder.join("src/node.cpp"), "node");
    folder.join("node")
}

/// The lines that a node prints over these events.
fn heard(node: &Path, options: &[&str], events: &str) -> Vec<String> {
    let mut child =
        Command::new(node).args(options).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(events.as_bytes()).unwrap();
    let done = child.wait_with_output().unwrap();
    String::from_utf8(done.stdout).unwrap().lines().map(str::to_owned).collect()
}

/// The last number of the last line that begins with these words; `%a` writes all its bits.
fn last(lines: &[String], beginning: &str) -> f64 {
    let line = lines.iter().rfind(|line| line.starts_with(beginning));
    hexadecimal(line.unwrap_or_else(|| panic!("{beginning}: {lines:?}")).rsplit(' ').next().unwrap())
}

/// A number as C's `%a` writes it.
fn hexadecimal(text: &str) -> f64 {
    let (sign, rest) = text.strip_prefix('-').map_or((1.0, text), |rest| (-1.0, rest));
    let (digits, exponent) = rest.strip_prefix("0x").unwrap().split_once('p').unwrap();
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mantissa = u64::from_str_radix(&format!("{whole}{fraction}"), 16).unwrap();
    let exponent: i32 = exponent.parse().unwrap();
    sign * mantissa as f64 * 2f64.powi(exponent - 4 * fraction.len() as i32)
}

fn steps(mechanism: &Mechanism, count: usize) -> Steps {
    let mut steps = mechanism.steps().unwrap();
    (0..count).for_each(|_| steps.step(0.001).unwrap());
    steps
}

#[test]
fn a_node_publishes_the_bits_of_steps_from_text() {
    let mut mechanism = Mechanism::from_text(DRIVEN).unwrap();
    let node = node("driven", &mechanism);
    let plain = heard(&node, &[], "tick 7\n");
    assert_eq!(plain[0], "~/output/bar_angle 0x1.0c152382d7366p-1", "the start is published: 30 deg");
    assert!(plain.contains(&"period 10000000 ns".to_owned()), "{plain:?}");
    let expected = steps(&mechanism, 70);
    assert_eq!(last(&plain, "~/output/bar_angle").to_bits(), angle(&expected).to_bits());
    // The pose of the bar: x and z are the plane, and a turn is about -y.
    let pose = plain.iter().rfind(|line| line.starts_with("/tf world driven/bar ")).unwrap();
    let pose: Vec<f64> = pose.split(' ').skip(3).map(hexadecimal).collect();
    let angle = angle(&expected);
    let about =
        [0.4 * angle.sin(), 0.0, -0.4 * angle.cos(), 0.0, -(0.5 * angle).sin(), 0.0, (0.5 * angle).cos()];
    for (own, closed) in pose.iter().zip(about) {
        assert!((own - closed).abs() < 1e-15, "{pose:?} {about:?}");
    }

    // An input and a parameter, before the first step; the other parameter is a constant of the source.
    mechanism.set_input("drive", 1.5).unwrap();
    mechanism.set_parameter("friction", 0.3).unwrap();
    let expected = steps(&mechanism, 20);
    let set = "input ~/input/drive 1.5\nset mechanism.friction 0.3\nset step 1\ntick 2\n";
    let heard_then = heard(&node, &[], set);
    assert_eq!(last(&heard_then, "~/output/bar_angle").to_bits(), self::angle(&expected).to_bits());
    assert!(heard_then.contains(&"set 0 step is read when the node starts".to_owned()), "{heard_then:?}");
    assert!(!fs::read_to_string(node.with_file_name("src/node.cpp")).unwrap().contains("\"begins\""));

    // Parameters at the start, of the node and of the mechanism; and the same after a restart.
    let options = ["mechanism.friction:=0.3", "step:=0.001", "period:=0.02", "frame:=map"];
    let again = heard(&node, &options, "input ~/input/drive 1.5\ntick 3\ncall ~/restart\ntick 1\n");
    assert_eq!(last(&again, "~/output/bar_angle").to_bits(), self::angle(&expected).to_bits());
    assert!(again.contains(&"call 1".to_owned()) && again.iter().any(|line| line.starts_with("/tf map ")));
    let wrong = heard(&node, &["step:=0"], "");
    assert_eq!(wrong, ["fatal `step` is above 0, and `period` not below it"]);
}

/// The first coordinate.
fn angle(steps: &Steps) -> f64 {
    steps.numbers().x[0]
}

#[test]
fn a_step_that_fails_is_told_and_a_restart_begins_again() {
    let text = "pub Falls { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; } body stone { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; \
                start y: 1 m; } require high: stone.y > 0.9 m; output stone.y; }";
    let node = node("falls", &Mechanism::from_text(text).unwrap());
    let lines = heard(&node, &[], "tick 30\ncall ~/restart\n");
    let errors: Vec<&String> = lines.iter().filter(|line| line.starts_with("error ")).collect();
    // It falls by 0.1 m in sqrt(0.2/9.81) s, and is told once.
    let [error] = errors[..] else { panic!("{lines:?}") };
    let time: f64 = error.split(' ').nth(3).unwrap().parse().unwrap();
    assert!((time - (0.2f64 / 9.81).sqrt()).abs() < 2e-3, "{error}");
    assert_eq!(last(&lines, "~/output/stone_y"), 1.0);
}
