//! Two unknowns of one loop in closed form: the dyads of L. V. Assur (F. Freudenstein, E. R. Maki, The creation of
//! mechanisms according to kinematic structure and function, Environment and Planning B 6, 1979), by what is unknown.
//!
//! With `m` the sum of the known vectors of the loop and `p`, `r` the unknown ones, `m + p + r = 0`:
//!
//! | unknown | dyad | solution |
//! |---|---|---|
//! | two angles | RRR | two circles: `p = (n m + D J m) / m^2`, `n = (r^2 - m^2 - p^2) / 2`, `D^2 = p^2 m^2 - n^2` |
//! | an angle, a displacement along another body | RRP, PRR | a line and a circle: `s = D - m . e`, `D^2 = p^2 - (m x e)^2` |
//! | an angle, a displacement along the same body | RPR | `s = -d . e - D`, `D^2 = m^2 - (d x e)^2` |
//! | two displacements | PRP, RPP | Cramer's rule |
//!
//! `J` is a quarter turn to the left. `D` is, in each case, the determinant of the loop's Jacobian by the two unknowns:
//! its sign tells the two mirror images apart, and where it vanishes they meet.

use plm_cas::{Expr, Rotation, Vec2};

use crate::collect::MapEach;
use crate::formulate::reduced::groups::crank::{Crank, DyadVectors};
use crate::formulate::reduced::groups::loops::{self, Found};
use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::bases::Base;
use crate::formulate::reduced::motion::solution::Solution;

/// A block of two unknowns that has a closed form.
#[derive(Clone, Copy)]
pub(crate) struct Dyad {
    /// The loop.
    pub(crate) closure: usize,
    /// Its two unknowns, an angle before a displacement.
    pub(crate) unknowns: [usize; 2],
    pub(crate) kind: Kind,
}

/// Kinds of the unknowns.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Two angles, of these orientations.
    Angles([usize; 2]),
    /// The angle of an orientation, and a displacement along another orientation.
    Across { orientation: usize, along: usize },
    /// The angle of an orientation, and a displacement along that orientation.
    Along { orientation: usize },
    /// Two displacements, along these orientations.
    Displacements([usize; 2]),
}

impl Dyad {
    /// The dyad of a block, if it has a closed form.
    pub(crate) fn of(coordinates: &Coordinates, closure: usize, unknowns: [usize; 2]) -> Option<Dyad> {
        let chain = &coordinates.closures[closure];
        let [first, second] = unknowns.map_each(|unknown| coordinates.unknowns[unknown]);
        let (unknowns, kind) = match (first, second) {
            (Unknown::Angle { orientation: a, .. }, Unknown::Angle { orientation: b, .. }) => {
                (unknowns, Kind::Angles([a, b]))
            }
            (Unknown::Angle { orientation, .. }, Unknown::Displacement { .. }) => {
                (unknowns, angle_and_displacement(chain, orientation, unknowns[1])?)
            }
            (Unknown::Displacement { .. }, Unknown::Angle { orientation, .. }) => {
                ([unknowns[1], unknowns[0]], angle_and_displacement(chain, orientation, unknowns[0])?)
            }
            (Unknown::Displacement { .. }, Unknown::Displacement { .. }) => {
                let [a, b] = [chain.displacement(unknowns[0])?, chain.displacement(unknowns[1])?];
                let across = a.1.cross(b.1);
                if a.0 == b.0 && across.is_zero() {
                    return None;
                }
                (unknowns, Kind::Displacements([a.0, b.0]))
            }
            _ => return None,
        };
        let dyad = Dyad { closure, unknowns, kind };
        // Without anything known, two bodies turn as one.
        let turns = dyad.orientations();
        let known = chain.terms().any(|(orientation, displacement, _)| {
            !turns.contains(&orientation) && displacement.is_none_or(|s| !unknowns.contains(&s))
        });
        (known || matches!(kind, Kind::Displacements(_))).then_some(dyad)
    }

    /// The orientations whose angles it determines.
    pub(crate) fn orientations(&self) -> Vec<usize> {
        match self.kind {
            Kind::Angles(orientations) => orientations.to_vec(),
            Kind::Across { orientation, .. } | Kind::Along { orientation } => vec![orientation],
            Kind::Displacements(_) => Vec::new(),
        }
    }

    /// Have its mirror images to be told apart?
    pub(crate) fn is_signed(&self) -> bool {
        !matches!(self.kind, Kind::Displacements(_))
    }

