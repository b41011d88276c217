//! What a formulation with loops remembers from the last state that was looked at.

use plm_cas::{Expr, Graph};

use super::coordinates::{Coordinates, Unknown};

/// Symbols of the numbers that are remembered.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    /// The time.
    time: Option<Expr>,
    /// By unknown, for angles: the angle, its cosine and its sine.
    angles: Vec<Option<[Expr; 3]>>,
    /// By dyad of a chart: its determinant and the rate of that.
    areas: Vec<[Expr; 2]>,
}

/// What is to be remembered of one state.
pub(crate) struct Memorable<'a> {
    pub(crate) time: Expr,
    /// By unknown: value, and axis if it is an angle.
    pub(crate) angle: &'a dyn Fn(usize) -> [Expr; 3],
    /// Determinants and their rates.
    pub(crate) areas: Vec<[Expr; 2]>,
}

impl Memory {
    /// Memory for charts of at most `dyads` dyads; nothing for a tree.
    pub(crate) fn new(coordinates: &Coordinates, dyads: usize, graph: &mut Graph) -> Memory {
        if dyads == 0 {
            return Memory { angles: vec![None; coordinates.unknowns.len()], ..Memory::default() };
        }
        let angles = coordinates.unknowns.iter().enumerate().map(|(k, unknown)| {
            let names = ["angle", "cosine", "sine"];
            matches!(unknown, Unknown::Angle { .. })
                .then(|| names.map(|name| graph.symbol(&format!("last_{name}_{k}"))))
        });
        let angles = angles.collect();
        let areas =
            (0..dyads).map(|k| ["area", "area_rate"].map(|name| graph.symbol(&format!("last_{name}_{k}"))));
        let areas = areas.collect();
        Memory { time: Some(graph.symbol("last_time")), angles, areas }
    }

    /// All symbols in the order of storage.
    pub(crate) fn symbols(&self) -> Vec<Expr> {
        let angles = self.angles.iter().flatten().flatten();
        self.time.iter().chain(angles).chain(self.areas.iter().flatten()).copied().collect()
    }

    /// Numbers before the first determinant.
    pub(crate) fn before_areas(&self) -> usize {
        self.symbols().len() - 2 * self.areas.len()
    }

    /// The values of [`Memory::symbols`] at a state.
    pub(crate) fn values(&self, of: &Memorable, graph: &Graph) -> Vec<Expr> {
        let mut values: Vec<Expr> = self.time.iter().map(|_| of.time).collect();
        for (unknown, angle) in self.angles.iter().enumerate() {
            if angle.is_some() {
                values.extend((of.angle)(unknown));
            }
        }
        // A chart with fewer dyads than another leaves the last places alone.
        let blank = [graph.one(), graph.zero()];
        let areas = (0..self.areas.len()).map(|k| of.areas.get(k).copied().unwrap_or(blank));
        values.extend(areas.flatten());
        values
    }

    /// The determinant of a dyad as it should be at `time`, from where it was and how it moved.
    pub(crate) fn predicted(&self, dyad: usize, time: Expr, graph: &mut Graph) -> Option<Expr> {
        let ([area, rate], last) = (*self.areas.get(dyad)?, self.time?);
        let passed = graph.sub(time, last);
        let passed = graph.define("since_look", passed);
        let change = graph.mul(passed, rate);
        Some(graph.add(area, change))
    }

    /// The angle with the cosine and sine `axis` that is nearest to the one remembered.
    pub(crate) fn unwound(&self, unknown: usize, axis: [Expr; 2], graph: &mut Graph) -> Option<Expr> {
        let [angle, cos, sin] = (*self.angles.get(unknown)?)?;
        let turned = super::plane::turned_back(graph, axis, [cos, sin]);
        let by = graph.atan2(turned[1], turned[0]);
        Some(graph.add(angle, by))
    }
}
