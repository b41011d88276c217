//! The picture, read back by an XML reader: what stands in it, and where.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_view::{Chart, Recording};
use roxmltree::{Document, Node};

/// Colours of the first two curves of a panel.
const FIRST: &str = "#0067b1";
const SECOND: &str = "#d55e00";

fn sampled<const N: usize>(columns: [(&str, &str); N], row: impl Fn(f64) -> [f64; N]) -> Recording {
    let mut recording = Recording::new(columns);
    for step in 0..=200 {
        let time = f64::from(step) / 50.0;
        recording.push(time, row(time));
    }
    recording
}

fn texts<'a>(svg: &'a Document) -> Vec<&'a str> {
    svg.descendants()
        .filter(|node| node.has_tag_name("text"))
        .map(|node| node.text().unwrap().trim())
        .collect()
}

fn points(node: Node) -> Vec<(f64, f64)> {
    let number = |text: &str| text.parse::<f64>().unwrap();
    let pairs =
        node.attribute("points").unwrap().split_whitespace().map(|pair| pair.split_once(',').unwrap());
    pairs.map(|(x, y)| (number(x), number(y))).collect()
}

/// The curves of one colour, without the line of the legend, which is level and has two points.
fn curves(svg: &Document, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let lines = svg.descendants().filter(|node| node.attribute("stroke") == Some(colour));
    lines.map(points).filter(|line| line.len() > 2).collect()
}

#[test]
fn there_is_a_panel_for_each_unit_with_legend_and_axes() {
    let columns = [("arm.angle", "deg"), ("elbow.force.x", "N"), ("forearm.angle", "deg"), ("ratio", "")];
    let recording = sampled(columns, |time| [time, -time, time * time, 1.0]);
    let text = Chart::over_time(&recording).titled("Arm & forearm <1>").to_svg();
    let svg = Document::parse(&text).unwrap();

    let texts = texts(&svg);
    let named = [
        "Arm & forearm <1>",
        "time (s)",
        "angle (deg)",
        "x (N)",
        "ratio",
        "arm.angle",
        "forearm.angle",
        "elbow.force.x",
    ];
    for expected in named {
        assert!(texts.contains(&expected), "{expected} is missing in {texts:?}");
    }
    assert_eq!(curves(&svg, FIRST).len(), 3, "a first curve in each of the three panels");
    assert_eq!(curves(&svg, SECOND).len(), 1, "a second curve in the panel of angles");
}

#[test]
fn a_straight_line_is_drawn_straight_across_the_frame() {
    let text = Chart::over_time(&sampled([("x", "m")], |time| [3.0 - 2.0 * time])).to_svg();
    let svg = Document::parse(&text).unwrap();
    let curve = &curves(&svg, FIRST)[0];

    let (first, last) = (curve[0], curve[curve.len() - 1]);
    assert!(last.1 > first.1, "downwards is where y grows in SVG");
    for point in curve {
        let share = (point.0 - first.0) / (last.0 - first.0);
        let expected = first.1 + share * (last.1 - first.1);
        // Both coordinates are rounded to a tenth of a pixel.
        assert!((point.1 - expected).abs() <= 0.11, "{point:?}");
    }
}

#[test]
fn everything_lies_in_the_picture() {
    let recording =
        sampled([("a.x", "m"), ("a.y", "m"), ("f", "N*m")], |time| [1e9 * time, -1.0, time.sin()]);
    let text = Chart::over_time(&recording).titled("Spread").to_svg();
    let svg = Document::parse(&text).unwrap();
    let view: Vec<f64> =
        svg.root_element().attribute("viewBox").unwrap().split(' ').map(|n| n.parse().unwrap()).collect();
    let size = |name: &str| svg.root_element().attribute(name).unwrap().parse::<f64>().unwrap();
    assert_eq!((view[2] / size("width"), view[3] / size("height")), (1.0, 1.0));

    for node in svg.descendants().filter(|node| node.has_tag_name("polyline")) {
        for (x, y) in points(node) {
            assert!((0.0..=view[2]).contains(&x) && (0.0..=view[3]).contains(&y), "{node:?}");
        }
    }
}

#[test]
fn not_a_number_interrupts_a_curve() {
    let gap = |time: f64| [if (1.0..1.1).contains(&time) { f64::NAN } else { time }];
    let text = Chart::over_time(&sampled([("x", "m")], gap)).to_svg();
    assert_eq!(curves(&Document::parse(&text).unwrap(), FIRST).len(), 2);
}

#[test]
fn nothing_recorded_is_an_empty_frame() {
    let text = Chart::over_time(&Recording::new([("x", "m")])).to_svg();
    let svg = Document::parse(&text).unwrap();
    assert!(texts(&svg).contains(&"x (m)"));
    assert!(curves(&svg, FIRST).is_empty());

    let text = Chart::over_time(&Recording::new([] as [(&str, &str); 0])).to_svg();
    assert!(Document::parse(&text).is_ok());
}

#[test]
fn a_long_run_gives_a_small_picture() {
    let mut recording = Recording::new([("x", "m")]);
    for step in 0..200_000 {
        let time = f64::from(step) * 1e-3;
        recording.push(time, [(100.0 * time).sin()]);
    }
    let text = Chart::over_time(&recording).to_svg();
    assert!(text.len() < 100_000, "{} bytes", text.len());
}

#[test]
fn the_same_chart_gives_the_same_text_in_the_file() {
    let recording = sampled([("x", "m")], |time| [time.cos()]);
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("svg/twice.svg");
    Chart::over_time(&recording).write_svg(&path).unwrap();
    let again = Chart::over_time(&recording).to_svg();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), again);

    let error = Chart::over_time(&recording).write_svg(path.join("below.svg")).unwrap_err();
    assert!(error.to_string().contains("below.svg"), "{error}");
}
