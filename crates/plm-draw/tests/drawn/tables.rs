//! Texts, gestures, and the texts that they make.

use plm_draw::{
    Dimension, Drag, End, Gesture, Picture, Placed, PortName, Refusal, Sheet, Typed, applied, draw,
};

use crate::support::compiled;

/// A four-bar in several forms of writing.
pub(crate) const TEXT: &str = "\
pub P {
    ground { port o: (0, 0) m; port d: (30, 0) cm; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 10 cm); port a: (-5, 0) cm; port b: (5, 0) cm; start angle: 90 deg; }
    body rod { mass: 1 kg; inertia: 1 kg*m^2; port b: (0 m, -0.1 m); port c: (0, 0.2 m); port tip: (0.1, 0) m; start angle: -60 deg; }
    revolute o(ground.o, crank.a);
    revolute b(crank.b, rod.b);
    output crank.angle, rod.angle, b.force;
}
";

pub(crate) fn port(name: &str) -> PortName {
    let (owner, port) = name.split_once('.').unwrap();
    PortName::new(owner, port)
}

/// The text after a gesture, with the picture of the compiler.
pub(crate) fn made(text: &str, gesture: &Gesture) -> Result<String, Refusal> {
    let picture = compiled(text).picture.unwrap_or_default();
    draw(&Sheet::read(text, None), &picture, gesture).map(|drawn| applied(text, &drawn.edits))
}

/// The lines of one text that the other has not.
pub(crate) fn new_lines(before: &str, after: &str) -> String {
    after
        .lines()
        .filter(|line| !before.lines().any(|old| old == *line))
        .map(|line| line.trim().to_owned() + "\n")
        .collect()
}

pub(crate) fn drag(name: &str, to: [f64; 2], free: bool) -> Gesture {
    Gesture::Drag(Drag { port: port(name), to, grid: 1e-3, free })
}

#[test]
fn a_bar_has_another_length_and_angle() {
    // From (0, 0) to (0.1, 0): a bar of 10 cm that pointed upwards; the rod stays, and its port goes to where the crank ends.
    let text = made(TEXT, &drag("crank.b", [0.08, 0.06], false)).unwrap();
    let crank = "port a: (-5, 0) cm; port b: (5, 0) cm; start angle: 36.87 deg;";
    assert!(text.contains(crank), "{text}");
    let longer = made(TEXT, &drag("crank.b", [0.12, 0.16], false)).unwrap();
    let crank = "inertia: rod(1 kg, 20 cm); port a: (-10, 0) cm; port b: (10, 0) cm; start angle: 53.13 deg;";
    assert!(longer.contains(crank), "{longer}");
    assert!(
        !longer.contains("port b: (0 m, -0.1 m)")
            && longer.contains("port c: (0, 0.2 m); port tip: (0.1, 0) m"),
        "{longer}"
    );
}

#[test]
fn numbers_stay_in_their_units() {
    let text = made(TEXT, &drag("ground.d", [0.2505, -0.0125], false)).unwrap();
    assert_eq!(new_lines(TEXT, &text), "ground { port o: (0, 0) m; port d: (25.05, -1.25) cm; }\n");
    // A zero without a unit gets that of its neighbour.
    let compiled = compiled(TEXT).picture.unwrap();
    let at = compiled.port(&port("rod.c")).unwrap().clone();
    let (sin, cos) = at.angle.sin_cos();
    let to = [at.at[0] + 0.02 * cos, at.at[1] + 0.02 * sin];
    let text = made(TEXT, &drag("rod.c", to, true)).unwrap();
    assert!(text.contains("port c: (0.02 m, 0.2 m);"), "{text}");
}

#[test]
fn a_prescribed_angle_keeps_its_ray() {
    let driven =
        TEXT.replace("    output", "    constraint turns: crank.angle = 90 deg + 1 rad/s*t;\n    output");
    let text = made(&driven, &drag("crank.b", [0.03, 0.2], false)).unwrap();
    let crank = "inertia: rod(1 kg, 20 cm); port a: (-10, 0) cm; port b: (10, 0) cm; start angle: 90 deg;";
    assert!(text.contains(crank), "{text}");
}

