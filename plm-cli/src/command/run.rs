//! `plm run`: the motion of a declaration over time.

use std::fs;
use std::io::{BufWriter, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use plm_compiler::bug_message;
use plm_dynamic::{Error, Integrator, Mechanism, Refused, Run, Sample};
use plm_view::svg::write_file;

mod recording;

use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::excerpt::is_rust;
use crate::read;
use crate::table::{aligned, csv_headings, csv_row, heading};
use crate::value::value;

pub(super) const COMMAND: Command = Command {
    name: "run",
    usage: "FILE --until SECONDS …",
    title: "runs a declaration, and writes its outputs over time",
    options: &[
        ("--until SECONDS", "when the run ends"),
        ("--every SECONDS", "between samples; without it 20 in a table, 1000 in files"),
        ("--set NAME=VALUE", "a parameter, in SI or with a unit (`--set length=20cm`); as often as wanted"),
        ("--input NAME=VALUE", "an input over the run, in SI or with a unit; as often as wanted"),
        ("--method NAME[:NUMBER]", "the method with its tolerance or its longest step (Dop853:1e-9)"),
        ("--csv FILE", "writes all that compiled programs write as CSV; `-` is the standard output"),
        ("--view FILE", "writes a page that moves (HTML), as compiled programs do"),
        ("--out FILE", "writes a results file (.npz), as compiled programs do"),
    ],
    run,
};

/// Samples of a table, and of CSV as compiled programs have it.
const SAMPLES: [f64; 2] = [20.0, 1000.0];
/// More rows than anybody reads.
const MOST_ROWS: f64 = 1e5;

/// The words of the command.
struct Asked {
    until: f64,
    every: f64,
    set: Vec<String>,
    input: Vec<String>,
    method: Integrator,
    csv: Option<String>,
    view: Option<PathBuf>,
    out: Option<PathBuf>,
}

impl Asked {
    fn new(words: &mut Words) -> Result<Asked, Failure> {
        let csv = words.value("--csv");
        let [view, out] = ["--view", "--out"].map(|option| words.value(option).map(PathBuf::from));
        let has_files = csv.is_some() || view.is_some() || out.is_some();
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
        Ok(Asked { until, every, set, input, method, csv, view, out })
    }
}

/// A positive time, s.
fn time(option: &str, text: Option<String>) -> Result<Option<f64>, Failure> {
    let Some(text) = text else { return Ok(None) };
    let time = text.parse().ok().filter(|time| *time > 0.0 && f64::is_finite(*time));
    Ok(Some(time.ok_or_else(|| format!("{option} wants a positive time in seconds, not `{text}`"))?))
}

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let asked = Asked::new(&mut words)?;
    let file = read::file(&words.file()?, streams.input)?;
    if is_rust(&file.name) {
        return Err(
            format!("{}: a run wants a file that is a declaration (`.plm`), not Rust", file.name).into()
        );
    }
    let mut run = match started(&asked, Mechanism::from_named_text(&file.name, &file.text)) {
        Ok(run) => run,
        Err(error) => return refused(error, streams),
    };
    let outcome = if asked.view.is_some() || asked.out.is_some() {
        recording::write(&asked, &mut run, streams.output)?
    } else if let Some(name) = &asked.csv {
        as_csv(&asked, &mut run, &mut *file_to(name, streams.output)?)?
    } else {
        as_table(&asked, &mut run, streams.output)?
    };
    outcome.map_or_else(|error| refused(error.into(), streams), |()| Ok(Outcome::Good))
}

/// Writes a file as a whole, with the folders above it, or leaves it as it was; `-` is the standard output.
pub(super) fn write_whole(name: &str, contents: &[u8], output: &mut dyn Write) -> Result<(), Failure> {
    if name == "-" {
        return Ok(output.write_all(contents)?);
    }
    Ok(write_file(Path::new(name), Ok(contents.to_vec()))?)
}

/// The file of this name, with the folders above it, to which rows are written as they come; `-` is the standard output.
fn file_to<'a>(name: &str, output: &'a mut dyn Write) -> Result<Box<dyn Write + 'a>, Failure> {
    if name == "-" {
        return Ok(Box::new(output));
    }
    let unwritten = |why: std::io::Error| format!("{name}: {why}");
    if let Some(folder) = Path::new(name).parent() {
        fs::create_dir_all(folder).map_err(unwritten)?;
    }
    Ok(Box::new(fs::File::create(name).map_err(unwritten)?))
}

/// A run with the values that are asked for.
fn started(asked: &Asked, mechanism: Result<Mechanism, Error>) -> Result<Run, Failure> {
    let mut mechanism = mechanism?;
    translate(&mechanism);
    for text in &asked.set {
        let (name, value) = setting("--set", text, mechanism.parameters())?;
        mechanism.set_parameter(name, value)?;
    }
    for text in &asked.input {
        let (name, value) = setting("--input", text, mechanism.inputs())?;
        mechanism.set_input(name, value)?;
    }
    Ok(mechanism.start_with(asked.method)?)
}

