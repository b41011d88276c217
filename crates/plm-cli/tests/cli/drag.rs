//! A drag of a page: a move costs a small part of a compilation, and gives the values of the drag by itself.

mod begun;

use std::fs;
use std::time::{Duration, Instant};

use plm_cli::Server;
use plm_compiler::token::Sources;
use plm_compiler::{Oracle, compile};
use serde_json::{Value, json};

use super::root;

/// The text of the first declaration of a file, which may be Rust.
pub(crate) fn declaration(path: &str) -> String {
    let text = fs::read_to_string(root().join(path)).unwrap();
    let Some(begin) = text.find("mechanism! {") else { return text };
    let (mut depth, begin) = (1, begin + "mechanism! {".len());
    for (at, letter) in text[begin..].char_indices() {
        depth += i32::from(letter == '{') - i32::from(letter == '}');
        if depth == 0 {
            return text[begin..begin + at].to_owned();
        }
    }
    String::new()
}

/// The ports of a text at its start, as a page tells them.
fn places(text: &str) -> Value {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    let picture = compile(&mut sources).oracle.as_ref().map(Oracle::picture).unwrap();
    let ground = picture.ground.iter().map(|port| {
        json!({ "owner": "ground", "port": port.name, "at": [port.place[0], port.place[1]], "angle": 0.0 })
    });
    let of_bodies = picture.bodies.iter().flat_map(|body| {
        let [x, y, angle] = body.pose;
        let (sin, cos) = angle.sin_cos();
        body.ports.iter().map(move |port| {
            let [px, py, _] = port.place;
            let at = [x + cos * px - sin * py, y + sin * px + cos * py];
            json!({ "owner": body.name, "port": port.name, "at": at, "angle": angle })
        })
    });
    ground.chain(of_bodies).collect()
}

pub(crate) fn asked(server: &mut Server, text: &str, places: &Value, gesture: &Value) -> Value {
    let params =
        json!({ "textDocument": { "uri": "plm:p.plm" }, "text": text, "gesture": gesture, "places": places });
    let request = json!({ "jsonrpc": "2.0", "id": 1, "method": "plm/draw", "params": params }).to_string();
    let answers = server.message(&request);
    serde_json::from_str::<Value>(&answers[0]).unwrap()["result"].take()
}

/// A text after the edits of an answer.
pub(crate) fn edited(text: &str, answer: &Value) -> String {
    let offset = |place: &Value| {
        let [line, character] = ["line", "character"].map(|of| place[of].as_u64().unwrap() as usize);
        let start: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        // The texts of these tests have letters of one unit alone.
        start + character
    };
    let mut made = text.to_owned();
    for edit in answer["edits"].as_array().unwrap().iter().rev() {
        let [start, end] = ["start", "end"].map(|end| offset(&edit["range"][end]));
        made.replace_range(start..end, edit["newText"].as_str().unwrap());
    }
    made
}

/// The least of some times of a compilation.
fn of_compilation(text: &str) -> Duration {
    let times = (0..3).map(|_| {
        let begin = Instant::now();
        let mut sources = Sources::new();
        sources.add_text("declaration", text);
        assert!(compile(&mut sources).oracle.is_some());
        begin.elapsed()
    });
    times.min().unwrap()
}

#[test]
fn a_move_costs_less_than_a_twentieth_of_a_compilation() {
    for path in [
        "examples/gallery/machines/pumpjack.rs",
        "examples/gallery/machines/klann.rs",
        "examples/gallery/machines/walschaerts.rs",
        "examples/figures/parts/geneva.plm",
    ] {
        let text = declaration(path);
        let (mut server, places) = (Server::default(), places(&text));
        let all = places.as_array().unwrap();
        let drag = |place: &Value, by: f64, live: bool| {
            let to = [place["at"][0].as_f64().unwrap() + by, place["at"][1].as_f64().unwrap() - 0.5 * by];
            json!({ "kind": "drag", "live": live, "port": place, "to": to, "grid": 1e-3 })
        };
        // The first port that a hand can drag.
        let found = all
            .iter()
            .find(|place| asked(&mut server, &text, &places, &drag(place, 0.01, true))["why"].is_null());
        let place = found.unwrap_or_else(|| panic!("{path}: no port can be dragged"));
        let mut times = Vec::new();
        for k in 1..=41 {
            let gesture = drag(place, 1e-3 * f64::from(k), true);
            let begin = Instant::now();
            let answer = asked(&mut server, &text, &places, &gesture);
            times.push(begin.elapsed());
            if k % 20 == 1 {
                let alone = asked(&mut server, &text, &places, &drag(place, 1e-3 * f64::from(k), false));
                assert_eq!(answer["values"], alone["values"], "{path} {place}");
                assert_eq!(answer["to"], alone["to"]);
            }
        }
        times.sort();
        let (of_move, whole) = (times[times.len() / 2], of_compilation(&text));
        println!("{path}: {of_move:?} for a move, {whole:?} for a compilation");
        assert!(20 * of_move < whole, "{path}: {of_move:?} for a move, {whole:?} for a compilation");
    }
}

/// Another text, another picture, another pin: nothing of the one before is left.
#[test]
fn what_is_kept_of_a_drag_is_of_it_alone() {
    let text = "\
pub P {
    ground { port o: (0, 0) mm; port d: (300, 0) mm; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 100 mm); port a: (-50, 0) mm; port b: (50, 0) mm; start angle: 90 deg; }
    revolute o(ground.o, crank.a);
}
";
    let other = text.replace("(300, 0) mm", "(30, 0) cm");
    let mut server = Server::default();
    let mut values = |text: &str, places: &Value, owner: &str, port: &str, free: bool| {
        let gesture = json!({ "kind": "drag", "live": true, "port": { "owner": owner, "port": port }, "to": [0.06, 0.08], "grid": 1e-3, "free": free });
        asked(&mut server, text, places, &gesture)["values"].clone()
    };
    let (here, mut moved) = (places(text), places(text));
    moved[3]["angle"] = json!(0.0);
    assert_eq!(values(text, &here, "ground", "d", false), json!([0.06, 0.08]));
    assert_eq!(values(&other, &here, "ground", "d", false), json!([0.06, 0.08]));
    let bar = values(text, &here, "crank", "b", false);
    let free = values(text, &here, "crank", "b", true);
    let turned = values(text, &moved, "crank", "b", true);
    assert!(bar != free && free != turned, "{bar} {free} {turned}");
    assert_eq!(values(text, &here, "crank", "b", false), bar);
}
