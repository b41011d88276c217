//! `plm check`, `plm expand` and `plm report`, right and wrong inputs.

use std::fs;

use serde_json::Value;

use super::{Said, folder, plm, plm_in, root};

const WRONG: &str = "pub P { body b { mass: 10; inertia: q; } }";
const RIGHT: &str = "pub P { allow(W0002); body b { mass: 1 kg; inertia: 1 kg*m^2; } }";

#[test]
fn diagnostics_are_text_with_carets_or_json_and_the_exit_code_tells() {
    let Said { code, output, errors } = plm(&["check", "-"], WRONG);
    assert_eq!((code, output.as_str()), (1, ""));
    assert!(errors.contains("error[E0302]") && errors.contains(" --> <stdin>:1:24\n"), "{errors}");
    assert!(errors.contains("                       ^^\n  = help: write its unit: `10 kg`\n"), "{errors}");
    let Said { code, output, errors } = plm(&["check", "--json", "-"], WRONG);
    assert_eq!((code, errors.as_str()), (1, ""));
    let codes: Vec<Value> = output
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap()["code"]["code"].clone())
        .collect();
    assert_eq!(codes, ["E0302", "E0201"]);
    assert_eq!(plm(&["check", "-"], RIGHT).code, 0);
}

#[test]
fn several_files_are_checked_and_the_worst_outcome_counts() {
    let folder = folder();
    fs::write(folder.join("right.plm"), RIGHT).unwrap();
    fs::write(folder.join("wrong.plm"), WRONG).unwrap();
    let check = |files: &[&str]| plm_in(&folder, &[&["check"], files].concat(), b"");
    assert_eq!(check(&["right.plm"]), Said { code: 0, output: String::new(), errors: String::new() });
    let said = check(&["right.plm", "wrong.plm"]);
    assert!(said.code == 1 && said.errors.contains("--> wrong.plm:1:24"), "{said:?}");
    let said = check(&["none.plm", "wrong.plm"]);
    assert!(said.code == 2 && said.errors.contains("plm: none.plm: ") && said.errors.contains("E0302"));
}

#[test]
fn each_mechanism_of_a_rust_file_is_checked_at_its_places() {
    let folder = folder();
    let rust = "// mechanism! { pub No { mass: 1; } }\nplm::parts! { pub mine { part gone(a: frame) { } } }\n\
                plm::mechanism! { pub P { body b { mass: 10; inertia: 1 kg*m^2; } } }\r\nfn é() { /* é */ plm::mechanism!(\n    \
                use mine; pub Q { body c { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; } gone fine(c.p); gone wrong(c.q); }); }\n\
                plm::mechanism! { use other::parts; pub R { } }\n";
    fs::write(folder.join("a.rs"), rust).unwrap();
    let said = plm_in(&folder, &["check", "a.rs"], b"");
    assert_eq!(said.code, 1);
    let places: Vec<&str> =
        said.errors.lines().filter(|line| line.trim_start().starts_with("--> ")).collect();
    assert_eq!(places, [" --> a.rs:3:42", " --> a.rs:5:112"], "{}", said.errors);
    // The lines are those of the file.
    assert!(said.errors.contains("3 | plm::mechanism! { pub P { body b { mass: 10;"), "{}", said.errors);
    assert!(
        said.errors.contains("plm: a.rs:6: not checked: the parts of `use other::parts;`"),
        "{}",
        said.errors
    );
    let said = plm_in(&folder, &["check", "--json", "a.rs"], b"");
    let spans =
        said.output.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["spans"][0].clone());
    let quoted = spans.map(|span| {
        let [from, to] = ["byte_start", "byte_end"].map(|of| span[of].as_u64().unwrap() as usize);
        rust[from..to].to_owned()
    });
    assert_eq!(quoted.collect::<Vec<_>>(), ["10", "q"]);
}

