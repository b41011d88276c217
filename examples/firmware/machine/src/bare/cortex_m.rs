//! Cortex-M with a floating-point unit, under QEMU with semihosting and `-icount shift=10`.

use core::arch::{asm, naked_asm};
use core::ptr;

/// SysTick: control, reload and count.
const SYSTICK: [*mut u32; 3] = [0xE000_E010 as *mut u32, 0xE000_E014 as *mut u32, 0xE000_E018 as *mut u32];
/// It counts 24 bits down.
const SYSTICK_RANGE: u32 = 1 << 24;
/// At 25 MHz a tick is 40 ns, and an instruction takes 2^10 ns by QEMU's clock.
const TICK_NS: u32 = 40;
const INSTRUCTION_NS: u32 = 1 << 10;

/// Entry point: lets the floating-point unit be used (coprocessors 10 and 11 in CPACR) and begins.
#[unsafe(naked)]
#[unsafe(no_mangle)]
extern "C" fn reset() -> ! {
    naked_asm!(
        "movw r0, #0xED88", "movt r0, #0xE000", "ldr r1, [r0]", "orr r1, r1, #0xF00000", "str r1, [r0]",
        "dsb", "isb", "bl {enter}",
        enter = sym enter)
}

/// What the processor goes to at a fault.
#[unsafe(no_mangle)]
extern "C" fn fault() -> ! {
    exit(70)
}

extern "C" fn enter() -> ! {
    // SAFETY: registers of the processor, which nothing else uses; 5 is on, without an interrupt, by the processor's clock.
    unsafe {
        SYSTICK[1].write_volatile(SYSTICK_RANGE - 1);
        SYSTICK[2].write_volatile(0);
        SYSTICK[0].write_volatile(5);
    }
    super::enter()
}

/// A request to the debugger, here QEMU.
fn semihosting(operation: u32, argument: *const u32) {
    // SAFETY: the operations used here read one byte or two words at the argument.
    unsafe {
        asm!("bkpt 0xAB", inlateout("r0") operation => _, in("r1") argument, options(nostack));
    }
}

/// Writes to the debugger's output.
pub fn print(text: &[u8]) {
    for character in text {
        semihosting(0x03, ptr::from_ref(character).cast());
    }
}

/// Ends the program.
pub fn exit(code: i32) -> ! {
    // ADP_Stopped_ApplicationExit.
    semihosting(0x20, [0x2_0026, code as u32].as_ptr());
    loop {
        core::hint::spin_loop();
    }
}

fn ticks() -> u32 {
    // SAFETY: see `enter`.
    unsafe { SYSTICK[2].read_volatile() }
}

/// Runs something and counts its instructions, at most 650 000.
#[inline]
pub fn instructions<R>(action: impl FnOnce() -> R) -> (R, u32) {
    let before = ticks();
    let result = action();
    let ticks = before.wrapping_sub(ticks()) % SYSTICK_RANGE;
    // Both readings are whole ticks: their difference is off by less than one, a small part of an instruction.
    (result, (ticks * TICK_NS + INSTRUCTION_NS / 2) / INSTRUCTION_NS)
}

/// A pattern that no number of a mechanism is likely to have.
const PAINT: u32 = 0xC5A3_96E7;
/// Words below the stack pointer that are looked at.
const DEPTH: usize = 64 << 10;

/// Runs something and tells how much of the stack it takes, in bytes, at most 256 KiB.
#[inline(never)]
pub fn stack<R>(action: impl FnOnce() -> R) -> (R, u32) {
    let top: usize;
    // SAFETY: reads the stack pointer.
    unsafe { asm!("mov {}, sp", out(reg) top, options(nomem, nostack, preserves_flags)) };
    // Room for what these loops themselves may push.
    let floor = (top - 4 * DEPTH) as *mut u32;
    let words = DEPTH - 64;
    // SAFETY: nothing stands below the stack pointer; the linker script leaves megabytes there, and no interrupt comes.
    unsafe { (0..words).for_each(|k| floor.add(k).write_volatile(PAINT)) };
    let result = action();
    // SAFETY: as above.
    let clean = unsafe { (0..words).take_while(|&k| floor.add(k).read_volatile() == PAINT).count() };
    (result, 4 * (DEPTH - clean) as u32)
}

unsafe extern "C" {
    /// Ends of what the linker has put into the flash, from address 0, and into the memory.
    static code_end: u8;
    static data_end: u8;
}

/// Bytes of the program: code with constants, and variables.
pub fn sizes() -> [u32; 2] {
    // Addresses alone; nothing is read.
    [(&raw const code_end) as u32, (&raw const data_end) as u32 - 0x2000_0000]
}
