//! Tables: values at points, straight lines or a smooth curve between them.

use crate::collect::CollectVec;
use plm_cas::{Expr, Number};

use crate::diag::Code;
use crate::resolve::Resolver;
use crate::resolve::names::ScopeId;
use crate::resolve::values::{Eval, Failed, Nature, Quantity, Reads, Scalar, Value};
use crate::span::Span;
use crate::syntax::ast::{self, ExprKind};

/// How values go on between the points of a table.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Interpolation {
    /// Along straight lines.
    Lines,
    /// Along a smooth curve.
    Spline,
}

/// A point of a table.
#[derive(Clone, Copy)]
struct Point {
    x: Expr,
    y: Expr,
}

impl<'a> Resolver<'a> {
    /// The value at the first argument of a table of points `(x, y)`; beyond the ends the values there are held.
    pub(crate) fn table(
        &mut self,
        scope: ScopeId,
        span: Span,
        how: Interpolation,
        arguments: &'a [ast::Expr],
    ) -> Eval<Value> {
        let x = self.eval_scalar(scope, &arguments[0])?;
        let mut points: Vec<Point> = Vec::with_capacity(arguments.len() - 1);
        let mut last: Option<Scalar> = None;
        for point in &arguments[1..] {
            let ExprKind::Pair(at, value) = &point.kind else {
                self.error(scope, Code::BadTable, point.span, "a point of a table is a pair `(x, y)`");
                return Err(Failed);
            };
            let at_x = self.eval_scalar(scope, at)?;
            self.joined(scope, at.span, x, at_x)?;
            self.reads_fixed(scope, at, at_x.nature)?;
            let y = self.eval_scalar(scope, value)?;
            let nature = last.map_or(Ok(y.nature), |last| self.joined(scope, span, last, y))?;
            last = Some(Quantity { nature, ..y });
            points.push(Point { x: at_x.value, y: y.value });
        }
        self.ascending(scope, span, &points)?;
        let nature = last.map_or(Nature::BARE, |last| last.nature);
        let value = match how {
            Interpolation::Lines => between(x.value, &points, |k| line(points[k], points[k + 1])),
            Interpolation::Spline => {
                let spline = Spline::new(&points);
                between(x.value, &points, |k| spline.segment(k))
            }
        };
        Ok(Quantity::new(value, Nature::derived(nature.dimension, nature.reads.and(x.nature.reads))).into())
    }

    fn reads_fixed(&mut self, scope: ScopeId, expr: &ast::Expr, nature: Nature) -> Eval<()> {
        if nature.reads == Reads::NOTHING {
            return Ok(());
        }
        self.error(scope, Code::BadTable, expr.span, "the x values of a table are constants");
        Err(Failed)
    }

    fn ascending(&mut self, scope: ScopeId, span: Span, points: &[Point]) -> Eval<()> {
        if points.windows(2).all(|pair| number_of(pair[0].x) < number_of(pair[1].x)) {
            return Ok(());
        }
        self.error(scope, Code::BadTable, span, "the x values of a table ascend");
        Err(Failed)
    }
}

/// The value at x: of the first segment whose end lies above x, as a polynomial in the distance from its first point, its
/// coefficients by ascending powers; before the first point and after the last, the value there.
fn between(x: Expr, points: &[Point], segment: impl Fn(usize) -> Vec<Expr>) -> Expr {
    let mut value = points[points.len() - 1].y;
    for k in (0..points.len() - 1).rev() {
        let coefficients = segment(k);
        let along = x - points[k].x;
        let curve = coefficients.into_iter().rev().reduce(|sum, coefficient| coefficient + sum * along);
        value = x.less(points[k + 1].x).select(curve.unwrap_or(value), value);
    }
    x.less(points[0].x).select(points[0].y, value)
}

/// The straight line through two points.
fn line(from: Point, to: Point) -> Vec<Expr> {
    vec![from.y, (to.y - from.y) / (to.x - from.x)]
}

/// A curve through points that begins and ends at rest, with a continuous second derivative: cubics that have it so at the
/// points between (C. de Boor, A Practical Guide to Splines, 1978, chapter IV, the complete spline), but for the first and
/// the last segment, which are quintics, so that the second derivative vanishes at the ends as it does beyond them.
struct Spline {
    /// Distances from point to point.
    runs: Vec<f64>,
    y: Vec<Expr>,
    slopes: Vec<Expr>,
}

impl Spline {
    fn new(points: &[Point]) -> Spline {
        let knots: Vec<f64> = points.iter().map(|point| number_of(point.x)).collect_vec();
        let runs: Vec<f64> = knots.windows(2).map(|pair| pair[1] - pair[0]).collect_vec();
        let y: Vec<Expr> = points.iter().map(|point| point.y).collect_vec();
        // Slopes are linear in the values: those of a value of 1 at one point, and 0 at all others, are its weights.
        let columns: Vec<Vec<f64>> = (0..y.len()).map(|of| slopes(&runs, of)).collect_vec();
        let slope = |k: usize| y.iter().zip(&columns).map(|(&y, weights)| scaled(weights[k], y)).sum();
        let slopes = (0..y.len()).map(slope).collect_vec();
        Spline { runs, y, slopes }
    }

