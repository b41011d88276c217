//! A sheet as SVG in millimetres, with a group for each layer.

use std::fmt::Write;

use super::number;
use super::region::{Path, Point, sub};
use super::sheet::{Placed, Sheet};

/// The colours of layers, in turns.
const COLOURS: [&str; 5] = ["#0000ff", "#ff0000", "#00a000", "#c000c0", "#0090a0"];
/// The width of lines, mm.
const LINE: &str = "0.1";

pub(super) fn text(sheet: &Sheet) -> String {
    let [low, high] = sheet.bounds;
    let [width, height] = sub(high, low).map(number);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\" fill=\"none\" stroke-width=\"{LINE}\">\n"
    );
    // The y axis of SVG points down.
    let at = |[x, y]: Point| [x - low[0], high[1] - y];
    let last = sheet.links.iter().map(|link| link.layer).max().unwrap_or_default();
    for layer in 1..=last {
        let on: Vec<&Placed> = sheet.links.iter().filter(|link| link.layer == layer).collect();
        if on.is_empty() {
            continue;
        }
        let colour = COLOURS[(layer - 1) % COLOURS.len()];
        let _ = writeln!(svg, "<g id=\"{}\" stroke=\"{colour}\">", super::layer_name(layer));
        for link in on {
            let data: Vec<String> = link.paths.iter().map(|path| closed(path, at)).collect();
            let _ = writeln!(svg, "<path id=\"{}\" d=\"{}\"/>", link.name, data.join(" "));
        }
        svg.push_str("</g>\n");
    }
    let _ = writeln!(
        svg,
        "<g id=\"{}\" fill=\"#808080\" font-family=\"sans-serif\" text-anchor=\"middle\" dominant-baseline=\"central\">",
        super::NAMES
    );
    for link in &sheet.links {
        let (middle, height) = link.text;
        let [x, y] = at(middle).map(number);
        let _ =
            writeln!(svg, "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\">{}</text>", number(height), link.name);
    }
    svg + "</g>\n</svg>\n"
}

/// A closed line; `at` turns the y axis round.
fn closed(path: &Path, at: impl Fn(Point) -> Point) -> String {
    let shown = |of: Point| {
        let [x, y] = at(of).map(number);
        format!("{x} {y}")
    };
    match path {
        Path::Circle { at: [x, y], radius } => {
            let (right, left, radius) = (shown([x + radius, *y]), shown([x - radius, *y]), number(*radius));
            format!("M{right} A{radius} {radius} 0 0 0 {left} A{radius} {radius} 0 0 0 {right} Z")
        }
        Path::Corners(corners) => {
            let mut data = format!("M{}", shown(corners[0].0));
            let next = corners.iter().cycle().skip(1);
            for ((from, bulge), (to, _)) in corners.iter().zip(next) {
                let [dx, dy] = sub(*to, *from);
                if *bulge == 0.0 {
                    let _ = write!(data, " L{}", shown(*to));
                    continue;
                }
                let radius = number(dx.hypot(dy) * (1.0 + bulge * bulge) / (4.0 * bulge.abs()));
                let (large, sweep) = (u8::from(bulge.abs() > 1.0), u8::from(*bulge < 0.0));
                let _ = write!(data, " A{radius} {radius} 0 {large} {sweep} {}", shown(*to));
            }
            data + " Z"
        }
    }
}
