//! Colours and fonts: those of the page in its light theme (page/src/palette.js, page/src/pen.js). page/tests/ticks.json holds
//! both to one table.

/// Families of letters, the first that a reader has.
pub const FONT: &str = "system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";
pub(super) const BACKGROUND: &str = "#f7f8fa";
/// Titles, legends, lines of reference.
pub const INK: &str = "#1d2430";
/// Numbers and names of axes, and the line at zero.
pub(super) const FAINT: &str = "#5c6675";
/// Frames, and lines at the other ticks.
pub(super) const GRID: &str = "#dfe3ea";
/// Colour of curves for comparison.
pub(super) const MUTED: &str = "#808080";

/// Distinct for colour-blind readers too: M. Okabe, K. Ito, "Color universal design", 2008; darkened where they would be faint
/// on white.
pub const CURVES: [&str; 8] =
    ["#0067b1", "#d55e00", "#008a63", "#b8578f", "#a07800", "#1283b8", "#8a2be2", "#444444"];

/// Each colour, and what stands in its place where the reader prefers a dark scheme: the page's dark theme.
const DARK: [(&str, &str); 12] = [
    (BACKGROUND, "#161a21"),
    (INK, "#e6eaf1"),
    (FAINT, "#9aa5b6"),
    (GRID, "#2c333f"),
    (CURVES[0], "#5fb0f0"),
    (CURVES[1], "#ff9a56"),
    (CURVES[2], "#3fd0a0"),
    (CURVES[3], "#e79ac4"),
    (CURVES[4], "#e8c34a"),
    (CURVES[5], "#9ad7ff"),
    (CURVES[6], "#c79bff"),
    (CURVES[7], "#c8ccd4"),
];

/// Style of a chart for readers who prefer a dark scheme. A rule of style goes before an attribute, so the shapes stay as
/// they are; the background stays a filled rectangle, so that the chart can be read on a page of the other scheme.
pub fn dark_style() -> String {
    let rules = DARK.map(|(light, dark)| {
        format!("[fill=\"{light}\"]{{fill:{dark}}}[stroke=\"{light}\"]{{stroke:{dark}}}")
    });
    format!("<style>@media(prefers-color-scheme:dark){{{}}}</style>", rules.concat())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::table::cases;

    #[test]
    fn charts_look_as_in_the_page() {
        let known: Vec<(String, String)> = cases("look");
        let ours =
            [("font", FONT), ("background", BACKGROUND), ("ink", INK), ("faint", FAINT), ("grid", GRID)];
        let ours = ours.map(|(name, value)| (name.to_owned(), value.to_owned()));
        assert_eq!(known, ours);
        assert_eq!(cases::<String>("curves"), CURVES);
        let dark = DARK.map(|(_, dark)| dark.to_owned());
        assert_eq!(cases::<String>("dark"), dark);
    }
}
