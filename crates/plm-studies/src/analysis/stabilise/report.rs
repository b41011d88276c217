//! Report of a search: residuals, freedoms and changes by name.

use std::fmt;

use nalgebra::{DMatrix, DVector};
use plm_runtime::Statics;

use super::contact::Support;
use super::evaluation::{Evaluation, Task};
use super::residuals::{Point, Setting};
use super::{BALANCED, Equilibrium, Stabilise};

/// Something that is not at rest, or would not be without its lock.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// The coordinate (`arm.y`), the state, or the constraint row.
    pub name: String,
    /// Kind of the residual.
    pub what: What,
    /// How much, in `unit`.
    pub value: f64,
    /// SI unit of the value.
    pub unit: String,
}

/// Why something is not at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum What {
    /// A locked coordinate stays where it is only with this force or moment.
    Lock,
    /// A force or moment that nothing balances, counted along this coordinate: what it acts on begins to move, or goes on
    /// moving steadily.
    Force,
    /// A locked state would change at this rate.
    LockedState,
    /// A state that changes at this rate, wherever it is.
    State,
    /// A motion that is prescribed: by a constraint, or by a locked velocity.
    Motion,
}

/// Coordinates and states that rest in other places as well, and how many of them would have to be locked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Freedom {
    /// Names of those any of which can be locked.
    pub names: Vec<&'static str>,
    /// How many have to be.
    pub count: usize,
}

/// A coordinate or a state at the equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Its name.
    pub name: &'static str,
    /// Its value, SI units.
    pub value: f64,
    /// How far it is from the assembled start.
    pub moved: f64,
    /// Its SI unit.
    pub unit: &'static str,
}

/// There is no equilibrium: what is not at rest.
///
/// Its `Debug` reads like its `Display`, since a `main` that returns it shows that one.
#[derive(Clone, PartialEq)]
pub struct Unbalanced {
    /// Everything that is not at rest.
    pub residuals: Vec<Residual>,
}

impl std::error::Error for Unbalanced {}

impl fmt::Debug for Unbalanced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Unbalanced {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let list: Vec<String> = self.residuals.iter().map(ToString::to_string).collect();
        write!(f, "no equilibrium: {}", list.join("; "))
    }
}

impl fmt::Display for Residual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, what, value, unit } = self;
        let value = Short(*value);
        match what {
            What::Lock => write!(f, "{name} is locked and needs {value} {unit} to stay"),
            What::Force => write!(f, "{name} moves: nothing balances {value} {unit}"),
            What::LockedState => write!(f, "{name} is locked and would change by {value} {unit}"),
            What::State => write!(f, "{name} does not come to residuals: it changes by {value} {unit}"),
            What::Motion => write!(f, "{name} is made to move by {value} {unit}"),
        }
    }
}

impl fmt::Display for Freedom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = self.names.join(", ");
        match self.count {
            1 => write!(f, "lock one of {names}"),
            count => write!(f, "lock {count} of {names}"),
        }
    }
}

impl<M: Statics> fmt::Display for Equilibrium<M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let found = if self.residuals.is_empty() { "equilibrium" } else { "no equilibrium" };
        writeln!(f, "{found} after {} iterations", self.iterations)?;
        for residual in &self.residuals {
            writeln!(f, "{residual}")?;
        }
        for freedom in &self.free {
            writeln!(f, "it rests in other places too: {freedom}")?;
        }
        if let Some(Change { name, moved, .. }) = self.far() {
            let (moved, size) = (Short(*moved), Short(self.size));
            writeln!(
                f,
                "far from the start: {name} moved by {moved} m, and the mechanism is {size} m large"
            )?;
        }
        for Change { name, value, moved, unit } in &self.values {
            let unit = if *unit == "no unit" { "" } else { unit };
            writeln!(f, "{name} = {} {unit} (moved by {})", Short(*value), Short(*moved))?;
        }
        for Support { name, force, used } in &self.supports {
            match (force, used) {
                (None, _) => writeln!(f, "{name} holds, by a force that is not unique")?,
                (Some(force), None) => writeln!(f, "{name} is closed and pushes by {}", Short(*force))?,
                (Some(force), Some(used)) => {
                    writeln!(f, "{name} holds by {}, {} % of its bound", Short(*force), Short(100.0 * used))?;
                }
            }
        }
        Ok(())
    }
}

/// A number in six digits.
struct Short(f64);

impl fmt::Display for Short {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if self.0 == 0.0 {
            write!(f, "0")
        } else if (1e-3..1e6).contains(&size) {
            let digits = (5 - size.log10().floor() as i32).max(0) as usize;
            write!(f, "{:.digits$}", self.0)
        } else {
            write!(f, "{:.5e}", self.0)
        }
    }
}

/// The last evaluation of a search.
pub(super) struct Found<'a, M: Stabilise> {
    pub(super) task: &'a Task<M>,
    pub(super) evaluation: &'a Evaluation,
    pub(super) before: &'a Point,
}

