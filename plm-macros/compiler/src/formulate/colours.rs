//! Columns of df/dx that dual numbers differentiate in one direction.
//!
//! Columns that share no row can be: in each row at most one of them moves anything, so that its derivative is the one that
//! the column has by itself (A. R. Curtis, M. J. D. Powell, J. K. Reid, On the estimation of sparse Jacobian matrices, J.
//! Inst. Maths Applics 13, 1974). A row counts as holding a column if its value reads it at all, zero derivatives included:
//! then nothing that leads to the row sees two columns of a colour, and the derivatives have the same bits as one by one.
//!
//! Colours are given greedily, columns that share rows with most others first (T. F. Coleman, J. J. Moré, Estimation of
//! sparse Jacobian matrices and graph coloring problems, SIAM J. Numer. Anal. 20, 1983: the sequential algorithm with the
//! largest-first ordering).

use crate::collect::CollectVec;
use crate::sorted::sort_by_key;

use plm_cas::{Expr, Op, Tape};

use super::function::{Function, Place};

/// Which numbers of the state each row of a rate reads.
#[derive(Clone)]
pub(crate) struct Reads {
    /// Coordinates: the first rows say q' = v, and nobody differentiates them.
    freedom: usize,
    /// Numbers of the state.
    length: usize,
    /// Of each row a set of columns, one a bit.
    rows: Vec<u128>,
}

/// Colours of columns.
pub(crate) struct Colours {
    /// How many there are.
    pub(crate) count: usize,
    /// The colour of each column; none of one that no row reads.
    pub(crate) of_columns: Vec<Option<usize>>,
    /// The column that each row has in each colour, colour by colour.
    pub(crate) columns: Vec<Vec<Option<usize>>>,
}

impl Reads {
    /// Reads of `dx` among coordinates, their rates and first-order states; everything, where these are many: the full matrix is
    /// small wherever a method takes it.
    pub(crate) fn of(rate: &Function, state: [&[Expr]; 3]) -> Reads {
        let (freedom, state) = (state[0].len(), &state.concat());
        let length = state.len();
        if length > u128::BITS as usize {
            return Reads { freedom, length, rows: Vec::new() };
        }
        let tape = rate.tape();
        let sets = sets(&tape, state);
        let mut rows = vec![0; length];
        let results = &tape.outputs[tape.outputs.len() - rate.results.len()..];
        for ((place, _), at) in rate.results.iter().zip(results) {
            if let &Place::Element("dx", row) = place {
                rows[row] = sets[at.index()];
            }
        }
        Reads { freedom, length, rows }
    }

    /// Operations of the derivatives in dual numbers: a direction costs about what the rate does (measured: 9.2 rates for 10
    /// directions, 14 for 20).
    pub(crate) fn operations(&self, rate: &Function) -> usize {
        rate.tape().count().total() * self.colours().count.max(1) * 7 / 10
    }

    /// Union of both.
    pub(crate) fn joined(mut self, other: &Reads) -> Reads {
        self.rows.iter_mut().zip(&other.rows).for_each(|(row, other)| *row |= other);
        self
    }

    /// The colours.
    pub(crate) fn colours(&self) -> Colours {
        let lower = self.rows.get(self.freedom..).unwrap_or(&[]);
        let near = |column: usize| {
            if self.rows.is_empty() {
                return u128::MAX;
            }
            lower.iter().filter(|&&row| holds(row, column)).fold(0, |near, row| near | row)
        };
        let near: Vec<u128> = (0..self.length).map(near).collect_vec();
        let mut order = (0..self.length).filter(|&column| near[column] != 0).collect_vec();
        sort_by_key(&mut order, |&column| std::cmp::Reverse(near[column].count_ones()));
        let (mut of_columns, mut members) = (vec![None; self.length], Vec::<Vec<usize>>::new());
        for column in order {
            let is_free = |members: &Vec<usize>| {
                !self.rows.is_empty() && members.iter().all(|&other| !holds(near[column], other))
            };
            let colour = members.iter().position(is_free).unwrap_or(members.len());
            if colour == members.len() {
                members.push(Vec::new());
            }
            members[colour].push(column);
            of_columns[column] = Some(colour);
        }
        let columns = members.iter().map(|members| self.columns_of(members)).collect_vec();
        Colours { count: members.len(), of_columns, columns }
    }

