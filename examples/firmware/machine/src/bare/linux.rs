//! A process of Linux without a C library; how the kernel is called and the process is entered differs by processor.

#[cfg(target_arch = "riscv64")]
use super::riscv64::{EXIT, WRITE, system_call};
#[cfg(target_arch = "x86_64")]
use super::x86_64::{EXIT, WRITE, system_call};

/// Writes to the standard output.
pub fn print(text: &[u8]) {
    system_call(WRITE, 1, text.as_ptr() as usize, text.len());
}

/// Ends the process.
pub fn exit(code: i32) -> ! {
    system_call(EXIT, code as usize, 0, 0);
    loop {
        core::hint::spin_loop();
    }
}
