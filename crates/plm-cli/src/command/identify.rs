//! `plm identify`: parameters and start values of a declaration from measurements.

use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use plm_dynamic::{Dynamic, Integrator, Mechanism};
use plm_studies::optimise::{ByDop853, ByRadau, Error, Fit, Identification, Integration, Progress};
use plm_view::{Page, Results};

mod asked;

use self::asked::{Asked, Unknowns};
use super::clock;
use super::run::{refused, setting, write_whole};
use super::words::Words;
use super::{Command, Failure, Outcome, Streams};
use crate::excerpt::is_rust;
use crate::fitted::{Found, with_values};
use crate::read;

pub(super) const COMMAND: Command = Command {
    name: "identify",
    usage: "FILE --csv READINGS --fit NAMES …",
    title: "finds parameters and start values of a declaration from measurements",
    options: &[
        (
            "--csv FILE",
            "readings: times, outputs and inputs with their units, as `run --csv` and others write them; one for each experiment",
        ),
        (
            "--fit NAMES",
            "what all experiments have in common, with first guesses (`--fit mass,k=20N/mm,bob.angle`)",
        ),
        ("--each NAMES", "what each experiment has by itself, such as starts"),
        ("--bounds NAME=LEAST..MOST", "bounds of an unknown; one of them may be left out (`--bounds k=0..`)"),
        ("--expected NAME=VALUE..DEVIATION", "what is known beforehand, with its standard deviation"),
        ("--deviation OUTPUT=VALUE", "the standard deviation of a reading; without it residuals tell it"),
        ("--only NAMES", "the columns that are read; without it all"),
        ("--set NAME=VALUE", "a parameter that is known, in its declared unit or with one"),
        ("--input NAME=VALUE", "an input over all experiments"),
        (
            "--from TIME",
            "the time of the readings at which the run begins (`--from 100s`); `first` is that of the first one",
        ),
        (
            "--loss NAME[:NUMBER]",
            "Squares, or Huber with its border in deviations, where some readings are wrong (Huber:1.345)",
        ),
        ("--segments COUNT", "segments of each experiment, for long and unstable motions"),
        ("--method NAME[:NUMBER]", "Dop853 or RadauIia5 with its tolerance (Dop853:1e-10)"),
        (
            "--view FILE",
            "writes a page that moves (HTML), with measured values and residuals beside the outputs",
        ),
        ("--chart FILE", "writes readings, model and residuals as a picture (SVG)"),
        ("--out FILE", "writes the declaration with the values that were found"),
    ],
    run,
};

/// The mechanism with its numbers, of at most 8 bodies.
type Small = Dynamic<f64, 24, 32, 64, 24>;

fn run(mut words: Words, streams: &mut Streams) -> Result<Outcome, Failure> {
    let asked = Asked::new(&mut words)?;
    let file = read::file(&words.file()?, streams.input)?;
    if is_rust(&file.name) {
        let name = file.name;
        return Err(format!("{name}: it wants a file that is a declaration (`.plm`), not Rust").into());
    }
    let problem = Mechanism::from_named_text(&file.name, &file.text)
        .map_err(Failure::from)
        .and_then(|own| problem(&asked, own, streams));
    let problem = match problem {
        Ok(problem) => problem,
        Err(failure) => return refused(failure, streams),
    };
    let outcome = match asked.method {
        Integrator::Dop853(tolerance) => found(&asked, &problem, ByDop853(tolerance), &file, streams),
        Integrator::RadauIia5(tolerance) => found(&asked, &problem, ByRadau(tolerance), &file, streams),
        _ => Err("an identification runs by Dop853 or RadauIia5".into()),
    };
    match outcome {
        Err(failure) => match failure.downcast_ref::<Error>() {
            // The readings and the mechanism do not go together.
            Some(Error::AtGuess { .. } | Error::NotConverged { .. }) => {
                writeln!(streams.errors, "plm: {failure}")?;
                Ok(Outcome::Wrong)
            }
            _ => Err(failure),
        },
        outcome => outcome,
    }
}

