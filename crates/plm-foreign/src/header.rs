//! The header for C and C++, from the tables of a mechanism.

use core::fmt::{self, Write};

use plm_runtime::contact::Mode;
use plm_runtime::described::Quantity;

use crate::source::{Entry, Si, replace};
use crate::{By, Called, Foreign, Kind, Matrix, Names, Number, Status};

/// The functions, for a mechanism with this prefix.
const FUNCTIONS: &str = include_str!("header.h.txt");
/// One of a step by itself.
const STEP: &str = include_str!("header_step.h.txt");

/// Comment above the names of rows of contact.
const ROWS: &str = "\
/* Rows of contact. What one does is its number of the kind PLM_CONTACT: a gap is PLM_OPEN or PLM_CLOSED; a friction is PLM_OFF as long as
   nothing pushes, PLM_STICKS, or slips PLM_FORWARDS or PLM_BACKWARDS. */
";

/// Writes the header of a mechanism; `declared` is one as it was declared.
///
/// # Errors
/// Those of the writer.
pub fn header<M: Foreign>(declared: &M, entry: Entry<'_>, to: &mut impl Write) -> fmt::Result {
    let (tables, upper) = (M::TABLES, Names::upper(entry.name));
    writeln!(to, "/* {}", tables.name)?;
    for line in tables.docs.lines() {
        writeln!(to, "   {}", Comment(line))?;
    }
    writeln!(
        to,
        "\n   One object is used by one thread at a time; several objects have nothing in common. */"
    )?;
    writeln!(to, "#ifndef PLM_{upper}_H\n#define PLM_{upper}_H\n\n#include <stddef.h>\n")?;
    writeln!(to, "#ifdef __cplusplus\nextern \"C\" {{\n#endif\n")?;
    common(to)?;
    writeln!(
        to,
        "/* Of the library beside this file, for memory that is known when C is compiled; `init` looks at it. */"
    )?;
    let (size, align) = entry.room::<M>();
    writeln!(to, "#define {upper}_SIZE {size}u\n#define {upper}_ALIGN {align}u\n")?;
    let (name, steps, methods) = (entry.name, Steps(entry.name, M::S::C, M::STEPS), Methods(entry));
    let words = [("PREFIX", &name as &dyn fmt::Display), ("REAL", &M::S::C), ("STEPS", &steps)];
    let [prefix, real, steps] = words;
    replace(FUNCTIONS, &[prefix, real, steps, ("METHODS", &methods)], to)?;
    let quantity = |rows: &'static [Quantity], k: usize| rows.get(k).map_or(Unit::None, Unit::Of);
    let mut list = |kind, unit: &dyn Fn(usize) -> Unit| list(declared, (kind, entry.name), unit, &mut *to);
    list(Kind::Parameter, &|k| quantity(tables.parameters, k))?;
    list(Kind::Input, &|k| quantity(tables.inputs, k))?;
    list(Kind::State, &|k| quantity(tables.states, k))?;
    list(Kind::Output, &|k| M::OBSERVED.get(k).map_or(Unit::None, |(_, unit)| Unit::Named(unit)))?;
    list(Kind::Start, &of_start::<M>)?;
    list(Kind::Body, &|_| Unit::None)?;
    list(Kind::Contact, &|_| Unit::None)?;
    writeln!(to, "\n#ifdef __cplusplus\n}}\n#endif\n\n#endif")
}

/// The steps by themselves that a declaration orders.
struct Steps<'a>(&'a str, &'static str, &'static [&'static str]);

impl fmt::Display for Steps<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(prefix, real, steps) = self;
        if steps.is_empty() {
            return Ok(());
        }
        f.write_str(
            "/* Steps of `h`, s, that the declaration orders, by themselves: no memory is taken, and the operations are the same in
   each. Conditions switch at the end of a step. After an error the run is as it was. */\n",
        )?;
        steps
            .iter()
            .try_for_each(|step| replace(STEP, &[("PREFIX", prefix), ("REAL", real), ("STEP", step)], f))?;
        f.write_str("\n")
    }
}

/// The methods of a library, one a line.
struct Methods<'a>(Entry<'a>);

impl fmt::Display for Methods<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.methods.iter().try_for_each(|by| {
            let Called { c, words, .. } = by.called();
            writeln!(f, "     PLM_{c}: {words}")
        })
    }
}

