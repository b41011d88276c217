//! `plm identify`: what `plm run` has written is identified, the table, the fitted declaration, the page, misuse.

use std::fs;

use super::{Said, folder, plm_in};

/// A mass on a spring, and a throw.
const YARD: &str = "pub Yard {
    param mass: kg;
    param stiffness: N/m = 50 N/m; // of the maker
    param g: m/s^2 = 9.81 m/s^2;
    input push: N = 0 N;
    gravity: g;
    ground { port rail: (0, 0) m; }
    body cart { mass: mass; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 10 cm, locked; start vx: 0 m/s, locked; }
    prismatic rail(ground.rail, cart.shoe) { stiffness: stiffness; drive: push; }
    body ball { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m, locked; }
    output cart.x in mm, ball.y;
}";

const METHOD: [&str; 2] = ["--method", "Dop853:1e-8"];

/// A folder with the declaration, and with the readings of a run of it.
fn measured(name: &str, words: &[&str]) -> std::path::PathBuf {
    let folder = folder();
    fs::write(folder.join("yard.plm"), YARD).unwrap();
    let words = [&["run", "yard.plm", "--until", "0.6", "--every", "0.1", "--csv", name], words].concat();
    let said = plm_in(&folder, &words, b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    folder
}

#[test]
fn what_was_run_is_identified() {
    let folder = measured("a.csv", &["--set", "mass=2kg", "--set", "stiffness=60", "--set", "g=9.7"]);
    let files = ["--out", "out/found.plm", "--view", "a.html", "--chart", "a.svg"];
    let words = ["identify", "yard.plm", "--csv", "a.csv", "--fit", "stiffness,ball.vy=0.1m/s", "--fit", "g"];
    let more = ["--set", "mass=2kg", "--only", "cart.x,ball.y", "--bounds", "stiffness=1N/m.."];
    let said = plm_in(&folder, &[&words[..], &more, &METHOD, &files].concat(), b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let lines: Vec<Vec<&str>> = said.output.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines[0], ["unknown", "value", "deviation", "unit", "correlation"]);
    let value = |line: usize| lines[line][1].parse::<f64>().unwrap();
    for (line, (name, truth, unit)) in
        [("stiffness", 60.0, "N/m"), ("ball.vy", 0.0, "m/s"), ("g", 9.7, "m/s^2")].into_iter().enumerate()
    {
        let own = &lines[line + 1];
        assert_eq!((own[0], own[3]), (name, unit), "{}", said.output);
        assert!((value(line + 1) - truth).abs() < 1e-5, "{}", said.output);
    }
    // Spring and throw do not touch each other; speed and gravity of the throw do.
    assert!(
        lines[2][4].trim_start_matches('-') == "0.000" && lines[3][5].parse::<f64>().unwrap() > 0.9,
        "{}",
        said.output
    );

    let found = fs::read_to_string(folder.join("out/found.plm")).unwrap();
    let of = |start: &str, end: &str| {
        let (_, rest) = found.split_once(start).unwrap();
        rest.split_once(end).unwrap().0.parse::<f64>().unwrap()
    };
    assert!((of("stiffness: N/m = ", " N/m; // of the maker") - 60.0).abs() < 1e-6, "{found}");
    assert!((of("g: m/s^2 = ", " m/s^2;") - 9.7).abs() < 1e-6, "{found}");
    assert!(of("start vy: ", " m/s; }").abs() < 1e-6, "{found}");
    let again = ["run", "out/found.plm", "--until", "0.6", "--set", "mass=2"];
    assert_eq!(plm_in(&folder, &again, b"").code, 0, "{found}");
    let chart = fs::read_to_string(folder.join("a.svg")).unwrap();
    assert!(chart.contains("model - reading"), "{chart}");
    let page = fs::read_to_string(folder.join("a.html")).unwrap();
    assert!(page.len() > 50_000);
}

/// Of a swing that nothing drives the readings tell the ratio of stiffness and mass alone.
#[test]
fn what_is_not_told_is_named() {
    let folder = measured("a.csv", &["--set", "mass=2kg"]);
    let words = ["identify", "yard.plm", "--csv", "a.csv", "--fit", "mass=2.1,stiffness", "--only", "cart.x"];
    let said = plm_in(&folder, &[&words[..], &METHOD].concat(), b"");
    assert_eq!(said.code, 3, "{said:?}");
    assert!(said.errors.contains("plm: no reading changes with "), "{said:?}");
    assert!(
        said.output.contains("no reading changes with ") && said.output.contains(" together\n"),
        "{said:?}"
    );
    assert!(said.output.contains("not told"), "{said:?}");
    // What is known of the mass beforehand tells both.
    let expected = ["--expected", "mass=2kg..1gram", "--deviation", "cart.x=1e-6m"];
    let said = plm_in(&folder, &[&words[..], &METHOD, &expected].concat(), b"");
    let mass = said.output.lines().find(|line| line.starts_with("mass ")).unwrap();
    let words: Vec<&str> = mass.split_whitespace().collect();
    assert!((words[1].parse::<f64>().unwrap() - 2.0).abs() < 1e-4, "{said:?}");
    assert_eq!(words[2..4], ["0.00100", "kg"], "{said:?}");
}

/// Two experiments, one of which is pushed; each has a start of its own.
#[test]
fn several_experiments() {
    let folder = measured("a.csv", &["--set", "mass=2kg", "--input", "push=0"]);
    let table = fs::read_to_string(folder.join("a.csv")).unwrap();
    assert!(table.starts_with("time (s),cart.x (mm),ball.y (m)"), "{table}");
    let words = [
        "identify",
        "yard.plm",
        "--csv",
        "a.csv",
        "--csv",
        "a.csv",
        "--fit",
        "stiffness",
        "--each",
        "cart.x=9cm",
    ];
    let more = ["--set", "mass=2kg", "--only", "cart.x", "--input", "push=0 N"];
    let said = plm_in(&folder, &[&words[..], &more, &METHOD].concat(), b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    for number in 0..2 {
        let line =
            said.output.lines().find(|line| line.starts_with(&format!("cart.x (experiment {number})")));
        let value = line.unwrap().split_whitespace().nth(3).unwrap().parse::<f64>().unwrap();
        assert!((value - 0.1).abs() < 1e-6, "{said:?}");
    }
}

/// Readings are in the units of who has read them.
#[test]
fn readings_in_other_units() {
    let folder = measured("a.csv", &["--set", "mass=2kg", "--set", "stiffness=60"]);
    let table = fs::read_to_string(folder.join("a.csv")).unwrap();
    let mut lines = table.lines().map(|line| line.split(',').take(2).collect::<Vec<_>>());
    assert_eq!(lines.next().unwrap(), ["time (s)", "cart.x (mm)"]);
    let rows = lines.map(|line| format!("{},{}\n", line[0], line[1].parse::<f64>().unwrap() / 10.0));
    fs::write(folder.join("cm.csv"), "time (s),cart.x (cm)\n".to_owned() + &rows.collect::<String>())
        .unwrap();
    let words = ["identify", "yard.plm", "--csv", "cm.csv", "--fit", "stiffness", "--set", "mass=2kg"];
    let said = plm_in(&folder, &[&words[..], &METHOD].concat(), b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let line = said.output.lines().find(|line| line.starts_with("stiffness ")).unwrap();
    let value = line.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap();
    assert!((value - 60.0).abs() < 1e-5, "{said:?}");
    assert!(said.output.contains(" cm"), "{said:?}");
}

/// A mass that a damper stops, and what is read of it.
const DAMPED: &str = "pub P {
    param c: N*s/m = 1 N*s/m;
    ground { port o: (0, 0) m; }
    body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start vx: 1 m/s, locked; }
    prismatic r(ground.o, b.o) { damping: c; }
    output b.x;
}";

/// A damping that the first step takes below zero is found, not its guess (issue 47); a bound that holds is told, with a code of its own.
#[test]
fn issue_047_bounds_hold_where_they_are_reached() {
    let folder = folder();
    fs::write(folder.join("p.plm"), DAMPED).unwrap();
    fs::write(folder.join("free.csv"), "time (s),b.x (m)\n0.5,0.4999\n1.0,0.9999\n").unwrap();
    fs::write(folder.join("held.csv"), "time (s),b.x (m)\n0.5,0.51\n1.0,1.01\n1.5,1.51\n").unwrap();
    let run = |csv: &str, fit: &str| {
        plm_in(&folder, &["identify", "p.plm", "--csv", csv, "--fit", fit, "--bounds", "c=0.."], b"")
    };
    for guess in ["c", "c=0", "c=1e-3", "c=30"] {
        let said = run("free.csv", guess);
        assert_eq!((said.code, said.errors.as_str()), (0, ""), "{guess}: {said:?}");
        assert!(said.output.contains("c        0.000235315  0.000141"), "{guess}: {said:?}");
        let said = run("held.csv", guess);
        let told = "plm: c ends at its bound, 0.00000 N*s/m: the bound may be what holds it\n";
        assert_eq!((said.code, said.errors.as_str()), (3, told), "{guess}: {said:?}");
    }
}

/// A frequency far from that of the readings leaves them as they are: that is told.
#[test]
fn a_false_valley_is_told() {
    let folder = measured("a.csv", &["--set", "mass=2kg", "--set", "stiffness=5000", "--every", "0.01"]);
    let words = ["identify", "yard.plm", "--csv", "a.csv", "--only", "cart.x", "--set", "mass=2kg", "--fit"];
    let said = plm_in(&folder, &[&words[..], &["stiffness=300"], &METHOD].concat(), b"");
    assert_eq!(said.code, 3, "{said:?}");
    assert!(said.errors.starts_with("plm: the model does not follow cart.x in experiment 0: "), "{said:?}");
    let said = plm_in(&folder, &[&words[..], &["stiffness=4800"], &METHOD].concat(), b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""), "{said:?}");
}

