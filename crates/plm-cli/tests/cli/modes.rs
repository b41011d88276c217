//! `plm modes`: frequencies and shapes by closed forms, the page, misuse.

use std::f64::consts::PI;
use std::fs;

use super::{folder, plm, plm_in, root};

/// Three masses between two walls, with four equal springs.
const CHAIN: &str = "pub Chain {
    param k: N/m = 50 N/m;
    ground { port a: (0, 0) m; port b: (1, 0) m; port c: (2, 0) m; }
    body m1 { mass: 2 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; }
    body m2 { mass: 2 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 1 m; }
    body m3 { mass: 2 kg; inertia: 1 kg*m^2; port shoe: (0, 0) m; start x: 2 m; }
    prismatic r1(ground.a, m1.shoe) { drive: k*(r2.displacement - 2*r1.displacement); }
    prismatic r2(ground.b, m2.shoe) { drive: k*(r1.displacement + r3.displacement - 2*r2.displacement); }
    prismatic r3(ground.c, m3.shoe) { drive: k*(r2.displacement - 2*r3.displacement); }
}";

/// Mode j swings with 2 sqrt(k/m) sin(j pi/8), mass i by sin(i j pi/4) (J. W. Strutt, The Theory of Sound, 1877, 120).
#[test]
fn chain_of_three_masses() {
    let folder = folder();
    fs::write(folder.join("chain.plm"), CHAIN).unwrap();
    let said = plm_in(&folder, &["modes", "chain.plm", "--set", "k=200N/m", "--view", "out/a.html"], b"");
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let lines: Vec<&str> = said.output.lines().skip(1).collect();
    assert_eq!(lines.len(), 3, "{}", said.output);
    for (line, j) in lines.iter().zip([1.0, 2.0, 3.0]) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let frequency = 2.0 * f64::sqrt(200.0 / 2.0) * f64::sin(j * PI / 8.0);
        assert!((words[1].parse::<f64>().unwrap() / frequency - 1.0).abs() < 1e-6, "{line}");
        assert!((words[2].parse::<f64>().unwrap() * 2.0 * PI / frequency - 1.0).abs() < 1e-6, "{line}");
        assert!(words[3].parse::<f64>().unwrap().abs() < 1e-9, "{line}");
        let part = |i: u32| -> f64 {
            let (_, rest) = line.split_once(&format!("r{i}.displacement ")).unwrap_or(("", "0,"));
            rest.split([',', ' ']).next().unwrap().parse().unwrap()
        };
        let shape = [1.0, 2.0, 3.0].map(|i: f64| (i * j * PI / 4.0).sin());
        for i in 0..3 {
            let ratio = part(i as u32 + 1) * shape[0] - part(1) * shape[i];
            assert!(ratio.abs() < 2e-3, "{line}");
        }
    }
    assert!(fs::read_to_string(folder.join("out/a.html")).unwrap().len() > 50_000);
}

/// A pendulum that starts at 30 deg hangs at rest: sqrt(m g l/J) = 3.1 rad/s, and a damping of c/(2 J).
#[test]
fn modes_are_those_of_an_equilibrium() {
    let pendulum = "pub Pendulum {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.02 kg*m^2; port o: (0, 1) m; start angle: 30 deg, locked; }
        revolute hinge(ground.o, bob.o) { damping: 0.5 N*m*s/rad; }
    }";
    let folder = folder();
    fs::write(folder.join("a.plm"), pendulum).unwrap();
    let frequency = |words: &[&str]| {
        let said = plm_in(&folder, &[&["modes", "a.plm"], words].concat(), b"");
        assert_eq!((said.code, said.errors.as_str()), (0, ""));
        let words: Vec<f64> = said
            .output
            .lines()
            .nth(1)
            .unwrap()
            .split_whitespace()
            .skip(1)
            .take(3)
            .map(|own| own.parse().unwrap())
            .collect();
        [words[0], words[2]]
    };
    let natural = f64::sqrt(9.81 / 1.02);
    let [found, damping] = frequency(&[]);
    assert!((found / natural - 1.0).abs() < 1e-6 && (damping - 0.5 / (2.0 * 1.02 * natural)).abs() < 1e-4);
    // About the start the torque changes by the cosine.
    let [found, _] = frequency(&["--as-started"]);
    assert!((found / (natural * 30_f64.to_radians().cos().sqrt()) - 1.0).abs() < 1e-6);
}

#[test]
fn the_book_shows_modes() {
    let page = fs::read_to_string(root().join("docs/src/running/command-line.md")).unwrap();
    let (_, declaration) = page.split_once("```plm\n").unwrap();
    let said = plm(&["modes", "-"], declaration.split_once("```").unwrap().0);
    assert!(said.code == 0 && page.contains(&said.output), "{}", said.output);
}

#[test]
fn what_has_no_modes_is_told() {
    let folder = folder();
    let falls = "pub Falls { gravity: 9.81 m/s^2; body a { mass: 1 kg; inertia: 1 kg*m^2; } }";
    fs::write(folder.join("falls.plm"), falls).unwrap();
    let said = plm_in(&folder, &["modes", "falls.plm"], b"");
    assert!(said.code == 1 && said.errors.contains("there is no equilibrium near the start: "), "{said:?}");
    let said = plm_in(&folder, &["modes", "falls.plm", "--as-started", "--view", "a.html"], b"");
    assert!(said.code == 2 && said.errors.contains("no mode oscillates"), "{said:?}");
    let said = plm_in(&folder, &["modes", "none.plm"], b"");
    assert!(said.code == 2 && said.errors.contains("none.plm"), "{said:?}");
}
