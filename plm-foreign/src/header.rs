//! The header for C and C++, from the tables of a mechanism.

use core::fmt::{self, Write};

use plm_runtime::described::Quantity;

use crate::border::Block;
use crate::source::{Si, fill};
use crate::{Foreign, Kind, Names, Status};

/// The functions, for a mechanism with this prefix.
const FUNCTIONS: &str = include_str!("header.h.txt");

/// Writes the header of a mechanism; `declared` is one as it was declared.
///
/// # Errors
/// Those of the writer.
pub fn header<M: Foreign>(declared: &M, to: &mut impl Write) -> fmt::Result {
    let (tables, upper) = (M::TABLES, Names::upper(M::TABLES.name));
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
    writeln!(
        to,
        "#define {upper}_SIZE {}u\n#define {upper}_ALIGN {}u\n",
        Block::<M>::SIZE,
        Block::<M>::ALIGN
    )?;
    fill(FUNCTIONS, tables.name, to)?;
    let quantity = |rows: &'static [Quantity], k: usize| rows.get(k).map_or(Unit::None, Unit::Of);
    list(declared, (Kind::Parameter, "PARAMETER"), |k| quantity(tables.parameters, k), to)?;
    list(declared, (Kind::Input, "INPUT"), |k| quantity(tables.inputs, k), to)?;
    list(declared, (Kind::State, "STATE"), |k| quantity(tables.states, k), to)?;
    let of_output = |k: usize| M::OBSERVED.get(k).map_or(Unit::None, |(_, unit)| Unit::Named(unit));
    list(declared, (Kind::Output, "OUTPUT"), of_output, to)?;
    list(declared, (Kind::Start, "START"), of_start::<M>, to)?;
    list(declared, (Kind::Body, "BODY"), |_| Unit::None, to)?;
    writeln!(to, "\n#ifdef __cplusplus\n}}\n#endif\n\n#endif")
}

/// What the headers of all mechanisms have in common.
fn common(to: &mut impl Write) -> fmt::Result {
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
    writeln!(to, "}};\n\n/* What an index belongs to. */\nenum plm_kind {{")?;
    for (kind, name) in Kind::ALL.into_iter().zip(["PARAMETER", "INPUT", "STATE", "OUTPUT", "START", "BODY"])
    {
        writeln!(to, "    PLM_{name} = {}{}", kind as i32, comma(kind != Kind::Body))?;
    }
    writeln!(to, "}};\n#endif\n")
}

/// What stands behind a name.
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
    (kind, word): (Kind, &str),
    unit: impl Fn(usize) -> Unit,
    to: &mut impl Write,
) -> fmt::Result {
    let (count, mut index, mut outcome) = (kind.count(declared), 0, Ok(()));
    if count == 0 {
        return Ok(());
    }
    let (lower, upper) = (Names::lower(M::TABLES.name), Names::upper(M::TABLES.name));
    writeln!(to, "\nenum {lower}_{} {{", Names::lower(word))?;
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

/// Between the words of a list.
fn comma(goes_on: bool) -> &'static str {
    if goes_on { "," } else { "" }
}

/// Words that do not end the comment that they stand in.
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
