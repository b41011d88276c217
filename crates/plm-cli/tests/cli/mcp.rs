//! The server of the Model Context Protocol: a recorded session, limits, the folder, resources, and what is no message.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::{folder, plm_in, root};

#[path = "mcp/folder.rs"]
mod folder_of_a_server;
#[path = "mcp/resources.rs"]
mod resources;

/// A pendulum.
const PENDULUM: &str = "pub Pendulum { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; } body bob { mass: 1 kg; inertia: 0.01 kg*m^2; \
                        port pivot: (0, 1) m; start angle: 30 deg, locked; } revolute hinge(ground.o, bob.pivot); output bob.angle; }";

/// The answers to messages, in the order in which they come, of a server in a folder.
pub(crate) fn answers(folder: &Path, options: &[&str], messages: &[Value]) -> Vec<Value> {
    let lines: Vec<String> = messages.iter().map(Value::to_string).collect();
    answers_to(folder, options, &(lines.join("\n") + "\n"))
}

fn answers_to(folder: &Path, options: &[&str], lines: &str) -> Vec<Value> {
    let said = plm_in(folder, &[&["mcp"], options].concat(), lines.as_bytes());
    assert!(said.code == 0 && said.errors.is_empty(), "{said:?}");
    said.output.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// A request.
pub(crate) fn request(id: u64, method: &str, params: &Value) -> Value {
    json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params })
}

/// A call of a tool.
pub(crate) fn call(id: u64, tool: &str, arguments: &Value) -> Value {
    request(id, "tools/call", &json!({ "name": tool, "arguments": arguments }))
}

/// The result of one call.
pub(crate) fn result(folder: &Path, options: &[&str], tool: &str, arguments: &Value) -> Value {
    answers(folder, options, &[call(1, tool, arguments)])[0]["result"].clone()
}

/// The text of a result that is an error.
pub(crate) fn cause(result: &Value) -> &str {
    let shown: String = result.to_string().chars().take(500).collect();
    assert_eq!(result["isError"], true, "{shown}");
    result["content"][0]["text"].as_str().unwrap()
}

/// A session from a check to a complete FMU, whose answers stand beside it.
#[test]
fn a_recorded_session_has_the_same_answers() {
    let files = root().join("crates/plm-cli/tests/cli/mcp");
    let lines = fs::read_to_string(files.join("session.jsonl")).unwrap();
    let folder = folder();
    let answers = answers_to(&folder, &[], &lines);
    // Paths in messages are those of the system.
    let line = |answer: &Value| answer.to_string().replace("\\\\", "/") + "\n";
    let made: String = answers.iter().map(line).collect();
    let expected = files.join("session.expected.jsonl");
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(expected, made).unwrap();
    } else {
        let known = fs::read_to_string(expected).unwrap_or_default();
        for (made, known) in made.lines().zip(known.lines()) {
            assert!(made == known, "{made}\n  is not\n{known}\n  `cargo xtask bless book` writes it anew");
        }
        assert_eq!(made.lines().count(), known.lines().count(), "`cargo xtask bless book` writes it anew");
    }
    assert!(folder.join("crank/slider_crank.c").is_file(), "{:?}", fs::read_dir(folder.join("crank")));
    let fmu = fs::read(folder.join("crank.fmu")).unwrap();
    assert!(fmu.starts_with(b"PK"), "an FMU is a ZIP archive");
    let has = |name: &str| fmu.windows(name.len()).any(|bytes| bytes == name.as_bytes());
    assert!(
        has("modelDescription.xml") && has("sources/slider_crank_fmi.c"),
        "its description and its source"
    );
}

#[test]
fn a_fix_goes_in_the_place_of_its_bytes() {
    let text = PENDULUM.replace("mass: 1 kg", "mass: 1");
    let found = result(&folder(), &[], "check", &json!({ "text": text }));
    let fix = &found["structuredContent"]["fixes"][0];
    let [from, to] = ["byte_start", "byte_end"].map(|name| fix[name].as_u64().unwrap() as usize);
    let mut fixed = text.clone();
    fixed.replace_range(from..to, fix["replacement"].as_str().unwrap());
    assert_eq!(fixed, PENDULUM);
}

