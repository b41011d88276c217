//! A text of bounded length, as C reads it.

use core::ffi::c_char;
use core::fmt;

/// Bytes of a text, the zero at its end among them.
const ROOM: usize = 256;

/// A text that ends with a zero; what does not fit is cut off at a character.
#[derive(Clone, Copy)]
pub struct Text {
    bytes: [u8; ROOM],
    length: usize,
}

impl Text {
    /// No text.
    pub const fn new() -> Self {
        Self { bytes: [0; ROOM], length: 0 }
    }

    /// The text of `words`.
    pub fn of(words: impl fmt::Display) -> Self {
        let mut text = Self::new();
        // It is cut off where it is too long.
        let _ = fmt::Write::write_fmt(&mut text, format_args!("{words}"));
        text
    }

    /// The text.
    pub fn as_str(&self) -> &str {
        self.bytes.get(..self.length).and_then(|bytes| core::str::from_utf8(bytes).ok()).unwrap_or("")
    }

    /// The text for C, with a zero at its end.
    pub fn as_ptr(&self) -> *const c_char {
        self.bytes.as_ptr().cast()
    }
}

impl Default for Text {
    fn default() -> Self {
        Self::new()
    }
}

impl fmt::Write for Text {
    fn write_str(&mut self, words: &str) -> fmt::Result {
        for character in words.chars() {
            let mut buffer = [0; 4];
            let bytes = character.encode_utf8(&mut buffer).as_bytes();
            let end = self.length + bytes.len();
            // The last byte stays zero.
            let room = self.bytes.get_mut(self.length..end).filter(|_| end < ROOM).ok_or(fmt::Error)?;
            room.copy_from_slice(bytes);
            self.length = end;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{ROOM, Text};

    #[test]
    fn what_does_not_fit_is_cut_off_at_a_character() {
        assert_eq!(Text::of(format_args!("{} {}", "a", 1)).as_str(), "a 1");
        let long = Text::of(
            ["µ"; 300]
                .iter()
                .fold(Text::new(), |mut text, word| {
                    let _ = core::fmt::Write::write_str(&mut text, word);
                    text
                })
                .as_str(),
        );
        assert_eq!(long.as_str().chars().count(), (ROOM - 1) / 2);
        assert_eq!(long.bytes.last(), Some(&0));
    }
}
