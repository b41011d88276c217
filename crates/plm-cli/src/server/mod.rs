//! A language server: diagnostics, hover, completion, definitions, references, outline, layout, quick fixes.
//!
//! The messages are those of the Language Server Protocol 3.17.

mod complete;
mod document;
mod draw;
mod gesture;
mod hints;
mod home;
mod meaning;
mod names;
mod parts;
mod path;
mod signature;
mod start;
mod streams;
mod symbols;
mod text;
mod uses;

use std::collections::BTreeMap;
use std::ops::Range;

use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use plm_compiler::without_panic;
use serde_json::{Value, json};

use crate::layout::formatted;
use document::Document;
use meaning::{Meaning, hover, meaning};
pub(crate) use streams::serve;

/// A language server, whatever carries its messages.
#[derive(Default)]
pub struct Server {
    documents: BTreeMap<String, Document>,
    /// Texts that have changed since they were compiled.
    stale: Vec<String>,
    /// Does the editor take snippets?
    with_snippets: bool,
    /// The pin of a drag that goes on.
    dragging: Option<draw::Dragging>,
}

impl Server {
    /// Takes one message of the protocol as JSON, and gives what follows from it, until texts have been compiled: answers and
    /// diagnostics, as JSON each. A text that is no message of the protocol has the protocol's error for it.
    pub fn message(&mut self, text: &str) -> Vec<String> {
        let message = match serde_json::from_str(text) {
            Ok(message) => message,
            Err(error) => return vec![unread(&error).to_string()],
        };
        let mut answers: Vec<Message> = match message {
            Message::Request(Request { id, method, params }) if method == "initialize" => {
                vec![Response::new_ok(id, self.greet(&params)).into()]
            }
            Message::Request(request) => vec![self.answer(request).into()],
            Message::Notification(notification) => {
                self.note(&notification).into_iter().map(Message::from).collect()
            }
            Message::Response(_) => Vec::new(),
        };
        while let Some(shown) = self.check() {
            answers.push(shown.into());
        }
        answers.iter().filter_map(|answer| serde_json::to_string(answer).ok()).collect()
    }

    /// Notes what an editor can, and says what the server can.
    fn greet(&mut self, params: &Value) -> Value {
        let completion = &params["capabilities"]["textDocument"]["completion"];
        self.with_snippets = completion["completionItem"]["snippetSupport"] == true;
        greeting(params)
    }

    /// Compiles one text that has changed, if there is one: its diagnostics.
    fn check(&mut self) -> Option<Notification> {
        let uri = self.stale.pop()?;
        let problems = self.documents.get_mut(&uri).map(Document::check).unwrap_or_default();
        Some(published(&uri, &problems))
    }

    /// Notes what became of a text; of one that was closed no diagnostics are left.
    fn note(&mut self, notification: &Notification) -> Option<Notification> {
        let params = &notification.params;
        let uri = params["textDocument"]["uri"].as_str()?;
        let text = match notification.method.as_str() {
            "textDocument/didOpen" => params["textDocument"]["text"].as_str(),
            "textDocument/didChange" => {
                params["contentChanges"].as_array().and_then(|changes| changes.last()?["text"].as_str())
            }
            "textDocument/didClose" => {
                self.documents.remove(uri);
                self.stale.retain(|other| other != uri);
                return Some(published(uri, &[]));
            }
            _ => None,
        }?;
        self.documents.insert(uri.to_owned(), Document::new(uri, text.to_owned()));
        self.stale.retain(|other| other != uri);
        self.stale.push(uri.to_owned());
        None
    }