/// Small swings of a pendulum of mass m and inertia I at the distance l: sqrt(m g l/(I + m l^2)).
#[test]
fn modes_are_those_of_the_closed_form() {
    let found = result(&folder(), &[], "modes", &json!({ "text": PENDULUM }));
    let frequency = found["structuredContent"]["modes"][0]["frequency_rad_per_s"].as_f64().unwrap();
    assert!((frequency - (9.81_f64 / 1.01).sqrt()).abs() < 1e-9, "{found}");
}

/// A rod of 8 cm does not let a crank of 10 cm past the angle whose sine is 0.8.
#[test]
fn a_fault_of_a_run_is_told_with_what_came_before() {
    let skill = include_str!("../../skills/plm/SKILL.md");
    let declaration = skill.split("```plm\n").nth(1).unwrap().split("```").next().unwrap();
    let short = declaration.replace("(-15, 0) cm", "(-4, 0) cm").replace("(15, 0) cm", "(4, 0) cm");
    let found = result(&folder(), &[], "run", &json!({ "text": short, "until": 1, "every": 0.01 }));
    let run = &found["structuredContent"];
    assert!(run["fault"].as_str().unwrap().starts_with("t = "), "{run}");
    let (dead, end) =
        ((0.8_f64.asin() - 30_f64.to_radians()) / (100.0 / 60.0 * std::f64::consts::TAU), &run["end"]);
    assert!((end.as_f64().unwrap() - dead).abs() < 1e-3, "{end} {dead}");
    assert!(run["rows"].as_array().unwrap().len() > 3, "{run}");
}

#[test]
fn limits_end_a_call_and_are_named() {
    let long = json!({ "text": PENDULUM, "until": 1e9, "every": 1e8 });
    let outputs = "output bob.angle, bob.x, bob.y, bob.vx, bob.vy, bob.omega, hinge.force, bob.pivot.velocity, bob.pivot.acceleration;";
    let text = PENDULUM.replace("output bob.angle;", outputs);
    let wordy = json!({ "text": text, "until": 40, "every": 0.0009 });
    let folder = folder();
    for (options, arguments, limit) in [
        (["--seconds", "0.5"], &long, "more than 0.5 s, the limit of time"),
        (["--memory", "6"], &wordy, "more than 6 MiB, the limit of memory"),
        (["--seconds", "60"], &wordy, "more than 8 MiB, the limit of an answer"),
    ] {
        let next = call(2, "check", &json!({ "text": PENDULUM }));
        let said = answers(&folder, &options, &[call(1, "run", arguments), next]);
        assert!(cause(&said[0]["result"]).contains(limit), "{limit}");
        // The server goes on.
        assert_eq!(said[1]["result"]["structuredContent"]["errors"], 0);
    }
}

#[test]
fn what_is_no_request_is_told_and_the_next_one_is_answered() {
    let lines = [
        "{".to_owned(),
        "[]".to_owned(),
        "{\"jsonrpc\":\"2.0\",\"id\":1}".to_owned(),
        "{\"jsonrpc\":\"2.0\",\"id\":[1],\"method\":\"ping\"}".to_owned(),
        "{\"jsonrpc\":\"2.0\",\"id\":7,\"result\":{}}".to_owned(),
        String::new(),
        request(2, "no/method", &json!({})).to_string(),
        call(3, "no_tool", &json!({})).to_string(),
        call(4, "run", &json!({ "text": PENDULUM })).to_string(),
        call(5, "run", &json!({ "text": PENDULUM, "until": "1 s" })).to_string(),
        call(6, "run", &json!({ "text": PENDULUM, "until": 1, "untill": 1 })).to_string(),
        call(7, "check", &json!({ "text": PENDULUM, "file": "a.plm" })).to_string(),
        call(8, "check", &json!({})).to_string(),
        call(9, "check", &json!([1])).to_string(),
        request(10, "ping", &json!({})).to_string(),
    ];
    let said = answers_to(&folder(), &[], &(lines.join("\n") + "\n"));
    let of = |id: Value| said.iter().filter(move |answer| answer["id"] == id).collect::<Vec<_>>();
    let codes: Vec<i64> =
        of(Value::Null).iter().map(|answer| answer["error"]["code"].as_i64().unwrap()).collect();
    assert_eq!(codes, [-32700, -32600, -32600, -32600], "{said:?}");
    assert_eq!(of(json!(2))[0]["error"]["code"], -32601);
    assert_eq!(of(json!(3))[0]["error"]["code"], -32602);
    for (id, part) in [
        (4, "`until` is missing"),
        (5, "`until` is \"1 s\", and a number of seconds is wanted"),
        (6, "no argument `untill`"),
        (7, "`text` or `file`, not both"),
        (8, "a declaration is wanted"),
        (9, "are an object"),
    ] {
        let result = &of(json!(id))[0]["result"];
        assert!(cause(result).contains(part), "{result}");
    }
    assert_eq!(of(json!(10))[0]["result"], json!({}));
}

