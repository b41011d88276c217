//! A mechanism whose parameters, inputs and states have values, so that only its pose and velocity are open.

use plm_cas::Expr;

use super::values::defaults;
use crate::collect::PushAll;
use crate::derive::Equations;
use crate::evaluated::value;
use crate::formulate::Absolute;
use crate::model::Model;

/// A mechanism and values of all its symbols but coordinates and velocities.
pub(crate) struct Scene<'a> {
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) absolute: &'a Absolute,
    /// Each symbol and its value, SI.
    pub(crate) values: Vec<(Expr, f64)>,
    /// Its size, m: the unit in which gaps and tolerances are judged.
    pub(crate) length: f64,
}

impl<'a> Scene<'a> {
    /// The scene of a mechanism where its symbols have these values.
    pub(crate) fn new(
        model: &'a Model,
        equations: &'a Equations,
        absolute: &'a Absolute,
        values: Vec<(Expr, f64)>,
    ) -> Scene<'a> {
        let length = length(model, &values);
        Scene { model, equations, absolute, values, length }
    }

    /// The scene of a mechanism with its declared values, at time zero.
    pub(crate) fn declared(model: &'a Model, equations: &'a Equations, absolute: &'a Absolute) -> Scene<'a> {
        Scene::new(model, equations, absolute, defaults(model))
    }

    /// Values of all symbols but velocities at a pose `q`, m and rad.
    pub(crate) fn at(&self, q: &[f64]) -> Vec<(Expr, f64)> {
        let mut values = self.values.clone();
        values.push_all(self.equations.q.iter().copied().zip(q.iter().copied()));
        values
    }

    /// Values of all symbols at a pose `q` with velocities `v`, m/s and rad/s.
    pub(crate) fn moving(&self, q: &[f64], v: &[f64]) -> Vec<(Expr, f64)> {
        let mut values = self.at(q);
        values.push_all(self.equations.v.iter().copied().zip(v.iter().copied()));
        values
    }
}

/// The largest extent of a body, or 1 m if all are points.
fn length(model: &Model, values: &[(Expr, f64)]) -> f64 {
    let mut length: f64 = 0.0;
    for body in &model.bodies {
        for port in &body.ports {
            for component in port.at.components() {
                length = length.max(value(component, values).abs());
            }
        }
    }
    if length > 0.0 && length.is_finite() { length } else { 1.0 }
}
