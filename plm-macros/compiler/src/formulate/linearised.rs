//! Linearised equations of motion, for implicit methods.
//!
//! They are derived entry by entry where that takes fewer operations than dual numbers. For loops that may come to a singular
//! pose the full matrix is derived instead.

use crate::sorted::SortedMap;

use plm_cas::{Expr, algebra};

use super::function::{Function, Place, Section, stored};
use super::pattern::Pattern;
use super::resolvent::Resolvent;
use crate::model::{Model, Step};

/// Factor of a coefficient; the words are those of the runtime.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Part {
    Value,
    Rate,
    Position,
    Velocity,
    Acceleration,
}

/// Coefficients by equation, unknown and part of it.
pub(crate) type Terms = SortedMap<(usize, usize, Part), Expr>;

/// A coefficient in an equation.
#[derive(Clone, Copy)]
pub(crate) struct Term {
    /// Its place among the results of [`Augmented::coefficients`].
    pub(crate) coefficient: usize,
    pub(crate) row: usize,
    pub(crate) column: usize,
    pub(crate) part: Part,
}

/// The linearised equations.
pub(crate) struct Augmented {
    /// `c`: the different coefficients, where the accelerations are known.
    pub(crate) coefficients: Function,
    /// Symbols of the second derivatives of the coordinates.
    pub(crate) accelerations: Vec<Expr>,
    /// Number of first-order states.
    pub(crate) states: usize,
    /// Places of the coefficients in the equations: row, column, and the part of the unknown that is the factor.
    pub(crate) terms: Vec<Term>,
    /// How they are eliminated.
    pub(crate) pattern: Pattern,
}

/// The linearised equations of a formulation.
pub(crate) struct Linearised {
    /// The equations.
    pub(crate) augmented: Augmented,
    /// Do implicit methods solve them in place of df/dx?
    pub(crate) sparse: bool,
    /// How a linearly implicit step of its own solves them.
    pub(crate) resolvent: Option<Resolvent>,
}

impl Linearised {
    /// The equations if they serve implicit methods, or a step that the user ordered.
    pub(crate) fn wanted(model: &Model, augmented: Augmented, sparse: bool) -> Option<Linearised> {
        let ordered = orders_step(model);
        let resolvent = ordered.then(|| Resolvent::new(&augmented));
        (sparse || ordered).then_some(Linearised { augmented, sparse, resolvent })
    }
}

/// `by_t`, the derivative of a rate by the time, which a linearly implicit step asks for; none where dual numbers take less:
/// a direction of theirs costs about what the rate does, and the rate comes with it.
pub(crate) fn by_time(rate: &Function, time: Expr) -> Option<Function> {
    let slope = |(place, value): &(Place, Expr)| match place {
        Place::Element("dx", k) => Some((Place::Element("by_t", *k), value.diff(time))),
        _ => None,
    };
    let slopes = rate.results.iter().filter_map(slope).filter(|(_, slope)| !slope.is_zero());
    let found = Function::of_results(slopes.collect()).optimise();
    (found.tape().count().total() < 2 * rate.tape().count().total()).then_some(found)
}

/// Does the user order a linearly implicit step?
pub(crate) fn orders_step(model: &Model) -> bool {
    model.steps.contains(&Step::LinearlyImplicit)
}

impl Augmented {
    /// Of coefficients, eliminated in an order; `sections` tells of the different ones what a person would write down first.
    pub(crate) fn new(
        terms: Terms,
        (accelerations, states): (Vec<Expr>, usize),
        order: &[usize],
        sections: impl FnOnce(&[Expr]) -> Vec<Section>,
    ) -> Augmented {
        let (different, terms) = placed(terms);
        let pattern = Pattern::new(order, terms.iter().map(|term| (term.row, term.column)));
        let results = stored("c", different.iter());
        let coefficients = Function { sections: sections(&different), results }.optimise();
        Augmented { coefficients, accelerations, states, terms, pattern }
    }

    /// Do these equations take fewer operations than the derivatives of the rate in dual numbers and the decomposition of
    /// the full matrix, where these take so many?
    pub(crate) fn is_cheaper(&self, by_dual_numbers: usize) -> bool {
        let pivots = &self.pattern.pivots;
        let products: usize = pivots.iter().map(|pivot| pivot.below.len() * (1 + pivot.right.len())).sum();
        let sparse = self.coefficients.tape().count().total() + products;
        let (n, k) = (self.accelerations.len(), self.states);
        sparse < by_dual_numbers + (n + k).pow(3) / 3
    }
}

/// Adds the derivatives of equations by coordinates, their rates and first-order states, whose columns are after those of
/// the coordinates.
pub(crate) fn add_slopes(terms: &mut Terms, equations: &[Expr], [q, v, x]: [&[Expr]; 3]) {
    let n = q.len();
    for (row, &equation) in equations.iter().enumerate() {
        for (symbols, part, first) in [(q, Part::Position, 0), (v, Part::Velocity, 0), (x, Part::Value, n)] {
            for (k, slope) in algebra::gradient(equation, symbols) {
                terms.insert((row, first + k, part), slope);
            }
        }
    }
}

/// Equal coefficients are computed once.
fn placed(terms: Terms) -> (Vec<Expr>, Vec<Term>) {
    let (mut different, mut places, mut placed) = (Vec::new(), SortedMap::new(), Vec::new());
    for ((row, column, part), value) in terms {
        if value.is_zero() {
            continue;
        }
        let coefficient = *places.or_insert(value, different.len());
        if coefficient == different.len() {
            different.push(value);
        }
        placed.push(Term { coefficient, row, column, part });
    }
    (different, placed)
}