#[test]
fn a_cancelled_call_is_not_answered_and_a_ping_does_not_wait() {
    let long = json!({ "text": PENDULUM, "until": 1e9, "every": 1e8 });
    let cancelled = |id: u64| json!({ "jsonrpc": "2.0", "method": "notifications/cancelled", "params": { "requestId": id } });
    let messages = [
        call(1, "run", &long),
        call(2, "run", &long),
        request(3, "ping", &json!({})),
        cancelled(2),
        cancelled(1),
        call(4, "check", &json!({ "text": PENDULUM })),
    ];
    let said = answers(&folder(), &["--seconds", "30"], &messages);
    let ids: Vec<u64> = said.iter().map(|answer| answer["id"].as_u64().unwrap()).collect();
    assert_eq!(ids, [3, 4], "{said:?}");
}

/// The revision of 2026-07-28 has no beginning: each request says its revision, and each result that it is whole.
#[test]
fn each_revision_is_answered_in_its_form() {
    let meta = |revision: &str| json!({ "_meta": { "io.modelcontextprotocol/protocolVersion": revision } });
    let asks = |revision: &str| json!({ "protocolVersion": revision, "capabilities": {} });
    let said = answers(
        &folder(),
        &[],
        &[
            request(1, "server/discover", &meta("2026-07-28")),
            request(2, "tools/list", &meta("2026-07-28")),
            request(3, "tools/list", &meta("1999-01-01")),
            request(4, "initialize", &asks("2024-11-05")),
            request(5, "initialize", &asks("1999-01-01")),
            request(6, "tools/list", &json!({})),
        ],
    );
    assert_eq!(said[0]["result"]["supportedVersions"][0], "2026-07-28");
    assert_eq!(said[1]["result"]["resultType"], "complete");
    assert_eq!(said[2]["error"]["code"], -32022);
    assert_eq!(said[3]["result"]["protocolVersion"], "2024-11-05");
    assert_eq!(said[4]["result"]["protocolVersion"], "2025-11-25");
    assert!(said[5]["result"].get("resultType").is_none());
}

/// A picture in pixels is an image of the answer, or a file.
#[test]
fn a_picture_is_text_or_pixels() {
    let folder = folder();
    let svg = result(&folder, &[], "picture", &json!({ "text": PENDULUM }));
    assert!(svg["content"][0]["text"].as_str().unwrap().starts_with("<svg"), "{svg}");
    let png = result(&folder, &[], "picture", &json!({ "text": PENDULUM, "format": "png", "at": 0.3 }));
    let image = &png["content"][0];
    assert_eq!((&image["type"], &image["mimeType"]), (&json!("image"), &json!("image/png")), "{png}");
    // The signature of PNG, in base 64.
    assert!(image["data"].as_str().unwrap().starts_with("iVBORw0KGgo"), "{png}");
    let to = json!({ "text": PENDULUM, "format": "png", "to": "pendulum.png" });
    assert_eq!(result(&folder, &[], "picture", &to)["isError"], false);
    assert!(fs::read(folder.join("pendulum.png")).unwrap().starts_with(b"\x89PNG\r\n\x1a\n"));
    let other = result(&folder, &[], "picture", &json!({ "text": PENDULUM, "format": "gif" }));
    assert!(cause(&other).contains("one of svg, png"), "{other}");
}
