//! Sources of the symbols of a model: their places among the arguments of a straight-line function.
//!
//! Emission writes a place as Rust, a mechanism at run time reads it as data: both have the symbols from here.

use plm_cas::Expr;

use crate::derive::Equations;
use crate::formulate::{Absolute, Chart, Reduced, Resolvent};
use crate::model::{ContactMode, Model};

/// The place of a symbol.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// Time, s.
    Time,
    /// A parameter, by number.
    Parameter(usize),
    /// An input, by number.
    Input(usize),
    /// The side of a condition that is held, by number.
    Switch(usize),
    /// The whole turns of an angle that are counted, by count.
    Turns(usize),
    /// The multiplier of a row of contact, by row.
    Multiplier(usize),
    /// 1 where a row of contact has this mode, else 0.
    Mode(usize, ContactMode),
    /// A number of the scalar.
    Scalar(OfScalar),
    /// A number that is remembered of loops, in the order of storage.
    Remembered(usize),
    /// An element of an array.
    Element(&'static str, usize),
    /// A number by itself.
    Number(&'static str),
}

/// Numbers that a scalar has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OfScalar {
    /// The largest ratio of a diagonal entry to its pivot.
    MostGrowth,
    /// Lengths that repeat each other may differ by one part in so many.
    Agreement,
    /// A unit in the last place of 1.
    Precision,
}

/// Origin of the arguments of a function.
#[derive(Clone, Copy)]
pub(crate) enum Origin<'a> {
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

/// The owners of the symbols.
#[derive(Clone, Copy)]
pub(crate) struct Symbols<'a> {
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) absolute: &'a Absolute,
    /// Joint coordinates, if they are taken.
    pub(crate) reduced: Option<&'a Reduced>,
}

impl Symbols<'_> {
    /// The place of every symbol, where a function has such arguments.
    pub(crate) fn of(&self, origin: Origin) -> Vec<(Expr, Source)> {
        let mut places = self.held();
        if let Origin::Resolvent(Resolvent { c, e, r, lambda, inverse, .. }) = origin {
            places.push((*lambda, Source::Number("lambda")));
            places.push((*inverse, Source::Number("inverse")));
            for (symbols, array) in [(c, "c"), (e, "e"), (r, "r")] {
                put(&mut places, symbols, array, 0);
            }
        }
        self.put_state(&mut places, origin);
        let Self { equations, absolute, reduced, .. } = self;
        let a = if matches!(origin, Origin::Linearised) { ("dx", equations.q.len()) } else { ("a", 0) };
        put(&mut places, &equations.a, a.0, a.1);
        put(&mut places, &equations.lambda, "lambda", 0);
        put(&mut places, &absolute.weights, "w", 0);
        put(&mut places, &absolute.r, "r", 0);
        let memory = reduced.iter().flat_map(|reduced| &reduced.memory);
        for (k, (symbol, _)) in memory.enumerate() {
            places.push((*symbol, Source::Remembered(k)));
        }
        places
    }

    /// Places of numbers that are constant during a step, and of the time.
    fn held(&self) -> Vec<(Expr, Source)> {
        let model = self.model;
        let mut places = Vec::new();
        for (k, param) in model.params.iter().enumerate() {
            places.push((param.symbol, Source::Parameter(k)));
        }
        for (k, input) in model.inputs.iter().enumerate() {
            places.push((input.symbol, Source::Input(k)));
        }
        for (k, switch) in model.switches.iter().enumerate() {
            places.push((switch.symbol, Source::Switch(k)));
        }
        for (k, counted) in model.turns.iter().enumerate() {
            places.push((counted.symbol, Source::Turns(k)));
        }
        for (k, contact) in model.contacts.iter().enumerate() {
            places.push((contact.lambda, Source::Multiplier(k)));
            places.push((contact.mode, Source::Mode(k, contact.kind_of_mode())));
        }
        places.push((model.time, Source::Time));
        places.push((model.most_growth, Source::Scalar(OfScalar::MostGrowth)));
        places.push((model.agreement, Source::Scalar(OfScalar::Agreement)));
        places.push((model.precision, Source::Scalar(OfScalar::Precision)));
        places
    }

    /// Coordinates, their rates and first-order states.
    fn put_state(&self, places: &mut Vec<(Expr, Source)>, origin: Origin) {
        let Self { equations, reduced, .. } = self;
        let nq = equations.q.len();
        let mut put = |symbols: &[Expr], array, offset| put(places, symbols, array, offset);
        match origin {
            Origin::Pose | Origin::Resolvent(_) => {}
            Origin::State => put(&equations.x, "x", 2 * reduced.map_or(nq, Reduced::freedom)),
            Origin::Arguments | Origin::Linearised => put(&equations.x, "x", 2 * nq),
            Origin::Chart(chart) | Origin::Rate(chart) => {
                let freedom = chart.y.len();
                put(&chart.y, "x", 0);
                put(&chart.y_dot, "x", freedom);
                put(&equations.x, "x", 2 * freedom);
                let linearised =
                    chart.linearised.as_ref().map(|linearised| &linearised.augmented.accelerations);
                let jacobian = chart.jacobian.as_ref().map(|jacobian| &jacobian.accelerations);
                for accelerations in linearised.into_iter().chain(jacobian) {
                    put(accelerations, "dx", freedom);
                }
                return;
            }
        }
        let [q, v] = match origin {
            Origin::Pose | Origin::State => [("q", 0), ("v", 0)],
            _ => [("x", 0), ("x", nq)],
        };
        put(&equations.q, q.0, q.1);
        put(&equations.v, v.0, v.1);
    }
}

/// Symbols as elements of an array, from `offset` on.
fn put(places: &mut Vec<(Expr, Source)>, symbols: &[Expr], array: &'static str, offset: usize) {
    for (k, &symbol) in symbols.iter().enumerate() {
        places.push((symbol, Source::Element(array, offset + k)));
    }
}
