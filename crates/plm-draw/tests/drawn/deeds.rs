//! Gestures on what is there: copies, mirror images, locked dimensions, values of parameters.

use plm_draw::{
    Ahead, Coordinate, Dimension, Drag, End, Gesture, PortName, Refusal, Sheet, StartAt, Typed, applied,
    draw, layout,
};

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

fn lock(name: &str, dimension: Dimension) -> Gesture {
    Gesture::Lock { port: port(name), dimension }
}

fn drag(name: &str, to: [f64; 2]) -> Gesture {
    Gesture::Drag(Drag { port: port(name), to, grid: 1e-3, free: false })
}

fn unlock(name: &str, dimension: Dimension) -> Gesture {
    Gesture::Unlock { port: port(name), dimension }
}

fn typed(name: &str, dimension: Dimension, text: &str) -> Gesture {
    Gesture::Typed(Typed { port: port(name), dimension, text: text.to_owned(), grid: 1e-3 })
}

#[test]
fn a_locked_number_is_a_parameter_and_the_other_one_goes() {
    let text = made(TEXT, &lock("bar1.b", Dimension::Y)).unwrap();
    assert!(text.starts_with("pub P {\n    param p2_y: mm = 40 mm;\n    param speed"), "{text}");
    assert!(text.contains("let p2 = (30 mm, p2_y);"), "{text}");
    assert!(near(place(&text, "bar1.b"), [0.03, 0.04], 1e-12));
    // A hand moves it along the other axis, and not along its own.
    let slid = made(&text, &drag("bar1.b", [0.04, 0.05])).unwrap();
    assert_eq!(slid, text.replace("(30 mm, p2_y)", "(40 mm, p2_y)"));
    assert_eq!(made(&text, &drag("bar1.b", [0.03, 0.07])).unwrap(), text);
    let across = made(TEXT, &lock("bar2.a", Dimension::X)).unwrap();
    let slid = made(&across, &drag("bar1.b", [0.04, 0.05])).unwrap();
    assert!(slid.contains("let p2 = (p2_x, 50 mm);") && slid.contains("param p2_x: mm = 30 mm;"), "{slid}");
    // With both there is no way to go.
    let both = made(&text, &lock("bar1.b", Dimension::X)).unwrap();
    assert!(both.contains("let p2 = (p2_x, p2_y);"), "{both}");
    assert_eq!(made(&both, &drag("bar1.b", [0.04, 0.05])), Err(Refusal::Held(port("bar1.b"))));
    assert_eq!(made(&both, &lock("bar1.b", Dimension::X)), Err(Refusal::Locked("x of bar1.b".to_owned())));
    // What is typed is the value of the parameter.
    let set = made(&both, &typed("bar1.b", Dimension::Y, "45.0")).unwrap();
    assert_eq!(set, both.replace("p2_y: mm = 40 mm", "p2_y: mm = 45.0 mm"));
    // Taken away again it is the text before.
    assert_eq!(
        made(&text, &unlock("bar1.b", Dimension::Y)).unwrap(),
        TEXT.replace("let p2 = (30, 40) mm", "let p2 = (30 mm, 40 mm)")
    );
    assert_eq!(
        made(TEXT, &unlock("bar1.b", Dimension::Y)),
        Err(Refusal::NotLocked("y of bar1.b".to_owned()))
    );
    // Of a body in axes of its own, and on the ground.
    let text = made(TEXT, &lock("crank.b", Dimension::X)).unwrap();
    assert!(
        text.contains("param crank_b_x: cm = 5 cm;") && text.contains("port b: (crank_b_x, 0 cm);"),
        "{text}"
    );
    let text = made(TEXT, &lock("ground.g3", Dimension::X)).unwrap();
    assert!(text.contains("port g3: (ground_g3_x, 0 cm);"), "{text}");
    // The parameter moves the pin as the number does.
    let set = made(&text, &Gesture::Set { name: "ground_g3_x".to_owned(), value: 0.4 }).unwrap();
    assert!(set.contains("param ground_g3_x: cm = 40 cm;"), "{set}");
    assert!(near(place(&set, "crank.a"), [0.4, 0.0], 1e-12));
    let twice = set.replace("    revolute pin1", "    let more = ground_g3_x;\n    revolute pin1");
    assert_eq!(
        made(&twice, &unlock("ground.g3", Dimension::X)),
        Err(Refusal::Shared("ground_g3_x".to_owned()))
    );
}

