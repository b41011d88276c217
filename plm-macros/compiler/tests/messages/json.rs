//! Diagnostics as JSON: what the example `dump` writes for editors is what rustc shows, in `tests/ui`.

use std::fs;
use std::path::{Path, PathBuf};

use plm_compiler::compile;
use plm_compiler::token::Sources;
use serde_json::Value;

#[path = "../../examples/dump/command.rs"]
mod command;

/// The messages for a declaration, read as JSON.
fn messages(text: &str) -> Vec<Value> {
    let mut sources = Sources::new();
    sources.add_text("pendulum.plm", text);
    let expansion = compile(&mut sources);
    let lines = expansion.diagnostics.sorted().into_iter().map(|of| command::json::line(of, &sources, text));
    lines
        .inspect(|line| assert!(!line.contains('\n')))
        .map(|line| serde_json::from_str(&line).unwrap())
        .collect()
}

/// Code, line, column and carets of each error that rustc shows.
fn shown(stderr: &str) -> Vec<(String, u64, u64, u64)> {
    let errors = stderr.split("error: [").skip(1);
    let shown = errors.map(|error| {
        let place = error.lines().find_map(|line| line.trim_start().strip_prefix("--> ")).unwrap();
        let mut numbers = place.rsplit(':').map(|number| number.parse().unwrap());
        let [column, line] = [(); 2].map(|()| numbers.next().unwrap());
        let carets =
            error.lines().find(|line| line.trim_start().starts_with("| ") && line.contains('^')).unwrap();
        (error[..5].to_owned(), line, column, carets.matches('^').count() as u64)
    });
    shown.collect()
}

/// The Rust code with blanks for all but what stands in its one macro, so that places stay.
fn declared(rust: &str) -> Option<String> {
    let (before, rest) = rust.split_once("mechanism! {")?;
    let is_alone = !rest.contains("mechanism!") && !rust.contains("parts!");
    let end = rest.find("\n}\n").filter(|_| is_alone)?;
    let blank = |text: &str| text.chars().map(|c| if c == '\n' { '\n' } else { ' ' }).collect::<String>();
    Some(blank(before) + "            " + &rest[..end])
}

fn cases(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .flat_map(|path| if path.is_dir() { cases(&path) } else { vec![path] })
        .filter(|path| path.extension().is_some_and(|extension| extension == "stderr"))
        .collect();
    found.sort();
    found
}

#[test]
fn places_in_json_are_those_that_rustc_shows() {
    let (mut compared, mut several) = (0, 0);
    for case in cases(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/ui")) {
        let stderr = fs::read_to_string(&case).unwrap();
        let rust = fs::read_to_string(case.with_extension("rs")).unwrap();
        // What rustc's own lexer refuses (`error[E0768]`) comes to the compiler in another form.
        let is_ours = stderr.contains("error: [") && !stderr.contains("error[");
        let Some(text) = declared(&rust).filter(|_| is_ours) else { continue };
        let mut expected = shown(&stderr);
        let errors = messages(&text).into_iter().filter(|message| message["level"] == "error");
        let mut found: Vec<_> = errors
            .map(|error| {
                let span = &error["spans"][0];
                assert_eq!(span["is_primary"], true);
                let [line, end, start, behind] = ["line_start", "line_end", "column_start", "column_end"]
                    .map(|of| span[of].as_u64().unwrap());
                assert_eq!(line, end, "{error}");
                (error["code"]["code"].as_str().unwrap().to_owned(), line, start, behind - start)
            })
            .collect();
        expected.sort();
        found.sort();
        assert_eq!(found, expected, "{}", case.display());
        compared += 1;
        several += usize::from(found.len() > 1);
    }
    assert!(compared > 12 && several > 2, "{compared} cases, {several} of them with several errors");
}

/// The page of the book shows a declaration, its message, and the same as JSON.
#[test]
fn the_book_shows_a_message() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/running/editors.md");
    let text = fs::read_to_string(&page).unwrap();
    let block = |fence: &str| {
        let start = text.find(fence).unwrap() + fence.len();
        start..start + text[start..].find("```\n").unwrap()
    };
    let made = serde_json::to_string_pretty(&messages(&text[block("```plm,E0302\n")])[0]).unwrap() + "\n";
    let shown = block("```json\n");
    if std::env::var_os("PLM_BLESS").is_some() {
        fs::write(page, [&text[..shown.start], &made, &text[shown.end..]].concat()).unwrap();
    } else {
        assert!(text[shown] == made, "{made}\nPLM_BLESS=1 writes it anew");
    }
}

