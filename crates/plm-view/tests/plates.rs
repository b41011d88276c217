//! Charts of series on chosen axes, read back by an XML reader.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use plm_view::{Axis, Chart, Rule, Series};
use roxmltree::{Document, Node};

/// Colours of the first two series and of those to compare with.
const FIRST: &str = "#0067b1";
const SECOND: &str = "#d55e00";
const GREY: &str = "#808080";
const RULE: &str = "#1d2430";

fn log_log() -> Chart {
    Chart::new(Axis::log("error", "m"), Axis::log("time", "s"))
}

/// y = x^-2 at powers of ten.
fn power_law() -> Vec<(f64, f64)> {
    (0..6).map(|k| (10_f64.powi(-k), 1e-3 * 100_f64.powi(k))).collect()
}

fn points(node: Node) -> Vec<(f64, f64)> {
    let pairs = node.attribute("points").unwrap().split_whitespace();
    let number = |text: &str| text.parse::<f64>().unwrap();
    pairs.map(|pair| pair.split_once(',').unwrap()).map(|(x, y)| (number(x), number(y))).collect()
}

fn elements(svg: &str, tag: &str, attribute: &str, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let svg = Document::parse(svg).unwrap();
    let nodes = svg.descendants().filter(|node| node.has_tag_name(tag));
    nodes.filter(|node| node.attribute(attribute) == Some(colour)).map(points).collect()
}

/// The lines of a colour in the frame: the legend's are level and have two points.
fn curves(svg: &str, colour: &str) -> Vec<Vec<(f64, f64)>> {
    let lines = elements(svg, "polyline", "stroke", colour).into_iter();
    lines.filter(|line| line.len() > 2 || line[0].1 != line[1].1).collect()
}

/// Where a text is anchored.
fn place(svg: &str, wanted: &str) -> (f64, f64) {
    let svg = Document::parse(svg).unwrap();
    let is_it = |node: &Node| node.has_tag_name("text") && node.text().is_some_and(|t| t.trim() == wanted);
    let node = svg.descendants().find(is_it).unwrap_or_else(|| panic!("{wanted} is missing"));
    let number = |name: &str| node.attribute(name).unwrap().parse::<f64>().unwrap();
    (number("x"), number("y"))
}

#[test]
fn a_power_law_is_a_straight_line_on_logarithmic_axes() {
    let svg = log_log().with(Series::new("law", power_law())).to_svg();
    let curve = &curves(&svg, FIRST)[0];
    let (first, last) = (curve[0], curve[5]);
    assert!(
        last.0 < first.0 && last.1 < first.1,
        "the smallest abscissa is left, the largest ordinate above"
    );
    for (k, point) in curve.iter().enumerate() {
        let share = k as f64 / 5.0;
        let expected = (first.0 + share * (last.0 - first.0), first.1 + share * (last.1 - first.1));
        // Ends and points are rounded to a tenth of a pixel.
        assert!((point.0 - expected.0).abs() <= 0.11 && (point.1 - expected.1).abs() <= 0.11, "{point:?}");
    }
    for decade in ["10⁻⁵", "10⁻¹", "10⁰", "10⁴", "10⁶", "error (m)", "time (s)"] {
        place(&svg, decade);
    }
}

#[test]
fn ticks_stand_where_their_numbers_are() {
    let svg = log_log().with(Series::new("law", power_law())).to_svg();
    let curve = &curves(&svg, FIRST)[0];
    assert!((place(&svg, "10⁻³").0 - curve[3].0).abs() <= 0.11);
    // Between the labels of 10^2 and 10^4 lies the ordinate 10^3.
    let (below, above) = (place(&svg, "10²").1, place(&svg, "10⁴").1);
    assert!(
        (0.5 * (below + above) - curve[3].1).abs() <= 0.11,
        "a text is upright in the middle of its place"
    );
}

#[test]
fn a_falling_axis_has_its_large_values_left() {
    let falling = Chart::new(Axis::log("error", "m").falling(), Axis::log("time", "s"));
    let svg = falling.with(Series::new("law", power_law())).to_svg();
    let curve = &curves(&svg, FIRST)[0];
    assert!(curve.is_sorted_by(|a, b| a.0 < b.0));
}

