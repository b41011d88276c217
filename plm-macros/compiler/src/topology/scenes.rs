//! Linkages for the tests of this folder.

use super::blocks::Equation;
use super::cycles::shortest_cycle_basis;

/// A revolute joint: body and point, body and point. Body 0 is the ground; points are numbered on each body.
type Pin = (usize, usize, usize, usize);

/// A linkage of revolutes alone; the angle of body `k` is unknown `k - 1`.
pub(super) struct Linkage {
    pub(super) bodies: usize,
    pub(super) pins: Vec<Pin>,
}

impl Linkage {
    fn new(pins: &[Pin]) -> Linkage {
        let bodies = pins.iter().map(|&(a, _, b, _)| a.max(b)).max().unwrap_or(0);
        Linkage { bodies, pins: pins.to_vec() }
    }

    pub(super) fn nodes(&self) -> usize {
        self.bodies + 1
    }

    pub(super) fn edges(&self) -> Vec<(usize, usize)> {
        self.pins.iter().map(|&(a, _, b, _)| (a, b)).collect()
    }

    /// The closures of the shortest loops. A loop holds the angle of a body that it leaves at another point than it
    /// enters.
    pub(super) fn closures(&self) -> Vec<Equation> {
        let basis = shortest_cycle_basis(self.nodes(), &self.edges());
        let closures = basis.iter().map(|cycle| {
            let walked: Vec<Pin> = cycle.iter().map(|&(edge, along)| walk(self.pins[edge], along)).collect();
            let passed = walked.iter().zip(walked.iter().cycle().skip(1));
            let turned = passed.filter(|((_, _, body, entry), (_, exit, _, _))| *body > 0 && entry != exit);
            let mut unknowns: Vec<usize> = turned.map(|(pin, _)| pin.2 - 1).collect();
            unknowns.sort_unstable();
            Equation { unknowns, rows: 2 }
        });
        closures.collect()
    }
}

fn walk((a, at_a, b, at_b): Pin, along: bool) -> Pin {
    if along { (a, at_a, b, at_b) } else { (b, at_b, a, at_a) }
}

/// Crank 1, coupler 2, rocker 3: also the triple rocker, whose graph is the same.
pub(super) fn four_bar() -> Linkage {
    Linkage::new(&[(0, 1, 1, 1), (1, 2, 2, 1), (2, 2, 3, 2), (3, 1, 0, 2)])
}

/// Andrews' squeezing mechanism: K1 to K7; four bars meet at E, which K2 holds.
pub(super) fn andrews() -> Linkage {
    Linkage::new(&[
        (1, 1, 0, 1),
        (1, 2, 2, 1),
        (2, 2, 3, 2),
        (3, 1, 0, 2),
        (2, 2, 4, 2),
        (4, 1, 5, 2),
        (5, 1, 0, 3),
        (2, 2, 6, 2),
        (6, 1, 7, 2),
        (7, 1, 0, 3),
    ])
}

/// The manual's rhombi on a Peaucellier cell: crank 1, OA 2, OB 3, AC 4, BC 5, then the dyads a1 6, b1 7 to a4 12,
/// b4 13.
pub(super) fn quadrorhomb() -> Linkage {
    Linkage::new(&[
        (0, 1, 1, 1),
        (0, 2, 2, 1),
        (0, 2, 3, 1),
        (1, 2, 4, 1),
        (1, 2, 5, 1),
        (2, 2, 4, 2),
        (2, 2, 6, 1),
        (3, 2, 5, 2),
        (3, 2, 7, 1),
        (6, 2, 7, 2),
        (7, 3, 8, 1),
        (6, 3, 9, 1),
        (8, 2, 9, 2),
        (9, 3, 10, 1),
        (8, 3, 11, 1),
        (10, 2, 11, 2),
        (11, 3, 12, 1),
        (10, 3, 13, 1),
        (12, 2, 13, 2),
    ])
}

/// `windows` four-bars in a row (IFToMM benchmark A02): uprights 1, 3, 5 and so on, couplers 2, 4, 6 and so on.
pub(super) fn ladder(windows: usize) -> Linkage {
    let mut pins: Vec<Pin> = vec![(0, 0, 1, 1)];
    for window in 0..windows {
        let upright = 2 * window + 1;
        pins.extend([
            (upright, 2, upright + 1, 1),
            (upright + 1, 2, upright + 2, 2),
            (0, window + 1, upright + 2, 1),
        ]);
    }
    Linkage::new(&pins)
}

/// Two ternary links that are pinned to each other, twice (the butterflies: the ground and 1, 2 and 3), with a binary
/// link from each wing to each of the other pair: 8 bars, 10 revolutes, the only chain of four ternary and four binary
/// links without a loop of four (K. J. Waldron, S. V. Sreenivasan, A study of the solvability of the position problem
/// for multi-circuit mechanisms by way of example of the double butterfly linkage, J. Mech. Design 118, 1996).
pub(super) fn double_butterfly() -> Linkage {
    Linkage::new(&[
        (0, 1, 1, 1),
        (2, 1, 3, 1),
        (0, 2, 4, 1),
        (4, 2, 2, 2),
        (0, 3, 5, 1),
        (5, 2, 3, 2),
        (1, 2, 6, 1),
        (6, 2, 2, 3),
        (1, 3, 7, 1),
        (7, 2, 3, 3),
    ])
}

/// A four-bar 1, 2, 3 whose coupler 2 carries the dyad 4, 5 to a third pivot on the ground.
pub(super) fn stephenson_iii() -> Linkage {
    Linkage::new(&[
        (0, 1, 1, 1),
        (1, 2, 2, 1),
        (2, 2, 3, 2),
        (3, 1, 0, 2),
        (2, 3, 4, 1),
        (4, 2, 5, 2),
        (5, 1, 0, 3),
    ])
}

/// Cranks 1, 2, 3 on one coupler 4.
pub(super) fn three_cranks() -> Linkage {
    Linkage::new(&[(0, 1, 1, 1), (0, 2, 2, 1), (0, 3, 3, 1), (1, 2, 4, 1), (2, 2, 4, 2), (3, 2, 4, 3)])
}

/// A ground that carries nothing but a crank, and a four-bar of bodies 2 to 5 that floats.
pub(super) fn floating_four_bar() -> Linkage {
    Linkage::new(&[(0, 1, 1, 1), (2, 1, 3, 1), (3, 2, 4, 1), (4, 2, 5, 1), (5, 2, 2, 2)])
}

/// A crank 1 and dyads, each between two bodies that were there before.
pub(super) fn grown(dyads: usize, random: &mut Random) -> Linkage {
    let mut pins: Vec<Pin> = vec![(0, 0, 1, 0)];
    for first in (2..).step_by(2).take(dyads) {
        let left = random.below(first);
        let right = (left + 1 + random.below(first - 1)) % first;
        let (at_left, at_right) = (pins.len(), pins.len() + 2);
        pins.extend([(left, at_left, first, 0), (first, 1, first + 1, 0), (first + 1, 1, right, at_right)]);
    }
    Linkage::new(&pins)
}

/// A sequence of numbers for random cases (D. E. Knuth, The Art of Computer Programming 2, section 3.3.4, table 1).
pub(super) struct Random(pub(super) u64);

impl Random {
    /// A number below `bound`.
    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound
    }
}
