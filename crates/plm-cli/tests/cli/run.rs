//! `plm run`: the table and the CSV of compiled programs, faults, misuse.

#[allow(unused_qualifications, unreachable_pub, missing_docs, reason = "emitted code")]
#[path = "../../../../tests/snapshots/bouncer.rs"]
mod bouncer;
#[allow(unused_qualifications, unreachable_pub, missing_docs, reason = "emitted code")]
#[path = "../../../../tests/snapshots/double_pendulum.rs"]
mod double_pendulum;
#[allow(unused_qualifications, unreachable_pub, missing_docs, reason = "emitted code")]
#[path = "../../../../tests/snapshots/four_bar.rs"]
mod four_bar;

use std::fs;

use plm::view::{Options, Recorder};
use plm::{Described, Dop853, Method, Sim};

use super::{Said, folder, plm, plm_in, root};

const PENDULUM: &str = "pub Pendulum {
    param length: m;
    input torque: N*m = 0 N*m;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    body bob { mass: 1 kg; inertia: 1e-9 kg*m^2; port pivot: (0 m, length); start angle: 1 deg, locked; }
    revolute hinge(ground.o, bob.pivot);
    force motor(bob.pivot) { torque: torque; }
}";

/// The CSV that a compiled program writes with `--until 1 --every 0.05`.
fn of_compiled<M: Described<S = f64>, I: Method<M>>(mut sim: Sim<M, I>) -> String {
    let mut recorder = Recorder::observing_all(&sim);
    recorder.run(&mut sim, 1.0, 0.05).unwrap();
    let mut text = Vec::new();
    recorder.recording().write_csv_to(&mut text).unwrap();
    String::from_utf8(text).unwrap()
}

/// The CSV of a file of `tests/snapshots`.
fn of_text(name: &str, words: &[&str]) -> String {
    let path = root().join("tests/snapshots").join(name);
    let all =
        [&["run", path.to_str().unwrap(), "--until", "1", "--every", "0.05", "--csv", "-"], words].concat();
    let Said { code, output, errors } = plm(&all, "");
    assert_eq!((code, errors.as_str()), (0, ""));
    output
}

#[test]
fn csv_is_that_of_compiled_programs() {
    let tree = double_pendulum::DoublePendulum::new();
    let text = of_text("double_pendulum.plm", &[]);
    assert_eq!(text, of_compiled(tree.start_with(Dop853::new(1e-9)).unwrap()));
    assert!(text.starts_with("time (s),arm.angle (deg),") && text.lines().count() == 22, "{text}");
    let by_steps = of_text("double_pendulum.plm", &["--method", "Rk4:1e-3"]);
    assert_eq!(by_steps, of_compiled(tree.start_with(plm::Rk4::new(1e-3)).unwrap()));
    assert_ne!(by_steps, text);
    let with_loop = of_compiled(four_bar::FourBar::new().start_with(Dop853::new(1e-9)).unwrap());
    assert_eq!(of_text("four_bar.plm", &[]), with_loop);
}

/// Page, results file and CSV of one run with events.
#[test]
fn files_are_those_of_compiled_programs() {
    let [own, compiled] = [folder(), folder()];
    let path = root().join("tests/snapshots/bouncer.plm");
    let files = ["--view", "out/a.html", "--out", "a.npz", "--csv", "a.csv"];
    let words = [&["run", path.to_str().unwrap(), "--until", "1", "--every", "0.05"][..], &files].concat();
    let said = plm_in(&own, &words, b"");
    assert_eq!((said.code, said.output.as_str(), said.errors.as_str()), (0, "", ""));

    let mut sim = bouncer::Bouncer::new().start_with(Dop853::new(1e-9)).unwrap();
    let mut recorder = Recorder::observing_all(&sim);
    recorder.run(&mut sim, 1.0, 0.05).unwrap();
    let words = files.map(|word| match word.strip_prefix("--") {
        Some(_) => word.to_owned(),
        None => compiled.join(word).display().to_string(),
    });
    let options = Options::parse(words).unwrap();
    let written = plm::view::write::<bouncer::Bouncer<f64>>(&options, recorder.recording()).unwrap();
    assert_eq!(written.len(), 3);
    for file in ["out/a.html", "a.npz", "a.csv"] {
        let [own, compiled] = [&own, &compiled].map(|folder| fs::read(folder.join(file)).unwrap());
        assert!(own == compiled && own.len() > 200, "{file}");
    }
    // An event has a row before it and one after it.
    let table = fs::read_to_string(own.join("a.csv")).unwrap();
    assert!(table.lines().count() > 22, "{table}");
}

