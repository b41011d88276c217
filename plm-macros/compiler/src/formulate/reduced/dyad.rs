//! Two unknowns of one loop in closed form: the dyads of L. V. Assur (F. Freudenstein, E. R. Maki, The creation of
//! mechanisms according to kinematic structure and function, Environment and Planning B 6, 1979), by what is unknown.
//!
//! With `m` the sum of the known vectors of the loop and `p`, `r` the unknown ones, `m + p + r = 0`:
//!
//! | unknown | dyad | solution |
//! |---|---|---|
//! | two angles | RRR | two circles: `p = (n m + D J m) / m^2`, `n = (r^2 - m^2 - p^2) / 2`, `D^2 = p^2 m^2 - n^2` |
//! | an angle, a slide along another body | RRP, PRR | a line and a circle: `s = D - m . e`, `D^2 = p^2 - (m x e)^2` |
//! | an angle, a slide along the same body | RPR | `s = -d . e - D`, `D^2 = m^2 - (d x e)^2` |
//! | two slides | PRP, RPP | Cramer's rule |
//!
//! `J` is a quarter turn to the left. `D` is, in each case, the determinant of the loop's Jacobian by the two unknowns:
//! its sign tells the two mirror images apart, and where it vanishes they meet.

use plm_cas::{Expr, Graph};

use super::bases::Base;
use super::chain::Chain;
use super::coordinates::{Coordinates, Unknown};
use super::link::{Link, Own};
use super::motion::Motion;
use super::plane::{self, Vec2};
use super::solution::Solution;

/// A block of two unknowns that has a closed form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dyad {
    /// The loop.
    pub(crate) closure: usize,
    /// Its two unknowns, an angle before a slide.
    pub(crate) unknowns: [usize; 2],
    pub(crate) kind: Kind,
}

/// What is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Two angles, of these classes.
    Angles([usize; 2]),
    /// The angle of a class, and a slide along another class.
    Across { class: usize, along: usize },
    /// The angle of a class, and a slide along that class.
    Along { class: usize },
    /// Two slides, along these classes.
    Slides([usize; 2]),
}

impl Dyad {
    /// The dyad of a block, if it has a closed form.
    pub(crate) fn of(
        coordinates: &Coordinates,
        closure: usize,
        unknowns: [usize; 2],
        graph: &mut Graph,
    ) -> Option<Dyad> {
        let chain = &coordinates.closures[closure];
        let [first, second] = unknowns.map(|unknown| coordinates.unknowns[unknown]);
        let (unknowns, kind) = match (first, second) {
            (Unknown::Angle { class: a, .. }, Unknown::Angle { class: b, .. }) => {
                (unknowns, Kind::Angles([a, b]))
            }
            (Unknown::Angle { class, .. }, Unknown::Slide { .. }) => {
                (unknowns, angle_and_slide(chain, class, unknowns[1])?)
            }
            (Unknown::Slide { .. }, Unknown::Angle { class, .. }) => {
                ([unknowns[1], unknowns[0]], angle_and_slide(chain, class, unknowns[0])?)
            }
            (Unknown::Slide { .. }, Unknown::Slide { .. }) => {
                let [a, b] = [chain.slide(unknowns[0])?, chain.slide(unknowns[1])?];
                let across = plane::cross(graph, a.1, b.1);
                if a.0 == b.0 && graph.is_zero(across) {
                    return None;
                }
                (unknowns, Kind::Slides([a.0, b.0]))
            }
            _ => return None,
        };
        let dyad = Dyad { closure, unknowns, kind };
        // Without anything known, two bodies turn as one.
        let turns = dyad.classes();
        let known = chain
            .terms()
            .any(|(class, slide, _)| !turns.contains(&class) && slide.is_none_or(|s| !unknowns.contains(&s)));
        (known || matches!(kind, Kind::Slides(_))).then_some(dyad)
    }

    /// The classes whose angles it determines.
    pub(crate) fn classes(&self) -> Vec<usize> {
        match self.kind {
            Kind::Angles(classes) => classes.to_vec(),
            Kind::Across { class, .. } | Kind::Along { class } => vec![class],
            Kind::Slides(_) => Vec::new(),
        }
    }

