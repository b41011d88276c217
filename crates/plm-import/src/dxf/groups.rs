//! Groups of a DXF file: pairs of lines, a code and its value; the text of its bytes.

use std::borrow::Cow;
use std::rc::Rc;

use encoding_rs::{Encoding, WINDOWS_1252};

use crate::notice::{Notices, Place};

/// A group code with its value and its place.
pub(super) struct Group {
    pub(super) code: i32,
    pub(super) value: String,
    pub(super) place: Place,
}

/// The text of a drawing from its bytes: UTF-8, or what `$DWGCODEPAGE` says, as files before AutoCAD 2007 have it.
///
/// # Errors
/// A drawing in binary form, a code page that is not known: a message.
pub fn drawing_text(bytes: &[u8]) -> Result<Cow<'_, str>, String> {
    if bytes.starts_with(b"AutoCAD Binary DXF") {
        return Err("this DXF is binary: save it as text (ASCII)".to_owned());
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if let Ok(text) = std::str::from_utf8(bytes) {
        return Ok(Cow::Borrowed(text));
    }
    let page = code_page(bytes).unwrap_or_else(|| "ANSI_1252".to_owned());
    let encoding =
        encoding(&page).ok_or_else(|| format!("the code page {page} ($DWGCODEPAGE) is not known"))?;
    Ok(encoding.decode_without_bom_handling(bytes).0)
}

/// The value of `$DWGCODEPAGE`, which stands two lines after it.
fn code_page(bytes: &[u8]) -> Option<String> {
    let name = b"$DWGCODEPAGE";
    let at = bytes.windows(name.len()).position(|window| window == name)?;
    let line = bytes[at..].split(|byte| *byte == b'\n').nth(2)?;
    Some(String::from_utf8_lossy(line).trim().to_uppercase())
}

/// The encoding of a code page of AutoCAD.
fn encoding(page: &str) -> Option<&'static Encoding> {
    let number = page.strip_prefix("ANSI_").or_else(|| page.strip_prefix("DOS"));
    let label = match (page, number) {
        ("UTF-8" | "UTF8", _) => "utf-8",
        (_, Some("932")) => "shift_jis",
        (_, Some("936")) => "gbk",
        (_, Some("949" | "1361")) => "euc-kr",
        (_, Some("950")) => "big5",
        (_, Some("874")) => "windows-874",
        (_, Some("866")) => "ibm866",
        (_, Some(number)) if page.starts_with("ANSI_") => {
            return Encoding::for_label(format!("windows-{number}").as_bytes());
        }
        // Names alone depend on it: numbers are ASCII in all of them.
        ("ASCII", _) | (_, Some(_)) => return Some(WINDOWS_1252),
        _ => {
            return page
                .strip_prefix("ISO")
                .and_then(|part| Encoding::for_label(format!("iso-{part}").as_bytes()));
        }
    };
    Encoding::for_label(label.as_bytes())
}

pub(super) fn groups(file: &Rc<str>, text: &str, notices: &mut Notices) -> Option<Vec<Group>> {
    let mut groups = Vec::new();
    let mut lines = text.lines().enumerate();
    while let (Some((number, code)), Some((_, value))) = (lines.next(), lines.next()) {
        let place = Place { file: file.clone(), line: number as u32 + 1, column: 1 };
        let Ok(code) = code.trim().parse() else {
            notices.error(
                &place,
                format!("this is no DXF of text: expected a group code, found `{}`", code.trim()),
            );
            return None;
        };
        groups.push(Group { code, value: named(value.trim()), place });
    }
    if groups.first().is_none_or(|first| !matches!(first.code, 0 | 999)) {
        let place = Place { file: file.clone(), line: 1, column: 1 };
        notices.error(&place, "this is no DXF: it does not begin with a section");
        return None;
    }
    // Comments.
    groups.retain(|group| group.code != 999);
    Some(groups)
}

/// A value with the letters that are written by their numbers, `\U+00FC`.
fn named(value: &str) -> String {
    let mut parts = value.split("\\U+");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let letter = part.get(..4).and_then(|hex| u32::from_str_radix(hex, 16).ok()).and_then(char::from_u32);
        if let Some(letter) = letter {
            text.push(letter);
            text.push_str(&part[4..]);
        } else {
            text.push_str("\\U+");
            text.push_str(part);
        }
    }
    text
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{drawing_text, named};

    #[test]
    fn bytes_are_those_of_the_code_page() {
        let of = |page: &str, bytes: &[u8]| {
            [b"9\n$DWGCODEPAGE\n3\n", page.as_bytes(), b"\r\n8\n", bytes, b"\n"].concat()
        };
        for (page, bytes, name) in [
            ("ANSI_1252", &b"Schl\xfcssel"[..], "Schlüssel"),
            ("ANSI_1251", b"\xca\xee\xed\xf2\xf3\xf0", "Контур"),
            ("ANSI_932", b"\x8aO\x8c`", "外形"),
            ("ANSI_936", b"\xc2\xd6\xc0\xaa", "轮廓"),
            ("ANSI_1250", b"\xb3", "ł"),
            ("ISO8859-1", b"\xfc", "ü"),
        ] {
            let all = of(page, bytes);
            let text = drawing_text(&all).unwrap();
            assert!(text.ends_with(&format!("8\n{name}\n")), "{page}: {text}");
        }
        assert!(drawing_text(&of("ANSI_9999", b"\xfc")).is_err());
        assert!(drawing_text(b"AutoCAD Binary DXF\r\n\x1a\0").is_err());
        assert_eq!(named("Schl\\U+00FCssel \\U+zz"), "Schlüssel \\U+zz");
    }
}
