//! Regions of the plane: polygons, and all that is within a radius of a convex one; their outlines, moved by half a cut.

/// A place in the plane, m.
pub(super) type Point = [f64; 2];

/// All places within a radius of a polygon, whose corners go round counter-clockwise.
///
/// One corner is a disc, two are a capsule. A radius other than zero stands round a convex polygon.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Region {
    pub(super) corners: Vec<Point>,
    pub(super) radius: f64,
}

/// A closed line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Path {
    Circle {
        at: Point,
        radius: f64,
    },
    /// Corners, each with the bulge of the line to the next one: the tangent of a quarter of the angle of its arc, zero of a straight one.
    Corners(Vec<(Point, f64)>),
}

/// Normals whose sum is shorter than this have no corner between them.
const SHARPEST: f64 = 0.2;

impl Region {
    /// The outline, moved outwards by a distance, inwards by a negative one.
    pub(super) fn path(&self, by: f64) -> Path {
        let (corners, radius) = (&self.corners, self.radius + by);
        if let [at] = corners[..] {
            return Path::Circle { at, radius };
        }
        let count = corners.len();
        let normal = |k: usize| {
            let [dx, dy] = sub(corners[(k + 1) % count], corners[k % count]);
            let length = dx.hypot(dy);
            [dy / length, -dx / length]
        };
        let is_round = self.radius > 0.0;
        let around = (0..count).flat_map(|k| {
            let [before, after] = [normal(k + count - 1), normal(k)];
            let at = |normal: Point| add(corners[k], normal.map(|part| radius * part));
            let (cosine, sine) = (dot(before, after), cross(before, after));
            let mitre = add(before, after).map(|part| part / (1.0 + cosine));
            if is_round {
                vec![(at(before), (sine.abs().atan2(cosine) / 4.0).tan()), (at(after), 0.0)]
            } else if by == 0.0 || 1.0 + cosine > SHARPEST {
                vec![(if by == 0.0 { corners[k] } else { at(mitre) }, 0.0)]
            } else {
                vec![(at(before), 0.0), (at(after), 0.0)]
            }
        });
        Path::Corners(around.collect())
    }

    /// The region, with its corners elsewhere.
    pub(super) fn moved(&self, to: impl Fn(Point) -> Point) -> Region {
        Region { corners: self.corners.iter().map(|at| to(*at)).collect(), radius: self.radius }
    }

    /// How far two regions are apart; negative by the sum of the radii where the polygons meet.
    pub(super) fn apart(&self, other: &Region) -> f64 {
        let is_in = |of: &Region, at: &Region| of.contains(at.corners[0]);
        let between = if is_in(self, other) || is_in(other, self) {
            0.0
        } else {
            let pairs = self.sides().flat_map(|side| other.sides().map(move |of| sides_apart(side, of)));
            pairs.fold(f64::INFINITY, f64::min)
        };
        between - self.radius - other.radius
    }

    /// Lowest and highest coordinates.
    pub(super) fn bounds(&self) -> [Point; 2] {
        let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        self.corners.iter().fold(start, |[low, high], at| {
            let to = |k: usize| (low[k].min(at[k] - self.radius), high[k].max(at[k] + self.radius));
            let ((x0, x1), (y0, y1)) = (to(0), to(1));
            [[x0, y0], [x1, y1]]
        })
    }

    /// The mean of the corners.
    pub(super) fn middle(&self) -> Point {
        let sum = self.corners.iter().copied().fold([0.0; 2], add);
        sum.map(|part| part / self.corners.len() as f64)
    }

    fn sides(&self) -> impl Iterator<Item = [Point; 2]> {
        let next = self.corners.iter().cycle().skip(1);
        self.corners.iter().zip(next).map(|(a, b)| [*a, *b])
    }

    /// Is a place within the polygon? By how often a ray to the right crosses its sides.
    fn contains(&self, [x, y]: Point) -> bool {
        let crosses = |[[x0, y0], [x1, y1]]: &[Point; 2]| {
            (*y0 > y) != (*y1 > y) && x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)
        };
        self.sides().filter(crosses).count() % 2 == 1
    }
}

