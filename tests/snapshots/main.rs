//! What the compiler emits for eight mechanisms, word for word, and the bits of their first steps.
//!
//! Beside each declaration, `tests/snapshots/*.plm`, stands what is emitted for it, formatted; it is a module of this test, so
//! that it compiles. A change of emission shows in these files, line by line:
//! `PLM_BLESS=1 cargo test --test snapshots` writes them anew.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]
#![allow(
    unused_qualifications,
    reason = "emitted code qualifies where a name of the user's could stand in the way"
)]

mod arm_on_jack;
mod bouncer;
mod chain;
mod double_pendulum;
mod driven_crank;
mod four_bar;
mod plate_on_three_pins;
mod slider_crank;

use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use plm::Rk4;
use plm::runtime::{Mechanism, Moment, Vector};
use plm_compiler::compile;
use plm_compiler::token::Sources;

/// The mechanisms, each with what it stands for.
const MECHANISMS: [(&str, &str); 8] = [
    ("arm_on_jack", "states of hydraulics, a limit that is hit"),
    ("bouncer", "conditions, a requirement, an input"),
    ("chain", "elimination body by body"),
    ("double_pendulum", "a tree"),
    ("driven_crank", "prescribed motion, a ground that moves"),
    ("four_bar", "a dyad, and charts"),
    ("plate_on_three_pins", "a group for Newton's iteration"),
    ("slider_crank", "absolute coordinates"),
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots")
}

/// What is emitted for a declaration, formatted as the repository is.
fn emitted(name: &str) -> String {
    let mut sources = Sources::new();
    let declaration = fs::read_to_string(folder().join(name).with_extension("plm")).unwrap();
    sources.add_text(name, &declaration);
    let expansion = compile(&mut sources);
    let messages: Vec<String> =
        expansion.diagnostics.sorted().iter().map(|diagnostic| diagnostic.render(&sources)).collect();
    assert!(messages.is_empty(), "{}", messages.join("\n"));
    formatted(&expansion.code.unwrap().text())
}

fn formatted(code: &str) -> String {
    let config = Path::new(env!("CARGO_MANIFEST_DIR")).join("rustfmt.toml");
    let mut rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--config-path"])
        .arg(config)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    rustfmt.stdin.take().unwrap().write_all(code.as_bytes()).unwrap();
    let output = rustfmt.wait_with_output().unwrap();
    assert!(output.status.success(), "rustfmt does not take what is emitted");
    String::from_utf8(output.stdout).unwrap()
}

/// Compares with a file, or writes it.
fn blessed(file: &str, found: &str) -> Result<(), String> {
    let path = folder().join(file);
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(path, found).unwrap();
        return Ok(());
    }
    let expected = fs::read_to_string(path).unwrap_or_default();
    let mut lines = expected.lines().zip(found.lines()).zip(1..);
    match lines.find(|((expected, found), _)| expected != found) {
        Some(((expected, found), line)) => {
            Err(format!("{file}:{line}\n  blessed: {expected}\n  emitted: {found}"))
        }
        None if expected != found => Err(format!("{file}: one text goes on where the other ends")),
        None => Ok(()),
    }
}

#[test]
fn emitted_code_is_as_it_was_blessed() {
    let compared = MECHANISMS.map(|(name, _)| blessed(&format!("{name}.rs"), &emitted(name)));
    let changed: Vec<String> = compared.into_iter().filter_map(Result::err).collect();
    assert!(changed.is_empty(), "PLM_BLESS=1 takes what is emitted now\n{}", changed.join("\n"));
}

/// The bits of the state and the outputs after ten steps of a tenth of a millisecond.
fn bits<M: Mechanism<S = f64>, O: IntoIterator<Item = f64>>(
    name: &str,
    mechanism: M,
    outputs: impl Fn(&M::State) -> O,
) -> String {
    let mut sim = mechanism.start_with(Rk4::new(1e-4)).unwrap();
    sim.step(1e-3).unwrap();
    let state = sim.state();
    let values = (0..M::X::LEN).map(|k| state.x().at(k)).chain(outputs(state));
    let words: Vec<String> = values.map(|value| format!("{:016x}", value.to_bits())).collect();
    format!("{name}: {}\n", words.join(" "))
}

#[test]
#[allow(clippy::redundant_closure_for_method_calls, reason = "the method's own path is longer than the call")]
fn first_steps_have_the_bits_that_they_had() {
    let found = [
        bits("arm_on_jack", arm_on_jack::ArmOnJack::new(), |state| state.outputs()),
        bits("bouncer", bouncer::Bouncer::new(), |state| state.outputs()),
        bits("chain", chain::Chain::new(), |state| state.outputs()),
        bits("double_pendulum", double_pendulum::DoublePendulum::new(), |state| state.outputs()),
        bits("driven_crank", driven_crank::DrivenCrank::new(), |state| state.outputs()),
        bits("four_bar", four_bar::FourBar::new(), |state| state.outputs()),
        bits("plate_on_three_pins", plate_on_three_pins::PlateOnThreePins::new(), |state| state.outputs()),
        bits("slider_crank", slider_crank::SliderCrank::new(), |state| state.outputs()),
    ];
    blessed("bits.txt", &found.concat()).unwrap();
}
