//! Libraries of two suppliers in one program, and what C and C++ choose of how a mechanism runs.

use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use plm::foreign::By;
use plm::{Dop853, Mechanism, Rk4};

use super::{Press, SYSTEM, compiled_with, included, is_there, library, said, succeeds};

/// The folder with the library of another supplier, who calls a mechanism `Press` too: by several methods, and of single
/// precision; static, and shared below `shared`.
fn of_another_supplier() -> &'static Path {
    use std::sync::OnceLock;
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("supplier");
        let library = plm::view::Library::new("supplier").with(&book::Pendulum::new()).unwrap();
        let library = library.prefixed("acme").by(&[By::Rk4, By::RadauIia5]);
        let library = library.with(&other::Press::new()).unwrap();
        let library = library.prefixed("single").by(&[By::Rk4]).with(&other::Press::<f32>::of()).unwrap();
        library.write(&folder).unwrap();
        library.shared().write(&folder.join("shared")).unwrap();
        folder
    })
}

mod book {
    plm::mechanism! {
        /// A bar on a pin.
        pub Pendulum {
            gravity: 9.81 m/s^2;
            emit: step(rk4);
            /// Of the bearing.
            param friction: N*m*s/rad = 0.1 N*m*s/rad;
            input drive: N*m = 0;
            ground { port o: (0, 0) m; }
            body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port pivot: (0, 0.4) m; start angle: 30 deg, locked; }
            revolute hinge(ground.o, bar.pivot) { damping: friction; drive: drive; }
            output bar.angle, hinge.force;
        }
    }
}

mod other {
    plm::mechanism! {
        /// A cart on a spring, with a lag.
        pub Press {
            emit: step(rk4, linearly_implicit);
            param stiff: N/m = 40 N/m;
            input push: N = 1 N;
            state lag: N = 0;
            rate lag = (push - lag)/0.05 s;
            ground { port o: (0, 0) m; }
            body cart { mass: 2 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; start x: 0.1 m; }
            prismatic rail(cart.a, ground.o) { stiffness: stiff; damping: 0.4 N*s/m; }
            force drive(cart.a) { x: lag; }
            output cart.x in mm, cart.vx;
        }
    }
}

/// What `suppliers.c` prints: the arm follows the cart, both in steps of 10 ms.
fn of_suppliers() -> String {
    let mut first = Press::new().start().unwrap();
    let mut second = other::Press::new().start_at(2.5, Rk4::new(1e-3)).unwrap();
    let mut single = *other::Press::<f32>::of().start().unwrap().state();
    let mut text = String::new();
    for _ in 0..100 {
        second.input.push = 10.0 * first.crank_angle();
        single.input.push = first.crank_angle() as f32;
        first.step(0.01).unwrap();
        second.step(0.01).unwrap();
        single.step_rk4(0.01).unwrap();
        let [one, two] = [first.crank_angle(), second.cart().x].map(f64::to_bits);
        writeln!(text, "{one:016x} {two:016x} {:08x}", single.cart().x.to_bits()).unwrap();
    }
    text
}

/// Two static libraries, a static and a shared one, and a program of C++ that is told of them by pkg-config.
#[test]
fn libraries_of_two_suppliers_are_in_one_program() {
    let (own, theirs, expected) = (library(), of_another_supplier(), of_suppliers());
    let (mine, system) = (own.join("libmachines.a"), SYSTEM.map(OsString::from));
    for compiler in ["gcc", "clang"] {
        let words = |other: &[OsString]| {
            let libraries = [mine.clone().into()].into_iter().chain(other.to_vec());
            included([own, theirs]).chain(libraries).chain(system.clone()).collect::<Vec<_>>()
        };
        let archive = [theirs.join("libsupplier.a").into()];
        let Some(program) = compiled_with([compiler, "-std=c99", "suppliers.c"], words(&archive)) else {
            continue;
        };
        assert!(said(&program, &[]) == expected, "{compiler}: two static libraries differ from Rust");
        let shared = theirs.join("shared");
        let by_name = |word: &str| OsString::from(format!("{word}{}", shared.display()));
        let shared = [by_name("-L"), "-lsupplier".into(), by_name("-Wl,-rpath,")];
        let program = compiled_with([compiler, "-std=c99", "suppliers.c"], words(&shared)).unwrap();
        assert!(
            said(&program, &[]) == expected,
            "{compiler}: a static and a shared library differ from Rust"
        );
    }
}

