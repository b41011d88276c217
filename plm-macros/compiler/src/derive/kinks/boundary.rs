//! The boundary of a condition, and what vanishes on it.
//!
//! That an expression vanishes wherever a difference does is looked at in random places, as zero tests of algebra are
//! (J. T. Schwartz, Fast probabilistic algorithms for verification of polynomial identities, J. ACM 27, 1980): symbols get
//! random values, and one of them is then moved onto the boundary by Newton's iteration.

use crate::collect::{CollectVec, PushAll};
use plm_cas::{Expr, algebra};

use crate::model::{Model, Steady};
use crate::numeric::{Random, defaults, value};

/// Places that are looked at.
const PLACES: u64 = 6;
/// So many are tried to find them: not every random place lies above a boundary, or in the domain of a root.
const TRIES: u64 = 60;
/// Below this part of the sides a difference is rounding.
const ROUNDING: f64 = 1e-9;

/// A quotient is looked at so far beside its pole, ...
const FAR: f64 = 1e-4;
/// ... and so near: that is 10 000 times, and of roots 100 times what it was.
const NEAR: f64 = 1e-8;
/// It grows if it does so by a part of that.
const GROWTH: f64 = 30.0;

/// The lowest derivative that jumps at a boundary.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Order {
    /// The position.
    Place,
    /// The velocity.
    Speed,
    /// The acceleration.
    Acceleration,
    /// None of these.
    Smooth,
}

/// Boundary of a condition, on which both sides meet: random places on it, and its time if that is one known number.
pub(in crate::derive) struct Boundary {
    /// Values of all symbols in some places on the boundary.
    places: Vec<Vec<(Expr, f64)>>,
    /// The symbol of the time, and the one time at which the condition changes, if it is a number.
    time: Option<(Expr, Expr)>,
}

impl Boundary {
    pub(in crate::derive) fn new(model: &Model, difference: Expr) -> Boundary {
        let held = algebra::symbols(&[difference]);
        let is_param = |symbol: Expr| model.params.iter().any(|param| param.symbol == symbol);
        let free = held.iter().copied().filter(|&symbol| !is_param(symbol));
        let solved: Vec<(Expr, Expr)> = free.map(|symbol| (symbol, difference.diff(symbol))).collect_vec();
        let places = (0..TRIES).filter_map(|seed| {
            let mut values = random(model, seed);
            let &(symbol, slope) = solved.get(seed as usize % solved.len().max(1))?;
            onto(difference, symbol, slope, &mut values).then_some(values)
        });
        let places = places.take(PLACES as usize).collect_vec();
        let alone = held.as_slice() == [model.time];
        let time = alone.then(|| root(difference, model.time, difference.diff(model.time)));
        let time = time.filter(|at| algebra::symbols(&[*at]).is_empty()).map(|at| (model.time, at));
        Boundary { places, time }
    }

    /// The first of the derivatives that does not vanish everywhere on the boundary.
    pub(super) fn order(&self, derivatives: &[Expr; 3], sides: [Expr; 2]) -> Order {
        let vanishes = |expr: Expr| {
            let mut seen = false;
            let all = self.places.iter().all(|values| {
                let size = sides.iter().map(|&side| value(side, values).abs()).fold(1.0, f64::max);
                let found = value(expr, values);
                seen |= found.is_finite();
                !found.is_finite() || found.abs() <= ROUNDING * size
            });
            all && seen
        };
        let orders = [Order::Place, Order::Speed, Order::Acceleration];
        let first = derivatives.iter().zip(orders).find(|(expr, _)| !vanishes(**expr));
        first.map_or(Order::Smooth, |(_, order)| order)
    }

    /// Does an expression grow without bound towards the boundary? A quotient does so as the distance, its root as the root.
    pub(in crate::derive) fn is_pole_of(&self, difference: Expr, root: Expr) -> bool {
        let read = algebra::symbols(&[difference]);
        self.places.iter().any(|values| {
            read.iter().any(|symbol| {
                let beside = |by: f64| {
                    let moved = values.iter().map(|&(of, at)| (of, if of == *symbol { at + by } else { at }));
                    value(root, &moved.collect_vec()).abs()
                };
                let (far, near) = (beside(FAR), beside(NEAR));
                near > GROWTH * far && near.is_finite()
            })
        })
    }

    /// The jump that happens whatever else does: a known time, and a known difference there.
    pub(super) fn jump(&self, gap: Expr, rate: Expr, sides: [Expr; 2]) -> Option<Steady> {
        let (time, at) = self.time?;
        let there = algebra::substitute(&[gap, rate, sides[0]], &[(time, at)]);
        let at = number(at);
        // A run begins at 0: what was before then is no motion.
        if at <= 0.0 {
            return None;
        }
        let size = number(there[2]).abs().max(1.0);
        let known = |expr: Expr| algebra::symbols(&[expr]).is_empty().then(|| number(expr));
        let place = known(there[0])?;
        if place.abs() > ROUNDING * size {
            return Some(Steady { at, by: place.abs(), of_speed: false });
        }
        let speed = known(there[1])?;
        (speed.abs() > ROUNDING * size).then_some(Steady { at, by: speed.abs(), of_speed: true })
    }
}

/// Random values of all symbols: parameters near their defaults, the rest between -2 and 2.
fn random(model: &Model, seed: u64) -> Vec<(Expr, f64)> {
    let mut numbers = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(1));
    let mut next = || 2.0 * numbers.unit();
    let mut values = defaults(model);
    for (symbol, number) in &mut values {
        *number = if *symbol == model.time { next() } else { *number * (1.0 + 0.1 * next()) + 0.01 * next() };
    }
    let coordinates = model.bodies.iter().flat_map(|body| body.q.into_iter().chain(body.v));
    values.push_all(coordinates.map(|symbol| (symbol, next())));
    values
}

/// Moves a symbol, along whose slope the difference changes, until that vanishes, by `s <- s - d / d'`; whether it does.
fn onto(difference: Expr, symbol: Expr, slope: Expr, values: &mut [(Expr, f64)]) -> bool {
    let Some(place) = values.iter().position(|(of, _)| *of == symbol) else { return false };
    for _ in 0..50 {
        let (d, by) = (value(difference, values), value(slope, values));
        let step = d / by;
        if !step.is_finite() {
            return d == 0.0;
        }
        values[place].1 -= step;
        if step.abs() <= 4.0 * f64::EPSILON * values[place].1.abs().max(1e-3) {
            return true;
        }
    }
    false
}

/// Root of `d`, which is linear in the symbol `s`: `s - d / d'`.
pub(in crate::derive) fn root(d: Expr, s: Expr, slope: Expr) -> Expr {
    s - d / slope
}

/// Value of what holds numbers alone.
fn number(expr: Expr) -> f64 {
    value(expr, &[])
}
