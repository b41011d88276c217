//! Quantities that are read by name, and what they have in common.

use core::cell::{Cell, OnceCell};

/// A quantity of a state that was found by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Observed {
    /// Name as in the declaration, such as `arm.p12.velocity.x`.
    pub name: &'static str,
    /// Unit of its value; empty for a pure number.
    pub unit: &'static str,
    column: usize,
}

impl Observed {
    /// The quantities of these names in a table of (name, unit).
    ///
    /// # Errors
    /// The first name that is not in the table.
    pub fn find<'n, const K: usize>(
        table: &[(&'static str, &'static str)],
        names: [&'n str; K],
    ) -> Result<[Observed; K], &'n str> {
        let mut found = [Observed { name: "", unit: "", column: 0 }; K];
        for (slot, wanted) in found.iter_mut().zip(names) {
            let entry = table.iter().enumerate().find(|(_, (name, _))| *name == wanted);
            let (column, &(name, unit)) = entry.ok_or(wanted)?;
            *slot = Observed { name, unit, column };
        }
        Ok(found)
    }

    /// Its place in the table.
    pub fn column(&self) -> usize {
        self.column
    }
}

/// A value that is worked out by the first who asks for it. Unlike `OnceCell::get_or_init` it cannot panic.
#[derive(Debug)]
pub struct Once<T>(OnceCell<T>);

impl<T> Once<T> {
    /// Not known yet.
    #[must_use]
    pub const fn new() -> Self {
        Self(OnceCell::new())
    }

    /// The value; `make` works it out if it is not known yet.
    #[inline]
    pub fn get_or_init(&self, make: impl Fn() -> T) -> &T {
        loop {
            match self.0.get() {
                Some(value) => return value,
                // It is known in the next turn.
                None => drop(self.0.set(make())),
            }
        }
    }
}

impl<T> Default for Once<T> {
    fn default() -> Self {
        Self::new()
    }
}

/// Pose, accelerations and a vector, which outputs of a moment have in common: each is worked out by the first output that reads it.
///
/// `P` is pose and velocity of all bodies, `U` the discrete state with the forces of contact, `A` accelerations and multipliers, and `V` a
/// vector.
#[derive(Debug)]
pub struct Common<P, U, A, V: Copy> {
    /// Pose and velocity of all bodies.
    pub pose: Once<P>,
    /// The discrete state with the forces of contact.
    pub loaded: Once<U>,
    /// Accelerations and multipliers.
    pub solved: Once<A>,
    /// The vector that was read last, and the number of its first component.
    vector: Cell<Option<(usize, V)>>,
}

impl<P, U, A, V: Copy> Common<P, U, A, V> {
    /// Nothing is known yet.
    #[must_use]
    pub const fn new() -> Self {
        Self { pose: Once::new(), loaded: Once::new(), solved: Once::new(), vector: Cell::new(None) }
    }

    /// The vector whose first component has this number: the one that was read last, or a new one.
    #[inline]
    pub fn vector(&self, first: usize, make: impl FnOnce() -> V) -> V {
        match self.vector.get() {
            Some((known, vector)) if known == first => vector,
            _ => {
                let vector = make();
                self.vector.set(Some((first, vector)));
                vector
            }
        }
    }
}

impl<P, U, A, V: Copy> Default for Common<P, U, A, V> {
    fn default() -> Self {
        Self::new()
    }
}
