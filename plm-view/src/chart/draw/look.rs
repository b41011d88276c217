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
    }
}
