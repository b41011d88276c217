//! Places in which commands run: their environment, and the destination of their output.

use std::ffi::{OsStr, OsString};
use std::fs::{self, File};
use std::io::{Read as _, Write as _};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use wait4::Wait4 as _;

use crate::Result;
use crate::beside::Guard;

/// A clone with other settings is a place of its own.
#[derive(Clone)]
pub(crate) struct Place {
    /// The root of the repository.
    pub(crate) root: PathBuf,
    /// Target folder of cargo.
    pub(crate) target: PathBuf,
    /// This program, by its path at the start: once a stage has built it anew, Linux calls the file that runs deleted.
    pub(crate) program: PathBuf,
    /// Variables that are set, the last of a name counts, and those that are taken away.
    variables: Vec<(String, Option<OsString>)>,
    /// File into which everything is printed; `None` is the terminal. With a file, commands are in groups of their own.
    output: Option<Arc<File>>,
    niceness: u32,
    /// Processor time of its commands, ms.
    spent: Arc<AtomicU64>,
}

impl Place {
    pub(crate) fn new() -> Result<Self> {
        // The folder of this package, from cargo: a target folder may have been built elsewhere.
        let own = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
        let program = std::env::current_exe().map_err(|why| format!("the path of this program: {why}"))?;
        let root = Path::new(&own).parent().ok_or("the package xtask has no folder above it")?.to_owned();
        std::env::set_current_dir(&root).map_err(|why| format!("{}: {why}", root.display()))?;
        let target = root.join(std::env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()));
        fs::create_dir_all(&target).map_err(|why| format!("{}: {why}", target.display()))?;
        // What `cargo run` says of itself is none of the others' business: another toolchain would call this one's cargo.
        let variables =
            ["CARGO", "CARGO_MANIFEST_DIR", "CARGO_MANIFEST_PATH"].map(|name| (name.to_owned(), None));
        Ok(Self {
            root,
            target,
            program,
            variables: variables.into(),
            output: None,
            niceness: 0,
            spent: Arc::default(),
        })
    }

    pub(crate) fn set(&mut self, name: &str, value: impl Into<OsString>) {
        self.variables.push((name.to_owned(), Some(value.into())));
    }

    /// A place like this one, without these variables.
    pub(crate) fn without(&self, names: &[&str]) -> Self {
        let mut place = self.clone();
        place.variables.extend(names.iter().map(|name| ((*name).to_owned(), None)));
        place
    }

    /// A place like this one, for work beside the stages: it prints into a file, and leaves the processor to others.
    pub(crate) fn beside(&self, output: File, niceness: u32) -> Self {
        Self { output: Some(Arc::new(output)), niceness, ..self.clone() }
    }

    /// A place like this one, which prints where another one does, with its niceness.
    pub(crate) fn printing_as(&self, other: &Self) -> Self {
        Self { output: other.output.clone(), niceness: other.niceness, ..self.clone() }
    }

    /// A place like this one, which counts the processor time of its commands anew.
    pub(crate) fn counting(&self) -> Self {
        Self { spent: Arc::default(), ..self.clone() }
    }

    /// Processor time of its commands that have ended, with all that they started.
    pub(crate) fn spent(&self) -> Duration {
        Duration::from_millis(self.spent.load(Ordering::Relaxed))
    }

    /// A command, its words separated by blanks; those that may hold blanks themselves are arguments.
    pub(crate) fn command(&self, words: &str) -> Task<'_> {
        let words = words.split_whitespace().map(Into::into).collect();
        Task { place: self, words, folder: self.root.clone(), variables: Vec::new() }
    }

    /// Prints a line to where commands print.
    pub(crate) fn say(&self, line: &str) -> Result {
        match self.output.as_deref() {
            None => println!("{line}"),
            Some(mut file) => writeln!(file, "{line}").map_err(|why| format!("{line}: {why}"))?,
        }
        Ok(())
    }
}

/// A command that is about to run.
pub(crate) struct Task<'a> {
    place: &'a Place,
    words: Vec<OsString>,
    folder: PathBuf,
    variables: Vec<(String, OsString)>,
}

