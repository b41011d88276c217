//! The text of a declaration.

mod drive;
mod joint;
mod tie;

use crate::names::{Names, mechanism};
use crate::number::{angle, coarse, drawn, length, short};
use crate::outline::Outline;
use crate::planar::{Body, PairKind, Planar, Port, local};
use crate::plane::Plane;
use crate::spatial::Spatial;

/// Columns of a list, without its indentation.
const LONGEST: usize = 110;

/// Part for the forces along one of two slides whose carriage has no mass.
const SLIDE: &str = "\
/// A slide whose carriage has no mass, on the ground: what acts along the x axis of `a`.
part free_slide(a: frame, b: frame) {
    param stiffness: N/m = 0;
    param free_length: m = 0;
    param damping: N*s/m = 0;
    param seal_friction: N, optional;
    param lower_limit: m, optional;
    param upper_limit: m, optional;
    input drive: N = 0;
    let way = dot(b.position - a.position, a.axis);
    node slider: slider = way;
    force on b: (drive + slider.force - stiffness*(way - free_length) - damping*rate(way))*a.axis;
    given seal_friction { friction rub: rate(way) within seal_friction; }
    given lower_limit { unilateral lower: way >= lower_limit; }
    given upper_limit { unilateral upper: way <= upper_limit; }
    output displacement = way;
    output speed = rate(way);
}";

/// Lines of a declaration, at their indentation.
#[derive(Debug, Default)]
struct Lines {
    text: String,
    depth: usize,
}

impl Lines {
    fn line(&mut self, text: &str) {
        if !text.is_empty() {
            self.text.push_str(&"    ".repeat(self.depth));
            self.text.push_str(text);
        }
        self.text.push('\n');
    }

    /// Lines with their own indentation.
    fn lines(&mut self, text: &str) {
        text.lines().for_each(|line| self.line(line));
    }

    /// A line with a list, broken where it is long.
    fn list(&mut self, head: &str, entries: &[String], tail: &str) {
        let outer = self.depth;
        let mut line = head.to_owned();
        for (k, entry) in entries.iter().enumerate() {
            if line.len() + entry.len() > LONGEST {
                self.line(line.trim_end());
                self.depth = outer + 1;
                line.clear();
            }
            line.push_str(entry);
            line.push_str(if k + 1 == entries.len() { tail } else { ", " });
        }
        self.line(&line);
        self.depth = outer;
    }

    /// A line, those within it, and its closing bracket.
    fn block(&mut self, head: &str, within: impl FnOnce(&mut Lines)) {
        self.line(&format!("{head} {{"));
        self.depth += 1;
        within(self);
        self.depth -= 1;
        self.line("}");
    }
}

/// The declaration of a mechanism; `file` and `format` say where it comes from.
pub(crate) fn declaration(
    planar: &Planar,
    spatial: &Spatial,
    names: &mut Names,
    file: &str,
    format: &str,
) -> String {
    let mut lines = Lines::default();
    let [x, y] = [planar.plane.x, planar.plane.y].map(Plane::shown);
    lines.line(&format!("// From {file} ({format}), by plm import."));
    lines.line(&format!("// The plane has the file's {x} as its x and the file's {y} as its y."));
    let reversed = planar.pairs.iter().any(|pair| joint::is_reversed(planar, spatial, pair));
    if reversed {
        lines.line("// Where the axis of a hinge points away from the reader, the bodies stand in the other order: its angle is that of the file.");
    }
    let drives = drive::Drives::of(planar, spatial, names);
    lines.block(&format!("pub {}", mechanism(&spatial.name)), |lines| {
        if planar.floats {
            lines.line("allow(W0002);");
        }
        gravity(planar.gravity, lines);
        pictures(planar, lines);
        if planar.pairs.iter().any(|pair| pair.kind == PairKind::Slide) {
            lines.lines(SLIDE);
        }
        tie::parts(planar, lines);
        drives.inputs(lines);
        if !planar.ground.is_empty() {
            lines.block("ground", |lines| {
                planar.ground.iter().for_each(|port| self::port(port, "axis", lines));
            });
        }
        planar.bodies.iter().for_each(|body| self::body(body, lines));
        joint::pairs(planar, spatial, &drives, names, lines);
        joint::couplings(planar, spatial, names, lines);
        tie::ties(planar, lines);
        planar.bodies.iter().for_each(|body| outlines(body, names, lines));
        joint::outputs(planar, lines);
    });
    lines.text
}

/// Contour and holes of a body, from the outlines of a drawing with their corners in `unit`.
pub(crate) fn drawing(file: &str, outlines: &[Vec<[f64; 2]>], unit: &str) -> String {
    let mut lines = Lines::default();
    lines.line(&format!("// From {file} (DXF), by plm import."));
    for (k, points) in outlines.iter().enumerate() {
        let corners: Vec<String> =
            points.iter().map(|[x, y]| format!("({}, {})", drawn(*x), drawn(*y))).collect();
        lines.list(if k == 0 { "contour: " } else { "hole: " }, &corners, &format!(" {unit};"));
    }
    lines.text
}

fn gravity([x, y]: [f64; 2], lines: &mut Lines) {
    let [x, y] = [x, y].map(|part| if part.abs() < 1e-9 { 0.0 } else { part });
    match (x, y) {
        (0.0, 0.0) => {}
        (0.0, y) if y < 0.0 => lines.line(&format!("gravity: {} m/s^2;", short(-y))),
        (x, y) => lines.line(&format!("gravity: ({}, {}) m/s^2;", short(x), short(y))),
    }
}

