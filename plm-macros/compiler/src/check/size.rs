//! Is the mechanism small enough to be written out?

use crate::derive::Equations;
use crate::diag::{Code, Diagnostics};
use crate::formulate::eliminates_beyond;
use crate::model::Model;

/// The most products that elimination over the constraint rows may take. They are written out one by one: so many take rustc
/// a minute. A chain takes some tens a joint; this is what 84 rows take that all meet each other.
const MOST_PRODUCTS: usize = 100_000;

/// The most coordinates and constraint rows. A chain of so many, a thousand bars, takes some seconds and half a gigabyte; what
/// is written out for it grows with them, and the memory faster.
const MOST_UNKNOWNS: usize = 5000;

/// Refuses what would keep the compiler busy without end: too many bodies and joints, or rows that all meet each other.
pub(crate) fn check_size(model: &Model, equations: &Equations, diagnostics: &mut Diagnostics) {
    let (name, rows, columns) = (&model.name, equations.phi.len(), equations.q.len());
    if rows + columns > MOST_UNKNOWNS {
        let message = format!(
            "`{}` is too large: {columns} coordinates and {rows} constraint rows, more than {MOST_UNKNOWNS} in all",
            name.text
        );
        diagnostics
            .error(Code::TooMany, name.span, message)
            .help("divide it into mechanisms that meet in inputs and outputs");
        return;
    }
    if !eliminates_beyond(MOST_PRODUCTS, equations) {
        return;
    }
    let message = format!(
        "`{}` is too closely joined: to eliminate its {rows} constraint rows takes more than {MOST_PRODUCTS} products",
        name.text
    );
    let error = diagnostics.error(Code::TooMany, name.span, message);
    if rows > columns {
        error.help(format!(
            "{columns} coordinates need no more rows than that: leave out joints that say what others say"
        ));
    } else {
        error.help("divide it into mechanisms that meet in inputs and outputs, or join its bodies in chains");
    }
}