/// The distance of two straight lines with ends.
fn sides_apart([a, b]: [Point; 2], [c, d]: [Point; 2]) -> f64 {
    let turn = |p: Point, q: Point, r: Point| cross(sub(q, p), sub(r, p));
    let crosses = turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0;
    if crosses {
        return 0.0;
    }
    let ends = [(a, [c, d]), (b, [c, d]), (c, [a, b]), (d, [a, b])];
    ends.into_iter().map(|(at, side)| from_side(at, side)).fold(f64::INFINITY, f64::min)
}

fn from_side(at: Point, [a, b]: [Point; 2]) -> f64 {
    let (along, to) = (sub(b, a), sub(at, a));
    let square = dot(along, along);
    let share = if square > 0.0 { (dot(to, along) / square).clamp(0.0, 1.0) } else { 0.0 };
    let [x, y] = sub(to, along.map(|part| share * part));
    x.hypot(y)
}

pub(super) fn add([a, b]: Point, [c, d]: Point) -> Point {
    [a + c, b + d]
}

pub(super) fn sub([a, b]: Point, [c, d]: Point) -> Point {
    [a - c, b - d]
}

fn dot([a, b]: Point, [c, d]: Point) -> f64 {
    a * c + b * d
}

fn cross([a, b]: Point, [c, d]: Point) -> f64 {
    a * d - b * c
}

#[cfg(test)]
mod tests {
    use super::{Path, Region};

    fn square(side: f64, radius: f64) -> Region {
        Region { corners: vec![[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]], radius }
    }

    /// The area within a closed line: its polygon, and a segment of the circle at each arc.
    fn area(path: &Path) -> f64 {
        let corners = match path {
            Path::Circle { radius, .. } => return std::f64::consts::PI * radius * radius,
            Path::Corners(corners) => corners,
        };
        let next = corners.iter().cycle().skip(1);
        let parts = corners.iter().zip(next).map(|(([x0, y0], bulge), ([x1, y1], _))| {
            let angle = 4.0 * bulge.atan();
            let radius =
                if angle == 0.0 { 0.0 } else { (x1 - x0).hypot(y1 - y0) / 2.0 / (angle / 2.0).sin() };
            0.5 * (x0 * y1 - y0 * x1 + radius * radius * (angle - angle.sin()))
        });
        parts.sum()
    }

    #[test]
    fn outlines_have_the_areas_of_steiner() {
        let pi = std::f64::consts::PI;
        // J. Steiner, 1840: area + circumference r + pi r^2.
        for (region, by, expected) in [
            (square(2.0, 0.5), 0.0, 4.0 + 8.0 * 0.5 + pi * 0.25),
            (square(2.0, 0.5), 0.1, 4.0 + 8.0 * 0.6 + pi * 0.36),
            (square(2.0, 0.0), 0.0, 4.0),
            (square(2.0, 0.0), 0.1, 2.2 * 2.2),
            (square(2.0, 0.0), -0.1, 1.8 * 1.8),
            (Region { corners: vec![[0.0, 0.0], [3.0, 4.0]], radius: 1.0 }, 0.0, 5.0 * 2.0 + pi),
            (Region { corners: vec![[3.0, 4.0]], radius: 1.0 }, -0.25, pi * 0.5625),
        ] {
            let found = area(&region.path(by));
            assert!((found - expected).abs() < 1e-14 * 50.0, "{region:?} {by}: {found} for {expected}");
        }
    }

    #[test]
    fn distances_are_those_of_the_polygons_less_the_radii() {
        let far = |[x, y]: [f64; 2]| [x + 5.0, y + 6.0];
        let pin = |at| Region { corners: vec![at], radius: 0.25 };
        assert!((square(2.0, 0.5).apart(&square(2.0, 0.0).moved(far)) - 4.5).abs() < 1e-15);
        assert_eq!(square(2.0, 0.0).apart(&pin([1.0, 1.0])), -0.25);
        assert_eq!(square(2.0, 0.0).apart(&pin([3.0, 1.0])), 0.75);
        assert_eq!(pin([0.0, 0.0]).apart(&pin([0.3, 0.4])), 0.0);
        // Two bars that cross, with all corners outside of each other.
        let bar = |corners: [[f64; 2]; 2]| Region { corners: corners.to_vec(), radius: 0.1 };
        let crossed = bar([[-1.0, 0.0], [1.0, 0.0]]).apart(&bar([[0.0, -1.0], [0.0, 1.0]]));
        assert_eq!(crossed, -0.2);
    }
}
