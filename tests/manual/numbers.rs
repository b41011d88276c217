//! What the manual prints, and the sheets beside it.

use serde_json::Value;

use crate::demos::sheet::{Reading, Source};

/// Figures of a demo.
fn figures(demo: &str) -> serde_json::Map<String, Value> {
    let all: Value = serde_json::from_str(include_str!("numbers.json")).unwrap();
    all.get(demo).and_then(Value::as_object).cloned().unwrap_or_default()
}

/// Names of the figures that the manual prints for a demo: those that an independent model of it reproduces, or the others.
pub(crate) fn reproduced(demo: &str, wanted: bool) -> Vec<String> {
    let mut figures = figures(demo);
    figures.retain(|_, figure| figure["reproduced_by_an_independent_model"] == wanted);
    figures.keys().cloned().collect()
}

/// How much of the exact value of the independent model a run may be off. Its own runs are that good: a relative tolerance of
/// 1e-9 over 40 s, and a mean speed over a stretch of the run of its own.
const EXACT: f64 = 1e-6;

/// The sheet compares its value with what the manual prints and as the manual wrote it, and the value is the one after the
/// print.
pub(crate) fn agrees(demo: &str, name: &str) {
    let figures = figures(demo);
    let figure = figures.get(name).unwrap_or_else(|| panic!("{demo} has no figure `{name}`"));
    let number = |key: &str| figure[key].as_f64().unwrap();
    let text = |key: &str| figure[key].as_str().unwrap();

    let line = super::line(demo, name);
    let Source::Manual(reading) = line.source else { panic!("{line}: not taken from the manual") };
    let reading = match reading {
        Reading::Rounded(tolerance) => ("round", tolerance),
        Reading::Truncated(tolerance) => ("trunc", tolerance),
        Reading::Approximate(tolerance) => ("approx", tolerance),
    };
    assert_eq!(reading, (text("reading"), number("tol")), "{line}");
    assert_eq!((line.known, line.unit), (number("stated"), text("unit")), "{line}");
    assert!(line.holds(), "{line}");

    let exact = number("exact");
    let off = (line.value - exact).abs();
    assert!(off <= EXACT * exact.abs().max(1.0), "{line}: {off:e} off {exact}");
}

#[test]
fn a_figure_that_is_off_is_missed() {
    use crate::demos::sheet::Line;
    let holds = |value, reading| {
        let name = "figure".to_owned();
        Line { name, value, unit: "N", known: 169.91, source: Source::Manual(reading) }.holds()
    };
    assert!(holds(169.914, Reading::Rounded(0.01)) && holds(169.906, Reading::Rounded(0.01)));
    assert!(!holds(169.921, Reading::Rounded(0.01)) && !holds(f64::NAN, Reading::Rounded(0.01)));
    assert!(holds(169.914, Reading::Truncated(0.01)) && !holds(169.906, Reading::Truncated(0.01)));
    assert!(holds(172.0, Reading::Approximate(5.0)) && !holds(160.0, Reading::Approximate(5.0)));
}

/// The sheet compares its value with that of the independent model.
pub(crate) fn agrees_with_the_model(demo: &str, name: &str) {
    let (figure, line) = (&figures(demo)[name], super::line(demo, name));
    let exact = figure["exact"].as_f64().unwrap();
    assert!(matches!(line.source, Source::Model(_)), "{line}");
    assert!((line.known - exact).abs() <= 1e-9 * exact.abs() && line.holds(), "{line}");
}
