//! Accuracy against speed: every benchmark scene in every formulation with every method, against its reference.
//!
//! ```sh
//! cargo run --release -p plm-speed --bin work_precision                            # plm alone
//! cargo run --release -p plm-speed --bin work_precision --features peers           # beside diffsol and rapier2d
//! cargo run --release -p plm-speed --bin work_precision -- --beside heyoka.csv     # beside a program that wrote a file
//! cargo run --release -p plm-speed --bin work_precision -- --quick --out DIR       # few settings, written to DIR
//! cargo run -p plm-speed --bin work_precision -- --redraw docs/src/images/work-precision   # the book's pictures, of the stored runs
//! ```
//!
//! It prints, for each scene, the least time and its evaluations of the right-hand side to some errors, and writes to
//! `target/plm/work-precision` or to DIR: `runs.csv` (all runs), `tables.txt`, and a picture per scene. What stands in the
//! book is the second command's with `-- --rounds 3 --out docs/src/images/work-precision --beside target/plm/heyoka.csv`.
//!
//! Time is that of one thread by the wall clock, the least of several runs, from the first step to the last: assembly and
//! allocation come before. Look at ratios rather than times, and at evaluations, which are the same on every machine.
//! The program fails if a line does not come near its reference.
#![allow(missing_docs, reason = "the macros of the scenes declare public modules")]
#![allow(unreachable_pub, reason = "the modules are private to a program")]

mod arms;
mod beside;
mod list;
mod measure;
mod methods;
mod references;
mod report;
mod scenes;
mod stored;
mod summary;

use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};

use plm_peers::{Peer, peers};
use plm_program::{Arguments, Known};

use beside::Beside;
use list::SCENES;
use measure::{Bench, Effort, Line, Scene};
use report::{Result as Measured, outcome};

const FULL: Effort =
    Effort { per_decade: 4, fewest_runs: 7, most_runs: 1000, spent: 0.01, longest_run: 0.03 };
const QUICK: Effort = Effort { per_decade: 1, fewest_runs: 1, most_runs: 1, spent: 0.0, longest_run: 0.02 };

/// Names, looks and facts of the lines, without a run.
const NOTHING: Effort = Effort { per_decade: 0, ..QUICK };

const KNOWN: [Known; 5] = [
    Known::value(
        "out",
        "DIR",
        "where runs, tables and pictures go; target/plm/work-precision if nothing is said",
    ),
    Known::flag("quick", "few settings, each run once"),
    Known::value(
        "rounds",
        "N",
        "how often all is measured, one scene after the other; the least counts; 1 if nothing is said",
    ),
    Known::value(
        "redraw",
        "DIR",
        "draws the pictures of the runs that stand in DIR anew and measures nothing",
    ),
    Known::value("beside", "FILE", "runs of another program, as benches/peers/by_heyoka.py writes them"),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::from_args(&KNOWN)?;
    if let Some(help) = arguments.help() {
        println!("{help}");
        return Ok(());
    }
    if let Some(folder) = arguments.value("redraw") {
        return redraw(Path::new(folder));
    }
    let effort = if arguments.flag("quick") { &QUICK } else { &FULL };
    let folder = arguments.value("out").map_or(PathBuf::from("target/plm/work-precision"), PathBuf::from);
    fs::create_dir_all(&folder)?;

    let peers = peers();
    let beside = arguments.value("beside").map(|file| beside::read(Path::new(file)));
    let beside = beside.transpose()?.unwrap_or_default();

    let mut all: Vec<Measured> = SCENES.iter().map(|scene| run(scene, effort, &peers, &beside)).collect();
    // What disturbs a machine for seconds or minutes is over in another round.
    for _ in 1..arguments.number("rounds")?.unwrap_or(1) {
        for measured in &mut all {
            measured.least(&run(measured.scene, effort, &peers, &beside));
        }
    }

    let mut csv = "scene,formulation,method,setting,error,seconds,evaluations,fault\n".to_owned();
    let mut page = String::new();
    let mut far = Vec::new();
    for measured in all {
        let (mark, table) = (slug(measured.scene), measured.table());
        println!("{table}");
        far.extend(measured.far(effort.longest_run));
        csv += &measured.csv();
        write!(page, "<!-- ANCHOR: {mark} -->\n{table}<!-- ANCHOR_END: {mark} -->\n\n")?;
        measured.chart().write_svg(folder.join(format!("{mark}.svg")))?;
    }
    fs::write(folder.join("runs.csv"), csv)?;
    fs::write(folder.join("tables.txt"), page)?;
    println!("written: {}", folder.display());
    Ok(outcome(&far)?)
}

/// Draws all pictures of a folder with `runs.csv`, and the summary beside what was measured elsewhere.
fn redraw(folder: &Path) -> Result<(), Box<dyn Error>> {
    let stored = stored::read(&fs::read_to_string(folder.join("runs.csv"))?)?;
    for scene in SCENES {
        let mut measured = run(scene, &NOTHING, &[], &[]);
        let of_scene = stored.iter().filter(|(of, _)| of == scene.id).map(|(_, line)| line);
        for line in of_scene {
            let is_same = |of: &&mut Line| of.method == line.method && of.formulation == line.formulation;
            match measured.lines.iter_mut().find(is_same) {
                Some(of) => of.points.clone_from(&line.points),
                None if line.formulation.is_empty() => measured.lines.push(line.clone()),
                None => {
                    return Err(format!("{}: no line {}, {}", scene.id, line.method, line.formulation).into());
                }
            }
        }
        measured.chart().write_svg(folder.join(format!("{}.svg", slug(scene))))?;
    }
    let elsewhere = fs::read_to_string(folder.join("elsewhere.csv"))?;
    fs::write(folder.join("summary.svg"), summary::svg(&summary::compare(&stored)?, &elsewhere)?)?;
    Ok(())
}

/// All lines of a scene, plm's first.
fn run(scene: &'static Scene, effort: &Effort, peers: &[Peer], beside: &[Beside]) -> Measured {
    eprintln!("{}, {}", scene.id, scene.title);
    let reference = references::of(scene.id).into_iter().map(|(_, value)| value).collect();
    let bench = Bench { scene, reference, effort };
    let mut lines = (scene.run)(&bench);
    let others = peers.iter().filter(|peer| peer.scene == scene.id);
    lines.extend(others.map(|peer| bench.peer(peer)));
    lines.extend(beside.iter().filter(|(of, _)| of == scene.id).map(|(_, line)| line.clone()));
    Measured { scene, lines }
}

/// `S1` as part of a file's name.
fn slug(scene: &Scene) -> String {
    scene.id.to_lowercase().replace(' ', "-")
}
