//! Residuals of static equilibrium as vectors and matrices, with their exact derivatives.

use nalgebra::{DMatrix, DVector};
use plm_runtime::{Dual, Fault, Linear, Moment, Statics, Vector};

use super::{Stabilise, contact};

/// A pose at rest with first-order states and multipliers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Point {
    /// Coordinates, m and rad.
    pub(super) q: DVector<f64>,
    /// First-order states.
    pub(super) x: DVector<f64>,
    /// Multipliers, by constraint row, then by row of contact that holds.
    pub(super) lambda: DVector<f64>,
}

/// Residuals, or their derivatives.
#[derive(Clone, Debug)]
pub(super) struct Rows<T> {
    /// phi_q^T lambda - Q, by coordinate.
    pub(super) force: T,
    /// phi, by row.
    pub(super) phi: T,
    /// phi_q v - nu, by row.
    pub(super) phi_dot: T,
    /// Rates of first-order states.
    pub(super) rate: T,
}

/// When an equilibrium is looked for, and with which inputs.
#[derive(Clone, Copy)]
pub(super) struct Setting<M: Statics> {
    /// s.
    pub(super) time: f64,
    /// Inputs; `None` takes those of the declaration.
    pub(super) inputs: Option<M::U>,
}

impl<M: Statics<S = f64>> Setting<M> {
    /// The assembled start of a mechanism.
    pub(super) fn start(&self, mechanism: M) -> Result<M::State, Fault> {
        let (held, x) = match &self.inputs {
            Some(inputs) => mechanism.start_with_inputs(self.time, inputs)?,
            None => mechanism.start_state(self.time)?,
        };
        Ok(M::State::new(mechanism, held, self.time, x))
    }
}

/// The residuals of a mechanism at a time, with its discrete state.
pub(super) struct Residuals<M: Stabilise> {
    mechanism: M,
    time: f64,
    held: M::U,
    /// Rows of contact that hold: they are constraints beside those of the joints.
    pub(super) holding: Vec<Holding>,
}

/// A row of contact that holds, and the displacement that it keeps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Holding {
    pub(super) row: usize,
    pub(super) place: f64,
}

type Lifted<M> = <M as Linear>::Lifted<1>;

impl<M: Stabilise> Residuals<M> {
    /// Number of coordinates.
    pub(super) fn nq(&self) -> usize {
        self.mechanism.coordinate_names().len()
    }

    /// Number of constraint rows of the joints.
    pub(super) fn own(&self) -> usize {
        self.mechanism.row_names().len()
    }

    /// Number of first-order states.
    pub(super) fn nx(&self) -> usize {
        self.mechanism.state_names().len()
    }

    /// The assembled start. Gaps that are released do not hold.
    pub(super) fn at_start(
        mechanism: M,
        setting: &Setting<M>,
        released: &[usize],
    ) -> Result<(Self, Point), Fault> {
        let start = setting.start(mechanism)?;
        let full = M::full(&start);
        let mut residuals = Self { mechanism, time: setting.time, held: start.held(), holding: Vec::new() };
        let (nq, nx) = (residuals.nq(), residuals.nx());
        let q = DVector::from_fn(nq, |i, _| full.at(i));
        let x = DVector::from_fn(nx, |i, _| full.at(2 * nq + i));
        let mut point = Point { q, x, lambda: DVector::zeros(residuals.own()) };
        residuals.holding = contact::holding(&residuals, &point, released);
        point.lambda = DVector::zeros(residuals.nc());
        Ok((residuals, point))
    }

    /// Rows whose multipliers are unknown.
    pub(super) fn nc(&self) -> usize {
        self.own() + self.holding.len()
    }

    /// Discrete state.
    pub(super) fn held(&self) -> &M::U {
        &self.held
    }

    /// Displacements of all rows of contact at a point, and the greatest force of each to either side.
    pub(super) fn of_contact(&self, point: &Point) -> (Vec<f64>, Vec<[f64; 2]>) {
        let mut gaps = self.values(point, |_| 0.0).split_off(self.nq() + 2 * self.own() + self.nx());
        let limits = gaps.split_off(self.mechanism.contact_count());
        (gaps, limits.as_chunks().0.to_vec())
    }

    pub(super) fn mechanism(&self) -> &M {
        &self.mechanism
    }

    /// The mechanism with its start at a point.
    pub(super) fn started_at(&self, point: &Point) -> M {
        let full: M::Full = Vector::from_fn(|i| self.entry(point, i, |_| 0.0));
        let mut mechanism = self.mechanism;
        *mechanism.starts_mut() = mechanism.starts_at(&full);
        mechanism
    }

    /// The residuals at rest.
    pub(super) fn rows(&self, point: &Point) -> Rows<DVector<f64>> {
        self.moving(point, |_| 0.0)
    }

