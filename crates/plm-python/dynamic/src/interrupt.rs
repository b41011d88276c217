//! Messages of threads, while Ctrl+C is looked at.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError};
use std::time::Duration;

use pyo3::prelude::*;

/// How often Ctrl+C is looked at.
const ASKS: Duration = Duration::from_millis(50);

/// The next message; none once nobody sends any more. Ctrl+C sets `stop`.
///
/// # Errors
/// Ctrl+C, or what else a handler of a signal raises.
pub(crate) fn next<T>(receiver: &Receiver<T>, stop: &AtomicBool) -> PyResult<Option<T>> {
    loop {
        match receiver.recv_timeout(ASKS) {
            Ok(message) => return Ok(Some(message)),
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => {
                if let Err(interrupt) = Python::attach(|py| py.check_signals()) {
                    stop.store(true, Ordering::Relaxed);
                    return Err(interrupt);
                }
            }
        }
    }
}
