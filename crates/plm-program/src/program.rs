//! A whole program over a mechanism: options, a run with progress, and its output files.

use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use indicatif::{ProgressBar, ProgressStyle};
use plm_foreign::fmi::Exchanged;
use plm_python::wheel::wheel;
use plm_runtime::described::pulls::WithPulls;
use plm_runtime::{Described, Fault, Method, Moment, Sim, Statics};
use plm_view::live::Module;
use plm_view::package::plm;
use plm_view::{Chart, Page, Recorder, Recording, Results};

use super::Library;
use super::foreign::fmu_of;
use super::options::{Options, quantities_of};
use super::server::Server;
#[cfg(feature = "c-source")]
use super::{Precision, c_source};

/// A run of a mechanism as its command line asks for it.
///
/// ```no_run
/// plm::mechanism! {
///     pub Pendulum {
///         gravity: 9.81 m/s^2;
///         param mass: kg = 1 kg;
///         ground { port o: (0, 0) m; }
///         body bob { mass: mass; inertia: 0.01 kg*m^2; port pivot: (0, 1) m; start angle: 30 deg, locked; }
///         revolute hinge(ground.o, bob.pivot);
///     }
/// }
///
/// fn main() -> std::process::ExitCode {
///     plm::view::Program::new(Pendulum::new()).until(4.0).every(0.01).main()
/// }
/// ```
#[derive(Clone, Debug)]
pub struct Program<M> {
    mechanism: M,
    until: f64,
    every: f64,
}

/// Default number of samples in a run.
const SAMPLES: f64 = 1000.0;
/// Number of times that the bar is drawn in a run.
const TICKS: u64 = 1000;

impl<M: Exchanged> Program<M> {
    /// Runs this mechanism, for 10 s by default.
    pub fn new(mechanism: M) -> Self {
        Self { mechanism, until: 10.0, every: 0.0 }
    }

    /// Runs until this time, s, unless `--until` says another one.
    #[must_use]
    pub fn until(self, until: f64) -> Self {
        Self { until, ..self }
    }

    /// Samples so often, s, unless `--every` says otherwise.
    #[must_use]
    pub fn every(self, every: f64) -> Self {
        Self { every, ..self }
    }

    /// Runs by the command line, and prints the names of written files at the end.
    pub fn main(self) -> ExitCode {
        let done = Options::from_args().map_err(Into::into).and_then(|options| self.with(&options));
        match done {
            Ok(()) => ExitCode::SUCCESS,
            Err(error) => {
                eprintln!("{error}");
                ExitCode::FAILURE
            }
        }
    }

    /// Runs by options. Samples recorded before a fault are written all the same.
    ///
    /// # Errors
    /// A parameter or an input that is not there; a fault of the run; a file that cannot be written, a port that cannot be had.
    pub fn with(mut self, options: &Options) -> Result<(), Box<dyn Error>> {
        if let Some(help) = &options.help {
            println!("{help}{}", quantities_of(&self.mechanism));
            return Ok(());
        }
        if let Some(folder) = &options.c {
            let library = Library::new(M::TABLES.name).by(&options.methods).with(&self.mechanism)?;
            let library = options.target.iter().fold(library, |library, target| library.for_target(target));
            told(&library.write(folder)?);
        }
        if let Some(file) = &options.fmu {
            told(&fmu_of(options.fmi, &self.mechanism, file)?);
        }
        if let Some(folder) = &options.python {
            told(&wheel(&self.mechanism, folder)?);
        }
        if options.c.is_some() || options.fmu.is_some() || options.python.is_some() {
            return Ok(());
        }
        options.apply(&mut self.mechanism)?;
        #[cfg(feature = "c-source")]
        if let Some(folder) = &options.c_source {
            let precision = if options.single { Precision::Single } else { Precision::Double };
            told(&c_source(&self.mechanism, precision, folder)?);
            return Ok(());
        }
        let method = options.method.unwrap_or_default();
        if let Some(port) = options.serve {
            return Serve { options, port }.run(&mut method.start_at(self.mechanism, 0.0)?);
        }
        let until = options.until.unwrap_or(self.until);
        let usual = if self.every > 0.0 { self.every } else { until / SAMPLES };
        let every = options.every.unwrap_or(usual);
        Record { options, until, every }.run(&mut method.start_at(self.mechanism, 0.0)?)
    }
}

/// A run from start to end, and its output files.
struct Record<'a> {
    options: &'a Options,
    until: f64,
    every: f64,
}

impl Record<'_> {
    fn run<M: Described<S = f64>, I: Method<M>>(self, sim: &mut Sim<M, I>) -> Result<(), Box<dyn Error>> {
        self.options.apply_inputs(sim)?;
        let mut recorder = Recorder::observing_all(sim);
        let outcome = run(sim, &mut recorder, self.until, self.every);
        let written = write::<M>(self.options, recorder.recording())?;
        outcome?;
        told(&written);
        Ok(())
    }
}

