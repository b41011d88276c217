//! The tools: commands of `plm` with their arguments, and what their results are to an agent.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};

use super::arguments::{Arguments, Field, Kind, schema};
use super::folder::Folder;
use super::process::Said;

/// A tool.
pub(super) struct Tool {
    name: &'static str,
    title: &'static str,
    about: &'static str,
    /// Arguments beside the declaration.
    fields: &'static [Field],
    /// Does it write files?
    writes: bool,
    /// Words of the command and of its options, without the declaration.
    words: fn(&Arguments) -> Result<Vec<String>, String>,
    answer: fn(&Said) -> Value,
}

/// A call that is to be made.
pub(super) struct Call {
    pub(super) words: Vec<String>,
    pub(super) input: String,
    pub(super) answer: fn(&Said) -> Value,
}

/// The declaration, which each tool has.
const DECLARATION: [Field; 2] = [
    Field {
        name: "text",
        kind: Kind::Text,
        about: "the declaration, `pub Name { … }`, the inside of `mechanism!`",
        is_needed: false,
    },
    Field {
        name: "file",
        kind: Kind::Text,
        about: "in place of `text`: its file, relative to the folder of the server",
        is_needed: false,
    },
];

const SET: Field = Field {
    name: "set",
    kind: Kind::Values,
    about: "values of parameters, with units or in those declared: {\"length\": \"20 cm\"}",
    is_needed: false,
};
const INPUT: Field = Field {
    name: "input",
    kind: Kind::Values,
    about: "values of inputs, as those of `set`",
    is_needed: false,
};

const fn needed(name: &'static str, kind: Kind, about: &'static str) -> Field {
    Field { name, kind, about, is_needed: true }
}

const fn optional(name: &'static str, kind: Kind, about: &'static str) -> Field {
    Field { name, kind, about, is_needed: false }
}

/// Formats of an export, and their options of `plm export`.
const FORMATS: [(&str, &str); 11] = [
    ("c_source", "--c-source"),
    ("cuda", "--cuda"),
    ("fmu_source", "--fmu-source"),
    ("ros2", "--ros2"),
    ("mjcf", "--mjcf"),
    ("urdf", "--urdf"),
    ("rust", "--rust"),
    ("c", "--c"),
    ("fmu", "--fmu"),
    ("python", "--python"),
    ("link", "--link"),
];
const FORMAT_NAMES: [&str; 11] =
    ["c_source", "cuda", "fmu_source", "ros2", "mjcf", "urdf", "rust", "c", "fmu", "python", "link"];

