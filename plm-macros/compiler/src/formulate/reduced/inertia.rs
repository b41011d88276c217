//! The equations of motion in joint coordinates, as a dense symmetric system.
//!
//! `M_ij = sum over bodies of m J_i . J_j + I w_i w_j` with the partial velocities `J` of G (T. R. Kane, D. A. Levinson,
//! Dynamics: Theory and Applications, 1985, chapter 6). Vectors are constant in the axes of their orientations, so the sums
//! over the bodies are constants, and what is left of a pair of orientations is the cosine and the sine of the angle between
//! them.

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::algebra::{self, dot};
use plm_cas::{Expr, Vec2};

use crate::formulate::reduced::joints::chain::Chain;
use crate::formulate::reduced::motion::Motion;
use crate::formulate::reduced::motion::bases::Products;
use crate::model::Model;

/// `M a = Q` for the second derivatives `a` of the coordinates.
#[derive(Clone)]
pub(crate) struct Dense {
    /// Lower entries of M, (row, column) with `row >= column`; what is absent is zero.
    pub(crate) mass: SortedMap<(usize, usize), Expr>,
    /// Forces; without a pace, less what the velocities ask for.
    pub(crate) force: Vec<Expr>,
    /// With a pace, what the velocities ask for over its square.
    pub(crate) turning: Vec<Expr>,
}

/// `factor R(theta_orientation) vector`.
struct Term {
    orientation: usize,
    factor: Expr,
    vector: Vec2,
}

/// Sums of `m u . w` and `m u x w` over the bodies, by (orientation of u, orientation of w, factor).
type Sums = SortedMap<(usize, usize, Expr), (Vec<Expr>, Vec<Expr>)>;

/// Sets up the equations; `force` are the applied forces at each G in absolute axes, without gravity.
pub(crate) fn dense(model: &Model, motion: &Motion, force: &[[Expr; 3]]) -> Dense {
    let coordinates = motion.coordinates;
    let count = coordinates.unknowns.len();
    let mut mass: SortedMap<(usize, usize), Sums> = SortedMap::new();
    let mut spin: SortedMap<(usize, usize), Vec<Expr>> = SortedMap::new();
    let mut inertial: Vec<Sums> = (0..count).map(|_| Sums::new()).collect_vec();
    let mut turning: Vec<Sums> = (0..count).map(|_| Sums::new()).collect_vec();
    let mut applied: Vec<Vec<Expr>> = vec![Vec::new(); count];
    for (body, declared) in model.bodies.iter().enumerate() {
        let columns = partial_velocities(motion, &coordinates.centres[body]);
        let weight = [against_gravity(model)];
        let bias = bias(model, motion, &coordinates.centres[body]);
        for (k, (i, left)) in columns.iter().enumerate() {
            for (j, right) in &columns[..=k] {
                let entry = mass.or_insert((*i, *j), SortedMap::new());
                multiply(motion, entry, declared.mass, (left, right));
            }
            multiply(motion, &mut inertial[*i], declared.mass, (left, &weight));
            let moving = if motion.pace.is_some() { &mut turning } else { &mut inertial };
            multiply(motion, &mut moving[*i], declared.mass, (left, &bias));
            let [fx, fy, _] = force[body];
            for term in left {
                let along = motion.turned(term.orientation, term.vector);
                let work = along.dot(Vec2::new(fx, fy));
                applied[*i].push(term.factor * work);
            }
        }
        if let Some(angle) = coordinates.angle_of_orientation[coordinates.absolute_angles[body].orientation] {
            spin.or_insert((angle, angle), Vec::new()).push(declared.inertia);
            applied[angle].push(force[body][2]);
        }
    }
    let mut entries: SortedMap<(usize, usize), Expr> = SortedMap::new();
    for (key, sums) in mass {
        entries.insert(key, collect(motion, sums));
    }
    for (key, terms) in spin {
        *entries.or_insert(key, Expr::ZERO) += algebra::sum(&terms);
    }
    entries.retain(|&(i, j), entry| i == j || !entry.is_zero());
    let force = inertial.into_iter().zip(applied).map(|(inertial, applied)| {
        let against = collect(motion, inertial);
        algebra::sum(&applied) - against
    });
    let force = force.collect_vec();
    let turning = turning.into_iter().map(|sums| collect(motion, sums)).collect_vec();
    Dense { mass: entries, force, turning }
}

impl Dense {
    /// `M a - Q`, zero along the motion.
    pub(crate) fn residuals(&self, motion: &Motion, a: &[Expr]) -> Vec<Expr> {
        let mut residuals: Vec<Expr> =
            self.right_hand_side(motion).into_iter().map(|force| -force).collect_vec();
        for (&(i, j), &mass) in &self.mass {
            residuals[i] += mass * a[j];
            if i != j {
                residuals[j] += mass * a[i];
            }
        }
        residuals
    }

    /// Forces less what the velocities ask for.
    pub(crate) fn right_hand_side(&self, motion: &Motion) -> Vec<Expr> {
        let Some(pace) = motion.pace else { return self.force.clone() };
        let each = self.force.iter().zip(&self.turning).enumerate().map(|(i, (&force, &turning))| {
            // By names, so that what waits for the velocity is done last.
            let force = force.named(format!("still_{i}"));
            force - pace.squared() * turning.named(format!("turning_{i}"))
        });
        each.collect_vec()
    }
}