#[test]
fn a_message_has_all_that_an_editor_wants() {
    let text = "pub P {\n    ground { port o: (0, 0) m; }\n    body \u{e9}t\u{e9} { mass: 10; }\n}\n";
    let found = messages(text);
    let mass = found.iter().find(|of| of["code"]["code"] == "E0302").unwrap();
    assert_eq!(mass["$message_type"], "diagnostic");
    assert_eq!(mass["code"]["page"], "diagnostics/E0302.html");
    assert_eq!(mass["children"][0]["level"], "help");
    assert_eq!(mass["children"][0]["message"], "write its unit: `10 kg`");
    let span = &mass["spans"][0];
    let [from, to] = ["byte_start", "byte_end"].map(|of| span[of].as_u64().unwrap() as usize);
    assert_eq!(&text[from..to], "10");
    assert_eq!(span["text"][0]["text"], text.lines().nth(2).unwrap());
    assert!(mass["rendered"].as_str().unwrap().starts_with("error[E0302]: "));
}

#[test]
fn places_behind_a_missing_bracket_are_those_of_the_file() {
    let text = "pub P { body b { mass: (1 kg; } let b = q; }";
    let found = messages(text);
    let unknown = found.iter().find(|of| of["code"]["code"] == "E0201").unwrap();
    let span = &unknown["spans"][0];
    let [from, to] = ["byte_start", "byte_end"].map(|of| span[of].as_u64().unwrap() as usize);
    assert_eq!((&text[from..to], from), ("q", text.find('q').unwrap()));
}

#[test]
fn a_mistake_within_a_part_names_its_use_and_its_place() {
    let text = "part magnet(a: frame) { force on a: (0, 3 N*m); }\npub P {\n    ground { port o: (0, 0) m; }\n    \
                body b { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; }\n    magnet lower(b.p);\n}\n";
    let found = messages(text);
    let wrong = found.iter().find(|of| of["code"]["code"] == "E0301").unwrap();
    let spans = wrong["spans"].as_array().unwrap();
    assert_eq!(spans[0]["line_start"], 1);
    assert_eq!(spans[1]["label"], "the part `magnet`, used as `lower`");
    assert_eq!(spans[1]["line_start"], 5);
}

/// What the command says of a declaration on its input: are there errors, its output, its errors.
fn said(words: &[&str], declaration: &str) -> (bool, String, String) {
    let (mut output, mut errors) = (Vec::new(), Vec::new());
    let words = words.iter().map(ToString::to_string);
    let failed = command::run(words, &mut declaration.as_bytes(), &mut output, &mut errors).unwrap();
    (failed, String::from_utf8(output).unwrap(), String::from_utf8(errors).unwrap())
}

#[test]
fn the_command_checks_and_tells_by_its_exit() {
    let wrong = "pub P { body b { mass: 10; inertia: q; } }";
    let (failed, output, errors) = said(&["--check", "-"], wrong);
    assert!(
        failed && output.is_empty() && errors.contains("error[E0302]") && errors.contains("error[E0201]")
    );
    let (failed, output, errors) = said(&["--message-format", "json", "-"], wrong);
    assert!(failed && errors.is_empty());
    let codes: Vec<Value> = output
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap()["code"]["code"].clone())
        .collect();
    assert_eq!(codes, ["E0302", "E0201"]);

    assert_eq!(said(&["--check"], ""), (false, String::new(), String::new()));
    let (failed, code, report) = said(&[], "");
    assert!(!failed && code.contains("pub struct DoublePendulum") && report.contains("Formulation 2"));
    let run = |words: &[&str]| {
        let words = words.iter().map(ToString::to_string);
        command::run(words, &mut "".as_bytes(), &mut Vec::new(), &mut Vec::new())
    };
    assert!(
        run(&["--message-format", "xml"]).is_err() && run(&["--chek"]).is_err() && run(&["a", "b"]).is_err()
    );
}
