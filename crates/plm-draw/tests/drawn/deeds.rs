//! Gestures on what is there: copies, mirror images, locked dimensions, values of parameters.

use plm_draw::{Drag, End, Gesture, PortName, Refusal, Sheet, applied, draw, layout};

use crate::support::compiled;

/// Two bars on the ground, as a hand draws them, and a crank in axes of its own.
const TEXT: &str = "\
pub P {
    param speed: rev/min = 60 rev/min;
    param ratio: 1 = 2*speed/(1 rev/min);
    let p1 = (0, 0) mm;
    let p2 = (30, 40) mm;
    let p3 = (60, 0) mm;
    ground { port g1: p1; port g2: p3; port g3: (30, 0) cm; }
    body bar1 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p1; port b: p2; port s: p1, axis: p2 - p1; }
    body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p2; port b: p3; }
    body crank { mass: 1 kg; inertia: rod(1 kg, 10 cm); port a: (-5, 0) cm; port b: (5, 0) cm; start x: 0.3 m; start y: 5 cm; start angle: 90 deg; }
    revolute pin1(ground.g1, bar1.a);
    revolute pin2(bar1.b, bar2.a);
    revolute pin3(ground.g2, bar2.b);
    revolute pin4(ground.g3, crank.a);
}
";

fn port(name: &str) -> PortName {
    let (owner, port) = name.split_once('.').unwrap();
    PortName::new(owner, port)
}

/// The text after a gesture, with the picture of the compiler.
fn made(text: &str, gesture: &Gesture) -> Result<String, Refusal> {
    let picture = compiled(text).picture.unwrap();
    let made = draw(&Sheet::read(text, None), &picture, gesture).map(|drawn| applied(text, &drawn.edits))?;
    assert_eq!(layout::formatted(&made).as_ref(), Ok(&made));
    Ok(made)
}

fn place(text: &str, name: &str) -> [f64; 2] {
    let found = compiled(text);
    found.picture.and_then(|picture| picture.port(&port(name)).map(|port| port.at)).unwrap_or_else(|| {
        panic!("{name}: {:?}\n{text}", found.problems);
    })
}

fn near(found: [f64; 2], [x, y]: [f64; 2], tolerance: f64) -> bool {
    (found[0] - x).hypot(found[1] - y) <= tolerance
}

#[test]
fn a_copy_stands_beside_and_has_points_of_its_own() {
    let copy = |name: &str| Gesture::Copy { body: name.to_owned(), by: [0.02, -0.01], grid: 1e-3 };
    let text = made(TEXT, &copy("bar1")).unwrap();
    let expected = "port a: p4; port b: p5; port s: p4, axis: p5 - p4; }";
    assert!(text.contains("body bar3 {") && text.contains(expected), "{text}");
    assert!(text.contains("let p4 = (20, -10) mm;") && text.contains("let p5 = (50, 30) mm;"), "{text}");
    // What was there stays, and the copy is not joined.
    assert!(TEXT.lines().all(|line| text.contains(line)) && text.matches("bar3").count() == 1, "{text}");
    assert!(near(place(&text, "bar3.b"), [0.05, 0.03], 1e-12));
    // In axes of its own: it starts beside, turned as the one is.
    let text = made(TEXT, &copy("crank")).unwrap();
    let expected = "port b: (5, 0) cm; start x: 320 mm; start y: 40 mm; start angle: 90 deg; }";
    assert!(text.contains("body crank1 {") && text.contains(expected), "{text}");
    assert!(near(place(&text, "crank1.b"), [0.32, 0.09], 1e-12), "{:?}", place(&text, "crank1.b"));
    assert_eq!(made(TEXT, &copy("ground")), Err(Refusal::Unknown("ground".to_owned())));
    let many = "pub P {\n    repeat i in 0..2 { body bar[i] { mass: 1 kg; inertia: 1 kg*m^2; port a: (0, 0) m; } }\n}\n";
    assert_eq!(made(many, &copy("bar[1]")), Err(Refusal::Repeated("bar[1]".to_owned())));
}

