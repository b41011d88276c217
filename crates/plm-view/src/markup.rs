//! Text in HTML and SVG.

/// A text as it stands between tags, and in attributes with double quotes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
