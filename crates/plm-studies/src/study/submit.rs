//! The shards of a study as the tasks of an engine for many machines.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::Problem;

/// Who runs the shards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Engine {
    /// Slurm: a job array, by sbatch.
    Slurm,
    /// HyperQueue: a job, by its Python package.
    HyperQueue,
}

impl Engine {
    pub(super) fn parse(word: &str) -> Result<Self, Problem> {
        match word {
            "slurm" => Ok(Engine::Slurm),
            "hq" => Ok(Engine::HyperQueue),
            _ => Err(Problem::new(format!("the engines are slurm and hq, not `{word}`"))),
        }
    }
}

/// The shards of a study, on their way to an engine.
pub(super) struct Submission<'a> {
    pub(super) engine: Engine,
    /// Of the study.
    pub(super) name: &'a str,
    pub(super) folder: &'a Path,
    pub(super) shards: usize,
    /// Of each shard.
    pub(super) threads: usize,
    /// More options of sbatch.
    pub(super) words: &'a [String],
}

impl Submission<'_> {
    /// Writes the script into the folder and hands it over, unless it is only to be printed. Gives the command and its answer.
    pub(super) fn perform(&self, print: bool) -> Result<String, Problem> {
        let failed = |error| Problem::file(self.folder, error);
        fs::create_dir_all(self.folder).map_err(failed)?;
        // The tasks begin in folders of their own, on other machines.
        let folder = fs::canonicalize(self.folder).map_err(failed)?;
        let program = std::env::current_exe().map_err(failed)?;
        let (name, script) = match self.engine {
            Engine::Slurm => ("slurm.sh", self.slurm(&program, &folder)),
            Engine::HyperQueue => ("hq.py", self.hyper_queue(&program, &folder)),
        };
        let path = folder.join(name);
        fs::write(&path, script).map_err(|error| Problem::file(&path, error))?;
        let mut command = Command::new(if self.engine == Engine::Slurm { "sbatch" } else { "python3" });
        command.args(self.words).arg(&path);
        let words = core::iter::once(command.get_program()).chain(command.get_args());
        let line = words.map(|word| quoted(&word.to_string_lossy())).collect::<Vec<_>>().join(" ");
        if print { Ok(line) } else { answer(&mut command, &line) }
    }

    /// A job array of sbatch. A task that is put back into the queue goes on where it was.
    fn slurm(&self, program: &Path, folder: &Path) -> String {
        let Self { name, shards, threads, .. } = self;
        let output = folder.join(format!("%a-of-{shards}.txt"));
        format!(
            "#!/bin/sh\n\
             #SBATCH --job-name={}\n\
             #SBATCH --array=1-{shards}\n\
             #SBATCH --cpus-per-task={threads}\n\
             #SBATCH --requeue\n\
             #SBATCH --open-mode=append\n\
             #SBATCH --output={}\n\
             exec {} --folder {} --threads {threads} --shard \"$SLURM_ARRAY_TASK_ID/{shards}\"\n",
            quoted(name),
            quoted(&output.to_string_lossy()),
            quoted(&program.to_string_lossy()),
            quoted(&folder.to_string_lossy()),
        )
    }

    /// A program in Python for the server whose folder HQ_SERVER_DIR names, or that of the user. A task whose worker is lost is
    /// given to another one, and goes on where it was.
    fn hyper_queue(&self, program: &Path, folder: &Path) -> String {
        let Self { name, shards, threads, .. } = self;
        let (program, folder) = (program.to_string_lossy(), folder.to_string_lossy());
        format!(
            "import os\n\
             from hyperqueue import Client, Job\n\
             from hyperqueue.ffi.protocol import ResourceRequest\n\
             \n\
             folder = {folder:?}\n\
             job = Job(name={name:?}, max_fails=None, default_workdir=folder)\n\
             for shard in range(1, {shards} + 1):\n    \
                 words = [{program:?}, '--folder', folder, '--threads', '{threads}', '--shard', f'{{shard}}/{shards}']\n    \
                 told = f'{{folder}}/{{shard}}-of-{shards}.txt'\n    \
                 job.program(words, stdout=told, stderr=told + '.err', resources=ResourceRequest(cpus={threads}))\n\
             submitted = Client(os.environ.get('HQ_SERVER_DIR')).submit(job)\n\
             print(f'HyperQueue has job {{submitted.id}} of {shards} shards')\n"
        )
    }
}

/// Runs a command; what it says is the answer.
fn answer(command: &mut Command, line: &str) -> Result<String, Problem> {
    let output = command.output().map_err(|error| Problem::new(format!("{line}: {error}")))?;
    let said =
        [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).trim().to_string());
    let said = format!("{line}\n{}", said.join("\n").trim());
    if output.status.success() { Ok(said) } else { Err(Problem::new(said)) }
}

/// An argument, quoted for the shell.
fn quoted(word: &str) -> String {
    let plain = |letter: char| letter.is_ascii_alphanumeric() || "/._-%=:,".contains(letter);
    if !word.is_empty() && word.chars().all(plain) {
        return word.to_string();
    }
    format!("'{}'", word.replace('\'', "'\\''"))
}
