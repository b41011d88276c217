//! Arguments of `plm identify`.

use std::path::PathBuf;

use plm_dynamic::{Integrator, Mechanism};
use plm_studies::optimise::{Experiment, Loss, Unknown};
use plm_view::Recording;

use super::super::Failure;
use super::super::clock::Begin;
use super::super::words::{Words, known, names};
use crate::readings::experiment;
use crate::value::{declared_value, value};

/// Parsed arguments of the command.
pub(super) struct Asked {
    pub(super) csv: Vec<String>,
    fit: Vec<String>,
    each: Vec<String>,
    bounds: Vec<String>,
    expected: Vec<String>,
    deviation: Vec<String>,
    pub(super) only: Vec<String>,
    pub(super) set: Vec<String>,
    pub(super) input: Vec<String>,
    /// The time of the readings at which the run begins.
    pub(super) from: Option<Begin>,
    pub(super) loss: Loss,
    pub(super) segments: usize,
    pub(super) method: Integrator,
    pub(super) view: Option<PathBuf>,
    pub(super) chart: Option<PathBuf>,
    pub(super) out: Option<String>,
}

/// The tolerance of runs whose derivatives are fitted.
const TOLERANCE: f64 = 1e-10;

impl Asked {
    pub(super) fn new(words: &mut Words) -> Result<Asked, Failure> {
        let [fit, each, only] = ["--fit", "--each", "--only"].map(|option| names(&words.values(option)));
        let [bounds, expected, deviation, csv, set, input] =
            ["--bounds", "--expected", "--deviation", "--csv", "--set", "--input"]
                .map(|option| words.values(option));
        let [view, chart] = ["--view", "--chart"].map(|option| words.value(option).map(PathBuf::from));
        let out = words.value("--out");
        if csv.is_empty() {
            return Err("an identification needs readings: `--csv FILE`".into());
        }
        if fit.is_empty() && each.is_empty() {
            return Err("an identification needs unknowns: `--fit NAMES`".into());
        }
        let segments = words.value("--segments").unwrap_or_else(|| "1".to_owned());
        let segments = segments
            .parse()
            .ok()
            .filter(|count| *count > 0)
            .ok_or_else(|| format!("--segments wants a positive whole number, not `{segments}`"))?;
        let from = Begin::asked(words)?;
        let loss = words.value("--loss").map_or(Ok(Loss::Squares), |text| loss(&text))?;
        let method = words.value("--method").map(|text| text.parse()).transpose()?;
        let method = method.unwrap_or(Integrator::Dop853(TOLERANCE));
        Ok(Asked {
            csv,
            fit,
            each,
            bounds,
            expected,
            deviation,
            only,
            set,
            input,
            from,
            loss,
            segments,
            method,
            view,
            chart,
            out,
        })
    }

    /// The readings of a file, with deviations that are given.
    pub(super) fn experiment(
        &self,
        recording: &Recording,
        mechanism: &Mechanism,
    ) -> Result<Experiment, Failure> {
        let names: Vec<&str> = recording.columns().iter().map(|column| column.name.as_str()).collect();
        known("--only", self.only.iter().map(String::as_str), &names)?;
        let mut experiment = experiment(recording, &self.only, mechanism)?;
        for text in &self.deviation {
            let (name, given) = assigned("--deviation", text, "bob.angle=0.3deg")?;
            known("--deviation", std::iter::once(name), &names)?;
            let column = recording.columns().iter().find(|column| column.name == name);
            let unit = column.map_or("", |column| column.unit.as_str());
            let wrong = |why| format!("--deviation {name}: {why}");
            // A number alone is in the unit of the column.
            let deviation = match given.trim().parse::<f64>() {
                Ok(number) => number,
                Err(_) => {
                    value(given, unit).map_err(wrong)? / value(&format!("1 {unit}"), unit).map_err(wrong)?
                }
            };
            if !(deviation > 0.0 && deviation.is_finite()) {
                return Err(format!("--deviation {name} wants a positive value, not `{given}`").into());
            }
            experiment = experiment.deviation(name, deviation);
        }
        Ok(experiment)
    }
}

/// A loss by its name, with the border that it has without a number.
fn loss(text: &str) -> Result<Loss, Failure> {
    let (name, number) = text.split_once(':').map_or((text, None), |(name, number)| (name, Some(number)));
    let number = number.map(|number| number.trim().parse::<f64>()).transpose();
    match (name.to_lowercase().as_str(), number) {
        ("squares", Ok(None)) => Ok(Loss::Squares),
        ("huber", Ok(number)) => Ok(Loss::Huber(number.unwrap_or(1.345))),
        _ => Err(format!("--loss wants Squares, Huber or Huber:NUMBER, not `{text}`").into()),
    }
}

