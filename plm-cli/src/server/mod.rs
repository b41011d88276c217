//! A language server over standard input and output: diagnostics, hover, completion, definitions, layout, quick fixes.
//!
//! The messages are those of the Language Server Protocol 3.17. Texts are compiled when no message waits, so that a keystroke does not
//! wait for the one before.

mod complete;
mod document;
mod meaning;
mod names;
mod parts;
mod path;
mod text;

use std::collections::BTreeMap;
use std::error::Error;
use std::ops::Range;

use lsp_server::{Connection, ErrorCode, Message, Notification, Request, Response};
use plm_compiler::without_panic;
use serde_json::{Value, json};

use crate::layout::formatted;
use document::Document;
use meaning::{Meaning, hover, meaning};

/// Serves until the editor says that it ends.
///
/// # Errors
/// The editor breaks the protocol, or its streams.
pub(crate) fn serve() -> Result<(), Box<dyn Error + Send + Sync>> {
    let (connection, threads) = Connection::stdio();
    let (id, params) = connection.initialize_start()?;
    // Rust files have a formatter; an editor that asks for languages hears of declarations alone.
    let asks = params["capabilities"]["textDocument"]["formatting"]["dynamicRegistration"] == true;
    let capabilities = json!({
        "textDocumentSync": { "openClose": true, "change": 1 },
        "hoverProvider": true,
        "definitionProvider": true,
        "documentFormattingProvider": !asks,
        "codeActionProvider": { "codeActionKinds": ["quickfix"] },
        "completionProvider": { "triggerCharacters": ["."] },
    });
    let info = json!({ "name": "plm", "version": env!("CARGO_PKG_VERSION") });
    connection.initialize_finish(id, json!({ "capabilities": capabilities, "serverInfo": info }))?;
    if asks {
        connection.sender.send(registration().into())?;
    }
    Server { connection: &connection, documents: BTreeMap::new(), stale: Vec::new() }.run()?;
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

struct Server<'a> {
    connection: &'a Connection,
    documents: BTreeMap<String, Document>,
    /// Texts that have changed since they were compiled.
    stale: Vec<String>,
}

impl Server<'_> {
    fn run(&mut self) -> Result<(), Box<dyn Error + Send + Sync>> {
        loop {
            let message = match self.connection.receiver.try_recv() {
                Ok(message) => message,
                Err(_) if self.check()? => continue,
                Err(_) => match self.connection.receiver.recv() {
                    Ok(message) => message,
                    Err(_) => return Ok(()),
                },
            };
            match message {
                Message::Request(request) => {
                    if self.connection.handle_shutdown(&request)? {
                        return Ok(());
                    }
                    let response = self.answer(request);
                    self.connection.sender.send(response.into())?;
                }
                Message::Notification(notification) => self.note(&notification)?,
                Message::Response(_) => {}
            }
        }
    }

    /// Compiles one text that has changed, if there is one.
    fn check(&mut self) -> Result<bool, Box<dyn Error + Send + Sync>> {
        let Some(uri) = self.stale.pop() else { return Ok(false) };
        if let Some(document) = self.documents.get_mut(&uri) {
            let problems = document.check();
            self.publish(&uri, &problems)?;
        }
        Ok(true)
    }

    fn publish(&self, uri: &str, problems: &[Value]) -> Result<(), Box<dyn Error + Send + Sync>> {
        let shown = json!({ "uri": uri, "diagnostics": problems });
        let notification = Notification::new("textDocument/publishDiagnostics".to_owned(), shown);
        Ok(self.connection.sender.send(notification.into())?)
    }

    fn note(&mut self, notification: &Notification) -> Result<(), Box<dyn Error + Send + Sync>> {
        let params = &notification.params;
        let Some(uri) = params["textDocument"]["uri"].as_str() else { return Ok(()) };
        let text = match notification.method.as_str() {
            "textDocument/didOpen" => params["textDocument"]["text"].as_str(),
            "textDocument/didChange" => {
                params["contentChanges"].as_array().and_then(|changes| changes.last()?["text"].as_str())
            }
            "textDocument/didClose" => {
                self.documents.remove(uri);
                return self.publish(uri, &[]);
            }
            _ => None,
        };
        if let Some(text) = text {
            self.documents.insert(uri.to_owned(), Document::new(uri, text.to_owned()));
            self.stale.retain(|other| other != uri);
            self.stale.push(uri.to_owned());
        }
        Ok(())
    }

    fn answer(&self, request: Request) -> Response {
        let Request { id, method, params } = request;
        let uri = params["textDocument"]["uri"].as_str().unwrap_or_default();
        let Some(document) = self.documents.get(uri) else {
            return Response::new_err(id, ErrorCode::InvalidParams as i32, format!("{uri} is not open"));
        };
        let at = text::offset(&document.text, &params["position"]);
        let result = without_panic(|| match method.as_str() {
            "textDocument/hover" => Some(at.and_then(|at| show(document, at)).unwrap_or_default()),
            "textDocument/definition" => Some(at.and_then(|at| definition(document, at)).unwrap_or_default()),
            "textDocument/completion" => Some(json!(at.map(|at| complete::completion(document, at)))),
            "textDocument/formatting" => Some(layout(document)),
            "textDocument/codeAction" => Some(fixes(document, &params["range"])),
            _ => None,
        });
        match result {
            Ok(Some(result)) => Response::new_ok(id, result),
            Ok(None) => {
                Response::new_err(id, ErrorCode::MethodNotFound as i32, format!("there is no {method}"))
            }
            Err(what) => {
                Response::new_err(id, ErrorCode::InternalError as i32, plm_compiler::bug_message(&what))
            }
        }
    }
}

fn show(document: &Document, at: usize) -> Option<Value> {
    let (text, range) = hover(document, at)?;
    let contents = json!({ "kind": "markdown", "value": text });
    Some(json!({ "contents": contents, "range": text::range(&document.text, &range) }))
}

fn definition(document: &Document, at: usize) -> Option<Value> {
    let place =
        |range: &Range<usize>| json!({ "uri": document.uri, "range": text::range(&document.text, range) });
    let (meaning, word, declaration) = meaning(document, at)?;
    let of_kind = |kind: &str| declaration.names.visible(kind, at);
    match meaning {
        Meaning::Name(name) => Some(place(&name.place)),
        // A part that the declaration defines itself.
        Meaning::Part(_) => of_kind(word.path.last()?).map(|name| place(&name.place)),
        _ => None,
    }
}

/// The edit that gives a text its layout; none where it has it, or has none.
fn layout(document: &Document) -> Value {
    let name = text::path(&document.uri);
    match formatted(&name, &document.original) {
        Ok(made) if made != document.original => {
            json!([{ "range": text::range(&document.text, &(0..document.text.len())), "newText": made }])
        }
        _ => json!([]),
    }
}

/// Replacements that diagnostics of a range suggest.
fn fixes(document: &Document, range: &Value) -> Value {
    let [start, end] = ["start", "end"].map(|of| text::offset(&document.text, &range[of]));
    let (Some(start), Some(end)) = (start, end) else { return json!([]) };
    let touched =
        document.problems.iter().filter(|problem| problem.range.start <= end && start <= problem.range.end);
    let fixes = touched.flat_map(|problem| {
        problem.replacements.iter().map(|(title, replacement)| {
            let edit =
                json!({ "range": text::range(&document.text, &problem.range), "newText": replacement });
            json!({
                "title": title,
                "kind": "quickfix",
                "diagnostics": [problem.shown],
                "edit": { "changes": { &document.uri: [edit] } },
            })
        })
    });
    Value::Array(fixes.collect())
}
