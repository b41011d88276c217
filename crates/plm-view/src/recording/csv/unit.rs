//! Units as headings have them.

/// Names of units that headings have without a blank before them: those of declarations and what instruments write in their places.
const NAMES: [&str; 54] = [
    "m", "mm", "cm", "km", "um", "\u{b5}m", "\u{3bc}m", "L", "l", "kg", "g", "gram", "t", "tonne", "s", "ms",
    "us", "min", "h", "Hz", "rad", "deg", "degree", "\u{b0}", "rev", "N", "kN", "Nm", "kNm", "J", "kJ", "W",
    "kW", "Pa", "kPa", "MPa", "GPa", "bar", "cP", "K", "A", "ampere", "V", "volt", "ohm", "henry", "mV",
    "mA", "rpm", "1", "%", "-", "in", "ft",
];

/// Is a text a unit, such as `N*m/rad` or `m/s²`?
pub(super) fn is_unit(text: &str) -> bool {
    let atoms = text.split(['*', '/', '\u{b7}', '\u{d7}', '(', ')', ' ']).filter(|atom| !atom.is_empty());
    let is_atom = |atom: &str| {
        let name = atom.trim_end_matches(['2', '3', '^', '\u{b2}', '\u{b3}']);
        NAMES.contains(&name) || (name.is_empty() && atom == "1")
    };
    !text.is_empty() && atoms.clone().count() > 0 && atoms.clone().all(is_atom)
}

/// The unit as declarations write it: signs of degrees, of products and of powers are spelled out.
pub(super) fn spelled(unit: &str) -> String {
    let unit = unit.trim();
    match unit {
        "-" | "1" => return String::new(),
        "Nm" => return "N*m".to_owned(),
        "kNm" => return "kN*m".to_owned(),
        "rpm" => return "rev/min".to_owned(),
        "l" => return "L".to_owned(),
        _ => {}
    }
    let mut text = String::new();
    for letter in unit.chars() {
        match letter {
            '\u{b0}' => text.push_str("deg"),
            '\u{b7}' | '\u{d7}' => text.push('*'),
            '\u{b2}' => text.push_str("^2"),
            '\u{b3}' => text.push_str("^3"),
            '\u{b5}' | '\u{3bc}' => text.push('u'),
            _ => text.push(letter),
        }
    }
    text
}
