//! A call as a process: `plm` with these words, within limits of time, memory and length of what it says.

use std::borrow::Cow;
use std::io::{Read, Write};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Time between two looks at a process.
pub(super) const PAUSE: Duration = Duration::from_millis(3);
/// Most that a process may say, bytes.
const LONGEST: u64 = 8 << 20;
/// The variable by which a process has its limit of memory, MiB.
pub(super) const MEMORY: &str = "PLM_MEMORY";

/// Limits of a call.
#[derive(Clone, Copy)]
pub(crate) struct Limits {
    pub(crate) seconds: f64,
    pub(crate) mebibytes: u64,
}

/// Output and exit code of a process.
pub(super) struct Said {
    pub(super) code: i32,
    /// Text, except where a picture in pixels was asked for.
    pub(super) output: Vec<u8>,
    pub(super) errors: String,
}

impl Said {
    /// The output as text.
    pub(super) fn text(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(&self.output)
    }
}

/// How a process ended.
pub(super) enum Ended {
    Said(Said),
    /// A limit has ended it: a message that names the limit.
    Limit(String),
}

/// A process at work; it ends with this value.
pub(super) struct Running {
    child: Child,
    since: Instant,
    limits: Limits,
    is_too_long: Arc<AtomicBool>,
    streams: Option<[JoinHandle<Vec<u8>>; 2]>,
}

/// Starts a process in a folder.
///
/// # Errors
/// It cannot be started.
pub(super) fn start(words: &[String], input: &str, folder: &Path, limits: Limits) -> Result<Running, String> {
    let unstarted = |why: std::io::Error| format!("plm cannot be run: {why}");
    let program = std::env::current_exe().map_err(unstarted)?;
    let mut command = Command::new(program);
    command.args(words).current_dir(folder).env(MEMORY, limits.mebibytes.to_string());
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().map_err(unstarted)?;
    let (stdin, text) = (child.stdin.take(), input.to_owned());
    // A process that ends early does not read all of it.
    thread::spawn(move || stdin.map(|mut stdin| stdin.write_all(text.as_bytes()).is_ok()));
    let is_too_long = Arc::new(AtomicBool::new(false));
    let (output, errors) = (child.stdout.take(), child.stderr.take());
    let streams = Some([kept(output, &is_too_long), kept(errors, &is_too_long)]);
    Ok(Running { child, since: Instant::now(), limits, is_too_long, streams })
}

/// Reads a stream to its end, or until it is too long.
fn kept(stream: Option<impl Read + Send + 'static>, is_too_long: &Arc<AtomicBool>) -> JoinHandle<Vec<u8>> {
    let is_too_long = is_too_long.clone();
    thread::spawn(move || {
        let mut bytes = Vec::new();
        // What was read before a fault of the pipe is kept.
        let _ = stream.map(|stream| stream.take(LONGEST + 1).read_to_end(&mut bytes));
        if bytes.len() as u64 > LONGEST {
            is_too_long.store(true, Ordering::Relaxed);
        }
        bytes
    })
}

impl Running {
    /// How it ended, if it has; a limit ends it here.
    pub(super) fn ended(&mut self) -> Option<Ended> {
        if self.is_too_long.load(Ordering::Relaxed) {
            self.end();
            return Some(Ended::Limit(format!(
                "the answer has more than {} MiB, the limit of an answer: ask for less, as by a larger `every`",
                LONGEST >> 20
            )));
        }
        match self.child.try_wait() {
            Ok(Some(status)) => Some(self.said(status)),
            Ok(None) if self.since.elapsed().as_secs_f64() > self.limits.seconds => {
                self.end();
                let (_, errors) = self.spoken();
                let limit = self.limits.seconds;
                Some(Ended::Limit(format!(
                    "the call took more than {limit} s, the limit of time (`plm mcp --seconds`)\n{errors}"
                )))
            }
            Ok(None) => None,
            Err(why) => {
                self.end();
                Some(Ended::Limit(format!("plm cannot be waited for: {why}")))
            }
        }
    }

    fn said(&mut self, status: ExitStatus) -> Ended {
        let (output, errors) = self.spoken();
        // Rust's own words where an allocator has no more.
        if errors.contains("memory allocation of") {
            let limit = self.limits.mebibytes;
            return Ended::Limit(format!(
                "the call needed more than {limit} MiB, the limit of memory (`plm mcp --memory`)"
            ));
        }
        match status.code() {
            Some(code) => Ended::Said(Said { code, output, errors }),
            None => Ended::Limit(format!("the call ended without an answer ({status})\n{errors}")),
        }
    }

    /// Standard output, and the text of standard error.
    fn spoken(&mut self) -> (Vec<u8>, String) {
        let bytes = |stream: JoinHandle<Vec<u8>>| stream.join().unwrap_or_default();
        let [output, errors] = self.streams.take().map(|streams| streams.map(bytes)).unwrap_or_default();
        (output, String::from_utf8_lossy(&errors).into_owned())
    }

    fn end(&mut self) {
        // It may have ended by itself.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.end();
    }
}
