//! The equations of motion in the order in which textbooks write them, for whoever reads them: not what is computed.
//!
//! ```text
//! sum of M_ij u_j'' + sum of C_ijk u_j' u_k' + G_i = Q_i - sum over rows of (d phi_k/d u_i) lambda_k,    phi_k(u, t) = 0
//! ```
//!
//! in the coordinates `u` of a spanning tree of the joints, with `M_ij = sum over bodies of m J_i . J_j + I w_i w_j` (T. R. Kane, D. A.
//! Levinson, Dynamics: Theory and Applications, 1985, chapter 6). Joints that close loops, and rows of their own, keep their multipliers.
//! Two vectors that turn with two angles make the cosine and the sine of the angle between them.

use crate::collect::{CollectVec, MapEach};
use plm_cas::{Expr, Rotation, Vec2, algebra};

use super::joints::chain::Chain;
use super::joints::coordinates::{Coordinates, Unknown};
use crate::derive::{Equations, SparseRow};
use crate::model::{self, Model};
use crate::numeric::Random;

/// The equations of a mechanism.
pub(crate) struct Textbook {
    /// Names of the coordinates, as paths of the model.
    pub(crate) names: Vec<String>,
    /// Their symbols.
    pub(crate) value: Vec<Expr>,
    /// Symbols of their rates.
    pub(crate) rate: Vec<Expr>,
    /// Each coordinate as a function of the absolute pose.
    #[cfg(test)]
    pub(crate) of_pose: Vec<Expr>,
    /// An equation for each coordinate.
    pub(crate) rows: Vec<Row>,
    /// Constraints that are left.
    pub(crate) conditions: Vec<Condition>,
    /// Why it has absolute coordinates, if it has.
    pub(crate) reason: Option<String>,
}

/// One equation.
#[derive(Default)]
pub(crate) struct Row {
    /// Coefficients of second derivatives, by coordinate; those that are zero are left out, as in the next.
    pub(crate) mass: Vec<(usize, Expr)>,
    /// Coefficients of products of two rates.
    pub(crate) turning: Vec<([usize; 2], Expr)>,
    /// Terms of the weight, and of a motion of the ground.
    pub(crate) still: Vec<Expr>,
    /// Terms of the applied force.
    pub(crate) applied: Vec<Expr>,
}

/// A constraint.
pub(crate) struct Condition {
    /// The part that it belongs to.
    pub(crate) part: usize,
    pub(crate) phi: Expr,
    /// Its derivative by each coordinate.
    pub(crate) along: Vec<(usize, Expr)>,
}

/// `factor R(orientation) vector`, times a product of rates.
struct Term {
    orientation: usize,
    factor: Expr,
    rates: Option<[usize; 2]>,
    vector: Vec2,
}

/// Sums over the bodies of `m u . w` and `m u x w` of two orientations.
struct Sum {
    between: [usize; 2],
    factor: Expr,
    dots: Vec<Expr>,
    crosses: Vec<Expr>,
}

/// Coordinates of a spanning tree.
struct Tree<'a> {
    model: &'a Model,
    coordinates: &'a Coordinates,
    value: Vec<Expr>,
    rate: Vec<Expr>,
}

/// The equations of a mechanism, in the present graph.
pub(crate) fn textbook(model: &Model, equations: &Equations) -> Textbook {
    match Coordinates::new(model) {
        Ok(coordinates) => {
            let symbols = coordinates.unknowns.iter().map(|unknown| symbols(model, *unknown));
            let (value, rate) = symbols.unzip();
            Tree { model, coordinates: &coordinates, value, rate }.textbook(equations)
        }
        Err(reason) => in_absolute_coordinates(model, equations, reason),
    }
}

