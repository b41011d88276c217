//! A page that a running program serves itself, over HTTP from the loopback interface alone: `GET /` is the page, `GET /events`
//! the run as server-sent events, `POST /message` the actions of users in the page.
//!
//! The simulation never waits for a client: each has a thread and a queue of its own.

mod access;
mod client;
mod message;
mod request;

use std::io::{self, Read, Write};
use std::net::{Ipv4Addr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use serde::Serialize;

use crate::page::Page;
use crate::recording::{About, Fault, Recording};
use crate::results::Results;
use client::{Client, Item, json, locked};
pub use message::{Message, Pull};
use request::Refusal;

/// Connections at once; more are refused.
const MOST_CONNECTIONS: usize = 32;
/// Most of them that may listen to events; a further one takes the place of the one that has listened longest. A client that no longer
/// reads is detected late: the system buffers megabytes for it. All other connections are done within seconds.
const MOST_LISTENERS: usize = 24;
/// Messages that were not taken yet; more are refused.
const MOST_MESSAGES: usize = 1024;
/// A request must have come after this time.
const REQUEST_TIME: Duration = Duration::from_secs(3);
/// Of one that is refused so much longer is listened to what still comes.
const FAREWELL: Duration = Duration::from_millis(500);
/// Interval at which clocks are read while nothing comes.
const LOOK: Duration = Duration::from_millis(200);
/// An answer must have been taken after this time.
const ANSWER_TIME: Duration = Duration::from_secs(5);
/// A client whose connection takes nothing for this time is given up.
const STALL_TIME: Duration = Duration::from_secs(5);
/// Events go out so often at most: as often as a page draws.
const FRAME: Duration = Duration::from_millis(16);
/// At the end clients get what still waits for them, in this time.
const LAST_WORDS: Duration = Duration::from_secs(1);

/// A served page and its clients. It ends when it is dropped.
#[derive(Debug)]
pub struct Host {
    shared: Arc<Shared>,
    messages: Receiver<Message>,
    address: SocketAddr,
    accepting: Option<JoinHandle<()>>,
}

/// An event of the stream; as JSON, `kind` says which.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase", rename_all_fields = "camelCase")]
enum Event<'a> {
    /// The first of every stream: what runs, by which start of the program, and whether bodies can be pulled.
    Hello {
        run: String,
        pulls: bool,
        about: &'a About,
    },
    /// A start.
    Began {
        numbers: &'a [f64],
        is_assembled: bool,
    },
    Settings {
        parameters: &'a [f64],
        inputs: &'a [f64],
        shape: &'a [f64],
        size_names: &'a str,
    },
    Running {
        is_running: bool,
        speed: f64,
    },
    Trouble {
        trouble: Option<&'a Fault>,
    },
}

#[derive(Debug)]
struct Shared {
    page: String,
    hello: Arc<str>,
    /// Allowed values of the header `Host`.
    names: Vec<String>,
    state: Mutex<State>,
    connections: AtomicUsize,
    is_over: AtomicBool,
    messages: SyncSender<Message>,
}

/// State for clients that come later, and the clients.
#[derive(Debug)]
struct State {
    row: Arc<[f64]>,
    is_assembled: bool,
    settings: Option<Arc<str>>,
    running: Option<Arc<str>>,
    trouble: Option<Arc<str>>,
    clients: Vec<Arc<Client>>,
}

