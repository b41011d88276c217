//! Labels of axes: quantities, units, powers of ten.

/// `angle (deg)`; the quantity alone for a pure number, the unit alone where the curves have no common name.
pub(super) fn with_unit(quantity: &str, unit: &str) -> String {
    match (quantity, unit) {
        (_, "") => quantity.to_owned(),
        ("", _) => typeset(unit),
        _ => format!("{quantity} ({})", typeset(unit)),
    }
}

/// The last part of dotted names if all have the same one: `angle` for `arm.angle` and `forearm.angle`, nothing
/// for `arm.x` and `arm.y`. A single name is in the legend, so its last part serves too.
pub(super) fn common_quantity<'a>(names: impl Iterator<Item = &'a str>) -> &'a str {
    let mut common = None;
    for name in names {
        let last = name.rsplit('.').next().unwrap_or(name);
        match common {
            Some(other) if other != last => return "",
            _ => common = Some(last),
        }
    }
    common.unwrap_or("")
}

/// A unit as printed: `N*m/s^2` becomes `N·m/s²`.
fn typeset(unit: &str) -> String {
    let mut out = String::new();
    let mut raised = false;
    for character in unit.chars() {
        raised = character == '^' || raised && (character == '-' || character.is_ascii_digit());
        match character {
            '^' => {}
            '*' => out.push('·'),
            _ if raised => out.push(superscript(character)),
            _ => out.push(character),
        }
    }
    out
}

/// `10⁻⁶` for -6.
pub(super) fn power_of_ten(exponent: i32) -> String {
    let digits: String = exponent.to_string().chars().map(superscript).collect();
    format!("10{digits}")
}

fn superscript(character: char) -> char {
    match character {
        '-' => '⁻',
        '0' => '⁰',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::super::table::cases;
    use super::*;

    #[test]
    fn units_are_typeset() {
        for (unit, expected) in cases::<(String, String)>("units") {
            assert_eq!(typeset(&unit), expected);
        }
    }

    #[test]
    fn an_axis_names_what_its_curves_have_in_common() {
        for (names, expected) in cases::<(String, String)>("common") {
            assert_eq!(common_quantity(names.split(' ')), expected);
        }
        assert_eq!(common_quantity([].into_iter()), "");
        for (quantity, unit, expected) in cases::<(String, String, String)>("axes") {
            assert_eq!(with_unit(&quantity, &unit), expected);
        }
    }

    #[test]
    fn powers_of_ten_are_raised() {
        for (exponent, expected) in cases::<(i32, String)>("powers") {
            assert_eq!(power_of_ten(exponent), expected);
        }
    }
}
