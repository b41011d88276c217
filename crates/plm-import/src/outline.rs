//! Outlines: projections of solids along the normal of the plane.

use crate::plane::Plane;
use crate::space::{Pose, Vector};
use crate::spatial::{Shape, Solid};

/// Corners of a circle in a picture.
const CORNERS: u32 = 12;

/// The picture of a solid, in the plane.
#[derive(Clone, Debug)]
pub(crate) enum Outline {
    Circle { at: [f64; 2], radius: f64 },
    Polygon(Vec<[f64; 2]>),
}

impl Outline {
    /// The picture of a shape of a link at `pose`; none of what has no extent.
    pub(crate) fn of(shape: &Shape, pose: &Pose, plane: &Plane) -> Option<Outline> {
        let pose = pose.of(&shape.pose);
        let centre = plane.flat(pose.at);
        let along = |k: usize| plane.flat([pose.turn[0][k], pose.turn[1][k], pose.turn[2][k]]);
        let is_seen_along = |k: usize| along(k).iter().all(|part| part.abs() < 1e-6);
        match shape.solid {
            Solid::Ellipsoid([a, b, c]) if a == b && b == c => return circle(centre, a),
            Solid::Cylinder { radius, .. } | Solid::Capsule { radius, .. } if is_seen_along(2) => {
                return circle(centre, radius);
            }
            _ => {}
        }
        let flat: Vec<[f64; 2]> =
            corners(&shape.solid).into_iter().map(|corner| plane.flat(pose.point(corner))).collect();
        let mut points = match shape.solid {
            // The picture of a ball is a circle, however it is turned.
            Solid::Capsule { radius, .. } => flat.iter().flat_map(|end| around(*end, radius)).collect(),
            _ => flat,
        };
        let hull = hull(&mut points);
        (hull.len() >= 3).then_some(Outline::Polygon(hull))
    }

    /// The area, by which the largest is found.
    pub(crate) fn area(&self) -> f64 {
        match self {
            Outline::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
            Outline::Polygon(points) => area(points),
        }
    }
}

fn circle(at: [f64; 2], radius: f64) -> Option<Outline> {
    (radius > 0.0).then_some(Outline::Circle { at, radius })
}

/// Signed area within a polygon, positive counter-clockwise.
pub(crate) fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>() / 2.0
}

fn around(at: [f64; 2], radius: f64) -> impl Iterator<Item = [f64; 2]> {
    (0..CORNERS).map(move |k| {
        let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / f64::from(CORNERS)).sin_cos();
        [at[0] + radius * cos, at[1] + radius * sin]
    })
}

/// Points whose convex hull is the solid; of a capsule the centres of its ends.
fn corners(solid: &Solid) -> Vec<Vector> {
    match *solid {
        Solid::Box([x, y, z]) => (0..8)
            .map(|k| {
                [
                    if k & 1 == 0 { x } else { -x },
                    if k & 2 == 0 { y } else { -y },
                    if k & 4 == 0 { z } else { -z },
                ]
            })
            .collect(),
        Solid::Capsule { half, .. } => vec![[0.0, 0.0, half], [0.0, 0.0, -half]],
        Solid::Cylinder { radius, half } => {
            around([0.0; 2], radius).flat_map(|[x, y]| [[x, y, half], [x, y, -half]]).collect()
        }
        Solid::Ellipsoid([a, b, c]) => (0..=CORNERS / 2)
            .flat_map(|ring| {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(ring) / f64::from(CORNERS)).sin_cos();
                around([0.0; 2], sin).map(move |[x, y]| [a * x, b * y, c * cos])
            })
            .collect(),
    }
}

/// The convex hull, counter-clockwise (A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions, 1979), without
/// points that lie on its sides.
pub(crate) fn hull(points: &mut [[f64; 2]]) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let size = points.iter().flatten().fold(0.0_f64, |size, part| size.max(part.abs()));
    let half = |points: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for &p in points {
            while let [.., a, b] = chain[..] {
                if (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-9 * size * size {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut points.iter());
    hull.extend(half(&mut points.iter().rev()));
    hull
}
