//! `plm lsp`, driven over its protocol.

mod client;
mod drawing;

use std::io::Write;

use serde_json::{Value, json};

use client::{Client, part, position};

const PENDULUM: &str = "\
/// A bar on a pin.
pub Pendulum {
    gravity: 9.81 m/s^2;
    /// Length of the bar.
    param length: cm = 80 cm;
    let half = length/2;
    ground { port o: (0, 0) m; }
    body bar {
        mass: 2 kg; inertia: rod(2 kg, length);
        port top: (0, half); port tip: (0, -half);
        start angle: 30 deg, locked;
    }
    /// A magnet of its own.
    part magnet(a: frame) { param pull: N = 1 N; force on a: (pull, 0 N); output pulls = pull; }
    revolute hinge(ground.o, bar.top) { damping: 0.1 N*m*s/rad; }
    magnet low(bar.tip) { pull: 2 N; }
    output bar.angle in deg, hinge.torque, low.pulls;
}
";
const URI: &str = "file:///nowhere/pendulum.plm";

#[test]
fn diagnostics_come_as_one_types_and_quick_fixes_answer_them() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    assert_eq!(client.published, Vec::<Value>::new());
    let wrong = PENDULUM.replace("mass: 2 kg", "/* \u{1d11e} */ mass: 2").replace("bar.tip)", "bar.tpi)");
    let changed =
        json!({ "textDocument": { "uri": URI, "version": 2 }, "contentChanges": [{ "text": wrong }] });
    client.tell("textDocument/didChange", &changed);
    client.wait(URI);
    let found: Vec<(&str, &str, u64)> = client
        .published
        .iter()
        .map(|of| {
            (of["code"].as_str().unwrap(), part(&wrong, &of["range"]), of["severity"].as_u64().unwrap())
        })
        .collect();
    assert_eq!(found, [("E0302", "2", 1), ("E0204", "tpi", 1)]);
    let message = client.published[0]["message"].as_str().unwrap();
    assert_eq!(message, "expected a mass (kg), found 2 without a unit\n= help: write its unit: `2 kg`");
    let mut repaired = wrong.clone();
    for problem in client.published.clone() {
        let params = json!({ "textDocument": { "uri": URI }, "range": problem["range"], "context": { "diagnostics": [] } });
        let fixes = client.ask("textDocument/codeAction", &params);
        let edit = &fixes[0]["edit"]["changes"][URI][0];
        let old = part(&wrong, &edit["range"]);
        repaired =
            repaired.replacen(&format!(": {old};"), &format!(": {};", edit["newText"].as_str().unwrap()), 1);
        repaired =
            repaired.replacen(&format!(".{old})"), &format!(".{})", edit["newText"].as_str().unwrap()), 1);
    }
    assert_eq!(repaired.replace("/* \u{1d11e} */ ", ""), PENDULUM);
    client.tell("textDocument/didClose", &json!({ "textDocument": { "uri": URI } }));
    client.wait(URI);
    assert_eq!(client.published, Vec::<Value>::new());
    client.stop();
}

#[test]
fn a_hover_tells_value_unit_and_documentation() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    let shown = client.hover("length/2", "length");
    assert_eq!(
        shown,
        "```plm\nparam length: cm = 80 cm;\n```\n\nLength of the bar.\n\nAt the start: `80 cm`"
    );
    assert!(client.hover("half);", "half").contains("At the start: `0.4 m`"));
    // The tip of a bar that was turned by 30 degrees about a pin at the origin: 0.8 m (sin 30 deg, -cos 30 deg).
    assert!(client.hover("bar.tip) {", "tip").contains("At the start: `(0.4, -0.69282) m`"));
    let shown = client.hover("bar.angle in", "angle");
    assert!(
        shown.contains("from the absolute one, rad") && shown.contains("At the start: `30 deg`"),
        "{shown}"
    );
    let shown = client.hover("damping: 0.1", "damping");
    assert!(shown.contains("param damping: N*m/(rad/s) = 0;") && shown.contains("Rotary damper."), "{shown}");
    let shown = client.hover("hinge.torque", "torque");
    assert!(shown.contains("positive to the left") && shown.contains("At the start: `0 N*m`"), "{shown}");
    assert!(client.hover("low.pulls", "pulls").contains("At the start: `2 N`"));
    assert!(
        client.hover("magnet low", "magnet").contains("part magnet(a: frame)\n```\n\nA magnet of its own.")
    );
    assert!(client.hover("revolute hinge", "revolute").contains("joint revolute(a: frame, b: frame)"));
    assert!(client.hover("cm = 80", "cm").contains("the centimetre, a unit: 1 cm = 0.01 m"));
    // A part has its values for each use.
    let shown = client.hover("pull: N = 1 N", "pull");
    assert!(shown.contains("param pull: N = 1 N;") && !shown.contains("At the start"), "{shown}");
    assert!(client.hover("rod(2", "rod").contains("a function: `rod(…)`"));
    assert_eq!(client.hover("/// Length of", "Length"), "");
    client.stop();
}

