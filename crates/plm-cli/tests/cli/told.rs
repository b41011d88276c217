//! What `plm run` tells beside its numbers: notices, counts, ends, faults with their places.

use std::fs;

use super::{Said, folder, plm, plm_in};

/// A bar as a pendulum with a length in cm.
const BAR: &str = "pub Bar {
    param length: cm = 10 cm;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 1e-3 kg*m^2; port p: (0 m, length); start angle: 20 deg, locked; }
    revolute hinge(ground.o, bob.p);
    output bob.angle, bob.x;
}";

fn numbers(said: &Said) -> Vec<Vec<f64>> {
    let rows = said.output.lines().skip(1);
    rows.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect()
}

#[test]
fn help_is_where_it_is_looked_for() {
    let help = plm(&["help"], "");
    assert!(help.code == 0 && help.output.contains("plm run FILE"), "{help:?}");
    for words in [&["--help"][..], &["-h"]] {
        assert_eq!(plm(words, ""), help, "{words:?}");
    }
    let of_run = plm(&["help", "run"], "");
    for words in [&["run", "--help"][..], &["run", "-h"], &["--help", "run"]] {
        assert_eq!(plm(words, ""), of_run, "{words:?}");
    }
    for words in [&["--version"][..], &["-V"], &["version"]] {
        assert!(plm(words, "").output.starts_with("plm 0."), "{words:?}");
    }
}

#[test]
fn the_end_of_a_run_is_a_row() {
    let times = |words: &[&str]| {
        let said = plm(&[&["run", "-", "--csv", "-"], words].concat(), BAR);
        assert_eq!((said.code, said.errors.as_str()), (0, ""));
        numbers(&said).iter().map(|row| row[0]).collect::<Vec<_>>()
    };
    assert_eq!(times(&["--until", "1", "--every", "0.3"]), [0.0, 0.3, 0.6, 0.9_f64.min(3.0 * 0.3), 1.0]);
    assert_eq!(times(&["--until", "1", "--every", "5"]), [0.0, 1.0]);
    assert_eq!(times(&["--until", "1", "--every", "0.25"]), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(times(&["--until", "1", "--every", "0.1"]).len(), 11);
    assert_eq!(times(&["--until", "1", "--every", "0.3", "--method", "Rk4:1e-3"]).len(), 5);
    assert_eq!(times(&["--until", "1", "--every", "0.3", "--sampled"]).len(), 4);
    // The same rows beside files.
    let folder = folder();
    fs::write(folder.join("a.plm"), BAR).unwrap();
    for (words, rows) in [(&[][..], 5), (&["--sampled"], 4)] {
        let files = ["run", "a.plm", "--until", "1", "--every", "0.3", "--csv", "a.csv", "--out", "a.npz"];
        assert_eq!(plm_in(&folder, &[&files, words].concat(), b"").code, 0);
        assert_eq!(fs::read_to_string(folder.join("a.csv")).unwrap().lines().count(), rows + 1);
    }
}

/// A ball that bounces: rows before and after each impact, or none.
#[test]
fn events_have_rows_and_are_counted() {
    let ball = "pub Ball { gravity: 9.81 m/s^2; allow(W0002); ground { port o: (0, 0) m; }
        body b { mass: 1 kg; inertia: 1 kg*m^2; port c: (0, 0) m; start y: 1 m, locked; }
        circle_on_line f(ground.o, b.c) { radius: 0.1 m; restitution: 0.5; } output b.y; }";
    let words = ["run", "-", "--until", "0.5", "--every", "0.1", "--csv", "-"];
    let all = plm(&[&words[..], &["--stats"]].concat(), ball);
    let sampled = plm(&[&words[..], &["--sampled"]].concat(), ball);
    assert_eq!((numbers(&all).len(), numbers(&sampled).len()), (8, 6));
    assert!(sampled.errors.is_empty(), "{sampled:?}");
    // From 0.9 m.
    let time = (2.0_f64 * 0.9 / 9.81).sqrt();
    for told in [" steps, ", "contact: 1 impacts", &format!("plm: t = {time:.9} s: f.contact\n")] {
        assert!(all.errors.contains(told), "{told}\n{all:?}");
    }
}