    /// Have its mirror images to be told apart?
    pub(crate) fn is_signed(&self) -> bool {
        !matches!(self.kind, Kind::Slides(_))
    }

    /// Its name in the literature.
    pub(crate) fn name(&self) -> &'static str {
        match self.kind {
            Kind::Angles(_) => "RRR",
            Kind::Across { .. } => "RRP",
            Kind::Along { .. } => "RPR",
            Kind::Slides(_) => "PRP",
        }
    }

    /// Effort of its solution, for the choice of drivers: roots and divisions.
    pub(crate) fn cost(&self) -> u32 {
        match self.kind {
            Kind::Angles(_) => 4,
            Kind::Across { .. } | Kind::Along { .. } => 3,
            Kind::Slides(_) => 1,
        }
    }

    /// Solves for the two unknowns and writes them into `motion`. `side` has the sign of the determinant; without it the
    /// determinant is positive.
    pub(crate) fn solve(
        &self,
        coordinates: &Coordinates,
        motion: &mut Motion,
        side: Option<Expr>,
        time: Expr,
        graph: &mut Graph,
    ) -> Solution {
        let chain = &coordinates.closures[self.closure];
        let known = known(chain, &self.classes(), &self.unknowns, motion, graph);
        let known = named(graph, known, &format!("loop_{}", self.closure));
        let root = Root { closure: self.closure, side };
        match self.kind {
            Kind::Angles(classes) => {
                let link = Link::of(chain, self, motion, time, graph);
                self.circles(chain, classes, (known, link), &root, motion, graph)
            }
            Kind::Across { class, along } => {
                let link = Link::of(chain, self, motion, time, graph);
                self.line_and_circle(chain, [class, along], (known, link), &root, motion, graph)
            }
            Kind::Along { class } => self.line_that_turns(chain, class, known, &root, motion, graph),
            Kind::Slides(classes) => self.lines(chain, classes, known, motion, graph),
        }
    }

    /// Determinant and scale where all unknowns are known.
    pub(crate) fn at_pose(&self, coordinates: &Coordinates, motion: &Motion, graph: &mut Graph) -> Solution {
        let chain = &coordinates.closures[self.closure];
        let mut columns = [[graph.zero(); 2]; 2];
        let mut scale = graph.one();
        for (k, class) in self.classes().into_iter().enumerate() {
            let arm = motion.whole_arm(chain, class, graph);
            columns[k] = plane::left(graph, arm);
            let square = plane::dot(graph, arm, arm);
            scale = graph.mul(scale, square);
        }
        for (k, unknown) in self.unknowns.into_iter().enumerate() {
            if let Some((class, vector)) = chain.slide(unknown) {
                columns[k] = motion.turned(graph, class, vector);
            }
        }
        if matches!(self.kind, Kind::Along { .. }) {
            scale = graph.powi(motion.length, 2);
        }
        let determinant = plane::cross(graph, columns[0], columns[1]);
        let square = graph.powi(determinant, 2);
        Solution { determinant, square, scale, columns, arms: Vec::new(), link: None }
    }

    /// RRR.
    fn circles(
        &self,
        chain: &Chain,
        [a, b]: [usize; 2],
        (known, link): (Vec2, Option<Link>),
        root: &Root,
        motion: &mut Motion,
        graph: &mut Graph,
    ) -> Solution {
        let arms = [a, b].map(|class| motion.arm(chain, class, &[], graph));
        let [aa, bb] = arms.map(|arm| plane::dot(graph, arm, arm));
        let mm = root.distance(known, graph);
        let reach = graph.add(mm, aa);
        let difference = graph.sub(bb, reach);
        let two = graph.int(2);
        let n = graph.div(difference, two);
        let n = graph.define(&format!("along_{}", self.closure), n);
        let (full, part) = (graph.mul(aa, mm), graph.powi(n, 2));
        let square = graph.sub(full, part);
        let (square, determinant) = root.of(square, graph);
        let reciprocal = graph.recip(mm);
        let reciprocal = graph.define(&format!("inverse_{}", self.closure), reciprocal);
        let ways = plane::scale(graph, reciprocal, [n, determinant]);
        let ways = named(graph, ways, &format!("way_{}", self.closure));
        let p = plane::turn(graph, ways, known);
        let p = motion.name_arm(self.unknowns[0], p, graph);
        let sum = plane::add(graph, known, p);
        let r = motion.name_arm(self.unknowns[1], plane::negated(graph, sum), graph);
        motion.turn_class(self.unknowns[0], a, axis(graph, p, arms[0], aa), graph);
        motion.turn_class(self.unknowns[1], b, axis(graph, r, arms[1], bb), graph);
        for (class, vector, own, square) in [(a, p, arms[0], aa), (b, r, arms[1], bb)] {
            motion.bases.insert_arm(chain, class, Base { vector, own, square });
        }
        let columns = [plane::left(graph, p), plane::left(graph, r)];
        let scale = graph.mul(aa, bb);
        // From `m p = n`.
        let sum = graph.add(n, aa);
        let unit = [graph.one(), graph.zero()];
        let own = Own { p: a, r: (b, unit), pp: aa, pr: graph.neg(sum), rr: Some(bb) };
        if let Some(link) = &link {
            link.meet(self, &own, (ways, determinant), motion, graph);
        }
        let link = link.map(|link| (link, own));
        Solution { determinant, square, scale, columns, arms: vec![(a, p), (b, r)], link }
    }

    /// RRP and PRR.
    fn line_and_circle(
        &self,
        chain: &Chain,
        [class, along]: [usize; 2],
        (known, link): (Vec2, Option<Link>),
        root: &Root,
        motion: &mut Motion,
        graph: &mut Graph,
    ) -> Solution {
        let [angle, slide] = self.unknowns;
        let arm = motion.arm(chain, class, &[], graph);
        let aa = plane::dot(graph, arm, arm);
        let e = slide_axis(chain, slide, along, motion, graph);
        let (offset, ahead) = (plane::cross(graph, e, known), plane::dot(graph, e, known));
        let squared = graph.powi(offset, 2);
        let square = graph.sub(aa, squared);
        let (square, determinant) = root.of(square, graph);
        let value = graph.sub(determinant, ahead);
        motion.set_slide(slide, value, graph);
        // `m + s e = D e + (e x m) J e`.
        let sum = across(graph, [determinant, offset], e);
        let p = motion.name_arm(angle, plane::negated(graph, sum), graph);
        motion.turn_class(angle, class, axis(graph, p, arm, aa), graph);
        motion.bases.insert_arm(chain, class, Base { vector: p, own: arm, square: aa });
        let r = [e[1], graph.neg(e[0])];
        let own = Own { p: class, r: (0, r), pp: aa, pr: offset, rr: None };
        if let Some(link) = &link {
            let ways = plane::negated(graph, [determinant, offset]);
            link.meet(self, &own, (ways, determinant), motion, graph);
        }
        let (columns, link) = ([plane::left(graph, p), e], link.map(|link| (link, own)));
        Solution { determinant, square, scale: aa, columns, arms: vec![(class, p)], link }
    }

    /// RPR.
    fn line_that_turns(
        &self,
        chain: &Chain,
        class: usize,
        known: Vec2,
        root: &Root,
        motion: &mut Motion,
        graph: &mut Graph,
    ) -> Solution {
        let [angle, slide] = self.unknowns;
        let d = motion.arm(chain, class, &[slide], graph);
        let e = chain.slide(slide).map_or([graph.zero(); 2], |slide| slide.1);
        let (offset, ahead) = (plane::cross(graph, e, d), plane::dot(graph, e, d));
        let mm = root.distance(known, graph);
        let squared = graph.powi(offset, 2);
        let square = graph.sub(mm, squared);
        let (square, determinant) = root.of(square, graph);
        let back = graph.neg(determinant);
        let value = graph.sub(back, ahead);
        motion.set_slide(slide, value, graph);
        // `d + s e = -D e + (e x d) J e`.
        let arm = across(graph, [back, offset], e);
        let p = plane::negated(graph, known);
        motion.turn_class(angle, class, axis(graph, p, arm, mm), graph);
        let columns = [plane::left(graph, p), motion.turned(graph, class, e)];
        let scale = graph.powi(motion.length, 2);
        Solution { determinant, square, scale, columns, arms: vec![(class, p)], link: None }
    }

    /// PRP and RPP.
    fn lines(
        &self,
        chain: &Chain,
        classes: [usize; 2],
        known: Vec2,
        motion: &mut Motion,
        graph: &mut Graph,
    ) -> Solution {
        let columns = [0, 1].map(|k| slide_axis(chain, self.unknowns[k], classes[k], motion, graph));
        let determinant = plane::cross(graph, columns[0], columns[1]);
        let determinant = graph.define(&format!("area_{}", self.closure), determinant);
        let ways = [plane::cross(graph, columns[1], known), plane::cross(graph, known, columns[0])];
        for (unknown, way) in self.unknowns.into_iter().zip(ways) {
            let value = graph.div(way, determinant);
            motion.set_slide(unknown, value, graph);
        }
        let square = graph.powi(determinant, 2);
        Solution { determinant, square, scale: graph.one(), columns, arms: Vec::new(), link: None }
    }
}

