//! Runs with derivatives on a stack that holds them.

use std::panic::resume_unwind;
use std::thread;

/// A number has five times the size that it has without derivatives, and methods for stiff systems hold matrices of them: more than the
/// 2 MiB of a thread, or the 1 MiB of a program on Windows. The system gives what is used of it, not more.
const STACK: usize = 16 << 20;

/// Does it on a thread with such a stack; on this one where the system has no thread to give.
pub(crate) fn on_large_stack<T: Send>(work: impl Fn() -> T + Sync) -> T {
    thread::scope(|scope| match thread::Builder::new().stack_size(STACK).spawn_scoped(scope, &work) {
        Ok(thread) => thread.join().unwrap_or_else(|panic| resume_unwind(panic)),
        Err(_) => work(),
    })
}