/// Readings whose clock does not begin with the motion; a reading that is wrong, and what is no reading.
#[test]
fn readings_as_instruments_have_them() {
    let folder = folder();
    fs::write(folder.join("p.plm"), DAMPED).unwrap();
    let x = |c: f64, t: f64| (1.0 - (-c * t).exp()) / c;
    let table = |first: f64, wrong: f64| {
        let rows = (0..40).map(|k| {
            let t = 0.05 * f64::from(k);
            let noise = 1e-4 * f64::from((7 * k) % 5 - 2);
            format!("{:?};{:?}\n", first + t, x(0.8, t) + noise + if k == 30 { wrong } else { 0.0 })
        });
        format!("sep=;\nZeit [s];b.x(m)\n{}", rows.collect::<String>())
            .replace('.', ",")
            .replace("b,x", "b.x")
    };
    let run = |words: &[&str]| {
        plm_in(&folder, &[&["identify", "p.plm", "--fit", "c", "--csv"], words].concat(), b"")
    };
    let value = |said: &Said| {
        let line = said.output.lines().nth(1).unwrap();
        line.split_whitespace().nth(1).unwrap().parse::<f64>().unwrap()
    };
    fs::write(folder.join("late.csv"), table(100.0, 0.0)).unwrap();
    let said = run(&["late.csv", "--from", "first"]);
    assert!(said.code == 0 && (value(&said) - 0.8).abs() < 1e-3, "{said:?}");
    assert!(said.errors.is_empty(), "{said:?}");
    let said = run(&["late.csv", "--from", "100s"]);
    assert!(said.code == 0 && (value(&said) - 0.8).abs() < 1e-3, "{said:?}");
    let said = run(&["late.csv"]);
    assert!(said.errors.contains("late.csv begins at 100 s, and the run at 0 s: "), "{said:?}");
    assert!(said.errors.contains("`--from first`"), "{said:?}");

    // One wrong reading pulls squares, and Huber's loss little; it is the one that is named.
    fs::write(folder.join("wrong.csv"), table(0.0, 0.5)).unwrap();
    let squares = run(&["wrong.csv"]);
    assert!((value(&squares) - 0.8).abs() > 0.01, "{squares:?}");
    let huber = run(&["wrong.csv", "--loss", "huber"]);
    assert!((value(&huber) - 0.8).abs() < 1e-3, "{huber:?}");
    assert!(
        huber.output.contains("the farthest reading is b.x at 1.5 s of experiment 0: off by 0.5"),
        "{huber:?}"
    );

    fs::write(folder.join("inf.csv"), "time (s),b.x (m)\n0.5,0.5\n1.0,inf\n").unwrap();
    fs::write(folder.join("twice.csv"), "time (s),b.x (m),b.x (mm)\n0.5,0.5,500\n1.0,0.9,900\n").unwrap();
    for (file, told) in [
        ("inf.csv", "experiment 0: `b.x` is inf m at 1 s: a reading is a number, or NaN where there is none"),
        ("twice.csv", "experiment 0: `b.x` is measured twice: one of its columns is to be left out"),
    ] {
        let said = run(&[file]);
        assert!(said.code == 2 && said.errors.contains(told), "{said:?}");
    }
    for (words, told) in [
        (["free.csv", "--from", "1kg"], "--from: 1 kg is a mass (kg), and a time (s) is wanted"),
        (["free.csv", "--loss", "hubert"], "--loss wants Squares, Huber or Huber:NUMBER, not `hubert`"),
    ] {
        let said = run(&words);
        assert!(said.code == 2 && said.errors.contains(told), "{said:?}");
    }
}

