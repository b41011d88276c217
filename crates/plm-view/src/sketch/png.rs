//! A file of PNG (ISO/IEC 15948): eight bits of red, green and blue, deflated.

use std::io::Write as _;

use flate2::write::ZlibEncoder;
use flate2::{Compression, Crc};

const SIGNATURE: [u8; 8] = [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n'];
/// Eight bits of each colour, no palette, the only compression, the only set of filters, rows in their order.
const KIND: [u8; 5] = [8, 2, 0, 0, 0];

/// The file of these pixels, row by row.
pub(super) fn file(columns: usize, pixels: &[[u8; 3]]) -> Vec<u8> {
    let columns = columns.max(1);
    let mut file = SIGNATURE.to_vec();
    let sizes = [columns, pixels.len() / columns].map(|count| u32::try_from(count).unwrap_or(u32::MAX));
    chunk(&mut file, *b"IHDR", &[&sizes[0].to_be_bytes()[..], &sizes[1].to_be_bytes(), &KIND].concat());
    let mut deflated = ZlibEncoder::new(Vec::new(), Compression::default());
    for row in pixels.chunks_exact(columns) {
        // The filter of each row is none: there are few colours. Writing into memory does not fail.
        let _ = deflated.write_all(&[0]).and_then(|()| deflated.write_all(row.as_flattened()));
    }
    chunk(&mut file, *b"IDAT", &deflated.finish().unwrap_or_default());
    chunk(&mut file, *b"IEND", &[]);
    file
}

/// Adds a chunk: its length, its name, its bytes, and the checksum of name and bytes.
fn chunk(file: &mut Vec<u8>, name: [u8; 4], bytes: &[u8]) {
    let mut sum = Crc::new();
    sum.update(&name);
    sum.update(bytes);
    file.extend(u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_be_bytes());
    file.extend(name);
    file.extend(bytes);
    file.extend(sum.sum().to_be_bytes());
}
