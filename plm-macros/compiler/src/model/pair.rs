//! Kinematic pairs, as a table.

use super::Pair;

/// Properties of a pair.
struct Kind {
    pair: Pair,
    name: &'static str,
    /// How many constraint rows hold it.
    rows: usize,
    /// Is the second frame free to move along the x axis of the first?
    slides: bool,
    /// Is the second frame free to turn?
    turns: bool,
    /// How it moves, in a sentence.
    says: &'static str,
}

const KINDS: [Kind; 4] = [
    Kind {
        pair: Pair::Revolute,
        name: "revolute",
        rows: 2,
        slides: false,
        turns: true,
        says: "the points of both frames coincide, and they turn freely",
    },
    Kind {
        pair: Pair::Prismatic,
        name: "prismatic",
        rows: 2,
        slides: true,
        turns: false,
        says: "the second frame slides along the x axis of the first, without turning",
    },
    Kind {
        pair: Pair::PinSlot,
        name: "pin_slot",
        rows: 1,
        slides: true,
        turns: true,
        says: "the point of the second frame is on the x axis of the first, and it turns freely",
    },
    Kind {
        pair: Pair::Weld,
        name: "weld",
        rows: 3,
        slides: false,
        turns: false,
        says: "both frames are the same",
    },
];

impl Pair {
    /// All pairs.
    pub const ALL: [Pair; 4] = [Pair::Revolute, Pair::Prismatic, Pair::PinSlot, Pair::Weld];

    /// The pair of a name in the language.
    pub fn named(name: &str) -> Option<Pair> {
        KINDS.iter().find(|kind| kind.name == name).map(|kind| kind.pair)
    }

    /// Its name in the language.
    pub fn name(self) -> &'static str {
        self.kind().name
    }

    /// How many constraint rows hold it.
    pub fn rows(self) -> usize {
        self.kind().rows
    }

    /// Is the second frame free to move along the x axis of the first?
    pub fn slides(self) -> bool {
        self.kind().slides
    }

    /// Is the second frame free to turn against the first?
    pub fn turns(self) -> bool {
        self.kind().turns
    }

    /// How it moves, in a sentence.
    pub fn says(self) -> &'static str {
        self.kind().says
    }

    const fn kind(self) -> &'static Kind {
        &KINDS[self as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::{KINDS, Pair};

    #[test]
    fn the_table_has_the_order_of_the_pairs() {
        assert_eq!(Pair::ALL.map(|pair| pair as usize), [0, 1, 2, 3]);
        assert!(Pair::ALL.iter().zip(&KINDS).all(|(pair, kind)| *pair == kind.pair));
    }

    #[test]
    fn rows_and_freedoms_of_a_pair_add_up_to_three() {
        for pair in Pair::ALL {
            assert_eq!(pair.rows() + usize::from(pair.slides()) + usize::from(pair.turns()), 3, "{pair:?}");
        }
    }
}