    /// Its name in the literature.
    pub(crate) fn name(&self) -> &'static str {
        match self.kind {
            Kind::Angles(_) => "RRR",
            Kind::Across { .. } => "RRP",
            Kind::Along { .. } => "RPR",
            Kind::Displacements(_) => "PRP",
        }
    }

    /// Effort of its solution, for the choice of coordinates: roots and divisions.
    pub(crate) fn cost(&self) -> u32 {
        match self.kind {
            Kind::Angles(_) => 4,
            Kind::Across { .. } | Kind::Along { .. } => 3,
            Kind::Displacements(_) => 1,
        }
    }

    /// Solves for the two unknowns and writes them, their coefficients and rates into `motion`. `side` has the sign of the
    /// determinant; without it the determinant is positive.
    pub(crate) fn solve(&self, motion: &mut Motion, side: Option<Expr>) -> Solution {
        let chain = &motion.coordinates.closures[self.closure];
        let m = motion.known_sum(chain, &self.orientations(), &self.unknowns);
        let m = m.named(format!("loop_{}", self.closure));
        let crank = Crank::of(chain, self, motion);
        let mut work = Solving { dyad: self, chain, m, side, motion };
        let (solution, own) = match self.kind {
            Kind::Angles(orientations) => work.circles(orientations, crank.as_ref()),
            Kind::Across { orientation, along } => work.line_and_circle(orientation, along, crank.as_ref()),
            Kind::Along { orientation } => (work.line_that_turns(orientation), None),
            Kind::Displacements(orientations) => (work.lines(orientations), None),
        };
        self.differentiate(motion, &solution, crank.as_ref().zip(own.as_ref()));
        solution
    }

    /// Writes coefficients and rates of the two unknowns into `motion`: by Cramer's rule, if not by one body that moves it.
    fn differentiate(&self, motion: &mut Motion, solution: &Solution, crank: Option<(&Crank, &DyadVectors)>) {
        let reciprocal = solution.determinant.recip().named(format!("reciprocal_{}", self.closure));
        if let Some((crank, own)) = crank {
            return crank.differentiate(motion, (self, own), reciprocal);
        }
        let [first, second] = solution.columns;
        let cramer = |sum: Vec2| {
            let minors = [second.cross(sum), sum.cross(first)];
            minors.map_each(|minor| minor * reciprocal).to_vec()
        };
        let found = Found { closure: self.closure, unknowns: &self.unknowns, solution, solve: &cramer };
        loops::differentiate(motion, &found);
    }

    /// Determinant and scale where all unknowns are known.
    pub(crate) fn at_pose(&self, motion: &Motion) -> Solution {
        let chain = &motion.coordinates.closures[self.closure];
        let mut columns = [Vec2::ZERO; 2];
        let mut scale = Expr::ONE;
        for (k, orientation) in self.orientations().into_iter().enumerate() {
            let arm = motion.absolute_arm(chain, orientation);
            columns[k] = arm.left();
            scale *= arm.squared();
        }
        for (k, unknown) in self.unknowns.into_iter().enumerate() {
            if let Some((orientation, vector)) = chain.displacement(unknown) {
                columns[k] = motion.turned(orientation, vector);
            }
        }
        if matches!(self.kind, Kind::Along { .. }) {
            scale = motion.length.squared();
        }
        let determinant = columns[0].cross(columns[1]);
        Solution { determinant, square: determinant.squared(), scale, columns, arms: Vec::new() }
    }
}

/// A dyad while it is being solved.
struct Solving<'a, 'm> {
    dyad: &'a Dyad,
    chain: &'a Chain,
    /// The sum of the known vectors.
    m: Vec2,
    /// A number with the sign of the determinant.
    side: Option<Expr>,
    motion: &'a mut Motion<'m>,
}

impl Solving<'_, '_> {
    /// RRR.
    fn circles(&mut self, [a, b]: [usize; 2], crank: Option<&Crank>) -> (Solution, Option<DyadVectors>) {
        let [first, second] = self.dyad.unknowns;
        let arms = [a, b].map_each(|orientation| self.motion.arm(self.chain, orientation, &[]));
        let [pp, rr] = arms.map_each(Vec2::squared);
        let mm = self.named("distance", self.m.squared());
        let n = self.named("along", (rr - (mm + pp)) / 2);
        let (square, determinant) = self.root(pp * mm - n.squared());
        let reciprocal = self.named("inverse", mm.recip());
        let ways = (reciprocal * Vec2::new(n, determinant)).named(format!("way_{}", self.dyad.closure));
        let ways = Rotation::to(ways);
        let p = self.motion.name_arm(first, ways * self.m);
        let r = self.motion.name_arm(second, -(self.m + p));
        self.motion.set_rotation(first, a, Rotation::between(arms[0], p) / pp);
        self.motion.set_rotation(second, b, Rotation::between(arms[1], r) / rr);
        for (orientation, vector, own, square) in [(a, p, arms[0], pp), (b, r, arms[1], rr)] {
            self.motion.bases.insert_arm(self.chain, orientation, Base { vector, own, square });
        }
        let columns = [p.left(), r.left()];
        // From `m p = n`.
        let own = DyadVectors { p: a, r: (b, Vec2::X), pp, pr: -(n + pp), rr: Some(rr) };
        if let Some(crank) = crank {
            crank.meet(self.dyad, &own, (ways, determinant), self.motion);
        }
        let arms = vec![(a, p), (b, r)];
        (Solution { determinant, square, scale: pp * rr, columns, arms }, Some(own))
    }

