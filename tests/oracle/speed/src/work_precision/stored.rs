//! Runs as `runs.csv` keeps them, so that pictures are drawn anew without measuring anew.

use crate::measure::{Line, Look, Outcome, Point};

/// Names of formulations as the scenes write them; other programs have none.
const FORMULATIONS: [&str; 4] = ["tree", "loops", "absolute", ""];

/// All lines of a file, each with the name of its scene. Rows of a line follow each other, from coarse to fine.
///
/// # Errors
/// A row that is no run.
pub fn read(text: &str) -> Result<Vec<(String, Line)>, String> {
    let mut lines: Vec<(String, Line)> = Vec::new();
    for (number, row) in text.lines().enumerate().skip(1) {
        let (scene, method, formulation, point) =
            run(row).ok_or_else(|| format!("{}: `{row}` is no run", number + 1))?;
        match lines.last_mut() {
            Some((of, line)) if of == scene && line.method == method && line.formulation == formulation => {
                line.points.push(point);
            }
            _ => {
                let (method, points) = (method.to_owned(), vec![point]);
                let line = Line { method, formulation, look: Look::Peer, facts: String::new(), points };
                lines.push((scene.to_owned(), line));
            }
        }
    }
    Ok(lines)
}

/// The scene, method, formulation and run of a row.
fn run(row: &str) -> Option<(&str, &str, &'static str, Point)> {
    let fields: Vec<&str> = row.splitn(8, ',').collect();
    let &[scene, formulation, method, setting, error, seconds, evaluations, fault] = &fields[..] else {
        return None;
    };
    let formulation = FORMULATIONS.into_iter().find(|name| *name == formulation)?;
    let outcome = if fault.is_empty() {
        let (error, seconds) = (error.parse().ok()?, seconds.parse().ok()?);
        Ok(Outcome { error, seconds, evaluations: evaluations.parse().ok()? })
    } else {
        Err(fault.trim_matches('"').to_owned())
    };
    Some((scene, method, formulation, Point { setting: setting.parse().ok()?, outcome }))
}
