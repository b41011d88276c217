//! Letters in pixels: those of Noto Sans Mono, set by the width of their ink.

use std::ops::Range;

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster};

/// A letter with the room that it takes.
pub(super) struct Letter {
    /// Rows of pixels, 255 where they are full of ink.
    pub(super) rows: Vec<&'static [u8]>,
    /// The columns that have ink.
    pub(super) ink: Range<usize>,
    /// Pixels from its beginning to that of the next one.
    pub(super) advance: usize,
}

/// The letters of a text, of the height that is next to what is wanted, in pixels. Those that there are not are question marks.
pub(super) fn of(text: &str, height: f64) -> Vec<Letter> {
    let size = if height > 24.0 { RasterHeight::Size32 } else { RasterHeight::Size24 };
    let of = |letter| get_raster(letter, FontWeight::Regular, size);
    let letters = text.chars().filter_map(|letter| of(letter).or_else(|| of('?')));
    letters
        .map(|letter| {
            let rows: Vec<&[u8]> = letter.rows().collect();
            let has_ink = |column: &usize| rows.iter().any(|row| row[*column] > 0);
            let mut columns = (0..letter.width()).filter(has_ink);
            let ink = columns.next().map_or(0..0, |first| first..columns.next_back().unwrap_or(first) + 1);
            // A blank is narrower than a letter is.
            let own = if ink.is_empty() { letter.width() / 3 } else { ink.len() };
            Letter { rows, ink, advance: own + letter.height() / 10 }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::of;

    #[test]
    fn letters_have_the_room_of_their_ink() {
        let width = |text: &str| of(text, 26.0).iter().map(|letter| letter.advance).sum::<usize>();
        assert!(width(".") < width("m") && width(" ") > 0 && width("") == 0);
        assert_eq!(width("ab"), width("a") + width("b"));
        // Of Latin-1, and beyond it.
        assert_ne!(width("ü"), 0);
        assert_eq!(width("\u{3c6}"), width("?"));
        assert!(of("a", 22.0)[0].rows.len() < of("a", 26.0)[0].rows.len());
    }
}