    /// RRP and PRR.
    fn line_and_circle(
        &mut self,
        orientation: usize,
        along: usize,
        crank: Option<&Crank>,
    ) -> (Solution, Option<DyadVectors>) {
        let [angle, displacement] = self.dyad.unknowns;
        let arm = self.motion.arm(self.chain, orientation, &[]);
        let pp = arm.squared();
        let e = self.displacement_axis(displacement, along);
        let (offset, ahead) = (e.cross(self.m), e.dot(self.m));
        let (square, determinant) = self.root(pp - offset.squared());
        self.motion.set_value(displacement, determinant - ahead);
        // `m + s e = D e + (e x m) J e`.
        let p = -(determinant * e + offset * e.left());
        let p = self.motion.name_arm(angle, p);
        self.motion.set_rotation(angle, orientation, Rotation::between(arm, p) / pp);
        self.motion.bases.insert_arm(self.chain, orientation, Base { vector: p, own: arm, square: pp });
        let own = DyadVectors { p: orientation, r: (0, -e.left()), pp, pr: offset, rr: None };
        if let Some(crank) = crank {
            let ways = Rotation::to(-Vec2::new(determinant, offset));
            crank.meet(self.dyad, &own, (ways, determinant), self.motion);
        }
        let (columns, arms) = ([p.left(), e], vec![(orientation, p)]);
        (Solution { determinant, square, scale: pp, columns, arms }, Some(own))
    }

    /// RPR.
    fn line_that_turns(&mut self, orientation: usize) -> Solution {
        let [angle, displacement] = self.dyad.unknowns;
        let d = self.motion.arm(self.chain, orientation, &[displacement]);
        let e = self.chain.displacement(displacement).map_or(Vec2::ZERO, |displacement| displacement.1);
        let (offset, ahead) = (e.cross(d), e.dot(d));
        let mm = self.named("distance", self.m.squared());
        let (square, determinant) = self.root(mm - offset.squared());
        self.motion.set_value(displacement, -determinant - ahead);
        // `d + s e = -D e + (e x d) J e`.
        let arm = -determinant * e + offset * e.left();
        let p = -self.m;
        self.motion.set_rotation(angle, orientation, Rotation::between(arm, p) / mm);
        let columns = [p.left(), self.motion.turned(orientation, e)];
        let scale = self.motion.length.squared();
        Solution { determinant, square, scale, columns, arms: vec![(orientation, p)] }
    }

    /// PRP and RPP.
    fn lines(&mut self, orientations: [usize; 2]) -> Solution {
        let [first, second] = self.dyad.unknowns;
        let columns =
            [self.displacement_axis(first, orientations[0]), self.displacement_axis(second, orientations[1])];
        let determinant = self.named("area", columns[0].cross(columns[1]));
        let minors = [columns[1].cross(self.m), self.m.cross(columns[0])];
        self.motion.set_value(first, minors[0] / determinant);
        self.motion.set_value(second, minors[1] / determinant);
        let square = determinant.squared();
        Solution { determinant, square, scale: Expr::ONE, columns, arms: Vec::new() }
    }

    /// `D^2` by a name, and `D`.
    fn root(&self, square: Expr) -> (Expr, Expr) {
        let square = self.named("square", square);
        let root = self.named("root", square.max(Expr::ZERO).sqrt());
        let Some(area) = self.side else { return (square, root) };
        // The side is held over a step: what tells it is the same in all stages.
        let side = self.named("side", area.less(Expr::ZERO).select(-Expr::ONE, Expr::ONE));
        (square, self.named("area", side * root))
    }

    /// The direction in which a displacement moves, in absolute axes.
    fn displacement_axis(&self, displacement: usize, orientation: usize) -> Vec2 {
        let vector = self.chain.displacement(displacement).map_or(Vec2::ZERO, |displacement| displacement.1);
        self.motion.turned(orientation, vector)
    }

    fn named(&self, what: &str, value: Expr) -> Expr {
        value.named(format!("{what}_{}", self.dyad.closure))
    }
}

fn angle_and_displacement(chain: &Chain, orientation: usize, displacement: usize) -> Option<Kind> {
    let (along, _) = chain.displacement(displacement)?;
    Some(if along == orientation { Kind::Along { orientation } } else { Kind::Across { orientation, along } })
}
