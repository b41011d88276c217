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
    /// By unknown, for those that Newton's iteration starts from: value, rate, half the rate of that; of slides, over the
    /// size of the scene.
    followed: Vec<Option<[Expr; 3]>>,
    /// A unit in the last place of 1, which the runtime knows; if anything is followed.
    precision: Option<Expr>,
}

/// What is kept of a dyad's determinant.
const AREA: [&str; 3] = ["area", "area_rate", "area_bend"];
/// What is kept of an unknown that is followed.
const FOLLOWED: [&str; 3] = ["value", "rate", "bend"];

/// What is to be remembered of one state; how fast the rate of a determinant changes is seen from two states, by the
/// runtime.
pub(crate) struct Memorable<'a> {
    pub(crate) time: Expr,
    /// By unknown that is an angle: value, cosine and sine.
    pub(crate) angle: &'a dyn Fn(usize, &mut Graph) -> [Expr; 3],
    /// Determinants and their rates.
    pub(crate) areas: Vec<[Expr; 2]>,
    /// By unknown: value and rate as they are followed.
    pub(crate) followed: &'a dyn Fn(usize) -> [Expr; 2],
}

impl Memory {
    /// Memory for charts of at most `dyads` dyads, and for some unknowns that are followed; nothing for a tree.
    pub(crate) fn new(
        coordinates: &Coordinates,
        dyads: usize,
        followed: &[usize],
        graph: &mut Graph,
    ) -> Memory {
        let none = vec![None; coordinates.unknowns.len()];
        if dyads == 0 {
            return Memory { angles: none.clone(), followed: none, ..Memory::default() };
        }
        let triple = |kinds: [&str; 3], k: usize, graph: &mut Graph| {
            kinds.map(|kind| graph.symbol(&format!("last_{kind}_{k}")))
        };
        let angles = coordinates.unknowns.iter().enumerate().map(|(k, unknown)| {
            matches!(unknown, Unknown::Angle { .. }).then(|| triple(["angle", "cosine", "sine"], k, graph))
        });
        let angles = angles.collect();
        let areas = (0..dyads).map(|k| triple(AREA, k, graph)).collect();
        let mut places = none;
        for &unknown in followed {
            places[unknown] = Some(triple(FOLLOWED, unknown, graph));
        }
        let precision = (!followed.is_empty()).then(|| graph.symbol("precision"));
        let times = Some(["last_time", "next_time"].map(|name| graph.symbol(name)));
        Memory { times, angles, areas, followed: places, precision }
    }

    /// All symbols in the order of storage.
    pub(crate) fn symbols(&self) -> Vec<Expr> {
        let times = self.times.iter().flatten();
        let angles = self.angles.iter().flatten().flatten();
        let followed = self.followed.iter().flatten().flatten();
        let all =
            times.chain(angles).chain(self.areas.iter().flatten()).chain(followed).chain(&self.precision);
        all.copied().collect()
    }

    /// Numbers before the first determinant.
    pub(crate) fn before_areas(&self) -> usize {
        self.before_followed() - AREA.len() * self.areas.len()
    }

    /// Numbers before the first unknown that is followed.
    pub(crate) fn before_followed(&self) -> usize {
        let followed = FOLLOWED.len() * self.followed.iter().flatten().count();
        self.symbols().len() - followed - usize::from(self.precision.is_some())
    }

    /// The unknowns that are followed, ascending.
    pub(crate) fn followed(&self) -> impl Iterator<Item = usize> {
        self.followed.iter().enumerate().filter(|(_, place)| place.is_some()).map(|(unknown, _)| unknown)
    }

    /// A unit in the last place of 1.
    pub(crate) fn precision(&self) -> Option<Expr> {
        self.precision
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
        for unknown in self.followed() {
            values.extend((of.followed)(unknown));
            values.push(graph.zero());
        }
        values.extend(self.precision.map(|_| graph.zero()));
        values
    }

    /// The determinant of a dyad as it should be at `time`, from where it was and how it moved.
    pub(crate) fn predicted(&self, dyad: usize, time: Expr, graph: &mut Graph) -> Option<Expr> {
        let [area, rate, bend] = *self.areas.get(dyad)?;
        let change = self.change([rate, bend], time, graph)?;
        Some(graph.add(area, change))
    }

    /// Where an unknown was, and by how much it should have moved until `time`; of slides, over the size of the scene.
    pub(crate) fn moved(&self, unknown: usize, time: Expr, graph: &mut Graph) -> Option<[Expr; 2]> {
        let [value, rate, bend] = (*self.followed.get(unknown)?)?;
        Some([value, self.change([rate, bend], time, graph)?])
    }

    /// Change since the last look by a rate and half the rate of that.
    fn change(&self, [rate, bend]: [Expr; 2], time: Expr, graph: &mut Graph) -> Option<Expr> {
        let [last, _] = self.times?;
        let passed = graph.sub(time, last);
        let passed = graph.define("since_look", passed);
        let bent = graph.mul(passed, bend);
        let slope = graph.add(rate, bent);
        let slope = graph.define("slope", slope);
        Some(graph.mul(passed, slope))
    }

    /// Cosine and sine of an angle as remembered.
    pub(crate) fn axis(&self, unknown: usize) -> Option<[Expr; 2]> {
        let [_, cos, sin] = (*self.angles.get(unknown)?)?;
        Some([cos, sin])
    }

    /// The angle with the cosine and sine `axis` that is nearest to the one remembered.
    pub(crate) fn unwound(&self, unknown: usize, axis: [Expr; 2], graph: &mut Graph) -> Option<Expr> {
        let [angle, cos, sin] = (*self.angles.get(unknown)?)?;
        let turned = super::plane::turned_back(graph, axis, [cos, sin]);
        let by = graph.atan2(turned[1], turned[0]);
        Some(graph.add(angle, by))
    }
}
