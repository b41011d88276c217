//! The linear systems of Newton's iteration on loops, solved without a pivot that could vanish.
//!
//! Straight-line code cannot choose pivots by what it finds, and an order that suits one pose fails at another. But each
//! loop has two rows, and they may be turned: along the column `g` of an unknown whose bar has a constant length, and
//! across it. Along `g`, the loop gives that unknown, by a pivot that is constant; across, it does not hold it. What is
//! left is a system of half the size, of at most four unknowns, whose inverse is written down by minors (Laplace's
//! expansion, two rows at a time). It is singular where the whole is, and nowhere else.

use crate::collect::{CollectVec, MapEach};
use crate::sorted::sort_by_key;
use plm_cas::algebra::{self, dot};
use plm_cas::{Expr, Vec2};

/// Which unknown each loop gives. Loops and unknowns by their places in the block.
#[derive(Clone)]
pub(crate) struct Plan {
    pivots: Vec<Pivot>,
    /// The unknowns of the system that is left.
    rest: Vec<Rest>,
}

/// An unknown of the system that is left.
#[derive(Clone)]
struct Rest {
    unknown: usize,
    /// Its columns by loop.
    columns: Vec<Column>,
}

#[derive(Clone, Copy)]
struct Pivot {
    in_loop: usize,
    unknown: usize,
    /// `g . g`.
    square: Expr,
    /// `1 / g . g`.
    reciprocal: Expr,
}

/// The column of an unknown in a loop.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Column {
    /// The loop does not hold it.
    Absent,
    /// It changes its length with the pose.
    Varying,
    /// The square of its length.
    Constant(Expr),
}

impl Plan {
    /// The plan with the least to carry from loop to loop; `squares[k][u]` is the column of the unknown `u` in the loop `k`.
    pub(crate) fn new(squares: &[Vec<Column>]) -> Option<Plan> {
        let holds = |k: usize, u: usize| squares[k][u] != Column::Absent;
        let count = |u: usize| (0..squares.len()).filter(|&k| holds(k, u)).count();
        let n = squares.first()?.len();
        let mut best: Option<(usize, Vec<(usize, usize)>)> = None;
        for code in 0..n.pow(squares.len() as u32) {
            let chosen = (0..squares.len()).map(|k| (k, code / n.pow(k as u32) % n));
            let mut chosen: Vec<(usize, usize)> = chosen.collect_vec();
            let twice = |(place, own): (usize, &(usize, usize))| chosen[..place].iter().any(|c| c.1 == own.1);
            if chosen.iter().any(|&(k, u)| !matches!(squares[k][u], Column::Constant(_)))
                || chosen.iter().enumerate().any(twice)
            {
                continue;
            }
            sort_by_key(&mut chosen, |&(k, u)| (count(u), k));
            let Some(cost) = carried(squares, &chosen) else { continue };
            if best.as_ref().is_none_or(|best| cost < best.0) {
                best = Some((cost, chosen));
            }
        }
        let (_, chosen) = best?;
        let left = (0..n).filter(|u| chosen.iter().all(|pivot| pivot.1 != *u));
        let columns = |unknown: usize| squares.iter().map(|row| row[unknown]).collect_vec();
        let rest = left.map(|unknown| Rest { unknown, columns: columns(unknown) }).collect_vec();
        let pivots = chosen.into_iter().filter_map(|(in_loop, unknown)| match squares[in_loop][unknown] {
            Column::Constant(square) => Some(Pivot { in_loop, unknown, square, reciprocal: square.recip() }),
            _ => None,
        });
        Some(Plan { pivots: pivots.collect_vec(), rest })
    }
}

/// How many entries elimination touches in this order; nothing if it changes a column before that is a pivot.
fn carried(squares: &[Vec<Column>], chosen: &[(usize, usize)]) -> Option<usize> {
    let holds = |row: &Vec<Column>| row.iter().map(|column| *column != Column::Absent).collect_vec();
    let mut held: Vec<Vec<bool>> = squares.iter().map(holds).collect_vec();
    let mut touched = vec![vec![false; squares[0].len()]; squares.len()];
    let mut cost = 0;
    for (place, &(k, u)) in chosen.iter().enumerate() {
        if touched[k][u] {
            return None;
        }
        let others: Vec<usize> = (0..held[k].len()).filter(|&c| c != u && held[k][c]).collect_vec();
        cost += 2 * others.len();
        for other in 0..squares.len() {
            if other == k || !held[other][u] {
                continue;
            }
            let is_later = chosen[place..].iter().any(|pivot| pivot.0 == other);
            cost += others.len() * if is_later { 2 } else { 1 };
            for &c in &others {
                (held[other][c], touched[other][c]) = (true, true);
            }
            held[other][u] = false;
        }
    }
    Some(cost)
}