/// A small swing in a table against its closed form; poses, because no output is declared.
#[test]
fn values_have_units_and_bodies_their_poses() {
    let words = ["run", "-", "--until", "0.7", "--every", "0.35", "--set", "length=25cm"];
    let Said { code, output, errors } = plm(&words, PENDULUM);
    assert_eq!((code, errors.as_str()), (0, ""));
    let mut lines = output.lines();
    let headings = lines.next().unwrap();
    assert_eq!(headings, "time (s)    bob.x (m)  bob.y (m)  bob.angle (rad)");
    let rows: Vec<Vec<f64>> = lines
        .inspect(|line| assert_eq!(line.len(), headings.len(), "{output}"))
        .map(|line| line.split_whitespace().map(|number| number.parse().unwrap()).collect())
        .collect();
    let amplitude = 1_f64.to_radians();
    let omega = (9.81_f64 / 0.25).sqrt() * (1.0 - amplitude * amplitude / 16.0);
    for (row, time) in rows.iter().zip([0.0, 0.35, 0.7]) {
        assert!(
            (row[0] - time).abs() < 1e-9 && (row[3] - amplitude * (omega * time).cos()).abs() < 1e-6,
            "{output}"
        );
    }
    assert_eq!(rows.len(), 3);
    let csv = plm(&[&words[..], &["--csv", "-"]].concat(), PENDULUM).output;
    assert!(csv.starts_with("time (s),bob.x (m),bob.y (m),bob.angle (rad)\n0.0,"), "{csv}");
    // A torque holds the pendulum where it starts.
    let held = format!("torque = {:e} N*mm", 9810.0 * 0.25 * amplitude.sin());
    let said = plm(&[&words[..], &["--input", &held]].concat(), PENDULUM);
    let angles: Vec<&str> =
        said.output.lines().skip(1).map(|line| line.split_whitespace().last().unwrap()).collect();
    assert_eq!(angles, ["0.0174533"; 3], "{said:?}");
}

/// An arm of 0.5 m whose end is drawn away at 0.4 m/s from 0.2 m: it is stretched after 0.75 s.
#[test]
fn a_fault_ends_a_run_after_what_came_before() {
    let stretched = "pub Stretched {
        ground { port o: (0, 0) m; }
        body arm { mass: 1 kg; inertia: 1 kg*m^2; port o: (-0.5, 0) m; start angle: 60 deg; }
        revolute hinge(ground.o, arm.o);
        constraint motor: arm.x = 0.2 m + 0.4 m/s*t;
        output arm.x in mm;
    }";
    let folder = folder();
    fs::write(folder.join("a.plm"), stretched).unwrap();
    let words = ["run", "a.plm", "--until", "2", "--every", "0.25"];
    let table = plm_in(&folder, &words, b"");
    let csv = plm_in(&folder, &[&words[..], &["--csv", "out/a.csv"]].concat(), b"");
    for said in [&table, &csv] {
        assert_eq!(said.code, 1, "{said:?}");
        let at = said.errors.strip_prefix("plm: t = ").and_then(|text| text.split(' ').next());
        assert!((at.unwrap().parse::<f64>().unwrap() - 0.75).abs() < 1e-6, "{said:?}");
        assert!(said.errors.contains("motor"), "{said:?}");
    }
    assert_eq!((csv.output.as_str(), csv.errors), ("", table.errors));
    let written = fs::read_to_string(folder.join("out/a.csv")).unwrap();
    assert_eq!(written.lines().count(), table.output.lines().count());
    let mut lines = written.lines();
    assert_eq!(lines.next(), Some("time (s),arm.x (mm)"));
    let rows: Vec<[f64; 2]> = lines
        .map(|line| {
            line.split_once(',').map(|(time, x)| [time, x].map(|text| text.parse().unwrap())).unwrap()
        })
        .collect();
    assert!(rows.iter().all(|[time, x]| (x - (200.0 + 400.0 * time)).abs() < 1e-6), "{written}");
    let times: Vec<f64> = rows.iter().map(|[time, _]| *time).collect();
    assert_eq!(times[..3], [0.0, 0.25, 0.5]);
    assert!(times[3] > 0.7 && times.len() == 4, "{written}");
}

