//! `plm export`: what a project holds, which commands it tells, what is refused. `cargo xtask ci --only package-programs` builds one.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use super::{Said, folder, plm_in};

const BAR: &str = "/// A bar.\npub TwoBars {\n    ground { port o: (0, 0) m; }\n    body bar {\n        density: 7850 kg/m^3;\n        thickness: 8 mm;\n        contour: \"bar.csv\";\n        port pin: (0, 0) m;\n    }\n    revolute pin(ground.o, bar.pin);\n}\n";

/// A folder with a declaration and the file that it names.
fn declared() -> PathBuf {
    let folder = folder();
    fs::write(folder.join("bar.plm"), BAR).unwrap();
    fs::write(folder.join("bar.csv"), "0, 0\n1, 0\n1, 0.1\n0, 0.1\n").unwrap();
    folder
}

fn export(folder: &Path, words: &[&str]) -> Said {
    plm_in(folder, &[&["export"], words].concat(), b"")
}

#[test]
fn a_package_has_the_declaration_its_files_and_a_program() {
    let folder = declared();
    for (option, commands) in [
        ("--rust", "cargo run --release -- --until 5 --csv outputs.csv\n"),
        ("--c", "cargo run --release -- --c c\n"),
        ("--fmu", "cargo run --release -- --fmu two_bars.fmu\n"),
        (
            "--python",
            "pip install maturin numpy\ncargo run --release -- --python wheels\npip install wheels/two_bars-*.whl\n",
        ),
    ] {
        let to = option.trim_start_matches('-');
        let written = format!(
            "written: {to}/Cargo.toml\nwritten: {to}/bar.csv\nwritten: {to}/src/main.rs\n\ncd {to}\n"
        );
        let said = export(&folder, &["bar.plm", option, to]);
        assert_eq!(said, Said { code: 0, output: written + commands, errors: String::new() });
    }
    let read = |file: &str| fs::read_to_string(folder.join("rust").join(file)).unwrap();
    assert_eq!(read("bar.csv"), fs::read_to_string(folder.join("bar.csv")).unwrap());
    let manifest = read("Cargo.toml");
    assert!(
        manifest.contains("name = \"two_bars\"")
            && manifest.contains("version = \"0.1.0\", features = [\"view\"]")
    );
    let checked = plm_in(&folder.join("rust"), &["check", "src/main.rs"], b"");
    assert_eq!((checked.code, checked.errors.as_str()), (0, ""));
    assert!(read("src/main.rs").ends_with("plm::view::Program::new(TwoBars::new()).main()\n}\n"));
    // A clone in place of the registry.
    fs::create_dir(folder.join("clone")).unwrap();
    fs::write(folder.join("clone/Cargo.toml"), "").unwrap();
    assert_eq!(export(&folder, &["bar.plm", "--rust", "rust", "--plm", "clone", "--force"]).code, 0);
    let path = std::path::absolute(folder.join("clone")).unwrap();
    assert!(read("Cargo.toml").contains(&format!("path = {:?}", path.display().to_string())));
}

#[test]
fn a_declaration_of_rust_source_is_named_and_has_its_parts() {
    let folder = folder();
    let bodies = "ground { port o: (0, 0) m; } body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }";
    let text = format!(
        "plm::parts! {{ pub own {{ part drag(a: frame) {{ force on a: -1 N*s/m*a.velocity; }} }} }}\n\
         mechanism! {{ use own; pub One {{ {bodies} prismatic p(ground.o, b.o); drag d(b.o); }} }}\n\
         mechanism! {{ pub Other {{ {bodies} revolute r(ground.o, b.o); }} }}\n"
    );
    fs::write(folder.join("two.rs"), text).unwrap();
    let said = export(&folder, &["two.rs", "--rust", "made"]);
    assert_eq!(said.errors, "plm: two.rs: `--name` says which of these: One, Other\n");
    assert_eq!(said.code, 2);
    let said = export(&folder, &["two.rs", "--rust", "made", "--name", "Third"]);
    assert_eq!(said.errors, "plm: two.rs: there is no `Third` in it: One, Other\n");
    let said = export(&folder, &["two.rs", "--rust", "made", "--name", "One"]);
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let main = fs::read_to_string(folder.join("made/src/main.rs")).unwrap();
    assert!(main.contains("    parts { part drag(a: frame)") && !main.contains("use own"), "{main}");
    let checked = plm_in(&folder, &["check", "made/src/main.rs"], b"");
    assert_eq!((checked.code, checked.errors.as_str()), (0, ""), "{main}");
}

