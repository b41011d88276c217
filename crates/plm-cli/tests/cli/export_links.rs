//! `plm export --dxf` and `--svg`: links in true size, by the numbers of their declarations and closed forms.
//!
//! `crates/plm-import/tests/links.py` reads the same drawings by ezdxf.

use std::f64::consts::PI;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use super::{Said, folder, plm_in};

/// A four-bar of absolute points, whose coupler has a third pin and a window.
const FOUR_BAR: &str = "\
pub P {
    gravity: 9.81 m/s^2;
    let p1 = (0, 0) mm;
    let p2 = (40, 60) mm;
    let p3 = (240, 140) mm;
    let p4 = (200, 0) mm;
    let p5 = (100, 200) mm;
    body crank { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p1; port b: p2; }
    body coupler { coordinates: absolute; width: 30 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p2; port b: p3; port tip: p5; }
    body rocker { coordinates: absolute; width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: p3; port b: p4; }
    ground { port g1: p1; port g2: p4; }
    revolute pin1(ground.g1, crank.a);
    revolute pin2(crank.b, coupler.a);
    revolute pin3(coupler.b, rocker.a);
    revolute pin4(ground.g2, rocker.b);
    constraint motor: crank.angle = 60 rev/min*t;
}
";

/// A corner of a polyline with the bulge of the arc that follows.
type Corner = ([f64; 2], f64);

/// Circles and lines of a drawing, mm.
#[derive(Default)]
struct Drawn {
    /// Centres and radii.
    circles: Vec<([f64; 2], f64)>,
    /// Corners and bulges of closed lines, with their layers.
    lines: Vec<(String, Vec<Corner>)>,
}

/// The circles and polylines of a DXF text.
fn read(text: &str) -> Drawn {
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let (mut drawn, mut entity) = (Drawn::default(), "");
    let (mut layer, mut at, mut size) = ("", [0.0; 2], 0.0);
    for pair in lines.chunks(2) {
        let (code, value) = (pair[0].parse::<u32>().unwrap(), pair[1]);
        if code == 0 {
            match entity {
                "CIRCLE" => drawn.circles.push((at, size)),
                "POLYLINE" => drawn.lines.push((layer.to_owned(), Vec::new())),
                "VERTEX" => drawn.lines.last_mut().unwrap().1.push((at, size)),
                _ => {}
            }
            entity = value;
        }
        match code {
            8 => layer = value,
            10 => at[0] = value.parse().unwrap(),
            20 => at[1] = value.parse().unwrap(),
            40 | 42 => size = value.parse().unwrap(),
            _ => {}
        }
    }
    drawn
}

/// Within a closed line: its polygon, and a segment of the circle at each arc.
fn area(corners: &[([f64; 2], f64)]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let parts = corners.iter().zip(next).map(|(([x0, y0], bulge), ([x1, y1], _))| {
        let angle = 4.0 * bulge.atan();
        let radius = if angle == 0.0 { 0.0 } else { (x1 - x0).hypot(y1 - y0) / 2.0 / (angle / 2.0).sin() };
        0.5 * (x0 * y1 - y0 * x1 + radius * radius * (angle - angle.sin()))
    });
    parts.sum()
}

fn distance([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a - c).hypot(b - d)
}

fn export(folder: &Path, text: &str, words: &[&str]) -> Said {
    plm_in(folder, &[&["export", "-"], words].concat(), text.as_bytes())
}

fn link(folder: &Path, name: &str) -> Drawn {
    read(&fs::read_to_string(folder.join(format!("cut/links/{name}.dxf"))).unwrap())
}

/// Numbers of drawings have six digits behind the point.
const ROUNDING: f64 = 2e-6;

