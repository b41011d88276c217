//! A run as one object of JSON, for programs: columns, rows, events, notices, counts, and how it ended.

use plm_dynamic::{Course, Error, Run};
use serde_json::{Map, Value, json};

use super::asked::Asked;
use super::following::Following;
use super::told::{Event, steps};
use super::{Failure, Outcome, Streams, columns, fault, rowed};
use crate::interrupt;
use crate::read::File;

/// The results of a run.
pub(super) struct Gathered {
    outcome: Result<(), Error>,
    headings: Vec<String>,
    rows: Vec<Vec<f64>>,
    events: Vec<Event>,
}

/// Runs, and keeps the rows of the outputs.
pub(super) fn gathered(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
) -> Gathered {
    let (columns, headings) = columns(run, false);
    let mut rows = Vec::new();
    let (outcome, events) = rowed(asked, run, course, following, &columns, |row| {
        rows.push(row);
        true
    });
    Gathered { outcome, headings, rows, events }
}

impl Gathered {
    /// Writes the object. A run that ended early is told in it, with the line of the part in the declaration.
    pub(super) fn write(self, run: &mut Run, file: &File, streams: &mut Streams) -> Result<Outcome, Failure> {
        let told = match &self.outcome {
            Err(Error::Fault(why)) => {
                let mut text = Vec::new();
                fault::ended(why, file, &mut text)?;
                Some(String::from_utf8_lossy(&text).trim_start_matches("plm: ").trim_end().to_owned())
            }
            Err(other) => Some(other.to_string()),
            Ok(()) if interrupt::came() => Some("interrupted".to_owned()),
            Ok(()) => None,
        };
        let outcome = if told.is_some() { Outcome::Wrong } else { Outcome::Good };
        let event = |(time, what): &Event| json!({ "time": time, "what": what });
        let notices: Vec<String> = run.notices().iter().map(ToString::to_string).collect();
        let counts = steps(&run.stats()).into_iter().filter(|(count, _)| *count > 0);
        let counts: Map<String, Value> =
            counts.map(|(count, what)| (what.to_owned(), json!(count))).collect();
        let all = json!({
            "columns": self.headings,
            "rows": self.rows,
            "events": self.events.iter().map(event).collect::<Vec<_>>(),
            "notices": notices,
            "counts": counts,
            "end": run.time(),
            "fault": told,
        });
        writeln!(streams.output, "{all}")?;
        Ok(outcome)
    }
}
