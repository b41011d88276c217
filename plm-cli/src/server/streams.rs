//! The language server on standard input and output.
//!
//! Texts are compiled when no message waits, so that a keystroke does not wait for the one before.

use std::error::Error;

use lsp_server::{Connection, Message, Request};
use serde_json::json;

use super::{Server, asks_for_languages, greeting};

/// Serves until the editor says that it ends.
///
/// # Errors
/// The editor breaks the protocol, or its streams.
pub(crate) fn serve() -> Result<(), Box<dyn Error + Send + Sync>> {
    let (connection, threads) = Connection::stdio();
    let (id, params) = connection.initialize_start()?;
    connection.initialize_finish(id, greeting(&params))?;
    if asks_for_languages(&params) {
        connection.sender.send(registration().into())?;
    }
    go_on(&connection, &mut Server::default())?;
    // Its thread ends when the last sender has gone.
    drop(connection);
    Ok(threads.join()?)
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