#[test]
fn a_c_source_is_three_files_and_what_it_has_not_is_named() {
    let folder = declared();
    for (words, real) in
        [(["--c-source", "c"].as_slice(), "double"), (&["--c-source", "c32", "--single"], "float")]
    {
        let said = export(&folder, &[&["bar.plm"], words].concat());
        let written =
            ["two_bars.h", "two_bars.c", "plm_math.h"].map(|file| format!("written: {}/{file}\n", words[1]));
        assert_eq!(said, Said { code: 0, output: written.concat(), errors: String::new() });
        let header = fs::read_to_string(folder.join(words[1]).join("two_bars.h")).unwrap();
        assert!(header.contains(&format!("int two_bars_step(two_bars *self, {real} h);")), "{header}");
    }
    // The same for a GPU, beside kernels over it.
    let said = export(&folder, &["bar.plm", "--cuda", "gpu", "--single"]);
    let files = [
        "two_bars.h",
        "two_bars.c",
        "plm_math.h",
        "two_bars_batch.h",
        "two_bars_batch.c",
        "two_bars.cu",
        "two_bars_run.c",
    ];
    let written = files.map(|file| format!("written: gpu/{file}\n"));
    assert_eq!(said, Said { code: 0, output: written.concat(), errors: String::new() });
    let header = fs::read_to_string(folder.join("gpu/two_bars_batch.h")).unwrap();
    assert!(header.contains("two_bars_batch_steps(two_bars_batch all, float h, int steps);"), "{header}");
    let rubbing = BAR
        .replace("bar.pin);", "bar.pin) { friction: 1 N*m; }")
        .replace("contour: \"bar.csv\";", "contour: circle(10 cm);");
    fs::write(folder.join("rubs.plm"), rubbing).unwrap();
    for option in ["--c-source", "--cuda"] {
        let said = export(&folder, &["rubs.plm", option, "none"]);
        assert!(said.code != 0 && said.errors.contains("`pin") && !folder.join("none").exists(), "{said:?}");
    }
}

/// It is written without Rust and without a compiler; the tests of plm-source give it to an importer.
#[test]
fn an_fmu_with_sources_is_one_file() {
    let folder = declared();
    for (version, listed) in [("2", "<SourceFiles>"), ("3", "fmiVersion=\"3.0\"")] {
        let file = format!("two_bars{version}.fmu");
        let said = export(&folder, &["bar.plm", "--fmu-source", &file, "--fmi", version]);
        assert_eq!(said, Said { code: 0, output: format!("written: {file}\n"), errors: String::new() });
        let bytes = fs::read(folder.join(&file)).unwrap();
        let has = |name: &str| bytes.windows(name.len()).any(|part| part == name.as_bytes());
        assert!(has("modelDescription.xml") && has("sources/two_bars_fmi.c"));
        assert_eq!(has("sources/buildDescription.xml"), version == "3", "{listed}");
    }
    for (words, why) in [
        (["--fmu-source", "a.fmu", "--fmi", "1"].as_slice(), "--fmi is 2 or 3, not `1`"),
        (&["--fmu-source", "a.fmu", "--interface", "both"], "--interface is model-exchange or co-simulation"),
        (&["--fmu-source", "a.fmu", "--single"], "--single is of --c-source"),
        (&["--c-source", "a", "--fmi", "2"], "--fmi and --interface are of --fmu-source"),
    ] {
        let said = export(&folder, &[&["bar.plm"], words].concat());
        assert!(said.code == 2 && said.errors.contains(why), "{said:?}");
    }
}