    /// Which of some columns each row holds; none above.
    fn columns_of(&self, members: &[usize]) -> Vec<Option<usize>> {
        let of_row = |row: usize| {
            let set = self.rows.get(row).copied().unwrap_or_default();
            let held = |&column: &usize| self.rows.is_empty() || holds(set, column);
            members.iter().copied().find(held).filter(|_| row >= self.freedom)
        };
        (0..self.length).map(of_row).collect_vec()
    }
}

impl Colours {
    /// Does one direction serve more than one column, or a column need none?
    pub(crate) fn save(&self) -> bool {
        self.count < self.of_columns.len()
    }
}

/// Does a set hold a column?
fn holds(set: u128, column: usize) -> bool {
    (set >> column) & 1 == 1
}

/// Symbols of `state` that each instruction of a tape reads.
fn sets(tape: &Tape, state: &[Expr]) -> Vec<u128> {
    let mut sets: Vec<u128> = Vec::new();
    for instruction in &tape.ops {
        let set = match instruction.op {
            Op::Symbol(symbol) => {
                let column = state.iter().position(|&other| other == symbol);
                column.map_or(0, |column| 1 << column)
            }
            op => op.operands().fold(0, |set, operand| set | sets[operand.index()]),
        };
        sets.push(set);
    }
    sets
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reads(freedom: usize, rows: &[u128]) -> Reads {
        Reads { freedom, length: rows.len(), rows: rows.to_vec() }
    }

    /// Every row has in each colour the one column of it that it reads, and no entry is lost.
    fn is_right(reads: &Reads) -> usize {
        let Colours { count, of_columns, columns } = reads.colours();
        for (row, &set) in reads.rows.iter().enumerate().skip(reads.freedom) {
            for column in 0..reads.length {
                let colour = of_columns[column];
                if holds(set, column) {
                    assert_eq!(
                        colour.and_then(|colour| columns[colour][row]),
                        Some(column),
                        "{row}, {column}"
                    );
                }
            }
            let found = columns.iter().filter(|of_colour| of_colour[row].is_some()).count();
            assert_eq!(found, set.count_ones() as usize, "row {row}");
        }
        count
    }

    #[test]
    fn an_arrow_has_two_colours_and_a_full_matrix_all() {
        assert_eq!(is_right(&reads(0, &[0b00001, 0b00011, 0b00101, 0b01001, 0b10001])), 2);
        assert_eq!(is_right(&reads(0, &[0b111, 0b111, 0b111])), 3);
        assert!(!reads(0, &[0b111, 0b111, 0b111]).colours().save());
    }

    #[test]
    fn neither_the_upper_rows_nor_columns_of_zeros_take_a_direction() {
        // Two bodies on springs of their own, and a third one that falls.
        let two = reads(3, &[0b001_000, 0b010_000, 0b100_000, 0b001_001, 0b010_010, 0]);
        assert_eq!(is_right(&two), 2);
        assert_eq!(two.colours().of_columns[2], None);
        assert_eq!(two.colours().of_columns[5], None);
    }

    #[test]
    fn bands_have_as_many_colours_as_they_are_wide() {
        let rows: Vec<u128> = (0..20).map(|row: u32| ((0b111_u128 << row) >> 1) & ((1 << 20) - 1)).collect();
        assert_eq!(is_right(&reads(0, &rows)), 3);
    }

    #[test]
    fn what_is_not_known_is_full() {
        let Colours { count, columns, .. } = Reads { freedom: 40, length: 130, rows: Vec::new() }.colours();
        assert_eq!(count, 130);
        assert!(columns.iter().all(|rows| rows.iter().filter(|column| column.is_some()).count() == 90));
    }
}
