//! How the unknowns of a loop move with the coordinates: velocities and accelerations of its closure.
//!
//! With the columns `g_j` of the closure's Jacobian, `sum of g_j u_j' = 0` and `sum of g_j u_j'' + c = 0`, `c` being the
//! centripetal and Coriolis accelerations. Two of the `u_j` follow from the others by Cramer's rule: `u' = K y' + k` and
//! `u'' = K y'' + b`, the velocity and acceleration coefficients of the mechanism (E. J. Haug, Computer Aided Kinematics
//! and Dynamics of Mechanical Systems, 1989, section 3.6).

use plm_cas::{Expr, Graph};

use super::chain::Chain;
use super::coordinates::Coordinates;
use super::dyad::Dyad;
use super::motion::Motion;
use super::plane::{self, Vec2};
use super::solution::Solution;

/// Unknowns of one closure that have been found.
pub(crate) struct Found<'a> {
    /// The loop.
    pub(crate) closure: usize,
    pub(crate) unknowns: &'a [usize],
    pub(crate) solution: &'a Solution,
    /// The unknowns `u` of `sum of g u + c = 0`, by `c`.
    pub(crate) solve: &'a dyn Fn(Vec2, &mut Graph) -> Vec<Expr>,
}

impl Found<'_> {
    /// The rates that belong to `sum`, by unknown, with names.
    fn named(&self, sum: Vec2, what: &str, graph: &mut Graph) -> Vec<(usize, Expr)> {
        let values = (self.solve)(sum, graph);
        let named = self.unknowns.iter().zip(values).enumerate().map(|(k, (&unknown, value))| {
            (unknown, graph.define(&format!("{what}_{}_{k}", self.closure), value))
        });
        named.collect()
    }
}

/// Writes coefficients and rates of the two unknowns of a dyad into `motion`.
pub(crate) fn differentiate_dyad(
    coordinates: &Coordinates,
    motion: &mut Motion,
    dyad: &Dyad,
    solution: &Solution,
    time: Expr,
    graph: &mut Graph,
) {
    let reciprocal = graph.recip(solution.determinant);
    let reciprocal = graph.define(&format!("reciprocal_{}", dyad.closure), reciprocal);
    if let Some((link, own)) = &solution.link {
        return link.differentiate(coordinates, motion, (dyad, own), reciprocal, graph);
    }
    let [first, second] = solution.columns;
    let cramer = |sum: Vec2, graph: &mut Graph| {
        let minors = [plane::cross(graph, second, sum), plane::cross(graph, sum, first)];
        minors.map(|minor| graph.mul(minor, reciprocal)).to_vec()
    };
    let found = Found { closure: dyad.closure, unknowns: &dyad.unknowns, solution, solve: &cramer };
    differentiate(coordinates, motion, &found, time, graph);
}

/// Writes coefficients and rates of the unknowns that were found into `motion`.
pub(crate) fn differentiate(
    coordinates: &Coordinates,
    motion: &mut Motion,
    found: &Found,
    time: Expr,
    graph: &mut Graph,
) {
    let solved = (found.unknowns, &found.solution.arms[..]);
    let flow = Flow::new(coordinates, motion, found.closure, solved, time, graph);
    for driver in 0..motion.drivers.len() {
        let sum = flow.gain(motion, driver, graph);
        for (unknown, value) in found.named(sum, &format!("gain_{driver}"), graph) {
            motion.gain[unknown][driver] = value;
        }
    }
    let sum = flow.drift(motion, graph);
    for (unknown, value) in found.named(sum, "drift", graph) {
        motion.drift[unknown] = value;
    }
    for &unknown in found.unknowns {
        motion.set_rate(coordinates, unknown, graph);
    }
    let sum = flow.bias(motion, time, graph);
    for (unknown, value) in found.named(sum, "bias", graph) {
        motion.bias[unknown] = value;
    }
}

/// How a closure moves with everything but the unknowns that are sought.
pub(crate) struct Flow<'a> {
    closure: &'a Chain,
    /// The vectors that turn with each class.
    arms: Vec<(usize, Vec2)>,
    /// The columns of the unknowns that are known.
    known: Vec<(usize, Vec2)>,
    /// Velocity of what moves with the time.
    ground_rate: Vec2,
}

