//! Rounded hulls: the outline of a body with a `width`, which is the set of points within half of it of the convex hull of its ports.
//!
//! Such a set is the hull, a rectangle outside of each side, and a sector of the circle at each corner (J. Steiner, 1840; R. Schneider,
//! Convex Bodies, 2014, section 4.1). With the corners `p` counterclockwise, the sides `d` of the length `l` and the middle `m`, the
//! turn `phi` at a corner, and `n = -J d` the normal of a side times its length,
//!
//! ```text
//! (1)  area          = A + r sum l + pi r^2
//! (2)  first moment  = S + r sum l m + r^2/2 sum phi p
//! (3)  second moment = J + sum (r l m^2 + r l^3/12 + r^2 n.m + r^3 l) + r^2/2 sum phi p^2 + pi r^4/2
//! ```
//!
//! where A, S and J are those of the hull. One port is a disc, and two are a capsule, whose turns are half ones.

use plm_cas::Expr;
use plm_cas::algebra::Vec2;

use crate::collect::CollectVec;
use crate::resolve::declarations::plate::{Moments, moments_of};

/// Sides of a hull at which a port counts as lying on the side, in squares of the hull's size.
const STRAIGHT: f64 = 1e-12;

/// (1) to (3) about a point, of the corners of a hull in their order.
pub(crate) fn rounded(corners: &[Vec2], radius: Expr, about: Vec2) -> Moments {
    let from = corners.iter().map(|at| *at - about).collect_vec();
    let hull = if from.len() < 3 { Moments::ZERO } else { moments_of(corners, about) };
    let half = Expr::ONE / Expr::from(2);
    let Moments { mut area, mut first, mut second } = hull;
    area += Expr::pi() * radius.squared();
    second += half * Expr::pi() * radius.powi(4);
    let next = |k: usize| from[(k + 1) % from.len()];
    let sides = (0..from.len()).map(|k| next(k) - from[k]).collect_vec();
    for (k, (&at, &side)) in from.iter().zip(&sides).enumerate() {
        let before = sides[(k + sides.len() - 1) % sides.len()];
        let share = half * radius.squared() * turn(before, side, from.len());
        first += share * at;
        second += share * at.squared();
        // The side of a disc has no length.
        if from.len() > 1 {
            let (length, middle) = (side.squared().sqrt(), half * (at + next(k)));
            area += radius * length;
            first += radius * length * middle;
            second += radius * length * middle.squared() + radius * length.powi(3) / Expr::from(12)
                - radius.squared() * side.left().dot(middle)
                + radius.powi(3) * length;
        }
    }
    Moments { area, first, second }
}

/// The angle by which the outline turns at a corner.
fn turn(before: Vec2, after: Vec2, corners: usize) -> Expr {
    match corners {
        1 => Expr::from(2) * Expr::pi(),
        2 => Expr::pi(),
        _ => before.cross(after).atan2(before.dot(after)),
    }
}

/// Indices of the points that are corners of the convex hull of all, counterclockwise (A. M. Andrew, Another efficient algorithm for
/// convex hulls in two dimensions, Information Processing Letters 9, 1979). Points that lie on a side, or on a corner, are none.
pub(crate) fn corners(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order = (0..points.len()).collect_vec();
    order.sort_by(|&a, &b| {
        points[a][0].total_cmp(&points[b][0]).then(points[a][1].total_cmp(&points[b][1])).then(a.cmp(&b))
    });
    let spans = |axis: usize| {
        let along = || points.iter().map(move |point| point[axis]);
        along().fold(f64::MIN, f64::max) - along().fold(f64::MAX, f64::min)
    };
    let size = spans(0).max(spans(1));
    let least = STRAIGHT * size * size;
    // Where no coordinate differs.
    let Some((&first, &last)) = order.first().zip(order.last()).filter(|_| size > 0.0) else {
        return order.into_iter().take(1).collect_vec();
    };
    let is_left = |a: usize, b: usize, c: usize| {
        let [[ax, ay], [bx, by], [cx, cy]] = [points[a], points[b], points[c]];
        (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) > least
    };
    let chain = |order: &mut dyn Iterator<Item = usize>| {
        let mut chain: Vec<usize> = Vec::new();
        for point in order {
            while let [.., a, b] = chain[..] {
                if is_left(a, b, point) {
                    break;
                }
                chain.pop();
            }
            // A corner once.
            if chain.last().is_none_or(|&before| points[before] != points[point]) {
                chain.push(point);
            }
        }
        chain
    };
    let mut lower = chain(&mut order.iter().copied());
    let mut upper = chain(&mut order.iter().rev().copied());
    // The ends of both chains are the same two points.
    lower.retain(|&point| points[point] != points[last]);
    upper.retain(|&point| points[point] != points[first]);
    lower.extend(upper);
    lower
}