#[test]
fn what_cannot_be_exported_is_told_and_nothing_is_written() {
    let folder = declared();
    let refused = |text: &str, words: &[&str]| {
        let said = plm_in(&folder, &[&["export", "-"], words].concat(), text.as_bytes());
        assert!(!folder.join("made").exists(), "{said:?}");
        (said.code, said.errors)
    };
    let (code, errors) = refused("pub A { body b { mass: 1; inertia: 1 kg*m^2; } }", &["--c", "made"]);
    assert!(code == 1 && errors.starts_with("error[E0302]"), "{errors}");
    let param =
        BAR.replace("ground {", "param l: m; ground {").replace("\"bar.csv\"", "(0, 0), (1, 0), (1, 0.1) m");
    let (code, errors) = refused(&param, &["--c", "made"]);
    assert!(code == 2 && errors.contains("plm: the parameter `l` has no default"), "{errors}");
    assert_eq!(refused(BAR, &[]).0, 2);
    assert_eq!(refused(BAR, &["--c", "made", "--rust", "made"]).0, 2);
    let (code, errors) = refused(BAR, &["--c", "made", "--plm", "none"]);
    assert!(code == 2 && errors.starts_with("plm: --plm none: "), "{errors}");
    // A file that a person has changed is kept.
    assert_eq!(export(&folder, &["bar.plm", "--rust", "made"]).code, 0);
    fs::write(folder.join("made/src/main.rs"), "fn main() {}\n").unwrap();
    let said = export(&folder, &["bar.plm", "--rust", "made"]);
    assert_eq!(
        (said.code, said.errors.as_str()),
        (2, "plm: made/src/main.rs has other contents: `--force` writes over it\n")
    );
    assert_eq!(export(&folder, &["bar.plm", "--rust", "made", "--force"]).code, 0);
    assert!(fs::read_to_string(folder.join("made/src/main.rs")).unwrap().contains("TwoBars"));
}

/// Cargo is a program that tells how it was called.
#[cfg(unix)]
#[test]
fn cargo_is_called_in_the_folder_of_the_package() {
    use std::os::unix::fs::PermissionsExt;

    let folder = declared();
    let cargo = folder.join("cargo");
    fs::write(
        &cargo,
        "#!/bin/sh\n[ -f src/main.rs ] && echo \"$@\"\n[ \"$3\" = -- ] && [ \"$4\" != --fmu ]\n",
    )
    .unwrap();
    fs::set_permissions(&cargo, fs::Permissions::from_mode(0o755)).unwrap();
    let build = |option: &str| {
        let mut plm = Command::new(env!("CARGO_BIN_EXE_plm"));
        let words = ["export", "bar.plm", option, "made", "--build"];
        let said = plm.args(words).current_dir(&folder).env("CARGO", &cargo).output().unwrap();
        (said.status.code(), String::from_utf8(said.stdout).unwrap())
    };
    let (code, output) = build("--python");
    assert!(code == Some(0) && output.ends_with("\nrun --release -- --python wheels\n"), "{output}");
    // What cargo cannot build is no success.
    assert_eq!(build("--fmu").0, Some(1));
}

#[test]
fn a_link_holds_the_declaration_as_it_was_written() {
    let folder = folder();
    let bar = "/// A bar.\npub Bar {\n    ground { port o: (0, 0) m; }\n    body bar { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }\n    revolute pin(ground.o, bar.o);\n}\n";
    fs::write(folder.join("bar.plm"), bar).unwrap();
    let page = "https://example.org/playground.html";
    let link = plm::view::playground_link(page, bar).unwrap();
    let said = export(&folder, &["bar.plm", "--link", page]);
    assert_eq!(said, Said { code: 0, output: link + "\n", errors: String::new() });
    // What it names a link does not hold.
    let said = export(&declared(), &["bar.plm", "--link", page]);
    assert_eq!((said.code, said.output.as_str()), (2, ""));
    assert_eq!(said.errors, "plm: the declaration names the file bar.csv, which a link does not hold\n");
}
