//! Summary: how many times longer other programs take than the fastest line of plm, to three errors in four scenes.

use std::fmt::Write as _;

use plm_view::svg::{CURVES, FONT, INK, dark_style, escape};

use crate::measure::Line;

/// Errors at which programs are compared: three, six and nine digits.
pub const GOALS: [f64; 3] = [1e-3, 1e-6, 1e-9];

/// Scenes that other programs are in, and what they are.
pub const SCENES: [(&str, &str); 4] = [
    ("S1", "Double pendulum"),
    ("S2", "Four-bar linkage"),
    ("S5", "Andrews' squeezer, 7 bodies"),
    ("S6", "Slider-crank"),
];

/// Other programs with their colours, distinct for colour-blind readers, and their shapes.
const LOOKS: [(&str, usize, Shape); 4] = [
    ("heyoka", 1, Shape::Diamond),
    ("diffsol Tsit45", 2, Shape::Triangle),
    ("diffsol BDF", 3, Shape::Square),
    ("rapier2d", 4, Shape::Disc),
];

#[derive(Clone, Copy)]
enum Shape {
    Diamond,
    Triangle,
    Square,
    Disc,
}

/// A scene: plm's least times in s, and each program's times as multiples of them; none where the error is not reached.
pub struct Compared {
    pub scene: &'static str,
    pub title: &'static str,
    pub plm: [f64; 3],
    pub others: Vec<(String, [Option<f64>; 3])>,
}

/// Compares the lines of each scene.
///
/// # Errors
/// A scene in which plm has no run to one of the errors.
pub fn compare(lines: &[(String, Line)]) -> Result<Vec<Compared>, String> {
    let compared = SCENES.iter().map(|&(scene, title)| {
        let of_scene = || lines.iter().filter(move |(of, _)| of == scene).map(|(_, line)| line);
        let ours = GOALS.map(|goal| {
            let times = of_scene().filter(|line| !line.formulation.is_empty());
            times.filter_map(|line| Some(line.fastest(goal)?.seconds)).reduce(f64::min)
        });
        let &[Some(a), Some(b), Some(c)] = &ours else {
            return Err(format!("{scene}: plm has no run to {GOALS:?}"));
        };
        let plm = [a, b, c];
        let multiples = |line: &Line| [0, 1, 2].map(|k| Some(line.fastest(GOALS[k])?.seconds / plm[k]));
        let others = of_scene().filter(|line| line.formulation.is_empty());
        let others = others.map(|line| (line.method.clone(), multiples(line))).collect();
        Ok(Compared { scene, title, plm, others })
    });
    compared.collect()
}

const WIDTH: f64 = 800.0;
/// A panel: its place in the grid of two by two, and the plot in it.
const PANEL: [f64; 2] = [392.0, 232.0];
const TOP: f64 = 74.0;
const PLOT: [f64; 4] = [44.0, 30.0, 206.0, 150.0];
/// Multiples at the foot and at the head of a plot.
const RANGE: [f64; 2] = [0.7, 2000.0];
/// Labels stand at least so far apart.
const APART: f64 = 15.0;

/// The picture. `elsewhere` has times of one step that were measured apart: rows of scene, program, its ns, plm's ns.
///
/// # Errors
/// A row that has no times.
pub fn svg(compared: &[Compared], elsewhere: &str) -> Result<String, String> {
    let height = TOP + 2.0 * PANEL[1] + 34.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         font-family=\"{}\" stroke-linejoin=\"round\" role=\"img\" aria-label=\"Time of other programs as multiples of plm's\">\n\
         {}\n<rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#f7f8fa\"/>\n",
        escape(FONT),
        dark_style()
    );
    text(
        &mut svg,
        [14.0, 28.0],
        "How many times longer other programs take",
        INK,
        "font-size=\"17\" font-weight=\"600\"",
    );
    let note = "CPU time to an error of 10⁻³, 10⁻⁶ and 10⁻⁹, over that of plm's fastest method, which stands below (logarithmic)";
    text(&mut svg, [14.0, 50.0], note, FAINT, "font-size=\"13\"");
    for (number, scene) in compared.iter().enumerate() {
        let place = [PANEL[0] * (number % 2) as f64 + 8.0, TOP + PANEL[1] * (number / 2) as f64];
        panel(&mut svg, scene, place);
    }
    let said = format!(
        "Measured apart, on another machine, a step of RK4: {}, {}.",
        beside("CasADi", ", C code,", elsewhere)?,
        beside("MuJoCo", "", elsewhere)?
    );
    text(&mut svg, [14.0, height - 16.0], &said, FAINT, "font-size=\"13\"");
    Ok(svg + "</svg>\n")
}

const FAINT: &str = "#5c6675";
const GRID: &str = "#dfe3ea";

/// What was measured apart, for one program.
fn beside(program: &str, what: &str, elsewhere: &str) -> Result<String, String> {
    let mut multiples = Vec::new();
    let mut name = "";
    for row in elsewhere.lines().skip(1) {
        let fields: Vec<&str> = row.split(',').collect();
        let number = |k: usize| fields.get(k)?.parse::<f64>().ok();
        let (Some(&of), Some(ns), Some(plm)) = (fields.get(1), number(2), number(3)) else {
            return Err(format!("`{row}` has no times"));
        };
        if of.starts_with(program) {
            name = of;
            multiples.push(ns / plm);
        }
    }
    let least = multiples.iter().copied().fold(f64::INFINITY, f64::min);
    let most = multiples.iter().copied().fold(0.0, f64::max);
    Ok(format!("{name}{what} {} to {}", multiple(least), multiple(most)))
}

