//! Vectors from iterators, with less code than `collect`.
//!
//! Whoever uses plm builds this crate without optimisation. There `collect` costs some 350 lines of LLVM's code for each
//! iterator, five times the loop, since it asks for lengths and has ways of its own for iterators of many kinds.

/// Iterators whose items are wanted in a vector.
pub(crate) trait CollectVec: Iterator + Sized {
    /// All items, in their order.
    fn collect_vec(self) -> Vec<Self::Item> {
        let mut items = Vec::new();
        for item in self {
            items.push(item);
        }
        items
    }
}

impl<I: Iterator> CollectVec for I {}
