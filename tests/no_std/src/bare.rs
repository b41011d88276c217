//! The scene without std, allocation or panic: it links only if all three hold.
//!
//! * `no_std`, and no `extern crate alloc` with a global allocator: what allocates does not compile.
//! * The panic handler of `machine` calls a function that nobody defines: a panic that can be reached does not link.
#![no_std]
#![no_main]

mod scene;

machine::program!(main);

/// Runs the scene and prints its bits, one number a line in hexadecimal.
fn main() -> i32 {
    if cfg!(feature = "panic") {
        // The divisor is nothing that the compiler knows. Without the scene, whose optimisation takes longer than all else.
        machine::print_line(1 / core::hint::black_box(0));
        return 0;
    }
    i32::from(scene::run(machine::print_line).is_err())
}