/// Nothing of Rust is seen from outside.
#[test]
fn a_library_shows_its_functions_alone() {
    let (folder, own) = (of_another_supplier(), ["pendulum_", "acme_press_", "single_press_"]);
    for (words, file) in
        [(["-g", "--defined-only"], "libsupplier.a"), (["-D", "--defined-only"], "shared/libsupplier.so")]
    {
        let output = Command::new("nm").args(words).arg(folder.join(file)).output();
        let Ok(output) = output else { return println!("skipped: there is no nm") };
        let text = String::from_utf8(output.stdout).unwrap();
        let seen = text.lines().filter_map(|line| line.split(' ').nth(2)).collect::<Vec<_>>();
        assert!(seen.len() > 50, "{text}");
        let is_own = |name: &&str| own.iter().any(|own| name.starts_with(own));
        let strange: Vec<_> = seen.into_iter().filter(|name| !is_own(name)).collect();
        assert!(strange.is_empty(), "{file}: {strange:?}");
    }
}

/// Methods, steps by themselves, single precision, a start at a time, rates, a linearisation: by the classes of C++, which
/// pkg-config finds.
#[test]
fn a_program_of_cpp_chooses_how_a_mechanism_runs() {
    let (own, theirs) = (library(), of_another_supplier());
    let mut expected = String::new();
    let system = plm::linearise(&Press::new().start_at(1.5, Dop853::new(1e-9)).unwrap()).unwrap();
    for entry in system.a.transpose().iter().chain(system.b.iter()) {
        writeln!(expected, "{entry:.9e}").unwrap();
    }
    let (mut cart, mut stiff) = (other::Press::new(), other::Press::new());
    (cart.stiff, stiff.stiff) = (50.0, 50.0);
    let mut alone = *cart.start_at(0.5, Rk4::new(0.01)).unwrap().state();
    let mut stiff = stiff.start_at(0.5, plm::RadauIia5::new(1e-7)).unwrap();
    for _ in 0..50 {
        alone.step_linearly_implicit(0.01).unwrap();
        stiff.step(0.01).unwrap();
        writeln!(expected, "{:016x} {:016x}", alone.cart().x.to_bits(), stiff.cart().x.to_bits()).unwrap();
    }
    for compiler in ["g++", "clang++"] {
        let found = told_by_pkg_config(&[own, theirs]);
        let Some(words) = found else { return };
        let Some(program) = compiled_with([compiler, "-std=c++11", "choices.cpp"], words) else { continue };
        let text = said(&program, &[]);
        let (numbers, bits): (Vec<&str>, Vec<&str>) =
            text.lines().partition(|line| line.contains('e') && !line.contains(' '));
        let (theirs, their_bits): (Vec<&str>, Vec<&str>) =
            expected.lines().partition(|line| line.contains('e') && !line.contains(' '));
        assert_eq!(bits, their_bits, "{compiler}");
        assert_eq!(numbers.len(), theirs.len(), "{compiler}");
        for (ours, theirs) in numbers.iter().zip(theirs) {
            let [ours, theirs] = [ours, &theirs].map(|text| text.parse::<f64>().unwrap());
            assert!((ours - theirs).abs() <= 1e-6 * (1.0 + theirs.abs()), "{compiler}: {ours} {theirs}");
        }
    }
}

/// What pkg-config says of the libraries in some folders.
fn told_by_pkg_config(folders: &[&Path]) -> Option<Vec<OsString>> {
    if !is_there("pkg-config") {
        return None;
    }
    let path = std::env::join_paths(folders).unwrap();
    let mut ask = Command::new("pkg-config");
    ask.args(["--cflags", "--libs", "machines", "supplier"]).env("PKG_CONFIG_PATH", path);
    let output = ask.output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8(output.stdout).unwrap();
    Some(said.split_whitespace().map(OsString::from).collect())
}

