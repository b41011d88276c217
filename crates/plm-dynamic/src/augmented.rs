//! Linearised equations that implicit methods solve in place of df/dx.

use plm_compiler::lowered::{self, Elimination, Form, Lowered};
use plm_runtime::compact;
use plm_runtime::linalg::{Below, Pattern, Pivot};

use crate::code::Code;
use crate::kept::kept;
use crate::places::Room;

/// The equations of a mechanism.
#[derive(Debug)]
pub(crate) struct Augmented {
    pub(crate) coefficients: Code,
    /// Number of the coefficients.
    pub(crate) count: usize,
    pub(crate) pattern: &'static Pattern,
}

impl Augmented {
    /// Those of a mechanism whose state has this room in joint coordinates.
    pub(crate) fn new(lowered: &'static Lowered, state: Room) -> Option<Augmented> {
        let of = lowered.augmented.as_ref()?;
        let room = match lowered.form {
            Form::Absolute => Room { coordinates: lowered.coordinates.len(), ..state },
            Form::Tree | Form::Loops => state,
        };
        Some(Augmented {
            coefficients: Code::new(&of.coefficients, &["c"], room),
            count: of.coefficients.results.len(),
            pattern: Box::leak(Box::new(pattern(of))),
        })
    }
}

fn pattern(of: &lowered::Augmented) -> Pattern {
    let Elimination { terms, pivots, below, right, targets } = &of.elimination;
    let pivot = |&[row, entry, b0, b1, r0, r1, targets]: &[u32; 7]| Pivot {
        row,
        entry,
        below: [b0, b1],
        right: [r0, r1],
        targets,
    };
    let below_pivot = |&[row, entry, across]: &[u32; 3]| Below { row, entry, across };
    Pattern {
        coordinates: of.coordinates as u32,
        states: of.states as u32,
        terms: kept(terms.as_chunks::<5>().0.iter().map(|term| compact::term(*term))),
        pivots: kept(pivots.as_chunks::<7>().0.iter().map(pivot)),
        below: kept(below.as_chunks::<3>().0.iter().map(below_pivot)),
        right: kept(right.as_chunks::<2>().0.iter().copied()),
        targets: kept(targets.iter().copied()),
    }
}