#[test]
fn a_point_with_a_name_is_two_numbers() {
    let text = "\
pub P {
    let p1 = (0, 0) mm;
    let p2 = (100, 50) mm;
    ground { port o: p1; }
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p1; port b: p2; }
    revolute pin1(ground.o, bar1.a);
}
";
    let moved = made(text, &drag("bar1.b", [0.12, 0.0], false)).unwrap();
    assert_eq!(new_lines(text, &moved), "let p2 = (120, 0) mm;\n");
    let moved = made(text, &drag("bar1.a", [-0.01, 0.02], false)).unwrap();
    assert_eq!(new_lines(text, &moved), "let p1 = (-10, 20) mm;\n");
    // A second bar has the point of the first one, and a third end that is dropped on the ground becomes its point.
    let ends = [End::Port(port("bar1.b")), End::Ground([0.2, 0.0])];
    let two = made(text, &Gesture::Bar { ends, grid: 1e-3 }).unwrap();
    let expected = "\
let steel = 7850 kg/m^3;
let p3 = (200, 0) mm;
ground { port g1: p3; }
body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p2; port b: p3; }
revolute pin2(bar1.b, bar2.a);
revolute pin3(ground.g1, bar2.b);
";
    assert_eq!(new_lines(text, &two), expected);
    assert_eq!(compiled(&two).problems, []);
}

#[test]
fn an_empty_sheet_becomes_a_pendulum() {
    let ends = [End::Ground([0.0, 0.0]), End::Point([0.3, -0.4])];
    let text = made("", &Gesture::Bar { ends, grid: 1e-3 }).unwrap();
    let expected = "\
pub Drawing {
    gravity: 9.81 m/s^2;
    let steel = 7850 kg/m^3;
    let p1 = (0, 0) mm;
    ground { port g1: p1; }
    let p2 = (300, -400) mm;
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p1; port b: p2; }
    revolute pin1(ground.g1, bar1.a);
}
";
    assert_eq!(text, expected);
    assert_eq!(compiled(&text).problems, []);
    let driven = made(&text, &Gesture::Motor { body: "bar1".to_owned() }).unwrap();
    assert_eq!(new_lines(&text, &driven), "constraint motor1: bar1.angle = 60 rev/min*t;\n");
    assert_eq!(compiled(&driven).problems, []);
    let twice = made(&driven, &Gesture::Motor { body: "bar1".to_owned() });
    assert_eq!(twice, Err(Refusal::Driven("bar1".to_owned())));
}

#[test]
fn a_four_bar_is_drawn_by_pointer() {
    let bar = |ends| Gesture::Bar { ends, grid: 1e-3 };
    let mut text = String::new();
    for gesture in [
        bar([End::Ground([0.0, 0.0]), End::Point([0.04, 0.06])]),
        bar([End::Port(port("bar1.b")), End::Point([0.24, 0.14])]),
        bar([End::Point([0.25, 0.15]), End::Ground([0.2, 0.0])]),
        Gesture::Merge {
            drag: Drag { port: port("bar3.a"), to: [0.0, 0.0], grid: 1e-3, free: false },
            onto: port("bar2.b"),
        },
        Gesture::Motor { body: "bar1".to_owned() },
    ] {
        text = made(&text, &gesture).unwrap();
        assert_eq!(plm_draw::layout::formatted(&text).as_ref(), Ok(&text));
    }
    let found = compiled(&text);
    assert_eq!(found.problems, [], "{text}");
    let at = |name| {
        found.picture.as_ref().and_then(|picture| picture.port(&port(name)).map(|port| port.at)).unwrap()
    };
    let [one, other] = [at("bar3.a"), at("bar2.b")];
    assert!((one[0] - other[0]).hypot(one[1] - other[1]) < 1e-12 && (one[0] - 0.24).abs() < 1e-12, "{text}");
    assert_eq!(text.matches("let p").count(), 5 - 1, "{text}");
}

#[test]
fn a_body_goes_with_all_that_names_it() {
    let text = made(TEXT, &Gesture::Delete { name: "rod".to_owned() }).unwrap();
    assert!(!text.contains("rod.") && !text.contains("revolute b"), "{text}");
    assert!(
        text.contains("output crank.angle;") && text.contains("revolute o(ground.o, crank.a);"),
        "{text}"
    );
    // A joint has the name of ports, which stay.
    let text = made(TEXT, &Gesture::Delete { name: "b".to_owned() }).unwrap();
    assert_eq!(new_lines(TEXT, &text), "output crank.angle, rod.angle;\n");
    let text = made(TEXT, &Gesture::DeletePort { port: port("ground.o") }).unwrap();
    assert!(!text.contains("revolute o") && text.contains("ground { port d: (30, 0) cm; }"), "{text}");
    assert_eq!(made(TEXT, &Gesture::Delete { name: "x".to_owned() }), Err(Refusal::Unknown("x".to_owned())));
}

