//! What the gallery of the book shows of each demo: its runs, the manual's curves, and its pictures.

mod bodies;
mod book;
mod figure;
mod hydraulics;
mod joints;
mod masses;
mod pendulums;

use std::error::Error;
use std::fs;
use std::path::Path;

use plm::view::{Page, Recorder, Recording, Results};
use plm::{Described, Fault};
use serde_json::{Value, json};

use crate::command::Command;
use crate::demos::DEMOS;
use figure::Figure;

/// A demo as the gallery shows it.
pub struct Shown {
    /// Its name in the manual.
    pub demo: &'static str,
    /// Its section there.
    pub section: &'static str,
    /// What it is, in a sentence or two of Markdown.
    pub text: &'static str,
    /// The runs of its curves and pictures.
    runs: fn() -> Result<Vec<Recording>, Fault>,
    /// One run as the command line asks for it.
    pub program: Command,
    /// The manual's curves.
    figures: &'static [Figure],
    /// What the page shows of the runs.
    pictures: &'static [Picture],
}

/// A picture that the page draws.
struct Picture {
    /// The file, without its folder.
    file: &'static str,
    caption: &'static str,
    /// View and curves as the address of the page has them after `#`; with `preset`, the side of the view, and `zoom`, a factor on the scale
    /// that has all in sight.
    shows: &'static str,
    /// Width and height in pixels.
    size: [u32; 2],
}

/// The demos, in the order of the manual.
pub const SHOWN: [&Shown; 19] = [
    &pendulums::DOUBLE_PENDULUM,
    &masses::PRISMATIC_JOINT,
    &hydraulics::CONNECT_PLM_HYD,
    &hydraulics::CONNECT_PLM_HCD,
    &hydraulics::DOUBLE_ARM,
    &pendulums::PLMPIV00,
    &joints::PLMPIV10,
    &joints::PLMTRA00,
    &joints::PLMTRA10,
    &joints::PLMTRPI00,
    &joints::PLMJ00,
    &bodies::CONTOUR,
    &bodies::QUADRORHOMB,
    &pendulums::PLMBOD02,
    &pendulums::PLMASSEMBLY,
    &joints::PLMEMB01,
    &masses::PLMT01D,
    &masses::PLMT01D01,
    &bodies::PLMCALCUL,
];

impl Shown {
    fn page(&self) -> String {
        format!("{}.html", self.demo)
    }
}

/// Writes into a folder the curves, the page of each demo, the list of pictures that are to be made of the pages, and the
/// gallery of the book.
pub fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    if let Some((name, _)) = DEMOS.iter().find(|(name, _)| !SHOWN.iter().any(|shown| shown.demo == *name)) {
        return Err(format!("the gallery does not show {name}").into());
    }
    fs::create_dir_all(folder)?;
    let mut pictures = Vec::new();
    for shown in SHOWN {
        let runs = (shown.runs)()?;
        for figure in shown.figures {
            figure.chart(&runs)?.write_svg(folder.join(figure.file()))?;
        }
        let results = Results { runs, ..Results::default() }.to_bytes()?;
        Page::new(&results, shown.demo).write_html(folder.join(shown.page()))?;
        pictures.extend(shown.pictures.iter().map(|picture| entry(shown, picture)));
    }
    fs::write(folder.join("pictures.json"), serde_json::to_string_pretty(&pictures)?)?;
    fs::write(folder.join("gallery.md"), book::text())?;
    println!("written: {}", folder.display());
    Ok(())
}

fn entry(shown: &Shown, picture: &Picture) -> Value {
    let Picture { file, shows, size, .. } = picture;
    json!({ "page": shown.page(), "file": file, "shows": shows, "size": size })
}

/// A run of so many seconds, sampled every so many; of none, the start alone. It has a name, by which it is found.
fn run<M: Described<S = f64>>(
    name: &str,
    mechanism: M,
    [until, every]: [f64; 2],
) -> Result<Recording, Fault> {
    let mut sim = mechanism.start()?;
    let mut recorder = Recorder::new(&sim).named(name);
    if until > 0.0 {
        recorder.run(&mut sim, until, every)?;
    } else {
        recorder.take(sim.state());
    }
    Ok(recorder.into_recording())
}

/// Where only the start is shown.
const AT_START: [f64; 2] = [0.0, 0.0];
/// A picture beside others, or of a wide mechanism.
const WIDE: [u32; 2] = [640, 320];
const USUAL: [u32; 2] = [640, 440];
