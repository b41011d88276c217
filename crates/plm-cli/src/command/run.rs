//! `plm run`: the motion of a declaration over time.

use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;

use plm_compiler::bug_message;
use plm_dynamic::{Course, Declared, Error, Mechanism, Reason, Refused, Run, Sample, Watch};
use plm_view::svg::write_file;

mod asked;
mod fault;
mod following;
mod json;
mod recording;
mod signals;
mod told;

use self::asked::{Asked, Rows};
use self::following::Following;
use self::signals::Driven;
use self::told::Event;
use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::excerpt::is_rust;
use crate::interrupt;
use crate::quote::too_large;
use crate::read::{self, File};
use crate::table::{aligned, csv_headings, csv_row, heading};
use crate::value::declared_value;

pub(super) const COMMAND: Command = Command {
    name: "run",
    usage: "FILE --until SECONDS …",
    title: "runs a declaration, and writes its outputs over time",
    options: &[
        ("--until SECONDS", "when the run ends"),
        ("--every SECONDS", "between samples; without it 20 in a table, 1000 in files"),
        (
            "--set NAME=VALUE",
            "a parameter, in its declared unit or with one (`--set length=20cm`); as often as wanted",
        ),
        ("--input NAME=VALUE", "an input over the run, in its declared unit or with one; as often as wanted"),
        (
            "--inputs FILE",
            "inputs over time from a CSV: times, and columns by the names of inputs with their units; straight lines between readings",
        ),
        ("--hold", "inputs of a CSV hold from one reading to the next, as sampled signals do"),
        ("--only NAMES", "the columns of the CSV that are read; without it all"),
        (
            "--from TIME",
            "the time of the readings at which the run begins (`--from 100s`); `first` is that of the first one",
        ),
        ("--method NAME[:NUMBER]", "the method with its tolerance or its longest step (Dop853:1e-9)"),
        (
            "--sampled",
            "rows of tables and CSV at multiples of `--every` alone: none where something switches or where it ends",
        ),
        ("--stats", "tells counts of steps and contacts, and what switched, on standard error"),
        ("--json", "columns, rows, events, notices and the end as one object of JSON, on standard output"),
        ("--csv FILE", "writes all that compiled programs write as CSV; `-` is the standard output"),
        ("--view FILE", "writes a page that moves (HTML), as compiled programs do"),
        ("--out FILE", "writes a results file (.npz), as compiled programs do"),
    ],
    run,
};

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let asked = Asked::new(&mut words)?;
    let file = read::file(&words.file()?, streams.input)?;
    if is_rust(&file.name) {
        return Err(
            format!("{}: a run wants a file that is a declaration (`.plm`), not Rust", file.name).into()
        );
    }
    let started = Mechanism::from_named_text(&file.name, &file.text)
        .map_err(Failure::from)
        .and_then(|own| Driven::new(&asked, own, &file, streams))
        .and_then(|own| started(&asked, own, streams));
    let (mechanism, mut run, mut course) = match started {
        Ok(started) => started,
        Err(failure) => return not_started(&asked, &file, failure, streams),
    };
    let inputs = &mut course;
    let (begin, way) = (run.time(), (asked.method, asked.until));
    let mut following = Following::new((&mechanism, begin), way, &mut *streams.errors);
    if asked.json {
        let ended = json::gathered(&asked, &mut run, inputs, &mut following);
        following.end();
        return ended.write(&mut run, &file, streams);
    }
    let (outcome, events) = if asked.view.is_some() || asked.out.is_some() {
        recording::write(&asked, &mut run, inputs, &mut following, streams.output)?
    } else if let Some(name) = &asked.csv {
        as_csv(&asked, &mut run, inputs, &mut following, &mut *file_to(name, streams.output)?)?
    } else {
        as_table(&asked, &mut run, inputs, &mut following, streams.output)?
    };
    following.end();
    told::notices(&mut run, streams.errors)?;
    if asked.stats {
        told::stats(&mut run, &events, streams.errors)?;
    }
    match outcome {
        Err(Error::Fault(fault)) => {
            fault::ended(&fault, &file, streams.errors)?;
            Ok(Outcome::Wrong)
        }
        Err(error) => refused(error.into(), streams),
        Ok(()) if interrupt::came() => {
            writeln!(
                streams.errors,
                "plm: ended at t = {} s by Ctrl+C: what came before is written",
                run.time()
            )?;
            Ok(Outcome::Wrong)
        }
        Ok(()) => Ok(Outcome::Good),
    }
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