#[test]
fn a_locked_length_or_angle_of_a_drawn_bar_stays() {
    let along = [0.6_f64, 0.8];
    let text = made(TEXT, &lock("bar1.b", Dimension::Length)).unwrap();
    assert!(text.starts_with("pub P {\n    param bar1_length: mm = 50 mm;\n"), "{text}");
    assert!(text.contains("let p2 = p1 + turn((bar1_length, 0 mm), 53.1301 deg);"), "{text}");
    assert!(
        near(place(&text, "bar1.b"), [0.03, 0.04], 2e-6) && near(place(&text, "bar2.a"), [0.03, 0.04], 2e-6)
    );
    // A hand turns the bar: its end is where the circle is nearest to the pointer, here straight above and to the left.
    for (to, expected) in
        [([0.0, 0.1], [0.0, 0.05]), ([-0.2, 0.0], [-0.05, 0.0]), ([0.006, 0.008], [0.03, 0.04])]
    {
        let turned = made(&text, &drag("bar1.b", to)).unwrap();
        assert!(turned.contains("param bar1_length: mm = 50 mm;"), "{turned}");
        assert!(near(place(&turned, "bar1.b"), expected, 2e-6), "{:?}\n{turned}", place(&turned, "bar1.b"));
    }
    assert_eq!(made(&text, &drag("bar1.b", [0.0, 0.0])), Err(Refusal::Held(port("bar1.b"))));
    // Its other end takes it along.
    let moved = made(&text, &drag("bar1.a", [-0.01, 0.02])).unwrap();
    assert!(near(place(&moved, "bar1.b"), [0.02, 0.06], 2e-6), "{moved}");
    // What is typed: the length, the angle; and what cannot be both.
    let longer = made(&text, &typed("bar1.b", Dimension::Length, "100")).unwrap();
    assert_eq!(longer, text.replace("bar1_length: mm = 50 mm", "bar1_length: mm = 100 mm"));
    let level = made(&text, &typed("bar1.b", Dimension::Angle, "90.0")).unwrap();
    assert_eq!(level, text.replace("53.1301 deg", "90.0 deg"));
    assert_eq!(made(&text, &typed("bar1.b", Dimension::X, "10")), Err(Refusal::Held(port("bar1.b"))));
    // The angle: a hand goes along the ray.
    let text = made(TEXT, &lock("bar1.b", Dimension::Angle)).unwrap();
    assert!(
        text.contains("let p2 = p1 + turn((50, 0) mm, bar1_angle);")
            && text.contains("param bar1_angle: deg = 53.1301 deg;"),
        "{text}"
    );
    let further = made(&text, &drag("bar1.b", [0.1 * along[0] + 0.008, 0.1 * along[1] - 0.006])).unwrap();
    assert_eq!(further, text.replace("turn((50, 0)", "turn((100, 0)"));
    // Both, and no more than both; taken away one after the other it is the text before.
    let both = made(&text, &lock("bar1.b", Dimension::Length)).unwrap();
    assert!(both.contains("let p2 = p1 + turn((bar1_length, 0 mm), bar1_angle);"), "{both}");
    assert_eq!(made(&both, &drag("bar1.b", [0.1, 0.1])), Err(Refusal::Held(port("bar1.b"))));
    assert_eq!(
        made(&both, &lock("bar1.b", Dimension::Length)),
        Err(Refusal::Locked("length of bar1.b".to_owned()))
    );
    let one = made(&both, &unlock("bar1.b", Dimension::Angle)).unwrap();
    assert!(one.contains("turn((bar1_length, 0 mm), 53.1301 deg)") && !one.contains("bar1_angle"), "{one}");
    assert_eq!(made(&one, &unlock("bar1.b", Dimension::Length)).unwrap(), TEXT);
    // From its base the lock is the same one, and the bar points the other way.
    assert_eq!(made(&both, &unlock("bar1.a", Dimension::Angle)).unwrap(), one);
    assert_eq!(
        made(&one, &typed("bar1.a", Dimension::Angle, "-90")).unwrap(),
        one.replace("53.1301 deg", "90 deg")
    );
    // The length of the other bar at the pin: both circles hold it.
    assert_eq!(made(&one, &typed("bar2.a", Dimension::Length, "60")), Err(Refusal::Held(port("bar2.a"))));
    // A second bar at the same pin is locked from its other end; a copy has numbers of its own.
    let second = made(&both, &lock("bar2.a", Dimension::Length)).unwrap();
    assert!(second.contains("let p3 = p2 + turn((bar2_length, 0 mm), -53.1301 deg);"), "{second}");
    assert!(near(place(&second, "ground.g2"), [0.06, 0.0], 2e-6), "{second}");
    let copy = Gesture::Copy { body: "bar1".to_owned(), by: [0.02, -0.01], grid: 1e-3 };
    assert!(made(&both, &copy).unwrap().contains("let p5 = (50, 30) mm;"), "{}", made(&both, &copy).unwrap());
    // With its bar the point goes.
    let gone = made(&second, &Gesture::Delete { name: "bar1".to_owned() }).unwrap();
    assert!(gone.contains("turn((bar2_length") && !gone.contains("bar1."), "{gone}");
}

