//! Drawings of mechanisms, read back by an XML reader.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use std::fs;
use std::path::Path;

use plm_view::{Block, Body, Frame, GroundPort, Mechanism, Part, Port, Sense, Side, Sketch, Symbol};
use roxmltree::{Document, Node};

fn port(name: &str, x: f64, y: f64) -> Port {
    Port { name: name.into(), x, y, angle: 0.0 }
}

fn body(name: &str, ports: Vec<Port>) -> Body {
    Body { name: name.into(), mass: 1.0, inertia: 0.1, depth: 0.0, ports, contour: None, holes: [].into() }
}

fn ground(name: &str, x: f64, y: f64, angle: f64) -> GroundPort {
    GroundPort { name: name.into(), x, y, angle, depth: 0.0, moves: false }
}

/// A part that joins a port of the ground or of a body with another.
fn part(name: &str, kind: &str, pair: Option<&str>, ends: [(Option<usize>, usize); 2]) -> Part {
    let frames = ends.iter().zip(["a", "b"]).map(|((body, port), argument)| Frame {
        argument: argument.into(),
        body: *body,
        port: Some(*port),
    });
    let (name, kind) = (name.into(), kind.into());
    Part {
        name,
        kind,
        pair: pair.map(str::to_owned),
        frames: frames.collect(),
        sizes: [].into(),
        shapes: [].into(),
    }
}

/// Two bars on pins, the first of 0.4 m upright, the second of 0.3 m level.
fn bars() -> Sketch {
    let mechanism = Mechanism {
        bodies: vec![
            body("arm", vec![port("o", -0.2, 0.0), port("p", 0.2, 0.0)]),
            body("rod", vec![port("p", -0.15, 0.0), port("tip", 0.15, 0.0)]),
        ],
        ground: vec![ground("o", 0.0, 0.0, 0.0)],
        parts: vec![
            part("shoulder", "revolute", Some("revolute"), [(None, 0), (Some(0), 0)]),
            part("elbow", "revolute", Some("revolute"), [(Some(0), 1), (Some(1), 0)]),
            part("load", "force", None, [(Some(1), 1), (Some(1), 1)]),
        ],
        ..Mechanism::default()
    };
    Sketch::new(mechanism, [[0.0, 0.2, std::f64::consts::FRAC_PI_2], [0.15, 0.4, 0.0]]).titled("Bars <&>")
}

fn number(node: &Node, attribute: &str) -> f64 {
    node.attribute(attribute).unwrap().parse().unwrap()
}

fn circles(document: &Document, class: &str) -> Vec<[f64; 2]> {
    let all = document.descendants().filter(|node| node.has_tag_name("circle"));
    let wanted = all.filter(|node| node.attribute("class") == Some(class) && number(node, "r") == 6.0);
    wanted.map(|node| [number(&node, "cx"), number(&node, "cy")]).collect()
}

/// Pins stand where the bars' lengths put them, to scale, y upwards.
#[test]
fn pins_stand_to_scale() {
    let svg = bars().to_svg();
    let document = Document::parse(&svg).unwrap();
    let [shoulder, elbow] = circles(&document, "white")[..] else { panic!("{svg}") };
    assert!((shoulder[0] - elbow[0]).abs() < 0.11, "{svg}");
    // 0.4 m upright is the largest height that a drawing has, 250 px; coordinates are written to a tenth.
    assert!((shoulder[1] - elbow[1] - 250.0).abs() < 0.11, "{svg}");
    let root = document.root_element();
    assert_eq!((root.attribute("role"), root.attribute("aria-label")), (Some("img"), Some("Bars <&>")));
    assert_eq!(root.attribute("width"), Some("600"));
}

/// Twice as many pixels as the drawing has, by a reader that is not the writer's: pins, links and paper are where SVG has them.
#[test]
fn pixels_are_where_svg_has_shapes() {
    let (svg, png) = (bars().to_svg(), bars().to_png());
    let document = Document::parse(&svg).unwrap();
    let root = document.root_element();
    let [left, top, width, height] = root
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .map(|number| number.parse().unwrap())
        .collect::<Vec<f64>>()[..]
    else {
        panic!("{svg}")
    };
    let mut bytes = vec![0; minipng::decode_png_header(&png).unwrap().required_bytes_rgba8bpc()];
    let mut image = minipng::decode_png(&png, &mut bytes).unwrap();
    image.convert_to_rgba8bpc().unwrap();
    let columns = image.width() as usize;
    assert_eq!([f64::from(image.width()), f64::from(image.height())], [2.0 * width, 2.0 * height]);
    let at = |[x, y]: [f64; 2]| {
        let [column, row] = [2.0 * (x - left), 2.0 * (y - top)].map(|place| place as usize);
        let [red, green, blue, opaque] = image.pixels()[4 * (row * columns + column)..][..4] else {
            panic!()
        };
        assert_eq!(opaque, 255);
        [red, green, blue]
    };
    let [shoulder, elbow] = circles(&document, "white")[..] else { panic!("{svg}") };
    let (white, ink, link) = ([255; 3], at([elbow[0] - 6.0, elbow[1]]), [0xcf, 0xe0, 0xf0]);
    assert_eq!([at(shoulder), at(elbow), at([left + 1.0, top + 1.0])], [white; 3]);
    assert!(ink.iter().all(|part| *part < 80), "{ink:?}");
    // Beside the sign of the centre of gravity.
    assert_eq!(at([shoulder[0], 0.7 * shoulder[1] + 0.3 * elbow[1]]), link);
    // Letters of the title.
    let mut title =
        (0..100).flat_map(|x| (0..14).map(move |y| [14.5 + f64::from(x), top + 11.5 + f64::from(y)]));
    assert!(title.any(|place| at(place).iter().all(|part| *part < 80)));
}