/// A decomposed Jacobian.
pub(crate) struct Elimination<'a> {
    plan: &'a Plan,
    /// Prefix of the names of all entries.
    name: String,
    stages: Vec<Stage>,
    inverse: Vec<Vec<Expr>>,
    /// The square of how far the unknowns that are left are from a singular pose ([`Plan::measure`]).
    pub(crate) measure: Expr,
}

/// One unknown is gone.
struct Stage {
    column: Vec2,
    /// The unknown is `a - sum of along_c x_c`.
    along: Vec<Expr>,
    /// Its columns in loops that come later.
    later: Vec<(usize, Vec2)>,
    /// Its factors in the rows that were left before.
    before: Vec<(usize, Expr)>,
}

impl<'a> Elimination<'a> {
    /// Decomposes the matrix with the columns `columns[k][u]` in the loops. What varies is measured by `length`.
    pub(crate) fn new(
        plan: &'a Plan,
        mut columns: Vec<Vec<Vec2>>,
        (name, length): (&str, Expr),
    ) -> Elimination<'a> {
        let zero = Expr::ZERO;
        let (mut stages, mut rows): (Vec<Stage>, Vec<Vec<Expr>>) = (Vec::new(), Vec::new());
        for (place, &Pivot { in_loop, unknown, reciprocal, .. }) in plan.pivots.iter().enumerate() {
            let own = std::mem::take(&mut columns[in_loop]);
            let column = own[unknown];
            let (mut along, mut across) = (vec![zero; own.len()], vec![zero; own.len()]);
            for (c, &other) in own.iter().enumerate().filter(|&(c, _)| c != unknown) {
                along[c] = (column.dot(other) * reciprocal).named(format!("{name}_along_{place}_{c}"));
                across[c] = column.cross(other).named(format!("{name}_across_{place}_{c}"));
            }
            let mut stage = Stage { column, along, later: Vec::new(), before: Vec::new() };
            for (k, columns) in columns.iter_mut().enumerate() {
                let Some(&carried) = columns.get(unknown).filter(|column| !(**column).is_zero()) else {
                    continue;
                };
                for (c, column) in columns.iter_mut().enumerate() {
                    *column =
                        (*column - stage.along[c] * carried).named(format!("{name}_of_{place}_{k}_{c}"));
                }
                columns[unknown] = Vec2::ZERO;
                stage.later.push((k, carried));
            }
            for (k, row) in rows.iter_mut().enumerate() {
                let carried = std::mem::replace(&mut row[unknown], zero);
                if carried.is_zero() {
                    continue;
                }
                for (c, entry) in row.iter_mut().enumerate() {
                    *entry =
                        (*entry - carried * stage.along[c]).named(format!("{name}_left_{place}_{k}_{c}"));
                }
                stage.before.push((k, carried));
            }
            rows.push(across);
            stages.push(stage);
        }
        let left = |row: &Vec<Expr>| plan.rest.iter().map(|rest| row[rest.unknown]).collect_vec();
        let rest = rows.iter().map(left).collect_vec();
        let (cofactors, determinant) = cofactors(&rest, name);
        let measure = plan.measure(&cofactors, determinant, length);
        let reciprocal = determinant.recip().named(format!("{name}_reciprocal"));
        let mut inverse = cofactors;
        for (i, row) in inverse.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                *entry = (*entry * reciprocal).named(format!("{name}_inverse_{i}_{j}"));
            }
        }
        Elimination { plan, name: name.to_owned(), stages, inverse, measure }
    }

    /// The unknowns `x` of `A x = b`, `b` by loops.
    pub(crate) fn solve(&self, mut b: Vec<Vec2>, what: &str) -> Vec<Expr> {
        let label = format!("{}_{what}", self.name);
        let (mut along, mut across): (Vec<Expr>, Vec<Expr>) = (Vec::new(), Vec::new());
        for (place, (stage, pivot)) in self.stages.iter().zip(&self.plan.pivots).enumerate() {
            let own = b[pivot.in_loop];
            let product = (stage.column.dot(own) * pivot.reciprocal).named(format!("{label}_along_{place}"));
            for &(k, carried) in &stage.later {
                b[k] = (b[k] - product * carried).named(format!("{label}_of_{place}_{k}"));
            }
            for &(k, carried) in &stage.before {
                across[k] = (across[k] - product * carried).named(format!("{label}_left_{place}_{k}"));
            }
            across.push(stage.column.cross(own).named(format!("{label}_across_{place}")));
            along.push(product);
        }
        let mut x = vec![Expr::ZERO; self.stages.first().map_or(0, |stage| stage.along.len())];
        for (row, rest) in self.inverse.iter().zip(&self.plan.rest) {
            x[rest.unknown] = dot(row, &across).named(format!("{label}_{}", rest.unknown));
        }
        for ((stage, pivot), along) in self.stages.iter().zip(&self.plan.pivots).zip(along).rev() {
            let value = along - dot(&stage.along, &x);
            x[pivot.unknown] = value.named(format!("{label}_{}", pivot.unknown));
        }
        x
    }
}

