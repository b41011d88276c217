//! Names of files that every system can have, Windows and macOS among them.

use std::collections::BTreeSet;
use std::fs;

use super::{fail_with, root};

/// Names that Windows keeps for devices, whatever stands after their first full stop.
const DEVICES: [&str; 4] = ["con", "prn", "aux", "nul"];
/// Windows has 260 characters for a whole path; a checkout needs some for its folder.
const LONGEST_PATH: usize = 150;

/// What is wrong with a name, if anything.
fn fault(name: &str) -> Option<&'static str> {
    let stem = name.split('.').next().unwrap_or_default().to_ascii_lowercase();
    let is_port = ["com", "lpt"].iter().any(|port| {
        stem.strip_prefix(port)
            .is_some_and(|number| number.len() == 1 && number.as_bytes()[0].is_ascii_digit())
    });
    if DEVICES.contains(&stem.as_str()) || is_port {
        Some("a device of Windows")
    } else if name.chars().any(|letter| !letter.is_ascii() || letter < ' ' || "<>:\"\\|?*".contains(letter)) {
        Some("a letter that some system refuses or writes in another way")
    } else if name.ends_with(['.', ' ']) {
        Some("an end that Windows cuts off")
    } else {
        None
    }
}

#[test]
fn every_system_can_have_the_names_of_files() {
    let mut wrong = Vec::new();
    let mut folders = vec![String::new()];
    while let Some(folder) = folders.pop() {
        let mut seen = BTreeSet::new();
        for entry in fs::read_dir(root().join(&folder)).unwrap().map(Result::unwrap) {
            let Ok(name) = entry.file_name().into_string() else {
                wrong.push(format!("{folder}: a name that is no Unicode"));
                continue;
            };
            let path = format!("{folder}{name}");
            if ["target", ".git", "node_modules"].contains(&name.as_str()) {
                continue;
            }
            if !seen.insert(name.to_lowercase()) {
                wrong.push(format!("{path}: another name beside it differs in capitals alone"));
            }
            if path.len() > LONGEST_PATH {
                wrong.push(format!("{path}: {} characters", path.len()));
            }
            wrong.extend(fault(&name).map(|fault| format!("{path}: {fault}")));
            if entry.file_type().unwrap().is_dir() {
                folders.push(path + "/");
            }
        }
    }
    fail_with("names that some system cannot have", &wrong);
}

#[test]
fn names_that_some_system_refuses_are_found() {
    for name in ["aux.rs", "Con", "com1.txt", "a:b.md", "what?.svg", "end.", "größe.rs"] {
        assert!(fault(name).is_some(), "{name}");
    }
    for name in ["auxiliary.rs", "contract", "com.rs", "common1.txt", ".ci", "LICENSE-MIT", "c_step.rs.txt"] {
        assert!(fault(name).is_none(), "{name}");
    }
}
