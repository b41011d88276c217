//! Words of the language that stand inside of items. Those that are Rust's too, `if` and `in`, are `Token![…]`.

macro_rules! words {
    ($($word:ident)*) => {
        $(syn::custom_keyword!($word);)*

        /// All of them.
        pub(crate) const ALL: &[&str] = &[$(stringify!($word)),*];
    };
}

words! { across and angle at axis depth domain from joint locked not on optional or part parts port start step then through within }

// `**`, which other languages have.
syn::custom_punctuation!(Power, **);
