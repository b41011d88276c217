//! Places of a text.

use std::ops::Range;

/// The range in the text as declared of one in the text as read, which has brackets that were missing, and lines that end as on Unix.
pub fn as_declared(read: &str, declared: &str, range: Range<usize>) -> Range<usize> {
    if read == declared {
        return range;
    }
    let place = |end: usize| {
        let mut rest = declared.chars().peekable();
        let mut bytes = 0;
        for letter in read.get(..end).unwrap_or(read).chars() {
            if letter == '\n' && rest.next_if_eq(&'\r').is_some() {
                bytes += 1;
            }
            if rest.next_if_eq(&letter).is_some() {
                bytes += letter.len_utf8();
            }
        }
        bytes
    };
    place(range.start)..place(range.end)
}

#[cfg(test)]
mod tests {
    use super::as_declared;

    #[test]
    fn places_of_a_file_from_windows_are_its_own() {
        let declared = "a\r\n{\r\n(1; }\r\nb";
        let read = "a\n{\n(1; )}\nb";
        assert_eq!(as_declared(read, declared, 11..12), 13..14);
        assert_eq!(declared.get(13..14), Some("b"));
    }
}
