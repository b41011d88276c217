//! x86-64.

use core::arch::{asm, naked_asm};

pub(crate) const WRITE: usize = 1;
/// All threads.
pub(crate) const EXIT: usize = 231;

/// Entry point. The kernel hands over a stack aligned to 16 bytes; the call pushes a return address, as the ABI wants it.
#[unsafe(naked)]
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    naked_asm!("call {enter}", "ud2", enter = sym super::enter)
}

pub(crate) fn system_call(number: usize, a: usize, b: usize, c: usize) -> usize {
    let mut result = number;
    // SAFETY: the calls used here read at most `c` bytes at `b`, which `print` owns.
    unsafe {
        asm!("syscall", inlateout("rax") result, in("rdi") a, in("rsi") b, in("rdx") c,
             lateout("rcx") _, lateout("r11") _, options(nostack));
    }
    result
}

/// The compiler calls these for large copies; on a target without an operating system `core` brings them along.
#[unsafe(no_mangle)]
unsafe extern "C" fn memcpy(to: *mut u8, from: *const u8, count: usize) -> *mut u8 {
    // SAFETY: the caller gives `count` bytes at both places that do not overlap; the direction flag is clear (ABI).
    unsafe {
        asm!("rep movsb", inout("rcx") count => _, inout("rdi") to => _, inout("rsi") from => _,
             options(nostack, preserves_flags));
    }
    to
}

/// See [`memcpy`].
#[unsafe(no_mangle)]
unsafe extern "C" fn memset(to: *mut u8, byte: i32, count: usize) -> *mut u8 {
    // SAFETY: the caller gives `count` bytes; the direction flag is clear (ABI).
    unsafe {
        asm!("rep stosb", inout("rcx") count => _, inout("rdi") to => _, in("al") byte as u8,
             options(nostack, preserves_flags));
    }
    to
}

/// See [`memcpy`]: 0 for equal bytes. Names are compared by it.
#[unsafe(no_mangle)]
unsafe extern "C" fn bcmp(a: *const u8, b: *const u8, count: usize) -> i32 {
    // SAFETY: the caller gives `count` bytes at both places.
    let differs = |index: usize| unsafe { a.add(index).read() != b.add(index).read() };
    i32::from((0..count).any(differs))
}
