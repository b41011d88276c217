//! The language server on standard input and output.
//!
//! Texts are compiled when no message waits, so that a keystroke does not wait for the one before. A frame whose text is no message is
//! answered with the protocol's error, and the next one is read.

use std::error::Error;
use std::io::{self, BufRead, Write, stdin, stdout};
use std::thread;

use lsp_server::{Connection, Message, Notification, Request};
use serde_json::json;

use super::{Server, asks_for_languages, unread};

/// The longest text of a frame, bytes.
const MOST: usize = 1 << 28;

/// Serves until the editor says that it ends.
///
/// # Errors
/// The editor breaks the protocol, or its streams.
pub(crate) fn serve() -> Result<(), Box<dyn Error + Send + Sync>> {
    let (connection, streams) = Connection::memory();
    let writer = thread::spawn(move || streams.receiver.into_iter().try_for_each(|message| write(&message)));
    let to_server = streams.sender;
    let reader = thread::spawn(move || -> io::Result<()> {
        let mut input = stdin().lock();
        while let Some(message) = read(&mut input)? {
            let is_last =
                matches!(&message, Message::Notification(Notification { method, .. }) if method == "exit");
            // After the end there is no receiver of a message.
            if to_server.send(message).is_err() || is_last {
                break;
            }
        }
        Ok(())
    });
    let mut server = Server::default();
    let (id, params) = connection.initialize_start()?;
    connection.initialize_finish(id, server.greet(&params))?;
    if asks_for_languages(&params) {
        connection.sender.send(registration().into())?;
    }
    go_on(&connection, &mut server)?;
    // Its thread ends when the last sender has gone.
    drop(connection);
    for stream in [reader, writer] {
        stream.join().map_err(|_| "a stream of the server has panicked")??;
    }
    Ok(())
}

/// The next message; `None` if the stream ends. Malformed messages are answered here.
fn read(input: &mut impl BufRead) -> io::Result<Option<Message>> {
    loop {
        let Some(text) = frame(input)? else { return Ok(None) };
        match serde_json::from_slice(&text) {
            Ok(message) => return Ok(Some(message)),
            Err(error) => write_text(&unread(&error).to_string())?,
        }
    }
}

/// The text of the next frame: after a head of fields and an empty line, as long as `Content-Length` says.
fn frame(input: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut length = None;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line)? == 0 {
            return Ok(None);
        }
        match line.trim_end().split_once(':') {
            Some((field, value)) if field.eq_ignore_ascii_case("Content-Length") => {
                length = value.trim().parse().ok().filter(|length| *length <= MOST);
            }
            Some(_) => {}
            None if line.trim_end().is_empty() => break,
            None => return Err(io::Error::other(format!("no field of a frame: {line:?}"))),
        }
    }
    let length = length.ok_or_else(|| io::Error::other("a frame without a Content-Length"))?;
    let mut text = vec![0; length];
    input.read_exact(&mut text)?;
    Ok(Some(text))
}

fn write(message: &Message) -> io::Result<()> {
    let mut output = stdout().lock();
    message.clone().write(&mut output)
}

fn write_text(text: &str) -> io::Result<()> {
    let mut output = stdout().lock();
    write!(output, "Content-Length: {}\r\n\r\n{text}", text.len())?;
    output.flush()
}

/// Registers the layout of declarations.
fn registration() -> Request {
    let options = json!({ "documentSelector": [{ "language": "plm" }] });
    let registration =
        json!({ "id": "layout", "method": "textDocument/formatting", "registerOptions": options });
    let id = "layout".to_owned().into();
    Request::new(id, "client/registerCapability".to_owned(), json!({ "registrations": [registration] }))
}

fn go_on(connection: &Connection, server: &mut Server) -> Result<(), Box<dyn Error + Send + Sync>> {
    loop {
        while connection.receiver.is_empty()
            && let Some(shown) = server.check()
        {
            connection.sender.send(shown.into())?;
        }
        let Ok(message) = connection.receiver.recv() else { return Ok(()) };
        if take(connection, server, message)? {
            return Ok(());
        }
    }
}

/// Answers a message; whether it was the last.
fn take(
    connection: &Connection,
    server: &mut Server,
    message: Message,
) -> Result<bool, Box<dyn Error + Send + Sync>> {
    match message {
        Message::Request(request) => {
            if connection.handle_shutdown(&request)? {
                return Ok(true);
            }
            connection.sender.send(server.answer(request).into())?;
        }
        Message::Notification(notification) => {
            if let Some(shown) = server.note(&notification) {
                connection.sender.send(shown.into())?;
            }
        }
        Message::Response(_) => {}
    }
    Ok(false)
}
