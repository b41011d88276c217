//! The picture: error against CPU time in four scenes, creep of a block, energy at impacts.

use std::fmt::Write as _;

use plm_view::svg::{CURVES, FONT, INK, dark_style, escape};

use crate::runs::{LINES, Run, line};

pub(crate) const FAINT: &str = "#5c6675";
pub(crate) const GRID: &str = "#dfe3ea";
const WIDTH: f64 = 860.0;
const PANEL: [f64; 2] = [422.0, 268.0];
const TOP: f64 = 74.0;
/// The plot in a panel: left, top, width, height.
const PLOT: [f64; 4] = [58.0, 30.0, 338.0, 184.0];
/// Decades of the error, from left to right, and of the CPU time in s, from the foot.
const ERRORS: [f64; 2] = [1.5, -15.0];
const TIMES: [f64; 2] = [-4.6, -0.5];
/// Labels stand at least so far apart.
const APART: f64 = 15.0;

pub(crate) const SCENES: [(&str, &str); 4] = [
    ("oscillator", "Coulomb oscillator, at rest (m)"),
    ("ball", "Bouncing ball, after 6 impacts (m)"),
    ("rocking", "Rocking block, after 2 impacts (rad)"),
    ("slider-crank", "Slider-crank with friction, 1 s (rad)"),
];

/// The colour of a program: distinct for colour-blind readers, and told by its label as well.
fn colour(program: &str) -> &'static str {
    let order = ["plm", "MuJoCo", "Rapier2D", "Box2D", "Siconos"];
    CURVES[order.iter().position(|of| program.starts_with(of)).unwrap_or(0)]
}

/// The name of a line; a program that is shown twice says by which method.
fn label(program: &'static str, settings: &str) -> &'static str {
    if settings == "RK4" { "MuJoCo RK4" } else { program }
}

fn shown() -> impl Iterator<Item = (&'static str, &'static str)> {
    LINES.into_iter().filter(|(.., is_shown)| *is_shown).map(|(program, settings, _)| (program, settings))
}

/// Draws it.
pub fn svg(runs: &[Run]) -> String {
    let height = TOP + 3.0 * PANEL[1] + 8.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         font-family=\"{}\" stroke-linejoin=\"round\" role=\"img\" aria-label=\"Error against CPU time, creep and energy in scenes \
         with contact\">\n{}\n<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#f7f8fa\"/>\n",
        escape(FONT),
        dark_style()
    );
    let title = "Friction and impact: error, CPU time, creep and energy";
    text(&mut svg, [14.0, 28.0], title, INK, "font-size=\"17\" font-weight=\"600\"");
    let note = "Lower is faster, further right is more exact. Others at their tightest settings, steps of 10 to 0.1 ms; plm at 1e-4 to 1e-12";
    text(&mut svg, [14.0, 50.0], note, FAINT, "font-size=\"13\"");
    let place = |number: usize| [8.0 + PANEL[0] * (number % 2) as f64, TOP + PANEL[1] * (number / 2) as f64];
    for (number, (scene, title)) in SCENES.into_iter().enumerate() {
        panel(&mut svg, runs, (scene, title), place(number));
    }
    let creep = |run: &Run| run.creep;
    let block =
        Dots {
            scene: "block", title: "Creep of a block at 99 % of its friction (µm/s)", range: [-3.0, 5.0]
        };
    block.draw(&mut svg, runs, &creep, place(4));
    let gain = |run: &Run| run.gain.map(|gain| 100.0 * gain.abs());
    let ball =
        Dots { scene: "ball", title: "Ball: energy off the law at an impact (%)", range: [-13.0, 2.0] };
    ball.draw(&mut svg, runs, &gain, place(5));
    svg + "</svg>\n"
}