impl Plan {
    /// The harmonic mean of `s^2` over the unknowns that are left: `s` is the sine of the angle between the column of an unknown and
    /// those of the others, `1 / (|a| |row of the inverse|)` (G. W. Stewart, Collinearity and least squares regression, Statistical Science
    /// 2(1), 1987). For two unknowns it is the square of a sine.
    ///
    /// A column counts as it is in the loops: what elimination leaves of it vanishes where it becomes one with those of the pivots.
    /// Rows count as if they stood across columns of the length 1.
    fn measure(&self, cofactors: &[Vec<Expr>], determinant: Expr, length: Expr) -> Expr {
        let of_unknown = |(rest, row): (&Rest, &Vec<Expr>)| -> Expr {
            let column: Expr = rest.columns.iter().map(|column| column.square(length)).sum();
            let inverse: Expr =
                row.iter().zip(&self.pivots).map(|(entry, pivot)| entry.squared() * pivot.square).sum();
            column * inverse
        };
        let sum: Expr = self.rest.iter().zip(cofactors).map(of_unknown).sum();
        let mean = algebra::product(&[Expr::from(self.rest.len() as i32), determinant.squared()]) / sum;
        // Where two columns depend on the others all cofactors vanish with the determinant.
        Expr::ZERO.less(sum).select(mean, Expr::ZERO)
    }
}

impl Column {
    /// The square of its length, or of the size of the scene.
    fn square(self, length: Expr) -> Expr {
        match self {
            Column::Absent => Expr::ZERO,
            Column::Varying => length.squared(),
            Column::Constant(square) => square,
        }
    }
}

/// The transposed matrix of cofactors, and the determinant, of up to four rows.
fn cofactors(rows: &[Vec<Expr>], name: &str) -> (Vec<Vec<Expr>>, Expr) {
    let n = rows.len();
    let mut all = vec![vec![Expr::ONE; n]; n];
    for i in 0..n {
        for j in 0..n {
            let others = |k: usize| (0..n).filter(move |&l| l != k).collect_vec();
            let minor = minor(rows, &others(i), &others(j), name);
            let signed = if (i + j) % 2 == 0 { minor } else { -minor };
            all[j][i] = signed.named(format!("{name}_cofactor_{j}_{i}"));
        }
    }
    let first: Vec<Expr> = all.iter().map(|row| row[0]).collect_vec();
    let determinant = dot(&first, &rows[0]).named(format!("{name}_determinant"));
    (all, determinant)
}

