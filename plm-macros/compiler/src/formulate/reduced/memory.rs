//! What a formulation with loops remembers from the last state that was looked at.

use plm_cas::{Expr, Graph};

use super::coordinates::{Coordinates, Unknown};

/// Symbols of the numbers that are remembered.
#[derive(Clone, Debug, Default)]
pub(crate) struct Memory {
    /// The time, and the time of the next look, which is the runtime's.
    times: Option<[Expr; 2]>,
    /// By unknown, for angles: the angle, its cosine and its sine.
    angles: Vec<Option<[Expr; 3]>>,
    /// By dyad of a chart: its determinant, the rate of that, and half the rate of the rate.
    areas: Vec<[Expr; 3]>,
}

/// What is kept of a dyad's determinant.
const AREA: [&str; 3] = ["area", "area_rate", "area_bend"];

/// What is to be remembered of one state; how fast the rate of a determinant changes is seen from two states, by the
/// runtime.
pub(crate) struct Memorable<'a> {
    pub(crate) time: Expr,
    /// By unknown that is an angle: value, cosine and sine.
    pub(crate) angle: &'a dyn Fn(usize, &mut Graph) -> [Expr; 3],
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
        let areas = (0..dyads).map(|k| AREA.map(|name| graph.symbol(&format!("last_{name}_{k}"))));
        let areas = areas.collect();
        Memory { times: Some(["last_time", "next_time"].map(|name| graph.symbol(name))), angles, areas }
    }

    /// All symbols in the order of storage.
    pub(crate) fn symbols(&self) -> Vec<Expr> {
        let angles = self.angles.iter().flatten().flatten();
        self.times.iter().flatten().chain(angles).chain(self.areas.iter().flatten()).copied().collect()
    }

    /// Numbers before the first determinant.
    pub(crate) fn before_areas(&self) -> usize {
        self.symbols().len() - AREA.len() * self.areas.len()
    }

    /// The values of [`Memory::symbols`] at a state.
    pub(crate) fn values(&self, of: &Memorable, graph: &mut Graph) -> Vec<Expr> {
        let mut values: Vec<Expr> = self.times.iter().flatten().map(|_| of.time).collect();
        for (unknown, angle) in self.angles.iter().enumerate() {
            if angle.is_some() {
                values.extend((of.angle)(unknown, graph));
            }
        }
        // A chart with fewer dyads than another leaves the last places alone.
        let blank = [graph.one(), graph.zero()];
        for k in 0..self.areas.len() {
            values.extend(of.areas.get(k).copied().unwrap_or(blank));
            values.push(graph.zero());
        }
        values
    }

    /// The determinant of a dyad as it should be at `time`, from where it was and how it moved.
    pub(crate) fn predicted(&self, dyad: usize, time: Expr, graph: &mut Graph) -> Option<Expr> {
        let ([area, rate, bend], [last, _]) = (*self.areas.get(dyad)?, self.times?);
        let passed = graph.sub(time, last);
        let passed = graph.define("since_look", passed);
        let bent = graph.mul(passed, bend);
        let slope = graph.add(rate, bent);
        let slope = graph.define("slope", slope);
        let change = graph.mul(passed, slope);
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
