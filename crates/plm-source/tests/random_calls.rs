//! Random calls of sources that trap where C leaves undefined what happens: calls of any number, with special numbers half of the time.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test ends where something is missing")]

#[path = "support/scenes.rs"]
mod scenes;

use std::fs;
use std::path::Path;
use std::process::Command;

use plm_dynamic::Mechanism;
use plm_source::Precision;
use scenes::scenes;

const CALLS: &str = include_str!("support/random_calls.c");

#[test]
fn random_calls_do_nothing_that_c_leaves_undefined() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/snapshots");
    let of_snapshot = |name: &str| {
        let mechanism = Mechanism::from_file(root.join(format!("{name}.plm"))).unwrap();
        (name.to_owned(), mechanism)
    };
    let snapshots = [
        "arm_on_jack",
        "bouncer",
        "chain",
        "driven_crank",
        "four_bar",
        "plate_on_three_pins",
        "slider_crank",
    ];
    for (name, mechanism) in snapshots.map(of_snapshot).into_iter().chain(scenes()) {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("calls-{name}"));
        fs::create_dir_all(&folder).unwrap();
        let files = plm_source::c(&mechanism, Precision::Double).unwrap();
        let name = files[0].name.trim_end_matches(".h");
        for file in &files {
            fs::write(folder.join(&file.name), &file.text).unwrap();
        }
        fs::write(folder.join("calls.c"), CALLS).unwrap();
        let mut command = Command::new("cc");
        command.args([
            "-std=c99",
            "-O1",
            "-fsanitize=undefined,float-cast-overflow",
            "-fsanitize-undefined-trap-on-error",
        ]);
        command.args([format!("-DNAME={name}"), format!("-DHEADER=\"{name}.h\"")]);
        for function in ["init", "step", "get", "set", "pose", "text"] {
            command.arg(format!("-D{}={name}_{function}", function.to_uppercase()));
        }
        let made = command
            .args(["calls.c", &format!("{name}.c"), "-o", "calls"])
            .current_dir(&folder)
            .output()
            .unwrap();
        assert!(made.status.success(), "{name}: {}", String::from_utf8_lossy(&made.stderr));
        let ran = Command::new(folder.join("calls")).output().unwrap();
        assert!(ran.status.success(), "{name}: {:?}", ran.status);
        println!("{name}: {}", String::from_utf8_lossy(&ran.stdout).trim_end());
    }
}
