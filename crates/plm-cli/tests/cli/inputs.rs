//! `plm run --inputs`: inputs over time from tables, against closed forms, and misuse.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use super::{Said, folder, plm_in};

/// Two masses that are pushed.
const CARTS: &str = "pub Carts {
    param mass = 2 kg;
    /// The push.
    input push: N // of the motor
        = 5 N;
    repeat i in 0..2 {
        input pull[i]: kN = 0 kN;
        body cart[i] { mass: mass; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
        prismatic rail[i](ground.o, cart[i].o) { drive: push + pull[i]; }
    }
    ground { port o: (0, 0) m; }
    output cart[0].x, cart[1].x, push;
}";

/// A mass that friction holds up to 4 N, and what counts how often more pushes.
const BOX: &str = "pub Box {
    input push: N = 0 N;
    input since: s = 100 s;
    ground { port o: (0, 0) m; }
    body cart { mass: 2 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
    friction slip: rate(cart.x) within 4 N;
    prismatic rail(ground.o, cart.o) { drive: push; }
    body flag { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
    prismatic pole(ground.o, flag.o) { drive: if t > since then 2 N else 0 N; }
    discrete n: 1 = 0;
    when push > 3 N { n = n + 1; }
    output cart.x, n, flag.x;
}";

/// A folder with declarations and tables.
fn with(files: &[(&str, &[u8])]) -> PathBuf {
    let folder = folder();
    fs::write(folder.join("carts.plm"), CARTS).unwrap();
    fs::write(folder.join("box.plm"), BOX).unwrap();
    for (name, text) in files {
        fs::write(folder.join(name), text).unwrap();
    }
    folder
}

/// The rows of a run, which tells this.
fn rows(folder: &std::path::Path, words: &[&str], told: &str) -> Vec<Vec<f64>> {
    let Said { code, output, errors } = plm_in(folder, &[&["run"], words, &["--csv", "-"]].concat(), b"");
    assert_eq!((code, errors.as_str()), (0, told), "{words:?}");
    let row = |line: &str| line.split(',').map(|field| field.parse().unwrap()).collect();
    output.lines().skip(1).map(row).collect()
}

fn close(found: &[f64], expected: &[f64]) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-8 * (1.0 + expected.abs()), "{found} for {expected}");
    }
}

const METHODS: [&str; 4] = ["Dop853:1e-10", "RadauIia5:1e-10", "Rk4:1e-2", "Gauss2:1e-2"];

/// x = k t^3/(6 m) under a force of k t, to the end of the readings and beyond; samples lie between readings.
#[test]
fn a_ramp_acts_within_steps() {
    let folder = with(&[
        ("a.csv", b"Zeit (ms);push [kN];pull[1] (N)\n0;0;0\n2000;0,006;\n2500;0,006;-10\n"),
        ("near.csv", b"t,push (N)\n0,0\n1,2\n1.2,4\n"),
    ]);
    for method in METHODS {
        let words = ["carts.plm", "--until", "3", "--every", "0.7", "--inputs", "a.csv", "--method", method];
        let told = "plm: a.csv ends at 2.5 s, and the run at 3 s: its last readings hold from there on\n";
        let rows = rows(&folder, &words, told);
        let push = |t: f64| (3.0 * t).min(6.0);
        let pushed =
            |t: f64| if t < 2.0 { t.powi(3) / 4.0 } else { 2.0 + 3.0 * (t - 2.0) + 1.5 * (t - 2.0).powi(2) };
        // The pull falls by 4 N/s until 2.5 s.
        let pulled = |t: f64| {
            let late = (t - 2.5).max(0.0);
            -(t.min(2.5).powi(3) / 3.0) - 6.25 * late - 2.5 * late * late
        };
        assert_eq!(rows.len(), 6, "{method}: {rows:?}");
        for row in rows {
            let t = row[0];
            close(&row[1..], &[pushed(t), pushed(t) + pulled(t), push(t)]);
        }
    }
    // A reading after the end of the run has its part in the line before it.
    let words = ["carts.plm", "--until", "1.1", "--inputs", "near.csv"];
    close(&rows(&folder, &words, "").pop().unwrap(), &[1.1, 0.2225, 0.2225, 3.0]);
}

