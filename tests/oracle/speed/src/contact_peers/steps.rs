//! The picture and tables of the time stepping of Moreau and Jean: error against step, beside the event-driven run.

use std::fmt::Write as _;

use plm_view::svg::{CURVES, FONT, INK, dark_style, escape};

use crate::chart::{FAINT, GRID, SCENES, curve, power, text};
use crate::runs::{Run, line};

/// Settings of the runs.
pub const LINES: [&str; 3] = ["theta 0.5", "theta 1", "two evaluations"];

/// Names of the curves in the legend: those of the settings, then that of Siconos.
const NAMES: [&str; 4] = ["θ = 1/2", "θ = 1", "θ = 1/2, two evaluations", "Siconos, θ = 1/2"];
/// Colours of the curves, as indices of `CURVES`.
const COLOURS: [usize; 4] = [0, 1, 2, 4];

const WIDTH: f64 = 860.0;
const PANEL: [f64; 2] = [422.0, 268.0];
const TOP: f64 = 74.0;
/// The plot in a panel: left, top, width, height.
const PLOT: [f64; 4] = [58.0, 30.0, 338.0, 184.0];
/// Decades of the step, s, from left to right, and of the error, from the foot.
const STEPS: [f64; 2] = [-1.9, -4.2];
const ERRORS: [f64; 2] = [-12.0, 1.0];

/// Scenes and their titles: those that other programs run too, and those of time stepping alone.
const STEPPED: [(&str, &str); 7] = [
    SCENES[0],
    SCENES[1],
    SCENES[2],
    SCENES[3],
    ("belt", "Mass on a belt, slips for the third time (m)"),
    ("rope", "Mass that a rope has caught, 1.5 s (m)"),
    ("shaken", "Ball on a shaken table, sixth flight (m)"),
];

/// Draws it; `peers` has the event-driven runs, and Siconos.
pub fn svg(runs: &[Run], peers: &[Run]) -> String {
    let height = TOP + STEPPED.len().div_ceil(2) as f64 * PANEL[1] + 8.0;
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" \
         font-family=\"{}\" stroke-linejoin=\"round\" role=\"img\" aria-label=\"Error against step in scenes with contact\">\n{}\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#f7f8fa\"/>\n",
        escape(FONT),
        dark_style()
    );
    let title = "Steps of Moreau and Jean: error against step";
    text(&mut svg, [14.0, 28.0], title, INK, "font-size=\"17\" font-weight=\"600\"");
    let note = "Dashed: the event-driven run (Dop853 at 1e-8). Finer steps further right; errors at the end of the scene";
    text(&mut svg, [14.0, 50.0], note, FAINT, "font-size=\"13\"");
    for (number, (scene, title)) in STEPPED.into_iter().enumerate() {
        let place = [8.0 + PANEL[0] * (number % 2) as f64, TOP + PANEL[1] * (number / 2) as f64];
        panel(&mut svg, (runs, peers), (scene, title), place);
    }
    let last = STEPPED.len();
    legend(&mut svg, [8.0 + PANEL[0] * (last % 2) as f64, TOP + PANEL[1] * (last / 2) as f64]);
    svg + "</svg>\n"
}

/// The legend, in the place of the panel after the last one.
fn legend(svg: &mut String, [left, top]: [f64; 2]) {
    let [x0, y0, ..] = PLOT;
    for (number, (name, colour)) in NAMES.into_iter().zip(COLOURS).enumerate() {
        let [x, y] = [left + x0, top + y0 + 22.0 * number as f64];
        curve(svg, &[[x, y - 4.0], [x + 30.0, y - 4.0]], CURVES[colour]);
        text(svg, [x + 42.0, y], name, CURVES[colour], "font-size=\"13\" font-weight=\"600\"");
    }
}

