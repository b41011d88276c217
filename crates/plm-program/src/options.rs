//! The options that programs over a mechanism have in common.

mod values;

use std::ffi::OsString;
use std::path::PathBuf;
use std::str::FromStr;

use plm_foreign::By;
use plm_foreign::fmi::Version;
use plm_run::{BadOption, Integrator, METHODS, nearest};
use plm_runtime::described::{Quantity, by_number};
use plm_runtime::{AsMoment, Described, Method, Moment, Sim, Statics};
use plm_view::Recorder;

use self::values::{methods, port_of, settings, time, version_of};
use super::arguments::{Arguments, Known};

/// Options of the command line.
///
/// ```
/// use plm::view::{Known, Options};
///
/// let options = Options::parse(["--until", "5", "--set", "mass=3", "--csv=run.csv"])?;
/// assert_eq!((options.until, options.csv.as_deref()), (Some(5.0), Some("run.csv".as_ref())));
/// // A program's own options stand in the same table; options that it has no use for do not.
/// let table = Options::table().without(&["csv"]).with(&[Known::value("gain", "NUMBER", "of the controller")]);
/// assert_eq!(table.parse(["--gain", "2.5"])?.own.number("gain")?, Some(2.5));
/// assert!(table.parse(["--csv", "run.csv"]).is_err());
/// assert!(Options::parse(["--untl", "5"]).unwrap_err().to_string().contains("--until"));
/// # Ok::<(), plm::view::BadOption>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// `--view FILE`: the page that moves.
    pub view: Option<PathBuf>,
    /// `--live`: the page holds the mechanism itself, to be run in it.
    pub live: bool,
    /// `--serve[=PORT]`: the program serves the page while it runs; the port is chosen by the system where it is 0.
    pub serve: Option<u16>,
    /// `--csv FILE`: the table.
    pub csv: Option<PathBuf>,
    /// `--svg FILE`: the curves.
    pub svg: Option<PathBuf>,
    /// `--out FILE`: the results file.
    pub out: Option<PathBuf>,
    /// `--c FOLDER`: a static library of the mechanism, and its header.
    pub c: Option<PathBuf>,
    /// `--target NAME`: what that library is for, without an operating system, as rustc calls it.
    pub target: Option<String>,
    /// `--methods NAMES`: by which methods a mechanism runs in that library, the usual one first; none for that of every library.
    pub methods: Vec<By>,
    /// `--c-source FOLDER`: its C source, with the parameters that are set.
    #[cfg(feature = "c-source")]
    pub c_source: Option<PathBuf>,
    /// `--single`: numbers of 32 bits in it.
    #[cfg(feature = "c-source")]
    pub single: bool,
    /// `--fmu FILE`: an FMU of the mechanism.
    pub fmu: Option<PathBuf>,
    /// `--fmi 2` or `3`: the version that it is for.
    pub fmi: Version,
    /// `--python FOLDER`: a wheel and a source distribution of the mechanism.
    pub python: Option<PathBuf>,
    /// `--until TIME`, s.
    pub until: Option<f64>,
    /// `--every TIME`, s: between samples.
    pub every: Option<f64>,
    /// `--set NAME=VALUE`, as often as wanted: parameters in their declared units.
    pub set: Vec<(String, f64)>,
    /// `--input NAME=VALUE`, as often as wanted: inputs in their declared units, constant during the run.
    pub input: Vec<(String, f64)>,
    /// `--method NAME[:NUMBER]`.
    pub method: Option<Integrator>,
    /// `--help`: the text to be printed.
    pub help: Option<String>,
    /// All that was given, the program's own options among it.
    pub own: Arguments,
}

