//! Functions of sides as diagrams: each is the number of a node that asks one side, and those that follow ask later ones.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use crate::model::Decisions;

/// The function that holds never.
pub(super) const FALSE: usize = 0;
/// The function that holds always.
pub(super) const TRUE: usize = 1;
/// More nodes than this are too many.
const MOST: usize = 2000;

/// All functions so far; the same function has the same number.
pub(super) struct Diagram {
    /// The side that is asked, what holds where its condition does, and where it does not; from number 2 on.
    nodes: Vec<(usize, usize, usize)>,
    numbers: SortedMap<(usize, usize, usize), usize>,
    chosen: SortedMap<(usize, usize, usize), usize>,
}

impl Diagram {
    pub(super) fn new() -> Self {
        Self { nodes: Vec::new(), numbers: SortedMap::new(), chosen: SortedMap::new() }
    }

    /// Its functions are worth nothing then.
    pub(super) fn is_too_large(&self) -> bool {
        self.nodes.len() > MOST
    }

    /// The condition with this number holds.
    pub(super) fn side(&mut self, side: usize) -> usize {
        self.node(side, TRUE, FALSE)
    }

    /// `yes` where the condition of a side holds, else `no`.
    pub(super) fn choice(&mut self, side: usize, yes: usize, no: usize) -> usize {
        let holds = self.side(side);
        self.chosen(holds, yes, no)
    }

    pub(super) fn and(&mut self, a: usize, b: usize) -> usize {
        self.chosen(a, b, FALSE)
    }

    pub(super) fn or(&mut self, a: usize, b: usize) -> usize {
        self.chosen(a, TRUE, b)
    }

    pub(super) fn not(&mut self, a: usize) -> usize {
        self.chosen(a, FALSE, TRUE)
    }

    /// Holds where a function does on either side of a condition.
    pub(super) fn without(&mut self, of: usize, side: usize) -> usize {
        let mut known = SortedMap::new();
        self.either(of, side, &mut known)
    }

    fn either(&mut self, of: usize, side: usize, known: &mut SortedMap<usize, usize>) -> usize {
        let Some((asked, yes, no)) = self.asks(of).filter(|(asked, ..)| *asked <= side) else { return of };
        if asked == side {
            return self.or(yes, no);
        }
        if let Some(found) = known.get(&of) {
            return *found;
        }
        let (yes, no) = (self.either(yes, side, known), self.either(no, side, known));
        let found = self.choice(asked, yes, no);
        known.insert(of, found);
        found
    }

    /// The node of a function that is not the same everywhere.
    fn asks(&self, of: usize) -> Option<(usize, usize, usize)> {
        self.nodes.get(of.checked_sub(2)?).copied()
    }

    fn node(&mut self, side: usize, yes: usize, no: usize) -> usize {
        if yes == no {
            return yes;
        }
        if let Some(number) = self.numbers.get(&(side, yes, no)) {
            return *number;
        }
        self.nodes.push((side, yes, no));
        let number = self.nodes.len() + 1;
        self.numbers.insert((side, yes, no), number);
        number
    }

    /// `yes` where `of` holds, else `no`: Bryant's algorithm, which goes no deeper than there are sides.
    fn chosen(&mut self, of: usize, yes: usize, no: usize) -> usize {
        if of == TRUE || yes == no {
            return yes;
        }
        if of == FALSE {
            return no;
        }
        if self.is_too_large() {
            return TRUE;
        }
        if let Some(known) = self.chosen.get(&(of, yes, no)) {
            return *known;
        }
        let all = [of, yes, no];
        let first = all.iter().filter_map(|&one| self.asks(one)).map(|(side, ..)| side).min().unwrap_or(0);
        let part = |diagram: &Self, one: usize, holds: bool| match diagram.asks(one) {
            Some((side, yes, no)) if side == first => {
                if holds {
                    yes
                } else {
                    no
                }
            }
            _ => one,
        };
        let [on_yes, on_no] = [true, false].map(|holds| {
            let [of, yes, no] = all.map(|one| part(self, one, holds));
            self.chosen(of, yes, no)
        });
        let found = self.node(first, on_yes, on_no);
        self.chosen.insert((of, yes, no), found);
        found
    }

    /// The nodes that some functions need, with new numbers.
    pub(super) fn reduced(&self, mut roots: Vec<usize>) -> Decisions {
        let mut needed = vec![false; self.nodes.len() + 2];
        let mut open = roots.clone();
        while let Some(number) = open.pop() {
            if let (false, Some((_, yes, no))) = (needed[number], self.asks(number)) {
                needed[number] = true;
                open.push(yes);
                open.push(no);
            }
        }
        let kept = (2..needed.len()).filter(|number| needed[*number]).collect_vec();
        let renumbered = |number: usize| kept.binary_search(&number).map_or(number, |place| place + 2);
        let nodes = kept.iter().filter_map(|number| self.asks(*number));
        let nodes = nodes.map(|(side, yes, no)| (side, renumbered(yes), renumbered(no))).collect_vec();
        for root in &mut roots {
            *root = renumbered(*root);
        }
        Decisions { nodes, roots }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Does a function hold where the condition of each side is as `sides` says?
    fn holds(diagram: &Diagram, mut of: usize, sides: &[bool]) -> bool {
        while let Some((side, yes, no)) = diagram.asks(of) {
            of = if sides[side] { yes } else { no };
        }
        of == TRUE
    }

    #[test]
    fn functions_hold_where_their_tables_say() {
        let mut diagram = Diagram::new();
        // Each with its table over four sides, one bit a row.
        let rows = |f: fn(&[bool]) -> bool| {
            (0..16_u32).filter(|row| f(&bits(*row))).fold(0_u32, |table, row| table | 1 << row)
        };
        let mut known = (0..4)
            .map(|k| (diagram.side(k), [rows(|s| s[0]), rows(|s| s[1]), rows(|s| s[2]), rows(|s| s[3])][k]));
        let mut known: Vec<(usize, u32)> = known.by_ref().collect();
        let mut seed = 20_261_124_u64;
        let mut next = |below: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as usize % below
        };
        for _ in 0..300 {
            let (a, b, side) = (known[next(known.len())], known[next(known.len())], next(4));
            let mask = [0xAAAA_u32, 0xCCCC, 0xF0F0, 0xFF00][side];
            let shift = 1_u32 << side;
            let (on, off) = (a.1 & mask, a.1 & !mask);
            known.push(match next(5) {
                0 => (diagram.and(a.0, b.0), a.1 & b.1),
                1 => (diagram.or(a.0, b.0), a.1 | b.1),
                2 => (diagram.not(a.0), !a.1 & 0xFFFF),
                3 => (diagram.without(a.0, side), (on | on >> shift | off | off << shift) & 0xFFFF),
                _ => (diagram.choice(side, a.0, b.0), a.1 & mask | b.1 & !mask),
            });
        }
        for (of, table) in known {
            for row in 0..16 {
                assert_eq!(holds(&diagram, of, &bits(row)), table >> row & 1 == 1, "{of} {table:x} {row}");
            }
            // The same function has the same number.
            assert_eq!(table == 0xFFFF, of == TRUE);
            assert_eq!(table == 0, of == FALSE);
        }
    }

    fn bits(row: u32) -> [bool; 4] {
        [0, 1, 2, 3].map(|side| row >> side & 1 == 1)
    }
}