fn panel(svg: &mut String, runs: &[Run], (scene, title): (&str, &str), [left, top]: [f64; 2]) {
    let [x0, y0, width, height] = PLOT;
    let (x0, y0) = (left + x0, top + y0);
    let x = |error: f64| x0 + width * (error.log10() - ERRORS[0]) / (ERRORS[1] - ERRORS[0]);
    let y = |seconds: f64| y0 + height * (1.0 - (seconds.log10() - TIMES[0]) / (TIMES[1] - TIMES[0]));
    text(svg, [x0, y0 - 10.0], title, INK, "font-size=\"13\" font-weight=\"600\"");
    for (seconds, name) in [(1e-4, "0.1 ms"), (1e-3, "1 ms"), (1e-2, "10 ms"), (1e-1, "100 ms")] {
        let _ =
            writeln!(svg, "<path d=\"M{x0} {:.1}h{width}\" fill=\"none\" stroke=\"{GRID}\"/>", y(seconds));
        text(svg, [x0 - 6.0, y(seconds) + 4.0], name, FAINT, "font-size=\"12\" text-anchor=\"end\"");
    }
    for (error, name) in
        [(1.0, "1"), (1e-3, "10⁻³"), (1e-6, "10⁻⁶"), (1e-9, "10⁻⁹"), (1e-12, "10⁻¹²"), (1e-15, "10⁻¹⁵")]
    {
        text(svg, [x(error), y0 + height + 17.0], name, FAINT, "font-size=\"12\" text-anchor=\"middle\"");
    }
    let mut labels = Vec::new();
    for (program, settings) in shown() {
        let runs = line(runs, scene, program, settings);
        let points: Vec<[f64; 2]> =
            runs.iter().filter_map(|run| Some([x(run.error?.clamp(1e-15, 30.0)), y(run.seconds)])).collect();
        let Some(&last) = points.last() else { continue };
        curve(svg, &points, colour(program));
        let right = points.iter().fold(last[0], |right, point| right.max(point[0]));
        labels.push((last[1], right, label(program, settings)));
    }
    // The other programs have their names in a column beside their lines.
    let column =
        labels.iter().filter(|(.., program)| *program != "plm").fold(x0, |most, label| most.max(label.1));
    labels.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut above = f64::NEG_INFINITY;
    for (y, right, program) in labels {
        let y = y.max(above + APART);
        above = y;
        let right = if program == "plm" { right } else { column };
        let (x, anchor) =
            if right > x0 + width - 60.0 { (right - 14.0, "end") } else { (right + 10.0, "start") };
        // What ends at the right edge has its name over its line.
        let lift = if anchor == "end" { -14.0 } else { 4.5 };
        let more = format!("font-size=\"13\" font-weight=\"600\" text-anchor=\"{anchor}\"");
        text(svg, [x, y + lift], program, colour(program), &more);
    }
}

pub(crate) fn curve(svg: &mut String, points: &[[f64; 2]], colour: &str) {
    let path: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    let _ = writeln!(
        svg,
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.6\"/>",
        path.join(" ")
    );
    for [x, y] in points {
        dot(svg, [*x, *y], colour);
    }
}

fn dot(svg: &mut String, [x, y]: [f64; 2], colour: &str) {
    let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{colour}\"/>");
}

/// A panel with a row of dots for each program, on a logarithmic axis that begins with zero.
struct Dots {
    scene: &'static str,
    title: &'static str,
    /// Decades of the axis.
    range: [f64; 2],
}

impl Dots {
    fn draw(
        &self,
        svg: &mut String,
        runs: &[Run],
        value: &dyn Fn(&Run) -> Option<f64>,
        [left, top]: [f64; 2],
    ) {
        let (x0, y0, width, height) = (left + 98.0, top + PLOT[1], 298.0, PLOT[3]);
        let [low, high] = self.range;
        let zero = x0 + 14.0;
        let x = |value: f64| {
            let share = (value.log10().max(low) - low) / (high - low);
            if value == 0.0 { zero } else { x0 + 44.0 + (width - 54.0) * share }
        };
        text(svg, [x0 - 26.0, y0 - 10.0], self.title, INK, "font-size=\"13\" font-weight=\"600\"");
        let foot = y0 + height;
        let decades = [-12.0, -9.0, -6.0, -4.0, -3.0, -2.0, 0.0, 2.0, 4.0];
        let step = if high - low > 10.0 { 3.0 } else { 2.0 };
        let marked =
            decades.into_iter().filter(|decade| *decade >= low && *decade <= high && decade % step == 0.0);
        let ticks = marked.map(|decade| (x(10_f64.powf(decade)), power(decade)));
        for (x, name) in [(zero, "0".to_owned())].into_iter().chain(ticks) {
            let _ = writeln!(svg, "<path d=\"M{x:.1} {y0}V{foot}\" fill=\"none\" stroke=\"{GRID}\"/>");
            text(svg, [x, foot + 17.0], &name, FAINT, "font-size=\"12\" text-anchor=\"middle\"");
        }
        for (number, (program, settings)) in shown().enumerate() {
            let y = y0 + 18.0 + 30.0 * number as f64;
            let more = "font-size=\"13\" font-weight=\"600\" text-anchor=\"end\"";
            text(svg, [x0 - 6.0, y + 4.5], label(program, settings), colour(program), more);
            let values: Vec<f64> =
                line(runs, self.scene, program, settings).into_iter().filter_map(value).collect();
            let points: Vec<[f64; 2]> = values.iter().map(|value| [x(*value), y]).collect();
            curve(svg, &points, colour(program));
        }
    }
}

/// `10⁻³`, `1`.
pub(crate) fn power(decade: f64) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if decade == 0.0 {
        return "1".to_owned();
    }
    let sign = if decade < 0.0 { "⁻" } else { "" };
    let digits = format!("{:.0}", decade.abs());
    let raised: String = digits.bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect();
    format!("10{sign}{raised}")
}

pub(crate) fn text(svg: &mut String, [x, y]: [f64; 2], text: &str, colour: &str, more: &str) {
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{colour}\" {more}>{}</text>", escape(text));
}
