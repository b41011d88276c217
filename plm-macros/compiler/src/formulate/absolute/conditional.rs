//! Constraints with a condition, as assembly closes them where they hold at the start.

use crate::collect::CollectVec;
use plm_cas::Expr;

use crate::derive::Equations;
use crate::formulate::Function;
use crate::model::{ContactLaw, Model};

/// Functions of these constraints for assembly.
pub(crate) struct Conditional {
    /// Their places among the rows of contact.
    pub(crate) rows: Vec<usize>,
    /// `phi`, m or rad by row.
    pub(crate) phi: Function,
    /// `phi_dot`, m/s or rad/s by row.
    pub(crate) phi_dot: Function,
    /// `phi_q`, the entries of their Jacobian that are not zero by structure.
    pub(crate) phi_q: Function,
    /// Row and column of each of these entries.
    pub(crate) places: Vec<[usize; 2]>,
}

impl Conditional {
    /// The functions of the constraints with a condition; none without any.
    pub(super) fn new(model: &Model, equations: &Equations) -> Option<Conditional> {
        let contacts = model.contacts.iter().enumerate();
        let rows = contacts.filter(|(_, row)| matches!(row.law, ContactLaw::Constraint));
        let rows: Vec<usize> = rows.map(|(row, _)| row).collect_vec();
        if rows.is_empty() {
            return None;
        }
        // Assembly holds no switches, and its angles have all turns.
        let turns = model.turns.iter().map(|counted| (counted.symbol, Expr::ZERO));
        let here = model.released.iter().copied().chain(turns).collect_vec();
        let released =
            |name: &'static str, of: Vec<_>| Function::of_array(name, &of).substitute(&here).optimise();
        let phi = rows.iter().map(|row| model.contacts[*row].displacement).collect_vec();
        let phi_dot = rows.iter().map(|row| equations.contacts[*row].rate).collect_vec();
        let directions = rows.iter().enumerate();
        let entries = directions.flat_map(|(k, row)| {
            equations.contacts[*row].direction.iter().map(move |&(column, entry)| ([k, column], entry))
        });
        let (places, phi_q): (Vec<_>, Vec<_>) = entries.unzip();
        Some(Conditional {
            rows,
            phi: released("phi", phi),
            phi_dot: released("phi_dot", phi_dot),
            phi_q: released("phi_q", phi_q),
            places,
        })
    }
}