impl Host {
    /// Serves a page of what a recording describes: its mechanism, and its columns; rows of it are not sent. The port is
    /// chosen by the system where it is 0. With `pulls` the page offers to pull bodies.
    ///
    /// # Errors
    /// If the port cannot be had.
    pub fn start(of: &Recording, port: u16, pulls: bool) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        let address = listener.local_addr()?;
        let described = Recording::empty(of.about.clone());
        let page = Page::new(&Results::from(described).to_bytes()?, &of.about.mechanism.name);
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let run = format!("{}-{}", std::process::id(), since.as_nanos());
        let (sender, messages) = sync_channel(MOST_MESSAGES);
        let shared = Arc::new(Shared {
            page: page.to_served_html(),
            hello: json(&Event::Hello { run, pulls, about: &of.about }).into(),
            names: access::names(address.port()),
            state: Mutex::new(State {
                row: Arc::new([]),
                is_assembled: false,
                settings: None,
                running: None,
                trouble: None,
                clients: Vec::new(),
            }),
            connections: AtomicUsize::new(0),
            is_over: AtomicBool::new(false),
            messages: sender,
        });
        let accepting = Arc::clone(&shared);
        let accepting = thread::Builder::new().spawn(move || accept(&listener, &accepting))?;
        Ok(Self { shared, messages, address, accepting: Some(accepting) })
    }

    /// Address at which it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The next message, if one was sent.
    pub fn message(&self) -> Option<Message> {
        self.messages.try_recv().ok()
    }

    /// Numbers of a moment: time (s); x, y, angle, vx, vy, omega of each body; x, y, angle of each port of the ground; the
    /// columns. All of them in each row.
    pub fn row(&self, numbers: &[f64]) {
        let row: Arc<[f64]> = numbers.into();
        let mut state = locked(&self.shared.state);
        state.row = Arc::clone(&row);
        state.send(&Item::Row(row));
    }

    /// A start, with the numbers of its moment; where nothing was assembled, the start values as they are set.
    pub fn began(&self, numbers: &[f64], is_assembled: bool) {
        let mut state = locked(&self.shared.state);
        state.row = numbers.into();
        state.is_assembled = is_assembled;
        let text = state.began();
        state.send(&Item::Text(text));
    }

    /// Parameters and inputs as they are, and the shape that parameters make with the names of its sizes, as those of
    /// `plm::live::Live::shape` and `size_names`; SI.
    pub fn settings(&self, parameters: &[f64], inputs: &[f64], (shape, size_names): (&[f64], &str)) {
        let text: Arc<str> = json(&Event::Settings { parameters, inputs, shape, size_names }).into();
        let mut state = locked(&self.shared.state);
        state.settings = Some(Arc::clone(&text));
        state.send(&Item::Text(text));
    }

    /// Reports that it runs or stands still, and how many seconds of the run go into a second.
    pub fn running(&self, is_running: bool, speed: f64) {
        let text: Arc<str> = json(&Event::Running { is_running, speed }).into();
        let mut state = locked(&self.shared.state);
        state.running = Some(Arc::clone(&text));
        state.send(&Item::Text(text));
    }

    /// Why nothing moves, or that nothing is wrong any more.
    pub fn trouble(&self, trouble: Option<&Fault>) {
        let text: Arc<str> = json(&Event::Trouble { trouble }).into();
        let mut state = locked(&self.shared.state);
        state.trouble = Some(Arc::clone(&text));
        state.send(&Item::Text(text));
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        self.shared.is_over.store(true, Ordering::Release);
        // The accepting thread wakes up, and closes the port.
        let woken = TcpStream::connect_timeout(&self.address, LAST_WORDS);
        if let (Ok(_), Some(accepting)) = (woken, self.accepting.take()) {
            drop(accepting.join());
        }
        let clients: Vec<Arc<Client>> = locked(&self.shared.state).clients.drain(..).collect();
        for client in &clients {
            client.end();
        }
        let until = Instant::now() + LAST_WORDS;
        while !clients.is_empty()
            && self.shared.connections.load(Ordering::Acquire) > 0
            && Instant::now() < until
        {
            thread::sleep(Duration::from_millis(5));
        }
    }
}

impl State {
    fn send(&mut self, item: &Item) {
        self.clients.retain(|client| {
            let stays = client.push(item.clone());
            if !stays {
                client.give_up();
            }
            stays
        });
    }

    fn began(&self) -> Arc<str> {
        json(&Event::Began { numbers: &self.row, is_assembled: self.is_assembled }).into()
    }
}

/// Takes connections, each to a thread of its own.
fn accept(listener: &TcpListener, shared: &Arc<Shared>) {
    for stream in listener.incoming() {
        if shared.is_over.load(Ordering::Acquire) {
            return;
        }
        let Ok(mut stream) = stream else {
            // As where there are too many files: they become fewer.
            thread::sleep(FRAME);
            continue;
        };
        let limited = stream.set_read_timeout(Some(LOOK)).and(stream.set_write_timeout(Some(STALL_TIME)));
        if limited.is_err() {
            continue;
        }
        if shared.connections.fetch_add(1, Ordering::AcqRel) >= MOST_CONNECTIONS {
            shared.connections.fetch_sub(1, Ordering::AcqRel);
            // The accepting thread does not wait for one that is refused.
            drop(stream.set_read_timeout(Some(FRAME)));
            refuse(&mut stream, Refusal(503, "too many connections"));
            continue;
        }
        let serving = Counted(Arc::clone(shared));
        // A thread that cannot be had closes the connection.
        drop(thread::Builder::new().spawn(move || serve(&mut stream, &serving.0)));
    }
}

