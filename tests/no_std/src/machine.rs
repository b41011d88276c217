//! The machine under the bare program: Linux on x86-64. The only unsafe code of the project, in a program that is
//! never shipped: a process without a C library has to enter, print and leave by itself.

use core::arch::{asm, naked_asm};
use core::panic::PanicInfo;

unsafe extern "C" {
    /// Defined nowhere, so that the linker refuses a program in which a panic can be reached.
    fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    // SAFETY: a program with this call does not link.
    unsafe { a_panic_can_be_reached() }
}

/// Entry point. The kernel hands over a stack aligned to 16 bytes; the call pushes a return address, as the ABI wants it.
#[unsafe(naked)]
#[unsafe(no_mangle)]
extern "C" fn _start() -> ! {
    naked_asm!("call {enter}", "ud2", enter = sym enter)
}

extern "C" fn enter() -> ! {
    let code = crate::main();
    system_call(231, code as usize, 0, 0); // exit_group
    loop {
        core::hint::spin_loop();
    }
}

/// Writes to the standard output.
pub fn print(text: &[u8]) {
    system_call(1, 1, text.as_ptr() as usize, text.len());
}

/// A number that the compiler cannot know.
pub fn process_id() -> u64 {
    system_call(39, 0, 0, 0) as u64
}

fn system_call(number: usize, a: usize, b: usize, c: usize) -> usize {
    let mut result = number;
    // SAFETY: the calls used here (write, getpid, exit_group) read at most `c` bytes at `b`, which `print` owns.
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