fn symbols(model: &Model, unknown: Unknown) -> (Expr, Expr) {
    match unknown {
        Unknown::Angle { body, .. } => (model.bodies[body].q[2], model.bodies[body].v[2]),
        Unknown::Centre { body, axis } => (model.bodies[body].q[axis], model.bodies[body].v[axis]),
        Unknown::Displacement { part } => {
            let name = &model.parts[part].name.text;
            (Expr::symbol(format!("s_{name}")), Expr::symbol(format!("v_{name}")))
        }
    }
}

/// Each body by itself, held by the multipliers of all rows.
fn in_absolute_coordinates(model: &Model, equations: &Equations, reason: String) -> Textbook {
    let rows = equations.mass.iter().zip(&equations.force).enumerate();
    let row = |(i, (&mass, &force)): (usize, (&Expr, &Expr))| Row {
        mass: vec![(i, mass)],
        applied: vec![force],
        ..Row::default()
    };
    let names = (0..equations.q.len()).map(|k| crate::formulate::coordinate_name(model, k));
    let conditions = equations.phi.iter().zip(&equations.phi_q).zip(&model.rows);
    let condition = |((&phi, along), row): ((&Expr, &SparseRow), &model::Row)| Condition {
        part: row.part,
        phi,
        along: along.clone(),
    };
    Textbook {
        names: names.collect_vec(),
        #[cfg(test)]
        of_pose: equations.q.clone(),
        value: equations.q.clone(),
        rate: equations.v.clone(),
        rows: rows.map(row).collect_vec(),
        conditions: conditions.map(condition).collect_vec(),
        reason: Some(reason),
    }
}

