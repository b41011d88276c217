//! Checks by compilers: formatting, lints, documentation, the oldest Rust, Miri.

use std::fs;

use crate::Result;
use crate::ci::{FEATURES, OUTSIDE};
use crate::place::Place;

/// Nobody debugs the compiler of plm here.
const AS_PLAIN_PACKAGES: [&str; 4] = [
    "--config",
    "profile.dev.package.plm-cas.opt-level=0",
    "--config",
    "profile.dev.package.plm-compiler.opt-level=0",
];

/// Nothing is built twice and nobody debugs: a third of the time goes without these.
pub(super) fn environment(place: &mut Place) {
    for (name, value) in [
        ("CARGO_TERM_COLOR", "never"),
        ("CARGO_INCREMENTAL", "0"),
        ("CARGO_PROFILE_DEV_DEBUG", "none"),
        ("CARGO_PROFILE_DEV_BUILD_OVERRIDE_DEBUG", "none"),
        // Crates fill the cores already; 256 pieces of each, the default, only cost time.
        ("CARGO_PROFILE_DEV_CODEGEN_UNITS", "16"),
        ("CARGO_PROFILE_DEV_BUILD_OVERRIDE_CODEGEN_UNITS", "16"),
    ] {
        place.set(name, value);
    }
}

/// The lints look on while all is compiled for the tests, as `cargo clippy` has it done: nothing is compiled twice for them.
/// Not all features: those of the peers cost minutes. Programs that are run hear nothing of it. Gives the place without them.
pub(super) fn look_at_what_is_built(place: &mut Place) -> Result<Place> {
    const WRAPPER: &str = "RUSTC_WORKSPACE_WRAPPER";
    let version = place.command("rustc -vV").text()?;
    let host = version.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc names no host")?;
    let runner = format!("CARGO_TARGET_{}_RUNNER", host.to_uppercase().replace('-', "_"));
    place.set(&runner, format!("env -u {WRAPPER}"));
    place.set(WRAPPER, "clippy-driver");
    place.set("CLIPPY_ARGS", "-Dwarnings__CLIPPY_HACKERY__");

    // A warning that clippy alone has must be an error.
    let (wrong, made) = (place.target.join("wrong.rs"), place.target.join("wrong.rmeta"));
    let written = fs::write(&wrong, "pub fn f(x: u8) -> u8 { return x; }\n");
    written.map_err(|why| format!("{}: {why}", wrong.display()))?;
    let driver = place.command("clippy-driver --crate-type lib --crate-name f --emit metadata -o").arg(made);
    if driver.arg(wrong).set("CARGO_PRIMARY_PACKAGE", "1").works() {
        return Err("clippy-driver has no warnings here".to_owned());
    }
    Ok(place.without(&[WRAPPER, &runner]))
}

pub(super) fn formatting(place: &Place) -> Result {
    place.command("cargo fmt --check --all").run()?;
    for package in OUTSIDE {
        place.command("cargo fmt --check --manifest-path").arg(format!("{package}/Cargo.toml")).run()?;
    }
    Ok(())
}

pub(super) fn what_tests_do_not_compile(place: &Place) -> Result {
    place.command("cargo clippy -p plm-runtime --features fma -- -D warnings").run()?;
    for package in OUTSIDE {
        let clippy = place.command("cargo clippy --manifest-path").arg(format!("{package}/Cargo.toml"));
        let clippy = clippy.arg("--target-dir").arg(place.target.join("outside"));
        clippy.args(["--", "-D", "warnings"]).run()?;
    }
    Ok(())
}

/// By the features that tests ask of the crates: with others the compiler, and what is checked of all crates, would be built again.
pub(super) fn documentation(place: &Place) -> Result {
    let features = format!("{FEATURES},dynamic,jit,optimise,synthesis,view,plm-macros/lowered");
    let doc = place.command("cargo doc --no-deps --workspace --features").arg(features);
    doc.set("RUSTDOCFLAGS", "-D warnings").run()
}

/// Documentation as docs.rs shows it, with the names of features: by the nightly toolchain, as there.
pub(super) fn docs_rs(place: &Place) -> Result {
    if !place.command("cargo +nightly --version").works() {
        return place.say("NOT CHECKED: the nightly toolchain cannot be had on this machine");
    }
    let features = format!("{FEATURES},view");
    let doc = place.command("cargo +nightly doc --no-deps -p plm-planar --features").arg(features);
    let doc = doc.arg("--target-dir").arg(place.target.join("docs-rs")).args(AS_PLAIN_PACKAGES);
    doc.set("RUSTDOCFLAGS", "--cfg docsrs -D warnings").run()
}

/// All crates for the systems that this machine is not: types and borrows; nothing is linked or run, tests are left out.
pub(super) fn other_systems(place: &Place) -> Result {
    for target in ["x86_64-pc-windows-gnu", "aarch64-apple-darwin"] {
        if !place.command("rustup target add").arg(target).works() {
            place.say(&format!("NOT CHECKED: the target {target} cannot be had on this machine"))?;
            continue;
        }
        let check = place.command("cargo check --workspace --exclude plm-peers --target").arg(target);
        let check = check.arg("--features").arg(format!("{FEATURES},view"));
        check.arg("--target-dir").arg(place.target.join("systems")).args(AS_PLAIN_PACKAGES).run()?;
    }
    Ok(())
}

/// The library, the macro and the compiler behind it, by the oldest rustc that is declared.
pub(super) fn oldest_rust(place: &Place) -> Result {
    let manifest = fs::read_to_string(place.root.join("Cargo.toml")).map_err(|why| why.to_string())?;
    let version = manifest.lines().find_map(|line| line.strip_prefix("rust-version = \""));
    let oldest = version.ok_or("Cargo.toml declares no rust-version")?.trim_end_matches('"');
    let install = "--profile minimal --no-self-update";
    if !place.command("rustup run").arg(oldest).args(["cargo", "--version"]).works()
        && !place.command("rustup toolchain install").arg(oldest).args(install.split(' ')).works()
    {
        return place.say(&format!("NOT CHECKED: rust {oldest} cannot be had on this machine"));
    }
    let check = place.command("rustup run").arg(oldest).args(["cargo", "check", "--target-dir"]);
    let check = check.arg(place.target.join("oldest")).arg("--features").arg(format!("{FEATURES},view"));
    check.args(AS_PLAIN_PACKAGES).run()
}

/// Unsafe code that is no assembly is in one crate: its tests by the interpreter that finds undefined behaviour.
pub(super) fn miri(place: &Place) -> Result {
    let install =
        "rustup toolchain install nightly --profile minimal --component miri,rust-src --no-self-update";
    if !place.command("cargo +nightly miri --version").works() && !place.command(install).works() {
        return place.say("NOT CHECKED: Miri cannot be had on this machine");
    }
    let test = place.command("cargo +nightly miri test -p plm-foreign --test ffi --target-dir");
    test.arg(place.target.join("miri")).args(AS_PLAIN_PACKAGES).run()
}
