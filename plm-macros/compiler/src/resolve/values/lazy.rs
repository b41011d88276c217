//! Values that are worked out at their first use.

use crate::resolve::Resolver;
use crate::resolve::values::{Eval, Failed};

/// Something that is worked out at its first use.
#[derive(Clone, Copy, Default)]
pub(crate) enum Lazy<T> {
    #[default]
    Waiting,
    /// Being worked out: who asks for it now goes round in a circle.
    Busy,
    Known(T),
    Failed,
}

impl Resolver<'_> {
    /// The value that belongs in a place: what is known of it, or else what `work` gives. If the work needs its own result,
    /// `circle` tells so.
    pub(crate) fn lazy<T: Clone>(
        &mut self,
        place: impl Fn(&mut Self) -> &mut Lazy<T>,
        circle: impl FnOnce(&mut Self),
        work: impl FnOnce(&mut Self) -> Eval<T>,
    ) -> Eval<T> {
        match place(self) {
            Lazy::Known(value) => return Ok(value.clone()),
            Lazy::Failed => return Err(Failed),
            busy @ Lazy::Busy => {
                *busy = Lazy::Failed;
                circle(self);
                return Err(Failed);
            }
            waiting @ Lazy::Waiting => *waiting = Lazy::Busy,
        }
        let value = work(self);
        *place(self) = value.clone().map_or(Lazy::Failed, Lazy::Known);
        value
    }
}
