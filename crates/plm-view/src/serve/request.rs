//! Requests of HTTP/1.1, as much of it as a page sends, bounded in size and time.

use std::io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
use std::io::{self, Read, Write};
use std::time::Instant;

/// A head is no longer, bytes.
const LONGEST_HEAD: usize = 8192;
/// A body is no longer, bytes.
const LONGEST_BODY: usize = 4096;

/// A request that can be answered.
#[derive(Debug)]
pub(super) struct Request {
    pub(super) method: String,
    pub(super) path: String,
    pub(super) host: String,
    /// Origin of the page that sends it, if the browser says so.
    pub(super) origin: Option<String>,
    pub(super) fetch: Fetch,
    pub(super) body: Vec<u8>,
}

/// Who asks for what, if the browser says so (W3C: Fetch Metadata Request Headers).
#[derive(Debug, Default, PartialEq, Eq)]
pub(super) struct Fetch {
    /// `same-origin`, `same-site`, `cross-site`; `none` if the user has typed the address.
    pub(super) site: Option<String>,
    /// `navigate` where the answer is to be shown as a whole.
    pub(super) mode: Option<String>,
    /// Destination: `document`, `image`.
    pub(super) dest: Option<String>,
}

/// Reason why a request is refused: a status of HTTP, and a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Refusal(pub(super) u16, pub(super) &'static str);

const MALFORMED: Refusal = Refusal(400, "this is no request of HTTP/1.1");
const TOO_LARGE: Refusal = Refusal(413, "the request is too large");
const TOO_SLOW: Refusal = Refusal(408, "the request took too long");

/// Reads a request until a moment of the clock; a read of the stream ends by itself, and may give nothing.
///
/// # Errors
/// A request that is malformed, too large or too slow.
pub(super) fn read(stream: &mut impl Read, until: Instant) -> Result<Request, Refusal> {
    let mut bytes = Vec::new();
    let end = loop {
        if let Some(end) = bytes.windows(4).position(|window| window == b"\r\n\r\n") {
            break end;
        }
        if bytes.len() > LONGEST_HEAD {
            return Err(TOO_LARGE);
        }
        more(stream, &mut bytes, until)?;
    };
    let mut body = bytes.split_off(end + 4);
    bytes.truncate(end);
    let head = String::from_utf8(bytes).map_err(|_| MALFORMED)?;
    let (mut request, length) = parse(&head)?;
    while body.len() < length {
        more(stream, &mut body, until)?;
    }
    body.truncate(length);
    request.body = body;
    Ok(request)
}

fn more(stream: &mut impl Read, bytes: &mut Vec<u8>, until: Instant) -> Result<(), Refusal> {
    let mut block = [0; 1024];
    if Instant::now() > until {
        return Err(TOO_SLOW);
    }
    match stream.read(&mut block) {
        Ok(0) => Err(MALFORMED),
        Ok(count) => {
            bytes.extend(block.iter().take(count));
            Ok(())
        }
        // Nothing came; how long that may be is not for a single read to say.
        Err(error) if [Interrupted, WouldBlock, TimedOut].contains(&error.kind()) => Ok(()),
        Err(_) => Err(MALFORMED),
    }
}

/// A head without its empty line, and how long the body is.
fn parse(head: &str) -> Result<(Request, usize), Refusal> {
    let (first, rest) = head.split_once("\r\n").unwrap_or((head, ""));
    let mut words = first.split(' ');
    let (Some(method), Some(path), Some("HTTP/1.1"), None) =
        (words.next(), words.next(), words.next(), words.next())
    else {
        return Err(MALFORMED);
    };
    let fields: Option<Vec<(&str, &str)>> =
        rest.split("\r\n").filter(|line| !line.is_empty()).map(field).collect();
    let fields = fields.ok_or(MALFORMED)?;
    // A field that stands twice is read by one as the first and by another as the second.
    let one = |name: &str| {
        let mut found =
            fields.iter().filter(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, value)| *value);
        let first = found.next();
        if found.next().is_some() { Err(MALFORMED) } else { Ok(first) }
    };
    if one("transfer-encoding")?.is_some() {
        return Err(MALFORMED);
    }
    let length = one("content-length")?.map_or(Ok(0), length)?;
    let host = one("host")?.ok_or(MALFORMED)?.to_ascii_lowercase();
    let lower = |name: &str| Ok(one(name)?.map(str::to_ascii_lowercase));
    let (method, path, origin) = (method.to_owned(), path.to_owned(), lower("origin")?);
    let [site, mode, dest] = ["sec-fetch-site", "sec-fetch-mode", "sec-fetch-dest"].map(lower);
    let fetch = Fetch { site: site?, mode: mode?, dest: dest? };
    Ok((Request { method, path, host, origin, fetch, body: Vec::new() }, length))
}

fn field(line: &str) -> Option<(&str, &str)> {
    let (name, value) = line.split_once(':')?;
    let is_name = !name.is_empty() && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'-');
    is_name.then_some((name, value.trim()))
}

