//! A function of the program: what it computes, in which order, and where the results go.

use crate::collect::CollectVec;
use plm_cas::{Expr, Tape, algebra};

use super::rows::OfRows;

/// Destination of a result.
#[derive(Clone, PartialEq, Eq)]
pub(crate) enum Place {
    /// An element of an array, `dx[3]`.
    Element(&'static str, usize),
    /// An entry of a matrix, `by_x[3][1]`.
    Entry(&'static str, usize, usize),
    /// A number within a structure, `memory.turns[0].cos`.
    Path(String),
    /// A number of the rows of contact, `rows.gap[0]`.
    Rows(OfRows),
    /// The value that the function returns.
    Value,
}

/// A group of expressions that belong together under a title.
#[derive(Clone)]
pub(crate) struct Section {
    /// Title of the computation, for readers.
    pub(crate) title: String,
    /// The expressions, in the order in which they should be computed.
    pub(crate) roots: Vec<Expr>,
}

impl Section {
    pub(crate) fn new(title: &str, roots: Vec<Expr>) -> Section {
        Section { title: title.to_owned(), roots }
    }
}

/// A straight-line function.
#[derive(Clone, Default)]
pub(crate) struct Function {
    /// Order of computation; every expression here is needed by a result.
    pub(crate) sections: Vec<Section>,
    /// Results.
    pub(crate) results: Vec<(Place, Expr)>,
}

impl Function {
    /// A function of results alone, computed in their order.
    pub(crate) fn of_results(results: Vec<(Place, Expr)>) -> Function {
        Function { sections: Vec::new(), results }
    }

    /// A function that returns one value.
    pub(crate) fn of_value(value: Expr) -> Function {
        Function::of_results(vec![(Place::Value, value)])
    }

    /// A function that fills one array.
    pub(crate) fn of_array(array: &'static str, values: &[Expr]) -> Function {
        Function::of_results(stored(array, values.iter()))
    }

    /// Shares common sub-expressions within the function.
    pub(crate) fn optimise(self) -> Function {
        let roots = self.roots();
        let shared = algebra::shared(&roots);
        self.with_roots(shared)
    }

    /// With the second of each pair in the place of the first.
    pub(crate) fn substitute(self, pairs: &[(Expr, Expr)]) -> Function {
        if pairs.is_empty() {
            return self;
        }
        let substituted = algebra::substitute(&self.roots(), pairs);
        self.with_roots(substituted)
    }

    /// With other expressions in the places of [`Function::roots`], in their order.
    fn with_roots(mut self, roots: Vec<Expr>) -> Function {
        let places = self.sections.iter_mut().flat_map(|section| section.roots.iter_mut());
        let places = places.chain(self.results.iter_mut().map(|(_, value)| value));
        places.zip(roots).for_each(|(place, root)| *place = root);
        self
    }

    /// All expressions: those of the sections, then the results.
    pub(crate) fn roots(&self) -> Vec<Expr> {
        let of_sections = self.sections.iter().flat_map(|section| section.roots.iter().copied());
        of_sections.chain(self.results.iter().map(|&(_, value)| value)).collect_vec()
    }

    /// The results without their places.
    pub(crate) fn values(&self) -> Vec<Expr> {
        self.results.iter().map(|&(_, value)| value).collect_vec()
    }

    /// The function as a list of instructions.
    pub(crate) fn tape(&self) -> Tape {
        algebra::tape(&self.roots())
    }
}

/// Results that fill an array from its beginning.
pub(crate) fn stored<'a>(array: &'static str, values: impl Iterator<Item = &'a Expr>) -> Vec<(Place, Expr)> {
    values.enumerate().map(|(k, &value)| (Place::Element(array, k), value)).collect_vec()
}
