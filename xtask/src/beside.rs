//! Work beside the stages: in a thread, its commands in groups of processes that end with this program.

use std::fs::{self, File};
use std::io::{self, Write as _};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::thread::{self, JoinHandle};

use crate::Result;
use crate::place::Place;

/// Work that has begun.
pub(crate) struct Beside {
    output: PathBuf,
    thread: JoinHandle<Result>,
}

impl Beside {
    /// Begins work in a thread. Its commands print into the file NAME.txt of the target folder.
    pub(crate) fn begin(
        name: &str,
        niceness: u32,
        place: &Place,
        work: impl FnOnce(&Place) -> Result + Send + 'static,
    ) -> Result<Self> {
        let output = place.target.join(format!("{name}.txt"));
        let file = File::create(&output).map_err(|why| format!("{}: {why}", output.display()))?;
        let place = place.beside(file, niceness);
        Ok(Self { output, thread: thread::spawn(move || work(&place)) })
    }

    /// Waits for it, and gives what it has printed; if it failed, that is shown.
    pub(crate) fn join(self) -> Result<String> {
        let done = self.thread.join().unwrap_or_else(|_| Err("a thread has panicked".to_owned()));
        let text = fs::read(&self.output).map_err(|why| format!("{}: {why}", self.output.display()))?;
        let text = String::from_utf8_lossy(&text).into_owned();
        done.inspect_err(|_| print!("{text}")).map(|()| text)
    }
}

/// Ends a group of processes when this program ends, however it ends: the guard reads a pipe that nobody else writes to, and
/// its end comes with that of this program.
pub(crate) struct Guard {
    child: Child,
}

impl Guard {
    /// Puts a command into a group of its own.
    pub(crate) fn separate(command: &mut Command) {
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(command, 0);
        #[cfg(not(unix))]
        let _ = command;
    }

    /// For the group of this process.
    pub(crate) fn of(group: u32) -> io::Result<Self> {
        let mut command = Command::new("sh");
        command.args(["-c", "read -r line || kill -- -\"$0\" 2>/dev/null", &group.to_string()]);
        command.stdin(Stdio::piped()).stdout(Stdio::null());
        Self::separate(&mut command);
        Ok(Self { child: command.spawn()? })
    }

    /// The group has ended by itself.
    pub(crate) fn dismiss(mut self) -> io::Result<()> {
        if let Some(mut pipe) = self.child.stdin.take() {
            writeln!(pipe, "ended")?;
        }
        self.child.wait().map(drop)
    }
}