    /// The residuals with velocities.
    pub(super) fn moving(&self, point: &Point, v: impl Fn(usize) -> f64) -> Rows<DVector<f64>> {
        let all = DVector::from_vec(self.values(point, v));
        let mut rows = self.split(|from, count| all.rows(from, count).into_owned());
        let own = self.nq() + 2 * self.own() + self.nx();
        rows.phi = rows.phi.resize_vertically(self.nc(), 0.0);
        rows.phi_dot = rows.phi_dot.resize_vertically(self.nc(), 0.0);
        for (k, Holding { row, place }) in self.holding.iter().enumerate() {
            rows.phi[self.own() + k] = entry(&all, own + row) - place;
        }
        rows
    }

    /// Residuals at a point, then displacements and limits of the rows of contact.
    fn values(&self, point: &Point, v: impl Fn(usize) -> f64) -> Vec<f64> {
        let full = Vector::from_fn(|i| self.entry(point, i, &v));
        let lambda = Vector::from_fn(|i| entry(&point.lambda, i));
        let mut held = self.held;
        for (k, of) in self.holding.iter().enumerate() {
            if let Some(own) = M::multipliers(&mut held).get_mut(of.row) {
                *own = entry(&point.lambda, self.own() + k);
            }
        }
        let mut values = Vec::new();
        self.mechanism.equations(self.time, &held, &full, &lambda, &mut |value| values.push(value));
        values
    }

    /// Derivatives by the coordinates.
    pub(super) fn by_q(&self, point: &Point) -> Rows<DMatrix<f64>> {
        self.derivatives(point, self.nq(), |k| (Some(k), None))
    }

    /// Derivatives by the first-order states.
    pub(super) fn by_x(&self, point: &Point) -> Rows<DMatrix<f64>> {
        self.derivatives(point, self.nx(), |k| (Some(2 * self.nq() + k), None))
    }

    /// Derivatives by the multipliers.
    pub(super) fn by_lambda(&self, point: &Point) -> Rows<DMatrix<f64>> {
        self.derivatives(point, self.nc(), |k| (None, Some(k)))
    }

    /// Derivatives by numbers of the state or of the multipliers, a column each.
    fn derivatives(
        &self,
        point: &Point,
        count: usize,
        variable: impl Fn(usize) -> (Option<usize>, Option<usize>),
    ) -> Rows<DMatrix<f64>> {
        type Number = Dual<f64, 1>;
        let (lifted, held) = self.mechanism.lift::<1>(&self.held);
        let dual = |value: f64, moves: bool| Number { value, tangents: [if moves { 1.0 } else { 0.0 }] };
        let contacts = 3 * self.mechanism.contact_count();
        let mut all = DMatrix::zeros(self.nq() + 2 * self.own() + self.nx() + contacts, count);
        for k in 0..count {
            let (state, row) = variable(k);
            let mut held = held;
            for (k, of) in self.holding.iter().enumerate() {
                if let Some(own) = <Lifted<M> as Statics>::multipliers(&mut held).get_mut(of.row) {
                    *own = dual(entry(&point.lambda, self.own() + k), row == Some(self.own() + k));
                }
            }
            let full = Vector::from_fn(|i| dual(self.entry(point, i, |_| 0.0), state == Some(i)));
            let lambda = Vector::from_fn(|i| dual(entry(&point.lambda, i), row == Some(i)));
            let mut i = 0;
            <Lifted<M> as Statics>::equations(
                &lifted,
                Dual::constant(self.time),
                &held,
                &full,
                &lambda,
                &mut |number: Number| {
                    if let Some(entry) = all.get_mut((i, k)) {
                        *entry = number.tangents[0];
                    }
                    i += 1;
                },
            );
        }
        let mut rows = self.split(|from, count| all.rows(from, count).into_owned());
        let own = self.nq() + 2 * self.own() + self.nx();
        rows.phi = rows.phi.resize_vertically(self.nc(), 0.0);
        rows.phi_dot = rows.phi_dot.resize_vertically(self.nc(), 0.0);
        for (k, of) in self.holding.iter().enumerate() {
            rows.phi.row_mut(self.own() + k).copy_from(&all.row(own + of.row));
        }
        rows
    }

    fn split<T>(&self, part: impl Fn(usize, usize) -> T) -> Rows<T> {
        let (nq, nc, nx) = (self.nq(), self.own(), self.nx());
        Rows {
            force: part(0, nq),
            phi: part(nq, nc),
            phi_dot: part(nq + nc, nc),
            rate: part(nq + 2 * nc, nx),
        }
    }

    /// Entry of a state in absolute coordinates.
    fn entry(&self, point: &Point, i: usize, v: impl Fn(usize) -> f64) -> f64 {
        let nq = self.nq();
        match i {
            _ if i < nq => entry(&point.q, i),
            _ if i < 2 * nq => v(i - nq),
            _ => entry(&point.x, i - 2 * nq),
        }
    }
}

fn entry(vector: &DVector<f64>, i: usize) -> f64 {
    vector.get(i).copied().unwrap_or(0.0)
}
