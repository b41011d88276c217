//! Diagnostics as JSON: what the program writes for tools is what rustc shows, in `tests/ui`.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{folder, plm_in, root};

/// The messages for a declaration, read as JSON.
fn messages(text: &str) -> Vec<Value> {
    let folder = folder();
    fs::write(folder.join("pendulum.plm"), text).unwrap();
    let said = plm_in(&folder, &["check", "--json", "pendulum.plm"], b"");
    assert!(said.code <= 1 && said.errors.is_empty(), "{said:?}");
    said.output.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
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
    for case in cases(&root().join("tests/ui")) {
        let stderr = fs::read_to_string(&case).unwrap();
        // What rustc's own lexer refuses (`error[E0768]`) comes to the compiler in another form, and parts of other files not at all.
        if !stderr.contains("error: [") || stderr.contains("error[") {
            continue;
        }
        let rust = case.with_extension("rs");
        let said = plm_in(
            rust.parent().unwrap(),
            &["check", "--json", rust.file_name().unwrap().to_str().unwrap()],
            b"",
        );
        // The form of `parts!` is rustc's alone to read.
        if !said.errors.is_empty() || stderr.contains("expected a name for the parts") {
            continue;
        }
        let mut expected = shown(&stderr);
        let found = said.output.lines().map(|line| serde_json::from_str::<Value>(line).unwrap());
        let mut found: Vec<_> = found
            .filter(|message| message["level"] == "error")
            .map(|error| {
                let span = &error["spans"][0];
                assert_eq!(span["is_primary"], true);
                let [line, end, start, after] = ["line_start", "line_end", "column_start", "column_end"]
                    .map(|of| span[of].as_u64().unwrap());
                assert_eq!(line, end, "{error}");
                (error["code"]["code"].as_str().unwrap().to_owned(), line, start, after - start)
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
    let page = root().join("docs/src/running/command-line.md");
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
fn places_after_a_missing_bracket_are_those_of_the_file() {
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