/// The identification that is asked for.
fn problem(
    asked: &Asked,
    mut mechanism: Mechanism,
    streams: &mut Streams,
) -> Result<Identification<Small>, Failure> {
    for text in &asked.set {
        let (name, value) = setting("--set", text, mechanism.declared_parameters())?;
        mechanism.set_parameter(name, value)?;
    }
    let unknowns = Unknowns::new(asked, &mut mechanism)?;
    let inputs: Vec<(&str, f64)> = asked
        .input
        .iter()
        .map(|text| setting("--input", text, mechanism.declared_inputs()))
        .collect::<Result<_, _>>()?;
    let mut problem = Identification::new(mechanism.small()?).loss(asked.loss).watched_by(progress());
    for unknown in unknowns.shared {
        problem = problem.find(unknown);
    }
    for path in &asked.csv {
        let recording = clock::read(path, asked.from, streams)?;
        let experiment = asked.experiment(&recording, &mechanism)?.segments(asked.segments);
        let mut experiment = match asked.from.and_then(|from| from.of(&recording)) {
            Some(time) => experiment.beginning_at(time),
            None => experiment,
        };
        for (name, value) in &inputs {
            let unit = mechanism.inputs().find(|(own, _)| own == name).map_or("", |(_, unit)| unit);
            experiment = experiment.input(name, unit, [0.0], [*value]);
        }
        for unknown in &unknowns.each {
            experiment = experiment.find(unknown.clone());
        }
        problem = problem.experiment(experiment);
    }
    Ok(problem)
}

/// Identifies, and writes the requested files.
fn found<D: Integration<Small>>(
    asked: &Asked,
    problem: &Identification<Small>,
    integration: D,
    file: &read::File,
    streams: &mut Streams,
) -> Result<Outcome, Failure> {
    let fit = problem.run_by(integration).map_err(|error| explained(asked, error))?;
    write!(streams.output, "{}", fit.table())?;
    if let Some(path) = &asked.chart {
        fit.chart(integration)?.write_svg(path)?;
    }
    if let Some(path) = &asked.view {
        let runs = (0..asked.csv.len()).map(|k| fit.recording(k, integration));
        let results = Results { runs: runs.collect::<Result<_, _>>()?, ..Results::default() };
        let name = results.runs.first().map_or(String::new(), |run| run.about.mechanism.name.clone());
        Page::new(&results.to_bytes()?, &name).write_html(path)?;
    }
    asked.out.as_ref().map_or(Ok(()), |path| declaration(&fit, file, path, streams))?;
    let notices = fit.notices();
    for notice in &notices {
        writeln!(streams.errors, "plm: {notice}")?;
    }
    Ok(if notices.is_empty() { Outcome::Good } else { Outcome::Doubtful })
}

/// Progress is reported after this duration, and no more often.
const LONG: Duration = Duration::from_secs(3);

/// Observer that reports the progress of a long search on the terminal, on standard error.
fn progress() -> impl Fn(&Progress) + Send + Sync + 'static {
    let told = Mutex::new(Instant::now());
    move |progress| {
        let Ok(mut told) = told.lock() else { return };
        if told.elapsed() >= LONG && std::io::stderr().is_terminal() {
            *told = Instant::now();
            // If messages cannot be written, there is no place to report it.
            let _ = writeln!(std::io::stderr(), "plm: {progress}");
        }
    }
}

/// Writes the declaration with the values that all experiments have in common.
fn declaration(
    fit: &Fit<Small>,
    file: &read::File,
    path: &str,
    streams: &mut Streams,
) -> Result<(), Failure> {
    let shared = fit.estimates.iter().filter(|estimate| estimate.experiment.is_none());
    let found: Vec<Found<'_>> =
        shared.map(|own| Found { name: &own.name, value: own.value / own.factor, unit: own.unit }).collect();
    let (text, missing) = with_values(&file.name, &file.text, &found);
    for name in missing {
        writeln!(
            streams.errors,
            "plm: `{name}` stands nowhere in {} by itself: it is left as it is",
            file.name
        )?;
    }
    write_whole(path, text.as_bytes(), streams.output)
}

/// Adds to the error of an unknown column how it is left out.
fn explained(asked: &Asked, error: Error) -> Failure {
    match &error {
        Error::Unknown { what: "output", .. } if asked.only.is_empty() => {
            format!("{error}; `--only NAMES` names the columns that are read").into()
        }
        _ => error.into(),
    }
}