fn panel(
    svg: &mut String,
    (runs, peers): (&[Run], &[Run]),
    (scene, title): (&str, &str),
    [left, top]: [f64; 2],
) {
    let [x0, y0, width, height] = PLOT;
    let (x0, y0) = (left + x0, top + y0);
    let x = |step: f64| x0 + width * (step.log10() - STEPS[0]) / (STEPS[1] - STEPS[0]);
    let y = |error: f64| {
        let error = error.log10().clamp(ERRORS[0], ERRORS[1]);
        y0 + height * (1.0 - (error - ERRORS[0]) / (ERRORS[1] - ERRORS[0]))
    };
    text(svg, [x0, y0 - 10.0], title, INK, "font-size=\"13\" font-weight=\"600\"");
    for decade in [0.0, -3.0, -6.0, -9.0, -12.0] {
        let at = y(10_f64.powf(decade));
        let _ = writeln!(svg, "<path d=\"M{x0} {at:.1}h{width}\" fill=\"none\" stroke=\"{GRID}\"/>");
        let more = "font-size=\"12\" text-anchor=\"end\"";
        text(svg, [x0 - 6.0, at + 4.0], &power(decade), FAINT, more);
    }
    for (step, name) in [(1e-2, "10 ms"), (1e-3, "1 ms"), (1e-4, "0.1 ms")] {
        text(svg, [x(step), y0 + height + 17.0], name, FAINT, "font-size=\"12\" text-anchor=\"middle\"");
    }
    let ours =
        LINES.iter().zip(COLOURS).map(|(settings, colour)| (line(runs, scene, "plm", settings), colour));
    let siconos = (line(peers, scene, "Siconos", "Moreau-Jean"), COLOURS[3]);
    for (line, colour) in ours.chain([siconos]) {
        let points: Vec<[f64; 2]> =
            line.iter().filter_map(|run| Some([x(run.size), y(run.error?)])).collect();
        if !points.is_empty() {
            curve(svg, &points, CURVES[colour]);
        }
    }
    let by_events = [peers, runs]
        .map(|runs| line(runs, scene, "plm", "DOP853"))
        .into_iter()
        .flatten()
        .find(|run| (run.size / 1e-8 - 1.0).abs() < 1e-6);
    if let Some(error) = by_events.and_then(|run| run.error) {
        let at = y(error);
        let _ = writeln!(
            svg,
            "<path d=\"M{x0} {at:.1}h{width}\" fill=\"none\" stroke=\"{FAINT}\" stroke-dasharray=\"5 4\" stroke-width=\"1.6\"/>"
        );
    }
}

/// Errors, creep and energy at three steps, each table between anchors.
pub fn tables(runs: &[Run]) -> String {
    let error = |run: &Run| run.error;
    let mut text = String::new();
    for (scene, _) in STEPPED {
        text += &table(runs, (scene, scene), &error);
    }
    text += &table(runs, ("creep-block", "block"), &|run| run.creep);
    text += &table(runs, ("creep-oscillator", "oscillator"), &|run| run.creep);
    text += &table(runs, ("gain-ball", "ball"), &|run| run.gain);
    text += &table(runs, ("gain-rocking", "rocking"), &|run| run.gain);
    text += &table(runs, ("gain-rope", "rope"), &|run| run.gain);
    text
}

fn table(runs: &[Run], (mark, scene): (&str, &str), value: &dyn Fn(&Run) -> Option<f64>) -> String {
    let mut text = format!("<!-- ANCHOR: {mark} -->\n| | 10 ms | 1 ms | 0.1 ms |\n|---|---:|---:|---:|\n");
    for settings in LINES {
        let line = line(runs, scene, "plm", settings);
        if line.is_empty() {
            continue;
        }
        let cells = [1e-2, 1e-3, 1e-4].map(|step| {
            let run = line.iter().find(|run| (run.size / step - 1.0).abs() < 1e-6);
            match run.and_then(|run| value(run)) {
                Some(0.0) => "0".to_owned(),
                Some(value) => format!("{value:.1e}"),
                None => "–".to_owned(),
            }
        });
        let _ = writeln!(text, "| {settings} | {} |", cells.join(" | "));
    }
    text + &format!("<!-- ANCHOR_END: {mark} -->\n\n")
}
