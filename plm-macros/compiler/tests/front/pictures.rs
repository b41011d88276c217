//! Contours, depths and sizes: what pictures need.

use plm_cas::Expr;
use plm_compiler::compile;
use plm_compiler::diag::Diagnostics;
use plm_compiler::front::parse_and_resolve;
use plm_compiler::model::Model;
use plm_compiler::token::Sources;

use crate::support::Values;

/// The model of a declaration that names files.
fn resolve(text: &str, files: &[(&str, &str)]) -> Model {
    let (mut sources, mut sink) = (Sources::new(), Diagnostics::new());
    sources.add_text("declaration", text);
    for (file, content) in files {
        sources.add_file(file, Ok((*content).to_string()));
    }
    let model = parse_and_resolve(&mut sources, &mut sink);
    assert!(!sink.has_errors(), "{:?}", sink.sorted());
    model.unwrap()
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

/// In micrometres, so that they can be compared.
fn micrometres(model: &Model, values: &Values, exprs: &[Expr]) -> Vec<i64> {
    exprs.iter().map(|&expr| (1e6 * values.at(model, expr)).round() as i64).collect()
}

/// From G, in the axes of the body; they follow the parameters.
#[test]
fn contours_count_from_the_centre_of_gravity() {
    let model = resolve(MECHANISM, &[("plate.csv", PLATE)]);
    let mut values = Values::of(&model);
    let contours = |values: &Values| {
        let points = |body: usize| model.bodies[body].contour.iter().flat_map(|at| at.components());
        [0, 1, 2].map(|body| micrometres(&model, values, &points(body).collect::<Vec<Expr>>()))
    };
    let [arm, drawn, plate] = contours(&values);
    assert_eq!(arm, [-101_000, -10_000, -80_000, -10_000, -80_000, 10_000]);
    assert_eq!(drawn, [0, 0, 0, -40_000, 1_000_000, 0]);
    assert_eq!(plate, [0, 0, 200_000, 0, 200_000, 50_000]);
    values.set(model.params[0].symbol, 0.1);
    assert_eq!(contours(&values)[1], [0, 0, 0, -100_000, 1_000_000, 0]);
}

#[test]
fn depths_and_sizes_stand_where_they_are_given() {
    let model = resolve(MECHANISM, &[("plate.csv", PLATE)]);
    let values = Values::of(&model);
    let depths = model.bodies.iter().map(|body| body.depth).chain(model.ground.iter().map(|port| port.depth));
    let depths: Vec<_> =
        depths.map(|depth| depth.map(|depth| micrometres(&model, &values, &[depth])[0])).collect();
    assert_eq!(depths, [Some(100_000), None, None, Some(-200_000), Some(30_000), None]);
    let sizes = model.instances.iter().flat_map(|part| part.sizes.iter().map(|size| (&part.name, size)));
    let sizes = sizes.map(|(part, size)| {
        (format!("{part}.{}", size.name), micrometres(&model, &values, &[size.value])[0])
    });
    let expected = [
        ("first.pin_diameter", 20_000),
        ("second.pin_diameter", 0),
        ("third.pin_diameter", 0),
        ("push.free_length", 0),
        ("push.piston_diameter", 50_000),
        ("push.rod_diameter", 20_000),
    ];
    assert_eq!(sizes.collect::<Vec<_>>(), expected.map(|(name, size)| (name.to_owned(), size)));
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