#[cfg(test)]
mod tests {
    use plm_cas::algebra::Vec2;
    use plm_cas::{Expr, Graph, Number};

    use super::{corners, rounded};
    use crate::collect::CollectVec;
    use crate::evaluated::value;
    use crate::resolve::declarations::plate::Moments;

    /// A number between -1 and 1, of a seed; half of them are special.
    struct Draw(u64);

    impl Draw {
        fn bits(&mut self) -> u64 {
            // Numerical Recipes, third edition, section 7.1.2.
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            self.0 >> 11
        }

        fn number(&mut self) -> f64 {
            let special = [0.0, 1.0, -1.0, 0.5];
            match self.bits() % 8 {
                which @ 0..4 => special[which as usize],
                _ => (self.bits() as f64 / (1_u64 << 53) as f64) * 2.0 - 1.0,
            }
        }
    }

    fn expr(value: f64) -> Expr {
        Expr::from(Number::from_f64(value))
    }

    fn of(points: &[[f64; 2]], radius: f64) -> [f64; 4] {
        Graph::new().enter(|| {
            let hull = corners(points);
            let places =
                hull.iter().map(|&k| Vec2::new(expr(points[k][0]), expr(points[k][1]))).collect_vec();
            let Moments { area, first, second } = rounded(&places, expr(radius), Vec2::ZERO);
            [area, first.x, first.y, second].map(|of| value(of, &[]))
        })
    }

    /// The distance of a point from a segment.
    fn away([x, y]: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
        let (d, p) = ([b[0] - a[0], b[1] - a[1]], [x - a[0], y - a[1]]);
        let square = d[0] * d[0] + d[1] * d[1];
        let along = if square > 0.0 { ((p[0] * d[0] + p[1] * d[1]) / square).clamp(0.0, 1.0) } else { 0.0 };
        (p[0] - along * d[0]).hypot(p[1] - along * d[1])
    }

    /// Cuts of a quadrature.
    const STRIPS: usize = 400;