#[test]
fn misuse_is_told_what_was_meant() {
    let folder = measured("a.csv", &["--set", "mass=2kg"]);
    let run = |words: &[&str]| plm_in(&folder, &[&["identify", "yard.plm"], words].concat(), b"");
    let all = ["--csv", "a.csv", "--set", "mass=2", "--fit"];
    let with = |words: &[&'static str]| [&all[..], words].concat();
    fs::write(folder.join("wrong.csv"), "time (s),cart.x (mm)\n0,100\n0.1,1OO\n").unwrap();
    fs::write(folder.join("other.csv"), "time (s),cart.z (mm)\n0,100\n0.1,90\n").unwrap();
    fs::write(folder.join("unit.csv"), "time (s),cart.x (kg)\n0,10\n0.1,9\n").unwrap();
    for (words, message) in [
        (vec!["--sett", "mass=2", "--fit", "g"], "there is no option --sett; `--set` is one\n"),
        (vec!["--fit", "g"], "an identification needs readings: `--csv FILE`"),
        (vec!["--csv", "a.csv"], "an identification needs unknowns: `--fit NAMES`"),
        (with(&["gg"]), "--fit: there is no parameter or start value `gg`; there are mass, stiffness, g, "),
        (with(&["g,mass,g"]), "`g` is one unknown, and is given twice"),
        (with(&["g", "--each", "g"]), "`g` is one unknown, and is given twice"),
        (with(&["g=1 m"]), "--fit g: 1 m is a length (m), and an acceleration (m/s^2) is wanted"),
        (with(&["g", "--bounds", "mass=1..2"]), "--bounds: there is no `mass`; there are g"),
        (
            with(&["g", "--bounds", "g=1"]),
            "--bounds wants two values, as in `--bounds k=1N/m..5N/m`, not `g=1`",
        ),
        (with(&["g", "--bounds", "g=2..1"]), "begins at 9.81 within 2 and 1"),
        (with(&["g", "--deviation", "cart.x=0"]), "--deviation cart.x wants a positive value, not `0`"),
        (
            with(&["g", "--deviation", "cart.x=1kg"]),
            "--deviation cart.x: 1 kg is a mass (kg), and a length (m) is wanted",
        ),
        (with(&["g", "--only", "cart.z"]), "--only: there is no `cart.z`; there are cart.x, ball.y"),
        (with(&["g", "--segments", "0"]), "--segments wants a positive whole number, not `0`"),
        (with(&["g", "--method", "Rk4:1e-3"]), "an identification runs by Dop853 or RadauIia5"),
        (
            vec!["--csv", "a.csv", "--fit", "g"],
            "the parameter `mass` has no default: it must be given, by `--set mass=VALUE`",
        ),
        (vec!["--csv", "none.csv", "--fit", "g", "--set", "mass=2"], "none.csv"),
        (
            vec!["--csv", "wrong.csv", "--fit", "g", "--set", "mass=2"],
            "line 3, column 2 (`cart.x (mm)`): found `1OO`, expected a number",
        ),
        (
            vec!["--csv", "other.csv", "--fit", "g", "--set", "mass=2"],
            "there is no output `cart.z`; there are cart.x, ",
        ),
        (
            vec!["--csv", "other.csv", "--fit", "g", "--set", "mass=2"],
            "`--only NAMES` names the columns that are read",
        ),
        (
            vec!["--csv", "unit.csv", "--fit", "g", "--set", "mass=2"],
            "cart.x: 1 kg is a mass (kg), and a length (m) is wanted",
        ),
    ] {
        let said = run(&words);
        assert!(
            said.code == 2 && said.output.is_empty() && said.errors.contains(message),
            "{words:?}: {said:?}"
        );
    }
    // A guess with which there is no run is no misuse.
    let Said { code, errors, .. } = run(&["--csv", "a.csv", "--fit", "mass=-1"]);
    assert!(code == 1 && errors.starts_with("plm: experiment 0 does not run with the guesses: "), "{errors}");
}