#[test]
fn a_name_is_another_one_wherever_it_stands() {
    let text = made(TEXT, &Gesture::Rename { from: "rod".to_owned(), to: "coupler".to_owned() }).unwrap();
    // The function of this name stays.
    assert!(text.contains("rod(1 kg, 10 cm)") && text.contains("revolute b(crank.b, coupler.b);"), "{text}");
    assert!(text.contains("output crank.angle, coupler.angle, b.force;"), "{text}");
    let text = made(TEXT, &Gesture::RenamePort { from: port("crank.b"), to: "pin".to_owned() }).unwrap();
    assert!(
        text.contains("port pin: (5, 0) cm;") && text.contains("revolute b(crank.pin, rod.b);"),
        "{text}"
    );
    let rename = |to: &str| made(TEXT, &Gesture::Rename { from: "rod".to_owned(), to: to.to_owned() });
    assert_eq!(rename("crank"), Err(Refusal::Taken("crank".to_owned())));
    assert_eq!(rename("2b"), Err(Refusal::NoName("2b".to_owned())));
    assert_eq!(rename("mm"), Err(Refusal::NoName("mm".to_owned())));
}

#[test]
fn what_is_typed_is_what_stands_there() {
    let typed = |name: &str, dimension, text: &str| {
        made(TEXT, &Gesture::Typed(Typed { port: port(name), dimension, text: text.to_owned(), grid: 1e-3 }))
    };
    let text = typed("ground.d", Dimension::X, "7.50").unwrap();
    assert!(text.contains("port d: (7.50, 0) cm;"), "{text}");
    let text = typed("ground.d", Dimension::Y, "75 mm").unwrap();
    assert!(text.contains("port d: (30, 7.5) cm;"), "{text}");
    let text = typed("crank.b", Dimension::Angle, "30").unwrap();
    assert!(text.contains("port b: (5, 0) cm; start angle: 30 deg;"), "{text}");
    let text = typed("crank.b", Dimension::Length, "12 cm").unwrap();
    assert!(text.contains("rod(1 kg, 12 cm); port a: (-6, 0) cm; port b: (6, 0) cm;"), "{text}");
    for wrong in ["", "x", "7 kg", "1/2", "inf", "7."] {
        assert_eq!(typed("ground.d", Dimension::X, wrong), Err(Refusal::NoNumber(wrong.to_owned())));
    }
    assert_eq!(typed("rod.tip", Dimension::Length, "1"), Err(Refusal::NoBar(port("rod.tip"))));
}

#[test]
fn what_cannot_be_moved_is_told() {
    let text = TEXT
        .replace("(5, 0) cm", "(0.5*length, 0 m)")
        .replace("pub P {", "pub P {\n    param length = 10 cm;");
    let refused = made(&text, &drag("rod.b", [0.0, 0.0], false));
    let expected = Refusal::Expression { port: port("crank.b"), text: "(0.5*length, 0 m)".to_owned() };
    assert_eq!(refused, Err(expected));
    assert_eq!(made(TEXT, &drag("crank.x", [0.0, 0.0], false)), Err(Refusal::Unknown("crank.x".to_owned())));
    let zero = made(TEXT, &drag("crank.b", [0.0, 0.0], false));
    assert_eq!(zero, Err(Refusal::NoLength));
}

#[test]
fn a_bar_gets_a_third_pin() {
    let bar = |ends| Gesture::Bar { ends, grid: 1e-3 };
    let text = made("", &bar([End::Ground([0.0, 0.0]), End::Point([0.3, -0.4])])).unwrap();
    let put =
        |text: &str, body: &str, end| made(text, &Gesture::Port { body: body.to_owned(), end, grid: 1e-3 });
    let third = put(&text, "bar1", End::Point([0.1, 0.05])).unwrap();
    let bar1 = "port a: p1; port b: p2; port c: p3; }";
    assert!(third.contains("    let p3 = (100, 50) mm;\n") && third.contains(bar1), "{third}");
    assert_eq!(compiled(&third).problems, []);
    // A bar that ends there has its point.
    let second = made(&third, &bar([End::Port(port("bar1.c")), End::Point([0.5, 0.5])])).unwrap();
    assert!(
        second.contains("port a: p3; port b: p4; }") && second.contains("revolute pin2(bar1.c, bar2.a);"),
        "{second}"
    );
    // A port at a pin of another body is joined to it, on the ground to the ground.
    let joined = put(&second, "bar1", End::Port(port("bar2.b"))).unwrap();
    assert!(
        joined.contains("port c: p3; port d: p4; }") && joined.contains("revolute pin3(bar2.b, bar1.d);"),
        "{joined}"
    );
    let held = put(&text, "bar1", End::Ground([0.1, 0.1])).unwrap();
    assert!(
        held.contains("ground { port g2: p3; }") && held.contains("revolute pin2(ground.g2, bar1.c);"),
        "{held}"
    );
    // In axes of its own, which assembly has turned: it stands where the hand was, within the rounding of its numbers.
    let own = put(TEXT, "crank", End::Point([0.02, 0.05])).unwrap();
    assert!(own.contains("port b: (5, 0) cm; port c: ("), "{own}");
    let at = compiled(&own).picture.unwrap().port(&port("crank.c")).unwrap().at;
    assert!((at[0] - 0.02).hypot(at[1] - 0.05) < 1e-5, "{at:?}");
    assert_eq!(put(&text, "bar1", End::Point([0.3, -0.4])), Err(Refusal::NoLength));
    assert_eq!(put(&text, "bar2", End::Point([0.0, 0.1])), Err(Refusal::Unknown("bar2".to_owned())));
    let many = "pub P {\n    repeat i in 0..2 { body bar[i] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; } }\n}\n";
    assert_eq!(put(many, "bar[0]", End::Point([0.0, 0.1])), Err(Refusal::Repeated("bar[0]".to_owned())));
}

