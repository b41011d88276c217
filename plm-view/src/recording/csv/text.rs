//! The bytes of a table as lines of UTF-8.

use std::borrow::Cow;

/// The bytes as UTF-8 without a byte-order mark, each line of which has a line feed at its end: Excel's text in Unicode is UTF-16, and old
/// programs of the Macintosh end lines with a carriage return alone.
///
/// # Errors
/// UTF-16 that is none.
pub(super) fn lines(bytes: &[u8]) -> Result<Cow<'_, [u8]>, String> {
    let wide = |of: fn([u8; 2]) -> u16| {
        let units: Vec<u16> =
            bytes[2..].chunks(2).map(|pair| of([pair[0], *pair.get(1).unwrap_or(&0)])).collect();
        String::from_utf16(&units).map_err(|_| "line 1: found UTF-16 that is no text".to_owned())
    };
    let text = if bytes.starts_with(&[0xff, 0xfe]) {
        Cow::Owned(wide(u16::from_le_bytes)?.into_bytes())
    } else if bytes.starts_with(&[0xfe, 0xff]) {
        Cow::Owned(wide(u16::from_be_bytes)?.into_bytes())
    } else {
        Cow::Borrowed(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))
    };
    let ends_by_return_alone = text.contains(&b'\r') && !text.contains(&b'\n');
    if ends_by_return_alone {
        let feeds = text.iter().map(|byte| if *byte == b'\r' { b'\n' } else { *byte }).collect();
        return Ok(Cow::Owned(feeds));
    }
    Ok(text)
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
