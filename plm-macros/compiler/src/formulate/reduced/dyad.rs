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

use plm_cas::Expr;

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
    pub(crate) fn of(coordinates: &Coordinates, closure: usize, unknowns: [usize; 2]) -> Option<Dyad> {
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
                let across = plane::cross(a.1, b.1);
                if a.0 == b.0 && across.is_zero() {
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
    ) -> Solution {
        let chain = &coordinates.closures[self.closure];
        let known = known(chain, &self.classes(), &self.unknowns, motion);
        let known = named(known, &format!("loop_{}", self.closure));
        let root = Root { closure: self.closure, side };
        match self.kind {
            Kind::Angles(classes) => {
                let link = Link::of(chain, self, motion, time);
                self.circles(chain, classes, (known, link), &root, motion)
            }
            Kind::Across { class, along } => {
                let link = Link::of(chain, self, motion, time);
                self.line_and_circle(chain, [class, along], (known, link), &root, motion)
            }
            Kind::Along { class } => self.line_that_turns(chain, class, known, &root, motion),
            Kind::Slides(classes) => self.lines(chain, classes, known, motion),
        }
    }

    /// Determinant and scale where all unknowns are known.
    pub(crate) fn at_pose(&self, coordinates: &Coordinates, motion: &Motion) -> Solution {
        let chain = &coordinates.closures[self.closure];
        let mut columns = [[Expr::ZERO; 2]; 2];
        let mut scale = Expr::ONE;
        for (k, class) in self.classes().into_iter().enumerate() {
            let arm = motion.whole_arm(chain, class);
            columns[k] = plane::left(arm);
            let square = plane::dot(arm, arm);
            scale *= square;
        }
        for (k, unknown) in self.unknowns.into_iter().enumerate() {
            if let Some((class, vector)) = chain.slide(unknown) {
                columns[k] = motion.turned(class, vector);
            }
        }
        if matches!(self.kind, Kind::Along { .. }) {
            scale = motion.length.powi(2);
        }
        let determinant = plane::cross(columns[0], columns[1]);
        let square = determinant.powi(2);
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
    ) -> Solution {
        let arms = [a, b].map(|class| motion.arm(chain, class, &[]));
        let [aa, bb] = arms.map(|arm| plane::dot(arm, arm));
        let mm = root.distance(known);
        let reach = mm + aa;
        let difference = bb - reach;
        let two = Expr::from(2);
        let n = difference / two;
        let n = n.named(format!("along_{}", self.closure));
        let (full, part) = (aa * mm, n.powi(2));
        let square = full - part;
        let (square, determinant) = root.of(square);
        let reciprocal = mm.recip();
        let reciprocal = reciprocal.named(format!("inverse_{}", self.closure));
        let ways = plane::scale(reciprocal, [n, determinant]);
        let ways = named(ways, &format!("way_{}", self.closure));
        let p = plane::turn(ways, known);
        let p = motion.name_arm(self.unknowns[0], p);
        let sum = plane::add(known, p);
        let r = motion.name_arm(self.unknowns[1], plane::negated(sum));
        motion.turn_class(self.unknowns[0], a, axis(p, arms[0], aa));
        motion.turn_class(self.unknowns[1], b, axis(r, arms[1], bb));
        for (class, vector, own, square) in [(a, p, arms[0], aa), (b, r, arms[1], bb)] {
            motion.bases.insert_arm(chain, class, Base { vector, own, square });
        }
        let columns = [plane::left(p), plane::left(r)];
        let scale = aa * bb;
        // From `m p = n`.
        let sum = n + aa;
        let unit = [Expr::ONE, Expr::ZERO];
        let own = Own { p: a, r: (b, unit), pp: aa, pr: (-sum), rr: Some(bb) };
        if let Some(link) = &link {
            link.meet(self, &own, (ways, determinant), motion);
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
    ) -> Solution {
        let [angle, slide] = self.unknowns;
        let arm = motion.arm(chain, class, &[]);
        let aa = plane::dot(arm, arm);
        let e = slide_axis(chain, slide, along, motion);
        let (offset, ahead) = (plane::cross(e, known), plane::dot(e, known));
        let squared = offset.powi(2);
        let square = aa - squared;
        let (square, determinant) = root.of(square);
        let value = determinant - ahead;
        motion.set_slide(slide, value);
        // `m + s e = D e + (e x m) J e`.
        let sum = across([determinant, offset], e);
        let p = motion.name_arm(angle, plane::negated(sum));
        motion.turn_class(angle, class, axis(p, arm, aa));
        motion.bases.insert_arm(chain, class, Base { vector: p, own: arm, square: aa });
        let r = [e[1], -e[0]];
        let own = Own { p: class, r: (0, r), pp: aa, pr: offset, rr: None };
        if let Some(link) = &link {
            let ways = plane::negated([determinant, offset]);
            link.meet(self, &own, (ways, determinant), motion);
        }
        let (columns, link) = ([plane::left(p), e], link.map(|link| (link, own)));
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
    ) -> Solution {
        let [angle, slide] = self.unknowns;
        let d = motion.arm(chain, class, &[slide]);
        let e = chain.slide(slide).map_or([Expr::ZERO; 2], |slide| slide.1);
        let (offset, ahead) = (plane::cross(e, d), plane::dot(e, d));
        let mm = root.distance(known);
        let squared = offset.powi(2);
        let square = mm - squared;
        let (square, determinant) = root.of(square);
        let back = -determinant;
        let value = back - ahead;
        motion.set_slide(slide, value);
        // `d + s e = -D e + (e x d) J e`.
        let arm = across([back, offset], e);
        let p = plane::negated(known);
        motion.turn_class(angle, class, axis(p, arm, mm));
        let columns = [plane::left(p), motion.turned(class, e)];
        let scale = motion.length.powi(2);
        Solution { determinant, square, scale, columns, arms: vec![(class, p)], link: None }
    }

    /// PRP and RPP.
    fn lines(&self, chain: &Chain, classes: [usize; 2], known: Vec2, motion: &mut Motion) -> Solution {
        let columns = [0, 1].map(|k| slide_axis(chain, self.unknowns[k], classes[k], motion));
        let determinant = plane::cross(columns[0], columns[1]);
        let determinant = determinant.named(format!("area_{}", self.closure));
        let ways = [plane::cross(columns[1], known), plane::cross(known, columns[0])];
        for (unknown, way) in self.unknowns.into_iter().zip(ways) {
            let value = way / determinant;
            motion.set_slide(unknown, value);
        }
        let square = determinant.powi(2);
        Solution { determinant, square, scale: Expr::ONE, columns, arms: Vec::new(), link: None }
    }
}

/// How the root of a dyad's determinant is taken.
struct Root {
    closure: usize,
    side: Option<Expr>,
}

impl Root {
    /// `D^2` by a name, and `D`.
    fn of(&self, square: Expr) -> (Expr, Expr) {
        let zero = Expr::ZERO;
        let square = square.named(format!("square_{}", self.closure));
        let real = square.max(zero);
        let root = real.sqrt();
        let root = root.named(format!("root_{}", self.closure));
        let Some(side) = self.side else { return (square, root) };
        let (mirrored, negative) = (side.less(zero), -root);
        let signed = mirrored.select(negative, root);
        (square, signed.named(format!("area_{}", self.closure)))
    }

    /// The square of a vector's length.
    fn distance(&self, vector: Vec2) -> Expr {
        let square = plane::dot(vector, vector);
        square.named(format!("distance_{}", self.closure))
    }
}

fn angle_and_slide(chain: &Chain, class: usize, slide: usize) -> Option<Kind> {
    let (along, _) = chain.slide(slide)?;
    Some(if along == class { Kind::Along { class } } else { Kind::Across { class, along } })
}

/// Sum of the vectors of a loop that do not hold the unknowns of a dyad.
pub(crate) fn known(chain: &Chain, turns: &[usize], unknowns: &[usize], motion: &Motion) -> Vec2 {
    let mut sum = [Expr::ZERO; 2];
    for class in chain.classes().into_iter().filter(|class| !turns.contains(class)) {
        let own = motion.arm(chain, class, unknowns);
        let own = motion.turned(class, own);
        sum = plane::add(sum, own);
    }
    sum
}

/// Direction in which a slide moves, in absolute axes.
fn slide_axis(chain: &Chain, slide: usize, class: usize, motion: &Motion) -> Vec2 {
    let vector = chain.slide(slide).map_or([Expr::ZERO; 2], |slide| slide.1);
    motion.turned(class, vector)
}

/// `a e + b J e`.
fn across([a, b]: [Expr; 2], e: Vec2) -> Vec2 {
    let (along, aside) = (plane::scale(a, e), plane::left(e));
    let aside = plane::scale(b, aside);
    plane::add(along, aside)
}

/// Cosine and sine of the angle that turns `arm`, of which the square is given, into `p`.
fn axis(p: Vec2, arm: Vec2, square: Expr) -> Vec2 {
    [plane::dot(arm, p), plane::cross(arm, p)].map(|product| product / square)
}

fn named(vector: Vec2, name: &str) -> Vec2 {
    let names = [format!("{name}_x"), format!("{name}_y")];
    [vector[0].named(&names[0]), vector[1].named(&names[1])]
}