#[test]
fn definitions_are_found() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    for (words, inside, declared) in [
        ("length/2", "length", "length: cm"),
        ("bar.tip)", "tip", "tip: (0"),
        ("bar.tip)", "bar", "bar {"),
        ("magnet low", "magnet", "magnet(a"),
        ("(pull, 0 N)", "pull", "pull: N ="),
        ("low.pulls", "low", "low(bar"),
        ("ground.o", "o", "o: (0, 0)"),
    ] {
        let at = PENDULUM.find(words).unwrap() + words.rfind(inside).unwrap();
        let found = client.at("definition", URI, PENDULUM, at);
        let start = PENDULUM.find(declared).unwrap();
        assert_eq!(found["range"]["start"], position(PENDULUM, start), "{words} {inside}: {found}");
    }
    let at = PENDULUM.find("revolute").unwrap();
    assert!(client.at("definition", URI, PENDULUM, at).is_null());
    client.stop();
}

#[test]
fn completion_knows_what_may_stand_there() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    let mut has = |words: &str, typed: &str, expected: &[&str], not: &[&str]| {
        let found = client.complete(words, typed);
        let is_there = |word: &&str| found.iter().any(|label| label == word);
        assert!(expected.iter().all(is_there) && !not.iter().any(is_there), "{typed}: {found:?}");
    };
    has("gravity: 9.81 m/s^2;", "gra", &["gravity", "body", "revolute", "magnet"], &["mass", "sin"]);
    has("mass: 2 kg; ", "ma", &["mass", "inertia", "contour"], &["body"]);
    has("bar.tip)", "bar.", &["top", "tip", "angle", "omega"], &["o", "body"]);
    has("ground.o", "ground.", &["o"], &["angle", "tip"]);
    has("bar.angle in deg", "bar.tip.", &["velocity", "position"], &["vx", "tip"]);
    has("hinge.torque", "hinge.", &["torque", "angle", "speed"], &["tip"]);
    has("low.pulls", "low.", &["pulls"], &["torque"]);
    has(
        "damping: 0.1 N*m*s/rad;",
        "st",
        &["stiffness", "damping", "lower_limit", "drive"],
        &["torque", "body"],
    );
    has("2 kg; inertia", "2 ", &["kg", "gram", "m"], &["hinge"]);
    has("2 kg; inertia", "2 kg*", &["m", "s"], &["hinge"]);
    has("(0, half);", "(0, half) ", &["m", "half"], &["mass"]);
    has("start angle", "start an", &["angle", "omega"], &["kg"]);
    has("gravity: 9.81 m/s^2;", "formulation: ", &["tree", "absolute"], &["sin"]);
    has("length: cm", "length: ", &["cm", "N"], &["sin"]);
    has("angle in deg", "angle in ", &["deg", "rad"], &["sin"]);
    has("length/2", "le", &["length", "half", "bar", "sin", "pi", "ground"], &["pull", "kg"]);
    has("(pull, 0 N)", "(", &["pull", "a"], &["kg"]);
    has("/// Length of the bar.", "/// Le", &[], &["length"]);
    client.complete("gravity: 9.81 m/s^2;", "re");
    for snippet in ["revolute ${1:name}(${2:a}, ${3:b});$0", "magnet ${1:name}(${2:a});$0"] {
        assert!(client.snippets.iter().any(|found| found == snippet), "{:?}", client.snippets);
    }
    assert!(client.snippets.iter().any(|found| found.starts_with("body ${1:name} {\n    mass:")));
    client.stop();
}

#[test]
fn a_mechanism_in_rust_is_served_at_its_places() {
    let mut client = Client::start();
    let uri = "file:///nowhere/main.rs";
    let text =
        format!("fn \u{e9}() {{}}\nplm::mechanism! {{\n{PENDULUM}}}\nfn main() {{ let length = 1; }}\n");
    client.open(uri, &text);
    assert_eq!(client.published, Vec::<Value>::new());
    let at = text.find("length/2").unwrap();
    let hover = client.at("hover", uri, &text, at);
    assert!(hover["contents"]["value"].as_str().unwrap().contains("At the start: `80 cm`"), "{hover}");
    let found = client.at("definition", uri, &text, at);
    assert_eq!(part(&text, &found["range"]), "length");
    // Rust's own names are not those of the mechanism.
    assert!(client.at("hover", uri, &text, text.rfind("length").unwrap()).is_null());
    let options =
        json!({ "textDocument": { "uri": uri }, "options": { "tabSize": 4, "insertSpaces": true } });
    let edits = client.ask("textDocument/formatting", &options);
    let made = edits[0]["newText"].as_str().unwrap();
    assert!(
        made.contains("mechanism! {\n    /// A bar on a pin.\n    pub Pendulum {\n        gravity"),
        "{made}"
    );
    client.stop();
}

