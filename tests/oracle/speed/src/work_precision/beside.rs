//! Lines of programs that are no crates: rows of a file that they have written (`benches/peers/by_heyoka.py`).

use std::error::Error;
use std::fs;
use std::path::Path;

use crate::measure::{Line, Look, Outcome, Point};

/// What a row has, by its heading.
const COLUMNS: &str = "scene,method,setting,error,seconds,evaluations";

/// A scene's name, and a line in it.
pub type Beside = (String, Line);

/// The lines of a file; rows of a line follow each other, from coarse to fine.
///
/// # Errors
/// When the file cannot be read, or a row is no run.
pub fn read(path: &Path) -> Result<Vec<Beside>, Box<dyn Error>> {
    let file = path.display();
    let text = fs::read_to_string(path).map_err(|error| format!("{file}: {error}"))?;
    let mut rows = text.lines().enumerate();
    if rows.next().map(|(_, heading)| heading) != Some(COLUMNS) {
        return Err(format!("{file}: the first line is to be `{COLUMNS}`").into());
    }
    let mut lines: Vec<Beside> = Vec::new();
    for (number, row) in rows {
        let (scene, method, point) =
            run(row).ok_or_else(|| format!("{file}:{}: `{row}` is no run", number + 1))?;
        match lines.last_mut() {
            Some((of, line)) if of == scene && line.method == method => line.points.push(point),
            _ => {
                let look = Look::Peer;
                let line = Line {
                    method: method.to_owned(),
                    formulation: "",
                    look,
                    facts: String::new(),
                    points: vec![point],
                };
                lines.push((scene.to_owned(), line));
            }
        }
    }
    Ok(lines)
}

fn run(row: &str) -> Option<(&str, &str, Point)> {
    let fields: Vec<&str> = row.split(',').collect();
    let &[scene, method, setting, error, seconds, evaluations] = &fields[..] else { return None };
    let outcome = Outcome {
        error: error.parse().ok()?,
        seconds: seconds.parse().ok()?,
        evaluations: evaluations.parse().ok()?,
    };
    Some((scene, method, Point { setting: setting.parse().ok()?, outcome: Ok(outcome) }))
}
