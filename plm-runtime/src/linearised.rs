//! A mechanism near a moment as a linear system, without a matrix of a size that is known when the program runs:
//! x' = A x + B u, y = C x + D u.

use crate::described::Described;
use crate::dual::Dual;
use crate::fault::{Cause, Fault};
use crate::linalg::Dense;
use crate::linear::Linear;
use crate::mechanism::{Mechanism, Moment};
use crate::ports::Ports;
use crate::scalar::{Real, Scalar};
use crate::system::{Rate, System};
use crate::vector::Vector;

/// A mechanism that can be linearised with all that is observed of it: generated ones can.
pub trait Linearisable: Described + Linear<Lifted<1>: Described> {}

impl<M: Described + Linear<Lifted<1>: Described>> Linearisable for M {}

/// The directions in which the state of a mechanism can go, and what changes along them.
///
/// With constraints the state is counted along orthonormal directions that they allow. Gaps that are closed and frictions that stick are
/// such constraints: the system is linearised in the present contact modes. Without any constraint the directions are those of the state,
/// [`Labels::name_of_state`](crate::Labels::name_of_state). Inputs and observed quantities are in SI.
pub struct Linearised<'a, M: Mechanism + Linear> {
    state: &'a M::State,
    /// Rows, of which the first `fixed` are those that constraints do not leave.
    rows: <M::X as Dense<M::S>>::Matrix,
    fixed: usize,
}

/// One of the matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Matrix {
    /// Rate by state.
    A = 0,
    /// Rate by inputs.
    B = 1,
    /// Observed quantities by state.
    C = 2,
    /// Observed quantities by inputs.
    D = 3,
    /// The directions in columns, in what is integrated.
    Basis = 4,
}

impl Matrix {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::A, Self::B, Self::C, Self::D, Self::Basis];
}

/// Variable of differentiation: a direction of the state, or an input.
#[derive(Clone, Copy)]
enum Along<X> {
    State(X),
    Input(usize),
}

type Lifted<M> = <M as Linear>::Lifted<1>;
type LiftedX<M> = <Lifted<M> as Rate>::X;

impl<'a, M: Linearisable> Linearised<'a, M> {
    /// The directions at a moment.
    ///
    /// # Errors
    /// [`Cause::Singular`] where accelerations are not determined without a decomposition by rank, or no chart of the loops is
    /// good.
    pub fn new(state: &'a M::State) -> Result<Self, Fault> {
        let (mechanism, held) = (state.mechanism(), state.held());
        let mut rate = *state.x();
        let is_good = mechanism.is_regular(&held)
            && mechanism.rate(state.time(), &held, state.x(), &mut rate).is_good();
        if !is_good {
            return Err(Fault::new(state.time().to_f64(), Cause::Singular { rows: M::X::LEN }));
        }
        let mut all = Self { state, rows: M::X::zeros(), fixed: 0 };
        let constraints = all.constraints(None, |_, _| {});
        for number in 0..constraints {
            let mut row = M::X::fill(M::S::ZERO);
            for column in 0..M::X::LEN {
                all.constraints(Some(column), |at, slope| {
                    if at == number {
                        row.set(column, slope);
                    }
                });
            }
            all.fixed += usize::from(all.fixed < M::X::LEN && all.take(all.fixed, row));
        }
        all.complete(constraints == 0);
        Ok(all)
    }

    /// How many directions there are.
    pub fn directions(&self) -> usize {
        M::X::LEN - self.fixed
    }

    /// Rows and columns of a matrix.
    pub fn shape(&self, matrix: Matrix) -> (usize, usize) {
        let (states, inputs) = (self.directions(), <M as Ports>::INPUTS.len());
        match matrix {
            Matrix::A => (states, states),
            Matrix::B => (states, inputs),
            Matrix::C => (M::OBSERVED.len(), states),
            Matrix::D => (M::OBSERVED.len(), inputs),
            Matrix::Basis => (M::X::LEN, states),
        }
    }

    /// Gives `each` the entries of a matrix with row and column, column by column.
    pub fn each(&self, matrix: Matrix, each: &mut impl FnMut(usize, usize, M::S)) {
        let (rows, columns) = self.shape(matrix);
        for column in 0..columns {
            let along = match matrix {
                Matrix::A | Matrix::C => Along::State(self.direction(column)),
                Matrix::B | Matrix::D => Along::Input(column),
                Matrix::Basis => {
                    let direction = self.direction(column);
                    for row in 0..rows {
                        each(row, column, direction.at(row));
                    }
                    continue;
                }
            };
            let (moment, slope) = self.change(along);
            if let Matrix::C | Matrix::D = matrix {
                let mut row = 0..rows;
                <Lifted<M>>::observe(&moment, 0..rows, &mut |number| {
                    let entry = number.map_or(M::S::ZERO, |number| number.tangents[0]);
                    row.next().into_iter().for_each(|row| each(row, column, entry));
                });
                continue;
            }
            for row in 0..rows {
                each(row, column, dot::<M>(&self.direction(row), &slope));
            }
        }
    }

