//! Checks that must pass before a change lands: stages, one after the other, and work beside them.

mod chores;
mod lints;
mod packages;
mod tests;

use std::collections::BTreeMap;
use std::fmt;
use std::time::{Duration, Instant};

use crate::Result;
use crate::beside::Beside;
use crate::place::Place;

/// One set of features for all that is built in the workspace: another one would build it again.
const FEATURES: &str = "analysis,batch,lanes";
/// Packages outside the workspace; their own target folder keeps the tree clean.
const OUTSIDE: [&str; 5] = [
    "tests/no_std",
    "tests/chain64",
    "examples/firmware",
    "examples/firmware/machine",
    "examples/playground",
];

/// Something that must hold.
#[derive(Clone, Copy)]
struct Part {
    name: &'static str,
    title: &'static str,
    /// Is it compiled by rustc alone, not as the tests are?
    is_plain: bool,
    work: fn(&Place) -> Result,
}

enum Step {
    /// Beginning of work beside the stages that follow: its parts run in a thread, one after the other.
    Begin { group: &'static str, niceness: u32, parts: &'static [Part] },
    /// A stage.
    Here(Part),
    /// The stage of all tests, which has work beside itself.
    Tests,
    /// End of such work: waits for it, and fails if a part has failed.
    Join { group: &'static str, title: &'static str },
}

const fn part(name: &'static str, title: &'static str, work: fn(&Place) -> Result) -> Part {
    Part { name, title, is_plain: false, work }
}

const fn plain(name: &'static str, title: &'static str, work: fn(&Place) -> Result) -> Part {
    Part { name, title, is_plain: true, work }
}

/// From a clean checkout; half an hour on two cores, where fourteen minutes are the aim. Nothing of it depends on how much time is left.
const STEPS: &[Step] = &[
    Step::Begin { group: "tools", niceness: 0, parts: &[part(tests::NAME, "tools", tests::tools)] },
    // They fill the cores that the stages leave idle.
    Step::Begin {
        group: "others",
        niceness: 19,
        parts: &[
            plain("book", "mdBook", chores::install_mdbook),
            plain("packages", "packages", packages::all),
        ],
    },
    Step::Here(part("formatting", "formatting", lints::formatting)),
    // In a minute, before all is built that tests need.
    Step::Here(part("rules", "rules of the repository", tests::rules)),
    Step::Tests,
    // The tests have built the sweeps, and share the target folder and apt with the machines: neither waits for them. One build
    // for a machine has one core, the sweep all that are left.
    Step::Begin {
        group: "targets",
        niceness: 19,
        parts: &[plain("machines", "machines", chores::one_machine)],
    },
    Step::Begin { group: "random", niceness: 19, parts: &[part("sweep", "sweep", chores::sweep)] },
    Step::Here(plain("lints", "other lints", lints::what_tests_do_not_compile)),
    Step::Here(part("fused", "fused multiply-add", tests::fused)),
    Step::Here(part("documentation", "documentation", lints::documentation)),
    Step::Here(plain("book", "book", chores::book)),
    Step::Here(part("curves", "curves", chores::curves)),
    Step::Here(part("page", "page", chores::page)),
    // Only here, so that no core is idle before.
    Step::Join { group: "others", title: "mdBook, packages" },
    Step::Join { group: "random", title: "sweep" },
    Step::Join { group: "targets", title: "machines" },
];

