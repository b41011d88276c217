//! Programs without an operating system, or without a C library on one.

#[cfg(target_arch = "arm")]
mod cortex_m;
#[cfg(target_arch = "arm")]
pub use cortex_m::{exit, instructions, print, sizes, stack};

#[cfg(any(target_arch = "x86_64", target_arch = "riscv64"))]
mod linux;
#[cfg(any(target_arch = "x86_64", target_arch = "riscv64"))]
pub use linux::{exit, print};
#[cfg(target_arch = "riscv64")]
mod riscv64;
#[cfg(target_arch = "x86_64")]
mod x86_64;

#[cfg(target_arch = "wasm32")]
mod wasm32;
#[cfg(target_arch = "wasm32")]
pub use wasm32::{exit, print};

unsafe extern "C" {
    /// Defined nowhere, so that the linker refuses a program in which a panic can be reached.
    fn a_panic_can_be_reached() -> !;
    #[cfg(not(target_arch = "wasm32"))]
    fn program() -> i32;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    // SAFETY: a program with this call does not link.
    unsafe { a_panic_can_be_reached() }
}

#[cfg(not(target_arch = "wasm32"))]
extern "C" fn enter() -> ! {
    // SAFETY: `program!` defines it so.
    exit(unsafe { program() })
}

/// Prints 16 hexadecimal digits and the end of the line. (`core::fmt` could panic.)
pub fn print_line(bits: u64) {
    let mut text = [b'\n'; 17];
    for (place, character) in text.iter_mut().take(16).enumerate() {
        let digit = (bits >> (60 - 4 * place)) as u8 & 15;
        *character = if digit < 10 { b'0' + digit } else { b'a' + digit - 10 };
    }
    print(&text);
}
