//! One of each unknown and of each residual: a millimetre, a milliradian, a bar, a typical force.

use nalgebra::DVector;
use plm_runtime::{Start, StartValues};

use super::Stabilise;
use super::residuals::{Point, Residuals};

/// The size of one scaled unit of each quantity.
pub(super) struct Scales {
    /// Of coordinates: m or rad.
    pub(super) q: DVector<f64>,
    /// Of first-order states.
    pub(super) x: DVector<f64>,
    /// Of forces: N or N m.
    pub(super) force: DVector<f64>,
    /// Size of the mechanism, m.
    pub(super) length: f64,
}

impl Scales {
    /// Of a mechanism by what acts on it at its start: all forces, what a micrometre does to them, and each state.
    pub(super) fn of<M: Stabilise>(residuals: &Residuals<M>, start: &Point) -> Self {
        let length = residuals.mechanism().size();
        let lever = |k: usize| if k % 3 == 2 { length } else { 1.0 };
        let (force, by_q, by_x) =
            (residuals.rows(start).force, residuals.by_q(start).force, residuals.by_x(start).force);
        let acts = |k: usize| {
            let springs = 1e-6 * by_q.row(k).amax();
            let states = (0..start.x.len()).map(|i| (by_x[(k, i)] * start.x[i]).abs());
            states.fold(force[k].abs().max(springs), f64::max) / lever(k)
        };
        let typical = (0..force.len()).map(acts).fold(0.0, f64::max);
        let typical = if typical > 0.0 { typical } else { 1.0 };
        let names = residuals.mechanism().state_names();
        let state = |i: usize| names.get(i).map_or(1.0, |(_, unit)| size_of(unit, typical, length));
        Self {
            q: DVector::from_element(force.len(), 1e-3),
            x: DVector::from_fn(names.len(), |i, _| state(i)),
            force: DVector::from_fn(force.len(), |k, _| typical * lever(k)),
            length,
        }
    }
}

/// One of a quantity with this SI unit.
fn size_of(unit: &str, force: f64, length: f64) -> f64 {
    match unit {
        "m" | "rad" | "m/s" | "rad/s" => 1e-3,
        "Pa" => 1e5,
        "N" => force,
        "N*m" => force * length,
        "m^3" => 1e-6,
        "m^3/s" => 1e-3 / 60.0,
        _ => 1.0,
    }
}

/// Locked coordinates and states.
pub(super) struct Locks {
    /// Coordinates.
    pub(super) q: Vec<bool>,
    /// First-order states.
    pub(super) x: Vec<bool>,
    /// Locked velocities that are not zero: name, m/s or rad/s.
    pub(super) motions: Vec<(&'static str, f64)>,
}

impl Locks {
    pub(super) fn of<M: Stabilise>(mut mechanism: M) -> Self {
        let mut starts: Vec<(&'static str, Start<f64>)> = Vec::new();
        mechanism.starts_mut().each(&mut |name, start| starts.push((name, *start)));
        let (bodies, x) = starts.split_at(2 * mechanism.coordinate_names().len());
        let (mut q, mut motions) = (Vec::new(), Vec::new());
        for body in bodies.chunks(6) {
            let (position, velocity) = body.split_at(3);
            q.extend(position.iter().map(|(_, start)| start.locked));
            let moves = velocity.iter().filter(|(_, start)| start.locked && start.value != 0.0);
            motions.extend(moves.map(|(name, start)| (*name, start.value)));
        }
        Self { q, x: x.iter().map(|(_, start)| start.locked).collect(), motions }
    }
}
