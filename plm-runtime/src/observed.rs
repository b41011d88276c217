//! Quantities that are read by name.

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