/// The usual options.
const USUAL: [Known; 17] = [
    Known::value(
        "view",
        "FILE",
        "the page that moves, one HTML file (to target/plm where nothing else is asked for)",
    ),
    Known::flag("live", "the page holds the mechanism itself: parameters are turned, bodies pulled"),
    Known::flag_or_value("serve", "PORT", "serves the page while it runs by the clock; writes no file"),
    Known::value("out", "FILE", "the results file, .npz (NumPy reads it)"),
    Known::value("csv", "FILE", "the table, outputs in their units and all else in SI"),
    Known::value("svg", "FILE", "the curves"),
    Known::value(
        "c",
        "FOLDER",
        "a static library of the mechanism as declared, and its header, for C and C++",
    ),
    Known::value("target", "NAME", "of --c: for a machine without std, such as thumbv7em-none-eabihf"),
    Known::value(
        "methods",
        "NAMES",
        "of --c: the methods that it has, by comma, the usual one first (Dop853)",
    ),
    Known::value("fmu", "FILE", "an FMU of the mechanism as declared (FMI 3.0)"),
    Known::value("fmi", "VERSION", "of --fmu: 2 or 3, for FMI 2.0 or 3.0"),
    Known::value(
        "python",
        "FOLDER",
        "a wheel and a source distribution of the mechanism as declared, for Python (needs maturin)",
    ),
    Known::value("until", "TIME", "when the run ends, s"),
    Known::value("every", "TIME", "between samples, s"),
    Known::value(
        "set",
        "NAME=VALUE",
        "a parameter in its declared unit, and the starts made of it; as often as wanted",
    ),
    Known::value("input", "NAME=VALUE", "an input in its declared unit; as often as wanted"),
    Known::value("method", "NAME[:NUMBER]", METHODS),
];

/// Those of C source.
#[cfg(feature = "c-source")]
const OF_SOURCE: [Known; 2] = [
    Known::value(
        "c-source",
        "FOLDER",
        "its C source, for compilers of any target, with the parameters that are set",
    ),
    Known::flag("single", "of --c-source: numbers of 32 bits"),
];

/// The options that a program knows.
#[derive(Clone, Debug)]
pub struct Table(Vec<Known>);

impl Table {
    /// These too, before the others.
    #[must_use]
    pub fn with(self, own: &[Known]) -> Self {
        Self(own.iter().copied().chain(self.0).collect())
    }

    /// Not those of these names: an option that does nothing would be a promise.
    #[must_use]
    pub fn without(self, names: &[&str]) -> Self {
        Self(self.0.into_iter().filter(|known| !names.contains(&known.name())).collect())
    }

    /// Those of this program.
    ///
    /// # Errors
    /// As [`Options::from_args`].
    pub fn from_args(&self) -> Result<Options, BadOption> {
        self.parse(std::env::args_os().skip(1))
    }

    /// Those of a list of arguments.
    ///
    /// # Errors
    /// As [`Options::from_args`].
    pub fn parse<W: Into<OsString>>(&self, words: impl IntoIterator<Item = W>) -> Result<Options, BadOption> {
        Options::of(Arguments::parse(&self.0, words)?)
    }
}

impl Options {
    /// Those of this program.
    ///
    /// # Errors
    /// An argument that is no option, with the nearest one; a value that is missing or not what it has to be.
    pub fn from_args() -> Result<Self, BadOption> {
        Self::table().from_args()
    }

    /// Those of a list of arguments.
    ///
    /// # Errors
    /// As [`from_args`](Self::from_args).
    pub fn parse<W: Into<OsString>>(words: impl IntoIterator<Item = W>) -> Result<Self, BadOption> {
        Self::table().parse(words)
    }

    /// The table of the usual options, for a program that has others too, or has no use for some.
    pub fn table() -> Table {
        #[cfg(feature = "c-source")]
        return Table([USUAL.as_slice(), &OF_SOURCE].concat());
        #[cfg(not(feature = "c-source"))]
        Table(USUAL.to_vec())
    }

    /// The options that the arguments give.
    fn of(given: Arguments) -> Result<Self, BadOption> {
        let path = |name| given.value(name).map(PathBuf::from);
        let options = Self {
            view: path("view"),
            live: given.flag("live"),
            serve: given.text("serve")?.map(|port| port_of(&port)).transpose()?,
            csv: path("csv"),
            svg: path("svg"),
            out: path("out"),
            c: path("c"),
            target: given.text("target")?,
            methods: methods(given.text("methods")?.as_deref())?,
            #[cfg(feature = "c-source")]
            c_source: path("c-source"),
            #[cfg(feature = "c-source")]
            single: given.flag("single"),
            fmu: path("fmu"),
            fmi: given.text("fmi")?.map_or(Ok(Version::default()), |word| version_of(&word))?,
            python: path("python"),
            until: time("until", &given)?,
            every: time("every", &given)?,
            set: settings("set", &given)?,
            input: settings("input", &given)?,
            method: given.text("method")?.map(|text| Integrator::from_str(&text)).transpose()?,
            help: given.help(),
            own: given,
        };
        options.without_conflict()
    }