/// The mechanism with the values that are asked for, its run, and the course of its inputs.
fn started(
    asked: &Asked,
    driven: Driven,
    streams: &mut Streams,
) -> Result<(Mechanism, Run, Course), Failure> {
    let Driven { mut mechanism, course, begin } = driven;
    translate(&mechanism);
    for text in &asked.set {
        let (name, value) = setting("--set", text, mechanism.declared_parameters())?;
        mechanism.set_parameter(name, value)?;
    }
    for (name, value) in begin {
        mechanism.set_input(&name, value)?;
    }
    let run = mechanism.start_with(asked.method)?;
    if let Some(far) = mechanism.far_start() {
        writeln!(streams.errors, "plm: {far}")?;
    }
    Ok((mechanism, run, course))
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

/// Name and value, SI, of a setting of one of these quantities, in its declared unit or with one. A name that is none of them has the value 0: to set
/// it is the mistake.
pub(super) fn setting<'a, 'b>(
    option: &str,
    text: &'a str,
    mut quantities: impl Iterator<Item = Declared<'b>>,
) -> Result<(&'a str, f64), Failure> {
    let wrong = || format!("{option} wants NAME=VALUE, as in `{option} length=20cm`, not `{text}`");
    let (name, given) = text.split_once('=').ok_or_else(wrong)?;
    let name = name.trim();
    let Some(own) = quantities.find(|known| known.name == name) else { return Ok((name, 0.0)) };
    Ok((name, declared_value(given, own.si, own.factor).map_err(|why| format!("{option} {name}: {why}"))?))
}

/// Reports why there is no run. A start that cannot be assembled gets the compiler's diagnostics.
fn not_started(
    asked: &Asked,
    file: &File,
    failure: Failure,
    streams: &mut Streams,
) -> Result<Outcome, Failure> {
    if let Some(Error::Fault(fault)) = failure.downcast_ref::<Error>() {
        fault::at_start(fault, file, &asked.set, streams.errors)?;
        return Ok(Outcome::Wrong);
    }
    match failure.downcast_ref::<Error>() {
        Some(Error::Refused(own @ Refused::TooLarge { .. })) => {
            write!(streams.errors, "{}", too_large(own, "plm", file))?;
            Ok(Outcome::Wrong)
        }
        _ => refused(failure, streams),
    }
}

/// Reports why there is no run, or why it has ended.
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

/// Columns after the time, with their headings. Where nothing is declared as output, the poses of all bodies stand in front.
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

/// Rows for a function, and what switches.
struct Rowed<'a, 'b, F> {
    following: &'a mut Following<'b>,
    rows: Rows,
    columns: &'a [Number],
    row: F,
    events: Vec<Event>,
    /// The rows can be taken no more.
    ends: bool,
}

impl<F: FnMut(Vec<f64>) -> bool> Watch for Rowed<'_, '_, F> {
    fn sample(&mut self, sample: &Sample, reason: Reason) {
        let is_wanted = self.rows == Rows::All || reason == Reason::Interval;
        if is_wanted && !(self.row)(row(self.columns, sample)) {
            self.ends = true;
        }
    }

    fn event(&mut self, time: f64, what: &str) {
        self.events.push((time, what.to_owned()));
    }

    fn goes_on(&mut self, time: f64) -> bool {
        self.following.goes_on(time) && !self.ends
    }
}

/// How a run has ended, and what switched in it.
type Ended = (Result<(), Error>, Vec<Event>);

/// Runs, and gives a function each row, which says whether the run goes on.
fn rowed(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
    columns: &[Number],
    row: impl FnMut(Vec<f64>) -> bool,
) -> Ended {
    let mut watch = Rowed { following, rows: asked.rows, columns, row, events: Vec::new(), ends: false };
    let outcome = if course.is_empty() {
        run.watch(asked.until, asked.every, &mut watch)
    } else {
        run.watch_driven(asked.until, asked.every, course, &mut watch)
    };
    (outcome, watch.events)
}

/// Writes a table when the run has ended; its outcome.
fn as_table(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
    to: &mut dyn Write,
) -> Result<Ended, Failure> {
    let (columns, headings) = columns(run, false);
    let mut rows = Vec::new();
    let ended = rowed(asked, run, course, following, &columns, |row| {
        rows.push(row);
        true
    });
    let mut to = BufWriter::new(to);
    aligned(&headings, &rows, &mut to)?;
    to.flush()?;
    Ok(ended)
}

/// Writes CSV while it runs, as long as it can be written; the outcome of the run.
fn as_csv(
    asked: &Asked,
    run: &mut Run,
    course: &mut Course,
    following: &mut Following,
    to: &mut dyn Write,
) -> Result<Ended, Failure> {
    let (columns, headings) = columns(run, true);
    let mut to = BufWriter::new(to);
    csv_headings(&headings, &mut to)?;
    let mut written = Ok(());
    let ended = rowed(asked, run, course, following, &columns, |row| {
        if written.is_ok() {
            written = csv_row(&row, &mut to);
        }
        written.is_ok()
    });
    written?;
    to.flush()?;
    Ok(ended)
}