impl<M: Stabilise> Found<'_, M> {
    /// The mechanism, which has the names.
    fn mechanism(&self) -> &M {
        self.task.residuals.mechanism()
    }

    pub(super) fn equilibrium(
        &self,
        (mechanism, setting): (M, Setting<M>),
        iterations: u32,
    ) -> Equilibrium<M> {
        let mut residuals = self.motions();
        residuals.extend(self.locks());
        residuals.extend(self.forces());
        residuals.extend(self.states());
        let (free, values) = (self.free(), self.values());
        let size = self.task.scales.length;
        let supports = Vec::new();
        Equilibrium { mechanism, residuals, free, values, supports, size, iterations, setting }
    }

    /// Prescribed motions, which no pose brings to rest.
    fn motions(&self) -> Vec<Residual> {
        let residual = |name: &str, value, unit: &str| Residual {
            name: name.into(),
            what: What::Motion,
            value,
            unit: unit.into(),
        };
        let rates = self.task.residuals.rows(&self.evaluation.point).phi_dot;
        let size = 1e-9 * self.task.scales.length.max(1.0);
        let rows =
            self.mechanism().row_names().iter().zip(rates.iter()).filter(|(_, rate)| rate.abs() > size);
        let rows = rows.map(|(name, rate)| residual(name, -rate, "m/s or rad/s"));
        let locked = self.task.locks.motions.iter();
        rows.chain(locked.map(|(name, value)| residual(name, *value, "m/s or rad/s"))).collect()
    }

    /// Locks that need a force.
    fn locks(&self) -> Vec<Residual> {
        let locked = self.task.locked();
        let forces = locked.iter().zip(self.evaluation.of_locks.iter());
        let forces = forces.filter(|(k, force)| force.abs() > BALANCED * self.task.scales.force[**k]);
        let residual = |(k, force): (&usize, &f64)| self.force(What::Lock, *k, *force);
        forces.map(residual).collect()
    }

    /// Forces that nothing balances, as one along the coordinate that they move most.
    fn forces(&self) -> Option<Residual> {
        let scales = &self.task.scales;
        let scaled = self.evaluation.unbalanced.component_div(&scales.force);
        // What joints and locks cannot carry is orthogonal to what they can: it is itself a motion that they allow.
        let motion = scaled.component_div(&scales.force);
        let moves = motion.component_div(&scales.q);
        let (k, _) = moves.iter().map(|moved| moved.abs()).enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let work = scaled.norm_squared();
        (work.sqrt() > BALANCED).then(|| self.force(What::Force, k, -work / motion[k]))
    }

    fn force(&self, what: What, k: usize, value: f64) -> Residual {
        let name = self.mechanism().coordinate_names().get(k).copied().unwrap_or_default();
        let unit = if k % 3 == 2 { "N*m" } else { "N" };
        Residual { name: name.into(), what, value, unit: unit.into() }
    }

    /// States that change.
    fn states(&self) -> Vec<Residual> {
        let Evaluation { rate, rate_scale, .. } = self.evaluation;
        let moving = (0..rate.len()).filter(|i| rate[*i].abs() > BALANCED * rate_scale[*i]);
        let residual = |i: usize| {
            let (name, unit) = self.mechanism().state_names().get(i).copied().unwrap_or_default();
            let what = if self.task.locks.x[i] { What::LockedState } else { What::State };
            let unit = if unit == "no unit" { "1/s".into() } else { format!("{unit}/s") };
            Residual { name: name.into(), what, value: rate[i], unit }
        };
        moving.map(residual).collect()
    }

    /// Freedoms of the equilibrium: groups that move independently of each other.
    fn free(&self) -> Vec<Freedom> {
        let directions = &self.evaluation.free;
        let projector = directions * directions.transpose();
        let names: Vec<&'static str> = self
            .mechanism()
            .coordinate_names()
            .iter()
            .copied()
            .chain(self.mechanism().state_names().iter().map(|(name, _)| *name))
            .collect();
        groups(&projector)
            .into_iter()
            .map(|group| {
                // The trace of a projector is the number of its directions.
                let trace: f64 = group.iter().map(|i| projector[(*i, *i)]).sum();
                let names = group.into_iter().filter_map(|i| names.get(i).copied()).collect();
                Freedom { names, count: trace.round() as usize }
            })
            .collect()
    }

    fn values(&self) -> Vec<Change> {
        let (point, before) = (&self.evaluation.point, self.before);
        let coordinates = self.mechanism().coordinate_names().iter().enumerate().map(|(k, name)| {
            let unit = if k % 3 == 2 { "rad" } else { "m" };
            change(name, unit, (&point.q, &before.q), k)
        });
        let states = self.mechanism().state_names().iter().enumerate();
        let states = states.map(|(i, (name, unit))| change(name, unit, (&point.x, &before.x), i));
        coordinates.chain(states).collect()
    }
}

fn change(
    name: &'static str,
    unit: &'static str,
    (now, before): (&DVector<f64>, &DVector<f64>),
    i: usize,
) -> Change {
    Change { name, value: now[i], moved: now[i] - before[i], unit }
}

/// Indices that a projector connects, group by group.
fn groups(projector: &DMatrix<f64>) -> Vec<Vec<usize>> {
    const PART: f64 = 1e-6;
    let mut left: Vec<usize> = (0..projector.nrows()).filter(|i| projector[(*i, *i)] > PART * PART).collect();
    let mut groups = Vec::new();
    while let Some(first) = left.first().copied() {
        let mut group = vec![first];
        let mut seen = 0;
        while let Some(of) = group.get(seen).copied() {
            let joins = |i: &usize| !group.contains(i) && projector[(of, *i)].abs() > PART * PART;
            let more: Vec<usize> = left.iter().copied().filter(joins).collect();
            group.extend(more);
            seen += 1;
        }
        group.sort_unstable();
        left.retain(|i| !group.contains(i));
        groups.push(group);
    }
    groups
}
