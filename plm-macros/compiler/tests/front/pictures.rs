//! Contours, depths and sizes: what pictures need, as constants of the emitted code.

use plm_compiler::compile;
use plm_compiler::token::Sources;

/// The constant of this name in what is emitted.
fn constant(text: &str, files: &[(&str, &str)], name: &str) -> String {
    let mut sources = Sources::new();
    sources.add_text("declaration", text);
    for (file, content) in files {
        sources.add_file(file, Ok((*content).to_string()));
    }
    let expansion = compile(&mut sources);
    assert!(!expansion.diagnostics.has_errors(), "{:?}", expansion.diagnostics.sorted());
    let text = expansion.code.unwrap().text();
    let line = text.lines().find(|line| line.contains(&format!("pub const {name}:"))).unwrap();
    line.split_once(" = ").unwrap().1.to_string()
}

const MECHANISM: &str = r#"pub P {
    param width: m = 40 mm;
    ground { port o: (0, 0) m, depth: -0.2 m; port p: (1, 0) m, angle: 10 deg, depth: 30 mm; port q: (2, 0) m; }
    body arm {
        mass: 1 kg; inertia: 1 kg*m^2; centre: (0.1, 0) m; port o: (0, 0) m; depth: 0.1 m;
        contour: (-0.1, -1), (2, -1), (2, 1) cm;
    }
    body drawn {
        mass: 1 kg; inertia: 1 kg*m^2; coordinates: absolute; drawing_angle: 90 deg; centre: (1, 2) m;
        port o: (1, 2) m; contour: (1 m, 2 m), (1 m + width, 2 m), (1 m, 3 m);
    }
    body plate { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; contour: "plate.csv"; }
    revolute first(ground.o, arm.o) { pin_diameter: width/2; }
    revolute second(arm.o, drawn.o);
    revolute third(drawn.o, plate.o);
    jack push(arm.o, plate.o) { piston_diameter: 50 mm; rod_diameter: 0.02 m; }
}"#;

const PLATE: &str = "x (mm), y (mm)\n0, 0\n200, 0\n200, 50\n";

/// From G, in the axes of the body, in metres, parameters at their defaults.
#[test]
fn contours_are_constants_from_the_centre_of_gravity() {
    assert_eq!(
        constant(MECHANISM, &[("plate.csv", PLATE)], "CONTOURS"),
        "[(\"arm\", &[[-0.101, -0.01], [-0.08, -0.01], [-0.08, 0.01]]), \
         (\"drawn\", &[[0.0, 0.0], [0.0, -0.04], [1.0, 0.0]]), \
         (\"plate\", &[[0.0, 0.0], [0.2, 0.0], [0.2, 0.05]])];"
    );
}

#[test]
fn depths_and_sizes_are_constants_where_they_are_given() {
    let files = [("plate.csv", PLATE)];
    assert_eq!(
        constant(MECHANISM, &files, "DEPTHS"),
        "[(\"arm\", 0.1), (\"ground.o\", -0.2), (\"ground.p\", 0.03)];"
    );
    assert_eq!(
        constant(MECHANISM, &files, "SIZES"),
        "[(\"first.pin_diameter\", 0.02), (\"push.piston_diameter\", 0.05), (\"push.rod_diameter\", 0.02)];"
    );
    let bare = "pub P { body a { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; } }";
    for name in ["CONTOURS", "DEPTHS", "SIZES"] {
        assert_eq!(constant(bare, &[], name), "[];");
    }
}

/// rustc is told of the files, so that cargo builds anew when one changes.
#[test]
fn files_are_named_to_those_who_read_them() {
    let mut sources = Sources::new();
    sources.add_text("declaration", MECHANISM);
    assert_eq!(sources.named_files(), ["plate.csv"]);
    sources.add_file("plate.csv", Ok(PLATE.to_string()));
    let text = compile(&mut sources).code.unwrap().text();
    assert!(text.contains("include_bytes!(concat!(env!(\"CARGO_MANIFEST_DIR\"), \"/\", \"plate.csv\"))"));
}