impl<'a> Flow<'a> {
    /// `sought` are unknowns, and vectors of the closure that have names.
    pub(crate) fn new(
        coordinates: &'a Coordinates,
        motion: &Motion,
        closure: usize,
        (sought, solved): (&[usize], &[(usize, Vec2)]),
        time: Expr,
        graph: &mut Graph,
    ) -> Flow<'a> {
        let closure = &coordinates.closures[closure];
        let arms: Vec<(usize, Vec2)> = closure
            .classes()
            .into_iter()
            .map(|class| {
                let solved = solved.iter().find(|(own, _)| *own == class);
                (class, solved.map_or_else(|| motion.whole_arm(closure, class, graph), |arm| arm.1))
            })
            .collect();
        let mut known: Vec<(usize, Vec2)> = Vec::new();
        for &(class, arm) in &arms {
            known.extend(coordinates.angle_of_class[class].map(|angle| (angle, plane::left(graph, arm))));
        }
        for (class, slide, vector) in closure.terms() {
            if let Some(slide) = slide {
                known.push((slide, motion.turned(graph, class, vector)));
            }
        }
        known.retain(|(unknown, _)| !sought.contains(unknown));
        // What a port of the ground that moves with the time adds.
        let ground: Vec2 =
            closure.of_class(0).filter(|(slide, _)| slide.is_none()).fold([graph.zero(); 2], |_, (_, d)| d);
        let ground_rate = ground.map(|component| graph.diff(component, time));
        Flow { closure, arms, known, ground_rate }
    }

    /// The closure's velocity when one coordinate moves at the rate 1.
    pub(crate) fn gain(&self, motion: &Motion, driver: usize, graph: &mut Graph) -> Vec2 {
        weighted(graph, &self.known, |unknown| motion.gain[unknown][driver])
    }

    /// Its velocity when no coordinate moves.
    pub(crate) fn drift(&self, motion: &Motion, graph: &mut Graph) -> Vec2 {
        let drifts = weighted(graph, &self.known, |unknown| motion.drift[unknown]);
        plane::add(graph, self.ground_rate, drifts)
    }

    /// Its acceleration when those of the coordinates and of what is sought are zero; all rates are known. With a pace, over
    /// its square.
    pub(crate) fn bias(&self, motion: &Motion, time: Expr, graph: &mut Graph) -> Vec2 {
        let mut sum = weighted(graph, &self.known, |unknown| motion.bias[unknown]);
        for &(class, arm) in &self.arms {
            let turning = motion.turning[class];
            let squared = graph.powi(turning, 2);
            let inward = plane::scale(graph, squared, arm);
            sum = [0, 1].map(|i| graph.sub(sum[i], inward[i]));
            let coriolis = sliding(self.closure, class, motion, &|slide| motion.sliding(slide), graph);
            let twice = graph.add(turning, turning);
            let across = plane::left(graph, coriolis);
            let across = plane::scale(graph, twice, across);
            sum = plane::add(graph, sum, across);
        }
        let moved = self.ground_rate.map(|component| graph.diff(component, time));
        plane::add(graph, sum, moved)
    }
}

/// Velocity of a loop's vector in the axes of its class, turned into absolute ones, by the rates of slides.
fn sliding(
    closure: &Chain,
    class: usize,
    motion: &Motion,
    rate: &dyn Fn(usize) -> Expr,
    graph: &mut Graph,
) -> Vec2 {
    let mut sum = [graph.zero(); 2];
    for (slide, vector) in closure.of_class(class) {
        if let Some(slide) = slide {
            let along = motion.turned(graph, class, vector);
            let along = plane::scale(graph, rate(slide), along);
            sum = plane::add(graph, sum, along);
        }
    }
    sum
}

/// `sum of g_j w_j`.
fn weighted(graph: &mut Graph, columns: &[(usize, Vec2)], weight: impl Fn(usize) -> Expr) -> Vec2 {
    let mut sum = [graph.zero(); 2];
    for &(unknown, column) in columns {
        let own = plane::scale(graph, weight(unknown), column);
        sum = plane::add(graph, sum, own);
    }
    sum
}
