//! Bodies and the ground.

use super::ast::{Body, Contour, Expr, ExprKind, Ident, IndexedName, Port, Start};
use super::cursor::{Cursor, Parse, Reported};
use crate::diag::{Code, nearest};
use crate::span::Span;
use crate::token::{Delimiter, TokenKind};

/// Fields of a body that hold one expression. The second spelling is understood too.
const FIELDS: &[&str] = &["mass", "inertia", "centre", "center", "drawing_angle", "depth"];

/// All that may begin an item of a body.
const WORDS: &[&str] =
    &["mass", "inertia", "centre", "coordinates", "drawing_angle", "port", "start", "depth", "contour"];

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
                    if cursor.is_word("port") { cursor.port(true) } else { Err(cursor.expected("`port`")) };
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
        let mut body = Body {
            name,
            fields: Vec::new(),
            coordinates: None,
            contour: None,
            ports: Vec::new(),
            starts: Vec::new(),
        };
        let mut unread = None;
        self.group(Delimiter::Brace, "`{`", |cursor| {
            while cursor.peek().is_some() {
                let start = cursor.position();
                cursor.docs();
                if cursor.body_item(&mut body).is_err() {
                    cursor.recover(start);
                    unread = Some(cursor.span_from(start));
                }
            }
            if let Some(span) = unread {
                may_have_been(&mut body, span);
            }
            Ok(())
        })?;
        Ok(body)
    }

    fn body_item(&mut self, body: &mut Body) -> Parse<()> {
        let word = self.peek().map_or("", |token| token.text.as_str());
        match word {
            "port" => body.ports.push(self.port(false)?),
            "start" => body.starts.push(self.start()?),
            "coordinates" => {
                self.advance();
                self.punct(':', "`:`")?;
                body.coordinates = Some(self.ident("`relative` or `absolute`")?);
                self.semicolon()?;
            }
            "contour" => self.contour(body)?,
            word if FIELDS.contains(&word) => {
                let mut name = self.ident("a field")?;
                if name.text == "center" {
                    name.text = "centre".to_string();
                }
                let start = self.position();
                if let Err(reported) = self.colon_of(&name.text) {
                    let span = self.span_from(start);
                    body.fields.push((name, Expr { kind: ExprKind::Unknown, span }));
                    return Err(reported);
                }
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

    /// `contour: (x, y), (x, y), … unit;` or `contour: "file.csv";`
    fn contour(&mut self, body: &mut Body) -> Parse<()> {
        let word = self.here();
        self.advance();
        self.punct(':', "`:`")?;
        let found = if let Some(token) = self.peek().filter(|token| token.kind == TokenKind::Str) {
            let (name, span) = (file_name(&token.text).to_string(), self.here());
            self.advance();
            self.semicolon()?;
            Contour::File(name, span)
        } else {
            let mut points = vec![self.expr()?];
            while self.eat_punct(',') {
                points.push(self.expr()?);
            }
            self.semicolon()?;
            share_unit(&mut points);
            Contour::Points(points)
        };
        if body.contour.replace(found).is_some() {
            self.error(Code::RepeatedItem, word, "the contour is given twice");
        }
        Ok(())
    }

    /// `port name: expr, angle: expr;`; on the ground with a depth.
    fn port(&mut self, on_ground: bool) -> Parse<Port> {
        self.advance();
        let name = if on_ground {
            self.indexed_name("the name of the port")?
        } else {
            IndexedName { ident: self.ident("the name of the port")?, indices: Vec::new() }
        };
        self.colon_of(&format!("port {}", name.ident.text))?;
        let at = self.value_expr();
        let (mut angle, mut depth) = (None, None);
        while self.eat_punct(',') {
            let slot = if self.is_word("angle") || self.is_word("axis") {
                &mut angle
            } else if on_ground && self.is_word("depth") {
                &mut depth
            } else {
                return Err(self.expected(if on_ground { "`angle` or `depth`" } else { "`angle`" }));
            };
            if slot.is_some() {
                return Err(self.expected("`;`"));
            }
            self.advance();
            self.punct(':', "`:`")?;
            *slot = Some(self.value_expr());
        }
        self.end_of(depth.as_ref().or(angle.as_ref()).unwrap_or(&at))?;
        Ok(Port { name, at, angle, depth })
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

/// What could not be read may have been the mass or the inertia: that they are missing would be no second mistake.
fn may_have_been(body: &mut Body, span: Span) {
    for field in ["mass", "inertia"] {
        if !body.fields.iter().any(|(name, _)| name.text == field) {
            let name = Ident { text: field.to_string(), span };
            body.fields.push((name, Expr { kind: ExprKind::Unknown, span }));
        }
    }
}

/// The unit behind the last of several points is that of all.
fn share_unit(points: &mut [Expr]) {
    let Some((Expr { kind: ExprKind::Quantity(_, unit), .. }, others)) = points.split_last_mut() else {
        return;
    };
    for point in others.iter_mut().filter(|point| matches!(point.kind, ExprKind::Pair(..))) {
        let bare = Expr { kind: std::mem::replace(&mut point.kind, ExprKind::Unknown), span: point.span };
        point.kind = ExprKind::Quantity(Box::new(bare), unit.clone());
    }
}

/// What stands between the quotes of a literal.
pub(crate) fn file_name(literal: &str) -> &str {
    literal.trim_start_matches(['r', '#']).trim_end_matches('#').trim_matches('"')
}
