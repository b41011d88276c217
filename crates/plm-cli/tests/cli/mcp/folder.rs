//! The folder of a server is the only one whose files calls read and write.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::{PENDULUM, cause, result};
use crate::folder;

/// A folder with a server's folder in it, and a secret beside that.
fn with_secret() -> (PathBuf, PathBuf) {
    let outside = folder();
    let inside = outside.join("inside");
    fs::create_dir_all(inside.join("sub")).unwrap();
    fs::write(outside.join("secret.plm"), PENDULUM).unwrap();
    fs::write(outside.join("secret.csv"), "0,0\n1,0\n0,1\n").unwrap();
    fs::write(inside.join("sub/own.plm"), PENDULUM).unwrap();
    (outside, inside)
}

fn refused(inside: &Path, tool: &str, arguments: &Value, why: &str) {
    let result = result(inside, &[], tool, arguments);
    assert!(cause(&result).contains(why), "{tool} {arguments}: {result}");
}

#[test]
fn files_of_the_folder_are_read_and_written() {
    let (_, inside) = with_secret();
    let own = json!({ "file": "sub/own.plm" });
    assert_eq!(result(&inside, &[], "check", &own)["structuredContent"]["errors"], 0);
    let drawn = json!({ "file": "./sub/own.plm", "to": "made/a.svg" });
    assert_eq!(result(&inside, &[], "picture", &drawn)["isError"], false);
    assert!(fs::read_to_string(inside.join("made/a.svg")).unwrap().starts_with("<svg"));
    // From elsewhere the server's folder is that of the option.
    let elsewhere = result(&folder(), &["--folder", inside.to_str().unwrap()], "check", &own);
    assert_eq!(elsewhere["isError"], false, "{elsewhere}");
}

#[test]
fn a_way_up_is_refused() {
    let (outside, inside) = with_secret();
    for file in ["../secret.plm", "sub/../../secret.plm", "sub/../sub/own.plm", ".."] {
        refused(&inside, "check", &json!({ "file": file }), "outside the folder of the server");
    }
    refused(&inside, "picture", &json!({ "text": PENDULUM, "to": "../a.svg" }), "outside the folder");
    let export = json!({ "text": PENDULUM, "format": "c_source", "to": "../made" });
    refused(&inside, "export", &export, "outside the folder");
    let run = json!({ "text": PENDULUM, "until": 1, "inputs": "../secret.csv" });
    refused(&inside, "run", &run, "outside the folder");
    assert!(!outside.join("a.svg").exists() && !outside.join("made").exists());
}

#[test]
fn an_absolute_path_is_refused() {
    let (outside, inside) = with_secret();
    let [secret, own] = [outside.join("secret.plm"), inside.join("sub/own.plm")];
    for file in [secret, own] {
        refused(&inside, "check", &json!({ "file": file }), "relative to the folder of the server");
    }
    let to = json!({ "text": PENDULUM, "to": outside.join("a.svg") });
    refused(&inside, "picture", &to, "relative to the folder");
    assert!(!outside.join("a.svg").exists());
}

#[cfg(unix)]
#[test]
fn a_link_is_refused() {
    use std::os::unix::fs::symlink;
    let (outside, inside) = with_secret();
    symlink(outside.join("secret.plm"), inside.join("link.plm")).unwrap();
    symlink(&outside, inside.join("up")).unwrap();
    symlink(outside.join("new.svg"), inside.join("new.svg")).unwrap();
    for file in ["link.plm", "up/secret.plm"] {
        refused(&inside, "check", &json!({ "file": file }), "leads through a link");
    }
    for to in ["new.svg", "up/a.svg"] {
        refused(&inside, "picture", &json!({ "text": PENDULUM, "to": to }), "leads through a link");
    }
    assert!(!outside.join("new.svg").exists() && !outside.join("a.svg").exists());
}

#[test]
fn a_declaration_names_no_file_outside() {
    let (outside, inside) = with_secret();
    let with = |file: &str| PENDULUM.replace("port pivot", &format!("contour: {file:?}; port pivot"));
    for (file, why) in [
        ("../secret.csv".to_owned(), "outside the folder"),
        (outside.join("secret.csv").to_str().unwrap().to_owned(), "relative to the folder"),
    ] {
        for tool in ["check", "picture", "assemble"] {
            refused(&inside, tool, &json!({ "text": with(&file) }), why);
        }
        fs::write(inside.join("sub/named.plm"), with(&file)).unwrap();
        refused(&inside, "check", &json!({ "file": "sub/named.plm" }), why);
        let rust = format!("plm::mechanism! {{ {} }}", with(&file));
        fs::write(inside.join("sub/named.rs"), rust).unwrap();
        refused(&inside, "check", &json!({ "file": "sub/named.rs" }), why);
    }
    // From a folder below, a way up within is one too.
    fs::write(inside.join("plate.csv"), "0,0\n1,0\n0,1\n").unwrap();
    let own = result(&inside, &[], "check", &json!({ "text": with("plate.csv") }));
    assert_eq!(own["structuredContent"]["errors"], 0, "{own}");
}

#[test]
fn names_that_begin_as_options_are_files() {
    let (_, inside) = with_secret();
    fs::write(inside.join("--json"), PENDULUM).unwrap();
    let own = result(&inside, &[], "assemble", &json!({ "file": "--json" }));
    assert_eq!(own["structuredContent"]["freedoms"], 1, "{own}");
    refused(&inside, "check", &json!({ "file": "-" }), "no name of a file");
    refused(&inside, "check", &json!({ "file": "missing.plm" }), "missing.plm: ");
}
