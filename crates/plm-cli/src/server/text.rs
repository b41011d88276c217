//! Places of the protocol: lines from 0, and columns in units of UTF-16.
//!
//! Language Server Protocol 3.17, "Position": UTF-16 is what every client understands.

use std::ops::Range;

use serde_json::{Value, json};

/// The byte at a place; the end of the line or of the text where that is shorter.
pub(super) fn offset(text: &str, place: &Value) -> Option<usize> {
    let [line, column] = ["line", "character"].map(|of| place[of].as_u64());
    let (line, column) = (usize::try_from(line?).ok()?, usize::try_from(column?).ok()?);
    let start = match line {
        0 => 0,
        _ => text.match_indices('\n').nth(line - 1).map_or(text.len(), |(at, _)| at + 1),
    };
    let line = text[start..].split('\n').next().unwrap_or_default();
    let mut units = 0;
    let letter = line.char_indices().find(|(_, letter)| {
        let is_after = units >= column;
        units += letter.len_utf16();
        is_after
    });
    Some(start + letter.map_or(line.len(), |(at, _)| at))
}

/// The place of a byte.
pub(super) fn position(text: &str, at: usize) -> Value {
    let before = text.get(..at).unwrap_or(text);
    let line = before.rfind('\n').map_or(0, |end| end + 1);
    json!({ "line": before.matches('\n').count(), "character": before[line..].encode_utf16().count() })
}

/// The places of a range of bytes.
pub(super) fn range(text: &str, of: &Range<usize>) -> Value {
    json!({ "start": position(text, of.start), "end": position(text, of.end) })
}

/// The path of a file by its address; an address of another kind as it is.
pub(super) fn path(uri: &str) -> String {
    let Some(path) = uri.strip_prefix("file://") else { return uri.to_owned() };
    let (mut bytes, mut rest) = (Vec::new(), path.as_bytes());
    while let [first, after @ ..] = rest {
        let hex = after.get(..2).and_then(|hex| u8::from_str_radix(std::str::from_utf8(hex).ok()?, 16).ok());
        match (first, hex) {
            (b'%', Some(byte)) => (bytes.push(byte), rest = &after[2..]).1,
            _ => (bytes.push(*first), rest = after).1,
        }
    }
    let path = String::from_utf8_lossy(&bytes).into_owned();
    // `/C:/folder`, as Windows has it.
    let is_drive = path.as_bytes().get(2) == Some(&b':');
    if is_drive { path[1..].to_owned() } else { path }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::{offset, path, position};

    #[test]
    fn places_count_in_utf_16() {
        let text = "a\n\u{1d11e}é b\n";
        let b = text.find('b');
        assert_eq!(position(text, 8), json!({ "line": 1, "character": 3 }));
        assert_eq!(offset(text, &json!({ "line": 1, "character": 4 })), b);
        assert_eq!(offset(text, &json!({ "line": 1, "character": 99 })), Some(text.len() - 1));
        assert_eq!(offset(text, &json!({ "line": 99, "character": 1 })), Some(text.len()));
        assert_eq!(offset(text, &json!({ "line": -1 })), None);
    }

    #[test]
    fn addresses_are_paths() {
        assert_eq!(path("file:///a%20b/%C3%A9.plm"), "/a b/é.plm");
        assert_eq!(path("file:///C%3A/a.plm"), "C:/a.plm");
        assert_eq!(path("untitled:1%2"), "untitled:1%2");
        assert_eq!(path("file:///50%"), "/50%");
    }
}
