//! Bytes as text of which each letter is seven bits, in one byte of UTF-8: 8/7 of the bytes, where base 64 takes 4/3.
//!
//! HTML changes or reads three letters: NUL, CR and `<`. Each of them becomes, with the seven bits after it, one letter of two bytes.
//! `page/src/dense.js` reads it.

/// The letters that may not stand there.
const BARRED: [u8; 3] = [0, 13, 60];
/// The first letter of two bytes: after the control characters.
const FIRST_PAIR: u32 = 0xa0;

/// The text of some bytes; it can stand in a `<script>`.
pub(super) fn dense(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len() * 8 / 7 + 2);
    let mut sevens = sevens(bytes);
    while let Some(seven) = sevens.next() {
        let Some(kind) = BARRED.iter().position(|barred| *barred == seven) else {
            text.push(char::from(seven));
            continue;
        };
        // After the pairs stand those that have nothing after them.
        let pair = match sevens.next() {
            Some(next) => kind * 128 + usize::from(next),
            None => (BARRED.len() + kind) * 128,
        };
        text.extend(u32::try_from(pair).ok().and_then(|pair| char::from_u32(FIRST_PAIR + pair)));
    }
    text
}

/// Seven bits each, the highest first; zeros fill the last one.
fn sevens(bytes: &[u8]) -> impl Iterator<Item = u8> {
    let bit = |at: usize| bytes.get(at / 8).map_or(0, |byte| byte >> (7 - at % 8) & 1);
    (0..(bytes.len() * 8).div_ceil(7))
        .map(move |k| (7 * k..7 * k + 7).fold(0, |seven, at| seven << 1 | bit(at)))
}

#[cfg(test)]
mod tests {
    use super::{BARRED, FIRST_PAIR, dense};

    /// The bytes of a text, as the page reads them.
    fn read(text: &str) -> Vec<u8> {
        let mut sevens: Vec<u8> = Vec::new();
        for letter in text.chars() {
            match u32::from(letter).checked_sub(FIRST_PAIR) {
                None => sevens.push(letter as u8),
                Some(pair) => {
                    sevens.push(BARRED[pair as usize / 128 % 3]);
                    sevens.extend((pair / 128 < 3).then_some((pair % 128) as u8));
                }
            }
        }
        let bits: Vec<u8> =
            sevens.iter().flat_map(|seven| (0..7).rev().map(move |k| seven >> k & 1)).collect();
        bits.chunks_exact(8).map(|byte| byte.iter().fold(0, |byte, bit| byte << 1 | bit)).collect()
    }

    #[test]
    fn bytes_come_back_and_html_reads_none_of_them() {
        for length in 0..36_u8 {
            for fill in [0, 13, 60, 61, 120, 255] {
                let bytes: Vec<u8> = (0..length).map(|k| if k % 3 == 0 { fill } else { k * 7 }).collect();
                let text = dense(&bytes);
                assert_eq!(read(&text), bytes);
                assert!(!text.contains(['\0', '\r', '<']), "{text:?}");
            }
        }
        let bytes: Vec<u8> = (0..70_000_u32).map(|k| (k.wrapping_mul(k) >> 3) as u8).collect();
        let text = dense(&bytes);
        assert_eq!(read(&text), bytes);
        assert_eq!(text.len(), 80_000);
    }
}