#[test]
fn what_has_no_place_on_a_logarithmic_axis_interrupts_a_curve() {
    let mut points = power_law();
    points.insert(3, (0.0, 1.0));
    points.insert(2, (1e-2, -1.0));
    let svg = log_log().with(Series::new("law", points)).to_svg();
    let lengths: Vec<usize> = curves(&svg, FIRST).iter().map(Vec::len).collect();
    assert_eq!(lengths, [2, 3]);
}

#[test]
fn every_point_has_its_marker_and_so_has_the_legend() {
    let chart = log_log().with(Series::new("filled", power_law()).of_family(1, 0).marked()).with(
        Series::new("hollow", power_law().into_iter().map(|(x, y)| (x, 3.0 * y))).of_family(0, 1).marked(),
    );
    let svg = chart.to_svg();
    assert_eq!(elements(&svg, "polygon", "fill", SECOND).len(), 6 + 1);
    assert_eq!(elements(&svg, "polygon", "fill", "#f7f8fa").len(), 6 + 1);
}

#[test]
fn a_muted_series_is_grey() {
    let svg = log_log().with(Series::new("other", power_law()).muted(0)).to_svg();
    assert!(!curves(&svg, GREY).is_empty());
    assert!(curves(&svg, FIRST).is_empty());
}

#[test]
fn the_legend_stands_beside_the_curves() {
    let svg = log_log().with(Series::new("law", power_law())).to_svg();
    let rightmost = curves(&svg, FIRST)[0].iter().map(|point| point.0).fold(0.0, f64::max);
    assert!(place(&svg, "law").0 > rightmost);
}

#[test]
fn lines_of_reference_stand_at_their_values() {
    let chart = log_log()
        .with(Series::new("law", power_law()))
        .with_rule(Rule::vertical(1e-3, "floor"))
        .with_rule(Rule::vertical(2e-3, "target"))
        .with_rule(Rule::horizontal(1e1, "limit"));
    let svg = chart.to_svg();
    let curve = &curves(&svg, FIRST)[0];
    let rules = elements(&svg, "polyline", "stroke", RULE);
    assert!(rules.iter().any(|rule| rule.iter().all(|point| point.0 == curve[3].0)));
    assert!(rules.iter().any(|rule| rule.iter().all(|point| point.1 == curve[2].1)));
    // Labels of upright lines stand over the frame; these two are too near to stand in one row.
    let (floor, target, frame) = (place(&svg, "floor"), place(&svg, "target"), curve[5].1);
    assert!(floor.1 < frame && target.1 < floor.1, "{floor:?} {target:?} {frame}");
}

#[test]
fn the_label_of_a_level_line_evades_the_curves() {
    let right_end = |y: f64| (0..50).map(move |k| (5.0 + 0.1 * f64::from(k), y));
    let chart = Chart::new(Axis::linear("x", ""), Axis::linear("y", "").including(0.0).including(2.0))
        .with(Series::new("a", right_end(1.02)))
        .with(Series::new("b", right_end(0.98)))
        .with(Series::new("c", [(0.0, 0.2), (1.0, 0.2), (2.0, 0.2)]))
        .with_rule(Rule::horizontal(1.0, "limit"));
    let svg = chart.to_svg();
    assert!(place(&svg, "limit").0 < curves(&svg, FIRST)[0][0].0, "the right end is taken");
}

#[test]
fn panels_stand_one_under_the_other_over_one_axis() {
    let chart = Chart::new(Axis::linear("time", "s"), Axis::log("drift", "m"))
        .titled("A title that is so long that it does not fit in one line of the picture, and so is broken in two")
        .noted("a note\nand its second line")
        .with(Series::new("a", [(0.0, 1e-9), (1.0, 1e-8), (3.0, 1e-7)]))
        .below(Axis::linear("energy", "J"))
        .with(Series::new("b", [(0.0, 1.0), (3.0, 2.0), (3.0, 3.0)]));
    let svg = chart.to_svg();
    let lines = curves(&svg, FIRST);
    assert_eq!((lines[0][2].0, lines[0][0].0), (lines[1][1].0, lines[1][0].0), "times stand in one column");
    assert!(lines[1].iter().all(|below| lines[0].iter().all(|above| above.1 < below.1)));
    assert!(place(&svg, "a note").1 < place(&svg, "and its second line").1);
    assert!(place(&svg, "and its second line").1 < lines[0][2].1);
}
