//! A mechanism near a state as a linear system: matrices, eigenvalues, damping, frequencies.

use std::fmt;

use nalgebra::{Complex, DMatrix};
use plm_runtime::linalg::Dense;
use plm_runtime::{
    AsMoment, Cause, Constraints, Dual, Fault, Labels, Linear, Mechanism, Moment, Ports, Rate, System,
};

use crate::analysis::control::eigenvalues;

/// A mechanism that can be linearised: generated ones can.
pub trait Linearisable: Mechanism + Ports + Linear<S = f64, Lifted<1>: Ports> + System<S = f64> {}

impl<M> Linearisable for M where M: Mechanism + Ports + Linear<S = f64, Lifted<1>: Ports> {}

/// x' = A x + B u, y = C x + D u for small changes of state x, inputs u and outputs y from those at a state.
///
/// With constraints the state is counted along the directions that they leave: the change of the coordinates,
/// velocities and first-order states is `basis * x`.
#[derive(Clone, Debug, PartialEq)]
pub struct Linearisation {
    /// Change of the rate by the state.
    pub a: DMatrix<f64>,
    /// Change of the rate by the inputs, in SI units.
    pub b: DMatrix<f64>,
    /// Change of the outputs, in their units, by the state.
    pub c: DMatrix<f64>,
    /// Change of the outputs, in their units, by the inputs.
    pub d: DMatrix<f64>,
    /// The directions of the state in columns, in coordinates, velocities and first-order states.
    pub basis: DMatrix<f64>,
    /// Names of the coordinates, velocities and first-order states, the rows of `basis`.
    pub states: Vec<&'static str>,
    /// Number of coordinates, the first ones of `states`.
    pub coordinates: usize,
    /// The state from which its changes count: a number for each row of `basis`.
    pub point: Vec<f64>,
    /// Names and units of the inputs, the columns of B and D.
    pub inputs: &'static [(&'static str, &'static str)],
    /// Names and units of the outputs, the rows of C and D.
    pub outputs: &'static [(&'static str, &'static str)],
}

/// One eigenvalue; oscillations have two, one the conjugate of the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// The eigenvalue lambda, 1/s.
    pub eigenvalue: Complex<f64>,
    /// Natural frequency |lambda|, rad/s.
    pub frequency: f64,
    /// Damping ratio -Re(lambda) / |lambda|: 1 or more does not oscillate, below 0 grows; 1 where lambda is zero.
    pub damping: f64,
}

impl Linearisation {
    /// The eigenvalues of A, slow ones first.
    pub fn modes(&self) -> Vec<Mode> {
        let mut modes: Vec<Mode> = eigenvalues(&self.a).into_iter().map(Mode::new).collect();
        modes.sort_by(|a, b| {
            let key = |mode: &Mode| (mode.frequency, mode.eigenvalue.im);
            let ((f, p), (g, q)) = (key(a), key(b));
            f.total_cmp(&g).then(p.total_cmp(&q))
        });
        modes
    }
}

/// Sizes, modes, and what goes in and comes out with its unit; the matrices are fields, and have a `Display` of their own.
impl fmt::Display for Linearisation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = self.a.nrows();
        writeln!(f, "{count} state{}", if count == 1 { "" } else { "s" })?;
        for (what, list) in [("input", self.inputs), ("output", self.outputs)] {
            for (name, unit) in list {
                writeln!(f, "{what} {name}, {unit}")?;
            }
        }
        for mode in self.modes().iter().filter(|mode| mode.eigenvalue.im >= 0.0) {
            writeln!(f, "{mode}")?;
        }
        Ok(())
    }
}

/// `-0.12 +- 3.4i 1/s: 3.402 rad/s, damping 0.0353`.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { eigenvalue, frequency, damping } = self;
        match eigenvalue.im {
            0.0 => write!(f, "{:.4e} 1/s", eigenvalue.re),
            im => write!(
                f,
                "{:.4e} +- {:.4e}i 1/s: {frequency:.4e} rad/s, damping {damping:.4}",
                eigenvalue.re,
                im.abs()
            ),
        }
    }
}