/// A run by the clock, which a page shows and holds.
struct Serve<'a> {
    options: &'a Options,
    port: u16,
}

/// Between rows of a served page, s; nearer where it is slow.
const SERVED_EVERY: f64 = 0.01;

impl Serve<'_> {
    fn run<M: Described<S = f64> + Statics, I: Method<M>>(
        self,
        sim: &mut Sim<M, I>,
    ) -> Result<(), Box<dyn Error>> {
        self.options.apply_inputs(sim)?;
        let mut server = Server::start(sim, self.port)?;
        println!("serving {} (Ctrl+C ends it)", server.url());
        let end = self.options.until.unwrap_or(f64::INFINITY);
        while sim.state().time() < end {
            server.obey(sim);
            let every = self.options.every.unwrap_or(SERVED_EVERY) * server.speed().min(1.0);
            if server.wait_for_step(every) {
                match sim.step(every) {
                    Ok(()) => server.show(sim),
                    Err(fault) => server.stop(&fault),
                }
            }
        }
        Ok(())
    }
}

/// Prints the names of written files.
fn told(files: &[PathBuf]) {
    for path in files {
        println!("written: {}", path.display());
    }
}

/// Runs with a bar of the time on a terminal, and nothing elsewhere.
///
/// # Errors
/// As [`Recorder::run`].
pub fn run<M: Described<S = f64>, I: Method<M>>(
    sim: &mut Sim<M, I>,
    recorder: &mut Recorder<M>,
    until: f64,
    every: f64,
) -> Result<(), Fault> {
    let (start, bar, clock) = (Moment::time(sim.state()), bar(), Instant::now());
    let mut shown = 0;
    let outcome = recorder.run_seen(sim, until, every, &mut |time| {
        let share = ((time - start) / (until - start)).clamp(0.0, 1.0);
        let tick = (share * TICKS as f64) as u64;
        if tick != shown {
            shown = tick;
            let rate = (time - start) / clock.elapsed().as_secs_f64();
            bar.set_message(format!("{time:.3} s of {until} s, {rate:.1} s in a second"));
            bar.set_position(tick);
        }
    });
    bar.finish_and_clear();
    outcome
}

/// A bar with the time that is simulated, and how much of it in a second.
fn bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{wide_bar} {msg}, {eta} left");
    ProgressBar::new(TICKS).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Writes what options ask for; the page where they ask for nothing. Gives the files.
///
/// # Errors
/// A file that cannot be written, or a module that cannot be built.
pub fn write<M: Described<S = f64>>(
    options: &Options,
    recording: &Recording,
) -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let mut written = Vec::new();
    if let Some(path) = &options.out {
        recording.write(path)?;
        written.push(path.clone());
    }
    if let Some(path) = &options.csv {
        recording.write_csv(path)?;
        written.push(path.clone());
    }
    if let Some(path) = &options.svg {
        Chart::over_time(recording).titled(M::TABLES.name).write_svg(path)?;
        written.push(path.clone());
    }
    if options.view.is_some() || options.live || written.is_empty() {
        let usual = || Path::new("target/plm").join(snake_case(M::TABLES.name)).with_extension("html");
        let path = options.view.clone().unwrap_or_else(usual);
        page::<M>(options, recording)?.write_html(&path)?;
        written.push(path);
    }
    Ok(written)
}

/// The page, with the mechanism in it where that is asked for.
fn page<M: Described<S = f64>>(options: &Options, recording: &Recording) -> Result<Page, Box<dyn Error>> {
    let results = Results { runs: vec![recording.clone()], ..Results::default() }.to_bytes()?;
    let page = Page::new(&results, M::TABLES.name);
    if !options.live {
        return Ok(page);
    }
    let bodies: Vec<&str> = M::TABLES.bodies.iter().map(|body| body.name).collect();
    let declaration = WithPulls { declaration: M::DECLARATION, bodies: &bodies }.to_string();
    let module = Module { name: M::TABLES.name, declaration: &declaration, files: M::FILES, plm: &plm() };
    match module.build(Path::new("target/plm/packages").join(format!("{}-live", M::TABLES.name))) {
        Ok(bytes) => Ok(page.with_module(&bytes)),
        Err(error) => {
            // The recorded run can be viewed without it.
            eprintln!("{error}\nthe page shows the recorded run alone");
            Ok(page)
        }
    }
}

/// `DoublePendulum` becomes `double_pendulum`.
fn snake_case(name: &str) -> String {
    let mut text = String::new();
    for (k, letter) in name.chars().enumerate() {
        if letter.is_uppercase() && k > 0 {
            text.push('_');
        }
        text.extend(letter.to_lowercase());
    }
    text
}
