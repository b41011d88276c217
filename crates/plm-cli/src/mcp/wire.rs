//! Messages of JSON-RPC 2.0 on a stream, one a line.

use std::io::{self, BufRead, Read, Write};

use serde_json::{Value, json};

/// The longest line, bytes: a declaration has 4 MiB at most, which escapes can double.
const LONGEST: u64 = 16 << 20;

/// Codes of errors of the protocol.
#[derive(Clone, Copy)]
pub(super) enum Code {
    Parse = -32700,
    Request = -32600,
    Method = -32601,
    Params = -32602,
    Resource = -32002,
    Revision = -32022,
}

/// An error of the protocol.
pub(super) struct Wrong {
    code: Code,
    message: String,
    data: Option<Value>,
}

impl Wrong {
    pub(super) fn new(code: Code, message: String) -> Wrong {
        Wrong { code, message, data: None }
    }

    pub(super) fn with(self, data: Value) -> Wrong {
        Wrong { data: Some(data), ..self }
    }
}

/// A request, which has a number to answer to.
pub(super) struct Request {
    pub(super) id: Value,
    pub(super) method: String,
    pub(super) params: Value,
}

/// A message that has come; notifications that nothing follows from are left out.
pub(super) enum Incoming {
    Request(Request),
    /// The request of this number is wanted no more.
    Cancelled(Value),
    /// A line that is no message.
    Unread(Wrong),
}

/// Gives each message of a stream to a function, until the stream ends or the function takes no more.
pub(super) fn read(input: &mut impl BufRead, mut takes: impl FnMut(Incoming) -> bool) {
    loop {
        let mut line = Vec::new();
        match input.by_ref().take(LONGEST).read_until(b'\n', &mut line) {
            Err(_) | Ok(0) => return,
            Ok(_) => {}
        }
        let is_whole = line.ends_with(b"\n") || (line.len() as u64) < LONGEST;
        let message = if is_whole { message(&line) } else { Some(too_long(input)) };
        if message.is_some_and(|message| !takes(message)) {
            return;
        }
    }
}

/// Passes over the rest of a line.
fn too_long(input: &mut impl BufRead) -> Incoming {
    loop {
        let mut rest = Vec::new();
        match input.by_ref().take(LONGEST).read_until(b'\n', &mut rest) {
            Ok(count) if count > 0 && !rest.ends_with(b"\n") => {}
            _ => break,
        }
    }
    let message = format!("the message has more than {} MiB, the limit of a line", LONGEST >> 20);
    Incoming::Unread(Wrong::new(Code::Request, message))
}

/// The message of a line; nothing of an empty one, of an answer, and of a notification without consequence.
fn message(line: &[u8]) -> Option<Incoming> {
    if line.iter().all(u8::is_ascii_whitespace) {
        return None;
    }
    let unread = |code, message| Some(Incoming::Unread(Wrong::new(code, message)));
    let mut value: Value = match serde_json::from_slice(line) {
        Ok(value) => value,
        Err(why) => return unread(Code::Parse, format!("no JSON: {why}")),
    };
    if !value.is_object() {
        return unread(Code::Request, "a message is one object of JSON: there are no batches".to_owned());
    }
    let Some(method) = value["method"].as_str().map(str::to_owned) else {
        // Answers come to nobody: the server asks nothing.
        let is_answer = value.get("result").is_some() || value.get("error").is_some();
        return if is_answer {
            None
        } else {
            unread(Code::Request, "the message has no `method`".to_owned())
        };
    };
    let (id, params) = (value["id"].take(), value["params"].take());
    match id {
        Value::Null if method == "notifications/cancelled" => {
            Some(Incoming::Cancelled(params["requestId"].clone()))
        }
        Value::Null => None,
        Value::String(_) | Value::Number(_) => Some(Incoming::Request(Request { id, method, params })),
        _ => unread(Code::Request, "the `id` of a request is a number or a string".to_owned()),
    }
}

/// The message with the result of a request.
pub(super) fn result(id: &Value, result: &Value) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "result": result })
}

/// The message with the error of a request.
pub(super) fn error(id: &Value, wrong: &Wrong) -> Value {
    let mut error = json!({ "code": wrong.code as i32, "message": wrong.message });
    if let Some(data) = &wrong.data {
        error["data"] = data.clone();
    }
    json!({ "jsonrpc": "2.0", "id": id, "error": error })
}

/// Writes a message as a line.
pub(super) fn write(output: &mut dyn Write, message: &Value) -> io::Result<()> {
    writeln!(output, "{message}")?;
    output.flush()
}
