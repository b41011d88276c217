//! Where the symbols of the model are found in an emitted function.

use plm_cas::Expr;

use super::Emission;
use super::contract::contact_sliding;
use super::lower::Bindings;
use crate::collect::PushAll;
use crate::formulate::{Chart, Resolvent};
use crate::model::ContactMode;

/// Origin of the arguments of a function.
#[derive(Clone, Copy)]
pub(super) enum Origin<'a> {
    /// `self` is the mechanism; time, inputs and state are arguments `t`, `u`, `x`.
    Arguments,
    /// `self` is the mechanism; coordinates and velocities are arguments `q`, `v`.
    Pose,
    /// `self` is a `State`; the pose is in the locals `q`, `v`.
    State,
    /// `self` is the mechanism; `x` is the state in this chart, `m` what is remembered.
    Chart(&'a Chart),
    /// A chart's rate; the argument `DIRECT` tells of angles among it.
    Rate(&'a Chart),
    /// Absolute coordinates, with their rate `dx` and the multipliers `lambda`.
    Linearised,
    /// Operands of linear algebra: `c`, `e`, `r`, `lambda`, `inverse`.
    Resolvent(&'a Resolvent),
}

impl Emission<'_> {
    /// Source text of the parameters, where `self` is the mechanism.
    pub(super) fn parameters(&self) -> Bindings {
        let params = self.model.params.iter().zip(&self.fields.params);
        params.map(|(param, field)| (param.symbol, format!("self.{field}"))).collect()
    }

    /// Source text of every symbol.
    pub(super) fn bindings(&self, origin: Origin) -> Bindings {
        let Emission { model, equations, fields, .. } = self;
        let of_state = matches!(origin, Origin::State);
        let [mechanism, held, x, time] = if of_state {
            ["self.mechanism", "self.held", "self.x", "self.time"]
        } else {
            ["self", "u", "x", "t"]
        };
        let mut bindings = Vec::new();
        for (param, field) in model.params.iter().zip(&fields.params) {
            bindings.push((param.symbol, format!("{mechanism}.{field}")));
        }
        for (declared, field) in model.inputs.iter().zip(&fields.inputs) {
            bindings.push((declared.symbol, format!("{held}.input.{field}")));
        }
        for (k, switch) in model.switches.iter().enumerate() {
            bindings.push((switch.symbol, format!("{held}.switches[{k}]")));
        }
        for (k, counted) in model.turns.iter().enumerate() {
            bindings.push((counted.symbol, format!("S::of_turns({held}.turns[{k}])")));
        }
        for (k, contact) in model.contacts.iter().enumerate() {
            let multipliers = if of_state { "contact" } else { "u.contact.lambda" };
            bindings.push((contact.lambda, format!("{multipliers}[{k}]")));
            let does = match contact.kind_of_mode() {
                ContactMode::Open => "is_open",
                ContactMode::Sticking => "is_sticking",
            };
            let does = format!("S::lit({held}.contact.modes.{does}({k}) as u8 as f64)");
            bindings.push((contact.mode, does));
        }
        bindings.push((model.time, time.to_owned()));
        bindings.push((model.most_growth, "lit(S::MOST_GROWTH)".to_owned()));
        bindings.push((model.agreement, "lit(S::AGREEMENT)".to_owned()));
        bindings.push((model.precision, "lit(S::PRECISION)".to_owned()));
        if let Origin::Resolvent(resolvent) = origin {
            bindings.push((resolvent.lambda, "lambda".to_owned()));
            bindings.push((resolvent.inverse, "inverse".to_owned()));
        }
        let mut bind = |symbols: &[Expr], array: &str, offset: usize| {
            for (k, &symbol) in symbols.iter().enumerate() {
                bindings.push((symbol, format!("{array}[{}]", offset + k)));
            }
        };
        let nq = equations.q.len();
        let [q, v] = match origin {
            Origin::Pose | Origin::State => [("q", 0), ("v", 0)],
            _ => [(x, 0), (x, nq)],
        };
        match origin {
            Origin::Pose => {}
            Origin::Resolvent(Resolvent { c, e, r, .. }) => {
                bind(c, "c", 0);
                bind(e, "e", 0);
                bind(r, "r", 0);
            }
            Origin::State => bind(&equations.x, x, self.sizes.second_order),
            Origin::Arguments | Origin::Linearised => bind(&equations.x, x, 2 * nq),
            Origin::Chart(chart) | Origin::Rate(chart) => {
                let freedom = chart.y.len();
                bind(&chart.y, x, 0);
                bind(&chart.y_dot, x, freedom);
                bind(&equations.x, x, 2 * freedom);
                let linearised =
                    chart.linearised.as_ref().map(|linearised| &linearised.augmented.accelerations);
                let jacobian = chart.jacobian.as_ref().map(|jacobian| &jacobian.accelerations);
                for accelerations in linearised.into_iter().chain(jacobian) {
                    bind(accelerations, "dx", freedom);
                }
            }
        }
        if !matches!(origin, Origin::Chart(_) | Origin::Rate(_)) {
            bind(&equations.q, q.0, q.1);
            bind(&equations.v, v.0, v.1);
        }
        let a = if matches!(origin, Origin::Linearised) { ("dx", nq) } else { ("a", 0) };
        bind(&equations.a, a.0, a.1);
        bind(&equations.lambda, "lambda", 0);
        bind(&self.program.weights, "w", 0);
        bind(&self.program.r, "r", 0);
        for (symbols, array) in contact_sliding::symbols(self) {
            bind(symbols, array, 0);
        }
        let remembered = self.loops().into_iter().flat_map(|reduced| &reduced.memory);
        bindings.push_all(remembered.map(|(symbol, path)| (*symbol, format!("m.{path}"))));
        Bindings::of(bindings)
    }
}