/// Stages that take longer, or need more than a fresh machine has.
const MORE: &[Step] = &[
    Step::Here(plain("oldest", "oldest Rust", lints::oldest_rust)),
    Step::Here(plain("chain", "chain of 64 at opt-level 0 and 3", chores::chain)),
    Step::Here(plain("miri", "Miri", lints::miri)),
    Step::Here(part("long-sweep", "sweep of 1000 mechanisms", chores::long_sweep)),
    Step::Here(plain("compiled-sweeps", "sweeps of compiled mechanisms", chores::compiled_sweeps)),
    Step::Here(plain("oracle", "random mechanisms of special values", |place| {
        place.command("cargo run --release -p plm-oracle -- all 1000 --seed 7").run()
    })),
    Step::Here(plain("licences", "licences", chores::licences)),
    Step::Here(plain("systems", "Windows and macOS", lints::other_systems)),
    Step::Here(plain("docs-rs", "documentation as on docs.rs", lints::docs_rs)),
    Step::Here(plain("package-programs", "programs of packages", packages::programs)),
    Step::Here(plain("release", "release up to the upload", |place| {
        place.command("cargo xtask release all v0.1.0 --dry-run").run()
    })),
    Step::Here(plain("playground", "playground", |place| {
        place.command("bash examples/playground/check.sh").run()?;
        place.command("bash examples/playground/npm.sh --check").run()
    })),
    Step::Here(plain("gradients", "derivatives of random mechanisms", |place| {
        place.command("cargo run --release --example gradients -- 300").run()
    })),
    Step::Here(plain("random-declarations", "bits of random declarations", |place| {
        place.command("cargo run -p plm-oracle --bin random_declarations -- 100").run()
    })),
    Step::Here(plain("neighbours", "MATLAB, ROS 2, Arduino, CUDA and recipes without Rust", |place| {
        ["matlab", "ros2", "arduino", "cuda", "without_rust"]
            .iter()
            .try_for_each(|name| place.command("bash").arg(format!("tests/{name}.sh")).run())
    })),
    Step::Here(part("fmu", "FMU", |place| place.command("bash tests/fmu.sh").run())),
    Step::Here(plain("exports", "programs, C, FMU and wheel that are exported", |place| {
        place.command("bash tests/exports.sh").run()
    })),
    Step::Here(plain("python-text", "Python without Rust", |place| {
        place.command("bash tests/python_text.sh").run()
    })),
    Step::Here(part("python", "Python", |place| place.command("bash tests/python.sh").run())),
    Step::Here(plain("seven-machines", "seven machines", |place| {
        place.command("bash tests/machines.sh").run()
    })),
    Step::Here(plain("many-machines", "many machines", |place| {
        place.command("bash tests/many_machines.sh").run()
    })),
    Step::Here(plain("precision", "every method on the smooth benchmark scenes", |place| {
        place.command("cargo run --release -p plm-speed --bin work_precision -- --quick").run()
    })),
    Step::Here(plain("instructions", "instruction counts", |place| {
        place.command("bash benches/instructions.sh").run()
    })),
];

/// A run of stages.
struct Ci {
    place: Place,
    plain: Place,
    /// Names of the parts that are wanted; none: all.
    only: Vec<String>,
    running: BTreeMap<&'static str, Beside>,
    started: Instant,
    durations: Vec<String>,
}

pub(crate) fn run(mut place: Place, words: &[String]) -> Result {
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    let (steps, only): (Vec<&Step>, &[&str]) = match words.as_slice() {
        [] => (STEPS.iter().collect(), &[]),
        ["--more"] => (MORE.iter().collect(), &[]),
        ["--only", names @ ..] if !names.is_empty() => (STEPS.iter().chain(MORE).collect(), names),
        ["--list"] => {
            println!("{}", names(STEPS.iter().chain(MORE)).join("\n"));
            return Ok(());
        }
        _ => return Err("cargo xtask ci [--more | --only NAME... | --list]".to_owned()),
    };
    let all = names(steps.iter().copied());
    if let Some(unknown) = only.iter().find(|name| !all.contains(name)) {
        return Err(format!("`{unknown}` is no stage; `cargo xtask ci --list` lists them"));
    }
    lints::environment(&mut place);
    let plain = lints::look_at_what_is_built(&mut place)?;
    chores::add_wasm(&plain)?;
    let only = only.iter().map(|&name| name.to_owned()).collect();
    let (running, durations) = (BTreeMap::new(), Vec::new());
    let mut ci = Ci { place, plain, only, running, started: Instant::now(), durations };
    steps.into_iter().try_for_each(|step| ci.take(step))?;
    println!("\nAll stages passed in {} s:\n{}", ci.started.elapsed().as_secs(), ci.durations.join("\n"));
    Ok(())
}