    fn answer(&mut self, request: Request) -> Response {
        let Request { id, method, params } = request;
        let uri = params["textDocument"]["uri"].as_str().unwrap_or_default();
        // A page asks about a text of its own, which need not be open.
        let of_text = params["text"].as_str().and_then(|text| match method.as_str() {
            "plm/draw" => {
                Some(without_panic(|| draw::answered_of_text(uri, text, &params, &mut self.dragging)))
            }
            "plm/equations" => Some(without_panic(|| home::equations(&Document::new(uri, text.to_owned())))),
            _ => None,
        });
        if let Some(answered) = of_text {
            return match answered {
                Ok(answer) => Response::new_ok(id, answer),
                Err(what) => {
                    Response::new_err(id, ErrorCode::InternalError as i32, plm_compiler::bug_message(&what))
                }
            };
        }
        let Some(document) = self.documents.get(uri) else {
            return Response::new_err(id, ErrorCode::InvalidParams as i32, format!("{uri} is not open"));
        };
        let at = text::offset(&document.text, &params["position"]);
        if method == "textDocument/rename" {
            let name = params["newName"].as_str().unwrap_or_default();
            let renamed = without_panic(|| uses::rename(document, at, name));
            return match renamed.unwrap_or_else(|what| Err(plm_compiler::bug_message(&what))) {
                Ok(edits) => Response::new_ok(id, edits),
                Err(why) => Response::new_err(id, ErrorCode::InvalidParams as i32, why),
            };
        }
        let result = without_panic(|| match method.as_str() {
            "textDocument/hover" => Some(at.and_then(|at| show(document, at)).unwrap_or_default()),
            "textDocument/definition" => Some(at.and_then(|at| definition(document, at)).unwrap_or_default()),
            "textDocument/completion" => {
                Some(json!(at.map(|at| complete::completion(document, at, self.with_snippets))))
            }
            "textDocument/documentSymbol" => Some(symbols::symbols(document)),
            "textDocument/references" => {
                let with_declaration = params["context"]["includeDeclaration"] == true;
                Some(at.and_then(|at| uses::references(document, at, with_declaration)).unwrap_or_default())
            }
            "textDocument/prepareRename" => {
                Some(at.and_then(|at| uses::renamed(document, at)).unwrap_or_default())
            }
            "textDocument/signatureHelp" => {
                Some(at.and_then(|at| signature::signature(document, at)).unwrap_or_default())
            }
            "textDocument/inlayHint" => Some(inlay(document, &params["range"])),
            "textDocument/formatting" => Some(layout(document)),
            "textDocument/codeAction" => Some(fixes(document, &params["range"])),
            "plm/package" => Some(home::package(document)),
            "plm/source" => Some(home::source(document, &params)),
            "plm/equations" => Some(home::equations(document)),
            "plm/draw" => Some(draw::answered(document, &params)),
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

/// Capabilities of the server, for an editor that sends its own.
fn greeting(params: &Value) -> Value {
    let capabilities = json!({
        "textDocumentSync": { "openClose": true, "change": 1 },
        "hoverProvider": true,
        "definitionProvider": true,
        "documentFormattingProvider": !asks_for_languages(params),
        "codeActionProvider": { "codeActionKinds": ["quickfix"] },
        "completionProvider": { "triggerCharacters": ["."] },
        "documentSymbolProvider": true,
        "referencesProvider": true,
        "renameProvider": { "prepareProvider": true },
        "signatureHelpProvider": { "triggerCharacters": ["(", ","] },
        "inlayHintProvider": true,
    });
    let info = json!({ "name": "plm", "version": env!("CARGO_PKG_VERSION") });
    json!({ "capabilities": capabilities, "serverInfo": info })
}

/// Does an editor ask of which languages there is a layout? Rust files have a formatter; such an editor hears of declarations alone.
fn asks_for_languages(params: &Value) -> bool {
    params["capabilities"]["textDocument"]["formatting"]["dynamicRegistration"] == true
}

/// The protocol's error for what cannot be read (JSON-RPC 2.0, 5.1).
fn unread(error: &serde_json::Error) -> Value {
    let code = if error.is_data() { ErrorCode::InvalidRequest } else { ErrorCode::ParseError };
    json!({ "jsonrpc": "2.0", "id": null, "error": { "code": code as i32, "message": error.to_string() } })
}

fn inlay(document: &Document, range: &Value) -> Value {
    let [start, end] = ["start", "end"].map(|of| text::offset(&document.text, &range[of]));
    let all = 0..document.text.len();
    hints::hints(document, &(start.unwrap_or(all.start)..end.unwrap_or(all.end)))
}

fn published(uri: &str, problems: &[Value]) -> Notification {
    let shown = json!({ "uri": uri, "diagnostics": problems });
    Notification::new("textDocument/publishDiagnostics".to_owned(), shown)
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

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::Server;

    /// Answers to a message.
    fn said(server: &mut Server, message: &Value) -> Vec<Value> {
        let answers = server.message(&message.to_string());
        answers.iter().filter_map(|text| serde_json::from_str(text).ok()).collect()
    }

    #[test]
    fn a_message_is_answered_without_streams() {
        let mut server = Server::default();
        let greeting = json!({ "id": 1, "method": "initialize", "params": { "capabilities": {} } });
        let [greeting] = &said(&mut server, &greeting)[..] else { unreachable!() };
        assert_eq!(greeting["result"]["capabilities"]["documentFormattingProvider"], true);

        let text = "pub P { ground { port o: (0, 0) m; } body b { mass: 1 kg } }";
        let document = json!({ "uri": "plm:p.plm", "languageId": "plm", "version": 1, "text": text });
        let open = json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } });
        let [shown] = &said(&mut server, &open)[..] else { unreachable!() };
        assert_eq!(shown["method"], "textDocument/publishDiagnostics");
        assert!(shown["params"]["diagnostics"].as_array().is_some_and(|all| !all.is_empty()), "{shown}");

        let place =
            json!({ "textDocument": { "uri": "plm:p.plm" }, "position": { "line": 0, "character": 45 } });
        let asked = json!({ "id": 2, "method": "textDocument/completion", "params": place });
        let [found] = &said(&mut server, &asked)[..] else { unreachable!() };
        let labels =
            found["result"].as_array().map(|all| all.iter().map(|of| &of["label"]).collect::<Vec<_>>());
        assert!(labels.is_some_and(|labels| labels.contains(&&json!("mass"))), "{found}");

        let asked = json!({ "id": 3, "method": "plm/package", "params": { "textDocument": document } });
        let [found] = &said(&mut server, &asked)[..] else { unreachable!() };
        let main = found["result"]["files"]["src/main.rs"].as_str().unwrap_or_default();
        assert!(main.contains(text) && found["result"]["name"] == "p", "{found}");

        let source = |server: &mut Server, kind: &str| {
            let params = json!({ "textDocument": document, "kind": kind });
            let all = said(server, &json!({ "id": 4, "method": "plm/source", "params": params }));
            all.first().map(|found| found["result"].clone()).unwrap_or_default()
        };
        // The declaration has a mistake.
        assert!(source(&mut server, "c")["why"].as_str().is_some_and(|why| why.contains("error[")));
        let text = "pub P { ground { port o: (0, 0) m; } body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 1) m; } \
                    revolute pin(ground.o, b.o); }";
        let params = json!({ "textDocument": { "uri": "plm:p.plm", "version": 2 }, "contentChanges": [{ "text": text }] });
        said(&mut server, &json!({ "method": "textDocument/didChange", "params": params }));
        for (kind, file) in
            [("c", "p.h"), ("fmi2", "sources/p_fmi.c"), ("fmi3", "sources/buildDescription.xml")]
        {
            let made = source(&mut server, kind);
            assert!(
                made["files"][file].is_string() && made["name"] == "p" && made["notices"] == json!([]),
                "{made}"
            );
        }
        assert!(source(&mut server, "fmi1")["why"].is_string());

        // Of the open text, and of one that is sent along.
        let mut equations = |params: Value| {
            let all = said(&mut server, &json!({ "id": 5, "method": "plm/equations", "params": params }));
            all.first().map(|found| found["result"].clone()).unwrap_or_default()
        };
        let open = json!({ "textDocument": { "uri": "plm:p.plm" } });
        assert_eq!(equations(open)["coordinates"][0][0], "b.angle");
        let of = |text: &str| json!({ "textDocument": { "uri": "plm:other" }, "text": text });
        let found = equations(of(&text.replace("inertia: 1", "inertia: 4")));
        // About a pin that is 1 m from the centre the moment of inertia is 4 + 1*1^2.
        assert!(
            found["latex"].as_str().is_some_and(|latex| latex.contains("\\[ 5 \\ddot{\\varphi}_{b} = 0")),
            "{found}"
        );
        assert!(found["mathml"][0].as_str().is_some_and(|math| math.starts_with("<math")), "{found}");
        assert!(
            equations(of("pub P { body b { mass: 1; } }"))["why"]
                .as_str()
                .is_some_and(|why| why.contains("error["))
        );
        let rust = json!({ "textDocument": { "uri": "plm:main.rs" }, "text": "fn main() {}" });
        assert_eq!(equations(rust), Value::Null);

        let closed = json!({ "method": "textDocument/didClose", "params": { "textDocument": document } });
        let [shown] = &said(&mut server, &closed)[..] else { unreachable!() };
        assert_eq!(shown["params"]["diagnostics"], json!([]));
        let [unread] = &server.message("no message")[..] else { unreachable!() };
        assert!(unread.contains("-32700"), "{unread}");
    }
}
