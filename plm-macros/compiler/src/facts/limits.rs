//! Ranges of values that parameters give, and which parameters shape a mechanism.

use plm_cas::Expr;

use crate::collect::{CollectVec, MapEach};
use crate::model::{Model, Range};

/// A limited value.
#[derive(Clone, Debug)]
pub struct Limit {
    /// The part.
    pub part: String,
    /// Its name: `mass`, `compliance`.
    pub what: String,
    /// Its unit.
    pub unit: String,
    /// The values that are allowed.
    pub least: Least,
    /// The value.
    pub(crate) value: Expr,
}

/// The values that are allowed, as the runtime names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Least {
    /// Above zero.
    Positive,
    /// Zero or more, of a body that others carry.
    Carried,
    /// Zero or more.
    Zero,
    /// Zero or less.
    Negative,
    /// Zero to one.
    Share,
    /// Zero or more, infinity too: the margin of a requirement.
    Required,
}

impl Limit {
    fn new(part: &str, what: &str, unit: &str, least: Least, value: Expr) -> Limit {
        let [part, what, unit] = [part, what, unit].map_each(str::to_owned);
        Limit { part, what, unit, least, value }
    }

    /// Does it depend on parameters? Constants have been looked at.
    fn varies(&self) -> bool {
        self.value.as_number().is_none()
    }
}

/// Mass and inertia of every body; others may carry one without.
fn of_bodies(model: &Model, may_be_carried: bool) -> Vec<[Limit; 2]> {
    let least = if may_be_carried { Least::Carried } else { Least::Positive };
    let bodies = model.bodies.iter().map(|body| {
        let name = &body.name.text;
        [
            Limit::new(name, "mass", "kg", least, body.mass),
            Limit::new(name, "inertia", "kg*m^2", least, body.inertia),
        ]
    });
    bodies.collect_vec()
}

/// Limits of mass and inertia of every body, if others may carry some that parameters make massless.
pub(crate) fn that_may_be_carried(model: &Model, may_be_carried: bool) -> Option<Vec<[Limit; 2]>> {
    let bodies = of_bodies(model, may_be_carried);
    let varies = may_be_carried && bodies.iter().flatten().any(Limit::varies);
    varies.then_some(bodies)
}

/// The limited values that depend on parameters.
pub(crate) fn varying(model: &Model, may_be_carried: bool) -> Vec<Limit> {
    let others = model.limits.iter().map(|limit| {
        let least = match limit.range {
            Range::Positive => Least::Positive,
            Range::NotNegative => Least::Zero,
            Range::NotPositive => Least::Negative,
            Range::Share => Least::Share,
            Range::Required => Least::Required,
        };
        Limit::new(&limit.part, &limit.what, &limit.unit, least, limit.value)
    });
    let all = of_bodies(model, may_be_carried).into_iter().flatten().chain(others);
    all.filter(Limit::varies).collect_vec()
}

/// The values that joints, masses and known times are made of: a parameter that it reads shapes the mechanism.
pub(crate) fn shaping(model: &Model) -> Vec<Expr> {
    let rows = model.rows.iter().map(|row| row.phi);
    let bodies = model.bodies.iter().flat_map(|body| [body.mass, body.inertia, body.centre.x, body.centre.y]);
    let limits = model.limits.iter().map(|limit| limit.value);
    let switches = model.switches.iter().map(|switch| switch.difference);
    rows.chain(bodies).chain(limits).chain(switches).collect_vec()
}
