//! Blocks on rails of the ground, pins in slots of bars, and places of the ground.

use plm_draw::{End, Gesture, Refusal};

use crate::support::compiled;
use crate::tables::{TEXT, drag, made, new_lines, port};

#[test]
fn a_slider_crank_is_drawn_by_pointer() {
    let bar = |ends| Gesture::Bar { ends, grid: 1e-3 };
    let slide = |toward| Gesture::Slide { port: port("bar2.b"), toward, grid: 1e-3 };
    let mut text = String::new();
    for gesture in [
        bar([End::Ground([0.0, 0.0]), End::Point([0.0, 0.05])]),
        bar([End::Port(port("bar1.b")), End::Point([0.2, 0.0])]),
    ] {
        text = made(&text, &gesture).unwrap();
    }
    let drawn = made(&text, &slide([0.1, 0.0])).unwrap();
    let expected = "\
ground { port g2: p3; }
body slider1 { coordinates: absolute; thickness: 5 mm; density: steel; contour: p3 + (-15, -10) mm, p3 + (15, -10) mm, p3 + (15, 10) mm, p3 + (-15, 10) mm; port a: p3; }
revolute pin3(bar2.b, slider1.a);
prismatic slide1(ground.g2, slider1.a);
";
    assert_eq!(new_lines(&text, &drawn), expected);
    // A line has one direction, whichever of its two is drawn.
    for toward in [[0.3, 0.1], [0.1, -0.1]] {
        let turned = made(&text, &slide(toward)).unwrap();
        assert!(turned.contains("ground { port g2: p3, axis: 45 deg; }"), "{turned}");
        assert!(
            turned.contains("p3 + turn((-15, -10) mm, 45 deg), ")
                && turned.contains("port a: p3, axis: 45 deg; }"),
            "{turned}"
        );
        assert_eq!(compiled(&turned).problems, [], "{turned}");
    }
    // Rail and block go with the pin; what is deleted leaves no name behind, and the block stays on its rail.
    let dragged = made(&drawn, &drag("bar2.b", [0.25, 0.02], false)).unwrap();
    assert_eq!(new_lines(&drawn, &dragged), "let p3 = (250, 20) mm;\n");
    let free = made(&drawn, &Gesture::Unpin { port: port("bar2.b") }).unwrap();
    assert!(free.contains("prismatic slide1") && !free.contains("pin3"), "{free}");
    for name in ["bar2", "slider1", "slide1", "p3"] {
        let less = made(&drawn, &Gesture::Delete { name: name.to_owned() }).unwrap();
        assert!(
            compiled(&less).problems.iter().all(|(code, _)| !code.starts_with('E')),
            "{name}: {:?}",
            compiled(&less).problems
        );
    }
    // Of a body in axes of its own the rail gets a point, which the block shares.
    let own = made(TEXT, &Gesture::Slide { port: port("rod.c"), toward: [1.0, 0.0], grid: 1e-3 }).unwrap();
    assert!(
        own.contains("{ port g1: p1, axis: ") && own.contains("revolute pin1(rod.c, slider1.a);"),
        "{own}"
    );
    assert_eq!(compiled(&own).problems, [], "{own}");
    let driven = made(&drawn, &Gesture::Motor { body: "bar1".to_owned() }).unwrap();
    assert_eq!(compiled(&driven).problems, [], "{driven}");
    assert_eq!(plm_draw::layout::formatted(&driven).as_ref(), Ok(&driven));
    assert_eq!(made(&text, &slide([0.2, 0.0])), Err(Refusal::NoLength));
    let held = Gesture::Slide { port: port("bar1.a"), toward: [1.0, 0.0], grid: 1e-3 };
    assert_eq!(made(&text, &held), Err(Refusal::Same(port("bar1.a"), port("ground.g1"))));
}

#[test]
fn the_ground_gets_a_place_for_a_spring() {
    let point = Gesture::GroundPoint { at: [0.02, -0.0], grid: 1e-3 };
    let text = made("", &point).unwrap();
    assert_eq!(
        text,
        "pub Drawing {\n    gravity: 9.81 m/s^2;\n    let p1 = (20, 0) mm;\n    ground { port g1: p1; }\n}\n"
    );
    let bar = Gesture::Bar { ends: [End::Ground([0.0, 0.1]), End::Point([0.1, 0.1])], grid: 1e-3 };
    let text = made(&text, &bar).unwrap();
    let ports = [port("ground.g1"), port("bar1.b")];
    let sprung = made(&text, &Gesture::Join { tool: "spring".to_owned(), ports, grid: 1e-3 }).unwrap();
    assert!(sprung.contains("spring spring1(ground.g1, bar1.b)"), "{sprung}");
    assert_eq!(compiled(&sprung).problems, [], "{sprung}");
    let moved = made(&sprung, &drag("ground.g1", [0.03, 0.01], false)).unwrap();
    assert_eq!(new_lines(&sprung, &moved), "let p1 = (30, 10) mm;\n");
}

#[test]
fn a_pin_slides_along_a_bar() {
    let bar = |ends| Gesture::Bar { ends, grid: 1e-3 };
    let groove = |body: &str| Gesture::Groove { port: port("bar1.b"), body: body.to_owned(), grid: 1e-3 };
    let mut text = String::new();
    for gesture in [
        bar([End::Ground([0.0, 0.0]), End::Point([0.03, 0.04])]),
        bar([End::Ground([0.0, -0.08]), End::Point([0.06, 0.16])]),
    ] {
        text = made(&text, &gesture).unwrap();
    }
    let slotted = made(&text, &groove("bar2")).unwrap();
    let expected = "\
body bar2 { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: steel; port a: p3; port b: p4; port s: p3, axis: p4 - p3; }
pin_slot slide1(bar2.s, bar1.b);
";
    assert_eq!(new_lines(&text, &slotted), expected);
    let driven = made(&slotted, &Gesture::Motor { body: "bar1".to_owned() }).unwrap();
    assert_eq!(compiled(&driven).problems, [], "{driven}");
    assert_eq!(plm_draw::layout::formatted(&driven).as_ref(), Ok(&driven));
    assert_eq!(made(&text, &groove("bar1")), Err(Refusal::Same(port("bar1.b"), port("bar1.b"))));
    // In axes of its own: from (0, -0.1) to (0, 0.2).
    let own = Gesture::Groove { port: port("ground.d"), body: "rod".to_owned(), grid: 1e-3 };
    let own = made(TEXT, &own).unwrap();
    assert!(own.contains("port tip: (0.1, 0) m; port s: (0 m, -0.1 m), axis: 90 deg;"), "{own}");
    assert!(own.contains("pin_slot slide1(rod.s, ground.d);"), "{own}");
}
