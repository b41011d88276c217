//! Names of joints and bodies in a fault, of fixed size.

use core::fmt;

/// A few names out of a table, and how many more there are.
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Names {
    table: &'static [&'static str],
    listed: [u16; Names::CAPACITY],
    len: u16,
}

impl Names {
    /// How many names are stored; the others are only counted.
    pub const CAPACITY: usize = 8;

    /// The names of the table that are marked, each once.
    pub fn marked(table: &'static [&'static str], marks: &[bool]) -> Self {
        let mut names = Self { table, listed: [0; Self::CAPACITY], len: 0 };
        for (i, (name, _)) in table.iter().zip(marks).enumerate().filter(|(_, (_, mark))| **mark) {
            if !names.iter().any(|listed| listed == *name) {
                names.push(i as u16);
            }
        }
        names
    }

    fn push(&mut self, index: u16) {
        if let Some(place) = self.listed.get_mut(usize::from(self.len)) {
            *place = index;
        }
        self.len = self.len.saturating_add(1);
    }

    /// The stored names, in the order of the declaration.
    pub fn iter(&self) -> impl Iterator<Item = &'static str> {
        let listed = self.listed.into_iter().take(usize::from(self.len));
        listed.filter_map(|i| self.table.get(usize::from(i)).copied())
    }

    /// As locks of the rates of the coordinates that were named: `arm.vx (locked), arm.omega (locked)`.
    pub(super) fn write_rates(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, name) in self.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            let (body, coordinate) = name.rsplit_once('.').unwrap_or(("", name));
            let rate = match coordinate {
                "x" => "vx",
                "y" => "vy",
                "angle" => "omega",
                other => other,
            };
            write!(f, "{comma}{body}.{rate} (locked)")?;
        }
        self.write_unlisted(f)
    }

    fn write_unlisted(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.unlisted() {
            0 => Ok(()),
            more => write!(f, " and {more} more"),
        }
    }

    /// How many names were given that were not stored.
    pub fn unlisted(&self) -> usize {
        usize::from(self.len).saturating_sub(Self::CAPACITY)
    }

    /// No name at all.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }
}

impl fmt::Debug for Names {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Names({self})")
    }
}

impl fmt::Display for Names {
    /// `shoulder.x, elbow.y`; with `#`, as locks: `arm.x (locked), arm.y (locked)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lock = if f.alternate() { " (locked)" } else { "" };
        for (i, name) in self.iter().enumerate() {
            let comma = if i == 0 { "" } else { ", " };
            write!(f, "{comma}{name}{lock}")?;
        }
        self.write_unlisted(f)
    }
}