/// Unknowns that all experiments have in common, and those that each has by itself.
pub(super) struct Unknowns {
    pub(super) shared: Vec<Unknown>,
    pub(super) each: Vec<Unknown>,
}

impl Unknowns {
    /// Looks names up among parameters and start values. Parameters without a default get their guess.
    pub(super) fn new(asked: &Asked, mechanism: &mut Mechanism) -> Result<Unknowns, Failure> {
        let all: Vec<&str> = asked.fit.iter().chain(&asked.each).map(|text| name_of(text)).collect();
        if let Some(twice) =
            all.iter().enumerate().find_map(|(k, name)| all[..k].contains(name).then_some(name))
        {
            return Err(format!("`{twice}` is one unknown, and is given twice").into());
        }
        for (option, texts) in [("--bounds", &asked.bounds), ("--expected", &asked.expected)] {
            let names = texts.iter().map(|text| name_of(text));
            known(option, names, &all)?;
        }
        let mut of = |texts: &[String], option| {
            texts.iter().map(|text| unknown(asked, mechanism, (option, text))).collect::<Result<Vec<_>, _>>()
        };
        Ok(Unknowns { shared: of(&asked.fit, "--fit")?, each: of(&asked.each, "--each")? })
    }
}

/// An unknown with its guess and its bounds.
fn unknown(
    asked: &Asked,
    mechanism: &mut Mechanism,
    (option, text): (&str, &str),
) -> Result<Unknown, Failure> {
    let name = name_of(text);
    let own = mechanism.declared_parameters().find(|own| own.name == name);
    let parameter = own.map(|own| (own.si.to_owned(), own.factor));
    let (mut unknown, unit) = match &parameter {
        Some((unit, _)) => (Unknown::parameter(name), unit.as_str()),
        None if mechanism.starts().contains(&name) => (Unknown::start(name), unit_of_start(name)),
        None => {
            let parameters = mechanism.parameters().map(|(name, _)| name);
            let all: Vec<&str> = parameters.chain(mechanism.starts().iter().copied()).collect();
            return Err(format!(
                "{option}: there is no parameter or start value `{name}`; there are {}",
                all.join(", ")
            )
            .into());
        }
    };
    let factor = parameter.as_ref().map_or(1.0, |(_, factor)| *factor);
    let read = |option: &str, given: &str| {
        declared_value(given, unit, factor).map_err(|why| format!("{option} {name}: {why}"))
    };
    if let Some((_, given)) = text.split_once('=') {
        let guess = read(option, given)?;
        unknown = unknown.from(guess);
        if parameter.is_some() {
            mechanism.set_parameter(name, guess)?;
        }
    }
    let of = |texts: &'_ [String]| texts.iter().rfind(|text| name_of(text) == name).cloned();
    if let Some(text) = of(&asked.bounds) {
        let (least, most) = pair("--bounds", &text)?;
        let bound =
            |given: &str, open| if given.trim().is_empty() { Ok(open) } else { read("--bounds", given) };
        unknown = unknown.within(bound(least, f64::NEG_INFINITY)?, bound(most, f64::INFINITY)?);
    }
    if let Some(text) = of(&asked.expected) {
        let (value, deviation) = pair("--expected", &text)?;
        unknown = unknown.expected(read("--expected", value)?, read("--expected", deviation)?);
    }
    Ok(unknown)
}

/// The unit of a start value of a body in SI; a first-order state is given in SI.
fn unit_of_start(name: &str) -> &'static str {
    match name.rsplit('.').next().unwrap_or_default() {
        "angle" => "rad",
        "omega" => "rad/s",
        "x" | "y" => "m",
        "vx" | "vy" => "m/s",
        _ => "",
    }
}

fn name_of(text: &str) -> &str {
    text.split_once('=').map_or(text, |(name, _)| name).trim()
}

fn assigned<'a>(option: &str, text: &'a str, example: &str) -> Result<(&'a str, &'a str), Failure> {
    let (name, given) = text
        .split_once('=')
        .ok_or_else(|| format!("{option} wants NAME=VALUE, as in `{option} {example}`, not `{text}`"))?;
    Ok((name.trim(), given))
}

/// Two values after a name: `k=1..2`.
fn pair<'a>(option: &str, text: &'a str) -> Result<(&'a str, &'a str), Failure> {
    let two = text.split_once('=').and_then(|(_, range)| range.split_once(".."));
    two.ok_or_else(|| {
        format!("{option} wants two values, as in `{option} k=1N/m..5N/m`, not `{text}`").into()
    })
}
