//! A server of the Model Context Protocol: its tools are the commands of `plm`, its resources the book, the parts and their examples.
//!
//! A call is a process of its own, which limits of time and memory end; a panic ends that process, and the server answers with its cause.
//! The messages are those of the revisions in [`REVISIONS`], a line of JSON each.

mod arguments;
mod folder;
mod process;
mod resources;
mod tools;
mod wire;

use std::collections::{BTreeSet, VecDeque};
use std::io::{self, BufReader, Write};
use std::sync::mpsc::{Receiver, channel};
use std::thread;

use serde_json::{Value, json};

use self::folder::Folder;
pub(crate) use self::process::Limits;
use self::process::{Ended, MEMORY};
use self::wire::{Code, Incoming, Request, Wrong};

/// Revisions of the protocol, the newest first. The first one has no beginning: each request says which revision it has.
const REVISIONS: [&str; 4] = ["2026-07-28", "2025-11-25", "2025-06-18", "2024-11-05"];
/// The newest revision that begins with `initialize`.
const WITH_BEGINNING: &str = REVISIONS[1];
/// The member of a request that says its revision.
const REVISION: &str = "io.modelcontextprotocol/protocolVersion";
const SERVER: &str = "io.modelcontextprotocol/serverInfo";

/// The limit of memory that this process has as a call of a server, bytes; none where it is no call.
pub fn memory_limit() -> Option<usize> {
    let mebibytes: usize = std::env::var(MEMORY).ok()?.parse().ok()?;
    mebibytes.checked_mul(1 << 20)
}

/// Advice to whoever calls the tools.
const INSTRUCTIONS: &str = "plm simulates planar mechanisms that a text declares. Read plm://skill first, and plm://language for the grammar and \
    the parts. Write a declaration, `check` it until it has no errors, look at it by `picture`, then `run` it.";

/// Options of the server.
pub(crate) struct Options {
    /// The folder of all files.
    pub(crate) folder: String,
    pub(crate) limits: Limits,
}

/// Serves standard input and output until the input ends.
///
/// # Errors
/// The folder is none, or the answers cannot be written.
pub(crate) fn serve(options: &Options) -> Result<(), String> {
    let folder = Folder::new(&options.folder)?;
    let (sender, inbox) = channel();
    // It waits for input and ends with the program.
    thread::spawn(move || {
        wire::read(&mut BufReader::new(io::stdin()), |message| sender.send(message).is_ok());
    });
    let mut server = Server {
        folder,
        limits: options.limits,
        inbox,
        waiting: VecDeque::new(),
        cancelled: BTreeSet::new(),
    };
    server.go_on(&mut io::stdout()).map_err(|why| format!("standard output: {why}"))
}

/// A server with the messages that it has not answered.
struct Server {
    folder: Folder,
    limits: Limits,
    inbox: Receiver<Incoming>,
    /// Requests that came while a call was at work.
    waiting: VecDeque<Request>,
    /// Numbers of requests that are wanted no more, as JSON.
    cancelled: BTreeSet<String>,
}

/// The result of a request, or the protocol's error.
type Answer = Result<Value, Wrong>;

impl Server {
    fn go_on(&mut self, output: &mut dyn Write) -> io::Result<()> {
        loop {
            if let Some(request) = self.waiting.pop_front() {
                if !self.cancelled.remove(&request.id.to_string()) {
                    self.answer(&request, output)?;
                }
                continue;
            }
            let Ok(message) = self.inbox.recv() else { return Ok(()) };
            self.take(message, output)?;
        }
    }

    /// Notes a message; what needs no work is answered at once.
    fn take(&mut self, message: Incoming, output: &mut dyn Write) -> io::Result<()> {
        match message {
            Incoming::Request(request) if request.method == "ping" => {
                wire::write(output, &wire::result(&request.id, &json!({})))
            }
            Incoming::Request(request) => {
                self.waiting.push_back(request);
                Ok(())
            }
            Incoming::Cancelled(id) => {
                // Of a request that is answered already nothing is to be done.
                if self.waiting.iter().any(|request| request.id == id) {
                    self.cancelled.insert(id.to_string());
                }
                Ok(())
            }
            Incoming::Unread(wrong) => wire::write(output, &wire::error(&Value::Null, &wrong)),
        }
    }