/// Where readings hold, the motion is a parabola from reading to reading.
#[test]
fn readings_hold() {
    let folder = with(&[("a.csv", b"t,push (N),comment\n0,1,\n0.5,2,\n1,-1,\n1.5,,\n2,4,\n")]);
    for method in METHODS {
        let words = [
            "carts.plm",
            "--until",
            "3",
            "--every",
            "0.25",
            "--inputs",
            "a.csv",
            "--hold",
            "--method",
            method,
        ];
        let told = "plm: a.csv ends at 2 s, and the run at 3 s: its last readings hold from there on\n";
        let rows = rows(&folder, &[&words[..], &["--only", "push"]].concat(), told);
        assert_eq!(rows.len(), 13, "{method}: {rows:?}");
        for (k, row) in rows.iter().enumerate() {
            let t = 0.25 * k as f64;
            let (mut x, mut v, mut push) = (0.0, 0.0, 0.0);
            for (from, to, force) in [(0.0, 0.5, 1.0), (0.5, 1.0, 2.0), (1.0, 2.0, -1.0), (2.0, 9.0, 4.0_f64)]
            {
                let own = (t.min(to) - from).max(0.0);
                x += v * own + force / 4.0 * own * own;
                v += force / 2.0 * own;
                push = if t >= from { force } else { push };
            }
            close(row, &[t, x, x, push]);
        }
    }
}

