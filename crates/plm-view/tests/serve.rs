//! A served page among clients that mean no good: nobody is shut out for long.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::thread::sleep;
use std::time::{Duration, Instant};

use plm_view::Recording;
use plm_view::serve::Host;

/// As the book says. Another second is for a machine with more to do.
const SHUT_OUT: Duration = Duration::from_secs(6);

fn host() -> Host {
    Host::start(&Recording::new([("x", "m")]), 0, false).unwrap()
}

/// A connection that has asked for something, and reads nothing yet.
fn asked(address: SocketAddr, path: &str, more: &str) -> TcpStream {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
    // One that is refused may be closed already.
    let _ = write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\n{more}\r\n");
    stream
}

fn status(mut stream: TcpStream) -> String {
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer);
    String::from_utf8_lossy(&answer).split(' ').nth(1).unwrap_or("none").to_owned()
}

/// How long it takes until the page is given.
fn time_to_page(address: SocketAddr) -> Duration {
    let begun = Instant::now();
    while status(asked(address, "/", "")) != "200" {
        assert!(begun.elapsed() < SHUT_OUT, "shut out for {:?}", begun.elapsed());
        sleep(Duration::from_millis(50));
    }
    begun.elapsed()
}

/// The text of a stream of events up to some words.
fn heard(stream: &mut TcpStream, words: &str) -> String {
    let (mut text, mut block) = (String::new(), [0; 4096]);
    while !text.contains(words) {
        let count = stream.read(&mut block).unwrap();
        assert!(count > 0, "it ends before `{words}`: {text}");
        text.push_str(&String::from_utf8_lossy(&block[..count]));
    }
    text
}

/// The system takes megabytes for those that never read, so that nothing tells them from others for minutes.
#[test]
fn streams_that_nobody_reads_shut_nobody_out() {
    let host = host();
    let silent: Vec<TcpStream> = (0..100).map(|_| asked(host.address(), "/events", "")).collect();
    host.row(&[0.0, 1.5]);
    println!("the page after {:?}", time_to_page(host.address()));
    let mut listener = asked(host.address(), "/events", "");
    heard(&mut listener, "\"hello\"");
    host.row(&[0.1, 2.5]);
    heard(&mut listener, "0.1,2.5");
    drop(silent);
}

/// Who has listened longest makes room, and is told by the end.
#[test]
fn the_oldest_stream_ends_where_there_are_too_many() {
    let host = host();
    let mut listeners = Vec::new();
    for _ in 0..25 {
        let mut listener = asked(host.address(), "/events", "");
        heard(&mut listener, "\"hello\"");
        listeners.push(listener);
    }
    host.row(&[0.1, 2.5]);
    let mut oldest = listeners.remove(0);
    let mut rest = Vec::new();
    oldest.read_to_end(&mut rest).unwrap();
    assert!(!String::from_utf8_lossy(&rest).contains("2.5"));
    for listener in &mut listeners {
        heard(listener, "0.1,2.5");
    }
}

/// Connections that send nothing, or a little at a time.
#[test]
fn requests_that_never_end_shut_nobody_out() {
    let host = host();
    let mut slow: Vec<TcpStream> = (0..40).map(|_| TcpStream::connect(host.address()).unwrap()).collect();
    let begun = Instant::now();
    let mut is_served = false;
    while !is_served && begun.elapsed() < SHUT_OUT {
        for stream in &mut slow {
            let _ = stream.write_all(b"G");
        }
        sleep(Duration::from_millis(100));
        is_served = status(asked(host.address(), "/", "")) == "200";
    }
    println!("the page after {:?}", begun.elapsed());
    assert!(is_served, "shut out for {:?}", begun.elapsed());
}

/// An image in any web page asks like this, without an origin.
#[test]
fn requests_that_another_page_makes_are_refused() {
    let host = host();
    let fetch = "Sec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: no-cors\r\nSec-Fetch-Dest: image\r\n";
    for path in ["/events", "/"] {
        assert_eq!(status(asked(host.address(), path, fetch)), "403", "{path}");
    }
    let typed = "Sec-Fetch-Site: none\r\nSec-Fetch-Mode: navigate\r\nSec-Fetch-Dest: document\r\n";
    assert_eq!(status(asked(host.address(), "/", typed)), "200");
}
