//! A wheel of a mechanism, installed and used by Python: `bash tests/python.sh` makes the environment that this needs.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use std::fmt::Write;
use std::path::Path;
use std::process::Command;

use plm::runtime::Statics;
use plm::runtime::method::RadauIia5;
use plm::{Described, Dop853, Method, Rk4, Sim};

plm::mechanism! {
    /// A trolley with a bar that hangs from it.
    ///
    /// Quotes "in" \ text.
    pub Gantry {
        gravity: 9.81 m/s^2;
        /// Of the trolley.
        param mass: kg = 3 kg;
        /// At the start.
        param tilt: deg = 20 deg;
        param load: kg;
        // Names that Python has for itself.
        param lambda: N*m*s/rad = 0.02 N*m*s/rad;
        param run: N/m = 40 N/m;
        param method: N*s/m = 2 N*s/m;
        /// Of the motor.
        input push: N = 0;
        state level: N = 0;
        rate level = (push - level) / 0.1 s;
        ground { port rail: (0, 0) m; }
        body trolley { mass: mass; inertia: 0.1 kg*m^2; port o: (0, 0) m; start x: 0.1 m, locked; }
        body bar { mass: load; inertia: 0.02 kg*m^2; port top: (0, 0.4) m; start angle: tilt, locked; }
        prismatic guide(ground.rail, trolley.o);
        revolute hinge(trolley.o, bar.top) { damping: lambda; }
        force motor(trolley.o) { x: level - run*trolley.x - method*trolley.vx; }
        force stop(trolley.o) { x: if trolley.x > 0.05 m then -90 N/m*(trolley.x - 0.02 m) else 0 N; }
        unilateral wall: trolley.x >= -0.03 m { restitution: 0.5; }
        require near: trolley.x < 2 m;
        output bar.angle in deg, hinge.force, trolley.x in mm;
        observe trolley;
    }
}

/// The environment: Python with NumPy, and maturin; nothing where one is missing, unless somebody names one who must mean it.
fn python() -> Option<String> {
    let named = std::env::var("PLM_PYTHON");
    let python = named.clone().unwrap_or("python3".to_owned());
    for (program, words) in
        [(python.as_str(), ["-c", "import numpy"].as_slice()), ("maturin", &["--version"])]
    {
        if !Command::new(program).args(words).output().is_ok_and(|output| output.status.success()) {
            let missing =
                format!("{program} {} fails here: bash tests/python.sh makes all that", words.join(" "));
            assert!(named.is_err(), "{missing}");
            println!("skipped: {missing}");
            return None;
        }
    }
    Some(python)
}

/// Runs Python on a program of `tests/python` or a module, with what was installed into a folder; it must say nothing is wrong.
fn expect(python: &str, site: &Path, words: &[&str]) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/python");
    let mut command = Command::new(python);
    command.args(words).current_dir(folder).env("PYTHONPATH", site).env("PYTHONDONTWRITEBYTECODE", "1");
    command.env("MYPYPATH", site).env("MYPY_CACHE_DIR", site.with_file_name("mypy"));
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{words:?}\n{said}{}", String::from_utf8_lossy(&output.stderr));
    println!("{said}");
}

fn print(sim: &<Gantry as plm::Mechanism>::State, text: &mut String) {
    let observed = (0..Gantry::<f64>::OBSERVED.len()).map(|k| Gantry::observed(sim, k).unwrap());
    let numbers: Vec<String> = observed.map(|number| format!("{number:?}")).collect();
    writeln!(text, "{}", numbers.join(",")).unwrap();
}

/// A thousand steps with an input and a parameter that change, as `check.py` makes them.
fn steps() -> String {
    let (mut sim, mut text) = (Gantry::new(2.0).start().unwrap(), String::new());
    for k in 0..1000 {
        match k {
            300 => sim.input.push = -7.5,
            500 => sim.mechanism.run = 55.0,
            _ => {}
        }
        sim.step(0.001).unwrap();
        print(sim.state(), &mut text);
    }
    assert!(sim.stats().switches > 0, "{:?}", sim.stats());
    text
}

/// A run by a method, from another start.
fn run<I: Method<Gantry>>(method: I) -> String {
    let mechanism = Gantry { tilt: 0.5, ..Gantry::new(2.0) };
    let mut mechanism = Gantry { start: mechanism.declared_starts(), ..mechanism };
    mechanism.start.trolley.x.value = -0.02;
    let (mut sim, mut text): (Sim<Gantry, I>, _) = (mechanism.start_with(method).unwrap(), String::new());
    sim.run(1.0, 0.01, |state| print(state, &mut text)).unwrap();
    text
}

#[test]
fn a_wheel_is_what_python_expects_with_the_numbers_of_rust() {
    let Some(python) = python() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("python");
    let (site, wheels) = (folder.join("site"), folder.join("wheels"));
    let files = plm::view::wheel(&Gantry::new(f64::NAN), &wheels).unwrap();
    let [wheel, source] = [0, 1].map(|k| files[k].to_string_lossy());
    assert!(wheel.contains("gantry-") && wheel.contains("-cp39-abi3-"), "{wheel}");
    assert!(source.ends_with(".tar.gz"), "{source}");
    let install = ["-m", "pip", "install", "--quiet", "--no-deps", "--no-index", "--upgrade", "--target"];
    expect(&python, &site, &[install.as_slice(), &[&site.to_string_lossy(), &wheel]].concat());
    let rows = [
        ("steps", steps()),
        ("dop853", run(Dop853::new(1e-8))),
        ("radauiia5", run(RadauIia5::new(1e-7))),
        ("rk4", run(Rk4::new(1e-3))),
    ];
    for (name, rows) in rows {
        std::fs::write(folder.join(format!("{name}.csv")), rows).unwrap();
    }
    expect(&python, &site, &["check.py", &folder.to_string_lossy()]);
    expect(&python, &site, &["more.py", &folder.to_string_lossy()]);
    expect(&python, &site, &["package.py", &wheel, &source, env!("CARGO_MANIFEST_DIR")]);
    if Command::new(&python).args(["-c", "import mypy"]).status().is_ok_and(|status| status.success()) {
        expect(&python, &site, &["-m", "mypy", "--strict", "use.py"]);
        expect(&python, &site, &["-m", "mypy.stubtest", "gantry"]);
    } else {
        println!("not checked: {python} has no mypy");
    }
}