/// A counter-clockwise arc has the sweep flag 0 where y points downwards, and ends left of where it begins above a pin.
#[test]
fn positive_turns_are_counter_clockwise() {
    let svg = bars().with_signs(["elbow"]).with_senses("load", [Sense::Turn("torque".into())]).to_svg();
    let document = Document::parse(&svg).unwrap();
    let paths = document.descendants().filter_map(|node| node.attribute("d"));
    let arcs: Vec<Vec<&str>> =
        paths.filter(|d| d.contains('A')).map(|d| d.split(['A', ' ']).collect()).collect();
    assert_eq!(arcs.len(), 2, "{svg}");
    for arc in arcs {
        // M x, y, A rx, ry, rotation, large, sweep, x, y
        assert_eq!((arc[5], arc[6]), ("0", "0"), "{svg}");
    }
    for text in ["angle", "torque"] {
        assert!(svg.contains(&format!(">{text}</text>")), "{svg}");
    }
}

/// What has no finite place is left out, and no reader stumbles.
#[test]
fn what_cannot_be_placed_is_left_out() {
    let lost = Mechanism {
        bodies: vec![body("lost", vec![port("a", f64::NAN, 0.0)]), body("none", Vec::new())],
        parts: vec![part("pin", "revolute", Some("revolute"), [(Some(0), 0), (Some(7), 3)])],
        ..Mechanism::default()
    };
    for poses in [vec![], vec![[f64::INFINITY, 0.0, 0.0]; 2], vec![[1e300, -1e300, 1.0], [0.0; 3]]] {
        let poses_of_png = poses.clone();
        let svg = Sketch::new(lost.clone(), poses).with_gravity([0.0, f64::NAN]).to_svg();
        Document::parse(&svg).unwrap();
        let png = Sketch::new(lost.clone(), poses_of_png).with_gravity([0.0, f64::NAN]).to_png();
        minipng::decode_png_header(&png).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}

#[test]
fn a_box_has_its_names_and_senses() {
    let block = Block::new("valve", Symbol::Orifice).port(Side::Left, "a").inward("flow").input("opening");
    assert_eq!(block.names().collect::<Vec<_>>(), ["a", "opening"]);
    assert_eq!(block.senses().collect::<Vec<_>>(), ["flow"]);
    let svg = block.noting("a < b").to_svg();
    Document::parse(&svg).unwrap();
    assert!(svg.contains(">a &lt; b</text>") && svg.contains(">opening</text>"));
}

/// Boxes of the texts of a drawing: middle and half of the sides, in pixels; letters of sans-serif fonts are some 0.58 of the
/// size of the font wide, on the safe side.
fn texts<'a>(document: &'a Document) -> Vec<(&'a str, [f64; 4])> {
    let all = document.descendants().filter(|node| node.has_tag_name("text"));
    all.filter_map(|node| {
        let (text, class) = (node.text()?, node.attribute("class")?);
        let size = if class == "small" { 11.0 } else { 13.0 };
        let (half, start) = (0.5 * 0.58 * size * text.chars().count() as f64, class == "title");
        let middle = number(&node, "x") + if start { half } else { 0.0 };
        Some((text, [middle, number(&node, "y"), half, 0.4 * size]))
    })
    .collect()
}

/// All figures of the book: nothing is cut off, no text lies on another.
#[test]
fn texts_of_the_figures_can_be_read() {
    let images = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/src/images");
    let (mut wrong, mut checked) = (Vec::new(), 0);
    for file in ["parts", "demos"].into_iter().flat_map(|folder| fs::read_dir(images.join(folder)).unwrap()) {
        let path = file.unwrap().path();
        let svg = fs::read_to_string(&path).unwrap();
        let document = Document::parse(&svg).unwrap();
        let view: Vec<f64> = document
            .root_element()
            .attribute("viewBox")
            .unwrap()
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        let texts = texts(&document);
        checked += texts.len();
        for (k, (text, [x, y, w, h])) in texts.iter().enumerate() {
            let inside = x - w >= 0.0 && x + w <= view[2] && y - h >= view[1] && y + h <= view[1] + view[3];
            let over = texts[..k].iter().find(|(_, other)| {
                (other[0] - x).abs() < other[2] + w && (other[1] - y).abs() < other[3] + h
            });
            if !inside || over.is_some() {
                wrong.push(format!("{}: {text} (inside: {inside}; on {over:?})", path.display()));
            }
        }
    }
    assert!(checked > 100 && wrong.is_empty(), "{checked} texts\n{}", wrong.join("\n"));
}