/// A connection, which counts as long as it is.
struct Counted(Arc<Shared>);

impl Drop for Counted {
    fn drop(&mut self) {
        self.0.connections.fetch_sub(1, Ordering::AcqRel);
    }
}

/// One request and its answer. A failure to send the answer is ignored.
fn serve(stream: &mut TcpStream, shared: &Shared) {
    let outcome = request::read(stream, Instant::now() + REQUEST_TIME).and_then(|request| {
        access::check(&request, &shared.names)?;
        Ok(request)
    });
    let request = match outcome {
        Ok(request) => request,
        Err(refusal) => return refuse(stream, refusal),
    };
    match (request.method.as_str(), request.path.as_str()) {
        ("GET", "/") => drop(request::answer(&mut InTime::new(stream), 200, "text/html", &shared.page)),
        ("GET", "/events") => drop(events(stream, shared)),
        ("POST", "/message") => match Message::read(&request.body) {
            None => refuse(stream, Refusal(400, "this is no message")),
            Some(message) if shared.messages.try_send(message).is_err() => {
                refuse(stream, Refusal(503, "the program does not take messages"));
            }
            Some(_) => drop(request::answer(stream, 204, "text/plain", "")),
        },
        (_, "/" | "/events" | "/message") => refuse(stream, Refusal(405, "not by this method")),
        _ => refuse(stream, Refusal(404, "there is nothing of this name")),
    }
}

/// A connection that has to take all that is written within [`ANSWER_TIME`]. One that takes a little now and then would hold its
/// place for hours.
struct InTime<'a> {
    stream: &'a mut TcpStream,
    until: Instant,
}

impl<'a> InTime<'a> {
    fn new(stream: &'a mut TcpStream) -> Self {
        Self { stream, until: Instant::now() + ANSWER_TIME }
    }
}

impl Write for InTime<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if Instant::now() > self.until {
            Err(io::ErrorKind::TimedOut.into())
        } else {
            self.stream.write(bytes)
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        self.stream.flush()
    }
}

/// Sends a refusal, and reads some of the remaining request: unread bytes would discard the answer.
fn refuse(stream: &mut TcpStream, Refusal(status, why): Refusal) {
    let said =
        request::answer(stream, status, "text/plain", why).and_then(|()| stream.shutdown(Shutdown::Write));
    let until = Instant::now() + FAREWELL;
    let mut block = [0; 4096];
    let mut left = 64;
    while said.is_ok()
        && left > 0
        && Instant::now() < until
        && stream.read(&mut block).is_ok_and(|count| count > 0)
    {
        left -= 1;
    }
}

/// Sends events until the client leaves.
fn events(stream: &mut TcpStream, shared: &Shared) -> io::Result<()> {
    stream.set_nodelay(true)?;
    stream.write_all(request::events_head().as_bytes())?;
    let client = Arc::new(Client::new(stream.try_clone()?));
    {
        let mut state = locked(&shared.state);
        if state.clients.len() >= MOST_LISTENERS {
            state.clients.remove(0).give_up();
        }
        // Whatever is sent from now on comes after this.
        client.push(Item::Text(Arc::clone(&shared.hello)));
        let texts = [state.settings.clone(), (!state.row.is_empty()).then(|| state.began())];
        let further = [state.running.clone(), state.trouble.clone()];
        for text in texts.into_iter().chain(further).flatten() {
            client.push(Item::Text(text));
        }
        state.clients.push(Arc::clone(&client));
    }
    if shared.is_over.load(Ordering::Acquire) {
        client.end();
    }
    let outcome = loop {
        let Some(text) = client.take() else { break Ok(()) };
        if let Err(error) = stream.write_all(text.as_bytes()) {
            break Err(error);
        }
        thread::sleep(FRAME);
    };
    client.give_up();
    outcome
}