impl Tree<'_> {
    fn textbook(self, equations: &Equations) -> Textbook {
        let places = self.places();
        let mut rows: Vec<Row> = self.value.iter().map(|_| Row::default()).collect_vec();
        let columns =
            self.coordinates.centres.iter().map(|chain| self.partial_velocities(chain)).collect_vec();
        for (i, row) in rows.iter_mut().enumerate() {
            self.moving(i, &columns, row);
        }
        self.apply(&places, &columns, &mut rows);
        let conditions = self.conditions(&places, equations);
        let names = self.coordinates.unknowns.iter().map(|unknown| unknown.name(self.model));
        let names = names.collect_vec();
        #[cfg(test)]
        let of_pose = |unknown: &Unknown| super::motion::of_pose(self.model, self.coordinates, *unknown);
        Textbook {
            names,
            #[cfg(test)]
            of_pose: self.coordinates.unknowns.iter().map(of_pose).collect_vec(),
            value: self.value,
            rate: self.rate,
            rows,
            conditions,
            reason: None,
        }
    }

    /// Mass, what the velocities ask for, and weight, along one coordinate.
    fn moving(&self, i: usize, columns: &[Vec<(usize, Vec<Term>)>], row: &mut Row) {
        let (model, mut mass) = (self.model, vec![Vec::new(); self.value.len()]);
        let mut sums: Vec<Vec<Sum>> = self.value.iter().map(|_| Vec::new()).collect_vec();
        let mut turning: Vec<([usize; 2], Vec<Sum>)> = Vec::new();
        let mut still = Vec::new();
        let weight = [Term { orientation: 0, factor: Expr::ONE, rates: None, vector: -model.gravity }];
        for (body, declared) in model.bodies.iter().enumerate() {
            let angle =
                self.coordinates.angle_of_orientation[self.coordinates.absolute_angles[body].orientation];
            if angle == Some(i) {
                mass[i].push(declared.inertia);
            }
            let Some((_, own)) = columns[body].iter().find(|(column, _)| *column == i) else { continue };
            for (j, other) in &columns[body] {
                multiply(&mut sums[*j], declared.mass, own, other);
            }
            multiply(&mut still, declared.mass, own, &weight);
            for term in self.bias(&self.coordinates.centres[body]) {
                let into = match term.rates {
                    None => &mut still,
                    Some(rates) => {
                        let known = turning.iter().position(|(of, _)| *of == rates);
                        let at = known.unwrap_or(turning.len());
                        if known.is_none() {
                            turning.push((rates, Vec::new()));
                        }
                        &mut turning[at].1
                    }
                };
                multiply(into, declared.mass, own, &[term]);
            }
        }
        for (j, (mut terms, sums)) in mass.into_iter().zip(sums).enumerate() {
            terms.extend(self.collected(sums));
            row.mass.extend(non_zero(algebra::sum(&terms)).map(|entry| (j, entry)));
        }
        turning.sort_by_key(|own| own.0);
        for (rates, sums) in turning {
            row.turning.extend(non_zero(algebra::sum(&self.collected(sums))).map(|entry| (rates, entry)));
        }
        row.still = self.collected(still);
    }

    /// `dp/du_i` of a place, by coordinate.
    fn partial_velocities(&self, place: &Chain) -> Vec<(usize, Vec<Term>)> {
        let mut columns: Vec<(usize, Vec<Term>)> = Vec::new();
        let mut add = |coordinate: usize, term: Term| match columns.iter_mut().find(|own| own.0 == coordinate)
        {
            Some((_, terms)) => terms.push(term),
            None => columns.push((coordinate, vec![term])),
        };
        for (orientation, displacement, vector) in place.terms() {
            let factor = displacement.map_or(Expr::ONE, |displacement| self.value[displacement]);
            if let Some(angle) = self.coordinates.angle_of_orientation[orientation] {
                add(angle, Term { orientation, factor, rates: None, vector: vector.left() });
            }
            if let Some(displacement) = displacement {
                add(displacement, Term { orientation, factor: Expr::ONE, rates: None, vector });
            }
        }
        columns.sort_by_key(|own| own.0);
        columns
    }

    /// The acceleration of a place while the second derivatives of the coordinates are zero.
    fn bias(&self, place: &Chain) -> Vec<Term> {
        let mut terms = Vec::new();
        for (orientation, displacement, vector) in place.terms() {
            let factor = displacement.map_or(Expr::ONE, |displacement| self.value[displacement]);
            if let Some(angle) = self.coordinates.angle_of_orientation[orientation] {
                terms.push(Term { orientation, factor, rates: Some([angle, angle]), vector: -vector });
                if let Some(own) = displacement {
                    let rates = Some([angle.min(own), angle.max(own)]);
                    terms.push(Term { orientation, factor: Expr::from(2), rates, vector: vector.left() });
                }
            }
            if orientation == 0 && displacement.is_none() {
                let vector = vector.diff(self.model.time).diff(self.model.time);
                terms.push(Term { orientation, factor: Expr::ONE, rates: None, vector });
            }
        }
        terms.retain(|term| !term.vector.is_zero());
        terms
    }

    /// Terms of sums of products.
    fn collected(&self, sums: Vec<Sum>) -> Vec<Expr> {
        let mut terms = Vec::new();
        for Sum { between: [a, b], factor, dots, crosses } in sums {
            let (dot, cross) = (algebra::sum(&dots), algebra::sum(&crosses));
            let [a, b] = [a, b].map_each(|orientation| self.angle(orientation));
            let angle = a - b;
            terms.extend(non_zero(factor * dot * angle.cos()));
            terms.extend(non_zero(factor * cross * angle.sin()));
        }
        terms
    }

    fn angle(&self, orientation: usize) -> Expr {
        self.coordinates.angle_of_orientation[orientation].map_or(Expr::ZERO, |angle| self.value[angle])
    }

    fn turned(&self, orientation: usize, vector: Vec2) -> Vec2 {
        if orientation == 0 { vector } else { Rotation::by(self.angle(orientation)) * vector }
    }

    /// Coordinates and velocities of all bodies as functions of the unknowns and the time.
    fn places(&self) -> Vec<(Expr, Expr)> {
        let along = self.value.iter().copied().zip(self.rate.iter().copied());
        let along = along.chain([(self.model.time, Expr::ONE)]).collect_vec();
        let mut pairs = Vec::new();
        for (body, declared) in self.model.bodies.iter().enumerate() {
            let mut place = Vec2::ZERO;
            for (orientation, displacement, vector) in self.coordinates.centres[body].terms() {
                let factor = displacement.map_or(Expr::ONE, |displacement| self.value[displacement]);
                place += factor * self.turned(orientation, vector);
            }
            let own = self.coordinates.absolute_angles[body];
            let angle = self.angle(own.orientation) + own.offset;
            let spin = self.coordinates.angle_of_orientation[own.orientation]
                .map_or(Expr::ZERO, |angle| self.rate[angle]);
            let [x, y] = place.components();
            let now = [x, y, angle, x.directional(&along), y.directional(&along), spin];
            let symbols = declared.q.iter().chain(&declared.v).copied();
            pairs.extend(symbols.zip(now).filter(|(old, new)| old != new));
        }
        pairs
    }

    /// Adds the applied forces along each coordinate.
    fn apply(&self, places: &[(Expr, Expr)], columns: &[Vec<(usize, Vec<Term>)>], rows: &mut [Row]) {
        for load in &self.model.loads {
            let force = algebra::substitute(&load.force, places);
            for (i, terms) in &columns[load.body] {
                let along = terms.iter().map(|term| term.factor * self.turned(term.orientation, term.vector));
                let work = along.sum::<Vec2>().dot(Vec2::new(force[0], force[1]));
                rows[*i].applied.extend(non_zero(work));
            }
            let orientation = self.coordinates.absolute_angles[load.body].orientation;
            if let Some(angle) = self.coordinates.angle_of_orientation[orientation] {
                rows[angle].applied.extend(non_zero(force[2]));
            }
        }
    }

    /// The rows that the tree does not fulfil by itself.
    fn conditions(&self, places: &[(Expr, Expr)], equations: &Equations) -> Vec<Condition> {
        let all = algebra::substitute(&equations.phi, places);
        let left = all.into_iter().zip(&self.model.rows).filter(|(phi, _)| !vanishes(*phi));
        let condition = |(phi, row): (Expr, &model::Row)| {
            let along = self.value.iter().enumerate();
            let along = along.filter_map(|(i, &value)| non_zero(phi.diff(value)).map(|entry| (i, entry)));
            Condition { part: row.part, phi, along: along.collect_vec() }
        };
        left.map(condition).collect_vec()
    }
}

