//! Programs over a mechanism: options in, files out.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

mod served;

use std::path::Path;

use plm::view::{Options, Program, Results};

plm::mechanism! {
    /// A mass on a spring that must not go too far.
    pub Mass {
        param load: kg = 2 kg;
        param stretch: mm = 100 mm;
        input force: kN = 0;
        ground { port o: (0, 0) m; }
        body mass { mass: load; inertia: 0.1 kg*m^2; port a: (0, 0) m; start x: stretch, locked; }
        prismatic rail(mass.a, ground.o) { stiffness: 200 N/m; drive: 30 N/s*t + force; }
        require within: abs(mass.x) < 0.3 m;
        output mass.x in mm;
    }
}

fn options(folder: &Path, words: &[&str]) -> Options {
    let file = |name: &str| folder.join(name).display().to_string();
    let files = [
        "--out",
        &file("run.npz"),
        "--csv",
        &file("run.csv"),
        "--svg",
        &file("run.svg"),
        "--view",
        &file("run.html"),
    ];
    Options::parse(files.iter().chain(words).copied()).unwrap()
}

#[test]
fn a_run_is_written_in_every_form() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program");
    let words = ["--until", "0.5", "--every", "0.01", "--set", "load=3", "--set", "stretch=120"];
    Program::new(Mass::new()).with(&options(&folder, &words)).unwrap();
    let run = &Results::read(folder.join("run.npz")).unwrap().runs[0];
    assert_eq!((run.len(), run.times()[50]), (51, 0.5));
    let parameters = &run.about.mechanism.parameters;
    assert_eq!([parameters[0].value, parameters[1].value], [3.0, 0.12]);
    // The start is made of the parameter.
    assert_eq!(run.poses(0)[0][0], 0.12);
    let table = std::fs::read_to_string(folder.join("run.csv")).unwrap();
    assert!(table.lines().count() == 52);
    // In the unit of the declaration, which the heading says.
    assert!(table.starts_with("time (s),mass.x (mm)"), "{table:.80}");
    let millimetres = run.rows().next().unwrap()[0];
    assert_eq!((run.columns()[0].unit.as_str(), millimetres), ("mm", 120.0));
    for (file, begins) in [("run.svg", "<svg"), ("run.html", "<!doctype html>")] {
        assert!(std::fs::read_to_string(folder.join(file)).unwrap().contains(begins), "{file}");
    }
}

#[test]
fn a_start_that_was_set_by_hand_does_not_follow_a_parameter() {
    let mut mechanism = Mass::new();
    mechanism.start.mass.x.value = 0.05;
    Options::parse(["--set", "stretch=120"]).unwrap().apply(&mut mechanism).unwrap();
    assert_eq!((mechanism.stretch, mechanism.start.mass.x.value), (0.12, 0.05));
}

/// What is set in a unit is the number that a declaration would have.
#[test]
fn a_number_in_a_unit_is_the_nearest_in_si() {
    for tenths in 1..5000_u32 {
        let text = format!("{}.{}", tenths / 10, tenths % 10);
        let mut mechanism = Mass::new();
        Options::parse(["--set", &format!("stretch={text}")]).unwrap().apply(&mut mechanism).unwrap();
        // The same digits, read as metres. A tenth that is no dyadic number may be off by its own rounding.
        let exact: f64 = format!("{text}e-3").parse().unwrap();
        let allowed = if tenths % 10 == 0 { 0.0 } else { exact * f64::EPSILON };
        assert!((mechanism.stretch - exact).abs() <= allowed, "{text} mm: {:?} {exact:?}", mechanism.stretch);
    }
    let mut mechanism = Mass::new();
    Options::parse(["--set", "stretch=350"]).unwrap().apply(&mut mechanism).unwrap();
    assert_eq!(mechanism.stretch.to_bits(), 0.35_f64.to_bits());
}