#[test]
fn hostile_input_is_answered_with_a_message() {
    let folder = folder();
    fs::write(folder.join("latin.plm"), b"pub P { let \xe9 = 1; }").unwrap();
    fs::write(folder.join("huge.plm"), vec![b'{'; (4 << 20) + 1]).unwrap();
    fs::write(folder.join("deep.plm"), "{".repeat(200_000)).unwrap();
    fs::write(folder.join("deep.rs"), format!("mechanism! {{ pub P {{ let a = {}", "(".repeat(100_000)))
        .unwrap();
    fs::write(folder.join("garbage.plm"), "§'\"}])\\ 0bar ".repeat(20_000)).unwrap();
    fs::write(folder.join("escaped.plm"), "\\\"".repeat(200_000)).unwrap();
    fs::write(folder.join("outside.plm"), "pub P { body b { contour: \"/dev/zero\"; } }").unwrap();
    for (file, code, message) in [
        ("latin.plm", 2, "plm: latin.plm: is not UTF-8 at byte 12"),
        ("huge.plm", 2, "plm: huge.plm: has more than 4 MiB"),
        (".", 2, "plm: .: is a folder"),
        ("none.plm", 2, "plm: none.plm: "),
        ("deep.plm", 1, "error[E01"),
        ("deep.rs", 1, "error[E01"),
        ("garbage.plm", 1, "error[E01"),
        ("escaped.plm", 1, "error[E01"),
        ("outside.plm", 1, "error[E04"),
    ] {
        let said = plm_in(&folder, &["check", file], b"");
        assert_eq!(said.code, code, "{file}: {}", &said.errors[..said.errors.len().min(400)]);
        assert!(
            said.errors.contains(message) && !said.errors.contains("bug in plm"),
            "{file}: {}",
            said.errors
        );
    }
    let said = plm(&["check", "-"], "");
    assert!(said.code == 1 && said.errors.contains("E0109"), "{said:?}");
}

#[test]
fn words_that_are_no_command_are_answered() {
    for (words, message) in [
        (&["chek"][..], "there is no command `chek`; `check` is one"),
        (&["check"], "name a file"),
        (
            &["check", "--jsn", "-"],
            "there is no option --jsn; `--json` is one\noptions of `plm check`: --json\n",
        ),
        (
            &["report", "--jsn", "-"],
            "there is no option --jsn; `--json` is one\noptions of `plm report`: --json, --equations, --mathml\n",
        ),
        (&["expand", "--jsn", "-"], "there is no option --jsn\noptions of `plm expand`: none\n"),
        (&["--json"], "there is no option --json"),
        (&["expand", "a", "b"], "one file at a time"),
    ] {
        let said = plm(words, "");
        assert!(said.code == 2 && said.errors.contains(message), "{said:?}");
    }
    assert_eq!(plm(&[], "").code, 2);
    assert!(plm(&["help"], "").output.contains("  plm check FILE… [--json]"));
    assert!(plm(&["check", "--help"], "").output.contains("--json"));
    assert_eq!(plm(&["--version"], "").output, format!("plm {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn expansion_and_report_are_those_of_the_library() {
    let path = root().join("plm-macros/compiler/examples/double_pendulum.plm");
    let text = fs::read_to_string(&path).unwrap();
    // The excerpt of a Rust file ends with its last token.
    let text = text.trim_end();
    let mut sources = plm_compiler::token::Sources::new();
    sources.add_text("double_pendulum.plm", text);
    let expansion = plm_compiler::compile(&mut sources);
    let said = plm(&["expand", "-"], text);
    let expected = format!("{}\n", expansion.code.unwrap().text());
    assert_eq!(said, Said { code: 0, output: expected.clone(), errors: String::new() });
    let said = plm(&["report", path.to_str().unwrap()], "");
    assert_eq!((said.code, said.output), (0, format!("{}\n", expansion.report.unwrap())));
    // Within Rust the same code comes out.
    let folder = folder();
    fs::write(folder.join("a.rs"), format!("fn main() {{}}\nplm::mechanism! {{\n{text}\n}}\n")).unwrap();
    assert_eq!(plm_in(&folder, &["expand", "a.rs"], b"").output, expected);
    let said = plm(&["expand", "-"], WRONG);
    assert!(said.code == 1 && said.output.is_empty() && said.errors.contains("E0302"));
    fs::write(folder.join("b.rs"), "fn main() {}").unwrap();
    assert_eq!(plm_in(&folder, &["report", "b.rs"], b"").code, 2);
}
