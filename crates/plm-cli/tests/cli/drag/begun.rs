//! A pose of a run becomes the start of the text.

use std::f64::consts::TAU;

use plm_cli::Server;
use plm_dynamic::{Mechanism, Run};
use serde_json::{Value, json};

use super::{asked, declaration, edited};

/// Two bars on a pin, without anything that drives them.
const PENDULUM: &str = "\
pub Pendulum {
    gravity: 9.81 m/s^2;
    let p1 = (0, 0) mm;
    let p2 = (300, 0) mm;
    let p3 = (300, 200) mm;
    ground { port g1: p1; }
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p1; port b: p2; }
    body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p2; port b: p3; }
    revolute pin1(ground.g1, bar1.a);
    revolute pin2(bar1.b, bar2.a);
}
";

/// A four-bar as a hand draws it.
const FOUR_BAR: &str = "\
pub Drawing {
    gravity: 9.81 m/s^2;
    let p1 = (0, 0) mm;
    let p2 = (40, 60) mm;
    let p3 = (240, 140) mm;
    let p4 = (200, 0) mm;
    ground { port g1: p1; port g2: p4; }
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p1; port b: p2; }
    body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p2; port b: p3; }
    body bar3 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p3; port b: p4; }
    revolute pin1(ground.g1, bar1.a);
    revolute pin2(bar1.b, bar2.a);
    revolute pin3(bar2.b, bar3.a);
    revolute pin4(ground.g2, bar3.b);
}
";

/// A block on a rail that is turned, whose origin is not its centre: its place is its freedom.
const BLOCK: &str = "\
pub Block {
    gravity: 9.81 m/s^2;
    ground { port rail: (10, 20) mm, axis: 30 deg; }
    body block { mass: 1 kg; inertia: 1 kg*m^2; centre: (30, -40) mm; port a: (0, 0) mm; }
    prismatic guide(ground.rail, block.a);
}
";

fn poses(run: &Run) -> Vec<(String, [f64; 3])> {
    let names: Vec<String> = run.bodies().map(str::to_owned).collect();
    let pose = |name: String| {
        let at = run.body(&name).unwrap();
        (name, [at.x, at.y, at.angle])
    };
    names.into_iter().map(pose).collect()
}

fn gesture(poses: &[(String, [f64; 3])]) -> Value {
    let pose =
        |(body, [x, y, angle]): &(String, [f64; 3])| json!({ "body": body, "at": [x, y], "angle": angle });
    json!({ "kind": "start", "poses": poses.iter().map(pose).collect::<Value>(), "grid": 1e-3 })
}

/// The text that begins where a text is after a time, which is asserted, and the number of its locks.
fn begun(what: &str, text: &str, time: f64) -> (String, usize) {
    let mut run = Mechanism::from_text(text).unwrap().start().unwrap();
    run.step_to(time).unwrap();
    let wanted = poses(&run);
    let answer = asked(&mut Server::default(), text, &Value::Null, &gesture(&wanted));
    assert!(answer["why"].is_null(), "{what}: {answer}");
    let made = edited(text, &answer);
    let found = poses(&Mechanism::from_text(&made).unwrap().start().unwrap());
    for ((name, found), (_, wanted)) in found.iter().zip(&wanted) {
        // Angles are written to half of a thousandth of a degree, 9e-6 rad; the worst of these links turns 30 times as much as what is locked.
        let turn = found[2] - wanted[2];
        let turn = turn - (turn / TAU).round() * TAU;
        let away = (found[0] - wanted[0]).hypot(found[1] - wanted[1]);
        assert!(turn.abs() < 3e-4 && away < 3e-4, "{what} {name}: {found:?} {wanted:?}\n{made}");
    }
    let locks = made.matches(", locked").count() - made.matches("omega: speed, locked").count();
    (made, locks)
}

#[test]
fn the_pose_on_the_screen_becomes_the_start() {
    let machine = |name: &str| declaration(&format!("examples/gallery/machines/{name}.rs"));
    let driven = FOUR_BAR
        .replace("    revolute pin1", "    constraint motor1: bar1.angle = 60 rev/min*t;\n    revolute pin1");
    // With as many locks as there are freedoms.
    for (what, text, time, freedoms) in [
        ("pendulum", PENDULUM.to_owned(), 0.3, 2),
        ("four-bar", FOUR_BAR.to_owned(), 0.3, 1),
        ("driven four-bar", driven.clone(), 0.7, 0),
        ("driven four-bar, turns later", driven, 3.3, 0),
        ("block", BLOCK.to_owned(), 0.1, 1),
        ("whitworth", machine("whitworth"), 1.7, 1),
        ("peaucellier", machine("peaucellier"), 0.4, 0),
    ] {
        let (made, locks) = begun(what, &text, time);
        assert_eq!(locks, freedoms, "{what}\n{made}");
    }
}

#[test]
fn a_pose_that_the_text_cannot_take_is_refused() {
    let mut server = Server::default();
    let mut why = |text: &str, poses: &[(String, [f64; 3])]| {
        asked(&mut server, text, &Value::Null, &gesture(poses))["why"].as_str().map(str::to_owned)
    };
    let start = poses(&Mechanism::from_text(FOUR_BAR).unwrap().start().unwrap());
    assert_eq!(why(FOUR_BAR, &start), None);
    let mut open = start.clone();
    open[2].1[2] += 0.3;
    assert!(why(FOUR_BAR, &open).unwrap().starts_with("from this pose the joints"));
    assert_eq!(why(FOUR_BAR, &start[..2]).unwrap(), "the picture is not that of the text");
    assert!(
        why(&FOUR_BAR.replace("revolute pin1", "revolut pin1"), &start)
            .unwrap()
            .starts_with("a text with errors")
    );
    let formula = BLOCK.replace("port a: (0, 0) mm;", "port a: (0, 0) mm; start x: 2*5 mm;");
    let block = poses(&Mechanism::from_text(&formula).unwrap().start().unwrap());
    assert!(why(&formula, &block).unwrap().contains("start x of block"));
}
