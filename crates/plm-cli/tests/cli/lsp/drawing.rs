//! Every gesture of `plm/draw`, asked as an editor asks: of a text that is open, without a picture of it.

use serde_json::{Value, json};

use super::super::drag::edited;
use super::{Client, URI};

/// A four-bar as a hand draws it, all but its last bar.
const TEXT: &str = "\
pub Drawing {
    gravity: 9.81 m/s^2;
    let steel = 7850 kg/m^3;
    let p1 = (0, 0) mm;
    let p2 = (40, 60) mm;
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p1; port b: p2; }
    let p3 = (240, 140) mm;
    body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p2; port b: p3; }
    param load: N = 5 N;
    ground { port g1: p1; }
    revolute pin1(ground.g1, bar1.a);
    revolute pin2(bar1.b, bar2.a);
}
";

/// A drawing that an editor has open.
struct Drawing {
    client: Client,
    text: String,
    version: u64,
}

impl Drawing {
    fn open(text: &str) -> Drawing {
        let mut client = Client::start();
        client.open(URI, text);
        Drawing { client, text: text.to_owned(), version: 1 }
    }

    fn ask(&mut self, gesture: &Value) -> Value {
        self.client.ask("plm/draw", &json!({ "textDocument": { "uri": URI }, "gesture": gesture }))
    }

    /// Makes a gesture, as the editor does: its edits are a new version of the text, which is `expected` in one of its lines.
    fn make(&mut self, gesture: &Value, expected: &str) {
        let answer = self.ask(gesture);
        assert!(answer["why"].is_null(), "{gesture}: {answer}");
        let made = edited(&self.text, &answer);
        assert!(made.contains(expected), "{gesture}\n{made}");
        self.version += 1;
        self.text = made;
        let version = json!({ "uri": URI, "version": self.version });
        let changed = json!({ "textDocument": version, "contentChanges": [{ "text": self.text }] });
        self.client.tell("textDocument/didChange", &changed);
        self.client.wait(URI);
        let errors = self.client.published.iter().filter(|of| of["severity"] == 1);
        assert_eq!(errors.collect::<Vec<_>>(), Vec::<&Value>::new(), "{gesture}\n{}", self.text);
    }
}

fn port(name: &str) -> Value {
    let (owner, port) = name.split_once('.').unwrap();
    json!({ "owner": owner, "port": port })
}

#[test]
fn an_editor_makes_every_gesture() {
    let mut of = Drawing::open(TEXT);
    let pin = of.ask(&json!({ "kind": "pin", "port": port("bar2.a") }));
    assert_eq!(pin, json!([port("bar1.b"), port("bar2.a")]));
    of.make(
        &json!({ "kind": "bar", "ends": [port("bar2.b"), { "at": [0.2, 0.0], "ground": true }] }),
        "revolute pin4(ground.g2, bar3.b);",
    );
    of.make(&json!({ "kind": "motor", "body": "bar1" }), "constraint motor1: bar1.angle = 60 rev/min*t;");
    of.make(
        &json!({ "kind": "drag", "port": port("bar2.b"), "to": [0.26, 0.16] }),
        "let p3 = (260, 160) mm;",
    );
    of.make(
        &json!({ "kind": "typed", "port": port("bar2.b"), "dimension": "x", "text": "250.0" }),
        "let p3 = (250.0, 160) mm;",
    );
    of.make(
        &json!({ "kind": "lock", "port": port("bar2.b"), "dimension": "y" }),
        "let p3 = (250.0 mm, p3_y);",
    );
    of.make(
        &json!({ "kind": "unlock", "port": port("bar2.b"), "dimension": "y" }),
        "let p3 = (250.0 mm, 160 mm);",
    );
    of.make(&json!({ "kind": "mirror", "port": port("bar3.a") }), "let p3 = (");
    of.make(&json!({ "kind": "mirror", "port": port("bar3.a") }), "let p3 = (250 mm, 159.99 mm);");
    of.make(
        &json!({ "kind": "port", "body": "bar2", "end": { "at": [0.1, 0.2] } }),
        "port b: p3; port c: p5; }",
    );
    of.make(&json!({ "kind": "ground", "at": [0.1, 0.3] }), "ground { port g3: p6; }");
    of.make(
        &json!({ "kind": "join", "tool": "spring", "ports": [port("ground.g3"), port("bar2.c")] }),
        "spring spring1(ground.g3, bar2.c)",
    );
    of.make(&json!({ "kind": "set", "name": "load", "value": 7.0 }), "param load: N = 7 N;");
    of.make(&json!({ "kind": "copy", "body": "bar3", "by": [0.3, 0.0] }), "body bar4 {");
    of.make(
        &json!({ "kind": "merge", "port": port("bar4.b"), "onto": port("bar2.c") }),
        "revolute pin5(bar2.c, bar4.b);",
    );
    of.make(&json!({ "kind": "unpin", "port": port("bar4.b") }), "port b: p5; }");
    of.make(&json!({ "kind": "ground", "port": port("bar4.a") }), "revolute pin5(ground.g4, bar4.a);");
    of.make(
        &json!({ "kind": "slide", "port": port("bar4.b"), "toward": [0.7, 0.0] }),
        "prismatic slide1(ground.g5, slider1.a);",
    );
    of.make(&json!({ "kind": "delete", "name": "slider1" }), "body bar4 {");
    of.make(
        &json!({ "kind": "groove", "port": port("bar2.c"), "body": "bar4" }),
        "pin_slot slide1(bar4.s, bar2.c);",
    );
    of.make(&json!({ "kind": "delete", "name": "bar4" }), "body bar3 {");
    of.make(
        &json!({ "kind": "rename", "name": "bar2", "to": "coupler" }),
        "revolute pin2(bar1.b, coupler.a);",
    );
    of.make(&json!({ "kind": "rename", "port": port("coupler.c"), "to": "tip" }), "port tip: p5;");
    of.make(&json!({ "kind": "delete", "port": port("coupler.tip") }), "ground { port g3: p6; }");
    let lift = of.ask(&json!({ "kind": "lift", "port": port("coupler.b"), "to": [0.25, 0.16] }));
    assert_eq!(lift["parameters"].as_array().map(Vec::len), Some(2), "{lift}");
    let sketch = of.ask(&json!({ "kind": "sketch" }));
    assert_eq!(sketch["parts"].as_array().map(Vec::len), Some(4), "{sketch}");
    // As it stands after a quarter of a second.
    let mut run = plm_dynamic::Mechanism::from_text(&of.text).unwrap().start().unwrap();
    run.step_to(0.25).unwrap();
    let poses = ["bar1", "coupler", "bar3"].map(|name| {
        let at = run.body(name).unwrap();
        json!({ "body": name, "at": [at.x, at.y], "angle": at.angle })
    });
    of.make(&json!({ "kind": "start", "poses": poses }), "bar1.angle = 90 deg + 60 rev/min*t;");
    assert_eq!(of.ask(&json!({ "kind": "fly" }))["why"], "the gesture has no kind that is known");
    of.client.stop();
}
