//! RISC-V of 64 bits.

use core::arch::{asm, naked_asm};

pub(crate) const WRITE: usize = 64;
/// All threads.
pub(crate) const EXIT: usize = 94;

/// Entry point. The kernel hands over a stack aligned to 16 bytes.
#[unsafe(naked)]
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    naked_asm!("call {enter}", enter = sym super::enter)
}

pub(crate) fn system_call(number: usize, a: usize, b: usize, c: usize) -> usize {
    let mut result = a;
    // SAFETY: the calls used here read at most `c` bytes at `b`, which `print` owns.
    unsafe {
        asm!("ecall", in("a7") number, inlateout("a0") result, in("a1") b, in("a2") c, options(nostack));
    }
    result
}