/// A rod in the region of Painlevé (theory of contact), a square that lies on three supports, steps that are too long, a stiff damper.
#[test]
fn what_the_run_knows_is_told() {
    let rod = "pub Rod { gravity: 9.81 m/s^2; allow(W0002); param mu = 1.6; param th: rad = 63.43494882292201 deg; param w: rad/s = -4 rad/s;
        ground { port o: (0, 0) m; }
        body rod { mass: 1 kg; inertia: 1 kg*m^2/3; port tip: (-1, 0) m; start angle: th, locked; start omega: w, locked;
            start x: 1 m*cos(th), locked; start y: 1 m*sin(th), locked; start vx: -20 m/s - 1 m*sin(th)*w, locked; start vy: 1 m*cos(th)*w, locked; }
        point_on_line tip(ground.o, rod.tip) { friction: mu; } output rod.angle; }";
    let table = "pub Table { gravity: 9.81 m/s^2; allow(W0002); ground { port o: (0, 0) m; }
        body top { mass: 1 kg; inertia: 1 kg*m^2; port a: (-1, 0) m; port b: (0, 0) m; port c: (1, 0) m; start y: 0 m, locked; }
        point_on_line a(ground.o, top.a) { } point_on_line b(ground.o, top.b) { } point_on_line c(ground.o, top.c) { } output top.y; }";
    let stiff = "pub Stiff { body mass { mass: 1 kg; inertia: 1 kg*m^2; start vx: 0.1 m/s; }
        constraint level: mass.angle = 0; constraint height: mass.y = 0;
        force pull: (-100 N/m*mass.x - 1e6 N*s/m*mass.vx, 0 N) on mass; output mass.x; }"
        .replace("force pull: (-100 N/m*mass.x - 1e6 N*s/m*mass.vx, 0 N) on mass;", "drag pull(mass) { }")
        .replace(
            "pub Stiff",
            "part drag(on: body) { force on on: (-(100 N/m)*on.x - 1e6 N*s/m*on.vx, 0 N); }\npub Stiff",
        );
    for (text, words, told) in [
        (rod, &["--until", "0.02"][..], "plm: notice: contacts could go on in several ways"),
        (table, &["--until", "0.1"], "plm: notice: more contacts rest than there are freedoms"),
        (BAR, &["--until", "10", "--method", "Rk4:0.2"], "plm: notice: steps of up to 2e-1 s err by up to"),
        (&stiff, &["--until", "0.2"], "something dies out at 1.0e6 1/s"),
    ] {
        let said = plm(&[&["run", "-", "--every", "1"], words].concat(), text);
        assert!(said.code == 0 && said.errors.contains(told), "{told}\n{said:?}");
    }
    let folder = folder();
    fs::write(folder.join("a.plm"), rod).unwrap();
    let said = plm_in(&folder, &["run", "a.plm", "--until", "0.02", "--view", "a.html"], b"");
    assert!(said.errors.contains("notice: contacts could go on"), "{said:?}");
}

#[test]
fn numbers_alone_are_in_the_declared_unit() {
    let run =
        |words: &[&str]| plm(&[&["run", "-", "--until", "0.3", "--csv", "-"], words].concat(), BAR).output;
    let declared = run(&["--set", "length=25"]);
    assert_eq!(declared, run(&["--set", "length=25 cm"]));
    assert_eq!(declared, run(&["--set", "length=0.25m"]));
    assert_ne!(declared, run(&[]));
}

#[test]
fn powers_are_in_watts() {
    let text = "pub P { allow(W0002); body w { mass: 1 kg; inertia: 1 kg*m^2; start omega: 2 rad/s, locked; }
        output power = 3 N*m*w.omega; output angular = w.omega^2; }";
    let said = plm(&["run", "-", "--until", "1", "--csv", "-"], text);
    assert!(said.output.starts_with("time (s),power (W),angular (rad^2/s^2)\n"), "{said:?}");
}

const FOUR_BAR: &str = "pub Mine {
    param rocker: cm = 25 cm;
    ground { port a: (0, 0) cm; port d: (30, 0) cm; }
    body crank { port a: (0, 0) cm; port b: (10, 0) cm; }
    body coupler { port b: (0, 0) cm; port c: (28, 0) cm; }
    body rod { port c: (rocker, 0 m); port d: (0, 0) cm; start angle: 110 deg; }
    revolute a(ground.a, crank.a);
    revolute b(crank.b, coupler.b);
    revolute c(coupler.c, rod.c);
    revolute d(ground.d, rod.d);
    constraint motor: crank.angle = 1 rev/s*t;
    output rod.angle;
}";

#[test]
fn a_start_that_does_not_close_is_told_as_by_the_compiler() {
    let run = |text: &str, words: &[&str]| plm(&[&["run", "-", "--until", "0.1"], words].concat(), text);
    assert_eq!(run(FOUR_BAR, &[]).code, 0);
    for said in [run(FOUR_BAR, &["--set", "rocker=5"]), run(&FOUR_BAR.replace("25 cm", "5 cm"), &[])] {
        assert_eq!((said.code, said.output.as_str()), (1, ""), "{said:?}");
        for told in [
            "error[E0503]: the mechanism cannot be assembled: `d` stays open by 0.03 m",
            "--> <stdin>:10:14",
            "    revolute d(ground.d, rod.d);",
        ] {
            assert!(said.errors.contains(told), "{told}\n{}", said.errors);
        }
        assert!(!said.errors.contains("m or rad"), "{said:?}");
    }
    assert!(run(FOUR_BAR, &["--set", "rocker=5"]).errors.ends_with("plm: with rocker=5\n"));
}

