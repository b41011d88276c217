//! Linearised equations of motion, and what they are for.

use super::reduced::Augmented;
use super::resolvent::Resolvent;
use crate::model::{Model, Step};

/// The linearised equations of a formulation.
#[derive(Debug)]
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

/// Does the user order a linearly implicit step?
pub(crate) fn orders_step(model: &Model) -> bool {
    model.steps.contains(&Step::LinearlyImplicit)
}

impl Augmented {
    /// Do these equations take fewer operations than the derivatives of the rate in dual numbers and the decomposition of
    /// the full matrix, where `rate` is the number of operations of the rate?
    pub(crate) fn is_cheaper(&self, rate: usize) -> bool {
        let pivots = &self.pattern.pivots;
        let products: usize = pivots.iter().map(|pivot| pivot.below.len() * (1 + pivot.right.len())).sum();
        let sparse = self.coefficients.tape().count().total() + products;
        let (n, k) = (self.accelerations.len(), self.states);
        // A direction of dual numbers costs about what the rate does (measured: 9.2 rates for 10 states, 14 for 20).
        let full = rate * (2 * n + k) * 7 / 10 + (n + k).pow(3) / 3;
        sparse < full
    }
}
