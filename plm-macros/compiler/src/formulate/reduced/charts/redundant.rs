//! Redundant constraints that agree: which loop says what others have said.
//!
//! Structure counts too many rows; the rank of `phi_q` at the start tells how many. A loop is taken for one whose second
//! row is redundant if the mechanism that is left closes all its joints not only at the start but in poses away from it.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, Vec2, algebra};

use crate::derive::Equations;
use crate::formulate::reduced::charts::kinematics::kinematics;
use crate::formulate::reduced::charts::{self, Scheme};
use crate::formulate::reduced::joints::coordinates::{Coordinates, Unknown};
use crate::formulate::reduced::layout::Layout;
use crate::formulate::reduced::motion;
use crate::formulate::reduced::motion::memory::Memory;
use crate::model::Model;
use crate::numeric;

/// Sets of loops that are tried.
const MOST_SETS: usize = 200;
/// How far from the start the joints must close, rad or parts of the scene's length.
const AWAY: [f64; 3] = [0.05, -0.07, 0.11];
/// The largest gap there, as a part of the scene's length.
const CLOSED: f64 = 1e-9;
/// Below this square of the measure nothing follows from the coordinates.
const LEAST: f64 = 1e-12;

/// The start with the defaults of the parameters, where structure alone cannot decide.
pub(crate) struct Assembled {
    /// The size of the scene, m.
    pub(crate) length: f64,
    /// Coordinates less the rank of `phi_q` at regular poses next to the start.
    pub(crate) freedom: usize,
    /// Values of all symbols, pose and velocity included.
    pub(crate) values: Vec<(Expr, f64)>,
}

/// Knowledge of dimensions and the start.
#[derive(Clone, Copy)]
pub(crate) struct Known<'a> {
    /// The size of the scene, m.
    pub(crate) length: f64,
    /// Multipliers of the joints in absolute coordinates.
    pub(crate) lambda: &'a [Expr],
    /// The start, if the joints close.
    pub(crate) assembled: &'a dyn Fn() -> Option<Assembled>,
    /// Coordinates less the rank of `phi_q` with other values of the parameters, if there are any and the joints close then.
    pub(crate) freedom_elsewhere: &'a dyn Fn() -> Option<usize>,
}

/// The charts of a mechanism that is redundant, if some loops say what others have said.
pub(crate) fn schemes(
    model: &Model,
    equations: &Equations,
    coordinates: &Coordinates,
    assembled: &Assembled,
) -> Option<Vec<Scheme>> {
    let all = charts::equations(coordinates);
    let rows: usize = all.iter().map(|equation| equation.rows).sum();
    let loops = coordinates.closures.len();
    if loops == 0 {
        return None;
    }
    let redundant = (assembled.freedom + rows).checked_sub(coordinates.unknowns.len())?;
    if redundant == 0 || redundant > loops {
        return None;
    }
    for set in sets(loops, redundant) {
        let mut equations_left = all.clone();
        for &closure in &set {
            equations_left[closure].rows = 1;
        }
        let Ok(schemes) = charts::split(model, coordinates, &equations_left, assembled.freedom) else {
            continue;
        };
        let mut closing: Vec<Scheme> = Vec::new();
        let mut measure: f64 = 0.0;
        for scheme in schemes {
            if let Some(own) = closes(model, equations, coordinates, &scheme, assembled) {
                closing.push(scheme);
                measure = measure.max(own);
            }
        }
        // Two cranks of one parallelogram turn together in all poses that are tried, and determine nothing.
        if measure > LEAST {
            return Some(closing);
        }
    }
    None
}

/// The square of the measure at the start, if all joints close in poses away from it.
fn closes(
    model: &Model,
    equations: &Equations,
    coordinates: &Coordinates,
    scheme: &Scheme,
    assembled: &Assembled,
) -> Option<f64> {
    let Assembled { length, .. } = *assembled;
    let iterated: Vec<usize> = scheme.iterated().collect_vec();
    let memory = Memory::new(coordinates, (scheme.independent.len(), scheme.loops().count()), &iterated);
    let size = Expr::from(plm_cas::Number::from_f64(length));
    let motion = kinematics(model, coordinates, scheme, &memory, size);
    let remember_pose = {
        let mut layout = Layout {
            model,
            equations,
            coordinates,
            memory: &memory,
            length: size,
            lambda: &equations.lambda,
        };
        layout.remember_pose(scheme)
    };
    let values_of = |roots: &[Expr], values: &[(Expr, f64)]| numeric::run(&algebra::tape(roots), values);
    let remembered: Vec<Expr> = remember_pose.results.iter().map(|&(_, value)| value).collect_vec();
    let remembered = values_of(&remembered, &assembled.values);
    let independent: Vec<Expr> = scheme
        .independent
        .iter()
        .map(|&unknown| motion::of_pose(model, coordinates, coordinates.unknowns[unknown]))
        .collect_vec();
    let start = values_of(&independent, &assembled.values);
    let pose: Vec<Expr> = (0..model.bodies.len())
        .flat_map(|body| {
            let Vec2 { x, y } = motion.position[body];
            [x, y, motion.angle(coordinates.absolute_angles[body])]
        })
        .collect_vec();
    let others = assembled.values.iter().filter(|(symbol, _)| !equations.q.contains(symbol));
    let others: Vec<(Expr, f64)> = others.copied().collect_vec();
    let all_close = AWAY.iter().all(|away| {
        let mut at = others.clone();
        at.push_all(memory.symbols().into_iter().zip(remembered.iter().copied()));
        for (&unknown, &from) in scheme.independent.iter().zip(&start) {
            let is_angle = matches!(coordinates.unknowns[unknown], Unknown::Angle { .. });
            at.push((motion.value[unknown], from + if is_angle { *away } else { away * length }));
        }
        let q = values_of(&pose, &at);
        let mut there = others.clone();
        there.push_all(equations.q.iter().copied().zip(q));
        values_of(&equations.phi, &there).iter().all(|gap| gap.abs() <= CLOSED * length)
    });
    all_close.then(|| remembered.last().copied().unwrap_or(0.0))
}

/// Sets of so many loops; the later ones first, which were declared to hold what the earlier ones hold.
fn sets(loops: usize, size: usize) -> Vec<Vec<usize>> {
    let mut sets: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..size {
        let longer = sets.iter().flat_map(|set| {
            let below = set.last().copied().unwrap_or(loops);
            (0..below).rev().map(move |closure| set.iter().copied().chain([closure]).collect_vec())
        });
        sets = longer.take(MOST_SETS).collect_vec();
    }
    sets
}
