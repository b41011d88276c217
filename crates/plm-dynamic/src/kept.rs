//! Lists and texts that live as long as the program.

/// A list that lives as long as the program.
pub(crate) fn kept<T>(items: impl IntoIterator<Item = T>) -> &'static [T] {
    Vec::leak(items.into_iter().collect())
}

/// A text that lives as long as the program.
pub(crate) fn text(text: &str) -> &'static str {
    String::leak(text.to_owned())
}

/// Names of a lowered mechanism, which lives as long.
pub(crate) fn texts(all: impl IntoIterator<Item = &'static String>) -> &'static [&'static str] {
    kept(all.into_iter().map(String::as_str))
}