    /// Itself, if nothing in it would be left undone in silence.
    fn without_conflict(self) -> Result<Self, BadOption> {
        let among = |names: &[&'static str]| names.iter().copied().find(|name| self.own.flag(name));
        let files = ["view", "live", "csv", "svg", "out"];
        let of_a_run = ["serve", "until", "every", "set", "input", "method"];
        if let (true, Some(name)) = (self.serve.is_some(), among(&files)) {
            return Err(BadOption::new(format!(
                "--serve shows a run that has no end and writes no file: without --{name}; the page saves results itself"
            )));
        }
        let run = among(&files).or_else(|| among(&of_a_run));
        if let (Some(built), Some(name)) = (among(&["c", "fmu", "python"]), run) {
            return Err(BadOption::new(format!(
                "--{built} writes the mechanism as declared and runs nothing: without --{name}"
            )));
        }
        let run = run.filter(|name| *name != "set");
        if let (true, Some(name)) =
            (self.own.flag("c-source"), run.or_else(|| among(&["c", "fmu", "python"])))
        {
            return Err(BadOption::new(format!(
                "--c-source writes source and runs nothing: without --{name}"
            )));
        }
        if self.own.flag("single") && !self.own.flag("c-source") {
            return Err(BadOption::new("--single says what numbers --c-source FOLDER has: with --c-source"));
        }
        if self.own.flag("fmi") && self.fmu.is_none() {
            return Err(BadOption::new("--fmi says which version --fmu FILE is for: with --fmu"));
        }
        if self.target.is_some() && self.c.is_none() {
            return Err(BadOption::new("--target says what --c FOLDER is for: with --c"));
        }
        if !self.methods.is_empty() && self.c.is_none() {
            return Err(BadOption::new("--methods are those of --c FOLDER: with --c"));
        }
        Ok(self)
    }

    /// A recorder of what they need: the declared outputs in their units, or all that a live page shows.
    pub fn recorder<M: Described>(&self, of: &impl AsMoment<State: Moment<M = M>>) -> Recorder<M> {
        if self.live { Recorder::observing_all(of) } else { Recorder::new(of) }
    }

    /// Sets the parameters of a mechanism, and the starts that are made of them; starts that were set by hand stay.
    ///
    /// # Errors
    /// A name that is no parameter, with those that there are.
    pub fn apply<M: Described<S = f64> + Statics>(&self, mechanism: &mut M) -> Result<(), BadOption> {
        for (name, value) in &self.set {
            let (index, factor) = find("parameter", name, mechanism.tables().parameters)?;
            by_number::set_parameter(mechanism, index, in_si(*value, factor));
        }
        Ok(())
    }

    /// Sets the inputs of a run.
    ///
    /// # Errors
    /// A name that is no input, with those that there are.
    pub fn apply_inputs<M, I>(&self, sim: &mut Sim<M, I>) -> Result<(), BadOption>
    where
        M: Described<S = f64>,
        I: Method<M>,
    {
        for (name, value) in &self.input {
            let (index, factor) = find("input", name, sim.state().mechanism().tables().inputs)?;
            by_number::set_input(sim, index, in_si(*value, factor));
        }
        Ok(())
    }
}

/// A value in a unit in SI: the number that is nearest to it, and that a declaration has, where the unit is a whole part of SI's,
/// as a millimetre is. 350 times the nearest number to a thousandth is not the nearest number to 0.35.
fn in_si(value: f64, factor: f64) -> f64 {
    let parts = (1.0 / factor).round();
    if parts > 1.0 && 1.0 / parts == factor { value / parts } else { value * factor }
}

/// The number of a quantity by its name, and its factor to SI.
fn find(what: &str, name: &str, quantities: &[Quantity]) -> Result<(usize, f64), BadOption> {
    let found = quantities.iter().enumerate().find(|(_, quantity)| quantity.name == name);
    found.map(|(index, quantity)| (index, quantity.factor)).ok_or_else(|| {
        let near = nearest(name, quantities.iter().map(|quantity| quantity.name));
        let hint = near.map_or(String::new(), |near| format!(" is `{near}` meant?"));
        BadOption::new(format!("there is no {what} `{name}`;{hint} {}", known(quantities)))
    })
}

/// Text that lists quantities of a mechanism.
fn known(quantities: &[Quantity]) -> String {
    let named = quantities.iter().map(|quantity| match quantity.unit {
        "" => quantity.name.to_owned(),
        unit => format!("{} ({unit})", quantity.name),
    });
    let named: Vec<String> = named.collect();
    if named.is_empty() { "it has none".to_owned() } else { format!("there are {}", named.join(", ")) }
}

/// Parameters and inputs of a mechanism as lines of help; nothing where there are none.
pub(super) fn quantities_of<M: Described>(of: &M) -> String {
    let tables = [("parameters", of.tables().parameters), ("inputs", of.tables().inputs)];
    let some = tables.into_iter().filter(|(_, quantities)| !quantities.is_empty());
    let lines: Vec<String> =
        some.map(|(what, quantities)| format!("\n{what}: {}", known(quantities))).collect();
    lines.concat()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{By, Integrator, Options, Version};

    #[test]
    fn every_option_is_read() {
        let words = vec![
            "--view", "a.html", "--live", "--csv", "b", "--svg", "c", "--out", "d", "--every", "1e-2",
            "--set", "k = -3", "--input", "force=2", "--input", "turn=1", "--method", "rk4:1e-3",
        ];
        let options = Options::parse(words).unwrap();
        assert!(options.live && options.help.is_none() && options.until.is_none());
        assert_eq!(options.set, [("k".to_string(), -3.0)]);
        assert_eq!(options.input, [("force".to_string(), 2.0), ("turn".to_string(), 1.0)]);
        assert_eq!((options.every, options.method), (Some(0.01), Some(Integrator::Rk4(1e-3))));
        assert!(Options::parse(["--c", "folder", "--fmu", "file"]).is_ok());
        let options = Options::parse(["--c", "folder", "--methods", "Rk4, dop853"]).unwrap();
        assert_eq!(options.methods, [By::Rk4, By::Dop853]);
        assert_eq!(Options::parse(["--fmu", "file"]).unwrap().fmi, Version::Three);
        assert_eq!(Options::parse(["--fmu", "file", "--fmi", "2"]).unwrap().fmi, Version::Two);
        assert_eq!(Options::parse(["--serve"]).unwrap().serve, Some(0));
        assert_eq!(Options::parse(["--serve=8080"]).unwrap().serve, Some(8080));
    }

    #[test]
    fn mistakes_say_what_was_wanted() {
        for (words, said) in [
            (vec!["--untill", "3"], "is `--until` meant?"),
            (vec!["--untill", "3"], "--until TIME"),
            (vec!["run"], "--view FILE"),
            (vec!["--until", "-3"], "positive time"),
            (vec!["--until"], "the value is missing"),
            (vec!["--set", "mass"], "--set wants NAME=NUMBER"),
            (vec!["--input", "force"], "--input wants NAME=NUMBER"),
            (vec!["--method", "rk4"], "Rk4:1e-3"),
            (vec!["--serve=x"], "a port from 1 to 65535"),
            (vec!["--serve", "--csv", "a"], "without --csv"),
            (vec!["--fmu", "a.fmu", "--set", "mass=3"], "without --set"),
            (vec!["--c", "a", "--view", "a.html"], "without --view"),
            (vec!["--python", "a", "--until", "1"], "without --until"),
            (vec!["--fmu", "a", "--fmi", "1"], "2 or 3, not `1`"),
            (vec!["--fmi", "2"], "with --fmu"),
            (vec!["--fmu", "a", "--target", "thumbv7em-none-eabihf"], "with --c"),
            (vec!["--fmu", "a", "--methods", "Rk4"], "with --c"),
            (vec!["--c", "a", "--methods", "Rk4,Rk5"], "is Rk4 meant?"),
        ] {
            let found = Options::parse(words).unwrap_err().to_string();
            assert!(found.contains(said), "{found}");
        }
    }
}
