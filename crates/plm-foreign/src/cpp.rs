//! The header for C++: a class over the functions of C.

use core::fmt::{self, Write};

use crate::source::{Entry, Word, replace};
use crate::{Foreign, Kind, Names, Number};

/// The class, for a mechanism with this prefix.
const CLASS: &str = include_str!("cpp.hpp.txt");

/// Writes the header of a mechanism for C++, which stands beside that for C; `declared` is one as it was declared.
///
/// # Errors
/// Those of the writer.
pub fn cpp_header<M: Foreign>(declared: &M, entry: Entry<'_>, to: &mut impl Write) -> fmt::Result {
    let upper = Names::upper(entry.name);
    writeln!(
        to,
        "/* {}, for C++ from 2011 on. */\n#ifndef PLM_{upper}_HPP\n#define PLM_{upper}_HPP\n",
        M::TABLES.name
    )?;
    let (name, class, steps) = (entry.name, Class(entry.name), Steps(entry.name, M::STEPS));
    let kinds = Kinds { name, counts: Kind::ALL.map(|kind| kind.count(declared)) };
    let words: [Word<'_>; 6] = [
        ("PREFIX", &name),
        ("UPPER", &upper),
        ("TYPE", &class),
        ("REAL", &M::S::C),
        ("STEPS\n", &steps),
        ("KINDS\n", &kinds),
    ];
    replace(CLASS, &words, to)
}

/// `AcmePress` of `acme_press`.
struct Class<'a>(&'a str);

impl fmt::Display for Class<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.split('_').try_for_each(|word| {
            let mut letters = word.chars();
            letters.next().into_iter().try_for_each(|first| write!(f, "{}", first.to_ascii_uppercase()))?;
            f.write_str(letters.as_str())
        })
    }
}

/// The steps by themselves.
struct Steps<'a>(&'a str, &'static [&'static str]);

impl fmt::Display for Steps<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(name, steps) = self;
        if !steps.is_empty() {
            f.write_str("\n    /* A step of `h`, s, by itself. */\n")?;
        }
        steps.iter().try_for_each(|step| {
            writeln!(f, "    void step_{step}(Number h) {{ check({name}_step_{step}(c(), h)); }}")
        })?;
        f.write_str("\n")
    }
}

/// Quantities that are read and set by enumerations.
struct Kinds<'a> {
    name: &'a str,
    counts: [usize; Kind::ALL.len()],
}

impl fmt::Display for Kinds<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, counts } = self;
        for (kind, _) in Kind::ALL.into_iter().zip(counts).filter(|(_, count)| **count > 0) {
            let (word, can_be_set) = (
                kind.word(),
                match kind {
                    Kind::Parameter | Kind::Input | Kind::Start => true,
                    Kind::State | Kind::Output | Kind::Contact => false,
                    // Without a number, or without names that stay.
                    Kind::Body | Kind::Integrated | Kind::Rate => continue,
                },
            );
            let own = Names::lower(word);
            writeln!(
                f,
                "    Number get(enum {name}_{own} which) const {{ return get(PLM_{word}, which); }}"
            )?;
            if can_be_set {
                writeln!(
                    f,
                    "    void set(enum {name}_{own} which, Number value) {{ set(PLM_{word}, which, value); }}"
                )?;
            }
        }
        f.write_str("\n")
    }
}
