//! Arguments of `plm run`.

use std::path::PathBuf;

use plm_dynamic::Integrator;

use super::super::clock::Begin;
use super::super::words::{Words, names};
use super::Failure;

/// Samples of a table, and of CSV as compiled programs have it.
const SAMPLES: [f64; 2] = [20.0, 1000.0];
/// Largest number of rows of a table.
const MOST_ROWS: f64 = 1e5;

/// Which rows are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rows {
    /// Samples, those before and after what switches, and the end.
    All,
    /// Samples alone.
    Sampled,
}

/// Options of inputs over time.
pub(super) struct Signals {
    /// Tables.
    pub(super) files: Vec<String>,
    pub(super) interpolation: Interpolation,
    /// The columns that are read; all where none is named.
    pub(super) only: Vec<String>,
    /// The time of the readings at which the run begins; none where both have one clock.
    pub(super) from: Option<Begin>,
}

/// Interpolation of an input between two readings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Interpolation {
    /// On the straight line from one to the other.
    Linear,
    /// Constant from one reading to the next: a zero-order hold.
    Hold,
}

impl Signals {
    fn new(words: &mut Words) -> Result<Signals, Failure> {
        let is_held = words.takes("--hold");
        let interpolation = if is_held { Interpolation::Hold } else { Interpolation::Linear };
        let (files, only, from) =
            (words.values("--inputs"), names(&words.values("--only")), Begin::asked(words)?);
        if files.is_empty() && (is_held || !only.is_empty() || from.is_some()) {
            return Err("--hold, --only and --from are of inputs over time: with `--inputs FILE`".into());
        }
        Ok(Signals { files, interpolation, only, from })
    }
}

/// Parsed arguments of the command.
pub(super) struct Asked {
    pub(super) until: f64,
    pub(super) every: f64,
    pub(super) set: Vec<String>,
    pub(super) input: Vec<String>,
    pub(super) signals: Signals,
    pub(super) method: Integrator,
    pub(super) rows: Rows,
    /// True if counters and events are printed.
    pub(super) stats: bool,
    /// True if the result is one object of JSON.
    pub(super) json: bool,
    pub(super) csv: Option<String>,
    pub(super) view: Option<PathBuf>,
    pub(super) out: Option<PathBuf>,
}

impl Asked {
    pub(super) fn new(words: &mut Words) -> Result<Asked, Failure> {
        let csv = words.value("--csv");
        let [view, out] = ["--view", "--out"].map(|option| words.value(option).map(PathBuf::from));
        let has_files = csv.is_some() || view.is_some() || out.is_some();
        let json = words.takes("--json");
        if json && has_files {
            return Err("--json is a result by itself: without --csv, --view and --out".into());
        }
        let until = time("--until", words.value("--until"))?;
        let until = until.ok_or("a run needs its end: `--until SECONDS`")?;
        let every = time("--every", words.value("--every"))?;
        let every = every.unwrap_or(until / SAMPLES[usize::from(has_files)]);
        if !has_files && until / every > MOST_ROWS {
            return Err(format!(
                "--every {every} makes a table of more than {MOST_ROWS} rows: with `--csv FILE`"
            )
            .into());
        }
        let method = words.value("--method").map(|text| text.parse()).transpose()?.unwrap_or_default();
        let (set, input) = (words.values("--set"), words.values("--input"));
        let rows = if words.takes("--sampled") { Rows::Sampled } else { Rows::All };
        let (signals, stats) = (Signals::new(words)?, words.takes("--stats"));
        Ok(Asked { until, every, set, input, signals, method, rows, stats, json, csv, view, out })
    }
}

/// A positive time, s.
fn time(option: &str, text: Option<String>) -> Result<Option<f64>, Failure> {
    let Some(text) = text else { return Ok(None) };
    let time = text.parse().ok().filter(|time| *time > 0.0 && f64::is_finite(*time));
    Ok(Some(time.ok_or_else(|| format!("{option} wants a positive time in seconds, not `{text}`"))?))
}