#[test]
fn mistakes_have_their_carets() {
    let said = plm(&["run", "-", "--until", "1"], "pub P { body b { mass: 10; inertia: 1 kg*m^2; } }");
    assert!(said.code == 1 && said.output.is_empty(), "{said:?}");
    assert!(said.errors.contains("error[E0302]") && said.errors.contains(" --> <stdin>:1:24\n"), "{said:?}");
    assert!(said.errors.contains("                       ^^\n"), "{said:?}");
}

#[test]
fn misuse_is_told_what_was_meant() {
    let run = |words: &[&str]| plm(&[&["run", "-"], words].concat(), PENDULUM);
    for (words, message) in [
        (&["--set", "length=1"][..], "a run needs its end: `--until SECONDS`"),
        (&["--until"], "--until SECONDS: the value is missing"),
        (&["--until", "--every", "1"], "--until SECONDS: the value is missing"),
        (&["--until", "soon"], "--until wants a positive time in seconds, not `soon`"),
        (&["--until", "1", "--every", "-0.1"], "--every wants a positive time in seconds, not `-0.1`"),
        (&["--until", "1", "--every", "1e-9"], "rows: with `--csv FILE`"),
        (
            &["--until", "1"],
            "the parameter `length` has no default: it must be given, by `--set length=VALUE`",
        ),
        (&["--until", "1", "--set", "lenght=1"], "there is no parameter `lenght`; there are length"),
        (&["--until", "1", "--input", "force=1 N"], "there is no input `force`; there are torque"),
        (
            &["--until", "1", "--set", "length"],
            "--set wants NAME=VALUE, as in `--set length=20cm`, not `length`",
        ),
        (&["--until", "1", "--set", "length=20 xm"], "--set length: unknown unit `xm`"),
        (&["--until", "1", "--set", "length=20kg"], "20 kg is a mass (kg), and a length (m) is wanted"),
        (&["--until", "1", "--method", "Rk4"], "Rk4 wants its longest step in seconds, as in Rk4:1e-3"),
        (
            &["--until", "1", "--untl", "2"],
            "there is no option --untl; `--until` is one\noptions of `plm run`: --until, ",
        ),
        (&["--until", "1", "--sett", "length=2"], "there is no option --sett; `--set` is one"),
        (&["--until", "1", "--sett=length=2"], "there is no option --sett; `--set` is one"),
        (&["--until", "1", "--fit", "length"], "there is no option --fit; it is one of `plm identify`"),
        (&["--until", "1", "-u"], "there is no option -u\noptions of `plm run`: "),
    ] {
        let said = run(words);
        assert!(
            said.code == 2 && said.output.is_empty() && said.errors.contains(message),
            "{words:?}: {said:?}"
        );
    }
    let said = plm(&["run", "none.plm", "--until", "1"], "");
    assert!(said.code == 2 && said.errors.contains("plm: none.plm: "), "{said:?}");
    let folder = folder();
    fs::write(folder.join("a.rs"), "fn main() {}").unwrap();
    let said = plm_in(&folder, &["run", "a.rs", "--until", "1"], b"");
    assert!(said.code == 2 && said.errors.contains("(`.plm`), not Rust"), "{said:?}");
    let words = ["run", "-", "--until", "1", "--set", "length=1", "--csv", "a.rs/a.csv"];
    let said = plm_in(&folder, &words, PENDULUM.as_bytes());
    assert!(said.code == 2 && said.errors.contains("plm: a.rs/a.csv: "), "{said:?}");
}

/// The page of the book shows a declaration and its table.
#[test]
fn the_book_shows_a_table() {
    let page = root().join("docs/src/running/command-line.md");
    let text = fs::read_to_string(&page).unwrap();
    let block = |fence: &str, from: usize| {
        let start = from + text[from..].find(fence).unwrap() + fence.len();
        start..start + text[start..].find("```\n").unwrap()
    };
    let declaration = block("```plm\n", 0);
    let shown = block("```text\n", declaration.end);
    let command = text[declaration.end..].split('`').find(|words| words.starts_with("plm run ")).unwrap();
    let words: Vec<&str> = command.split(' ').skip(1).collect();
    let folder = folder();
    fs::write(folder.join("pendulum.plm"), &text[declaration]).unwrap();
    let said = plm_in(&folder, &words, b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let made = said.output;
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(page, [&text[..shown.start], &made, &text[shown.end..]].concat()).unwrap();
    } else {
        assert!(text[shown] == made, "{made}\nPLM_BLESS=1 writes it anew");
    }
}
