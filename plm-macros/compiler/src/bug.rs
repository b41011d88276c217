//! Panics of the compiler: bugs of its own, never the user's mistake; they must not look like one of rustc.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Result of `run`, or the text that it panicked with.
///
/// # Errors
/// It panicked.
pub fn without_panic<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(run)).map_err(|panic| {
        let text = panic.downcast_ref::<String>().map(String::as_str);
        text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("no message").to_owned()
    })
}

/// The message that a user sees of it.
pub fn bug_message(what: &str) -> String {
    format!(
        "this is a bug in plm, not in your declaration: {what}\n= help: please report it with the declaration"
    )
}

#[cfg(test)]
#[allow(clippy::panic, clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{bug_message, without_panic};

    #[test]
    fn a_panic_becomes_its_text() {
        assert_eq!(without_panic(|| 3), Ok(3));
        assert_eq!(without_panic(|| panic!("row {}", 7)), Err::<(), _>("row 7".to_owned()));
        assert_eq!(without_panic(|| panic!("plain")), Err::<(), _>("plain".to_owned()));
        assert_eq!(without_panic(|| std::panic::panic_any(5_u8)), Err::<(), _>("no message".to_owned()));
    }

    #[test]
    fn a_bug_is_said_to_be_ours() {
        let shown = bug_message(&without_panic(|| Vec::<u8>::new()[0]).unwrap_err());
        assert!(
            shown.starts_with("this is a bug in plm, not in your declaration: index out of bounds"),
            "{shown}"
        );
    }
}