    /// The change of everything along a way: the moment with its tangents, and that of the rate.
    fn change(&self, along: Along<M::X>) -> (<Lifted<M> as Mechanism>::State, M::X) {
        let (lifted, mut held) = self.state.mechanism().lift::<1>(&self.state.held());
        let mut x = LiftedX::<M>::from_fn(|i| Dual::constant(self.state.x().at(i)));
        match along {
            Along::State(direction) => {
                for i in 0..M::X::LEN {
                    x.set(i, Dual { value: x.at(i).value, tangents: [direction.at(i)] });
                }
            }
            Along::Input(index) => {
                if let Some(input) = <Lifted<M>>::input(<Lifted<M>>::inputs(&mut held), index) {
                    *input = Dual::variable(input.value, 0);
                }
            }
        }
        let (time, mut rate) = (Dual::constant(self.state.time()), x);
        lifted.rate(time, &held, &x, &mut rate);
        let slope = M::X::from_fn(|i| rate.at(i).tangents[0]);
        (<Lifted<M> as Mechanism>::State::new(lifted, held, time, x), slope)
    }

    /// Gives `each` the slope of every constraint by a component of the state, with its number; how many there are.
    fn constraints(&self, column: Option<usize>, mut each: impl FnMut(usize, M::S)) -> usize {
        let (lifted, held) = self.state.mechanism().lift::<1>(&self.state.held());
        let mut x = LiftedX::<M>::from_fn(|i| Dual::constant(self.state.x().at(i)));
        if let Some(column) = column {
            x.set(column, Dual::variable(x.at(column).value, 0));
        }
        let (mut count, time) = (0, Dual::constant(self.state.time()));
        let mut row = |residual: Dual<M::S, 1>| {
            each(count, residual.tangents[0]);
            count += 1;
        };
        lifted.constraints(time, &x, &mut row);
        lifted.held_rows(time, &held, &x, &mut row);
        count
    }

    fn row(&self, number: usize) -> M::X {
        M::X::from_fn(|i| M::X::entry(&self.rows, number, i))
    }

    fn direction(&self, number: usize) -> M::X {
        self.row(self.fixed + number)
    }

    fn put(&mut self, number: usize, row: &M::X) {
        for i in 0..M::X::LEN {
            M::X::set_entry(&mut self.rows, number, i, row.at(i));
        }
    }

    /// Component of a row that is orthogonal to the rows before `number`. It is orthogonalised twice, so that rounding leaves nothing along
    /// them (A. Björck, Numerical Methods for Least Squares Problems, 1996, 2.4.5).
    fn across(&self, number: usize, mut row: M::X) -> M::X {
        for other in (0..2).flat_map(|_| 0..number) {
            let other = self.row(other);
            row.add([(-dot::<M>(&row, &other), &other)]);
        }
        row
    }

    /// Takes a row as the one with this number, made orthonormal to those before; false where it depends on them.
    fn take(&mut self, number: usize, row: M::X) -> bool {
        let (rest, size) = (self.across(number, row), dot::<M>(&row, &row).sqrt());
        let left = dot::<M>(&rest, &rest).sqrt();
        // False for NaN.
        let counts = left > M::S::RANK_TOLERANCE * size;
        if counts {
            self.put(number, &rest.map(|entry| entry / left));
        }
        counts
    }

    /// The directions that are left: those of the state that lie the farthest across, one after the other.
    fn complete(&mut self, is_free: bool) {
        let unit = |k: usize| M::X::from_fn(|i| if i == k { M::S::lit(1.0) } else { M::S::ZERO });
        for number in self.fixed..M::X::LEN {
            if is_free {
                self.put(number, &unit(number));
                continue;
            }
            let along = |k: usize| {
                (0..number).fold(M::S::ZERO, |sum, row| {
                    let entry = M::X::entry(&self.rows, row, k);
                    entry.mul_add(entry, sum)
                })
            };
            let farthest = (1..M::X::LEN).fold((0, along(0)), |least, k| {
                let next = along(k);
                if next < least.1 { (k, next) } else { least }
            });
            let _ = self.take(number, unit(farthest.0));
        }
    }
}

fn dot<M: System>(one: &M::X, other: &M::X) -> M::S {
    (0..M::X::LEN).fold(M::S::ZERO, |sum, i| one.at(i).mul_add(other.at(i), sum))
}