#[test]
fn what_is_half_typed_or_no_text_is_answered() {
    let mut client = Client::start();
    for cut in (0..PENDULUM.len()).step_by(37) {
        client.open(URI, &PENDULUM[..cut]);
        for method in ["hover", "definition", "completion"] {
            let answer = client.at(method, URI, &PENDULUM[..cut], cut);
            assert!(answer["code"].is_null(), "{cut}: {answer}");
        }
    }
    let unknown = client.at("hover", "file:///other.plm", "", 0);
    assert_eq!(unknown["code"], -32602);
    let unknown = client.ask("textDocument/moniker", &json!({ "textDocument": { "uri": URI } }));
    assert_eq!(unknown["code"], -32601);
    client.stop();
}

#[test]
fn a_text_that_is_no_message_has_the_protocols_error() {
    let mut client = Client::start();
    for (text, code) in [("{ no json", -32700), ("[1, 2]", -32600)] {
        write!(client.input, "Content-Length: {}\r\n\r\n{text}", text.len()).unwrap();
        client.input.flush().unwrap();
        let error = client.receive();
        assert_eq!((&error["error"]["code"], &error["id"]), (&json!(code), &Value::Null), "{error}");
    }
    client.open(URI, PENDULUM);
    client.stop();
}

#[test]
fn a_name_is_found_and_changed_wherever_it_stands() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    let at = |words: &str| PENDULUM.find(words).unwrap();
    for (words, others) in [("length:", 3), ("bar {", 4), ("tip: (0", 2), ("hinge(", 2), ("magnet(a", 2)] {
        let params = json!({
            "textDocument": { "uri": URI }, "position": position(PENDULUM, at(words)),
            "context": { "includeDeclaration": true },
        });
        let found = client.ask("textDocument/references", &params);
        let name = words.split(|c: char| !c.is_alphanumeric()).next().unwrap();
        let places = found.as_array().unwrap_or_else(|| panic!("{words}: {found}"));
        assert_eq!(places.len(), others, "{words}: {found}");
        assert!(places.iter().all(|place| part(PENDULUM, &place["range"]) == name), "{words}: {found}");
    }
    let renamed = |client: &mut Client, name: &str| {
        let place = position(PENDULUM, at("half)"));
        let params = json!({ "textDocument": { "uri": URI }, "position": place, "newName": name });
        client.ask("textDocument/rename", &params)
    };
    let edits = renamed(&mut client, "middle");
    assert_eq!(edits["changes"][URI].as_array().map(Vec::len), Some(3), "{edits}");
    for taken in ["t", "m", "two words", "3d", ""] {
        assert_eq!(renamed(&mut client, taken)["code"], -32602, "{taken}");
    }
    client.stop();
}

#[test]
fn outline_ports_and_values_are_shown() {
    let mut client = Client::start();
    client.open(URI, PENDULUM);
    let outline = client.ask("textDocument/documentSymbol", &json!({ "textDocument": { "uri": URI } }));
    let names = |of: &Value| -> Vec<String> {
        of.as_array().unwrap().iter().map(|symbol| symbol["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names(&outline), ["Pendulum"]);
    let inside = &outline[0]["children"];
    assert_eq!(names(inside), ["length", "half", "bar", "magnet", "hinge", "low"], "{outline}");
    assert_eq!(names(&inside[2]["children"]), ["top", "tip"]);

    let at = PENDULUM.find("bar.top)").unwrap();
    let help = client.at("signatureHelp", URI, PENDULUM, at);
    assert_eq!(help["signatures"][0]["label"], "joint revolute(a: frame, b: frame)", "{help}");
    assert_eq!(help["activeParameter"], 1);

    let whole = json!({ "start": position(PENDULUM, 0), "end": position(PENDULUM, PENDULUM.len()) });
    let hints =
        client.ask("textDocument/inlayHint", &json!({ "textDocument": { "uri": URI }, "range": whole }));
    assert_eq!(hints.as_array().map(Vec::len), Some(1), "{hints}");
    assert_eq!(hints[0]["label"], "= 0.4 m");
    client.stop();
}