#[test]
fn holes_stand_as_far_apart_as_the_points_are() {
    let folder = folder();
    let said = export(&folder, FOUR_BAR, &["--dxf", "cut"]);
    assert_eq!((said.code, said.errors.as_str()), (0, ""));
    let width = 20.0;
    for (name, length) in [("crank", 40.0_f64.hypot(60.0)), ("rocker", 40.0_f64.hypot(140.0))] {
        let drawn = link(&folder, name);
        let [(a, first), (b, second)] = drawn.circles[..] else {
            panic!("{name}: {} holes", drawn.circles.len())
        };
        assert!((distance(a, b) - length).abs() < ROUNDING, "{name}: {a:?} {b:?}");
        assert_eq!((first, second), (2.5, 2.5));
        // A capsule: L w + pi w^2/4.
        let [(_, outline)] = &drawn.lines[..] else { panic!("{name}") };
        let expected = length * width + PI * width * width / 4.0;
        assert!((area(outline) - expected).abs() < 1e-3, "{name}: {} for {expected}", area(outline));
    }
}

#[test]
fn an_outline_has_the_area_of_the_mass() {
    let folder = folder();
    let said = export(&folder, FOUR_BAR, &["--dxf", "cut"]);
    assert_eq!(said.code, 0, "{said:?}");
    let run = plm_in(
        &folder,
        &["export", "-", "--mjcf", "-"],
        FOUR_BAR.replace("constraint motor", "// ").as_bytes(),
    );
    for name in ["crank", "coupler", "rocker"] {
        let from = run.output.find(&format!("body name=\"{name}\"")).unwrap_or_else(|| panic!("{run:?}"));
        let mass = run.output[from..].split("mass=\"").nth(1).unwrap().split('"').next().unwrap();
        let mass: f64 = mass.parse().unwrap();
        let [(_, outline)] = &link(&folder, name).lines[..] else { panic!("{name}") };
        let drawn = area(outline) * 1e-6 * 5e-3 * 7850.0;
        assert!((drawn / mass - 1.0).abs() < 1e-7, "{name}: {drawn} kg for {mass}");
    }
}

#[test]
fn a_cut_takes_half_of_the_kerf_on_each_side() {
    let folder = folder();
    let words = ["--dxf", "cut", "--kerf", "0.4", "--hole", "8"];
    assert_eq!(export(&folder, FOUR_BAR, &words).code, 0);
    let drawn = link(&folder, "crank");
    let length = 40.0_f64.hypot(60.0);
    assert!(drawn.circles.iter().all(|(_, radius)| (radius - 3.8).abs() < ROUNDING), "{:?}", drawn.circles);
    let expected = length * 20.4 + PI * 20.4 * 20.4 / 4.0;
    assert!((area(&drawn.lines[0].1) - expected).abs() < 1e-3);
}

#[test]
fn links_that_meet_lie_in_different_layers() {
    let folder = folder();
    let layers = |text: &str, words: &[&str]| -> Vec<String> {
        let said = export(&folder, text, &[&["--dxf", "cut", "--force"], words].concat());
        assert_eq!((said.code, said.errors.as_str()), (0, ""));
        let sheet = read(&fs::read_to_string(folder.join("cut/sheet.dxf")).unwrap());
        sheet.lines.iter().map(|(layer, _)| layer.clone()).collect()
    };
    // At the start crank and rocker are apart, and over a turn too.
    assert_eq!(layers(FOUR_BAR, &[]), ["layer_1", "layer_2", "layer_1"]);
    assert_eq!(layers(FOUR_BAR, &["--until", "1"]), ["layer_1", "layer_2", "layer_1"]);
    // Two cranks whose circles cross: they meet at a quarter of a turn.
    let two = "\
pub P {
    ground { port g1: (0, 0) mm; port g2: (100, 0) mm; }
    body one { width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: (0, 0) mm; port b: (-60, 0) mm; }
    body two { width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: (0, 0) mm; port b: (60, 0) mm; }
    revolute pin1(ground.g1, one.a);
    revolute pin2(ground.g2, two.a);
    constraint turns: one.angle = 60 rev/min*t;
    constraint also: two.angle = 60 rev/min*t;
}
";
    assert_eq!(layers(two, &[]), ["layer_1", "layer_1"]);
    // Half a turn later both point to each other: 60 + 60 mm on 100 mm.
    assert_eq!(layers(two, &["--until", "0.5"]), ["layer_1", "layer_2"]);
}

