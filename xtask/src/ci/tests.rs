//! All tests, with the lints looking on.

use crate::Result;
use crate::ci::{Ci, FEATURES};
use crate::place::{Place, Task};

pub(super) const NAME: &str = "tests";

/// The disturbed declarations, which take more than a minute on one core.
const DISTURBED: &str = "disturbed_declarations_are_answered";

/// Tools that tests of other languages need. One after the other: both ask apt.
pub(super) fn tools(place: &Place) -> Result {
    place.command("bash tests/clang.sh").arg(place.target.join("clang")).run()?;
    place.command("bash crates/plm-view/page/check.sh --install").run()
}

/// Rules of CONTRIBUTING.md that a machine can read.
pub(super) fn rules(place: &Place) -> Result {
    let test = place.command("cargo test --workspace --features").arg(FEATURES);
    test.args(["--test", "tidy", "--test", "files"]).run()
}

/// Some take more than a minute on one core, so that the others run beside them: the disturbed declarations, and the tests that build
/// packages. While these run the lints look at programs and benchmarks that nobody runs here.
pub(super) fn all(ci: &mut Ci, place: &Place) -> Result {
    let build = "cargo test --no-run --message-format json-render-diagnostics --workspace --features";
    let messages = place.command(build).arg(FEATURES).text()?;
    let robust = executable(&messages, "robust").ok_or("there is no test of the name robust")?;
    ci.begin("robust", 0, move |place| {
        place.command("").arg(robust).in_folder("plm-macros/compiler").args(["--exact", DISTURBED]).run()
    })?;
    print!("{}", ci.join("tools")?);
    let mut path = place.target.join("clang").into_os_string();
    if let Some(others) = std::env::var_os("PATH") {
        path.push(":");
        path.push(others);
    }
    let of_packages = "cargo test --test no_std --test foreign --workspace --features";
    place.command(of_packages).args([FEATURES, "--no-run"]).run()?;
    let own = path.clone();
    ci.begin("package-tests", 0, move |place| {
        place.command(of_packages).arg(FEATURES).set("PATH", own).run()
    })?;
    place.command("cargo check --bins --benches --workspace --features").arg(FEATURES).run()?;
    let test = place.command("cargo test --workspace --features").arg(FEATURES).set("PATH", path);
    test.args(["--", "--skip", DISTURBED]).run()?;
    if !ci.join("robust")?.contains("1 passed") {
        return Err(format!("{DISTURBED} is no test of robust"));
    }
    ci.join("package-tests").map(|text| print!("{text}"))
}

/// The program of a test, as cargo's messages name it.
fn executable(messages: &str, test: &str) -> Option<String> {
    let name = format!("\"name\":\"{test}\"");
    let line = messages.lines().find(|line| line.contains("\"kind\":[\"test\"]") && line.contains(&name))?;
    let (_, path) = line.split_once("\"executable\":\"")?;
    Some(path.split_once('"')?.0.to_owned())
}

/// An example as the tests have built it: numbers are the same at any level of optimisation. For one package alone cargo would choose
/// other features of its dependencies, and build all of it again.
pub(super) fn example<'a>(place: &'a Place, name: &str) -> Result<Task<'a>> {
    place.command("cargo build --workspace --features").arg(FEATURES).args(["--example", name]).run()?;
    Ok(built(place, &format!("examples/{name}")))
}

/// A program of the workspace, as the tests have built it; it hears nothing of the lints.
pub(super) fn built<'a>(place: &'a Place, program: &str) -> Task<'a> {
    place.command("env -u RUSTC_WORKSPACE_WRAPPER").arg(place.target.join("debug").join(program))
}

/// Tests of the functions that fused multiply-add changes; the lints compile the rest with it.
pub(super) fn fused(place: &Place) -> Result {
    place.command("cargo test -p plm-math --features fma").run()
}
