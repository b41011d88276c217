//! Drawing: gestures on a picture and the edits that they are, as JSON. No message of the protocol asks for it; pages do.
//!
//! `plm/draw` takes `{ textDocument, gesture, places, text }`. A page that draws on a text of its own sends it as `text`. `places` has where
//! the ports stand; an editor without a picture leaves it out, and the text is compiled for it. A pose as `start` is tried on the text.

use std::ops::Range;

use plm_compiler::without_panic;
use plm_draw::{
    Drag, Drawn, Edit, GROUND, Handle, Held, Literal, Picture, Place, Placed, PortName, Refusal, Sheet,
    SketchPart, TOOLS, draw, follow, lift,
};
use serde_json::{Value, json};

use super::document::Document;
use super::gesture::{Unread, dragged, gesture, grid, placed, point, port};
use super::start::{self, PoseOf};
use super::text;
use crate::checked::checked;
use crate::excerpt::{excerpts, is_rust};

/// The answer to a gesture on the first declaration of a text; `{ why }` where it changes nothing.
pub(super) fn answered(document: &Document, params: &Value) -> Value {
    let masked = document.declarations.first().and_then(|of| of.excerpt.masked(&document.text));
    answer(&document.name, &document.text, masked.as_deref(), params)
}

/// Such an answer for a text that is not open.
///
/// A drag that goes on asks for the same pin of the same text again and again: it is kept, so that only its first move reads the text.
pub(super) fn answered_of_text(
    uri: &str,
    original: &str,
    params: &Value,
    kept: &mut Option<Dragging>,
) -> Value {
    let asked = &params["gesture"];
    let is_declaration = !is_rust(&text::path(uri));
    let is_plain = is_declaration && !original.contains('\r');
    if is_plain && asked["kind"] == "drag" && asked["live"] == true {
        return followed(original, params, kept).unwrap_or_else(|Unread(expected)| unread(expected));
    }
    let (name, text) = (text::path(uri), original.replace("\r\n", "\n"));
    let masked = excerpts(&name, &text).found.first().and_then(|excerpt| excerpt.masked(&text));
    answer(&name, &text, masked.as_deref(), params)
}

/// The pin of a drag that goes on, and the text that it is of.
pub(super) struct Dragging {
    text: String,
    held: Held,
}

/// The values of a drag that goes on.
fn followed(text: &str, params: &Value, kept: &mut Option<Dragging>) -> Result<Value, Unread> {
    let (drag, picture) = (dragged(&params["gesture"])?, picture_of(&params["places"]).unwrap_or_default());
    let is_kept = kept
        .as_ref()
        .is_some_and(|kept| kept.text == text && kept.held.is_of(&picture, &drag.port, drag.free));
    if !is_kept {
        match Held::take(&Sheet::read(text, None), &picture, &drag.port, drag.free) {
            Ok(held) => *kept = Some(Dragging { text: text.to_owned(), held }),
            Err(why) => return Ok(json!({ "why": why.to_string() })),
        }
    }
    let held = kept.as_ref().map(|kept| &kept.held);
    Ok(held.map_or(Value::Null, |held| shown(text, follow(held, drag.to, drag.grid))))
}

/// The places that a page tells.
fn picture_of(places: &Value) -> Option<Picture> {
    Some(Picture { ports: places.as_array()?.iter().filter_map(placed).collect() })
}

fn unread(expected: &str) -> Value {
    json!({ "why": format!("the gesture has no {expected}") })
}