/// Has a run computed by machine code, where there is some for this processor.
#[cfg(feature = "jit")]
fn translate(mechanism: &Mechanism) {
    if let Some(host) = plm_jit::Host::new() {
        mechanism.translate_by(std::sync::Arc::new(host.in_background()));
    }
}

/// Without machine code a run is interpreted.
#[cfg(not(feature = "jit"))]
fn translate(_: &Mechanism) {}

/// Name and value, SI, of a setting of one of these quantities with their SI units. A name that is none of them has the value 0: to set
/// it is the mistake.
pub(super) fn setting<'a, 'b>(
    option: &str,
    text: &'a str,
    mut quantities: impl Iterator<Item = (&'b str, &'b str)>,
) -> Result<(&'a str, f64), Failure> {
    let wrong = || format!("{option} wants NAME=VALUE, as in `{option} length=20cm`, not `{text}`");
    let (name, given) = text.split_once('=').ok_or_else(wrong)?;
    let name = name.trim();
    let Some((_, unit)) = quantities.find(|(known, _)| *known == name) else { return Ok((name, 0.0)) };
    Ok((name, value(given, unit).map_err(|why| format!("{option} {name}: {why}"))?))
}

/// Tells why there is no run, or why it has ended.
pub(super) fn refused(failure: Failure, streams: &mut Streams) -> Result<Outcome, Failure> {
    match failure.downcast_ref::<Error>() {
        Some(Error::Refused(Refused::Bug(what))) => return Err(bug_message(what).into()),
        Some(Error::Refused(Refused::Mistakes(text))) => writeln!(streams.errors, "{}", text.trim_end())?,
        Some(Error::Refused(refused)) => writeln!(streams.errors, "plm: {refused}")?,
        Some(Error::Fault(fault)) => writeln!(streams.errors, "plm: {fault}")?,
        Some(Error::NotGiven(name)) => return Err(format!("{failure}, by `--set {name}=VALUE`").into()),
        _ => return Err(failure),
    }
    Ok(Outcome::Wrong)
}

/// A column: a number of a sample.
#[derive(Clone, Copy)]
enum Number {
    /// Of a body, the one of x, y, angle with this number.
    Pose(usize, usize),
    /// Of the values.
    Value(usize),
}

impl Number {
    fn of(self, sample: &Sample) -> f64 {
        let number = match self {
            Number::Pose(body, k) => sample.bodies.get(body).map(|body| body.components()[k]),
            Number::Value(k) => sample.values.get(k).copied(),
        };
        number.unwrap_or(f64::NAN)
    }
}

/// Columns behind the time, with their headings. Where nothing is declared as output, the poses of all bodies stand in front.
fn columns(run: &Run, with_observed: bool) -> (Vec<Number>, Vec<String>) {
    let mut columns = Vec::new();
    if !run.all_columns().iter().any(|column| column.declared) {
        for (body, name) in run.bodies().enumerate() {
            let pose = [("x", "m"), ("y", "m"), ("angle", "rad")].into_iter().enumerate();
            columns.extend(
                pose.map(|(k, (axis, unit))| {
                    (Number::Pose(body, k), heading(&format!("{name}.{axis}"), unit))
                }),
            );
        }
    }
    let values = run.all_columns().iter().enumerate().filter(|(_, column)| column.declared || with_observed);
    columns.extend(values.map(|(k, column)| (Number::Value(k), heading(&column.name, &column.unit))));
    let (numbers, mut headings): (Vec<Number>, Vec<String>) = columns.into_iter().unzip();
    headings.insert(0, heading("time", "s"));
    (numbers, headings)
}

fn row(columns: &[Number], sample: &Sample) -> Vec<f64> {
    std::iter::once(sample.time).chain(columns.iter().map(|column| column.of(sample))).collect()
}

/// Writes a table when the run has ended; its outcome.
fn as_table(asked: &Asked, run: &mut Run, to: &mut dyn Write) -> Result<Result<(), Error>, Failure> {
    let (columns, headings) = columns(run, false);
    let mut rows = Vec::new();
    let outcome = run.record(asked.until, asked.every, |sample| {
        rows.push(row(&columns, sample));
        ControlFlow::Continue(())
    });
    let mut to = BufWriter::new(to);
    aligned(&headings, &rows, &mut to)?;
    to.flush()?;
    Ok(outcome)
}

/// Writes CSV while it runs, as long as it can be written; the outcome of the run.
fn as_csv(asked: &Asked, run: &mut Run, to: &mut dyn Write) -> Result<Result<(), Error>, Failure> {
    let (columns, headings) = columns(run, true);
    let mut to = BufWriter::new(to);
    csv_headings(&headings, &mut to)?;
    let mut written = Ok(());
    let outcome = run.record(asked.until, asked.every, |sample| {
        written = csv_row(&row(&columns, sample), &mut to);
        if written.is_ok() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    });
    written?;
    to.flush()?;
    Ok(outcome)
}
