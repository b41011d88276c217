//! Tables of the book: errors with CPU times, creep, energy at impacts.

use std::fmt::Write as _;

use crate::runs::{LINES, Run, line};

/// Tolerances of plm and steps of the others, s, that have a column.
const COLUMNS: [(f64, f64); 3] = [(1e-4, 1e-2), (1e-8, 1e-3), (1e-12, 1e-4)];

/// All tables, each between anchors.
pub fn all(runs: &[Run]) -> String {
    let error = |run: &Run| run.error.map(|error| format!("{} ({})", size(error), time(run.seconds)));
    let creep = |run: &Run| run.creep.map(|creep| if creep == 0.0 { "0".to_owned() } else { plain(creep) });
    let gain = |run: &Run| {
        run.gain.map(|gain| if gain.abs() < 5e-5 { size(gain) } else { format!("{:+.2} %", 100.0 * gain) })
    };
    let mut text = String::new();
    for (mark, scene) in
        [("oscillator", "oscillator"), ("ball", "ball"), ("rocking", "rocking"), ("crank", "slider-crank")]
    {
        text += &table(runs, mark, scene, &error);
    }
    text += &table(runs, "creep-block", "block", &creep);
    text += &table(runs, "creep-oscillator", "oscillator", &creep);
    text += &table(runs, "gain-ball", "ball", &gain);
    text += &table(runs, "gain-rocking", "rocking", &gain);
    text
}

fn table(runs: &[Run], mark: &str, scene: &str, cell: &dyn Fn(&Run) -> Option<String>) -> String {
    let mut text = format!("<!-- ANCHOR: {mark} -->\n| | coarse | middle | fine |\n|---|---:|---:|---:|\n");
    for (program, settings, _) in LINES {
        let line = line(runs, scene, program, settings);
        if line.is_empty() {
            continue;
        }
        let cells = COLUMNS.map(|(tolerance, step)| {
            let wanted = if program == "plm" { tolerance } else { step };
            let run = line.iter().find(|run| (run.size / wanted - 1.0).abs() < 1e-6);
            run.and_then(|run| cell(run)).unwrap_or_else(|| "–".to_owned())
        });
        let _ = writeln!(text, "| {program}, {settings} | {} |", cells.join(" | "));
    }
    text + &format!("<!-- ANCHOR_END: {mark} -->\n\n")
}

/// `2.3e-4`.
fn size(value: f64) -> String {
    if value == 0.0 { "0".to_owned() } else { format!("{value:.1e}") }
}

/// `56`, `0.03`.
fn plain(value: f64) -> String {
    if value >= 9.95 {
        format!("{value:.0}")
    } else if value >= 0.095 {
        format!("{value:.1}")
    } else {
        size(value)
    }
}

/// CPU time with its unit.
fn time(seconds: f64) -> String {
    if seconds < 1e-3 { format!("{:.0} µs", 1e6 * seconds) } else { format!("{} ms", plain(1e3 * seconds)) }
}