/// The sum of terms, each with whether it is negative; `0` of none.
fn sum(terms: &[(bool, String)]) -> String {
    let mut sum = String::new();
    for (is_negative, term) in terms {
        sum.push_str(match (sum.is_empty(), *is_negative) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        });
        sum.push_str(term);
    }
    if sum.is_empty() { "0".to_owned() } else { sum }
}

fn point([x, y]: [f64; 2]) -> String {
    format!("({}, {})", length(x), length(y))
}

fn port(port: &Port, word: &str, lines: &mut Lines) {
    let turned = if port.angle == 0.0 { String::new() } else { format!(", {word}: {}", angle(port.angle)) };
    lines.line(&format!("port {}: {} m{turned};", port.name, point(port.at)));
}

fn body(body: &Body, lines: &mut Lines) {
    lines.block(&format!("body {}", body.name), |lines| {
        lines.line(&format!("mass: {} kg;", short(body.mass)));
        lines.line(&format!("inertia: {} kg*m^2;", short(body.inertia)));
        if body.centre.iter().any(|part| part.abs() > 1e-12) {
            lines.line(&format!("centre: {} m;", point(body.centre)));
        }
        body.ports.iter().for_each(|port| self::port(port, "angle", lines));
        if let Some(Outline::Polygon(points)) = contour(body) {
            lines.list("contour: ", &corners(points), ";");
        }
        if body.depth != 0.0 {
            lines.line(&format!("depth: {} m;", length(body.depth)));
        }
        let locked = |k: usize| if body.locked[k] { ", locked" } else { "" };
        for (k, name) in ["x", "y"].into_iter().enumerate().filter(|(k, _)| body.given[*k]) {
            lines.line(&format!("start {name}: {} m{};", length(body.start[k]), locked(k)));
        }
        if body.given[2] {
            lines.line(&format!("start angle: {}{};", angle(body.start[2]), locked(2)));
        }
    });
}

/// The outline that is the contour: the largest with corners.
fn contour(body: &Body) -> Option<&Outline> {
    body.outlines.iter().find(|outline| matches!(outline, Outline::Polygon(_)))
}

/// Corners of a picture with their unit.
fn corners(points: &[[f64; 2]]) -> Vec<String> {
    let size = points.iter().flatten().fold(0.0_f64, |size, part| size.max(part.abs()));
    let mut corners: Vec<String> =
        points.iter().map(|[x, y]| format!("({}, {})", coarse(*x, size), coarse(*y, size))).collect();
    if let Some(last) = corners.last_mut() {
        last.push_str(" m");
    }
    corners
}

/// Definitions of the parts that draw what is no contour.
fn pictures(planar: &Planar, lines: &mut Lines) {
    let others = || planar.bodies.iter().flat_map(other_outlines);
    if others().any(|outline| matches!(outline, Outline::Polygon(_))) {
        lines.line("/// A plate in the picture.");
        lines.block("part plate(a: frame)", |lines| {
            lines.line("points corners: m;");
            lines.line("picture outline on a: corners[k] for k in 0..count(corners);");
        });
    }
    if others().any(|outline| matches!(outline, Outline::Circle { .. })) {
        lines.line("/// A disc or ball in the picture.");
        lines.block("part round(a: frame)", |lines| {
            lines.line("param radius: m;");
            lines.line("param x: m = 0;");
            lines.line("param y: m = 0;");
            lines.line("picture circle on a at (x, y): radius;");
        });
    }
}

fn other_outlines(body: &Body) -> impl Iterator<Item = &Outline> {
    let contour = contour(body).map(std::ptr::from_ref);
    body.outlines.iter().filter(move |outline| contour != Some(std::ptr::from_ref(*outline)))
}

/// Uses of the parts that draw, each at the port that is nearest to its first point.
fn outlines(body: &Body, names: &mut Names, lines: &mut Lines) {
    for (k, outline) in other_outlines(body).enumerate() {
        let first = match outline {
            Outline::Circle { at, .. } => *at,
            Outline::Polygon(points) => points[0],
        };
        let away = |port: &&Port| (port.at[0] - first[0]).hypot(port.at[1] - first[1]);
        let Some(port) = body.ports.iter().min_by(|a, b| away(a).total_cmp(&away(b))) else { return };
        let number = if k == 0 { String::new() } else { format!("_{}", k + 1) };
        let name = names.give(&format!("{}_shape{number}", body.name), "part");
        let head = |part: &str| format!("{part} {name}({}.{}) {{ ", body.name, port.name);
        // From the port, in its axes.
        let local = |at: [f64; 2]| local([port.at[0], port.at[1], port.angle], at);
        match outline {
            Outline::Polygon(points) => {
                let points: Vec<[f64; 2]> = points.iter().map(|point| local(*point)).collect();
                lines.list(&format!("{}corners: ", head("plate")), &corners(&points), "; }");
            }
            Outline::Circle { at, radius } => {
                let [x, y] = local(*at);
                let [x, y] = [("x", x), ("y", y)].map(|(axis, place)| {
                    if place.abs() < 1e-9 {
                        String::new()
                    } else {
                        format!("{axis}: {} m; ", coarse(place, place))
                    }
                });
                lines.line(&format!("{}{x}{y}radius: {} m; }}", head("round"), coarse(*radius, *radius)));
            }
        }
    }
}