#[test]
fn a_slot_is_as_long_as_its_pin_moves() {
    // A yoke: the pin of a crank of 30 mm moves from -30 mm to 30 mm along the slot.
    let yoke = "\
pub P {
    ground { port g: (0, 0) mm; port rail: (0, 0) mm; }
    body crank { width: 20 mm; thickness: 5 mm; density: 7850 kg/m^3; port a: (0, 0) mm; port b: (30, 0) mm; }
    body yoke { contour: (-20, -50), (20, -50), (20, 50), (-20, 50) mm; thickness: 5 mm; density: 7850 kg/m^3; port s: (0, 0) mm, axis: 90 deg; port r: (0, 0) mm; start x: 30 mm; }
    revolute pin1(ground.g, crank.a);
    pin_slot groove(yoke.s, crank.b);
    prismatic guide(ground.rail, yoke.r);
    constraint turns: crank.angle = 60 rev/min*t;
}
";
    let folder = folder();
    let said = export(&folder, yoke, &["--dxf", "cut", "--until", "1"]);
    assert_eq!((said.code, said.errors.as_str()), (0, ""), "{said:?}");
    let drawn = link(&folder, "yoke");
    // The contour and the slot, a capsule of 60 mm and 5 mm.
    let [(_, outline), (_, slot)] = &drawn.lines[..] else { panic!("{}", drawn.lines.len()) };
    assert!((area(outline) - 4000.0).abs() < 1e-3);
    let expected = 60.0 * 5.0 + PI * 6.25;
    assert!((area(slot) - expected).abs() < 1e-2, "{} for {expected}", area(slot));
    // Without a motion it is told.
    let said = export(&folder, yoke, &["--dxf", "cut", "--force"]);
    assert!(said.code == 0 && said.errors.contains("without a motion it is not cut"), "{said:?}");
}

#[test]
fn tables_have_pins_and_lengths() {
    let folder = folder();
    assert_eq!(export(&folder, FOUR_BAR, &["--svg", "cut"]).code, 0);
    let pins = fs::read_to_string(folder.join("cut/pins.csv")).unwrap();
    assert_eq!(pins.lines().next().unwrap(), "link,layer,port,x (mm),y (mm),hole (mm),joint");
    assert!(pins.contains("crank,1,b,72.111026,0.000000,5.000000,pin2\n"), "{pins}");
    // Nothing is pinned to the third one.
    assert!(pins.lines().any(|line| line.starts_with("coupler,2,tip,") && line.ends_with(",,")), "{pins}");
    let lengths = fs::read_to_string(folder.join("cut/lengths.csv")).unwrap();
    assert!(lengths.contains("rocker,a,b,145.602198\n"), "{lengths}");
    assert_eq!(lengths.lines().count(), 1 + 1 + 3 + 1);
}

#[test]
fn an_svg_has_the_size_of_the_links() {
    let folder = folder();
    assert_eq!(export(&folder, FOUR_BAR, &["--svg", "cut"]).code, 0);
    let text = fs::read_to_string(folder.join("cut/links/crank.svg")).unwrap();
    let tree = roxmltree::Document::parse(&text).unwrap();
    let root = tree.root_element();
    let size = |name| -> f64 { root.attribute(name).unwrap().trim_end_matches("mm").parse().unwrap() };
    // 72.111 mm and half the width on both ends.
    assert!((size("width") - 92.111_026).abs() < ROUNDING && (size("height") - 20.0).abs() < ROUNDING);
    assert_eq!(root.attribute("viewBox").unwrap(), "0 0 92.111026 20.000000");
    let paths: Vec<_> = tree.descendants().filter(|node| node.has_tag_name("path")).collect();
    assert_eq!(paths.len(), 1);
    // An outline of two arcs and two lines, and two holes.
    let data = paths[0].attribute("d").unwrap();
    assert_eq!(
        (data.matches('Z').count(), data.matches("A10.000000").count(), data.matches("A2.500000").count()),
        (3, 2, 4)
    );
    let sheet = fs::read_to_string(folder.join("cut/sheet.svg")).unwrap();
    let tree = roxmltree::Document::parse(&sheet).unwrap();
    let groups =
        tree.descendants().filter(|node| node.has_tag_name("g")).filter_map(|node| node.attribute("id"));
    assert_eq!(groups.collect::<Vec<_>>(), ["layer_1", "layer_2", "names"]);
}

