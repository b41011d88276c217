//! Machines under a program: how a bare one starts, prints and ends, and what is counted there. All unsafe code of the project
//! stands here, in programs that are never shipped; on a board of yours the crates of its vendor do this.
//!
//! A bare program names its main function by [`program!`]. It links only if no panic can be reached.
#![no_std]

#[cfg(not(feature = "std"))]
mod bare;
#[cfg(not(feature = "std"))]
pub use bare::{exit, print, print_line};

#[cfg(any(feature = "std", not(target_arch = "arm")))]
mod nothing_counts {
    /// Runs something; no instructions are counted here.
    #[inline]
    pub fn instructions<R>(action: impl FnOnce() -> R) -> (R, u32) {
        (action(), 0)
    }

    /// Runs something; its stack is not looked at here.
    pub fn stack<R>(action: impl FnOnce() -> R) -> (R, u32) {
        (action(), 0)
    }

    /// Bytes of the program, which are not known here.
    pub fn sizes() -> [u32; 2] {
        [0; 2]
    }
}
#[cfg(any(feature = "std", not(target_arch = "arm")))]
pub use nothing_counts::{instructions, sizes, stack};

#[cfg(all(not(feature = "std"), target_arch = "arm"))]
pub use bare::{instructions, sizes, stack};

/// Makes a function `fn() -> i32` the main function of the program; it returns the code that the program ends with.
#[macro_export]
macro_rules! program {
    ($main:path) => {
        /// Where the machine enters the program.
        #[unsafe(no_mangle)]
        extern "C" fn program() -> i32 {
            $main()
        }
    };
}
