//! `<geom>`: solids, with mass and inertia of their material.

use super::Reader;
use super::compiler::from_z;
use crate::space::{Pose, add, norm, scaled, sub};
use crate::spatial::{Inertial, Shape, Solid};
use crate::xml::Element;

/// kg/m³, unless a geom says another one.
const DENSITY: f64 = 1000.0;

impl Reader<'_> {
    /// The solid of a styled geom at its place, and its mass with inertia in its own axes.
    pub(super) fn geom(&mut self, geom: &Element) -> Option<(Shape, Option<Inertial>)> {
        let kind = geom.get("type").unwrap_or("sphere");
        if matches!(kind, "plane" | "hfield") {
            return None;
        }
        if matches!(kind, "mesh" | "sdf") || geom.get("mesh").is_some() {
            self.notices.warn(&geom.place, format!("{}: meshes are not taken", geom.shown()));
            return None;
        }
        let size = geom.numbers("size", self.notices).unwrap_or_default();
        let ends = geom.exactly::<6>("fromto", self.notices);
        let (pose, half) = if let Some([a, b, c, d, e, f]) = ends {
            let (from, to) = ([a, b, c], [d, e, f]);
            let turn = from_z(sub(from, to))?;
            (Pose { turn, at: scaled(add(from, to), 0.5) }, Some(norm(sub(to, from)) / 2.0))
        } else {
            (self.placed(geom), None)
        };
        // With two ends the first length is that of both directions across them.
        let mut lengths = size;
        if let Some(half) = half {
            let across = lengths.first().copied().unwrap_or_default();
            let count = if matches!(kind, "capsule" | "cylinder") { 1 } else { 2 };
            lengths = vec![across; count];
            lengths.push(half);
        }
        let solid = match (kind, &lengths[..]) {
            ("sphere", [radius, ..]) if half.is_none() => Solid::Ellipsoid([*radius; 3]),
            ("capsule", [radius, half, ..]) => Solid::Capsule { radius: *radius, half: *half },
            ("cylinder", [radius, half, ..]) => Solid::Cylinder { radius: *radius, half: *half },
            ("box", [x, y, z, ..]) => Solid::Box([*x, *y, *z]),
            ("ellipsoid", [x, y, z, ..]) => Solid::Ellipsoid([*x, *y, *z]),
            _ => {
                self.notices
                    .error(&geom.place, format!("{}: a {kind} of this size is not known", geom.shown()));
                return None;
            }
        };
        let group = geom.number("group", self.notices).unwrap_or_default();
        let [first, last] = self.compiler.groups;
        let inertial = if group < first || group > last { None } else { self.weighed(geom, &solid) };
        Some((Shape { solid, pose }, inertial))
    }

    fn weighed(&mut self, geom: &Element, solid: &Solid) -> Option<Inertial> {
        if geom.get("shellinertia") == Some("true") {
            self.notices.error(&geom.place, format!("{}: the inertia of a shell is not taken", geom.shown()));
        }
        let (volume, moments) = moments(solid);
        let density = geom.number("density", self.notices).unwrap_or(DENSITY);
        let mass = geom.number("mass", self.notices).unwrap_or(density * volume);
        let [x, y, z] = moments.map(|moment| moment * mass);
        let tensor = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        (mass > 0.0).then_some(Inertial { mass, centre: [0.0; 3], tensor })
    }
}

/// Volume, and the moments of inertia of a mass of 1 about the axes.
fn moments(solid: &Solid) -> (f64, [f64; 3]) {
    use std::f64::consts::PI;
    match *solid {
        Solid::Box([x, y, z]) => {
            (8.0 * x * y * z, [(y * y + z * z) / 3.0, (x * x + z * z) / 3.0, (x * x + y * y) / 3.0])
        }
        Solid::Ellipsoid([x, y, z]) => (
            4.0 / 3.0 * PI * x * y * z,
            [(y * y + z * z) / 5.0, (x * x + z * z) / 5.0, (x * x + y * y) / 5.0],
        ),
        Solid::Cylinder { radius, half } => {
            let across = radius * radius / 4.0 + half * half / 3.0;
            (2.0 * PI * radius * radius * half, [across, across, radius * radius / 2.0])
        }
        Solid::Capsule { radius, half } => {
            // A cylinder, and two halves of a ball whose centres of gravity are 3/8 of the radius outside of its ends.
            let (cylinder, ball) = (2.0 * PI * radius * radius * half, 4.0 / 3.0 * PI * radius.powi(3));
            let share = cylinder / (cylinder + ball);
            let of_ball = 0.4 * radius * radius;
            let ends = of_ball + half * half + 0.75 * half * radius;
            let across = share * (radius * radius / 4.0 + half * half / 3.0) + (1.0 - share) * ends;
            (cylinder + ball, [across, across, share * radius * radius / 2.0 + (1.0 - share) * of_ball])
        }
    }
}