/// Adds the products of two sums of vectors, times a mass.
fn multiply(into: &mut Vec<Sum>, mass: Expr, left: &[Term], right: &[Term]) {
    for a in left {
        for b in right {
            let (factor, cross) = (a.factor * b.factor, a.vector.cross(b.vector));
            let is_turned = a.orientation > b.orientation;
            let between =
                if is_turned { [b.orientation, a.orientation] } else { [a.orientation, b.orientation] };
            let cross = if is_turned { -cross } else { cross };
            let found = into.iter().position(|sum| sum.between == between && sum.factor == factor);
            let at = found.unwrap_or(into.len());
            if found.is_none() {
                into.push(Sum { between, factor, dots: Vec::new(), crosses: Vec::new() });
            }
            into[at].dots.push(mass * a.vector.dot(b.vector));
            into[at].crosses.push(mass * cross);
        }
    }
}

fn non_zero(expr: Expr) -> Option<Expr> {
    (!expr.is_zero()).then_some(expr)
}

/// Is an expression zero, whatever its symbols are? One whose terms do not cancel by themselves is tried at random values.
fn vanishes(expr: Expr) -> bool {
    if expr.is_zero() {
        return true;
    }
    let (symbols, tape, mut random) = (algebra::symbols(&[expr]), algebra::tape(&[expr]), Random(1));
    (0..4).all(|_| {
        let values = symbols.iter().map(|&symbol| (symbol, 1.5 + random.unit())).collect_vec();
        tape.eval(&values).is_ok_and(|values| values[0].abs() < 1e-12)
    })
}