/// A minor of up to three rows, those of two by a name: they are needed again.
fn minor(rows: &[Vec<Expr>], of: &[usize], columns: &[usize], name: &str) -> Expr {
    match (of, columns) {
        (&[i], &[j]) => rows[i][j],
        (&[i, k], &[j, l]) => {
            let value = Vec2::new(rows[i][j], rows[i][l]).cross(Vec2::new(rows[k][j], rows[k][l]));
            value.named(format!("{name}_minor_{i}{k}_{j}{l}"))
        }
        (&[first, second, third], &[j, k, l]) => {
            // Minors of the two rows that are neighbours of each other in pairs are shared by all four.
            let (single, pair) =
                if first == 0 && second == 1 { (third, [first, second]) } else { (first, [second, third]) };
            let terms = [(j, [k, l]), (k, [j, l]), (l, [j, k])].map_each(|(own, others)| {
                let rest = minor(rows, &pair, &others, name);
                rows[single][own] * rest
            });
            (terms[0] + terms[2]) - terms[1]
        }
        _ => Expr::ONE,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;
    use crate::numeric::Random;

    /// Solutions of systems with random numbers, and with a random pattern in which some unknowns that a loop gives stand
    /// in other loops as well: what is left of `A x - b`.
    #[test]
    fn solutions_solve() {
        let mut random = Random(1);
        let mut number = || random.unit();
        let mut shared = 0;
        for case in 0..60 {
            let loops = 2 + case % 3;
            let n = 2 * loops;
            let holds: Vec<Vec<bool>> = (0..loops)
                .map(|k| {
                    (0..n)
                        .map(|u| u == k || if u < loops { number() > 0.6 } else { number() > -0.6 })
                        .collect()
                })
                .collect();
            let mut values = Vec::new();
            let mut vector = |held: bool| {
                if !held {
                    return Vec2::ZERO;
                }
                let symbols = ["a_x", "a_y"].map(Expr::symbol);
                values.extend(symbols.map(|symbol| (symbol, number())));
                Vec2::from(symbols)
            };
            let columns: Vec<Vec<Vec2>> =
                holds.iter().map(|row| row.iter().map(|&held| vector(held)).collect()).collect();
            let b: Vec<Vec2> = (0..loops).map(|_| vector(true)).collect();
            let square = |k: usize, u: usize| match (holds[k][u], u < loops) {
                (false, _) => Column::Absent,
                (true, false) => Column::Varying,
                (true, true) => Column::Constant(columns[k][u].dot(columns[k][u])),
            };
            let squares: Vec<Vec<Column>> =
                (0..loops).map(|k| (0..n).map(|u| square(k, u)).collect()).collect();
            let Some(plan) = Plan::new(&squares) else { continue };
            let elimination = Elimination::new(&plan, columns.clone(), ("j", Expr::from(2)));
            shared +=
                usize::from(elimination.stages.iter().any(|s| !s.later.is_empty() || !s.before.is_empty()));
            let x = elimination.solve(b.clone(), "x");
            let mut roots = vec![elimination.measure];
            for (row, b) in columns.iter().zip(&b) {
                let product: Vec2 = row.iter().zip(&x).map(|(&column, &x)| x * column).sum();
                roots.extend((product - *b).components());
            }
            let results = algebra::tape(&roots).eval(&values).unwrap();
            let measure = results[0];
            assert!((0.0..1.0 + 1e-12).contains(&measure), "{case}: {measure}");
            let worst = results[1..].iter().fold(0.0_f64, |worst, gap| worst.max(gap.abs()));
            assert!(measure < 1e-8 || worst < 1e-9, "{case}: {worst:e}, measure {measure:e}");
        }
        assert!(shared > 10, "{shared}");
    }

    /// Two loops of which an unknown turns into the pivot's column of its loop: what is left of its column vanishes, and so does the
    /// measure, in proportion to the angle between them.
    #[test]
    fn measure_tells_a_column_that_vanishes() {
        let angle = Expr::symbol("angle");
        let (along, across) = (Vec2::new(Expr::ONE, Expr::ZERO), Vec2::new(Expr::ZERO, Expr::ONE));
        let turned = along + angle * across;
        let own = [[Some(along), None, Some(turned), None], [None, Some(across), Some(across), Some(along)]];
        let columns = own.map(|row| row.map(|column| column.unwrap_or(Vec2::ZERO)).to_vec()).to_vec();
        let kind = |column: &Option<Vec2>| column.map_or(Column::Absent, |_| Column::Constant(Expr::ONE));
        let squares = own.iter().map(|row| row.iter().map(kind).collect()).collect_vec();
        let plan = Plan::new(&squares).unwrap();
        let measure = Elimination::new(&plan, columns, ("j", Expr::ONE)).measure;
        let tape = algebra::tape(&[measure]);
        let [at_tenth, at_hundredth] =
            [0.1, 0.01].map(|value| tape.eval(&[(angle, value)]).unwrap()[0].sqrt());
        assert!((at_tenth / at_hundredth - 10.0).abs() < 0.1, "{at_tenth} {at_hundredth}");
        assert!(at_hundredth < 0.01, "{at_hundredth}");
    }

    /// Three loops in which two unknowns become one with those that the loops give: the determinant and all its cofactors vanish.
    #[test]
    fn measure_is_zero_where_the_rank_falls_by_two() {
        let [x, y] = [Vec2::new(Expr::ONE, Expr::ZERO), Vec2::new(Expr::ZERO, Expr::ONE)];
        let apart = Expr::symbol("apart");
        let row = |own: usize, with: (usize, Vec2)| {
            let place = |u: usize| if u == own { x } else { Vec2::ZERO };
            (0..6).map(|u| if u == with.0 { with.1 } else { place(u) }).collect_vec()
        };
        let near = x + apart * y;
        let columns = vec![row(0, (3, near)), row(1, (4, near)), row(2, (5, y))];
        let kind =
            |column: &Vec2| if column.is_zero() { Column::Absent } else { Column::Constant(Expr::ONE) };
        let squares = columns.iter().map(|row| row.iter().map(kind).collect()).collect_vec();
        let plan = Plan::new(&squares).unwrap();
        let measure = Elimination::new(&plan, columns, ("j", Expr::ONE)).measure;
        assert_eq!(algebra::tape(&[measure]).eval(&[(apart, 0.0)]).unwrap()[0].to_bits(), 0);
    }
}