/// The equations of the coordinates alone: `K^T M K` and `K^T Q - (M K)^T b`.
pub(crate) fn along_independent(dense: &Dense, motion: &Motion) -> Dense {
    let independent = motion.independent.len();
    let (mut mass, mut force, mut turning) = (SortedMap::new(), Vec::new(), Vec::new());
    for j in 0..independent {
        let column = motion.coefficients(j);
        let moved = times(dense, &column).into_iter().enumerate();
        let moved = moved.map(|(i, entry)| entry.named(format!("momentum_{j}_{i}")));
        let moved: Vec<Expr> = moved.collect_vec();
        for i in j..independent {
            let entry = dot(&motion.coefficients(i), &moved);
            if i == j || !entry.is_zero() {
                mass.insert((i, j), entry);
            }
        }
        let own = dot(&column, &dense.force);
        let (asked, pushed) = (dot(&column, &dense.turning), dot(&moved, &motion.bias));
        let paced = motion.pace.is_some();
        force.push(if paced { own } else { own - pushed });
        turning.push(asked + pushed);
    }
    Dense { mass, force, turning }
}

/// `M u`.
fn times(dense: &Dense, u: &[Expr]) -> Vec<Expr> {
    let mut terms: Vec<Vec<Expr>> = vec![Vec::new(); u.len()];
    for (&(i, j), &entry) in &dense.mass {
        terms[i].push(entry * u[j]);
        if i != j {
            terms[j].push(entry * u[i]);
        }
    }
    terms.iter().map(|terms| algebra::sum(terms)).collect_vec()
}

/// The acceleration with which the ground would have to move instead of gravity. Where it lies along an axis its size is left
/// as a factor of whole sums.
fn against_gravity(model: &Model) -> Term {
    let against = -model.gravity;
    let (factor, vector) = match (against.x.is_zero(), against.y.is_zero()) {
        (true, _) => (against.y, Vec2::Y),
        (_, true) => (against.x, Vec2::X),
        _ => (Expr::ONE, against),
    };
    Term { orientation: 0, factor, vector }
}

/// Over how many pairs of unknowns the sums go, body by body.
pub(crate) fn pairs(motion: &Motion) -> usize {
    let moved_by = motion.coordinates.centres.iter().map(|place| partial_velocities(motion, place).len());
    moved_by.map(|count| count * (count + 1) / 2).sum()
}

/// `dp/dy_i` of a place, for every coordinate that moves it, ascending.
fn partial_velocities(motion: &Motion, place: &Chain) -> Vec<(usize, Vec<Term>)> {
    let coordinates = motion.coordinates;
    let mut columns: SortedMap<usize, Vec<Term>> = SortedMap::new();
    for (orientation, displacement, vector) in place.terms() {
        let factor = displacement.map_or(Expr::ONE, |displacement| motion.value[displacement]);
        if let Some(angle) = coordinates.angle_of_orientation[orientation] {
            columns.or_insert(angle, Vec::new()).push(Term { orientation, factor, vector: vector.left() });
        }
        if let Some(displacement) = displacement {
            columns.or_insert(displacement, Vec::new()).push(Term { orientation, factor: Expr::ONE, vector });
        }
    }
    columns.into_iter().collect_vec()
}

/// The acceleration of a place while the second derivatives of the coordinates are zero; with a pace, over its square.
fn bias(model: &Model, motion: &Motion, place: &Chain) -> Vec<Term> {
    let mut terms = Vec::new();
    for (orientation, displacement, vector) in place.terms() {
        let omega = motion.turning[orientation];
        let squared = omega.squared();
        let factor = displacement.map_or(squared, |displacement| squared * motion.value[displacement]);
        terms.push(Term { orientation, factor, vector: -vector });
        if let Some(displacement) = displacement {
            // Coriolis: 2 omega s'.
            let turning = omega * motion.rate_over_pace(displacement);
            terms.push(Term { orientation, factor: turning + turning, vector: vector.left() });
        }
        if orientation == 0 && displacement.is_none() {
            let moved = vector.diff(model.time).diff(model.time);
            terms.push(Term { orientation, factor: Expr::ONE, vector: moved });
        }
    }
    terms.retain(|term| !term.factor.is_zero() && !term.vector.is_zero());
    terms
}

/// Adds the products of two sums of vectors, times a mass; those of two orientations over the orientations' bases.
fn multiply(motion: &Motion, into: &mut Sums, mass: Expr, (left, right): (&[Term], &[Term])) {
    for a in left {
        for b in right {
            let over_base = |term: &Term| {
                if a.orientation == b.orientation {
                    term.vector
                } else {
                    motion.over_base(term.orientation, term.vector)
                }
            };
            let products = Products::of(over_base(a), over_base(b));
            let factor = a.factor * b.factor;
            let (dots, crosses) = into.or_insert((a.orientation, b.orientation, factor), Default::default());
            dots.push(mass * products.dot);
            crosses.push(mass * products.cross);
        }
    }
}

/// `sum of factor (C sum(m u . w) - S sum(m u x w))` where C, S are scalar and cross product of the bases of the orientation of
/// `u` and of that of `w`.
fn collect(motion: &Motion, sums: Sums) -> Expr {
    let terms = sums.into_iter().map(|((a, b, factor), (dots, crosses))| {
        let (dots, crosses) = (algebra::sum(&dots), algebra::sum(&crosses));
        let along = if a == b {
            dots
        } else {
            let bases = motion.products_of_bases(a, b);
            bases.dot * dots - bases.cross * crosses
        };
        factor * along
    });
    terms.sum()
}
