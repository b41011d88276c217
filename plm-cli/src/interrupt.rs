//! Ctrl+C: a run ends where it is and writes what it has; everything else ends at once.

use std::sync::atomic::{AtomicBool, Ordering};

/// Somebody waits for an interrupt, and ends by itself.
static WAITS: AtomicBool = AtomicBool::new(false);
/// It has come.
static CAME: AtomicBool = AtomicBool::new(false);

/// Tells of Ctrl+C. True where whatever runs ends by itself; a program ends at once otherwise, as at the second time.
pub fn interrupt() -> bool {
    WAITS.load(Ordering::Relaxed) && !CAME.swap(true, Ordering::Relaxed)
}

/// From now on what runs asks [`came`], and ends by itself.
pub(crate) fn wait() {
    WAITS.store(true, Ordering::Relaxed);
}

/// Has the user pressed Ctrl+C?
pub(crate) fn came() -> bool {
    CAME.load(Ordering::Relaxed)
}
