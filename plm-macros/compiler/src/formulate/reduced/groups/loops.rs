//! How the unknowns of a loop move with the coordinates: velocities and accelerations of its closure.
//!
//! With the columns `g_j` of the closure's Jacobian, `sum of g_j u_j' = 0` and `sum of g_j u_j'' + c = 0`, `c` being the
//! centripetal and Coriolis accelerations. Two of the `u_j` follow from the others by Cramer's rule: `u' = K y' + k` and
//! `u'' = K y'' + b`, the velocity and acceleration coefficients of the mechanism (E. J. Haug, Computer Aided Kinematics
//! and Dynamics of Mechanical Systems, 1989, section 3.6).

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Vec2};

use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::solution::Solution;

/// Unknowns of one closure that have been found.
pub(crate) struct Found<'a> {
    /// The loop.
    pub(crate) closure: usize,
    pub(crate) unknowns: &'a [usize],
    pub(crate) solution: &'a Solution,
    /// The unknowns `u` of `sum of g u + c = 0`, by `c`.
    pub(crate) solve: &'a dyn Fn(Vec2) -> Vec<Expr>,
}

impl Found<'_> {
    /// The rates that belong to `sum`, by unknown, with names.
    fn named(&self, sum: Vec2, what: &str) -> Vec<(usize, Expr)> {
        let values = (self.solve)(sum);
        let named = self
            .unknowns
            .iter()
            .zip(values)
            .enumerate()
            .map(|(k, (&unknown, value))| (unknown, value.named(format!("{what}_{}_{k}", self.closure))));
        named.collect_vec()
    }
}

/// Writes coefficients and rates of the unknowns that were found into `motion`.
pub(crate) fn differentiate(motion: &mut Motion, found: &Found) {
    let solved = (found.unknowns, &found.solution.arms[..]);
    let flow = Flow::new(motion, found.closure, solved);
    for coordinate in 0..motion.independent.len() {
        let sum = flow.coefficient(motion, coordinate);
        for (unknown, value) in found.named(sum, &format!("coefficient_{coordinate}")) {
            motion.coefficient[unknown][coordinate] = value;
        }
    }
    let sum = flow.time_rate(motion);
    for (unknown, value) in found.named(sum, "time_rate") {
        motion.time_rate[unknown] = value;
    }
    for &unknown in found.unknowns {
        motion.set_rate(unknown);
    }
    let sum = flow.bias(motion);
    for (unknown, value) in found.named(sum, "bias") {
        motion.bias[unknown] = value;
    }
}

/// How a closure moves with everything but the unknowns that are sought.
pub(crate) struct Flow<'a> {
    closure: &'a Chain,
    /// The vectors that turn with each orientation.
    arms: Vec<(usize, Vec2)>,
    /// The columns of the unknowns that are known.
    known: Vec<(usize, Vec2)>,
    /// Velocity of what moves with the time.
    ground_rate: Vec2,
}

impl<'a> Flow<'a> {
    /// `sought` are unknowns, and vectors of the closure that have names.
    pub(crate) fn new(
        motion: &Motion<'a>,
        closure: usize,
        (sought, solved): (&[usize], &[(usize, Vec2)]),
    ) -> Flow<'a> {
        let coordinates = motion.coordinates;
        let closure = &coordinates.closures[closure];
        let arms: Vec<(usize, Vec2)> = closure
            .orientations()
            .into_iter()
            .map(|orientation| {
                let solved = solved.iter().find(|(own, _)| *own == orientation);
                (orientation, solved.map_or_else(|| motion.absolute_arm(closure, orientation), |arm| arm.1))
            })
            .collect_vec();
        let mut known: Vec<(usize, Vec2)> = Vec::new();
        for &(orientation, arm) in &arms {
            known.push_all(coordinates.angle_of_orientation[orientation].map(|angle| (angle, arm.left())));
        }
        for (orientation, displacement, vector) in closure.terms() {
            if let Some(displacement) = displacement {
                known.push((displacement, motion.turned(orientation, vector)));
            }
        }
        known.retain(|(unknown, _)| !sought.contains(unknown));
        // What a port of the ground that moves with the motion.time adds.
        let ground = closure
            .of_orientation(0)
            .find(|(displacement, _)| displacement.is_none())
            .map_or(Vec2::ZERO, |(_, d)| d);
        Flow { closure, arms, known, ground_rate: ground.diff(motion.time) }
    }

    /// The closure's velocity when one coordinate moves at the rate 1.
    pub(crate) fn coefficient(&self, motion: &Motion, coordinate: usize) -> Vec2 {
        weighted(&self.known, |unknown| motion.coefficient[unknown][coordinate])
    }

    /// Its velocity when no coordinate moves.
    pub(crate) fn time_rate(&self, motion: &Motion) -> Vec2 {
        self.ground_rate + weighted(&self.known, |unknown| motion.time_rate[unknown])
    }

    /// Its acceleration when those of the coordinates and of what is sought are zero; all rates are known. With a pace, over
    /// its square.
    pub(crate) fn bias(&self, motion: &Motion) -> Vec2 {
        let mut sum = weighted(&self.known, |unknown| motion.bias[unknown]);
        for &(orientation, arm) in &self.arms {
            let omega = motion.turning[orientation];
            sum -= omega.squared() * arm;
            let relative = relative_velocity(self.closure, orientation, motion);
            // Coriolis: 2 omega J v.
            sum += (omega + omega) * relative.left();
        }
        sum + self.ground_rate.diff(motion.time)
    }
}

/// Velocity of the vector of a loop relative to the axes of its orientation, in absolute ones: from the rates of the displacements.
fn relative_velocity(closure: &Chain, orientation: usize, motion: &Motion) -> Vec2 {
    let displacements = closure
        .of_orientation(orientation)
        .filter_map(|(displacement, vector)| Some((displacement?, vector)));
    displacements
        .map(|(displacement, vector)| {
            let along = motion.turned(orientation, vector);
            motion.rate_over_pace(displacement) * along
        })
        .sum()
}

/// `sum of g_j w_j`.
fn weighted(columns: &[(usize, Vec2)], weight: impl Fn(usize) -> Expr) -> Vec2 {
    columns.iter().map(|&(unknown, column)| weight(unknown) * column).sum()
}