fn answer(name: &str, text: &str, masked: Option<&str>, params: &Value) -> Value {
    let asked = &params["gesture"];
    let sheet = Sheet::read(text, masked);
    match asked["kind"].as_str().unwrap_or_default() {
        "handles" => return handles(&sheet),
        "sketch" => return sketch(&sheet),
        "tools" => {
            return TOOLS.iter().map(|tool| json!({ "tool": tool.word, "title": tool.title })).collect();
        }
        "start" => return begun(name, text, masked, asked),
        _ => {}
    }
    let picture = picture_of(&params["places"])
        .unwrap_or_else(|| without_panic(|| assembled(name, text, masked)).unwrap_or_default());
    let result = match asked["kind"].as_str().unwrap_or_default() {
        "pin" => port(&asked["port"]).map(|port| sheet.pin(&port).iter().map(named).collect()),
        // A drag that goes on is not laid out.
        "drag" if asked["live"] == true => {
            let taken = |drag: &Drag| Held::take(&sheet, &picture, &drag.port, drag.free);
            let followed = |drag: &Drag| taken(drag).and_then(|held| follow(&held, drag.to, drag.grid));
            dragged(asked).map(|drag| shown(text, followed(&drag)))
        }
        "lift" => dragged(asked).map(|drag| lifted(&sheet, &picture, &drag)),
        _ => gesture(asked).map(|gesture| shown(text, draw(&sheet, &picture, &gesture))),
    };
    result.unwrap_or_else(|Unread(expected)| unread(expected))
}

/// The edits after which a text begins in the pose of a picture.
fn begun(name: &str, text: &str, masked: Option<&str>, asked: &Value) -> Value {
    let pose = |of: &Value| {
        let at = point(&of["at"]).ok()?;
        let body = of["body"].as_str()?.to_owned();
        Some(PoseOf { body, pose: [at[0], at[1], of["angle"].as_f64()?] })
    };
    let poses: Option<Vec<PoseOf>> = asked["poses"].as_array().and_then(|all| all.iter().map(pose).collect());
    let Some(poses) = poses else { return unread("poses of bodies: body, at, angle") };
    match start::begun(&start::Source { name, text, masked }, &poses, grid(asked)) {
        Ok(drawn) => shown(text, Ok(drawn)),
        Err(why) => json!({ "why": why }),
    }
}

/// The ports of a text as it is assembled; none where it has errors.
fn assembled(name: &str, text: &str, masked: Option<&str>) -> Picture {
    let Some(oracle) = checked(name, text, masked).expansion.oracle else { return Picture::default() };
    let found = oracle.picture();
    let still = found.ground.iter().map(|port| ([0.0; 3], GROUND, port));
    let moving =
        found.bodies.iter().flat_map(|body| body.ports.iter().map(|port| (body.pose, &*body.name, port)));
    let place = |([x, y, angle], owner, port): ([f64; 3], &str, &plm_compiler::PicturePort)| {
        let ((sin, cos), [px, py, _]) = (angle.sin_cos(), port.place);
        let at = [x + cos * px - sin * py, y + sin * px + cos * py];
        Placed { name: PortName::new(owner, &port.name), at, angle }
    };
    Picture { ports: still.chain(moving).map(place).collect() }
}

fn handles(sheet: &Sheet<'_>) -> Value {
    let number = |of: &Literal| json!({ "range": text::range(sheet.text, &of.range), "value": of.value, "factor": of.factor(), "unit": of.unit.text, "locked": of.is_locked });
    let shown = |handle: &Handle<'_>| {
        let mut shown = named(&handle.name);
        shown["turns"] = json!(handle.turns);
        shown["driven"] = json!(handle.is_driven);
        match &handle.place {
            Place::Numbers { numbers, through, .. } => {
                shown["numbers"] = numbers.iter().map(number).collect();
                shown["through"] = json!(through);
            }
            Place::Polar { polar, through, .. } => {
                shown["length"] = number(&polar.length);
                shown["direction"] = number(&polar.angle);
                shown["through"] = json!(through);
            }
            Place::Expression(text) => shown["expression"] = json!(text),
        }
        shown
    };
    sheet.handles().iter().map(shown).collect()
}

/// The text as it is drawn before it is a mechanism.
fn sketch(sheet: &Sheet<'_>) -> Value {
    let sketch = sheet.sketch();
    let locks = sheet.locks();
    let port = |placed: &Placed| {
        let mut shown = named(&placed.name);
        shown["at"] = json!(placed.at);
        shown["angle"] = json!(placed.angle);
        shown["guessed"] = json!(sketch.guessed.contains(&placed.name));
        if let Some((_, locks)) = locks.iter().find(|(name, _)| *name == placed.name) {
            shown["locks"] = locks.iter().map(|of| of.word()).collect();
        }
        shown
    };
    let part = |part: &SketchPart| json!({ "name": part.name, "kind": part.kind, "pin": part.is_pin, "ports": part.ports.iter().map(named).collect::<Value>() });
    json!({
        "places": sketch.picture.ports.iter().map(port).collect::<Value>(),
        "parts": sketch.parts.iter().map(part).collect::<Value>(),
    })
}

