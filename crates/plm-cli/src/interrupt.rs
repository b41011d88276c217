//! Ctrl+C: a run ends where it is and writes what it has; everything else ends at once.

use std::sync::atomic::{AtomicBool, Ordering};

/// A command waits for an interrupt, and ends by itself.
static WAITS: AtomicBool = AtomicBool::new(false);
/// An interrupt has come.
static CAME: AtomicBool = AtomicBool::new(false);

/// Reports Ctrl+C. True if the running command ends by itself; else the program must end at once, also at the second interrupt.
pub fn interrupt() -> bool {
    WAITS.load(Ordering::Relaxed) && !CAME.swap(true, Ordering::Relaxed)
}

/// From now on the running command polls [`came`], and ends by itself.
pub(crate) fn wait() {
    WAITS.store(true, Ordering::Relaxed);
}

/// Has the user pressed Ctrl+C?
pub(crate) fn came() -> bool {
    CAME.load(Ordering::Relaxed)
}