#[test]
fn a_pin_of_two_bars_has_a_mirror_image() {
    let mirror = |name: &str| Gesture::Mirror { port: port(name), grid: 1e-3 };
    let text = made(TEXT, &mirror("bar1.b")).unwrap();
    assert_eq!(text, TEXT.replace("let p2 = (30, 40) mm", "let p2 = (30, -40) mm"));
    // Twice is not at all.
    assert_eq!(made(&text, &mirror("bar2.a")).unwrap(), TEXT);
    // Lengths stay, wherever the line is: its image by reflection in the line, of vectors.
    let turned = made(
        TEXT,
        &Gesture::Drag(Drag { port: port("ground.g2"), to: [0.07, 0.02], grid: 1e-3, free: false }),
    )
    .unwrap();
    let image = place(&made(&turned, &mirror("bar1.b")).unwrap(), "bar1.b");
    let (at, along) = ([0.03_f64, 0.04], [0.07_f64, 0.02]);
    let share = 2.0 * (at[0] * along[0] + at[1] * along[1]) / (along[0] * along[0] + along[1] * along[1]);
    assert!(near(image, [share * along[0] - at[0], share * along[1] - at[1]], 1e-5), "{image:?}");
    // On the ground, or at the end of one bar, there is none.
    for name in ["bar1.a", "crank.b"] {
        assert_eq!(made(TEXT, &mirror(name)), Err(Refusal::NoDyad(port(name))));
    }
    let line = TEXT.replace("(60, 0) mm", "(0, 0) mm");
    assert_eq!(made(&line, &mirror("bar1.b")), Err(Refusal::NoLength));
}

#[test]
fn a_locked_dimension_is_a_parameter() {
    let text = made(TEXT, &Gesture::Lock { port: port("bar1.b"), axis: 1 }).unwrap();
    assert!(text.starts_with("pub P {\n    param p2_y: mm = 40 mm;\n    param speed"), "{text}");
    assert!(text.contains("let p2 = (30 mm, p2_y);"), "{text}");
    assert!(near(place(&text, "bar1.b"), [0.03, 0.04], 1e-12));
    // No hand moves it.
    let drag = Gesture::Drag(Drag { port: port("bar1.b"), to: [0.04, 0.05], grid: 1e-3, free: false });
    assert_eq!(made(&text, &drag), Err(Refusal::Expression { port: port("bar1.b"), text: "p2".to_owned() }));
    // Of a body in axes of its own, and on the ground.
    let text = made(TEXT, &Gesture::Lock { port: port("crank.b"), axis: 0 }).unwrap();
    assert!(
        text.contains("param crank_b_x: cm = 5 cm;") && text.contains("port b: (crank_b_x, 0 cm);"),
        "{text}"
    );
    let text = made(TEXT, &Gesture::Lock { port: port("ground.g3"), axis: 0 }).unwrap();
    assert!(text.contains("port g3: (ground_g3_x, 0 cm);"), "{text}");
    // The parameter moves the pin as the number does.
    let set = made(&text, &Gesture::Set { name: "ground_g3_x".to_owned(), value: 0.4 }).unwrap();
    assert!(set.contains("param ground_g3_x: cm = 40 cm;"), "{set}");
    assert!(near(place(&set, "crank.a"), [0.4, 0.0], 1e-12));
}

#[test]
fn a_parameter_has_the_value_of_its_slider() {
    let set = |name: &str, value| made(TEXT, &Gesture::Set { name: name.to_owned(), value });
    let turns = std::f64::consts::TAU / 60.0;
    assert_eq!(set("speed", 90.0 * turns).unwrap(), TEXT.replace("= 60 rev", "= 90 rev"));
    assert_eq!(set("speed", 0.1 * 3.0 * turns).unwrap(), TEXT.replace("= 60 rev", "= 0.3 rev"));
    assert_eq!(set("speed", 0.0).unwrap(), TEXT.replace("= 60 rev", "= 0 rev"));
    assert_eq!(set("speed", -7.5 * turns).unwrap(), TEXT.replace("= 60 rev", "= -7.5 rev"));
    assert_eq!(set("speed", 60.0 * turns).unwrap(), TEXT);
    assert_eq!(set("ratio", 1.0), Err(Refusal::Formula("ratio".to_owned())));
    assert_eq!(set("p2", 1.0), Err(Refusal::Unknown("p2".to_owned())));
}

#[test]
fn a_copy_of_a_drawn_bar_is_drawn_on() {
    let ends = [End::Ground([0.0, 0.0]), End::Point([0.1, 0.05])];
    let bar = draw(&Sheet::read("", None), &plm_draw::Picture::default(), &Gesture::Bar { ends, grid: 1e-3 })
        .unwrap();
    let text = applied("", &bar.edits);
    let copied =
        made(&text, &Gesture::Copy { body: "bar1".to_owned(), by: [0.0, -0.05], grid: 1e-3 }).unwrap();
    let merge = Gesture::Merge {
        drag: Drag { port: port("bar2.a"), to: [0.0, 0.0], grid: 1e-3, free: false },
        onto: port("bar1.b"),
    };
    let joined = made(&copied, &merge).unwrap();
    assert_eq!(compiled(&joined).problems, [], "{joined}");
    assert!(joined.contains("revolute pin2(bar1.b, bar2.a);"), "{joined}");
}
