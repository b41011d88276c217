//! The command line of a study.

use std::env;
use std::error::Error;
use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::{Arg, Parser, ValueExt};

use super::shard::check_threads;
use super::submit::{Engine, Submission};
use super::{Gathered, Problem, Ran, Rows, Shard, Study};

/// Help on the options.
const HELP: &str = "\
                  (nothing) runs all points, on all cores
--shard K/N       runs shard K of N; what its log has is not run again
--threads N       on so many threads, 1024 at most (0: one for each core)
--folder FOLDER   where the logs are (target/plm/NAME of the study)
--status          how far it is, shard by shard, and points that failed
--merge FILE      puts all rows into one table, .csv or .npy
--partial         with --merge: also where points are missing
--submit ENGINE   hands the shards to slurm or hq (HyperQueue)
--shards N        with --submit: so many
--print           with --submit: writes what would be submitted, and submits nothing
-- WORDS          with --submit slurm: more options of sbatch
--help            these lines";

/// Parsed command line.
#[derive(Default)]
#[allow(clippy::struct_excessive_bools, reason = "each is an option of the command line")]
struct Request {
    shard: Option<Shard>,
    threads: usize,
    folder: Option<PathBuf>,
    status: bool,
    merge: Option<PathBuf>,
    partial: bool,
    submit: Option<Engine>,
    shards: Option<usize>,
    print: bool,
    words: Vec<String>,
    help: bool,
}

impl Request {
    fn parse(words: Vec<OsString>) -> Result<Self, Box<dyn Error>> {
        let mut request = Self::default();
        let mut parser = Parser::from_args(words);
        while let Some(word) = parser.next()? {
            match word {
                Arg::Long("shard") => request.shard = Some(Shard::parse(&parser.value()?.string()?)?),
                Arg::Long("threads") => request.threads = parser.value()?.parse()?,
                Arg::Long("folder") => request.folder = Some(parser.value()?.into()),
                Arg::Long("status") => request.status = true,
                Arg::Long("merge") => request.merge = Some(parser.value()?.into()),
                Arg::Long("partial") => request.partial = true,
                Arg::Long("submit") => request.submit = Some(Engine::parse(&parser.value()?.string()?)?),
                Arg::Long("shards") => request.shards = Some(parser.value()?.parse()?),
                Arg::Long("print") => request.print = true,
                Arg::Long("help") | Arg::Short('h') => request.help = true,
                Arg::Value(word) if request.submit == Some(Engine::Slurm) => {
                    request.words.push(word.string()?);
                }
                other => return Err(format!("{}; there are\n{HELP}", other.unexpected()).into()),
            }
        }
        request.check()?;
        Ok(request)
    }

    /// Does each option stand beside the one that it belongs to?
    fn check(&self) -> Result<(), Problem> {
        let tasks = [self.shard.is_some(), self.status, self.merge.is_some(), self.submit.is_some()];
        if tasks.iter().filter(|asked| **asked).count() > 1 {
            return Err(Problem::new("--shard, --status, --merge and --submit are asked for one at a time"));
        }
        let alone = [
            ("--partial", self.partial, "--merge FILE", self.merge.is_some()),
            ("--shards", self.shards.is_some(), "--submit ENGINE", self.submit.is_some()),
            ("--print", self.print, "--submit ENGINE", self.submit.is_some()),
        ];
        match alone.iter().find(|(_, given, _, has_owner)| *given && !has_owner) {
            Some((option, _, owner, _)) => Err(Problem::new(format!("{option} belongs to {owner}"))),
            None => Ok(()),
        }
    }
}

impl<F: Rows<P, C>, const P: usize, const C: usize> Study<F, P, C> {
    /// Runs by the command line, and prints the result. Points that fail are part of a result, and no failure of the program.
    pub fn main(&self) -> ExitCode {
        match self.with(env::args_os().skip(1)) {
            Ok(told) => {
                println!("{told}");
                ExitCode::SUCCESS
            }
            Err(error) => {
                eprintln!("{error}");
                ExitCode::FAILURE
            }
        }
    }

    /// Runs by the arguments of a command line, and returns the text to be printed.
    ///
    /// # Errors
    /// An argument that is no option or has no meaning there; a log or a table that cannot be read or written; missing points for a table;
    /// an engine that does not take the shards.
    pub fn with<W: Into<OsString>>(
        &self,
        words: impl IntoIterator<Item = W>,
    ) -> Result<String, Box<dyn Error>> {
        let request = Request::parse(words.into_iter().map(Into::into).collect())?;
        let usual = || Path::new("target/plm").join(&self.plan.name);
        let folder = request.folder.clone().unwrap_or_else(usual);
        if request.help {
            return Ok(HELP.to_owned());
        }
        if request.status {
            return Ok(self.gather(&folder)?.to_string());
        }
        if let Some(path) = &request.merge {
            let gathered = self.gather(&folder)?;
            return Ok(merge(&gathered, path, request.partial)?);
        }
        check_threads(request.threads)?;
        self.check_shards(request.shards.max(request.shard.map(|shard| shard.of)))?;
        if let Some(engine) = request.submit {
            self.plan.check()?;
            let shards = request.shards.filter(|shards| *shards > 0);
            let shards = shards.ok_or("--submit wants to know how many shards: --shards 64")?;
            let name = &self.plan.name;
            let (threads, words) = (request.threads.max(1), &request.words);
            let submission = Submission { engine, name, folder: &folder, shards, threads, words };
            return Ok(submission.perform(request.print)?);
        }
        let shard = request.shard.unwrap_or(Shard::WHOLE);
        let ran = self.run(&folder, shard, request.threads)?;
        Ok(told(shard, &ran, &folder))
    }

    /// Can each of so many shards have a point? One that has none would do nothing, and say that all went well.
    fn check_shards(&self, shards: Option<usize>) -> Result<(), Problem> {
        match (shards, self.plan.points.len()) {
            (_, 0) => Err(Problem::new("the study has no points")),
            (Some(shards), points) if shards > points => {
                Err(Problem::new(format!("{shards} shards are too many: the study has {points} points")))
            }
            _ => Ok(()),
        }
    }
}

/// Text that reports the run of a shard.
fn told(shard: Shard, ran: &Ran, folder: &Path) -> String {
    let Ran { kept, computed, failed, notes } = ran;
    let mut text = String::new();
    for note in notes {
        let _ = writeln!(text, "{note}");
    }
    let _ = write!(
        text,
        "shard {shard}: {computed} points computed, {failed} of them failed; {kept} were there; {}",
        folder.join(shard.log()).display()
    );
    text
}

/// Writes the table. Where points are missing, only if that is asked for.
fn merge<const P: usize, const C: usize>(
    gathered: &Gathered<P, C>,
    path: &Path,
    partial: bool,
) -> Result<String, Problem> {
    let missing = gathered.missing().count();
    if missing > 0 && !partial {
        let first: Vec<String> = gathered.missing().take(10).map(|index| index.to_string()).collect();
        let more = if missing > first.len() { ", ..." } else { "" };
        return Err(Problem::new(format!(
            "{gathered}\n{missing} points are missing: {}{more}; run their shards again, or merge with --partial",
            first.join(", ")
        )));
    }
    gathered.write(path)?;
    Ok(format!("{gathered}\nwritten: {}", path.display()))
}