    fn answer(&mut self, request: &Request, output: &mut dyn Write) -> io::Result<()> {
        let answer = match knows_revision(request) {
            Ok(()) if request.method == "tools/call" => match self.call(request, output)? {
                Some(answer) => answer,
                None => return Ok(()),
            },
            Ok(()) => answer(request),
            Err(wrong) => Err(wrong),
        };
        let message = match answer {
            Ok(result) => wire::result(&request.id, &complete(result, request)),
            Err(wrong) => wire::error(&request.id, &wrong),
        };
        wire::write(output, &message)
    }

    /// Calls a tool; nothing where the call is cancelled.
    fn call(&mut self, request: &Request, output: &mut dyn Write) -> io::Result<Option<Answer>> {
        let params = &request.params;
        let name = params["name"].as_str().unwrap_or_default();
        let Some(tool) = tools::named(name) else {
            let wrong =
                Wrong::new(Code::Params, format!("there is no tool `{name}`; there are {}", tools::names()));
            return Ok(Some(Err(wrong)));
        };
        let call = match tool.call(&params["arguments"], &self.folder) {
            Ok(call) => call,
            Err(why) => return Ok(Some(Ok(tools::failed(&why)))),
        };
        let mut child = match process::start(&call.words, &call.input, self.folder.root(), self.limits) {
            Ok(child) => child,
            Err(why) => return Ok(Some(Ok(tools::failed(&why)))),
        };
        loop {
            if let Some(ended) = child.ended() {
                return Ok(Some(Ok(match ended {
                    Ended::Said(said) => (call.answer)(&said),
                    Ended::Limit(why) => tools::failed(&why),
                })));
            }
            match self.inbox.recv_timeout(process::PAUSE) {
                Ok(Incoming::Cancelled(id)) if id == request.id => return Ok(None),
                Ok(message) => self.take(message, output)?,
                Err(std::sync::mpsc::RecvTimeoutError::Timeout) => {}
                // The input has ended; the call is finished all the same.
                Err(std::sync::mpsc::RecvTimeoutError::Disconnected) => thread::sleep(process::PAUSE),
            }
        }
    }
}

/// Is the revision known that a request says it has, if it says one?
fn knows_revision(request: &Request) -> Result<(), Wrong> {
    match request.params["_meta"][REVISION].as_str() {
        None => Ok(()),
        Some(own) if REVISIONS.contains(&own) => Ok(()),
        Some(own) => {
            Err(Wrong::new(Code::Revision, format!("the revision {own} of the protocol is not known here"))
                .with(json!({ "requested": own, "supported": REVISIONS })))
        }
    }
}

/// A result in the form of its request's revision: the newest one says that it is whole, and how long lists stay true.
fn complete(mut result: Value, request: &Request) -> Value {
    if request.params["_meta"][REVISION] == REVISIONS[0] {
        result["resultType"] = json!("complete");
        if request.method != "tools/call" {
            result["ttlMs"] = json!(0);
            result["cacheScope"] = json!("private");
        }
    }
    result
}

fn answer(request: &Request) -> Answer {
    let params = &request.params;
    match request.method.as_str() {
        "initialize" => Ok(greeting(params)),
        "server/discover" => Ok(json!({
            "supportedVersions": REVISIONS,
            "capabilities": capabilities(),
            "instructions": INSTRUCTIONS,
            "_meta": { SERVER: server() },
        })),
        "tools/list" => Ok(json!({ "tools": tools::list() })),
        "resources/list" => Ok(json!({ "resources": resources::list() })),
        "resources/templates/list" => Ok(json!({ "resourceTemplates": resources::templates() })),
        "resources/read" => {
            let uri = params["uri"].as_str().unwrap_or_default();
            resources::read(uri).map(|contents| json!({ "contents": [contents] }))
        }
        other => Err(Wrong::new(Code::Method, format!("there is no method `{other}`"))),
    }
}

/// The answer to `initialize`: the revision that the client asks for where it is known.
fn greeting(params: &Value) -> Value {
    let asked = params["protocolVersion"].as_str().unwrap_or_default();
    let known = REVISIONS[1..].iter().find(|own| **own == asked);
    json!({
        "protocolVersion": known.unwrap_or(&WITH_BEGINNING),
        "capabilities": capabilities(),
        "serverInfo": server(),
        "instructions": INSTRUCTIONS,
    })
}

fn capabilities() -> Value {
    json!({ "tools": {}, "resources": {} })
}

fn server() -> Value {
    json!({ "name": "plm", "title": "Planar mechanisms", "version": env!("CARGO_PKG_VERSION") })
}