/// A sine of a thousand readings a second moves as its lines do; page and results file have the rows of the CSV.
#[test]
fn long_signals_are_followed() {
    let mut table = String::from("time (s),push (N)\n");
    for k in 0..=2000 {
        let t = f64::from(k) * 1e-3;
        writeln!(table, "{},{}", t + 100.0, 4.0 * t.sin()).unwrap();
    }
    let folder = with(&[("a.csv", table.as_bytes())]);
    let words = ["carts.plm", "--until", "2", "--every", "0.1", "--inputs", "a.csv"];
    let from = [&words[..], &["--from", "first"]].concat();
    let rows = rows(&folder, &from, "");
    for row in &rows {
        let t = row[0];
        // Lines between readings are off by 4 N (1 ms)^2/8 at most.
        assert!((row[1] - 2.0 * (t - t.sin())).abs() < 1e-6, "{row:?}");
    }
    let files = ["--out", "a.npz", "--view", "a.html", "--csv", "b.csv"];
    let said = plm_in(&folder, &[&["run"], &from[..], &files].concat(), b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let text = fs::read_to_string(folder.join("b.csv")).unwrap();
    assert_eq!(text.lines().count(), rows.len() + 1);
    // On another clock the first reading holds, and that is told.
    let said = plm_in(&folder, &[&["run"], &words[..]].concat(), b"");
    assert!(said.errors.contains("`--from first` or `--from 100s`"), "{said:?}");
}

/// Friction lets go at its bound and conditions switch where a line meets them, or at a reading.
#[test]
fn events_are_where_signals_meet_them() {
    let folder =
        with(&[("a.csv", b"t,push (N),since (s)\n0,0,100\n1,2,0.5\n2,4,100\n2,4,2.5\n3,6,2.5\n4,6,2.5\n")]);
    let words = ["box.plm", "--until", "4", "--every", "0.5", "--sampled", "--inputs", "a.csv"];
    for row in rows(&folder, &words, "") {
        let t = row[0];
        let slid = |t: f64| if t < 2.0 { 0.0 } else { (t - 2.0).powi(3) / 6.0 };
        let x = if t < 3.0 { slid(t) } else { 1.0 / 6.0 + 0.5 * (t - 3.0) + 0.5 * (t - 3.0).powi(2) };
        // The flag is pushed from where 100 - 99.5 t = t to where 0.5 + 99.5 (t - 1) = t, and from 2.5 s on.
        let flag = |from: f64, to: f64| {
            let (own, late) = ((t.min(to) - from).max(0.0), (t - to).max(0.0));
            own * own + 2.0 * own * late
        };
        let flag = flag(100.0 / 100.5, 99.0 / 98.5) + flag(2.5, 9.0);
        close(&row, &[t, x, f64::from(t > 1.5), flag]);
    }
    let held = rows(&folder, &[&words[..], &["--hold"]].concat(), "");
    for row in held {
        let t = row[0];
        let x = if t < 3.0 { 0.0 } else { 0.5 * (t - 3.0).powi(2) };
        // A time that an input has moved past the present is that of the change.
        let early = (t.min(2.0) - 1.0).max(0.0);
        let flag = early * early + 2.0 * early * (t - 2.0).max(0.0) + (t - 2.5).max(0.0).powi(2);
        close(&[row[0], row[1], row[3]], &[t, x, flag]);
    }
}

/// Tables of Windows, with letters of code page 1252.
#[test]
fn tables_of_code_page_1252_are_followed() {
    let folder = with(&[("a.csv", b"sep=;\r\nZeit [s];L\xe4nge [\xb5m];push [N]\r\n0;1;4\r\n1;1;4\r\n")]);
    let words = ["carts.plm", "--until", "1", "--inputs", "a.csv", "--only", "push"];
    let told = "plm: a.csv: line 2 is no UTF-8: the table is read as of code page 1252\n";
    close(&rows(&folder, &words, told).pop().unwrap(), &[1.0, 1.0, 1.0, 4.0]);
}

#[test]
fn misuse_is_told() {
    for (text, words, message) in [
        ("t,push (N)\n0,1\n", &["--input", "push=3"][..], "`push` is given by --input, and by a.csv"),
        ("t,push (N)\n0,1\n", &["--inputs", "a.csv"], "`push` is given twice: an input has one course"),
        (
            "t,psuh (N)\n0,1\n",
            &[],
            "a.csv: `psuh` is no input; `push` is one\ninputs: push, pull[0], pull[1]; `--only NAMES`",
        ),
        ("t,push (N)\n0,1\n", &["--only", "pull"], "--only: there is no `pull`; there are push"),
        ("t,push\n0,1\n", &[], "a.csv: `push` is in `N`, and no unit is given"),
        ("t,pull[0]\n0,1\n", &[], "a.csv: `pull[0]` is in `kN` or `N`, and no unit is given"),
        ("t,push (m)\n0,1\n", &[], "a.csv: push: 1 m is a length (m), and a force (N) is wanted"),
        ("t,push (N)\n0,1\n2,1\n1,1\n", &[], "a.csv: times of readings ascend, and 1 s stands after 2 s"),
        ("t,push (N)\n0,1\n2,inf\n", &[], "a.csv: `push` is inf at 2 s: a reading is a number"),
        ("t,push (N)\n0,\n1,\n", &[], "a.csv: `push` has no readings"),
        ("t,push (N)\n", &[], "a.csv has headings, and no readings"),
        ("t\n0\n", &[], "a.csv has no column beside the time"),
        ("", &[], "found no line, expected headings"),
        ("t,push (N)\n0,1\n", &["--from", "noon"], "--from: `noon` is no number with a unit"),
    ] {
        let folder = with(&[("a.csv", text.as_bytes())]);
        let words = [&["run", "carts.plm", "--until", "1", "--inputs", "a.csv"], words].concat();
        let said = plm_in(&folder, &words, b"");
        assert!(
            said.code == 2 && said.output.is_empty() && said.errors.contains(message),
            "{words:?} {text:?}: {said:?}"
        );
    }
    let folder = with(&[("a.csv", b"t,g (m/s^2)\n0,1\n1,2\n")]);
    let said = plm_in(&folder, &["run", "carts.plm", "--until", "1", "--hold"], b"");
    assert!(said.code == 2 && said.errors.contains("with `--inputs FILE`"), "{said:?}");
    // What may read inputs and no states takes no lines.
    let lift = "pub Lift { input g: m/s^2 = 9.81 m/s^2; gravity: g; body a { mass: 1 kg; inertia: 1 kg*m^2; start y: 0 m, locked; } \
                output a.y; }";
    fs::write(folder.join("lift.plm"), lift).unwrap();
    let words = ["run", "lift.plm", "--until", "2", "--inputs", "a.csv"];
    let said = plm_in(&folder, &words, b"");
    assert!(said.code == 2 && said.errors.contains("`g` cannot move on straight lines"), "{said:?}");
    let said = plm_in(&folder, &[&words[..], &["--hold"]].concat(), b"");
    assert!(said.code == 0 && said.output.trim_end().ends_with("-2.50000"), "{said:?}");
}
