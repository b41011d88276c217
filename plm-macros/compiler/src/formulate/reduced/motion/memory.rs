//! Memory of a formulation with loops: values of the last accepted state.

use crate::collect::{CollectVec, MapEach, PushAll};
use plm_cas::{Expr, Rotation};

use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};

/// Symbols of the numbers that are remembered.
#[derive(Clone, Default)]
pub(crate) struct Memory {
    /// By coordinate of the chart, then for the time: where it was, and how far it may move until the next look.
    boxes: Vec<[Expr; 2]>,
    /// By unknown, for angles: the angle, its cosine and its sine.
    angles: Vec<Option<[Expr; 3]>>,
    /// By dyad of a chart: its determinant, whose sign tells the mirror images apart.
    areas: Vec<Expr>,
    /// By unknown, for those that Newton's iteration starts from: value, rate, half the rate of that; of displacements, over the
    /// size of the scene.
    followed: Vec<Option<[Expr; 3]>>,
}

/// Values that are kept of an unknown that is followed.
const FOLLOWED: [&str; 3] = ["value", "rate", "bend"];

/// Values of one state that are to be remembered.
pub(crate) struct Memorable<'a> {
    /// By coordinate, then for the time: value, and how far it may move until the next look.
    pub(crate) boxes: Vec<[Expr; 2]>,
    /// By unknown that is an angle: value, cosine and sine.
    pub(crate) angle: &'a dyn Fn(usize) -> [Expr; 3],
    /// Determinants.
    pub(crate) areas: Vec<Expr>,
    /// By unknown: value and rate as they are followed.
    pub(crate) followed: &'a dyn Fn(usize) -> [Expr; 2],
}

impl Memory {
    /// Memory for charts of `freedom` coordinates and at most `dyads` dyads, and for some unknowns that are followed;
    /// nothing for a tree.
    pub(crate) fn new(
        coordinates: &Coordinates,
        (freedom, dyads): (usize, usize),
        followed: &[usize],
    ) -> Memory {
        let none = vec![None; coordinates.unknowns.len()];
        if dyads == 0 {
            return Memory { angles: none.clone(), followed: none, ..Memory::default() };
        }
        let triple =
            |kinds: [&str; 3], k: usize| kinds.map_each(|kind| Expr::symbol(format!("last_{kind}_{k}")));
        let boxes =
            (0..=freedom).map(|k| ["last", "reach"].map_each(|kind| Expr::symbol(format!("{kind}_{k}"))));
        let boxes = boxes.collect_vec();
        let angles = coordinates.unknowns.iter().enumerate().map(|(k, unknown)| {
            matches!(unknown, Unknown::Angle { .. }).then(|| triple(["angle", "cosine", "sine"], k))
        });
        let angles = angles.collect_vec();
        let areas = (0..dyads).map(|k| Expr::symbol(format!("last_area_{k}"))).collect_vec();
        let mut places = none;
        for &unknown in followed {
            places[unknown] = Some(triple(FOLLOWED, unknown));
        }
        Memory { boxes, angles, areas, followed: places }
    }

    /// All symbols in the order of storage.
    pub(crate) fn symbols(&self) -> Vec<Expr> {
        let boxes = self.boxes.iter().flatten();
        let angles = self.angles.iter().flatten().flatten();
        let followed = self.followed.iter().flatten().flatten();
        boxes.chain(angles).chain(&self.areas).chain(followed).copied().collect_vec()
    }

    /// Paths of [`Memory::symbols`] in the runtime's `Continuation`, in their order.
    pub(crate) fn paths(&self) -> Vec<String> {
        let freedom = self.boxes.len().saturating_sub(1);
        let times = self.boxes.iter().skip(freedom).map(|_| "time".to_owned());
        let boxes = (0..freedom).map(|k| format!("coordinates[{k}]")).chain(times);
        let boxes = boxes.flat_map(|path| ["last", "reach"].map_each(|what| format!("{path}.{what}")));
        let angles = (0..self.angles.iter().flatten().count())
            .flat_map(|k| ["angle", "cos", "sin"].map_each(|what| format!("angles[{k}].{what}")));
        let areas = (0..self.areas.len()).map(|k| format!("determinants[{k}]"));
        let followed = (0..self.followed().count())
            .flat_map(|k| FOLLOWED.map_each(|what| format!("iterated[{k}].{what}")));
        boxes.chain(angles).chain(areas).chain(followed).collect_vec()
    }

    /// How many determinants are remembered.
    pub(crate) fn areas(&self) -> usize {
        self.areas.len()
    }

    /// The unknowns that are followed, ascending.
    pub(crate) fn followed(&self) -> impl Iterator<Item = usize> {
        self.followed.iter().enumerate().filter(|(_, place)| place.is_some()).map(|(unknown, _)| unknown)
    }

    /// The values of [`Memory::symbols`] at a state.
    pub(crate) fn values(&self, of: &Memorable) -> Vec<Expr> {
        let mut values: Vec<Expr> = of.boxes.iter().flatten().copied().collect_vec();
        for (unknown, angle) in self.angles.iter().enumerate() {
            if angle.is_some() {
                values.push_all((of.angle)(unknown));
            }
        }
        // A chart with fewer dyads than another leaves the last places alone.
        for k in 0..self.areas.len() {
            values.push(of.areas.get(k).copied().unwrap_or(Expr::ONE));
        }
        for unknown in self.followed() {
            values.push_all((of.followed)(unknown));
            values.push(Expr::ZERO);
        }
        values
    }

    /// A number with the sign that the determinant of a dyad has.
    pub(crate) fn area(&self, dyad: usize) -> Option<Expr> {
        self.areas.get(dyad).copied()
    }

    /// Last value of an unknown, and its change until `time` by extrapolation of second order; of displacements, over the size of the
    /// scene. `None` if the unknown is not followed.
    pub(crate) fn moved(&self, unknown: usize, time: Expr) -> Option<[Expr; 2]> {
        let [value, rate, bend] = (*self.followed.get(unknown)?)?;
        let [last, _] = *self.boxes.last()?;
        let passed = (time - last).named("since_remembered");
        let slope = (rate + passed * bend).named("slope");
        Some([value, passed * slope])
    }

    /// An angle as remembered.
    pub(crate) fn rotation(&self, unknown: usize) -> Option<Rotation> {
        let [_, cos, sin] = (*self.angles.get(unknown)?)?;
        Some(Rotation { cos, sin })
    }

    /// The angle of a rotation that is nearest to the one remembered.
    pub(crate) fn unwound(&self, unknown: usize, rotation: Rotation) -> Option<Expr> {
        let [angle, ..] = (*self.angles.get(unknown)?)?;
        let by = Rotation::between(self.rotation(unknown)?.axis(), rotation.axis());
        Some(angle + by.sin.atan2(by.cos))
    }
}