#[test]
fn a_locked_dimension_of_a_bar_in_its_own_axes_stays() {
    let text = TEXT.replace(
        "port a: (-5, 0) cm; port b: (5, 0) cm; start x: 0.3 m; start y: 5 cm;",
        "port a: (0, 0) cm; port b: (10, 0) cm;",
    );
    let locked = made(&text, &lock("crank.b", Dimension::Length)).unwrap();
    assert!(
        locked.contains("param crank_length: cm = 10 cm;")
            && locked.contains("port b: (crank_length, 0 cm);"),
        "{locked}"
    );
    let turned = made(&locked, &drag("crank.b", [0.5, 0.0])).unwrap();
    assert_eq!(turned, locked.replace("start angle: 90 deg", "start angle: 0 deg"));
    assert_eq!(
        made(&locked, &unlock("crank.b", Dimension::Length)).unwrap(),
        text.replace("(10, 0) cm", "(10 cm, 0 cm)")
    );
    let held = made(&text, &lock("crank.b", Dimension::Angle)).unwrap();
    assert!(
        held.contains("param crank_angle: deg = 90 deg;") && held.contains("start angle: crank_angle;"),
        "{held}"
    );
    assert_eq!(
        made(&held, &drag("crank.b", [0.35, 0.2])).unwrap(),
        held.replace("port b: (10, 0)", "port b: (20, 0)").replace("rod(1 kg, 10 cm)", "rod(1 kg, 20 cm)")
    );
    // The length of a bar around its middle is two numbers.
    assert_eq!(made(TEXT, &lock("crank.b", Dimension::Length)), Err(Refusal::NoBar(port("crank.b"))));
}