/// Names of all parts, each once.
fn names<'a>(steps: impl Iterator<Item = &'a Step>) -> Vec<&'static str> {
    let mut all = Vec::new();
    for step in steps {
        let names: Vec<&str> = match step {
            Step::Begin { parts, .. } => parts.iter().map(|part| part.name).collect(),
            Step::Here(part) => vec![part.name],
            Step::Tests => vec![tests::NAME],
            Step::Join { .. } => Vec::new(),
        };
        all.extend(names.into_iter().filter(|name| !all.contains(name)).collect::<Vec<_>>());
    }
    all
}

impl Ci {
    fn is_wanted(&self, name: &str) -> bool {
        self.only.is_empty() || self.only.iter().any(|wanted| wanted == name)
    }

    fn take(&mut self, step: &Step) -> Result {
        match *step {
            Step::Begin { group, niceness, parts } => {
                let (place, plain) = (self.place.clone(), self.plain.clone());
                let parts: Vec<Part> =
                    parts.iter().copied().filter(|part| self.is_wanted(part.name)).collect();
                if !parts.is_empty() {
                    self.begin(group, niceness, move |beside| {
                        parts.iter().try_for_each(|part| {
                            let place = if part.is_plain { &plain } else { &place };
                            let (started, place) = (Instant::now(), place.printing_as(beside).counting());
                            (part.work)(&place)?;
                            beside.say(&format!("== {}: {}", part.title, Took::since(started, &place)))
                        })
                    })?;
                }
            }
            Step::Here(part) if self.is_wanted(part.name) => {
                let place = if part.is_plain { &self.plain } else { &self.place }.counting();
                self.stage(part.title, &place, |_| (part.work)(&place))?;
            }
            Step::Tests if self.is_wanted(tests::NAME) => {
                let place = self.place.counting();
                self.stage("lints and tests", &place, |ci| tests::all(ci, &place))?;
            }
            Step::Join { group, title } if self.running.contains_key(group) => {
                let place = self.place.counting();
                self.stage(title, &place, |ci| {
                    ci.join(group).map(|text| print!("{}", worth_showing(&text)))
                })?;
            }
            Step::Here(_) | Step::Tests | Step::Join { .. } => {}
        }
        Ok(())
    }

    /// A stage whose commands run in this place.
    fn stage(&mut self, title: &str, place: &Place, work: impl FnOnce(&mut Self) -> Result) -> Result {
        let started = Instant::now();
        println!("\n== {title}");
        work(self).map_err(|why| format!("\n{title}: {why}"))?;
        let took = Took::since(started, place);
        println!("== {title}: {took}");
        self.durations.push(format!("{took}  {title}"));
        Ok(())
    }

    /// Work beside the stages, until it is joined.
    fn begin(
        &mut self,
        name: &'static str,
        niceness: u32,
        work: impl FnOnce(&Place) -> Result + Send + 'static,
    ) -> Result {
        let beside = Beside::begin(name, niceness, &self.place, work)?;
        self.running.insert(name, beside);
        Ok(())
    }

    /// Waits for work beside the stages, and gives what it has printed.
    fn join(&mut self, name: &str) -> Result<String> {
        let beside = self.running.remove(name).ok_or_else(|| format!("{name} was not begun"))?;
        beside.join()
    }
}

/// Time that a stage took.
struct Took {
    /// By the clock.
    wall: Duration,
    /// Of all processors together.
    processor: Duration,
}

impl Took {
    fn since(started: Instant, place: &Place) -> Self {
        Self { wall: started.elapsed(), processor: place.spent() }
    }
}

impl fmt::Display for Took {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:4} s, {:4} s of processors", self.wall.as_secs(), self.processor.as_secs())
    }
}

/// Results, durations, and what was not checked; not what cargo says while it builds.
fn worth_showing(text: &str) -> String {
    let mut is_result = false;
    let lines = text.lines().filter(|line| {
        is_result |= line.starts_with("seed") || line.contains("the same ");
        is_result || line.starts_with("== ") || line.contains("NOT CHECKED")
    });
    lines.flat_map(|line| [line, "\n"]).collect()
}