const TOOLS: [Tool; 7] = [
    Tool {
        name: "check",
        title: "Check a declaration",
        about: "All mistakes of a declaration at once: code, message, place (lines, columns, bytes), help, and `fixes`, texts that \
                go in the place of a range of bytes. No diagnostics means that it compiles. A Rust file is read too.",
        fields: &[],
        writes: false,
        words: |_| Ok(vec!["check".to_owned(), "--json".to_owned()]),
        answer: checked,
    },
    Tool {
        name: "run",
        title: "Run a mechanism",
        about: "Motion over time: columns, rows, events, notices, counts of steps, and `fault` where it ends early. Outputs are those \
                that the declaration names; without them the poses of all bodies.",
        fields: &[
            needed("until", Kind::Seconds, "the end of the run, s"),
            optional("every", Kind::Seconds, "between two samples, s; without it a 20th of the run"),
            SET,
            INPUT,
            optional("inputs", Kind::Text, "a CSV of inputs over time, relative to the folder of the server"),
            optional(
                "method",
                Kind::Text,
                "NAME or NAME:NUMBER with its tolerance or longest step; else Dop853:1e-9",
            ),
            optional(
                "sampled",
                Kind::Bare,
                "rows at multiples of `every` alone, none where something switches",
            ),
        ],
        writes: false,
        words: |given| {
            let mut words = vec!["run".to_owned(), "--json".to_owned()];
            words.extend(seconds(given, "until"));
            words.extend(seconds(given, "every"));
            words.extend([given.values("set"), given.values("input")].concat());
            words.extend(given.place("inputs")?.map(|file| format!("--inputs={file}")));
            words.extend(given.text("method").map(|method| format!("--method={method}")));
            words.extend(given.is_true("sampled").then(|| "--sampled".to_owned()));
            Ok(words)
        },
        answer: of_json,
    },
    Tool {
        name: "picture",
        title: "Draw a mechanism",
        about: "A drawing at the start or at a later time: PNG to look at, or SVG.",
        fields: &[
            optional("at", Kind::Seconds, "the time of the pose, s; without it the start"),
            optional("format", Kind::OneOf(&["svg", "png"]), "svg without it; png is 1200 pixels wide"),
            SET,
            INPUT,
            optional(
                "to",
                Kind::Text,
                "a file to be written, relative to the folder of the server; without it the picture is answered",
            ),
        ],
        writes: true,
        words: |given| {
            let mut words = vec!["picture".to_owned()];
            words.extend(seconds(given, "at"));
            words.extend([given.values("set"), given.values("input")].concat());
            let (format, to) = (given.text("format").unwrap_or("svg"), given.place("to")?.unwrap_or("-"));
            words.push(format!("--{format}={to}"));
            Ok(words)
        },
        answer: as_picture,
    },
    Tool {
        name: "assemble",
        title: "Assemble a mechanism",
        about: "The assembled start and the equations: poses and velocities of all bodies, degrees of freedom, redundant parts, \
                formulation and why it was taken, operations.",
        fields: &[],
        writes: false,
        words: |_| Ok(vec!["report".to_owned(), "--json".to_owned()]),
        answer: of_json,
    },
    Tool {
        name: "equations",
        title: "Equations of motion",
        about: "The equations of motion as in a textbook, as LaTeX, with the symbols of the coordinates.",
        fields: &[],
        writes: false,
        words: |_| Ok(vec!["report".to_owned(), "--equations".to_owned()]),
        answer: as_text,
    },
    Tool {
        name: "modes",
        title: "Modes of a mechanism",
        about: "Frequencies, dampings, eigenvalues and shapes of the modes near an equilibrium.",
        fields: &[
            SET,
            INPUT,
            optional("as_started", Kind::Bare, "at the start itself, which need not be an equilibrium"),
        ],
        writes: false,
        words: |given| {
            let mut words = vec!["modes".to_owned(), "--json".to_owned()];
            words.extend([given.values("set"), given.values("input")].concat());
            words.extend(given.is_true("as_started").then(|| "--as-started".to_owned()));
            Ok(words)
        },
        answer: of_json,
    },
    Tool {
        name: "export",
        title: "Export a mechanism",
        about: "C99 source (`c_source`), an FMU with it, complete (`fmu_source`), a package of ROS 2 whose node steps it (`ros2`), a \
                model of MuJoCo (`mjcf`) or ROS (`urdf`), a Rust package that makes a program, a library for C, an FMU with a binary \
                or a wheel (`rust`, `c`, `fmu`, `python`; cargo builds it), or a link to the playground.",
        fields: &[
            needed("format", Kind::OneOf(&FORMAT_NAMES), "what it becomes"),
            optional(
                "to",
                Kind::Text,
                "the file, of packages and sources the folder, relative to the folder of the server; mjcf and urdf are \
                 given as text without it",
            ),
            optional("single", Kind::Bare, "of c_source: numbers of 32 bits"),
            optional("fmi", Kind::OneOf(&["2", "3"]), "of fmu_source: the version of FMI, 3 without it"),
            optional("address", Kind::Text, "of link: the address of the playground"),
        ],
        writes: true,
        words: export,
        answer: as_text,
    },
];

fn export(given: &Arguments) -> Result<Vec<String>, String> {
    let format = given.text("format").unwrap_or_default();
    let option = FORMATS.iter().find(|(name, _)| *name == format).map_or("--rust", |(_, option)| *option);
    let value = match (format, given.place("to")?, given.text("address")) {
        ("link", _, Some(address)) => address,
        ("link", _, None) => return Err("a link needs `address`: that of the playground".to_owned()),
        (_, Some(to), _) => to,
        ("mjcf" | "urdf", None, _) => "-",
        ("fmu_source", None, _) => return Err("fmu_source needs `to`: the name of its file".to_owned()),
        (format, None, _) => return Err(format!("{format} needs `to`: a folder for its files")),
    };
    let mut words = vec!["export".to_owned(), format!("{option}={value}")];
    words.extend(given.is_true("single").then(|| "--single".to_owned()));
    words.extend(given.text("fmi").map(|version| format!("--fmi={version}")));
    Ok(words)
}

/// The option of a time.
fn seconds(given: &Arguments, name: &str) -> Option<String> {
    given.seconds(name).map(|value| format!("--{name}={value}"))
}