fn length(digits: &str) -> Result<usize, Refusal> {
    if digits.is_empty() || !digits.bytes().all(|digit| digit.is_ascii_digit()) {
        return Err(MALFORMED);
    }
    digits.parse().ok().filter(|length| *length <= LONGEST_BODY).ok_or(TOO_LARGE)
}

/// Writes a whole answer.
///
/// # Errors
/// Those of the stream.
pub(super) fn answer(stream: &mut impl Write, status: u16, kind: &str, body: &str) -> io::Result<()> {
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status} {}\r\nContent-Type: {kind}; charset=utf-8\r\nContent-Length: {length}\r\n{COMMON}\r\n",
        reason(status)
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())?;
    stream.flush()
}

/// The head of a stream of events.
pub(super) fn events_head() -> String {
    format!("HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\n{COMMON}\r\n")
}

/// The browser stores nothing, and no other page may show this one in a frame, where clicks could be led astray.
const COMMON: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\n\
     Content-Security-Policy: frame-ancestors 'none'\r\nConnection: close\r\n";

fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        204 => "No Content",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        408 => "Request Timeout",
        413 => "Content Too Large",
        503 => "Service Unavailable",
        _ => "Bad Request",
    }
}

#[cfg(test)]
mod tests {
    use std::time::{Duration, Instant};

    use super::{MALFORMED, Refusal, Request, TOO_LARGE, read};

    fn of(bytes: &[u8]) -> Result<Request, Refusal> {
        read(&mut &bytes[..], Instant::now() + Duration::from_secs(5))
    }

    const POST: &[u8] = b"POST /message HTTP/1.1\r\nHost: LocalHost:81\r\nOrigin: http://localhost:81\r\ncontent-length: 2\r\n\r\n{}more";

    #[test]
    fn a_request_is_read() {
        let request = of(POST);
        let found = request.as_ref().map(|r| (&*r.method, &*r.path, &*r.host, r.origin.as_deref(), &*r.body));
        assert_eq!(
            found.ok(),
            Some(("POST", "/message", "localhost:81", Some("http://localhost:81"), &b"{}"[..]))
        );
    }

    #[test]
    fn what_is_malformed_or_too_large_is_refused() {
        let head = |fields: &str| format!("GET / HTTP/1.1\r\nHost: a\r\n{fields}\r\n");
        let long = "a".repeat(10_000);
        for (text, refusal) in [
            (String::new(), MALFORMED),
            ("GET / HTTP/1.1\r\n\r\n".to_owned(), MALFORMED),
            ("GET  / HTTP/1.1\r\nHost: a\r\n\r\n".to_owned(), MALFORMED),
            ("GET / HTTP/1.0\r\nHost: a\r\n\r\n".to_owned(), MALFORMED),
            (head("Host: b\r\n"), MALFORMED),
            (head("no field\r\n"), MALFORMED),
            (head("Content-Length: +1\r\n"), MALFORMED),
            (head("Transfer-Encoding: chunked\r\n"), MALFORMED),
            (head("Content-Length: 3\r\n") + "{}", MALFORMED),
            (head("Content-Length: 5000\r\n"), TOO_LARGE),
            (head("Content-Length: 99999999999999999999999\r\n"), TOO_LARGE),
            (head(&format!("X: {long}\r\n")), TOO_LARGE),
            (long, TOO_LARGE),
        ] {
            assert_eq!(of(text.as_bytes()).err(), Some(refusal), "{text}");
        }
    }

    #[test]
    fn a_request_that_never_ends_is_given_up() {
        struct Endless;
        impl std::io::Read for Endless {
            fn read(&mut self, block: &mut [u8]) -> std::io::Result<usize> {
                std::thread::sleep(Duration::from_millis(2));
                block[0] = b'a';
                Ok(1)
            }
        }
        let refusal = read(&mut Endless, Instant::now() + Duration::from_millis(20));
        assert_eq!(refusal.err(), Some(super::TOO_SLOW));
    }

    /// Random damage to a good request: whatever comes out, nothing breaks.
    #[test]
    fn random_bytes_break_nothing() {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        println!("seed {state:#x}");
        let mut random = |below: usize| {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as usize % below
        };
        let (mut refused, mut taken) = (0, 0);
        for _ in 0..20_000 {
            let mut bytes = POST.to_vec();
            for _ in 0..random(6) {
                let at = random(bytes.len());
                match random(3) {
                    0 => bytes[at] = random(256) as u8,
                    1 => bytes.truncate(at.max(1)),
                    _ => bytes.insert(at, b"\r\n:/ 0"[random(6)]),
                }
            }
            match of(&bytes) {
                Ok(_) => taken += 1,
                Err(_) => refused += 1,
            }
        }
        assert!(taken > 1000 && refused > 1000, "{taken} {refused}");
    }
}
