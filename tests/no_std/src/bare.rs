//! The scene without std, allocation or panic: it links only if all three hold.
//!
//! * `no_std`, and no `extern crate alloc` with a global allocator: what allocates does not compile.
//! * The panic handler calls a function that nobody defines: a panic that can be reached does not link.
#![no_std]
#![no_main]

mod machine;
mod scene;

/// Runs the scene and prints its bits, one number a line in hexadecimal.
pub fn main() -> i32 {
    let outcome = scene::run(|bits| machine::print(&line(bits)));
    if cfg!(feature = "panic") {
        // The argument is nothing that the compiler knows.
        let divisor = machine::process_id();
        machine::print(&line(1 / divisor));
    }
    i32::from(outcome.is_err())
}

/// 16 hexadecimal digits and the end of the line. (`core::fmt` could panic.)
fn line(bits: u64) -> [u8; 17] {
    let mut text = [b'\n'; 17];
    for (place, character) in text.iter_mut().take(16).enumerate() {
        let digit = (bits >> (60 - 4 * place)) as u8 & 15;
        *character = if digit < 10 { b'0' + digit } else { b'a' + digit - 10 };
    }
    text
}