impl Mode {
    pub(crate) fn new(eigenvalue: Complex<f64>) -> Self {
        let frequency = eigenvalue.re.hypot(eigenvalue.im);
        let damping = if frequency > 0.0 { -eigenvalue.re / frequency } else { 1.0 };
        Self { eigenvalue, frequency, damping }
    }
}

/// Linearises a mechanism where a simulation is, or at a state of a run, exactly but for rounding: by running its equations
/// and outputs on dual numbers.
///
/// Modes mean what they usually mean where the state is an equilibrium. With friction and unilateral contact it is the system of the
/// modes held: gaps that are closed and frictions that stick are constraints, slips have the force of their friction.
///
/// # Errors
/// [`Cause::NotFinite`] where the state or a derivative is no number. [`Cause::Singular`] where the accelerations or their derivatives are not determined without a decomposition by rank, or
/// where no chart of the loops is good.
pub fn linearise<A, T>(of: &A) -> Result<Linearisation, Fault>
where
    A: AsMoment<State = T>,
    T: Moment<M: Linearisable<State = T>>,
{
    let Derivatives { a, b, c, d, constraints } = derivatives(of.as_moment())?;
    // Of a state that is no number there are neither directions nor modes.
    if [&a, &b, &c, &d, &constraints].iter().any(|all| all.iter().any(|entry| !entry.is_finite())) {
        return Err(Fault::new(of.as_moment().time(), Cause::NotFinite));
    }
    let basis = free_directions(&constraints);
    let transposed = basis.transpose();
    let (mechanism, held) = (of.as_moment().mechanism(), of.as_moment().held());
    let states = own(mechanism).into_iter().map(|place| mechanism.name_in_chart(&held, place)).collect();
    let x = of.as_moment().x();
    let point = own(mechanism).into_iter().map(|place| plm_runtime::Vector::at(x, place)).collect();
    Ok(Linearisation {
        a: &transposed * a * &basis,
        b: &transposed * b,
        c: c * &basis,
        d,
        basis,
        states,
        coordinates: own(mechanism).into_iter().filter(|place| *place < <T::M as Rate>::NQ).count(),
        point,
        inputs: of.as_moment().mechanism().input_names(),
        outputs: of.as_moment().mechanism().output_names(),
    })
}

/// Derivatives at a state in all its coordinates, velocities and first-order states.
pub struct Derivatives {
    /// Of the rates by the states.
    pub a: DMatrix<f64>,
    /// Of the rates by the inputs.
    pub b: DMatrix<f64>,
    /// Of the outputs, in their units, by the states.
    pub c: DMatrix<f64>,
    /// Of the outputs, in their units, by the inputs.
    pub d: DMatrix<f64>,
    /// Of what must vanish by the states.
    constraints: DMatrix<f64>,
}

/// The derivatives at a state.
///
/// # Errors
/// As [`linearise`].
pub fn derivatives<T>(state: &T) -> Result<Derivatives, Fault>
where
    T: Moment<M: Linearisable<State = T>>,
{
    let own = own(state.mechanism());
    let size = own.len();
    if !state.mechanism().is_regular(&state.held()) {
        return Err(Fault::new(state.time(), Cause::Singular { rows: size }));
    }
    let a = by_state(state, &own)?;
    let (inputs, outputs) = (state.mechanism().input_names().len(), state.mechanism().output_names().len());
    let (b, d) = (0..inputs)
        .map(|j| along(state, Direction::Input(j), &own))
        .fold((DMatrix::zeros(size, 0), DMatrix::zeros(outputs, 0)), |(b, d), change| {
            (append(b, &change.rate), append(d, &change.outputs))
        });
    let (c, rows) = own.iter().map(|j| along(state, Direction::State(*j), &own)).fold(
        (DMatrix::zeros(outputs, 0), None),
        |(c, rows), change| {
            let rows = rows.unwrap_or_else(|| DMatrix::zeros(change.constraints.len(), 0));
            (append(c, &change.outputs), Some(append(rows, &change.constraints)))
        },
    );
    Ok(Derivatives { a, b, c, d, constraints: rows.unwrap_or_else(|| DMatrix::zeros(0, size)) })
}

/// Places of the numbers that a state has.
fn own<M: Rate>(mechanism: &M) -> Vec<usize> {
    (0..<M::X as plm_runtime::Vector<M::S>>::LEN).filter(|place| mechanism.has_number(*place)).collect()
}

