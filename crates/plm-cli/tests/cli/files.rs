//! Files that are written over: whole, or as they were.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

use crate::{folder, plm_in};

/// Long enough that its layout does not fit where 1024 bytes may be written.
fn long() -> String {
    let body = |k| format!("body b{k}{{mass:1 kg;inertia:1 kg*m^2;port p:(0,0) m;}}\n");
    format!("pub A {{\n{}}}\n", (0..100).map(body).collect::<String>())
}

/// Runs the program where no file may be longer than 1 KiB, as on a disk that is full: `(exit code, messages)`.
fn on_a_full_disk(folder: &Path, words: &str) -> (i32, String) {
    // POSIX counts in blocks of 512 bytes, bash in KiB.
    let script = format!("trap '' XFSZ; ulimit -f 1; exec {} {words}", env!("CARGO_BIN_EXE_plm"));
    let done = Command::new("sh").args(["-c", &script]).current_dir(folder).output().unwrap();
    (done.status.code().unwrap(), String::from_utf8_lossy(&done.stderr).into_owned())
}

/// Names of all files of a folder.
fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[test]
fn a_full_disk_leaves_files_as_they_were() {
    let folder = folder();
    let text = long();
    fs::write(folder.join("long.plm"), &text).unwrap();
    fs::write(folder.join("short.plm"), "pub A{}\n").unwrap();
    let (code, said) = on_a_full_disk(&folder, "fmt long.plm short.plm");
    assert!(code == 2 && said.contains("long.plm: ") && said.contains("it is as it was"), "{said}");
    assert_eq!(fs::read_to_string(folder.join("long.plm")).unwrap(), text);
    // The next file is laid out all the same.
    assert_eq!(fs::read_to_string(folder.join("short.plm")).unwrap(), "pub A {}\n");
    let bar = "pub Bar { gravity: 9.81 m/s^2; ground { port o: (0, 0) m; } \
               body b { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 1) m; start angle: 1 rad, locked; } \
               revolute r(ground.o, b.p); output b.angle; }";
    fs::write(folder.join("bar.plm"), bar).unwrap();
    for written in [
        "run bar.plm --until 1 --out old",
        "run bar.plm --until 1 --view old",
        "export bar.plm --force --mjcf old",
    ] {
        fs::write(folder.join("old"), "old").unwrap();
        let (code, said) = on_a_full_disk(&folder, written);
        assert!(code == 2 && said.contains("old: "), "{written}: {code} {said}");
        assert_eq!(fs::read_to_string(folder.join("old")).unwrap(), "old", "{written}");
    }
    assert_eq!(names(&folder), ["bar.plm", "long.plm", "old", "short.plm"]);
}

#[test]
fn a_file_that_is_laid_out_keeps_its_permissions_and_links() {
    let folder = folder();
    fs::create_dir(folder.join("elsewhere")).unwrap();
    let file = folder.join("elsewhere/a.plm");
    fs::write(&file, "pub A{}\n").unwrap();
    fs::set_permissions(&file, fs::Permissions::from_mode(0o640)).unwrap();
    symlink("elsewhere/a.plm", folder.join("link.plm")).unwrap();
    assert_eq!(plm_in(&folder, &["fmt", "link.plm"], b"").code, 0);
    assert!(folder.join("link.plm").is_symlink());
    assert_eq!(fs::read_to_string(&file).unwrap(), "pub A {}\n");
    assert_eq!(fs::metadata(&file).unwrap().permissions().mode() & 0o777, 0o640);
    assert_eq!(names(&folder.join("elsewhere")), ["a.plm"]);
}

#[test]
fn a_device_is_written_as_it_is() {
    let folder = folder();
    fs::write(folder.join("a.plm"), "pub A { body b { mass: 1 kg; inertia: 1 kg*m^2; } }").unwrap();
    for (device, expected) in [("/dev/null", 0), ("/dev/full", 2)] {
        let said = plm_in(&folder, &["run", "a.plm", "--until", "1", "--out", device], b"");
        assert_eq!(said.code, expected, "{device}: {}", said.errors);
    }
}