#[test]
fn a_pin_is_opened() {
    let text = made(TEXT, &Gesture::Unpin { port: port("crank.b") }).unwrap();
    assert!(!text.contains("revolute b") && text.contains("port b: (5, 0) cm"), "{text}");
    assert!(text.contains("output crank.angle, rod.angle;"), "{text}");
    let none = made(&text, &Gesture::Unpin { port: port("crank.b") });
    assert_eq!(none, Err(Refusal::Unknown("pin of crank.b".to_owned())));
}

#[test]
fn a_drawn_bar_has_a_typed_length_and_angle() {
    let ends = [End::Ground([0.0, 0.0]), End::Point([0.3, -0.4])];
    let text = made("", &Gesture::Bar { ends, grid: 1e-3 }).unwrap();
    let typed = |dimension, of: &str| {
        made(
            &text,
            &Gesture::Typed(Typed { port: port("bar1.b"), dimension, text: of.to_owned(), grid: 1e-3 }),
        )
    };
    let longer = typed(Dimension::Length, "1000 mm").unwrap();
    assert_eq!(new_lines(&text, &longer), "let p2 = (600, -800) mm;\n");
    let turned = typed(Dimension::Angle, "90 deg").unwrap();
    assert_eq!(new_lines(&text, &turned), "let p2 = (0, 500) mm;\n");
    // The number of a place is written as it was typed, though assembly rounds.
    let mut picture = compiled(&text).picture.unwrap();
    for placed in &mut picture.ports {
        placed.angle += 1e-17;
        placed.at[0] += 1e-17;
    }
    let of = Typed { port: port("bar1.b"), dimension: Dimension::Y, text: "-130.0".to_owned(), grid: 1e-3 };
    let drawn = draw(&Sheet::read(&text, None), &picture, &Gesture::Typed(of)).unwrap();
    assert_eq!(new_lines(&text, &applied(&text, &drawn.edits)), "let p2 = (300, -130.0) mm;\n");
    assert_eq!(typed(Dimension::Angle, "3 mm"), Err(Refusal::NoNumber("3 mm".to_owned())));
    assert_eq!(typed(Dimension::Length, "0"), Err(Refusal::NoLength));
}

/// A text that is being typed has a tree as far as it goes.
#[test]
fn half_a_text_is_drawn_on() {
    for end in ["    revolut o((", "    output crank.", "    body x { mass: 1 kg"] {
        let text = TEXT.split("    output").next().unwrap().to_owned() + end;
        let picture = Picture { ports: vec![Placed { name: port("ground.d"), at: [0.3, 0.0], angle: 0.0 }] };
        let drawn = draw(&Sheet::read(&text, None), &picture, &drag("ground.d", [0.2, 0.1], false)).unwrap();
        let made = applied(&text, &drawn.edits);
        assert_eq!(made, text.replace("(30, 0) cm", "(20, 10) cm"));
    }
}

#[test]
fn tools_join_two_ports() {
    let join = |tool: &str, ports: [&str; 2]| {
        made(TEXT, &Gesture::Join { tool: tool.to_owned(), ports: ports.map(port), grid: 1e-3 })
    };
    let text = join("spring", ["ground.d", "rod.tip"]).unwrap();
    assert!(
        new_lines(TEXT, &text)
            .starts_with("spring spring1(ground.d, rod.tip) { stiffness: 1000 N/m; free_length: ")
    );
    for tool in plm_draw::TOOLS {
        let text = join(tool.word, ["ground.d", "rod.tip"]).unwrap();
        let names = compiled(&text).problems.into_iter().filter(|(code, _)| code.starts_with("E02"));
        assert_eq!(names.count(), 0, "{}: {text}", tool.word);
    }
    assert_eq!(join("rope", ["ground.d", "rod.tip"]), Err(Refusal::Unknown("rope".to_owned())));
    assert_eq!(join("pin", ["rod.b", "rod.tip"]), Err(Refusal::Same(port("rod.b"), port("rod.tip"))));
}
