//! The book, the examples, the page, other machines.

use std::fs;
use std::path::Path;

use crate::Result;
use crate::ci::FEATURES;
use crate::ci::tests::{built, example};
use crate::place::Place;

const MDBOOK: &str = "0.5.4";
const CARGO_DENY: &str = "0.20.2";

/// A live page holds the mechanism as WebAssembly; without the target its tests say that they were skipped.
pub(super) fn add_wasm(place: &Place) -> Result {
    let target = "wasm32-unknown-unknown";
    if place.command("rustup target add").arg(target).works() {
        return Ok(());
    }
    place.say(&format!("NOT CHECKED: the target {target} cannot be had on this machine"))
}

fn same(made: &Path, expected: &Path) -> Result {
    let read = |path: &Path| fs::read(path).map_err(|why| format!("{}: {why}", path.display()));
    if read(made)? == read(expected)? {
        return Ok(());
    }
    Err(format!("{} and {} differ", made.display(), expected.display()))
}

/// A long chain tries rustc's stack and time hardest. All debug information; the compiler of plm at opt-level 0, as in
/// a user's package, built once for both levels. Both must print the same bits.
pub(super) fn chain(place: &Place) -> Result {
    let outside = place.target.join("outside");
    fs::create_dir_all(&outside).map_err(|why| format!("{}: {why}", outside.display()))?;
    let printed = ["0", "3"].map(|level| (level, outside.join(format!("chain64-{level}.txt"))));
    for (level, file) in &printed {
        let run =
            place.command("cargo run --manifest-path tests/chain64/Cargo.toml --target-dir").arg(&outside);
        run.set("CARGO_PROFILE_DEV_DEBUG", "full").set("CARGO_PROFILE_DEV_OPT_LEVEL", *level).save(file)?;
    }
    same(&printed[0].1, &printed[1].1)?;
    let numbers = fs::read_to_string(&printed[0].1).map_err(|why| why.to_string())?;
    place.say(&format!("the same {} numbers at opt-level 0 and 3", numbers.lines().count()))
}

pub(super) fn install_mdbook(place: &Place) -> Result {
    install(place, ("mdbook", MDBOOK, "mdbook v"), &["--features", "search"])
}

/// A tool of Rust in a folder of the target folder, unless it is there: `said` is what stands before its version in what it says.
fn install(place: &Place, (tool, version, said): (&str, &str, &str), features: &[&str]) -> Result {
    let tools = place.target.join("tools");
    let there = place.command("").arg(tools.join("bin").join(tool)).arg("--version").text();
    if there.is_ok_and(|there| there.trim() == format!("{said}{version}")) {
        return Ok(());
    }
    let install =
        place.command("cargo install --locked --no-default-features --debug --version").arg(version);
    let install = install.arg(tool).args(features).arg("--root").arg(&tools);
    install.arg("--target-dir").arg(tools.join("build")).run()
}

/// Licences, versions and sources of dependencies, by `deny.toml`.
pub(super) fn licences(place: &Place) -> Result {
    install(place, ("cargo-deny", CARGO_DENY, "cargo-deny "), &[])?;
    let deny = place.command("").arg(place.target.join("tools/bin/cargo-deny"));
    deny.args(["check", "licenses", "bans", "sources"]).run()
}

/// Builds the book, and looks at what is built. This program is the preprocessor of its formulas.
pub(super) fn book(place: &Place) -> Result {
    install_mdbook(place)?;
    let built = place.target.join("book");
    let build = place.command("").arg(place.target.join("tools/bin/mdbook")).args(["build", "docs"]);
    let build =
        build.set("MDBOOK_PREPROCESSOR__MATH__COMMAND", format!("'{}' math", place.program.display()));
    build.arg("--dest-dir").arg(&built).run()?;
    if !place.command("node --version").works() {
        return place
            .say("NOT CHECKED: links, colours and widths of the book, for want of node (20 or later)");
    }
    place.command("npm ci --silent").in_folder("docs/check").run()?;
    let tests = ["--test", "--test-reporter=spec", "book.test.js", "colours.test.js", "open.test.js"];
    place
        .command("node")
        .args(tests)
        .in_folder("docs/check")
        .set("PLM_BOOK", built)
        .set("PLM", place.target.join("debug/plm"))
        .run()
}

/// The book shows the curves that the example draws.
pub(super) fn curves(place: &Place) -> Result {
    example(place, "double_pendulum")?.run()?;
    same("target/plm/double_pendulum.svg".as_ref(), "docs/src/images/double_pendulum.svg".as_ref())
}

pub(super) fn page(place: &Place) -> Result {
    example(place, "page")?;
    let check = place.command("bash crates/plm-view/page/check.sh");
    check.set("PLM_PAGE", place.target.join("debug/examples/page")).run()
}

/// Random trees and loops against a reference in higher precision, and random mechanisms with contacts against equations of their own: two
/// minutes of a processor.
pub(super) fn sweep(place: &Place) -> Result {
    swept(place, "60", "50")
}

/// The sweeps of a release.
pub(super) fn long_sweep(place: &Place) -> Result {
    swept(place, "1000", "200")
}

/// The programs are built with the tests of their package.
fn swept(place: &Place, smooth: &str, contacts: &str) -> Result {
    let build = place.command("cargo test --no-run --workspace --features").arg(FEATURES);
    build.args(["--test", "quick"]).run()?;
    let program = |name: &str| built(place, name);
    program("linkages").args([smooth, "--seed", "31", "--verbose"]).run()?;
    program("contacts").args([contacts, "--seed", "31", "--verbose"]).run()
}

/// Mechanisms by rustc beside those from text, for their bits, and linkages in f32.
pub(super) fn compiled_sweeps(place: &Place) -> Result {
    let run = |program: &str, words: &[&str]| {
        let cargo = place.command("cargo run --release -p plm-oracle --features compiled --bin");
        cargo.arg(program).arg("--").args(words).run()
    };
    run("linkages", &["100", "--seed", "7", "--verbose"])?;
    run("contacts", &["50", "--seed", "7", "--bits"])
}

/// Bits on a microcontroller of 32 bits beside those of this machine, which has 64, and the instructions of a step there.
pub(super) fn one_machine(place: &Place) -> Result {
    place.command("bash tests/machines.sh --one").run()
}