impl Tool {
    /// The call of these arguments.
    ///
    /// # Errors
    /// One of them is wrong.
    pub(super) fn call(&self, given: &Value, folder: &Folder) -> Result<Call, String> {
        let fields = self.fields.iter().chain(&DECLARATION);
        let given = Arguments::new(fields, given, folder)?;
        let mut words = (self.words)(&given)?;
        let (word, input) = given.declaration()?;
        words.push(word);
        Ok(Call { words, input, answer: self.answer })
    }
}

/// The tool of this name.
pub(super) fn named(name: &str) -> Option<&'static Tool> {
    TOOLS.iter().find(|tool| tool.name == name)
}

/// The names of all tools.
pub(super) fn names() -> String {
    TOOLS.iter().map(|tool| tool.name).collect::<Vec<_>>().join(", ")
}

/// The tools as the protocol describes them.
pub(super) fn list() -> Vec<Value> {
    let shown = |tool: &Tool| {
        json!({
            "name": tool.name,
            "title": tool.title,
            "description": tool.about,
            "inputSchema": schema(DECLARATION.iter().chain(tool.fields)),
            "annotations": {
                "readOnlyHint": !tool.writes, "destructiveHint": false, "idempotentHint": true, "openWorldHint": false,
            },
        })
    };
    TOOLS.iter().map(shown).collect()
}

/// The result of a call that has none: its cause.
pub(super) fn failed(why: &str) -> Value {
    json!({ "content": [{ "type": "text", "text": why.trim_end() }], "isError": true })
}

fn said(text: &str) -> Value {
    json!({ "content": [{ "type": "text", "text": text.trim_end() }], "isError": false })
}

/// A result as an object, and as its text for clients that know texts alone.
fn structured(value: Value) -> Value {
    let mut result = said(&value.to_string());
    result["structuredContent"] = value;
    result
}

/// The messages of a command, or its exit code where it says nothing.
fn because(told: &Said) -> String {
    if told.errors.trim().is_empty() {
        format!("plm ended with the code {}", told.code)
    } else {
        told.errors.clone()
    }
}

/// The result of `plm check --json`; mistakes of the declaration are its result.
fn checked(told: &Said) -> Value {
    let diagnostics: Vec<Value> =
        told.text().lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    if told.code > 1 {
        return failed(&because(told));
    }
    let count = |level: &str| diagnostics.iter().filter(|own| own["level"] == level).count();
    let fixes: Vec<Value> = diagnostics.iter().flat_map(fixes).collect();
    structured(json!({
        "errors": count("error"),
        "warnings": count("warning"),
        "messages": told.errors.lines().collect::<Vec<_>>(),
        "fixes": fixes,
        "diagnostics": diagnostics,
    }))
}

/// The texts that answer a diagnostic, with the bytes that they replace.
fn fixes(diagnostic: &Value) -> Vec<Value> {
    let children = diagnostic["children"].as_array().into_iter().flatten();
    let fix = |child: &Value| {
        let span = &child["spans"][0];
        let text = span["suggested_replacement"].as_str()?;
        Some(json!({
            "code": diagnostic["code"]["code"], "message": child["message"], "file": span["file_name"],
            "byte_start": span["byte_start"], "byte_end": span["byte_end"],
            "line": span["line_start"], "column": span["column_start"], "replacement": text,
        }))
    };
    children.filter_map(fix).collect()
}

/// The result of a command that writes one object; messages beside it are told in it.
fn of_json(told: &Said) -> Value {
    let Ok(mut value) = serde_json::from_slice::<Value>(&told.output) else {
        return failed(&because(told));
    };
    if !told.errors.trim().is_empty() {
        value["messages"] = json!(told.errors.lines().collect::<Vec<_>>());
    }
    structured(value)
}

/// The result of a command that writes a text.
fn as_text(told: &Said) -> Value {
    if told.code != 0 {
        return failed(&because(told));
    }
    let mut result = said(&told.text());
    if !told.errors.trim().is_empty()
        && let Some(content) = result["content"].as_array_mut()
    {
        content.push(json!({ "type": "text", "text": told.errors.trim_end() }));
    }
    result
}

/// The result of a command that writes a picture: pixels are an image.
fn as_picture(told: &Said) -> Value {
    let mut result = as_text(told);
    if told.code == 0 && told.output.starts_with(b"\x89PNG") {
        result["content"][0] =
            json!({ "type": "image", "mimeType": "image/png", "data": STANDARD.encode(&told.output) });
    }
    result
}
