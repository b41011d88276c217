//! A client of `plm lsp`, over its protocol.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;

use serde_json::{Value, json};

use super::{PENDULUM, URI};

pub(crate) struct Client {
    pub(crate) child: Child,
    pub(crate) input: ChildStdin,
    pub(crate) output: Receiver<Value>,
    pub(crate) count: i64,
    /// Diagnostics of the text that came last.
    pub(crate) published: Vec<Value>,
    /// Of the completion that came last.
    pub(crate) snippets: Vec<String>,
}

/// One message in its frame.
fn message(output: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if output.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim_end() {
            "" => break,
            line => {
                length =
                    line.strip_prefix("Content-Length: ").map_or(length, |length| length.parse().unwrap());
            }
        }
    }
    let mut body = vec![0; length];
    output.read_exact(&mut body).ok()?;
    Some(serde_json::from_slice(&body).unwrap())
}

impl Client {
    pub(crate) fn start() -> Client {
        let mut command = Command::new(env!("CARGO_BIN_EXE_plm"));
        let mut child =
            command.args(["lsp", "--stdio"]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (input, stdout) = (child.stdin.take().unwrap(), child.stdout.take().unwrap());
        let (sender, output) = channel();
        std::thread::spawn(move || {
            let mut stdout = BufReader::new(stdout);
            while let Some(message) = message(&mut stdout) {
                if sender.send(message).is_err() {
                    break;
                }
            }
        });
        let mut client =
            Client { child, input, output, count: 0, published: Vec::new(), snippets: Vec::new() };
        let snippets = json!({ "completion": { "completionItem": { "snippetSupport": true } } });
        let able = json!({ "capabilities": { "textDocument": snippets } });
        let capabilities = client.ask("initialize", &able);
        assert_eq!(capabilities["capabilities"]["hoverProvider"], true);
        assert_eq!(capabilities["serverInfo"]["version"], env!("CARGO_PKG_VERSION"));
        client.tell("initialized", &json!({}));
        client
    }

    pub(crate) fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.input, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.input.flush().unwrap();
    }

    pub(crate) fn tell(&mut self, method: &str, params: &Value) {
        self.send(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    pub(crate) fn receive(&mut self) -> Value {
        self.output.recv_timeout(Duration::from_secs(120)).unwrap()
    }

    /// The answer to a request: its result, or its error.
    pub(crate) fn ask(&mut self, method: &str, params: &Value) -> Value {
        self.count += 1;
        let id = self.count;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.receive();
            if message["id"] == id {
                return if message["error"].is_null() {
                    message["result"].clone()
                } else {
                    message["error"].clone()
                };
            }
        }
    }

    /// Opens a text, and waits for its diagnostics.
    pub(crate) fn open(&mut self, uri: &str, text: &str) {
        let document = json!({ "uri": uri, "languageId": "plm", "version": 1, "text": text });
        self.tell("textDocument/didOpen", &json!({ "textDocument": document }));
        self.wait(uri);
    }

    pub(crate) fn wait(&mut self, uri: &str) {
        loop {
            let message = self.receive();
            if message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == uri {
                self.published.clone_from(message["params"]["diagnostics"].as_array().unwrap());
                return;
            }
        }
    }

    /// A request for a place of a text.
    pub(crate) fn at(&mut self, method: &str, uri: &str, text: &str, at: usize) -> Value {
        let position = position(text, at);
        self.ask(
            &format!("textDocument/{method}"),
            &json!({ "textDocument": { "uri": uri }, "position": position }),
        )
    }

    /// The text of a hover over the first letter of a part of the pendulum.
    pub(crate) fn hover(&mut self, words: &str, inside: &str) -> String {
        let at = PENDULUM.find(words).unwrap() + words.find(inside).unwrap();
        let hover = self.at("hover", URI, PENDULUM, at);
        hover["contents"]["value"].as_str().unwrap_or_default().to_owned()
    }

    /// Labels that complete the pendulum with words in the place of others.
    pub(crate) fn complete(&mut self, words: &str, typed: &str) -> Vec<String> {
        let at = PENDULUM.find(words).unwrap();
        let text = [&PENDULUM[..at], typed, &PENDULUM[at + words.len()..]].concat();
        let changed =
            json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": text }] });
        self.tell("textDocument/didChange", &changed);
        let found = self.at("completion", URI, &text, at + typed.len());
        let items = found.as_array().unwrap();
        assert!(items.is_sorted_by_key(|item| item["sortText"].as_str().unwrap().to_owned()));
        self.snippets =
            items.iter().filter_map(|item| item["insertText"].as_str().map(str::to_owned)).collect();
        items.iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
    }

    pub(crate) fn stop(mut self) {
        assert!(self.ask("shutdown", &Value::Null).is_null());
        self.tell("exit", &Value::Null);
        assert!(self.child.wait().unwrap().success());
    }
}

/// The place of a byte, by the standard library's UTF-16.
pub(crate) fn position(text: &str, at: usize) -> Value {
    let lines: Vec<&str> = text[..at].split('\n').collect();
    json!({ "line": lines.len() - 1, "character": lines.last().unwrap().encode_utf16().count() })
}

/// The text of a range.
pub(crate) fn part<'a>(text: &'a str, range: &Value) -> &'a str {
    let offset = |place: &Value| {
        let (line, column) =
            (place["line"].as_u64().unwrap() as usize, place["character"].as_u64().unwrap() as usize);
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        let units: Vec<u16> = text[start..].encode_utf16().take(column).collect();
        start + String::from_utf16(&units).unwrap().len()
    };
    &text[offset(&range["start"])..offset(&range["end"])]
}
