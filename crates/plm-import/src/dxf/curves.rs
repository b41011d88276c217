//! Points on arcs, ellipses and splines.

/// Degrees between two corners on a curve, at most.
const STEP: f64 = 5.0;
/// Corners between two knots of a spline, at most.
const MOST: usize = 512;

/// Corners between the ends of an arc that is given by its bulge: the tangent of a quarter of its angle.
pub(super) fn bulged(from: [f64; 2], to: [f64; 2], bulge: f64) -> Vec<[f64; 2]> {
    let chord = [to[0] - from[0], to[1] - from[1]];
    // From the middle of the chord to the centre, across the chord.
    let out = (1.0 - bulge * bulge) / (4.0 * bulge);
    let centre =
        [f64::midpoint(from[0], to[0]) - out * chord[1], f64::midpoint(from[1], to[1]) + out * chord[0]];
    let d = [from[0] - centre[0], from[1] - centre[1]];
    let start = d[1].atan2(d[0]).to_degrees();
    let mut points = arc(centre, d[0].hypot(d[1]), start, 4.0 * bulge.atan().to_degrees());
    points.pop();
    points.drain(..1.min(points.len()));
    points
}

/// Points on an arc with both ends; angles in degrees.
pub(super) fn arc(centre: [f64; 2], radius: f64, from: f64, sweep: f64) -> Vec<[f64; 2]> {
    ellipse(centre, [radius, 0.0], [0.0, radius], from, sweep)
}

/// Points on an ellipse with these half axes, with both ends; its parameter in degrees.
pub(super) fn ellipse(
    centre: [f64; 2],
    major: [f64; 2],
    minor: [f64; 2],
    from: f64,
    sweep: f64,
) -> Vec<[f64; 2]> {
    let count = (sweep.abs() / STEP).ceil().max(1.0) as u32;
    (0..=count)
        .map(|k| {
            let (sin, cos) = (from + sweep * f64::from(k) / f64::from(count)).to_radians().sin_cos();
            [0, 1].map(|i| centre[i] + cos * major[i] + sin * minor[i])
        })
        .collect()
}

/// A spline of a degree: knots, and control points with their weights.
#[derive(Debug)]
pub(super) struct Spline {
    pub(super) degree: usize,
    pub(super) knots: Vec<f64>,
    /// x, y and weight.
    pub(super) controls: Vec<[f64; 3]>,
}

impl Spline {
    /// Do the numbers belong together?
    pub(super) fn is_right(&self) -> bool {
        let Spline { degree, knots, controls } = self;
        (1..=20).contains(degree)
            && controls.len() > *degree
            && knots.len() == controls.len() + degree + 1
            && knots.is_sorted()
            && controls.iter().all(|[.., weight]| *weight > 0.0)
    }

    /// The point at a parameter within a span of knots (C. de Boor, On calculating with B-splines, 1972; in homogeneous coordinates).
    fn at(&self, span: usize, parameter: f64) -> [f64; 2] {
        let first = span - self.degree;
        let mut own: Vec<[f64; 3]> = self.controls[first..=span]
            .iter()
            .map(|[x, y, weight]| [x * weight, y * weight, *weight])
            .collect();
        for round in 1..=self.degree {
            for k in (round..=self.degree).rev() {
                let (low, high) = (self.knots[first + k], self.knots[span + 1 + k - round]);
                let share = if high > low { (parameter - low) / (high - low) } else { 0.0 };
                own[k] = [0, 1, 2].map(|i| (1.0 - share) * own[k - 1][i] + share * own[k][i]);
            }
        }
        let [x, y, weight] = own[self.degree];
        [x / weight, y / weight]
    }

    /// Points from its beginning to its end, dense enough that no two sides turn by more than the step.
    pub(super) fn points(&self) -> Vec<[f64; 2]> {
        let mut points: Vec<[f64; 2]> = Vec::new();
        for span in self.degree..self.controls.len() {
            let (from, to) = (self.knots[span], self.knots[span + 1]);
            if to <= from {
                continue;
            }
            let mut count = if self.degree == 1 { 1 } else { 4 };
            let within = loop {
                let share = |k: usize| from + (to - from) * k as f64 / count as f64;
                let within: Vec<[f64; 2]> = (0..=count).map(|k| self.at(span, share(k))).collect();
                if count >= MOST || self.degree == 1 || turns_little(&within) {
                    break within;
                }
                count *= 2;
            };
            let skipped = usize::from(!points.is_empty());
            points.extend(within.into_iter().skip(skipped));
        }
        points
    }
}

/// Do the sides of a line turn by no more than the step?
fn turns_little(points: &[[f64; 2]]) -> bool {
    points.windows(3).all(|window| {
        let side = |k: usize| [window[k + 1][0] - window[k][0], window[k + 1][1] - window[k][1]];
        let (a, b) = (side(0), side(1));
        let turn = (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
        turn.abs().to_degrees() <= STEP
    })
}

#[cfg(test)]
mod tests {
    use super::Spline;

    /// A quarter of a circle as a rational spline of degree 2 (L. Piegl and W. Tiller, The NURBS Book, 2nd ed., 7.5), and a cubic of Bézier,
    /// whose length of a polynomial is known at its middle.
    #[test]
    fn splines_have_their_closed_forms() {
        let half = core::f64::consts::FRAC_1_SQRT_2;
        let quarter = Spline {
            degree: 2,
            knots: vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0],
            controls: vec![[1.0, 0.0, 1.0], [1.0, 1.0, half], [0.0, 1.0, 1.0]],
        };
        assert!(quarter.is_right());
        let points = quarter.points();
        assert!(
            points.len() > 18 && points.iter().all(|[x, y]| (x.hypot(*y) - 1.0).abs() < 1e-14),
            "{points:?}"
        );
        let cubic = Spline {
            degree: 3,
            knots: vec![0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0],
            controls: vec![[0.0, 0.0, 1.0], [0.0, 4.0, 1.0], [8.0, 4.0, 1.0], [8.0, 0.0, 1.0]],
        };
        let points = cubic.points();
        // 8 (3 u^2 - 2 u^3), 12 u (1 - u).
        assert!(points.iter().any(|[x, y]| (x - 4.0).abs() < 1e-12 && (y - 3.0).abs() < 1e-12), "{points:?}");
    }
}