fn lifted(sheet: &Sheet<'_>, picture: &Picture, drag: &Drag) -> Value {
    match lift(sheet, picture, drag) {
        Ok(lifted) => json!({ "text": lifted.text, "parameters": lifted.parameters }),
        Err(why) => json!({ "why": why.to_string() }),
    }
}

fn shown(text: &str, drawn: Result<Drawn, Refusal>) -> Value {
    let place = |range: &Range<usize>| text::range(text, range);
    let edit = |of: &Edit| json!({ "range": place(&of.range), "newText": of.text });
    match drawn {
        Ok(drawn) => json!({
            "edits": drawn.edits.iter().map(edit).collect::<Value>(),
            "values": drawn.values,
            "to": drawn.to,
            "also": drawn.also.iter().map(named).collect::<Value>(),
            "open": drawn.open,
            "told": drawn.told,
            "made": drawn.made,
        }),
        Err(why) => json!({ "why": why.to_string() }),
    }
}

fn named(port: &PortName) -> Value {
    json!({ "owner": port.owner, "port": port.port })
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use crate::Server;
    use crate::server::text;

    const TEXT: &str = "\
pub P {
    ground { port o: (0, 0) m; port d: (30, 0) cm; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 10 cm); port a: (-5, 0) cm; port b: (5, 0) cm; start angle: 90 deg; }
    revolute o(ground.o, crank.a);
}
";

    /// The answer to a request.
    fn asked(server: &mut Server, method: &str, params: &Value) -> Value {
        let answers = server.message(&json!({ "id": 1, "method": method, "params": params }).to_string());
        let [answer] = &answers[..] else { unreachable!("{answers:?}") };
        serde_json::from_str::<Value>(answer).map(|mut answer| answer["result"].take()).unwrap_or_default()
    }

    /// A text after the edits of an answer.
    fn edited(of: &str, answer: &Value) -> String {
        let edits = answer["edits"].as_array().cloned().unwrap_or_default();
        let mut made = of.to_owned();
        for edit in edits.iter().rev() {
            let [start, end] = ["start", "end"].map(|end| text::offset(of, &edit["range"][end]).unwrap_or(0));
            made.replace_range(start..end, edit["newText"].as_str().unwrap_or_default());
        }
        made
    }

    #[test]
    fn a_page_draws_on_a_text_of_its_own() {
        let mut server = Server::default();
        let document = json!({ "uri": "plm:p.plm" });
        let mut draw = |text: &str, gesture: Value, places: Value| {
            let params =
                json!({ "textDocument": document, "text": text, "gesture": gesture, "places": places });
            asked(&mut server, "plm/draw", &params)
        };
        let handles = draw(TEXT, json!({ "kind": "handles" }), Value::Null);
        assert_eq!(handles[3]["owner"], "crank");
        assert_eq!(handles[3]["numbers"][0]["value"], 5.0);
        let places = json!([
            { "owner": "crank", "port": "a", "at": [0.0, 0.0], "angle": std::f64::consts::FRAC_PI_2 },
            { "owner": "crank", "port": "b", "at": [0.0, 0.1], "angle": std::f64::consts::FRAC_PI_2 },
        ]);
        let port = json!({ "owner": "crank", "port": "b" });
        let drag = json!({ "kind": "drag", "port": port, "to": [0.12, 0.16], "grid": 1e-3 });
        let drawn = draw(TEXT, drag, places.clone());
        let made = edited(TEXT, &drawn);
        let crank =
            "inertia: rod(1 kg, 20 cm); port a: (-10, 0) cm; port b: (10, 0) cm; start angle: 53.13 deg;";
        assert!(made.contains(crank), "{drawn}\n{made}");
        assert_eq!(drawn["to"], json!([0.12, 0.16]));
        // While it goes on, its values are the same.
        let live = json!({ "kind": "drag", "live": true, "port": port, "to": [0.12, 0.16], "grid": 1e-3 });
        assert_eq!(draw(TEXT, live, places.clone())["values"], drawn["values"]);
        let sketch = draw(TEXT, json!({ "kind": "sketch" }), Value::Null);
        assert_eq!(
            sketch["places"][2],
            json!({ "owner": "crank", "port": "a", "at": [0.0, 0.0], "angle": std::f64::consts::FRAC_PI_2, "guessed": true })
        );
        assert_eq!(sketch["parts"][0]["pin"], true);
        let slide = json!({ "kind": "slide", "port": port, "toward": [0.0, 0.2], "grid": 1e-3 });
        let made = edited(TEXT, &draw(TEXT, slide, places.clone()));
        assert!(made.contains("ground { port g1: p1, axis: 90 deg; }"), "{made}");
        let opened = json!({ "kind": "unpin", "port": { "owner": "crank", "port": "a" } });
        assert!(!edited(TEXT, &draw(TEXT, opened, places.clone())).contains("revolute"));
        let lift = json!({ "kind": "lift", "port": port, "to": [0.0, 0.1], "grid": 1e-3 });
        let lifted = draw(TEXT, lift, places);
        assert_eq!(lifted["parameters"].as_array().map(Vec::len), drawn["values"].as_array().map(Vec::len));
        // From nothing.
        let ends = json!([{ "at": [0.0, 0.0], "ground": true }, { "at": [0.3, -0.4] }]);
        let made = edited("", &draw("", json!({ "kind": "bar", "ends": ends, "grid": 1e-3 }), json!([])));
        assert!(made.starts_with("pub Drawing {\n    gravity: 9.81 m/s^2;\n"), "{made}");
        let refused = draw("", json!({ "kind": "motor", "body": "bar1" }), json!([]));
        assert_eq!(refused["why"], "the text has no `bar1`");
        let refused = draw(TEXT, json!({ "kind": "drag", "to": [0, 0] }), json!([]));
        assert_eq!(refused["why"], "the gesture has no port with its owner");
        let refused = draw(TEXT, json!({ "kind": "fly" }), json!([]));
        assert_eq!(refused["why"], "the gesture has no kind that is known");
    }

    /// An editor has no picture: the text is compiled for it.
    #[test]
    fn an_editor_draws_in_a_file_of_rust() {
        let mut server = Server::default();
        let text = format!("// Größe\nplm::mechanism! {{\n{TEXT}}}\nfn main() {{}}\n");
        let document = json!({ "uri": "file:///p.rs", "languageId": "rust", "version": 1, "text": text });
        let open = json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } });
        server.message(&open.to_string());
        let port = json!({ "owner": "crank", "port": "b" });
        let mut draw = |gesture: Value| {
            asked(
                &mut server,
                "plm/draw",
                &json!({ "textDocument": { "uri": "file:///p.rs" }, "gesture": gesture }),
            )
        };
        let drawn = draw(json!({ "kind": "drag", "port": port, "to": [0.12, 0.16], "grid": 1e-3 }));
        let made = edited(&text, &drawn);
        assert!(
            made.contains("port b: (10, 0) cm; start angle: 53.13 deg;") && made.starts_with("// Größe\n"),
            "{made}"
        );
        let drawn = draw(json!({ "kind": "motor", "body": "crank" }));
        let made = edited(&text, &drawn);
        let row = "    revolute o(ground.o, crank.a);\n    constraint motor1: crank.angle = 90 deg + 60 rev/min*t;\n}\n}\n";
        assert!(made.contains(row), "{made}");
        let pin = draw(json!({ "kind": "pin", "port": { "owner": "crank", "port": "a" } }));
        assert_eq!(pin, json!([{ "owner": "ground", "port": "o" }, { "owner": "crank", "port": "a" }]));
    }
}