#[test]
fn what_is_no_outline_is_told() {
    let text = "\
pub P {
    ground { port o: (0, 0) m; }
    body bar { mass: 1 kg; inertia: rod(1 kg, 0.2 m); port a: (-0.1, 0) m; port b: (0.1, 0) m; }
    body point { mass: 1 kg; inertia: 1 kg*m^2; }
    revolute pin(ground.o, bar.a);
}
";
    let folder = folder();
    let said = export(&folder, text, &["--dxf", "cut", "--hole", "6", "--width", "5"]);
    for expected in [
        "warning: `bar` has no outline: it is drawn 5 mm wide round its ports\n --> <stdin>:3:10",
        "warning: `point` has no port and no contour: it is not drawn\n --> <stdin>:4:10",
        "warning: `bar` is 5 mm wide, and its holes 6 mm\n --> <stdin>:3:10",
    ] {
        assert!(said.code == 0 && said.errors.contains(expected), "{expected}\n{said:?}");
    }
    for (words, why) in [
        (&["--dxf", "cut", "--kerf", "wide"][..], "--kerf is a number from 0, not `wide`"),
        (&["--dxf", "cut", "--hole", "0"], "--hole is a number from 0.1, not `0`"),
        (&["--dxf", "cut", "--kerf", "9"], "--kerf is wider than the holes are"),
        (&["--rust", "x", "--kerf", "1"], "--kerf is of --dxf and --svg"),
        (&["--dxf", "cut", "--svg", "cut"], "an export makes one of"),
    ] {
        let said = export(&folder, text, words);
        assert!(said.code == 2 && said.errors.contains(why), "{words:?} {said:?}");
    }
}

/// An editor, or a page, gets the same files over the protocol; with the motion of a run the same layers.
#[test]
fn links_over_the_protocol_are_those_of_the_command() {
    let folder = folder();
    assert_eq!(export(&folder, FOUR_BAR, &["--dxf", "cut", "--until", "1"]).code, 0);
    assert_eq!(export(&folder, FOUR_BAR, &["--svg", "still"]).code, 0);
    let mut run = plm_dynamic::Mechanism::from_text(FOUR_BAR).unwrap().start().unwrap();
    let moments = (1..=360).map(|k| {
        run.step_to(f64::from(k) / 360.0).unwrap();
        let names: Vec<String> = run.bodies().map(str::to_owned).collect();
        let pose = |name: &String| {
            let at = run.body(name).unwrap();
            [at.x, at.y, at.angle]
        };
        names.iter().flat_map(pose).collect::<Vec<f64>>()
    });
    let motion: Vec<Vec<f64>> = moments.collect();
    let mut server = plm_cli::Server::default();
    let mut said = |message: Value| {
        let answers = server.message(&message.to_string());
        serde_json::from_str::<Value>(&answers[0]).unwrap()["result"].take()
    };
    let document = json!({ "uri": "plm:p.plm", "languageId": "plm", "version": 1, "text": FOUR_BAR });
    said(json!({ "method": "textDocument/didOpen", "params": { "textDocument": document } }));
    let mut source = |kind: &str, motion: &[Vec<f64>]| {
        let params = json!({ "textDocument": document, "kind": kind, "motion": motion });
        said(json!({ "id": 1, "method": "plm/source", "params": params }))
    };
    for (kind, motion, made) in [("dxf", &motion[..], "cut"), ("svg", &[], "still")] {
        let answer = source(kind, motion);
        assert_eq!(answer["name"], "P_links");
        let files = answer["files"].as_object().unwrap_or_else(|| panic!("{answer}"));
        assert_eq!(files.len(), 6, "a sheet, three links and two tables");
        for (name, text) in files {
            let expected = fs::read_to_string(folder.join(made).join(name)).unwrap();
            assert_eq!(text.as_str(), Some(&*expected), "{kind} {name}");
        }
    }
    assert!(source("svg", &[vec![0.0; 6]])["why"].as_str().unwrap().contains("each of the 3 bodies"));
    assert!(source("pdf", &[])["why"].as_str().unwrap().contains("c, fmi2, fmi3, dxf or svg"));
}
