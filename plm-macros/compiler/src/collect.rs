//! Vectors and arrays from iterators and arrays, with less code than the standard library has for it.
//!
//! Whoever uses plm builds this crate without optimisation. There `collect` costs some 350 lines of LLVM's code for each
//! iterator, and `extend` 250, since they ask for lengths and have ways of their own for iterators of many kinds.

/// Iterators whose items are wanted in a vector.
pub(crate) trait CollectVec: Iterator + Sized {
    /// All items, in their order.
    fn collect_vec(mut self) -> Vec<Self::Item> {
        let mut items = Vec::new();
        fill(&mut items, &mut self);
        items
    }
}

impl<I: Iterator> CollectVec for I {}

/// Vectors that take over what an iterator gives.
pub(crate) trait PushAll<T> {
    /// All items after those that are there.
    fn push_all(&mut self, items: impl IntoIterator<Item = T>);
}

impl<T> PushAll<T> for Vec<T> {
    fn push_all(&mut self, items: impl IntoIterator<Item = T>) {
        fill(self, &mut items.into_iter());
    }
}

/// The loop, which is there once for each type of items and not for each iterator.
fn fill<T>(items: &mut Vec<T>, source: &mut dyn Source<T>) {
    while let Some(item) = source.give() {
        items.push(item);
    }
}

/// An iterator, of whose many functions a table would have to hold each.
trait Source<T> {
    fn give(&mut self) -> Option<T>;
}

impl<I: Iterator> Source<I::Item> for I {
    fn give(&mut self) -> Option<I::Item> {
        self.next()
    }
}

/// Short arrays, entry by entry.
pub(crate) trait MapEach<T, const N: usize> {
    /// As `map`, with a tenth of its code.
    fn map_each<U>(self, change: impl FnMut(T) -> U) -> [U; N];
}

macro_rules! map_each {
    ($($count:literal: $($entry:ident)*;)*) => {$(
        impl<T> MapEach<T, $count> for [T; $count] {
            fn map_each<U>(self, mut change: impl FnMut(T) -> U) -> [U; $count] {
                let [$($entry),*] = self;
                [$(change($entry)),*]
            }
        }
    )*};
}

map_each! {
    2: a b;
    3: a b c;
    4: a b c d;
    5: a b c d e;
    6: a b c d e f;
}
