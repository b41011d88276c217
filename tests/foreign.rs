//! Programs of C and C++ run a mechanism by its library: the bits are those of Rust, and wrong calls do nothing.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use plm::view::Version;
use plm::{Described, Dop853, Sim};

#[path = "foreign/suppliers.rs"]
mod suppliers;

plm::mechanism! {
    /// A press: a loop with a slider that rubs and a crank that strikes a buffer, a spring that pushes at once, an input, a state, and a time that
    /// must not be passed.
    pub Press {
        gravity: 9.81 m/s^2;
        /// Of the spring
        /// at the guide.
        param stiff: N/mm = 0.2 N/mm;
        param load: kg = 0.5 kg;
        input push: N = 5 N;
        state level: N = 0;
        rate level = (push - level) / 0.1 s;
        ground { port o: (0, 0) m; port rail: (0, 0) m, axis: 5 deg; }
        body crank { mass: 0.2 kg; inertia: 0.001 kg*m^2; port o: (-0.1, 0) m; port pin: (0.1, 0) m; start angle: 60 deg, locked; }
        body rod { mass: 0.6 kg; inertia: 0.018 kg*m^2; port pin: (-0.3, 0) m; port wrist: (0.3, 0) m; start angle: -17 deg; }
        body slider { mass: load; inertia: 0.001 kg*m^2; port wrist: (0, 0) m; start x: 0.67 m; }
        revolute drive(ground.o, crank.o) { damping: 0.01 N*m*s/rad; }
        revolute crank_pin(crank.pin, rod.pin);
        revolute wrist_pin(rod.wrist, slider.wrist);
        prismatic guide(ground.rail, slider.wrist);
        force spring(slider.wrist) { x: if slider.x > 0.6 m then -stiff*(slider.x - 0.5 m) - level else -level; }
        unilateral buffer: crank.angle <= 300 deg { restitution: 0.7; }
        friction rub: rate(guide.displacement) within 0.1 N;
        require early: t < 20 s;
        output crank.angle in deg, drive.force, slider.x in mm;
    }
}

/// The folder with the library; it is built once for all tests.
fn library() -> &'static Path {
    use std::sync::OnceLock;
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign");
        let library = plm::view::Library::new("machines").with(&Press::new()).unwrap();
        library.with(&mechanisms::Arm::new()).unwrap().write(&folder).unwrap();
        folder
    })
}

/// Is there such a program?
fn is_there(program: &str) -> bool {
    let is_there = Command::new(program).arg("--version").output().is_ok();
    if !is_there {
        println!("skipped: there is no {program}");
    }
    is_there
}

/// The line that compiles a program of `tests/c` with every warning an error, and where the program will be.
fn compiler(compiler: &str, standard: &str, file: &str) -> (Command, PathBuf) {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c").join(file);
    let name = source.file_name().unwrap().to_string_lossy();
    let program = library().join(format!("{compiler}-{name}.out"));
    let mut compile = Command::new(compiler);
    compile.args([standard, "-O2", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]).arg(source);
    compile.arg("-o").arg(&program);
    (compile, program)
}

/// Compiles a program, with further words, and gives where it is; nothing where the compiler is not there.
fn compiled_with(
    [compiler_name, standard, file]: [&str; 3],
    words: impl IntoIterator<Item = OsString>,
) -> Option<PathBuf> {
    let (mut compile, program) = is_there(compiler_name).then(|| compiler(compiler_name, standard, file))?;
    let output = compile.args(words).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    Some(program)
}

/// The same, with the library of all tests.
fn compiled(compiler: &str, standard: &str, file: &str) -> Option<PathBuf> {
    let folder = library();
    let library = [folder.join("libmachines.a").into()];
    compiled_with([compiler, standard, file], included([folder]).chain(library).chain(SYSTEM.map(Into::into)))
}

/// What a static library needs of the system.
const SYSTEM: [&str; 3] = ["-lm", "-lpthread", "-ldl"];

fn included<'a>(folders: impl IntoIterator<Item = &'a Path>) -> impl Iterator<Item = OsString> {
    folders.into_iter().flat_map(|folder| [OsString::from("-I"), folder.into()])
}

/// What a program prints.
fn said(program: &Path, words: &[&Path]) -> String {
    let output = Command::new(program).args(words).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{}: {:?} {text}", program.display(), output.status);
    text
}

fn run(compiler: &str, standard: &str, file: &str) -> Option<String> {
    compiled(compiler, standard, file).map(|program| said(&program, &[]))
}

fn print(sim: &Sim<Press>, text: &mut String) {
    let bits = (0..Press::<f64>::OBSERVED.len()).map(|k| Press::observed(sim.state(), k).unwrap().to_bits());
    let words: Vec<String> = bits.map(|bits| format!("{bits:016x}")).collect();
    writeln!(text, "{}", words.join(" ")).unwrap();
}