/// The derivatives of the rate by the state, whose numbers stand at these places.
fn by_state<T: Moment<M: Linearisable<State = T>>>(state: &T, own: &[usize]) -> Result<DMatrix<f64>, Fault> {
    type X<T> = <<T as Moment>::M as Rate>::X;
    let mut matrix = <X<T> as Dense<f64>>::zeros();
    let health = state.mechanism().jacobian(state.time(), &state.held(), state.x(), &mut matrix, None);
    if !health.is_good() {
        return Err(Fault::new(state.time(), Cause::Singular { rows: own.len() }));
    }
    Ok(DMatrix::from_fn(own.len(), own.len(), |i, j| <X<T> as Dense<f64>>::entry(&matrix, own[i], own[j])))
}

/// A state or an input that moves.
#[derive(Clone, Copy)]
enum Direction {
    State(usize),
    Input(usize),
}

/// Derivatives along one direction.
struct Change {
    rate: Vec<f64>,
    outputs: Vec<f64>,
    constraints: Vec<f64>,
}

fn along<T: Moment<M: Linearisable<State = T>>>(state: &T, direction: Direction, own: &[usize]) -> Change {
    type Lifted<T> = <<T as Moment>::M as Linear>::Lifted<1>;
    type Number = Dual<f64, 1>;
    let (lifted, mut held) = state.mechanism().lift::<1>(&state.held());
    let mut x = <<Lifted<T> as Rate>::X as plm_runtime::Vector<Number>>::from_fn(|i| {
        Dual::constant(plm_runtime::Vector::at(state.x(), i))
    });
    match direction {
        Direction::State(j) => {
            use plm_runtime::Vector;
            x.set(j, Dual::variable(x.at(j).value, 0));
        }
        Direction::Input(j) => {
            if let Some(input) = <Lifted<T>>::input(<Lifted<T>>::inputs(&mut held), j) {
                *input = Dual::variable(input.value, 0);
            }
        }
    }
    let time = Dual::constant(state.time());
    let tangent = |number: Number| number.tangents[0];
    let mut rate = x;
    lifted.rate(time, &held, &x, &mut rate);
    let rate = own.iter().map(|place| tangent(plm_runtime::Vector::at(&rate, *place))).collect();
    let mut constraints = Vec::new();
    let mut row = |number| constraints.push(tangent(number));
    lifted.constraints(time, &x, &mut row);
    lifted.held_rows(time, &held, &x, &mut row);
    let moment = <Lifted<T> as Mechanism>::State::new(lifted, held, time, x);
    let mut outputs = Vec::new();
    <Lifted<T> as Ports>::outputs(&moment, &mut |number| outputs.push(tangent(number)));
    Change { rate, outputs, constraints }
}

/// A matrix with one more column.
fn append(matrix: DMatrix<f64>, column: &[f64]) -> DMatrix<f64> {
    let last = matrix.ncols();
    let mut matrix = matrix.insert_column(last, 0.0);
    matrix.column_mut(last).copy_from_slice(column);
    matrix
}

/// Orthonormal directions along which no row changes; the identity if there is no row.
fn free_directions(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let size = rows.ncols();
    if rows.nrows() == 0 {
        return DMatrix::identity(size, size);
    }
    // Singular vectors of the square of the rows belong to all directions, not only to as many as there are rows.
    let square = rows.transpose() * rows;
    // Squares beyond the range of numbers have no decomposition: nothing is known to be free.
    if !square.iter().all(|entry| entry.is_finite()) {
        return DMatrix::zeros(size, 0);
    }
    let decomposed = square.symmetric_eigen();
    let largest = decomposed.eigenvalues.amax();
    let free = (0..size).filter(|i| decomposed.eigenvalues[*i].abs() <= RANK_TOLERANCE * largest);
    let columns: Vec<_> = free.map(|i| decomposed.eigenvectors.column(i)).collect();
    if columns.is_empty() { DMatrix::zeros(size, 0) } else { DMatrix::from_columns(&columns) }
}

/// Squares of singular values below this fraction of the largest count as zero.
const RANK_TOLERANCE: f64 = 1e-12;