/// A rope that is drawn away from its drum: the line of the joint that locks up.
#[test]
fn a_fault_has_the_line_of_its_part() {
    let text = "pub Stretched {
    ground { port o: (0, 0) m; }
    body arm { mass: 1 kg; inertia: 1 kg*m^2; port o: (-0.5, 0) m; start angle: 60 deg; }
    revolute hinge(ground.o, arm.o);
    constraint motor: arm.x = 0.2 m + 0.4 m/s*t;
}";
    let said = plm(&["run", "-", "--until", "2"], text);
    let expected =
        "\n --> <stdin>:4:14\n  |\n4 |     revolute hinge(ground.o, arm.o);\n  |              ^^^^^\n";
    assert!(said.code == 1 && said.errors.ends_with(expected), "{}", said.errors);
}

#[test]
fn a_fault_of_conditions_has_the_line_that_they_stand_in() {
    let text = "pub Ball {\n    gravity: 9.81 m/s^2;\n    ground { port o: (0, 0) m; }\n    \
                body ball { mass: 1 kg; inertia: 0.1 kg*m^2; start y: 1 m; }\n    \
                when ball.y<0 m and ball.vy < 0 m/s { ball.vy = -0.5*ball.vy; }\n    output ball.y;\n}\n";
    let said = plm(&["run", "-", "--until", "5"], text);
    // Bounces of half the speed end after three times the first fall, by nine digits.
    let end = 3.0 * (2.0_f64 / 9.81).sqrt();
    assert!(said.code == 1 && said.errors.starts_with(&format!("plm: t = {end:.5}")), "{said:?}");
    let time = said.errors.split(' ').nth(3).unwrap();
    assert!(
        time.len() <= "1.35457092".len() && said.errors.contains("times within 2e-6 s, by"),
        "{}",
        said.errors
    );
    let condition = "ball.y<0 m and ball.vy < 0 m/s";
    let place = format!(
        " --> <stdin>:5:10\n  |\n5 |     when {condition} {{ ball.vy = -0.5*ball.vy; }}\n  |          {}\n",
        "^".repeat(condition.len())
    );
    assert!(said.errors.ends_with(&place), "{}", said.errors);
}

/// A wheel of seventeen spokes has 34 rows, and 16 have room in a run of a text.
#[test]
fn what_has_no_room_is_told_with_its_place() {
    let corners: Vec<String> = (0..17)
        .map(|k| (f64::from(k) * core::f64::consts::TAU / 17.0).sin_cos())
        .map(|(sin, cos)| format!("({cos:.6}, {sin:.6})"))
        .collect();
    let text = format!(
        "pub Rim {{ gravity: 9.81 m/s^2; allow(W0002);\n    ground {{ port o: (0, 0) m; }}\n    body w {{ mass: 1 kg; inertia: 1 kg*m^2; port g: (0, 0) m; start y: 2 m; }}\n    \
         polygon_on_line feet(ground.o, w.g) {{ corners: {} m; friction: 0.5; }}\n    output w.x;\n}}\n",
        corners.join(", ")
    );
    let check = plm(&["check", "-"], &text);
    let run = plm(&["run", "-", "--until", "1"], &text);
    assert_eq!((check.code, run.code), (0, 1), "{check:?}\n{run:?}");
    for (said, severity) in [(check, "warning"), (run, "plm")] {
        for told in [
            "34 rows of contact, and a run of a text has room for 16: `feet.",
            "--> <stdin>:4:21",
            "= help: fewer of them",
        ] {
            assert!(
                said.errors.starts_with(severity) && said.errors.contains(told),
                "{told}\n{}",
                said.errors
            );
        }
    }
    assert!(plm(&["check", "-"], BAR).errors.is_empty());
}

/// A run that would take hours: Ctrl+C, and the files have what came before.
#[cfg(unix)]
#[test]
fn an_interrupted_run_keeps_its_files() {
    use std::process::{Command, Stdio};

    let folder = folder();
    fs::write(folder.join("a.plm"), BAR).unwrap();
    let files = ["--out", "a.npz", "--view", "a.html", "--csv", "a.csv"];
    let mut command = Command::new(env!("CARGO_BIN_EXE_plm"));
    command.args(["run", "a.plm", "--until", "1e7", "--every", "1e6"]).args(files).current_dir(&folder);
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_secs(2));
    let number = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &number]).status().unwrap().success());
    let done = child.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr);
    assert!(
        done.status.code() == Some(1) && said.contains("by Ctrl+C: what came before is written"),
        "{said}"
    );
    let table = fs::read_to_string(folder.join("a.csv")).unwrap();
    let last: f64 = table.lines().last().unwrap().split(',').next().unwrap().parse().unwrap();
    assert!(last > 1.0 && table.lines().count() >= 3, "{table}");
    assert!(fs::metadata(folder.join("a.npz")).unwrap().len() > 500);
    assert!(fs::metadata(folder.join("a.html")).unwrap().len() > 10_000);
}