#[test]
fn a_drag_tells_of_dead_points_and_of_the_other_branch() {
    let told = |text: &str, name: &str, to: [f64; 2]| {
        let picture = compiled(text).picture.unwrap();
        draw(&Sheet::read(text, None), &picture, &drag(name, to)).unwrap().told
    };
    let (fourth, bar) = (
        "    let p4 = (80, 60) mm;\n",
        "coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3;",
    );
    let text = format!(
        "pub P {{\n    let p1 = (0, 0) mm;\n    let p2 = (0, 40) mm;\n    let p3 = (100, 0) mm;\n{fourth}    ground {{ port g1: p1; port g2: p3; }}\n    body crank {{ {bar} port a: p1; port b: p2; }}\n    body rod {{ {bar} port a: p2; port b: p4; }}\n    body rocker {{ {bar} port a: p4; port b: p3; }}\n    revolute o(ground.g1, crank.a);\n    revolute b(crank.b, rod.a);\n    revolute c(rod.b, rocker.a);\n    revolute d(ground.g2, rocker.b);\n}}\n"
    );
    // Without a drive nothing has a dead point.
    assert_eq!(told(&text, "rod.b", [0.05, 0.02]), Vec::<String>::new());
    let text =
        text.replace("    revolute o", "    constraint motor: crank.angle = 1 rad/s*t;\n    revolute o");
    // The line from (0, 40) to (100, 0) passes (50, 20).
    assert_eq!(told(&text, "rod.b", [0.07, 0.05]), Vec::<String>::new());
    assert_eq!(told(&text, "rod.b", [0.05, 0.02]), ["dead point: rod and rocker are in line"]);
    assert_eq!(told(&text, "rod.b", [0.05, -0.02]), ["flipped: rod and rocker meet on the other side"]);
    // As the pin itself, its ends do it: from (0, 40) through (80, 60) the line reaches (160, 80).
    assert_eq!(told(&text, "ground.g2", [0.16, 0.08]), ["dead point: rod and rocker are in line"]);
    assert_eq!(told(&text, "ground.g2", [0.16, 0.12]), ["flipped: rod and rocker meet on the other side"]);
    // Crank and rod may be in line: the motor takes them through it.
    assert_eq!(told(&text, "crank.b", [0.04, 0.03]), Vec::<String>::new());
    let driven = text
        .replace("    constraint motor: crank.angle = 1 rad/s*t;\n", "")
        .replace("revolute d(ground.g2, rocker.b);", "revolute d(ground.g2, rocker.b) { drive: 1 N*m; }");
    assert_eq!(told(&driven, "crank.b", [0.04, 0.03]), ["dead point: crank and rod are in line"]);
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

/// A chain of two of its bars, which has freedoms.
fn chain() -> String {
    TEXT.replace("    revolute pin3(ground.g2, bar2.b);\n", "")
}

/// A coordinate that is locked.
fn locked(body: &str, coordinate: Coordinate, value: f64) -> StartAt {
    StartAt { body: body.to_owned(), coordinate, value, is_locked: true }
}

fn begun(text: &str, starts: &[StartAt], ahead: &[Ahead]) -> Result<String, Refusal> {
    made(text, &Gesture::Start { starts: starts.to_vec(), ahead: ahead.to_vec(), grid: 1e-3 })
}

#[test]
fn a_pose_becomes_the_start() {
    use Coordinate::{Angle, X};
    let quarter = std::f64::consts::FRAC_PI_4;
    // What has a start has another one, in its unit; what has none gets one behind its ports.
    let text =
        begun(&chain(), &[locked("crank", Angle, quarter), locked("bar1", Angle, -0.5 * quarter)], &[])
            .unwrap();
    assert!(text.contains("start y: 5 cm; start angle: 45 deg, locked; }"), "{text}");
    assert!(text.contains("port s: p1, axis: p2 - p1; start angle: -22.5 deg, locked; }"), "{text}");
    let found = compiled(&text).picture.unwrap();
    let angle = |name: &str| found.port(&port(name)).unwrap().angle;
    assert!((angle("crank.a") - quarter).abs() < 1e-12 && (angle("bar1.a") + 0.5 * quarter).abs() < 1e-12);
    // Of another coordinate: the lock before goes.
    let free = StartAt { is_locked: false, ..locked("crank", X, 0.25) };
    let other = begun(&text, &[free, locked("bar1", Angle, 0.0)], &[]).unwrap();
    assert!(other.contains("start x: 0.25 m; start y: 5 cm; start angle: 45 deg; }"), "{other}");
    assert!(other.contains("start angle: 0 deg, locked; }"), "{other}");
    assert_eq!(
        begun(&text, &[locked("crank", Angle, quarter), locked("bar1", Angle, -0.5 * quarter)], &[]).unwrap(),
        text
    );
    // What a name says, the name says; a formula is left to who wrote it.
    let named = TEXT
        .replace("start angle: 90 deg", "start angle: lean")
        .replace("    let p1", "    param lean: deg = 90 deg;\n    let p1");
    assert!(begun(&named, &[locked("crank", Angle, 0.0)], &[]).unwrap().contains("param lean: deg = 0 deg;"));
    let formula = chain().replace("start angle: 90 deg", "start angle: 2*45 deg");
    assert_eq!(
        begun(&formula, &[locked("crank", Angle, 0.0)], &[]),
        Err(Refusal::Formula("start angle of crank".to_owned()))
    );
    assert_eq!(begun(&chain(), &[locked("bar9", Angle, 0.0)], &[]), Err(Refusal::Unknown("bar9".to_owned())));
    assert_eq!(
        begun(&chain(), &[locked("bar[0]", Angle, 0.0)], &[]),
        Err(Refusal::Repeated("bar[0]".to_owned()))
    );
    assert_eq!(Sheet::read(&other, None).locked_starts(), [("bar1".to_owned(), Angle)]);
}

#[test]
fn a_motor_begins_further_on() {
    let turns = |law: &str| {
        chain().replace(
            "    revolute pin1",
            &format!("    constraint motor: bar1.angle = {law};\n    revolute pin1"),
        )
    };
    let ahead = [Ahead { body: "bar1".to_owned(), by: std::f64::consts::FRAC_PI_2 }];
    let cases = [
        ("60 rev/min*t", "90 deg + 60 rev/min*t"),
        ("-30 deg + speed*t", "60 deg + speed*t"),
        ("0.25 rev - speed*t", "0.5 rev - speed*t"),
        ("0", "90 deg"),
        ("speed*t - 30 deg", "90 deg + speed*t - 30 deg"),
        ("-(speed*t)", "90 deg + (-(speed*t))"),
    ];
    for (law, expected) in cases {
        assert_eq!(begun(&turns(law), &[], &ahead).as_deref(), Ok(&*turns(expected)), "{law}");
    }
    let other = [Ahead { body: "crank".to_owned(), by: 1.0 }];
    assert_eq!(begun(&chain(), &[], &other), Err(Refusal::Repeated("crank".to_owned())));
}