fn panel(svg: &mut String, scene: &Compared, [left, top]: [f64; 2]) {
    let [x0, y0, width, height] = PLOT;
    let (x0, y0) = (left + x0, top + y0);
    let x = |goal: usize| x0 + 14.0 + (width - 28.0) * goal as f64 / 2.0;
    let y = |multiple: f64| y0 + height * (1.0 - (multiple / RANGE[0]).ln() / (RANGE[1] / RANGE[0]).ln());
    let title = format!("{} ({})", scene.title, scene.scene);
    text(svg, [x0, y0 - 10.0], &title, INK, "font-size=\"13\" font-weight=\"600\"");
    for tick in [1.0, 10.0, 100.0, 1000.0] {
        let _ = writeln!(svg, "<path d=\"M{x0} {0:.1}h{width}\" fill=\"none\" stroke=\"{GRID}\"/>", y(tick));
        let number = format!("{tick}×");
        text(svg, [x0 - 6.0, y(tick) + 4.0], &number, FAINT, "font-size=\"12\" text-anchor=\"end\"");
    }
    for (goal, name) in ["10⁻³", "10⁻⁶", "10⁻⁹"].into_iter().enumerate() {
        text(svg, [x(goal), y0 + height + 16.0], name, FAINT, "font-size=\"12\" text-anchor=\"middle\"");
        let micros = 1e6 * scene.plm[goal];
        let digits = usize::from(micros < 9.95);
        let time = format!("{micros:.digits$} µs");
        text(svg, [x(goal), y0 + height + 32.0], &time, CURVES[0], "font-size=\"12\" text-anchor=\"middle\"");
    }
    let mut labels = vec![(y(1.0), "plm".to_owned(), CURVES[0])];
    let _ = writeln!(
        svg,
        "<path d=\"M{:.1} {:.1}H{:.1}\" fill=\"none\" stroke=\"{}\" stroke-width=\"4\"/>",
        x(0),
        y(1.0),
        x(2),
        CURVES[0]
    );
    for (name, multiples) in &scene.others {
        let Some(&(_, colour, shape)) = LOOKS.iter().find(|(of, ..)| of == name) else { continue };
        let colour = CURVES[colour];
        let there: Vec<(f64, f64, f64)> =
            (0..3).filter_map(|goal| Some((x(goal), y(multiples[goal]?), multiples[goal]?))).collect();
        let path: Vec<String> = there.iter().map(|(x, y, _)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(
            svg,
            "<polyline points=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"2.2\"/>",
            path.join(" ")
        );
        for &(x, y, _) in &there {
            let _ = writeln!(svg, "<path d=\"{}\" fill=\"{colour}\"/>", shape.at(x, y));
        }
        let Some(&(last, height, value)) = there.last() else { continue };
        if multiples[2].is_some() {
            labels.push((height, format!("{name} {}", multiple(value)), colour));
        } else {
            let said = format!("{name} {}, not to 10⁻⁶", multiple(value));
            text(svg, [last + 10.0, height + 4.0], &said, colour, "font-size=\"13\"");
        }
    }
    for (y, label, colour) in apart(labels) {
        text(svg, [x(2) + 12.0, y + 4.5], &label, colour, "font-size=\"13\"");
    }
}

/// Moves labels that are too near to each other apart, the lowest first.
fn apart(mut labels: Vec<(f64, String, &'static str)>) -> Vec<(f64, String, &'static str)> {
    labels.sort_by(|a, b| b.0.total_cmp(&a.0));
    for k in 1..labels.len() {
        labels[k].0 = labels[k].0.min(labels[k - 1].0 - APART);
    }
    labels
}

/// `1.3×`, `29×`; two digits, and no more where there are three.
fn multiple(value: f64) -> String {
    if value < 9.95 {
        format!("{value:.1}×")
    } else if value < 995.0 {
        format!("{value:.0}×")
    } else {
        format!("{:.0}×", 100.0 * (value / 100.0).round())
    }
}

impl Shape {
    /// A path around a point.
    fn at(self, x: f64, y: f64) -> String {
        match self {
            Self::Diamond => format!("M{x:.1} {:.1}l6 6-6 6-6-6z", y - 6.0),
            Self::Triangle => format!("M{x:.1} {:.1}l5.5 9.5h-11z", y - 6.0),
            Self::Square => format!("M{:.1} {:.1}h9v9h-9z", x - 4.5, y - 4.5),
            Self::Disc => format!("M{:.1} {y:.1}a5 5 0 1 0 10 0a5 5 0 1 0-10 0z", x - 5.0),
        }
    }
}

fn text(svg: &mut String, [x, y]: [f64; 2], text: &str, colour: &str, more: &str) {
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" fill=\"{colour}\" {more}>{}</text>", escape(text));
}
