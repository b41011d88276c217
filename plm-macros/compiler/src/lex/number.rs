//! The form of a number: digits, fraction, exponent, suffix.

/// A number literal taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NumberText<'a> {
    /// What [`plm_cas::Number::parse_decimal`] reads.
    pub number: &'a str,
    /// What follows without a space, e.g. the `m` of `0.5m`; mostly empty.
    pub suffix: &'a str,
}

/// Takes a literal that begins with a digit apart. Like rustc, an exponent needs a digit, and a point that is followed
/// by a second one or by a name does not belong to the number.
pub fn split_number(text: &str) -> NumberText<'_> {
    let bytes = text.as_bytes();
    let digits =
        |from: usize| from + bytes[from..].iter().take_while(|b| b.is_ascii_digit() || **b == b'_').count();
    let mut end = digits(0);
    if bytes.get(end) == Some(&b'.') && !begins_name_or_point(&text[end + 1..]) {
        end = digits(end + 1);
    }
    if let Some(b'e' | b'E') = bytes.get(end) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) {
            end = digits(end + 1 + sign);
        }
    }
    NumberText { number: &text[..end], suffix: &text[end..] }
}

fn begins_name_or_point(rest: &str) -> bool {
    rest.chars().next().is_some_and(|c| c == '.' || c == '_' || c.is_alphabetic())
}

#[cfg(test)]
mod tests {
    use super::split_number;

    #[test]
    fn numbers_come_apart_as_in_rustc() {
        let cases = [
            ("0.5", "0.5", ""),
            ("0.5m", "0.5", "m"),
            ("1e-3", "1e-3", ""),
            ("1e5N", "1e5", "N"),
            ("10", "10", ""),
            ("1_000", "1_000", ""),
            ("2.", "2.", ""),
            ("3em", "3", "em"),
            ("0..64", "0", "..64"),
            ("1.x", "1", ".x"),
            ("0x10", "0", "x10"),
        ];
        for (text, number, suffix) in cases {
            let split = split_number(text);
            assert_eq!((split.number, split.suffix), (number, suffix), "{text}");
        }
    }
}
