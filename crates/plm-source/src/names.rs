//! Names of a source: those that a language has taken, and variables that would hide the type of a mechanism.

use plm_foreign::Names;

/// Words of C and C++ that are no names, and types that the header includes.
const TAKEN: &str = "alignas alignof and asm auto bitand bitor bool break case catch char class compl const constexpr continue decltype \
    default delete do double else enum explicit export extern false float for friend goto if inline int long mutable namespace new \
    noexcept not nullptr operator or private protected public register restrict return short signed sizeof static struct switch \
    template this throw true try typedef typeid typename union unsigned using virtual void volatile while xor \
    and_eq const_cast dynamic_cast not_eq or_eq reinterpret_cast size_t static_assert static_cast thread_local wchar_t xor_eq";

/// The name of a mechanism in C; one that is a word of the language ends with `_mechanism`.
pub(crate) fn of_mechanism(name: &str) -> String {
    let lower = Names::lower(name).to_string();
    if TAKEN.split_whitespace().any(|word| word == lower) { format!("{lower}_mechanism") } else { lower }
}

/// A text of C in which variables of the name of a type have another one: `stage_own`. The type stands before ` *` and before an alias that
/// begins with its name; fields, texts and comments keep their names.
pub(crate) fn without_hiding(text: &str, type_name: &str) -> String {
    let is_letter = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let alias = format!(" {type_name}_object;");
    let (mut all, mut rest) = (String::with_capacity(text.len()), text);
    while let Some(next) = rest.chars().next() {
        let length = if next == '"' {
            end_of_text(rest)
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if is_letter(next) {
            rest.find(|letter| !is_letter(letter)).unwrap_or(rest.len())
        } else {
            next.len_utf8()
        };
        let (word, after) = rest.split_at(length);
        let is_field = all.ends_with("->") || all.ends_with('.');
        let is_type = after.starts_with(" *self") || after.starts_with(&alias);
        all.push_str(word);
        if word == type_name && !is_field && !is_type {
            all.push_str("_own");
        }
        rest = after;
    }
    all
}

/// The length of a text in quotes at the beginning.
fn end_of_text(text: &str) -> usize {
    let mut escaped = false;
    for (place, letter) in text.char_indices().skip(1) {
        match letter {
            '"' if !escaped => return place + 1,
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::{of_mechanism, without_hiding};

    #[test]
    fn words_of_c_are_no_names() {
        assert_eq!(of_mechanism("Double"), "double_mechanism");
        assert_eq!(of_mechanism("FourBar"), "four_bar");
    }

    #[test]
    fn variables_do_not_hide_a_type() {
        let text = "static int x_f(const x *self, plm_real x[2]) { /* x */ return self->x[0] < x[0] ? \"x \\\" x\" : x_g(x); }\ntypedef x x_object;";
        let plain = "static int x_f(const x *self, plm_real x_own[2]) { /* x */ return self->x[0] < x_own[0] ? \"x \\\" x\" : x_g(x_own); }\ntypedef x x_object;";
        assert_eq!(without_hiding(text, "x"), plain);
    }
}