/// CMake finds both libraries.
#[test]
fn cmake_finds_libraries() {
    if !is_there("cmake") {
        return;
    }
    let (own, theirs) = (library(), of_another_supplier());
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("cmake");
    let _ = std::fs::remove_dir_all(&folder);
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c");
    let path = |name: &str, folder: &Path| format!("-D{name}_DIR={}", folder.display());
    let mut configure = Command::new("cmake");
    succeeds(
        configure
            .arg("-S")
            .arg(source)
            .arg("-B")
            .arg(&folder)
            .args([path("machines", own), path("supplier", theirs)]),
    );
    succeeds(Command::new("cmake").arg("--build").arg(&folder));
    assert!(said(&folder.join("suppliers"), &[]) == of_suppliers());
}

/// Programs of the book, of its pendulum: they are compiled as they stand there, and print what Rust computes.
#[test]
fn programs_of_the_book_run() {
    let page =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src/running/c.md")).unwrap();
    // Without spaces and documentation.
    let plain = |text: &str| text.split_whitespace().collect::<String>();
    let code: String = page.lines().filter(|line| !line.trim().starts_with("///")).map(plain).collect();
    let declared = plain(<book::Pendulum as plm::Described>::DECLARATION);
    let declared = declared.split("#[doc=\"").enumerate();
    let declaration: String =
        declared.map(|(k, rest)| if k == 0 { rest } else { rest.split_once("\"]").unwrap().1 }).collect();
    assert!(code.contains(&declaration), "the book has another declaration: {declaration}");
    let folder = of_another_supplier();
    let (mut blocks, mut printed) = (Vec::new(), Vec::new());
    for (begin, ending, compiler, standard) in
        [("```c\n", "c", "gcc", "-std=c99"), ("```cpp\n", "cpp", "g++", "-std=c++11")]
    {
        for block in page.split(begin).skip(1) {
            let file = folder.join(format!("book_{}.{ending}", blocks.len()));
            std::fs::write(&file, block.split("```").next().unwrap()).unwrap();
            blocks.push(file.clone());
            let file = file.to_str().unwrap();
            let library = [folder.join("libsupplier.a").into()];
            let words = included([folder]).chain(library).chain(SYSTEM.map(Into::into));
            let Some(program) = compiled_with([compiler, standard, file], words) else { continue };
            printed.push(said(&program, &[]));
        }
    }
    assert_eq!(blocks.len(), 3);
    if printed.len() == 3 {
        assert_eq!(printed, of_the_book());
    }
}

fn of_the_book() -> [String; 3] {
    let mut sim = book::Pendulum::new().start().unwrap();
    sim.mechanism.friction = 0.3;
    for k in 0..100 {
        sim.input.drive = if k < 50 { 1.0 } else { 0.0 };
        sim.step(0.01).unwrap();
    }
    let first = format!("{:.6} rad\n", sim.bar().angle);
    let mut state = *book::Pendulum::new().start_at(10.0, Dop853::new(1e-9)).unwrap().state();
    let mut angle = 0.0;
    for _ in 0..1000 {
        angle = state.bar().angle;
        state.input.drive = -20.0 * angle;
        state.step_rk4(0.001).unwrap();
    }
    // About the pin: I = 0.1 + 2 * 0.4^2.
    let (bar, drive) = (state.bar(), state.input.drive);
    let moment = drive - 0.1 * bar.omega - 2.0 * 9.81 * 0.4 * f64::sin(bar.angle);
    let second = format!("{angle:.6} rad, {:.6} rad/s^2\n", moment / 0.42);
    let mut hanging = book::Pendulum { friction: 0.3, ..book::Pendulum::new() };
    hanging.start.bar.angle.value = 0.0;
    let mut sim = hanging.start().unwrap();
    sim.input.drive = 1.0;
    sim.step(0.5).unwrap();
    let mut other = *sim.state();
    other.step_rk4(1e-3).unwrap();
    let frequency = f64::sqrt(2.0 * 9.81 * 0.4 / 0.42);
    let third = format!("{frequency:.6} rad/s\n{:.6} rad, {:.6} rad\n", sim.bar().angle, other.bar().angle);
    [first, second, third]
}
