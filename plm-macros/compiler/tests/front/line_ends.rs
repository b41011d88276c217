//! Declarations whose lines end as on Windows: the same code, and the same places in messages.

use std::fs;
use std::path::Path;

use plm_compiler::compile;
use plm_compiler::token::Sources;

/// Messages and code of a declaration, which may name `plate.csv`.
fn answer(text: &str, contour: &str) -> String {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    for file in sources.named_files() {
        sources.add_file(&file, Ok(contour.to_owned()));
    }
    let expansion = compile(&mut sources);
    let messages = expansion.diagnostics.sorted().into_iter().map(|diagnostic| diagnostic.render(&sources));
    let mut answer: Vec<String> = messages.collect();
    answer.extend(expansion.code.map(|code| code.text()));
    answer.join("\n")
}

/// With a carriage return before each line feed.
fn windows(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\n', "\r\n")
}

/// Both answers are the same; else their first lines that are not are shown.
fn same(text: &str, contours: [&str; 2], name: &str) -> String {
    let (one, other) = (answer(text, contours[0]), answer(&windows(text), contours[1]));
    let differs = one.lines().zip(other.lines()).find(|(one, other)| one != other);
    assert!(differs.is_none() && one.len() == other.len(), "{name}: {differs:?}");
    one
}

#[test]
fn wrong_declarations_are_answered_at_the_same_places() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/diagnostics");
    let mut files: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "plm"));
    files.sort();
    assert!(files.len() > 50, "{} declarations", files.len());
    for file in files.iter().step_by(3) {
        let text = fs::read_to_string(file).unwrap();
        let one = same(&text, [""; 2], &file.display().to_string());
        assert!(!one.contains('\r'), "{}", file.display());
    }
}

#[test]
fn contours_and_documentation_are_the_same() {
    let text = "/// A plate,\n/// in two lines.\npub Plate {\n    ground { port o: (0, 0) m; }\n    body plate {\n        mass: 1 kg;\n        \
        inertia: 1 kg*m^2;\n        port o: (0, 0) m;\n        contour: \"plate.csv\";\n    }\n    revolute pin(ground.o, plate.o);\n}\n";
    let contour = "x (mm), y (mm)\n0, 0\n400, 0\n400, 300\n0, 300\n";
    let one = same(text, [contour, &windows(contour)], "Plate");
    assert!(one.contains("/// A plate,") && one.contains("\"plate.csv\""), "{one}");
}
