//! The bytes of a table as lines of UTF-8.

use std::borrow::Cow;

/// A table as text.
pub(super) struct Text<'a> {
    /// UTF-8 without a byte-order mark, each line of which has a line feed at its end.
    pub(super) lines: Cow<'a, [u8]>,
    /// Notice on how the bytes were read.
    pub(super) notice: Option<String>,
}

impl<'a> Text<'a> {
    /// Reads bytes: UTF-8, UTF-16 with its mark, as Excel's text in Unicode is, or code page 1252, as spreadsheets on Windows write CSV. Old
    /// programs of the Macintosh end lines with a carriage return alone.
    ///
    /// # Errors
    /// UTF-16 that is none.
    pub(super) fn of(bytes: &'a [u8]) -> Result<Self, String> {
        if bytes.starts_with(&[0xff, 0xfe]) {
            return Ok(Self::plain(Cow::Owned(wide(bytes, u16::from_le_bytes)?)));
        }
        if bytes.starts_with(&[0xfe, 0xff]) {
            return Ok(Self::plain(Cow::Owned(wide(bytes, u16::from_be_bytes)?)));
        }
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let Err(why) = std::str::from_utf8(bytes) else { return Ok(Self::plain(Cow::Borrowed(bytes))) };
        let text: String = bytes.iter().map(|byte| letter(*byte)).collect();
        let before = fed(Cow::Owned(bytes.to_vec()));
        let line = before[..why.valid_up_to()].split(|byte| *byte == b'\n').count();
        let notice = format!("line {line} is no UTF-8: the table is read as of code page 1252");
        Ok(Self { notice: Some(notice), ..Self::plain(Cow::Owned(text.into_bytes())) })
    }

    fn plain(lines: Cow<'a, [u8]>) -> Self {
        Self { lines: fed(lines), notice: None }
    }
}

/// The letters of code page 1252 from 0x80 to 0x9f, where it is not Latin-1; the five that it leaves open are as in the Encoding Standard
/// of the WHATWG.
const OF_1252: [char; 32] = [
    '\u{20ac}', '\u{81}', '\u{201a}', '\u{192}', '\u{201e}', '\u{2026}', '\u{2020}', '\u{2021}', '\u{2c6}',
    '\u{2030}', '\u{160}', '\u{2039}', '\u{152}', '\u{8d}', '\u{17d}', '\u{8f}', '\u{90}', '\u{2018}',
    '\u{2019}', '\u{201c}', '\u{201d}', '\u{2022}', '\u{2013}', '\u{2014}', '\u{2dc}', '\u{2122}', '\u{161}',
    '\u{203a}', '\u{153}', '\u{9d}', '\u{17e}', '\u{178}',
];

/// The letter of a byte of code page 1252.
fn letter(byte: u8) -> char {
    let own = byte.checked_sub(0x80).and_then(|at| OF_1252.get(usize::from(at)));
    own.copied().unwrap_or(char::from(byte))
}

/// UTF-16 after its mark as UTF-8.
fn wide(bytes: &[u8], of: fn([u8; 2]) -> u16) -> Result<Vec<u8>, String> {
    let units: Vec<u16> =
        bytes[2..].chunks(2).map(|pair| of([pair[0], *pair.get(1).unwrap_or(&0)])).collect();
    let text = String::from_utf16(&units).map_err(|_| "line 1: found UTF-16 that is no text".to_owned())?;
    Ok(text.into_bytes())
}

/// The text with a line feed at the end of each line.
fn fed(text: Cow<'_, [u8]>) -> Cow<'_, [u8]> {
    let ends_by_return_alone = text.contains(&b'\r') && !text.contains(&b'\n');
    if !ends_by_return_alone {
        return text;
    }
    Cow::Owned(text.iter().map(|byte| if *byte == b'\r' { b'\n' } else { *byte }).collect())
}

/// The separator that Excel's line `sep=;` names, if the first line is one; it becomes a comment.
pub(super) fn named_separator(text: &mut Cow<'_, [u8]>) -> Option<u8> {
    let end = text.iter().position(|byte| *byte == b'\n').unwrap_or(text.len());
    let first = text[..end].strip_suffix(b"\r").unwrap_or(&text[..end]);
    // A spreadsheet that writes the line again fills the other columns of it, and may put it between quotes.
    let first = first.strip_prefix(b"\"").unwrap_or(first);
    let (name, rest) = first.split_at_checked(4)?;
    let separator = *rest.first()?;
    if !name.eq_ignore_ascii_case(b"sep=") || separator.is_ascii_alphanumeric() {
        return None;
    }
    text.to_mut()[0] = b'#';
    Some(separator)
}