impl Task<'_> {
    pub(crate) fn arg(mut self, word: impl AsRef<OsStr>) -> Self {
        self.words.push(word.as_ref().to_owned());
        self
    }

    pub(crate) fn args<W: AsRef<OsStr>>(mut self, words: impl IntoIterator<Item = W>) -> Self {
        self.words.extend(words.into_iter().map(|word| word.as_ref().to_owned()));
        self
    }

    pub(crate) fn set(mut self, name: &str, value: impl Into<OsString>) -> Self {
        self.variables.push((name.to_owned(), value.into()));
        self
    }

    pub(crate) fn in_folder(mut self, folder: &str) -> Self {
        self.folder = self.place.root.join(folder);
        self
    }

    /// Runs it; it has to succeed.
    pub(crate) fn run(self) -> Result {
        let (mut command, shown) = self.prepared()?;
        succeeded(self.status(&mut command)?, &shown)
    }

    /// Runs it, and writes what it prints into a file; errors go where those of others go.
    pub(crate) fn save(self, file: &Path) -> Result {
        let (mut command, shown) = self.prepared()?;
        command.stdout(File::create(file).map_err(|why| format!("{}: {why}", file.display()))?);
        succeeded(self.status(&mut command)?, &shown)
    }

    /// Runs it, and gives what it prints; errors go where those of others go.
    pub(crate) fn text(self) -> Result<String> {
        let (mut command, shown) = self.prepared()?;
        command.stdout(Stdio::piped());
        if self.place.output.is_none() {
            command.stderr(Stdio::inherit());
        }
        let failed = |why: std::io::Error| format!("{shown}: {why}");
        let mut child = command.spawn().map_err(failed)?;
        let mut text = Vec::new();
        if let Some(mut stdout) = child.stdout.take() {
            stdout.read_to_end(&mut text).map_err(failed)?;
        }
        succeeded(self.end_of(&mut child).map_err(failed)?, &shown)?;
        String::from_utf8(text).map_err(|why| format!("{shown}: {why}"))
    }

    /// Does it succeed? Nothing of it is shown. A program that is not there does not.
    pub(crate) fn works(self) -> bool {
        let Ok((mut command, _)) = self.prepared() else { return false };
        command.stdout(Stdio::null()).stderr(Stdio::null());
        self.status(&mut command).is_ok_and(|status| status.success())
    }

    /// The command, and how messages show it.
    fn prepared(&self) -> Result<(Command, String)> {
        let shown = self.words.iter().map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ");
        let nice = (self.place.niceness > 0).then(|| ["nice".into(), format!("-n{}", self.place.niceness)]);
        let mut words = nice.into_iter().flatten().map(OsString::from).chain(self.words.iter().cloned());
        let mut command = Command::new(words.next().ok_or("a command without a word")?);
        command.args(words).current_dir(&self.folder).stdin(Stdio::null());
        for (name, value) in &self.place.variables {
            match value {
                Some(value) => command.env(name, value),
                None => command.env_remove(name),
            };
        }
        command.envs(self.variables.iter().map(|(name, value)| (name, value)));
        if let Some(file) = self.place.output.as_deref() {
            let file = || file.try_clone().map_err(|why| format!("{shown}: {why}"));
            command.stdout(file()?).stderr(file()?);
            Guard::separate(&mut command);
        }
        Ok((command, shown))
    }

    /// Runs it to its end. What runs beside ends with this program, however that ends.
    fn status(&self, command: &mut Command) -> Result<ExitStatus> {
        let failed = |why: std::io::Error| format!("{}: {why}", self.words[0].display());
        let mut child = command.spawn().map_err(failed)?;
        let guard = self.place.output.as_ref().map(|_| Guard::of(child.id())).transpose().map_err(failed)?;
        let status = self.end_of(&mut child).map_err(failed)?;
        guard.map_or(Ok(()), Guard::dismiss).map_err(failed)?;
        Ok(status)
    }

    /// Waits for its end, and counts what it took of the processor.
    fn end_of(&self, child: &mut Child) -> std::io::Result<ExitStatus> {
        let ended = child.wait4()?;
        let spent = ended.rusage.utime + ended.rusage.stime;
        self.place.spent.fetch_add(u64::try_from(spent.as_millis()).unwrap_or(u64::MAX), Ordering::Relaxed);
        Ok(ended.status)
    }
}

fn succeeded(status: ExitStatus, shown: &str) -> Result {
    if status.success() { Ok(()) } else { Err(format!("{shown}: {status}")) }
}