    /// Lengths and moments of the outline's cut with vertical lines, added up by the midpoint rule. A cut is found by bisection of the
    /// distance from the hull, which is convex along the line. It knows no corner: a point is in a hull where it is in a triangle of
    /// three of the points, or near a segment of two.
    fn quadrature(points: &[[f64; 2]], radius: f64) -> [f64; 4] {
        let distance = |at: [f64; 2]| {
            let pairs = points.iter().flat_map(|a| points.iter().map(move |b| [*a, *b]));
            let least = pairs.map(|pair| away(at, pair)).fold(f64::MAX, f64::min);
            let cross =
                |a: [f64; 2], b: [f64; 2]| (a[0] - at[0]) * (b[1] - at[1]) - (a[1] - at[1]) * (b[0] - at[0]);
            let is_inside = points.iter().enumerate().any(|(i, &a)| {
                points[..i].iter().enumerate().any(|(j, &b)| {
                    points[..j].iter().any(|&c| {
                        let signs = [cross(a, b), cross(b, c), cross(c, a)];
                        signs.iter().all(|of| *of > 0.0) || signs.iter().all(|of| *of < 0.0)
                    })
                })
            });
            if is_inside { 0.0 } else { least }
        };
        let along = |axis: usize| {
            let all = || points.iter().map(move |point| point[axis]);
            [all().fold(f64::MAX, f64::min) - radius, all().fold(f64::MIN, f64::max) + radius]
        };
        let ([left, right], [bottom, top]) = (along(0), along(1));
        let mut sums = [0.0; 4];
        for strip in 0..STRIPS {
            // By the angle of a sine, in which the outline has no roots at its ends.
            let step = std::f64::consts::PI / STRIPS as f64;
            let (sin, cos) = ((strip as f64 + 0.5) * step - std::f64::consts::FRAC_PI_2).sin_cos();
            let x = 0.5 * (left + right) + 0.5 * (right - left) * sin;
            let width = 0.5 * (right - left) * cos * step;
            // The nearest point of the line, by ternary search.
            let (mut low, mut high) = (bottom, top);
            for _ in 0..80 {
                let [a, b] = [low + (high - low) / 3.0, high - (high - low) / 3.0];
                if distance([x, a]) <= distance([x, b]) { high = b } else { low = a }
            }
            let middle = 0.5 * (low + high);
            if distance([x, middle]) > radius {
                continue;
            }
            let end = |mut inside: f64, mut outside: f64| {
                for _ in 0..50 {
                    let half = 0.5 * (inside + outside);
                    if distance([x, half]) <= radius { inside = half } else { outside = half }
                }
                inside
            };
            let [y0, y1] = [end(middle, bottom - 1e-9), end(middle, top + 1e-9)];
            sums[0] += width * (y1 - y0);
            sums[1] += width * (y1 - y0) * x;
            sums[2] += width * 0.5 * (y1 * y1 - y0 * y0);
            sums[3] += width * ((y1 - y0) * x * x + (y1.powi(3) - y0.powi(3)) / 3.0);
        }
        sums
    }

    #[test]
    fn a_rounded_hull_has_the_moments_of_its_quadrature() {
        let mut draw = Draw(20_261_130);
        for case in 0..60 {
            let count = 1 + case % 6;
            let points = (0..count).map(|_| [draw.number(), draw.number()]).collect_vec();
            let radius = 0.1 + 0.5 * draw.number().abs();
            let (found, expected) = (of(&points, radius), quadrature(&points, radius));
            for (found, expected) in found.iter().zip(expected) {
                // The midpoint rule loses h^2/24 of the second derivative, h = pi/400, which is some times the moments, below 20.
                assert!((found - expected).abs() < 2e-4, "{case}: {points:?} {radius}: {found} {expected}");
            }
        }
    }

    #[test]
    fn a_disc_and_a_capsule_have_the_moments_of_tables() {
        let pi = std::f64::consts::PI;
        let [area, x, y, second] = of(&[[0.3, 0.4], [0.3, 0.4]], 0.2);
        assert!(
            (area - pi * 0.04).abs() < 1e-15
                && (x - 0.3 * area).abs() < 1e-15
                && (y - 0.4 * area).abs() < 1e-15
        );
        assert!((second - area * (0.02 + 0.25)).abs() < 1e-15);
        // A rectangle of 1 by 0.4, and a disc cut in two whose halves stand 1 apart; the centre of a half is 4r/(3 pi) from its cut.
        let [area, x, y, second] = of(&[[-0.5, 0.0], [0.0, 0.0], [0.5, 0.0]], 0.2);
        let disc = pi * 0.04;
        let halves = disc * 0.02 + disc * (0.25 + 2.0 * 0.5 * 4.0 * 0.2 / (3.0 * pi));
        assert!((area - (0.4 + disc)).abs() < 1e-15 && x.abs() < 1e-15 && y.abs() < 1e-15);
        assert!((second - (0.4 * (1.0 + 0.16) / 12.0 + halves)).abs() < 1e-15);
    }

    #[test]
    fn corners_are_those_of_the_hull() {
        let square = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5], [0.5, 0.0], [1.0, 1.0]];
        let found = corners(&square);
        assert_eq!(found.len(), 4);
        assert_eq!(
            found.iter().map(|&k| square[k]).collect_vec(),
            [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]
        );
        assert_eq!(corners(&[[1.0, 2.0], [1.0, 2.0]]).len(), 1);
        assert_eq!(corners(&[[0.0, 0.0], [0.0, 2.0], [0.0, 1.0]]), [0, 1]);
        assert!(corners(&[]).is_empty());
    }
}