    /// Coefficients by powers of the distance from point `k`.
    fn segment(&self, k: usize) -> Vec<Expr> {
        let last = self.runs.len() - 1;
        if k != 0 && k != last {
            return self.cubic(k);
        }
        let from = if k == 0 { Expr::ZERO } else { self.bend(k) };
        let to = if k == last { Expr::ZERO } else { self.bend(k + 1) };
        self.quintic(k, [from, to])
    }

    /// The cubic with the values and slopes of the two points:
    /// `y0 + m0 s + (3 (y1 - y0)/h - 2 m0 - m1) s^2/h + (2 (y0 - y1)/h + m0 + m1) s^3/h^2`.
    fn cubic(&self, k: usize) -> Vec<Expr> {
        let (h, y, m) = self.ends(k);
        let ends = [y[0], y[1], m[0], m[1]];
        let square = combined([-3.0 / (h * h), 3.0 / (h * h), -2.0 / h, -1.0 / h], ends);
        let cube = combined([2.0 / (h * h * h), -2.0 / (h * h * h), 1.0 / (h * h), 1.0 / (h * h)], ends);
        vec![y[0], m[0], square, cube]
    }

    /// The second derivative of the cubics at point `k` between the ends: `2 (3 (y1 - y0)/h - 2 m0 - m1)/h`.
    fn bend(&self, k: usize) -> Expr {
        let (h, y, m) = self.ends(k);
        combined([-6.0 / (h * h), 6.0 / (h * h), -4.0 / h, -2.0 / h], [y[0], y[1], m[0], m[1]])
    }

    /// The quintic with the values, slopes and second derivatives of the two points. `y0 + m0 s + b0 s^2/2` misses at `h` the
    /// value by `d`, the slope by `e`, the second derivative by `f`; the other terms are
    /// `(10 d - 4 e h + f h^2/2) s^3/h^3 + (-15 d + 7 e h - f h^2) s^4/h^4 + (6 d - 3 e h + f h^2/2) s^5/h^5`.
    fn quintic(&self, k: usize, [b0, b1]: [Expr; 2]) -> Vec<Expr> {
        let (h, [y0, y1], [m0, m1]) = self.ends(k);
        let miss = combined([-1.0, 1.0, -h, -0.5 * h * h], [y0, y1, m0, b0]);
        let slope = combined([-1.0, 1.0, -h, 0.0], [m0, m1, b0, b0]);
        let bend = b1 - b0;
        let term = |power: i32, [of_miss, of_slope, of_bend]: [f64; 3]| {
            let scale = plm_math::f64::powi(h, -power);
            let weights = [of_miss * scale, of_slope * scale * h, of_bend * scale * h * h, 0.0];
            combined(weights, [miss, slope, bend, bend])
        };
        let high = [term(3, [10.0, -4.0, 0.5]), term(4, [-15.0, 7.0, -1.0]), term(5, [6.0, -3.0, 0.5])];
        [vec![y0, m0, scaled(0.5, b0)], high.to_vec()].concat()
    }

    /// Length, values and slopes of a segment.
    fn ends(&self, k: usize) -> (f64, [Expr; 2], [Expr; 2]) {
        (self.runs[k], [self.y[k], self.y[k + 1]], [self.slopes[k], self.slopes[k + 1]])
    }
}

/// Slopes at all points, zero at the ends, where the value is 1 at one point and 0 at the others.
///
/// `m[k-1]/h[k-1] + 2 m[k] (1/h[k-1] + 1/h[k]) + m[k+1]/h[k] = 3 (rise[k-1]/h[k-1]^2 + rise[k]/h[k]^2)`, by elimination.
fn slopes(runs: &[f64], of: usize) -> Vec<f64> {
    let count = runs.len() + 1;
    let value = |k: usize| if k == of { 1.0 } else { 0.0 };
    let (mut above, mut slopes) = (vec![0.0; count], vec![0.0; count]);
    for k in 1..count - 1 {
        let (before, after) = (1.0 / runs[k - 1], 1.0 / runs[k]);
        let rises = (value(k) - value(k - 1)) * before * before + (value(k + 1) - value(k)) * after * after;
        let pivot = 2.0 * (before + after) - before * above[k - 1];
        above[k] = after / pivot;
        slopes[k] = (3.0 * rises - before * slopes[k - 1]) / pivot;
    }
    for k in (1..count.saturating_sub(1)).rev() {
        slopes[k] -= above[k] * slopes[k + 1];
    }
    slopes
}

fn scaled(weight: f64, x: Expr) -> Expr {
    Expr::from(Number::from_f64(weight)) * x
}

fn combined(weights: [f64; 4], of: [Expr; 4]) -> Expr {
    weights.into_iter().zip(of).map(|(weight, x)| scaled(weight, x)).sum()
}

fn number_of(expr: Expr) -> f64 {
    expr.as_number().map_or(f64::NAN, Number::to_f64)
}
