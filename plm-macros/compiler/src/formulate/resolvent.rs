//! The linear systems of a linearly implicit step, eliminated entry by entry.
//!
//! With the unknowns v for q' = v, lambda q - v = r_q, and s for the first-order states, an equation
//! `c_q q + c_v v + c_a v' + c_s s + c_r s' + c z = 0` of the linearised ones says
//!
//! ```text
//! (1)  (c_q / lambda + c_v + lambda c_a) v + (c_s + lambda c_r) s + c z = b
//! (2)  b = -c_q r_q / lambda + c_a r_v + c_r r_s
//! (3)  l_ip = a_ip / a_pp,   a_ij <- a_ij - l_ip a_pj     in the order of the pattern
//! (4)  b_i <- b_i - l_ip b_p,   y_p = (b_p - sum of a_pj y_j) / a_pp
//! (5)  k_q = (r_q + v) / lambda
//! ```
//!
//! (E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, IV.8, on the special structure; I. S. Duff,
//! A. M. Erisman, J. K. Reid, Direct Methods for Sparse Matrices, 1986, chapter 9.)

use crate::collect::CollectVec;
use crate::sorted::SortedMap;

use plm_cas::Expr;

use super::function::{Function, Place, stored};
use super::linearised::{Augmented, Part};

/// Elimination of linearised equations for one lambda, and their solution for one right-hand side.
pub(crate) struct Resolvent {
    /// Symbols of the coefficients.
    pub(crate) c: Vec<Expr>,
    /// Symbols of the eliminated entries.
    pub(crate) e: Vec<Expr>,
    /// Symbols of the right-hand side.
    pub(crate) r: Vec<Expr>,
    /// The symbol of lambda.
    pub(crate) lambda: Expr,
    /// That of 1 / lambda.
    pub(crate) inverse: Expr,
    /// `e`: L below the pivots, U right of them, reciprocals in their place; returns the largest growth, by which a product
    /// was larger than the pivot that it was taken from.
    pub(crate) eliminate: Function,
    /// `k`, the solution.
    pub(crate) solve: Function,
}

impl Resolvent {
    /// Lays out the elimination of linearised equations.
    pub(crate) fn new(augmented: &Augmented) -> Resolvent {
        let (coordinates, states) = (augmented.accelerations.len(), augmented.states);
        let symbols = |name: &str, count: usize| -> Vec<Expr> {
            (0..count).map(|k| Expr::symbol(format!("{name}_{k}"))).collect_vec()
        };
        let mut resolvent = Resolvent {
            c: symbols("c", augmented.coefficients.results.len()),
            e: symbols("e", augmented.pattern.places.len()),
            r: symbols("r", 2 * coordinates + states),
            lambda: Expr::symbol("lambda"),
            inverse: Expr::symbol("inverse"),
            eliminate: Function::default(),
            solve: Function::default(),
        };
        resolvent.eliminate = resolvent.eliminated(augmented);
        resolvent.solve = resolvent.solved(augmented, coordinates, states);
        resolvent
    }

    /// (1) and (3).
    fn eliminated(&self, augmented: &Augmented) -> Function {
        let mut a: SortedMap<(usize, usize), Expr> = SortedMap::new();
        for term in &augmented.terms {
            let c = self.c[term.coefficient];
            *a.or_insert((term.row, term.column), Expr::ZERO) += match term.part {
                Part::Value | Part::Velocity => c,
                Part::Rate | Part::Acceleration => c * self.lambda,
                Part::Position => c * self.inverse,
            };
        }
        let mut growth: Option<Expr> = None;
        let mut taken: SortedMap<usize, Expr> = SortedMap::new();
        for pivot in &augmented.pattern.pivots {
            let p = pivot.row;
            let diagonal = a.get(&(p, p)).copied().unwrap_or(Expr::ZERO);
            let reciprocal = (1 / diagonal).named(format!("r_{p}"));
            if let Some(product) = taken.get(&p) {
                let grown = *product * reciprocal.abs();
                growth = Some(growth.map_or(grown, |growth| grown.max(growth)));
            }
            a.insert((p, p), reciprocal);
            let across: Vec<(usize, Expr)> = pivot
                .right
                .iter()
                .map(|&j| (j, a.get(&(p, j)).copied().unwrap_or(Expr::ZERO).named(format!("u_{p}_{j}"))))
                .collect_vec();
            for &(j, entry) in &across {
                a.insert((p, j), entry);
            }
            for &i in &pivot.below {
                let entry = a.get(&(i, p)).copied().unwrap_or(Expr::ZERO);
                let l = (entry * reciprocal).named(format!("l_{i}_{p}")); // (3)
                a.insert((i, p), l);
                for &(j, u) in &across {
                    let product = l * u;
                    if i == j {
                        let size = product.abs();
                        let most = taken.get(&i).map_or(size, |most| Expr::max(*most, size));
                        taken.insert(i, most);
                    }
                    *a.or_insert((i, j), Expr::ZERO) -= product;
                }
            }
        }
        let entries = augmented.pattern.places.iter();
        let mut results: Vec<(Place, Expr)> = entries
            .map(|(key, &place)| (Place::Element("e", place), a.get(key).copied().unwrap_or(Expr::ZERO)))
            .collect_vec();
        results.push((Place::Value, growth.unwrap_or(Expr::ZERO)));
        Function::of_results(results).optimise()
    }

    /// (2), (4) and (5).
    fn solved(&self, augmented: &Augmented, n: usize, states: usize) -> Function {
        let pattern = &augmented.pattern;
        let e = |row: usize, column: usize| self.e[pattern.places[&(row, column)]];
        let mut b = vec![Expr::ZERO; pattern.pivots.len()];
        for term in &augmented.terms {
            let known = match term.part {
                Part::Value | Part::Velocity => continue,
                Part::Position => -(self.r[term.column] * self.inverse),
                Part::Acceleration | Part::Rate => self.r[n + term.column],
            };
            b[term.row] += self.c[term.coefficient] * known; // (2)
        }
        for pivot in &pattern.pivots {
            let p = pivot.row;
            b[p] = b[p].named(format!("b_{p}"));
            for &i in &pivot.below {
                b[i] = b[i] - e(i, p) * b[p]; // (4)
            }
        }
        for pivot in pattern.pivots.iter().rev() {
            let p = pivot.row;
            let rest = pivot.right.iter().fold(b[p], |rest, &j| rest - e(p, j) * b[j]);
            b[p] = (rest * e(p, p)).named(format!("y_{p}"));
        }
        let of_positions = (0..n).map(|i| (self.r[i] + b[i]) * self.inverse); // (5)
        let k: Vec<Expr> = of_positions.chain(b[..n + states].iter().copied()).collect_vec();
        Function::of_results(stored("k", k.iter())).optimise()
    }
}
