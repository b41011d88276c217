//! A program that serves its page, beside a client that knows nothing but sockets.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use plm::view::serve::Host;
use plm::view::{Recorder, Recording, Server};

plm::mechanism! {
    /// A pendulum with a parameter, an input, and what pulls it.
    Pendulum {
        gravity: 9.81 m/s^2;
        param length: mm = 500 mm;
        input torque: N*m = 0;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pivot: (0, length); start angle: 30 deg, locked; }
        revolute hinge(ground.o, bob.pivot) { drive: torque; }
        part plm_pull(a: body) { input x: N = 0; input y: N = 0; input turn: N*m = 0; force on a: (x, y); torque on a: turn; }
        input plm_pull_0_x: N = 0; input plm_pull_0_y: N = 0; input plm_pull_0_turn: N*m = 0;
        plm_pull plm_pull_0(bob) { x: plm_pull_0_x; y: plm_pull_0_y; turn: plm_pull_0_turn; }
        output bob.angle in deg, hinge.force;
    }
}

/// Some tests are slower where other builds run; none waits longer.
const PATIENCE: Duration = Duration::from_secs(60);

fn connect(address: SocketAddr) -> TcpStream {
    let stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(PATIENCE)).unwrap();
    stream
}

/// Everything that comes back for these bytes.
fn answer(address: SocketAddr, request: &[u8]) -> String {
    let mut stream = connect(address);
    // Who refuses may close before all is sent.
    let _ = stream.write_all(request);
    let mut bytes = Vec::new();
    let _ = stream.read_to_end(&mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

fn status(address: SocketAddr, request: &str) -> String {
    answer(address, request.as_bytes()).split(' ').nth(1).unwrap_or("none").to_owned()
}

fn post(address: SocketAddr, body: &str) -> String {
    let length = body.len();
    status(
        address,
        &format!("POST /message HTTP/1.1\r\nHost: {address}\r\nContent-Length: {length}\r\n\r\n{body}"),
    )
}

/// A client of the events.
struct Listener(BufReader<TcpStream>);

impl Listener {
    fn new(address: SocketAddr) -> Self {
        let mut stream = connect(address);
        write!(stream, "GET /events HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", address.port()).unwrap();
        let mut listener = Self(BufReader::new(stream));
        // It is counted among the clients when the first event has come.
        assert_eq!(listener.next().unwrap()["kind"], "hello");
        listener
    }

    /// The next event; none at the end.
    fn next(&mut self) -> Option<serde_json::Value> {
        let mut line = String::new();
        while self.0.read_line(&mut line).unwrap() > 0 {
            if let Some(json) = line.strip_prefix("data: ") {
                return Some(serde_json::from_str(json).unwrap());
            }
            line.clear();
        }
        None
    }

    /// Numbers of the next event of a kind.
    fn numbers(&mut self, kind: &str, list: &str) -> Vec<f64> {
        loop {
            let event = self.next().unwrap();
            if event["kind"] == kind {
                let numbers = event[list].as_array().unwrap();
                return numbers.iter().map(|number| number.as_f64().unwrap_or(f64::NAN)).collect();
            }
        }
    }
}

fn address(server: &Server<Pendulum>) -> SocketAddr {
    server.url().trim_start_matches("http://").trim_end_matches('/').parse().unwrap()
}

#[test]
fn the_page_is_served_to_this_machine_alone() {
    let sim = Pendulum::new().start().unwrap();
    let server = Server::start(&sim, 0).unwrap();
    let address = address(&server);
    assert!(address.ip().is_loopback());
    let page = answer(address, format!("GET / HTTP/1.1\r\nHost: {address}\r\n\r\n").as_bytes());
    assert!(
        page.starts_with("HTTP/1.1 200 OK\r\n") && page.contains("<title>Pendulum</title>"),
        "{page:.300}"
    );
    assert!(page.ends_with("</html>\n") && page.contains("new EventSource(\"events\")"));
    let port = address.port();
    for (request, expected) in [
        (format!("GET / HTTP/1.1\r\nHost: localhost:{port}\r\n\r\n"), "200"),
        (
            format!("GET / HTTP/1.1\r\nHost: localhost:{port}\r\nOrigin: http://localhost:{port}\r\n\r\n"),
            "200",
        ),
        ("GET / HTTP/1.1\r\nHost: example.org\r\n\r\n".to_owned(), "403"),
        (format!("GET / HTTP/1.1\r\nHost: example.org:{port}\r\n\r\n"), "403"),
        ("GET / HTTP/1.1\r\nHost: localhost:1\r\n\r\n".to_owned(), "403"),
        (
            format!("GET /events HTTP/1.1\r\nHost: localhost:{port}\r\nOrigin: http://example.org\r\n\r\n"),
            "403",
        ),
        (format!("POST /message HTTP/1.1\r\nHost: localhost:{port}\r\nOrigin: null\r\n\r\n"), "403"),
        (format!("GET /other HTTP/1.1\r\nHost: localhost:{port}\r\n\r\n"), "404"),
        (format!("DELETE / HTTP/1.1\r\nHost: localhost:{port}\r\n\r\n"), "405"),
        (format!("POST /message HTTP/1.1\r\nHost: localhost:{port}\r\nContent-Length: 9999\r\n\r\n"), "413"),
        (format!("GET /{} HTTP/1.1\r\nHost: localhost:{port}\r\n\r\n", "a".repeat(100_000)), "413"),
        ("GET / HTTP/1.1\r\n\r\n".to_owned(), "400"),
        ("hello\r\n\r\n".to_owned(), "400"),
    ] {
        assert_eq!(status(address, &request), expected, "{request:.200}");
    }
    assert_eq!(post(address, "{\"kind\":\"nothing\"}"), "400");
    assert_eq!(server.message(), None);
}

/// Numbers come to the bit, in the layout of a recording.
#[test]
fn events_have_the_numbers_of_the_run() {
    let mut sim = Pendulum::new().start().unwrap();
    let mut server = Server::start(&sim, 0).unwrap();
    let mut listener = Listener::new(address(&server));
    let mut recorder = Recorder::observing_all(&sim);
    for _ in 0..50 {
        sim.step(0.01).unwrap();
        recorder.take(sim.state());
        server.show(&sim);
    }
    let recording = recorder.recording();
    let ground = [0.0; 3];
    let expected: Vec<f64> = recording
        .rows()
        .enumerate()
        .flat_map(|(k, values)| {
            let time = std::iter::once(recording.times()[k]);
            let poses: Vec<f64> = recording.poses(k).iter().flatten().copied().collect();
            time.chain(poses).chain(ground).chain(values.to_vec())
        })
        .collect();
    let mut found = Vec::new();
    while found.len() < expected.len() {
        found.extend(listener.numbers("rows", "numbers"));
    }
    let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<u64>>();
    assert_eq!(bits(&found), bits(&expected));
    // Who comes later begins with the moment of now.
    let late = Listener::new(address(&server)).numbers("began", "numbers");
    assert_eq!(bits(&late), bits(&expected[expected.len() - late.len()..]));
}

#[test]
fn what_is_posted_changes_the_motion() {
    let mut sim = Pendulum::new().start().unwrap();
    let mut server = Server::start(&sim, 0).unwrap();
    let at = address(&server);
    let mut listener = Listener::new(at);
    sim.step(0.1).unwrap();
    let mut own = sim;
    assert_eq!(post(at, r#"{"kind":"input","index":0,"value":1.5}"#), "204");
    server.obey(&mut sim);
    own.input.torque = 1.5;
    sim.step(0.1).unwrap();
    own.step(0.1).unwrap();
    assert_eq!((sim.input.torque, sim.bob().angle.to_bits()), (1.5, own.bob().angle.to_bits()));
    assert_eq!(listener.numbers("settings", "inputs"), [0.0; 4]);
    assert_eq!(listener.numbers("settings", "inputs")[0], 1.5);

    // Pause and a step; the loop is told to stand still.
    assert_eq!(post(at, r#"{"kind":"pause"}"#), "204");
    server.obey(&mut sim);
    assert!(!server.is_running() && !server.wait_for_step(0.01));
    assert_eq!(post(at, r#"{"kind":"step","dt":0.01,"count":1}"#), "204");
    server.obey(&mut sim);
    assert!(server.wait_for_step(0.005));
    sim.step(0.005).unwrap();
    server.show(&sim);
    assert!(server.wait_for_step(0.005));
    sim.step(0.005).unwrap();
    server.show(&sim);
    assert!(!server.is_running());

    // A pull at the pivot does nothing, one at the centre of gravity as the same torque about the pivot.
    assert_eq!(
        post(
            at,
            r#"{"kind":"pull","pull":{"body":0,"point":[0,0],"target":[0,0],"stiffness":0,"damping":0,"force":[4,0]}}"#
        ),
        "204"
    );
    let mut own = sim;
    server.obey(&mut sim);
    own.input.torque = 1.5 + 4.0 * 0.5 * sim.bob().angle.cos();
    sim.step(1e-4).unwrap();
    own.step(1e-4).unwrap();
    // In the step h the torque of the pull changes by 2 N*m * 1.2/s * h, on 0.26 kg*m^2: 4.6 h^2 in the rate.
    assert!((sim.bob().omega - own.bob().omega).abs() < 5e-8, "{} {}", sim.bob().omega, own.bob().omega);
    assert_eq!(post(at, r#"{"kind":"pull","pull":null}"#), "204");
    server.obey(&mut sim);
    assert_eq!((sim.input.plm_pull_0_x, sim.input.plm_pull_0_turn), (0.0, 0.0));

    // A parameter, a restart with it, and all as declared.
    assert_eq!(post(at, r#"{"kind":"parameter","index":0,"value":0.4}"#), "204");
    assert_eq!(post(at, r#"{"kind":"restart"}"#), "204");
    server.obey(&mut sim);
    let [x, y] = [sim.bob().x, sim.bob().y];
    assert!((sim.time() == 0.0) && (x.hypot(y) - 0.4).abs() < 1e-12 && sim.input.torque == 1.5, "{x} {y}");
    assert_eq!(post(at, r#"{"kind":"reset"}"#), "204");
    assert_eq!(post(at, r#"{"kind":"input","index":99,"value":1}"#), "204");
    server.obey(&mut sim);
    let length = sim.state().mechanism.length;
    assert!(length == 0.5 && sim.input.torque == 0.0, "{length}");
}

/// The picture is never ahead of the clock, whatever the speed.
#[test]
fn a_loop_keeps_to_the_clock() {
    for speed in [1.0, 0.25, 4.0] {
        let mut sim = Pendulum::new().start().unwrap();
        let mut server = Server::start(&sim, 0).unwrap();
        assert_eq!(post(address(&server), &format!(r#"{{"kind":"speed","speed":{speed}}}"#)), "204");
        server.obey(&mut sim);
        let clock = Instant::now();
        // Waits of steps longer than the longest wait at the low speed, too.
        let step = 0.02;
        while sim.time() < 0.2 {
            if server.wait_for_step(step) {
                sim.step(step).unwrap();
                // What was late at the beginning is caught up.
                let ahead = sim.time() - step - speed * (clock.elapsed().as_secs_f64() + 0.1);
                assert!(ahead < 1e-9, "{ahead} s ahead at speed {speed}");
            }
        }
    }
}

/// A client that reads nothing fills its buffers at once; the others and the run go on.
#[test]
fn a_client_that_stalls_holds_up_nobody() {
    let columns = (0..20_000).map(|k| (format!("c{k}"), ""));
    let host = Host::start(&Recording::new(columns), 0, false).unwrap();
    let stalled = Listener::new(host.address());
    let mut listener = Listener::new(host.address());
    let mut numbers = vec![0.1; 20_001];
    let mut longest = Duration::ZERO;
    for k in 0..500 {
        numbers[0] = f64::from(k);
        let before = Instant::now();
        host.row(&numbers);
        longest = longest.max(before.elapsed());
    }
    // A write to the stalled one takes five seconds to fail.
    assert!(longest < Duration::from_secs(2), "{longest:?}");
    let mut last = 0.0;
    while last < 499.0 {
        let rows = listener.numbers("rows", "numbers");
        let times: Vec<f64> = rows.chunks(numbers.len()).map(|row| row[0]).collect();
        assert!(times.is_sorted() && times[0] >= last, "{times:?}");
        last = *times.last().unwrap();
    }
    drop(stalled);
}

#[test]
fn random_requests_break_nothing() {
    static PANICS: AtomicUsize = AtomicUsize::new(0);
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        // Threads of tests have names.
        if std::thread::current().name().is_none() {
            PANICS.fetch_add(1, Ordering::Relaxed);
        }
        usual(info);
    }));
    let mut sim = Pendulum::new().start().unwrap();
    let mut server = Server::start(&sim, 0).unwrap();
    let at = address(&server);
    let mut state = 20_261_123_u64;
    println!("seed {state}");
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let body = r#"{"kind":"parameter","index":0,"value":0.45}"#;
    let good =
        format!("POST /message HTTP/1.1\r\nHost: {at}\r\nContent-Length: {}\r\n\r\n{body}", body.len());
    for _ in 0..300 {
        let mut bytes = good.clone().into_bytes();
        for _ in 0..=random(4) {
            let place = random(bytes.len());
            match random(3) {
                0 => bytes[place] = random(256) as u8,
                1 => drop(bytes.splice(place..(place + random(5)).min(bytes.len()), [])),
                _ => bytes.insert(place, b"\r\n{}:0-e\xff"[random(9)]),
            }
        }
        // The end tells that no more comes.
        let mut stream = connect(at);
        let _ = stream.write_all(&bytes).and_then(|()| stream.shutdown(std::net::Shutdown::Write));
        let mut told = Vec::new();
        let _ = stream.read_to_end(&mut told);
        assert!(told.is_empty() || told.starts_with(b"HTTP/1.1 "), "{told:?}");
        server.obey(&mut sim);
        let _ = sim.step(1e-3);
    }
    assert_eq!(status(at, &format!("GET / HTTP/1.1\r\nHost: {at}\r\n\r\n")), "200");
    assert_eq!(PANICS.load(Ordering::Relaxed), 0);
}

/// What was shown last still comes, then the end.
#[test]
fn a_program_that_ends_tells_its_last_row() {
    let mut sim = Pendulum::new().start().unwrap();
    let mut server = Server::start(&sim, 0).unwrap();
    let at = address(&server);
    let mut listener = Listener::new(at);
    sim.step(0.25).unwrap();
    server.show(&sim);
    drop(server);
    assert_eq!(listener.numbers("rows", "numbers")[0], 0.25);
    assert_eq!(listener.next(), None);
    assert!(TcpStream::connect(at).is_err());
}
