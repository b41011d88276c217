//! Saved runs: bytes for files and for other processes.
//!
//! 64-bit words, little end first: `plm run` and a zero; the version of the format; a number of the declaration and of the kind of its
//! numbers; how many words follow; these, as [`InWords`] shows them; and a sum of all bytes before it (FNV-1a, which every change of a
//! single byte changes).

use plm_runtime::words::{InWords, Words};

use crate::{Error, Foreign, Status};

const NAME: u64 = u64::from_le_bytes(*b"plm run\0");
const VERSION: u64 = 3;
/// Bytes of a word.
const WORD: usize = 8;
/// Words before those of the run, and all that are not of it.
const HEAD: usize = 4;
const FRAME: usize = HEAD + 1;

/// A number of a text (FNV-1a of 64 bits: G. Fowler, L. C. Noll, K.-P. Vo).
pub(crate) const fn fnv(mut bytes: &[u8]) -> u64 {
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    while let [byte, rest @ ..] = bytes {
        hash = (hash ^ *byte as u64).wrapping_mul(0x0100_0000_01b3);
        bytes = rest;
    }
    hash
}

/// A number of a declaration, and of the numbers that it is for.
fn declaration<M: Foreign>() -> u64 {
    fnv(M::DECLARATION.as_bytes()) ^ (size_of::<M::S>() as u64).rotate_left(32)
}

/// Bytes of a saved run.
pub fn size<T: InWords>(mut run: T) -> usize {
    let mut counter = Counter(0);
    run.each(&mut counter);
    WORD * (FRAME + counter.0)
}

/// Writes a run of a mechanism; `bytes` has just the room for it.
///
/// # Errors
/// [`Status::Memory`]
pub fn write<M: Foreign, T: InWords + Clone>(run: &T, bytes: &mut [u8]) -> Result<(), Error> {
    if bytes.len() != size(run.clone()) {
        return Err(Status::Memory.into());
    }
    let (front, sum) = bytes.split_last_chunk_mut::<WORD>().ok_or(Status::Memory)?;
    let count = (front.len() / WORD).saturating_sub(HEAD);
    let mut writer = Writer(&mut *front);
    for mut word in [NAME, VERSION, declaration::<M>(), count as u64] {
        writer.word(&mut word);
    }
    run.clone().each(&mut writer);
    *sum = fnv(front).to_le_bytes();
    Ok(())
}

/// Reads a run of a mechanism into one of the same shape; only where there is no error has it been read whole.
///
/// # Errors
/// [`Status::Damaged`], [`Status::OtherVersion`], [`Status::OtherMechanism`]
pub fn read<M: Foreign>(run: &mut impl InWords, bytes: &[u8]) -> Result<(), Error> {
    let (front, sum) = bytes.split_last_chunk::<WORD>().ok_or(Status::Damaged)?;
    let mut reader = Reader { rest: front, missing: 0 };
    let [name, version, own, count] = core::array::from_fn(|_| reader.next());
    if name != NAME || fnv(front) != u64::from_le_bytes(*sum) {
        return Err(Status::Damaged.into());
    }
    if version != VERSION {
        return Err(Status::OtherVersion.into());
    }
    if own != declaration::<M>() {
        return Err(Status::OtherMechanism.into());
    }
    if reader.rest.len() as u64 != count.wrapping_mul(WORD as u64) {
        return Err(Status::Damaged.into());
    }
    run.each(&mut reader);
    if reader.missing > 0 || !reader.rest.is_empty() { Err(Status::Damaged.into()) } else { Ok(()) }
}

struct Counter(usize);

impl Words for Counter {
    fn word(&mut self, _word: &mut u64) {
        self.0 += 1;
    }
}

/// The room that is left.
struct Writer<'a>(&'a mut [u8]);

impl Words for Writer<'_> {
    fn word(&mut self, word: &mut u64) {
        let room = core::mem::take(&mut self.0);
        if let Some((place, rest)) = room.split_first_chunk_mut() {
            *place = word.to_le_bytes();
            self.0 = rest;
        }
    }
}

struct Reader<'a> {
    rest: &'a [u8],
    /// Words that were read beyond the end.
    missing: usize,
}

impl Reader<'_> {
    fn next(&mut self) -> u64 {
        let mut word = 0;
        self.word(&mut word);
        word
    }
}

impl Words for Reader<'_> {
    fn word(&mut self, word: &mut u64) {
        match self.rest.split_first_chunk() {
            Some((bytes, rest)) => (*word, self.rest) = (u64::from_le_bytes(*bytes), rest),
            None => self.missing += 1,
        }
    }
}