/// How the root of a dyad's determinant is taken.
struct Root {
    closure: usize,
    side: Option<Expr>,
}

impl Root {
    /// `D^2` by a name, and `D`.
    fn of(&self, square: Expr, graph: &mut Graph) -> (Expr, Expr) {
        let zero = graph.zero();
        let square = graph.define(&format!("square_{}", self.closure), square);
        let real = graph.max(square, zero);
        let root = graph.sqrt(real);
        let root = graph.define(&format!("root_{}", self.closure), root);
        let Some(side) = self.side else { return (square, root) };
        let (mirrored, negative) = (graph.less(side, zero), graph.neg(root));
        let signed = graph.select(mirrored, negative, root);
        (square, graph.define(&format!("area_{}", self.closure), signed))
    }

    /// The square of a vector's length.
    fn distance(&self, vector: Vec2, graph: &mut Graph) -> Expr {
        let square = plane::dot(graph, vector, vector);
        graph.define(&format!("distance_{}", self.closure), square)
    }
}

fn angle_and_slide(chain: &Chain, class: usize, slide: usize) -> Option<Kind> {
    let (along, _) = chain.slide(slide)?;
    Some(if along == class { Kind::Along { class } } else { Kind::Across { class, along } })
}

/// Sum of the vectors of a loop that do not hold the unknowns of a dyad.
pub(crate) fn known(
    chain: &Chain,
    turns: &[usize],
    unknowns: &[usize],
    motion: &Motion,
    graph: &mut Graph,
) -> Vec2 {
    let mut sum = [graph.zero(); 2];
    for class in chain.classes().into_iter().filter(|class| !turns.contains(class)) {
        let own = motion.arm(chain, class, unknowns, graph);
        let own = motion.turned(graph, class, own);
        sum = plane::add(graph, sum, own);
    }
    sum
}

/// Direction in which a slide moves, in absolute axes.
fn slide_axis(chain: &Chain, slide: usize, class: usize, motion: &Motion, graph: &mut Graph) -> Vec2 {
    let vector = chain.slide(slide).map_or([graph.zero(); 2], |slide| slide.1);
    motion.turned(graph, class, vector)
}

/// `a e + b J e`.
fn across(graph: &mut Graph, [a, b]: [Expr; 2], e: Vec2) -> Vec2 {
    let (along, aside) = (plane::scale(graph, a, e), plane::left(graph, e));
    let aside = plane::scale(graph, b, aside);
    plane::add(graph, along, aside)
}

/// Cosine and sine of the angle that turns `arm`, of which the square is given, into `p`.
fn axis(graph: &mut Graph, p: Vec2, arm: Vec2, square: Expr) -> Vec2 {
    [plane::dot(graph, arm, p), plane::cross(graph, arm, p)].map(|product| graph.div(product, square))
}

fn named(graph: &mut Graph, vector: Vec2, name: &str) -> Vec2 {
    let names = [format!("{name}_x"), format!("{name}_y")];
    [graph.define(&names[0], vector[0]), graph.define(&names[1], vector[1])]
}