/// An undamped oscillator under a ramp and a constant force, in closed form: m x'' = -k x + r t + f.
#[test]
fn inputs_and_the_method_are_set() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program-method");
    for (method, told, allowed) in [
        ("Dop853:1e-10", "Dop853, relative tolerance 1e-10", 1e-9),
        ("dopri5:1e-8", "Dopri5, relative tolerance 1e-8", 1e-7),
        ("RadauIia5:1e-8", "RadauIia5, relative tolerance 1e-8", 1e-7),
        // Steps h of methods of the orders 4, 1, 4, 6, 3, at a frequency of 10/s over five radians.
        ("rk4:1e-3", "Rk4", 1e-8),
        ("semiimpliciteuler:1e-4", "SemiImplicitEuler", 1e-3),
        ("gauss2:1e-3", "Gauss", 1e-8),
        ("gauss3:1e-3", "Gauss", 1e-10),
        ("ros34pw2:1e-3", "Ros34Pw2", 1e-5),
    ] {
        let words = ["--until", "0.5", "--every", "0.5", "--input", "force=-0.01", "--method", method];
        Program::new(Mass::new()).with(&options(&folder, &words)).unwrap();
        let run = &Results::read(folder.join("run.npz")).unwrap().runs[0];
        let (m, k, r, f, t) = (2.0, 200.0, 30.0, -10.0, 0.5);
        let w = f64::sqrt(k / m);
        // The joint drives the ground, so that the mass feels the opposite.
        let (r, f) = (-r, -f);
        let exact = (0.1 - f / k) * f64::cos(w * t) - r / (k * w) * f64::sin(w * t) + (r * t + f) / k;
        let found = run.poses(1)[0][0];
        assert!((found - exact).abs() < allowed, "{method}: {found} {exact}");
        assert_eq!(run.about.method, told);
    }
}

/// Nothing is lost: what came before the fault stands in every file, and the fault in the results.
#[test]
fn a_fault_ends_the_program_and_loses_nothing() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program-fault");
    let error = Program::new(Mass::new()).with(&options(&folder, &["--until", "10"])).unwrap_err();
    assert!(error.to_string().contains("within"), "{error}");
    let run = &Results::read(folder.join("run.npz")).unwrap().runs[0];
    let fault = run.about.fault.as_ref().unwrap();
    assert_eq!(fault.part, "within");
    assert!(run.len() > 10 && run.times()[run.len() - 1] <= fault.time, "{} {fault:?}", run.len());
    assert!(folder.join("run.html").exists());
}

#[test]
fn a_parameter_that_is_not_there_is_told_with_those_that_are() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program-name");
    let error = Program::new(Mass::new()).with(&options(&folder, &["--set", "mass=3"])).unwrap_err();
    assert_eq!(error.to_string(), "there is no parameter `mass`; there are load (kg), stretch (mm)");
}

#[test]
fn an_input_that_is_not_there_is_told_with_those_that_are() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program-input");
    let error = Program::new(Mass::new()).with(&options(&folder, &["--input", "forces=3"])).unwrap_err();
    assert_eq!(error.to_string(), "there is no input `forces`; is `force` meant? there are force (kN)");
}

/// C source of a compiled mechanism has the text of that of its declaration, with parameters and start values set.
#[test]
fn a_c_source_has_the_numbers_of_the_mechanism() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("program-c-source");
    let words = ["--c-source", folder.to_str().unwrap(), "--set", "load=3", "--set", "stretch=120"];
    Program::new(Mass::new()).with(&Options::parse(words).unwrap()).unwrap();
    let source = std::fs::read_to_string(folder.join("mass.c")).unwrap();
    let mut text = plm::dynamic::Mechanism::from_text(<Mass as plm::Described>::DECLARATION).unwrap();
    text.set_parameter("load", 3.0).unwrap();
    text.set_parameter("stretch", 0.12).unwrap();
    // The start is made of the parameter, and stands in the source as a constant.
    let start = text.steps().unwrap().numbers();
    assert_eq!((start.x[0].abs(), start.parameters[0]), (0.12, 3.0));
    assert!(source.contains("self->parameter[0] = PLM_C(3.0);"), "{source}");
    assert!(source.contains("PLM_C(0x1.eb851eb851eb8p-4)"), "{source}");
    // One that was set by hand does not follow it; the rail goes from the mass to the ground.
    let mut by_hand = Mass::new();
    by_hand.start.mass.x.value = 0.25;
    let written = plm::view::c_source(&by_hand, plm::view::Precision::Single, &folder).unwrap();
    assert_eq!(
        written.iter().map(|path| path.file_name().unwrap()).collect::<Vec<_>>(),
        ["mass.h", "mass.c", "plm_math.h"]
    );
    let source = std::fs::read_to_string(&written[1]).unwrap();
    assert!(
        source.contains("#define PLM_SINGLE 1") && source.contains("self->x[0] = (-PLM_C(0x1p-2));"),
        "{source}"
    );
    for (words, why) in [
        (
            ["--c-source", "c", "--until", "1"].as_slice(),
            "--c-source writes source and runs nothing: without --until",
        ),
        (&["--c-source", "c", "--fmu", "a.fmu"], "without --fmu"),
        (&["--single"], "with --c-source"),
    ] {
        let said = Options::parse(words).unwrap_err().to_string();
        assert!(said.contains(why), "{said}");
    }
}