/// Common part of the headers of all mechanisms: statuses, kinds, methods, modes. Later additions have guards of their own, so that headers of two versions
/// fit into one file.
///
/// # Errors
/// Those of the writer.
pub fn common(to: &mut impl Write) -> fmt::Result {
    writeln!(
        to,
        "#ifndef PLM_STATUS\n#define PLM_STATUS\n/* What functions return; 0 is good. */\nenum plm_status {{"
    )?;
    for status in Status::ALL {
        let (name, words) = status.words();
        let words = words.to_str().unwrap_or_default();
        writeln!(
            to,
            "    PLM_{name} = {}{} /* {words} */",
            status as i32,
            comma(Some(&status) != Status::ALL.last())
        )?;
    }
    let (kinds, later) = Kind::ALL.split_at(6);
    let (later, of_contact) = later.split_at(2);
    writeln!(to, "}};\n\n/* What an index belongs to. */")?;
    constants("plm_kind", kinds.iter().map(|kind| (kind.word(), *kind as i32)), to)?;
    writeln!(to, "#endif\n\n#ifndef PLM_METHOD\n#define PLM_METHOD\n/* Further kinds. */")?;
    constants("plm_integrated", later.iter().map(|kind| (kind.word(), *kind as i32)), to)?;
    writeln!(to, "\n/* Methods of integration; the functions below say which a library has. */")?;
    constants("plm_method", By::ALL.into_iter().map(|by| (by.called().c, by as i32)), to)?;
    writeln!(to, "\n/* Matrices of a linearisation. */")?;
    let matrices = Matrix::ALL.into_iter().zip(["A", "B", "C", "D", "BASIS"]);
    constants("plm_matrix", matrices.map(|(matrix, word)| (word, matrix as i32)), to)?;
    writeln!(
        to,
        "#endif\n\n#ifndef PLM_MODE\n#define PLM_MODE\n/* A further kind, and what a row of contact does. */"
    )?;
    constants("plm_contact", of_contact.iter().map(|kind| (kind.word(), *kind as i32)), to)?;
    let modes = Mode::ALL.into_iter().zip(["OPEN", "CLOSED", "OFF", "STICKS", "FORWARDS", "BACKWARDS"]);
    constants("plm_mode", modes.map(|(mode, word)| (word, mode.number() as i32)), to)?;
    writeln!(to, "#endif\n")
}

/// An enumeration.
fn constants(
    name: &str,
    words: impl ExactSizeIterator<Item = (&'static str, i32)>,
    to: &mut impl Write,
) -> fmt::Result {
    let last = words.len().saturating_sub(1);
    writeln!(to, "enum {name} {{")?;
    for (k, (word, number)) in words.enumerate() {
        writeln!(to, "    PLM_{word} = {number}{}", comma(k < last))?;
    }
    writeln!(to, "}};")
}

/// Unit after a name.
enum Unit {
    None,
    Named(&'static str),
    /// Its unit, and its documentation.
    Of(&'static Quantity),
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None | Self::Named("") => Ok(()),
            Self::Named(unit) => write!(f, ", {unit}"),
            Self::Of(row) => {
                if row.exponents != [0; 7] {
                    write!(f, ", {}", Si(row))?;
                }
                let between = |k| if k == 0 { ";" } else { "" };
                let mut lines = row.docs.lines().enumerate();
                lines.try_for_each(|(k, line)| write!(f, "{} {}", between(k), Comment(line.trim())))
            }
        }
    }
}

/// The unit of a start value.
fn of_start<M: Foreign>(index: usize) -> Unit {
    let bodies = M::TABLES.bodies.len();
    let units = ["m", "m", "rad", "m/s", "m/s", "rad/s"];
    let state = index.checked_sub(6 * bodies).and_then(|state| M::TABLES.states.get(state));
    state.map_or(Unit::Named(units.get(index % 6).copied().unwrap_or_default()), Unit::Of)
}

/// The numbers of a kind by name.
fn list<M: Foreign>(
    declared: &M,
    (kind, prefix): (Kind, &str),
    unit: &dyn Fn(usize) -> Unit,
    to: &mut impl Write,
) -> fmt::Result {
    let (count, mut index, mut outcome) = (kind.count(declared), 0, Ok(()));
    if count == 0 {
        return Ok(());
    }
    let (lower, upper, word) = (Names::lower(prefix), Names::upper(prefix), kind.word());
    let above = if kind == Kind::Contact { ROWS } else { "" };
    writeln!(to, "\n{above}enum {lower}_{} {{", Names::lower(word))?;
    kind.names(declared, &mut |name| {
        let (own, mut same) = (Names::upper(name), 0);
        kind.names(declared, &mut |other| same += usize::from(own.is_as(other)));
        let (comma, unit) = (comma(index + 1 < count), unit(index));
        outcome = outcome.and_then(|()| match same {
            1 => writeln!(to, "    {upper}_{word}_{own} = {index}{comma} /* {}{unit} */", Comment(name)),
            // Names that differ in other than letters and digits get their number.
            _ => writeln!(
                to,
                "    {upper}_{word}_{own}_{index} = {index}{comma} /* {}{unit} */",
                Comment(name)
            ),
        });
        index += 1;
    });
    outcome?;
    writeln!(to, "}};")
}

/// Separator between the elements of a list.
fn comma(goes_on: bool) -> &'static str {
    if goes_on { "," } else { "" }
}

/// Text that does not end the comment that it stands in.
struct Comment<'a>(&'a str);

impl fmt::Display for Comment<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, piece) in self.0.split("*/").enumerate() {
            if k > 0 {
                f.write_str("* /")?;
            }
            f.write_str(piece)?;
        }
        Ok(())
    }
}
