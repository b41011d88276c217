//! XML, written element by element at its indentation.

use crate::number::exact;

/// The attributes of an element: names and values.
pub(super) type Attributes<'a> = &'a [(&'a str, String)];

/// A text of XML.
#[derive(Debug, Default)]
pub(super) struct Tags {
    pub(super) text: String,
    depth: usize,
}

impl Tags {
    fn line(&mut self, text: &str) {
        self.text.push_str(&"  ".repeat(self.depth));
        self.text.push_str(text);
        self.text.push('\n');
    }

    pub(super) fn comment(&mut self, text: &str) {
        self.line(&format!("<!-- {text} -->"));
    }

    /// An element without children.
    pub(super) fn empty(&mut self, name: &str, attributes: Attributes) {
        self.line(&format!("<{name}{}/>", shown(attributes)));
    }

    /// An element that holds a text.
    pub(super) fn with_text(&mut self, name: &str, text: &str) {
        self.line(&format!("<{name}>{}</{name}>", escaped(text)));
    }

    /// An element and its children.
    pub(super) fn element(&mut self, name: &str, attributes: Attributes, within: impl FnOnce(&mut Tags)) {
        self.open(name, attributes);
        within(self);
        self.close(name);
    }

    /// Begins an element whose children follow.
    pub(super) fn open(&mut self, name: &str, attributes: Attributes) {
        self.line(&format!("<{name}{}>", shown(attributes)));
        self.depth += 1;
    }

    /// Ends an element.
    pub(super) fn close(&mut self, name: &str) {
        self.depth -= 1;
        self.line(&format!("</{name}>"));
    }
}

/// Attributes with a value: those without are left out.
fn shown(attributes: Attributes) -> String {
    let mut shown = String::new();
    for (name, value) in attributes.iter().filter(|(_, value)| !value.is_empty()) {
        shown.extend([" ", *name, "=\"", &escaped(value), "\""]);
    }
    shown
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Numbers after each other.
pub(super) fn numbers(numbers: &[f64]) -> String {
    numbers.iter().map(|number| exact(*number)).collect::<Vec<_>>().join(" ")
}

/// A number that is left out where it is zero.
pub(super) fn unless_zero(number: f64) -> String {
    if number == 0.0 { String::new() } else { exact(number) }
}

/// Numbers that are left out where all are zero.
pub(super) fn unless_zeros(of: &[f64]) -> String {
    if of.iter().all(|number| exact(*number) == "0") { String::new() } else { numbers(of) }
}
