//! The table of ERRORS.md: what is documented is what the tests demand.

use std::collections::BTreeMap;

/// (function, range) and its bounds for f64 and f32.
pub(crate) type Bounds = BTreeMap<(String, String), [f64; 2]>;

pub(crate) fn bounds() -> Bounds {
    let rows = include_str!("../../ERRORS.md").lines().filter(|line| line.starts_with("| "));
    let cells =
        rows.map(|row| row.replace("\\|", "¦").split('|').map(|c| c.trim().replace('¦', "|")).collect());
    let numbers = cells.filter_map(|cell: Vec<String>| {
        let bound = |k: usize| cell.get(k)?.parse().ok();
        Some(((cell[1].clone(), cell[2].clone()), [bound(3)?, bound(4)?]))
    });
    numbers.collect()
}