/// What `run.c` does; the rows to 700 once.
fn native() -> String {
    let (mut sim, mut text) = (Press::new().start().unwrap(), String::new());
    for k in 0..1000 {
        match k {
            300 => sim.input.push = -7.5,
            500 => sim.mechanism.stiff = 350.0,
            _ => {}
        }
        sim.step(0.001).unwrap();
        print(&sim, &mut text);
    }
    assert!(sim.stats().switches > 0 && sim.stats().renewed == 0, "{:?}", sim.stats());
    let contact = sim.contact_stats();
    assert!(contact.impacts > 0 && contact.sticks + contact.slips > 1, "{contact:?}");
    text
}

#[test]
fn programs_of_c_and_cpp_have_the_bits_of_rust() {
    let native = native();
    for (compiler, standard) in [("gcc", "-std=c99"), ("clang", "-std=c11")] {
        let Some(text) = run(compiler, standard, "run.c") else { continue };
        assert!(text == native, "{compiler} differs from Rust");
    }
    for (compiler, standard) in [("g++", "-std=c++11"), ("clang++", "-std=c++17")] {
        let Some(text) = run(compiler, standard, "run.cpp") else { continue };
        assert!(native.starts_with(&text) && text.lines().count() == 300, "{compiler} differs from Rust");
    }
}

#[test]
fn a_run_of_c_is_saved_to_a_file_and_goes_on_in_another_process() {
    let Some(program) = compiled("gcc", "-std=c99", "save.c") else { return };
    let file = library().join("run.saved");
    let first = said(&program, &[&file]);
    assert_eq!(first.lines().count(), 200);
    assert_eq!(said(&program, &[&file, Path::new("go")]), first);
}

#[test]
fn several_mechanisms_are_in_one_library() {
    let Some(text) = run("gcc", "-std=c99", "two.c") else { return };
    let mut arm = mechanisms::Arm::new().start_with(Dop853::new(1e-5).with_longest_step(0.04)).unwrap();
    let (mut press, mut expected) = (Press::new().start().unwrap(), String::new());
    for _ in 0..100 {
        arm.input.torque = 10.0 * press.crank_angle();
        press.step(0.01).unwrap();
        arm.step(0.01).unwrap();
        writeln!(expected, "{:016x}", arm.arm_angle().to_bits()).unwrap();
    }
    assert_eq!(text, expected);
    let twice =
        plm::view::Library::new("twice").with(&Press::new()).unwrap().with(&Press::new()).unwrap_err();
    let words = "the library has `press` already: each mechanism, and each file, needs a name of its own";
    assert_eq!(twice.to_string(), words);
}

/// Linked with nothing else but what moves bytes: no std, no allocation, no panic that is reached.
#[test]
fn a_library_for_a_microcontroller_links_alone() {
    const TARGET: &str = "thumbv7em-none-eabihf";
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output().unwrap();
    let tools = Path::new(std::str::from_utf8(&sysroot.stdout).unwrap().trim()).join("lib/rustlib");
    let linker = std::fs::read_dir(&tools).unwrap().map(|entry| entry.unwrap().path().join("bin/rust-lld"));
    let linker = linker.into_iter().find(|path| path.exists());
    let Some(linker) = linker.filter(|_| tools.join(TARGET).exists()) else {
        println!("skipped: the target is not installed (rustup target add {TARGET})");
        return;
    };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bare");
    let library = plm::view::Library::new("bare").with(&mechanisms::Arm::new()).unwrap();
    let files = library.for_target(TARGET).write(&folder).unwrap();
    let mut link = Command::new(linker);
    link.args(["-flavor", "gnu", "--gc-sections", "--entry", "arm_init"]);
    let functions = [
        "start_at",
        "step",
        "get",
        "set",
        "set_method",
        "rates",
        "linearise",
        "save",
        "restore",
        "text",
        "find",
    ];
    for function in functions {
        link.args(["--undefined", &format!("arm_{function}")]);
    }
    let said = link.arg(&files[0]).arg("-o").arg(folder.join("program")).output().unwrap();
    assert!(said.status.success(), "{}", String::from_utf8_lossy(&said.stderr));
    assert!(folder.join("arm.h").exists());
}

#[test]
fn wrong_calls_of_c_give_a_code_and_change_nothing() {
    let Some(text) = run("gcc", "-std=c99", "bad_use.c") else { return };
    let expected = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c/bad_use.txt");
    if std::env::var_os("PLM_BLESS").is_some() {
        std::fs::write(&expected, &text).unwrap();
    }
    assert_eq!(text, std::fs::read_to_string(expected).unwrap());
}

