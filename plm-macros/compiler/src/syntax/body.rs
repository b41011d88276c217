//! Bodies and the ground.

use super::ast::{Body, Port, Start};
use super::cursor::{Cursor, Parse, Reported};
use crate::diag::{Code, nearest};
use crate::token::Delimiter;

/// Fields of a body that hold one expression. The second spelling is understood too.
const FIELDS: &[&str] = &["mass", "inertia", "centre", "center", "drawing_angle"];

/// All that may begin an item of a body.
const WORDS: &[&str] = &["mass", "inertia", "centre", "coordinates", "drawing_angle", "port", "start"];

impl Cursor<'_> {
    /// `ground { ports }`
    pub(super) fn ground(&mut self) -> Parse<Vec<Port>> {
        self.advance();
        self.group(Delimiter::Brace, "`{`", |cursor| {
            let mut ports = Vec::new();
            while cursor.peek().is_some() {
                let start = cursor.position();
                cursor.docs();
                let port =
                    if cursor.is_word("port") { cursor.port() } else { Err(cursor.expected("`port`")) };
                match port {
                    Ok(port) => ports.push(port),
                    Err(Reported) => cursor.recover(start),
                }
            }
            Ok(ports)
        })
    }

    /// `body name { … }`
    pub(super) fn body(&mut self) -> Parse<Body> {
        self.advance();
        let name = self.indexed_name("the name of the body")?;
        let mut body =
            Body { name, fields: Vec::new(), coordinates: None, ports: Vec::new(), starts: Vec::new() };
        self.group(Delimiter::Brace, "`{`", |cursor| {
            while cursor.peek().is_some() {
                let start = cursor.position();
                cursor.docs();
                if cursor.body_item(&mut body).is_err() {
                    cursor.recover(start);
                }
            }
            Ok(())
        })?;
        Ok(body)
    }

    fn body_item(&mut self, body: &mut Body) -> Parse<()> {
        let word = self.peek().map_or("", |token| token.text.as_str());
        match word {
            "port" => body.ports.push(self.port()?),
            "start" => body.starts.push(self.start()?),
            "coordinates" => {
                self.advance();
                self.punct(':', "`:`")?;
                body.coordinates = Some(self.ident("`relative` or `absolute`")?);
                self.semicolon()?;
            }
            word if FIELDS.contains(&word) => {
                let mut name = self.ident("a field")?;
                if name.text == "center" {
                    name.text = "centre".to_string();
                }
                self.punct(':', "`:`")?;
                let value = self.value_expr();
                let end = self.end_of(&value);
                body.fields.push((name, value));
                end?;
            }
            word => return Err(self.unknown_body_item(word)),
        }
        Ok(())
    }

    fn unknown_body_item(&mut self, word: &str) -> Reported {
        let near = nearest(word, WORDS.iter().copied());
        let diagnostic = self.error(Code::UnknownItem, self.here(), format!("a body has no `{word}`"));
        if let Some(near) = near {
            diagnostic.help(format!("an item with a similar name exists: `{near}`"));
        }
        diagnostic.note(format!("items of a body: {}", WORDS.join(", ")));
        Reported
    }

    /// `port name: expr, angle: expr;`
    fn port(&mut self) -> Parse<Port> {
        self.advance();
        let name = self.ident("the name of the port")?;
        self.punct(':', "`:`")?;
        let at = self.value_expr();
        let mut angle = None;
        if self.eat_punct(',') {
            if !self.eat_word("angle") && !self.eat_word("axis") {
                return Err(self.expected("`angle`"));
            }
            self.punct(':', "`:`")?;
            angle = Some(self.value_expr());
        }
        self.end_of(angle.as_ref().unwrap_or(&at))?;
        Ok(Port { name, at, angle })
    }

    /// `start coordinate: expr, locked;`
    fn start(&mut self) -> Parse<Start> {
        self.advance();
        let coordinate = self.ident("a coordinate")?;
        self.punct(':', "`:`")?;
        if self.is_word("locked") {
            self.error(Code::MissingValue, self.here(), "a locked start needs a value")
                .help(format!("write `start {}: 0, locked;`", coordinate.text));
            return Err(Reported);
        }
        let value = self.value_expr();
        let locked = self.locked()?.is_some();
        self.end_of(&value)?;
        Ok(Start { coordinate, value, locked })
    }
}
