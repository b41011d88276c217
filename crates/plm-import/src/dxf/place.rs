//! Places of blocks in a drawing: shift, scale, turn, mirror.

use super::entities::Entity;
use crate::notice::Notices;

/// An affine map of the plane: columns of a matrix and a shift.
#[derive(Clone, Copy, Debug)]
pub(super) struct Placing {
    x: [f64; 2],
    y: [f64; 2],
    by: [f64; 2],
}

impl Placing {
    pub(super) const HERE: Placing = Placing { x: [1.0, 0.0], y: [0.0, 1.0], by: [0.0; 2] };

    pub(super) fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| x * self.x[i] + y * self.y[i] + self.by[i])
    }

    /// This after another one that is within it.
    fn of(&self, inner: &Placing) -> Placing {
        let direction = |v: [f64; 2]| [0, 1].map(|i| v[0] * self.x[i] + v[1] * self.y[i]);
        Placing { x: direction(inner.x), y: direction(inner.y), by: self.point(inner.by) }
    }

    /// The places of an INSERT within this one, one for each of its columns and rows, of a block with this base point.
    pub(super) fn inserted(
        &self,
        insert: &Entity<'_>,
        base: [f64; 2],
        notices: &mut Notices,
    ) -> Vec<Placing> {
        let (Some(at), Some(side)) = (insert.point(10), insert.side(notices)) else { return Vec::new() };
        let (scale_x, scale_y) = (insert.number(41).unwrap_or(1.0), insert.number(42).unwrap_or(1.0));
        let (sin, cos) = insert.number(50).unwrap_or(0.0).to_radians().sin_cos();
        let [columns, rows] = [70, 71].map(|code| insert.count(code).clamp(1, MOST));
        let [column, row] = [44, 45].map(|code| insert.number(code).unwrap_or(0.0));
        let mut placings = Vec::new();
        for (k, l) in (0..rows).flat_map(|l| (0..columns).map(move |k| (k, l))) {
            let away = [k as f64 * column, l as f64 * row];
            let by = [at[0] + cos * away[0] - sin * away[1], at[1] + sin * away[0] + cos * away[1]];
            let placed =
                Placing { x: [scale_x * cos, scale_x * sin], y: [-scale_y * sin, scale_y * cos], by };
            // From the back x goes the other way.
            let seen = Placing { x: [side, 0.0], ..Placing::HERE };
            let from_base = Placing { by: [-base[0], -base[1]], ..Placing::HERE };
            placings.push(self.of(&seen.of(&placed.of(&from_base))));
        }
        placings
    }
}

/// Columns and rows of blocks, at most.
const MOST: i64 = 1000;