/// FMPy validates FMUs of both versions, runs them in both modes and compares with Rust; `tests/fmu/check.py` and `two.py` say what
/// they look at.
#[test]
fn fmpy_finds_nothing_wrong_with_an_fmu_and_the_numbers_of_rust() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmu");
    let [file, two, rows] = ["press.fmu", "press2.fmu", "press.csv"].map(|name| folder.join(name));
    plm::view::fmu(&Press::new(), &file).unwrap();
    plm::view::fmu_of(Version::Two, &Press::new(), &two).unwrap();
    let (mut sim, mut text) = (Press::new().start().unwrap(), String::new());
    for k in 0..200 {
        if k == 100 {
            sim.input.push = -7.5;
        }
        let outputs = (0..Press::<f64>::OBSERVED.len()).map(|k| Press::observed(sim.state(), k).unwrap());
        let numbers: Vec<String> = outputs.map(|number| format!("{number:?}")).collect();
        writeln!(text, "{}", numbers.join(",")).unwrap();
        sim.step_to(f64::from(k) * 0.01 + 0.01).unwrap();
    }
    std::fs::write(&rows, text).unwrap();
    let Some(python) = python() else { return };
    let check = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmu/check.py");
    let steps = std::env::var_os("PLM_FMU_STEPS");
    succeeds(Command::new(&python).arg(check).args([&file, &rows]).args(steps));
    let check = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmu/two.py");
    succeeds(Command::new(python).arg(check).args([two, file, rows]));
}

plm::mechanism! {
    /// A box that is thrown on a floor: it bounces, slides, and sticks.
    pub Bounce {
        gravity: 10 m/s^2;
        param e: 1 = 0.5;
        param mu: 1 = 0.2;
        body ball { mass: 1 kg; inertia: 0.1 kg*m^2; port o: (0, 0) m; start y: 1 m, locked; start vx: 3 m/s, locked; }
        constraint upright: ball.angle = 0 rad;
        unilateral floor: ball.o.y >= 0 m { restitution: e; }
        friction rub: rate(ball.o.x) within mu*reaction(floor);
        output ball.o.position, ball.o.velocity;
    }
}

/// By CVode and by Euler's steps; `tests/fmu/contact.py` says what is looked at.
#[test]
fn an_fmu_with_contact_bounces_slides_and_sticks() {
    let Some(python) = python() else { return };
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fmu/bounce.fmu");
    plm::view::fmu(&Bounce::new(), &file).unwrap();
    let check = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fmu/contact.py");
    succeeds(Command::new(python).arg(check).arg(file));
}

#[path = "../examples/co_simulation/mechanisms.rs"]
mod mechanisms;

/// An arm and its controller, coupled by FMPy, converge to the mechanism that has both; `couple.py` says how.
#[test]
fn two_fmus_are_coupled() {
    let Some(python) = python() else { return };
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("co_simulation");
    plm::view::fmu(&mechanisms::Arm::new(), &folder.join("arm.fmu")).unwrap();
    plm::view::fmu(&mechanisms::Controller::new(), &folder.join("controller.fmu")).unwrap();
    let (mut sim, mut rows) = (mechanisms::Whole::new().start().unwrap(), String::new());
    sim.run(3.0, 0.05, |state| writeln!(rows, "{:?},{:?}", state.time(), state.arm_angle()).unwrap())
        .unwrap();
    std::fs::write(folder.join("whole.csv"), rows).unwrap();
    let couple = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/co_simulation/couple.py");
    succeeds(Command::new(python).arg(couple).arg(folder));
}

/// A Python that has FMPy; without one that is said.
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

fn succeeds(command: &mut Command) {
    let output = command.output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    println!("{said}");
}

#[test]
fn a_parameter_without_default_is_told() {
    plm::mechanism! {
        Bar {
            param load: kg;
            ground { port o: (0, 0) m; }
            body bar { mass: load; inertia: 0.1 kg*m^2; port a: (1, 0) m; }
            revolute pin(ground.o, bar.a);
        }
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign-bar");
    let error = plm::view::library(&Bar::new(1.0), &folder).unwrap_err();
    assert_eq!(error.to_string(), "the parameter `load` has no default, and a library needs one");
    assert!(!folder.exists());
}

/// This test is run once more as a program that finds no other ones.
#[test]
fn the_line_that_installs_maturin_is_told_where_it_is_missing() {
    const SELF: &str = "PLM_WITHOUT_MATURIN";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("foreign-wheel");
    if std::env::var_os(SELF).is_some() {
        println!("{}", plm::view::wheel(&Press::new(), &folder).unwrap_err());
        return;
    }
    let name = "the_line_that_installs_maturin_is_told_where_it_is_missing";
    let mut own = Command::new(std::env::current_exe().unwrap());
    let output =
        own.args([name, "--exact", "--nocapture"]).env(SELF, "yes").env("PATH", "").output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    let told = "the wheel cannot be built: maturin is missing; this line installs it: pip install maturin";
    assert!(said.contains(told) && !folder.exists(), "{said}");
}
