//! The plane of a mechanism: all hinges stand across it, all slides lie in it.

use crate::notice::Notices;
use crate::space::{Vector, cross, dot, norm, scaled, sub, unit};
use crate::spatial::{Kind, Spatial};

/// Sine of an angle that counts as rounding of the file: π/2 is often written as 1.5708.
const PARALLEL: f64 = 2e-5;

/// Axes of a plane in the file's world. `x × y = normal`, towards the reader.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) x: Vector,
    pub(crate) y: Vector,
    pub(crate) normal: Vector,
}

impl Plane {
    /// The plane in which a mechanism moves.
    ///
    /// If two axes of the world lie in it, these are its axes. Else gravity acts along −y.
    pub(crate) fn of(spatial: &Spatial, notices: &mut Notices) -> Option<Plane> {
        let normal = normal(spatial, notices)?;
        let is_across = |axis: &Vector| dot(*axis, normal).abs() < PARALLEL;
        let world = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let within: Vec<Vector> = world.into_iter().filter(is_across).collect();
        if let [x, y] = within[..] {
            return Some(Plane { x, y, normal: cross(x, y) });
        }
        let up = sub(scaled(spatial.gravity, -1.0), scaled(normal, -dot(spatial.gravity, normal)));
        let y = unit(up).or_else(|| within.first().copied()).or_else(|| unit(cross(normal, world[0])))?;
        let x = cross(y, normal);
        let greatest = x
            .into_iter()
            .fold(0.0_f64, |greatest, part| if part.abs() > greatest.abs() { part } else { greatest });
        let (x, normal) = if greatest < 0.0 { (scaled(x, -1.0), scaled(normal, -1.0)) } else { (x, normal) };
        Some(Plane { x, y, normal })
    }

    pub(crate) fn flat(&self, v: Vector) -> [f64; 2] {
        [dot(v, self.x), dot(v, self.y)]
    }

    /// The name of an axis in the world of the file: `x`, `-y`, or its components.
    pub(crate) fn shown(axis: Vector) -> String {
        for (k, name) in ["x", "y", "z"].into_iter().enumerate() {
            if axis[k].abs() > 1.0 - PARALLEL {
                return if axis[k] > 0.0 { name.to_owned() } else { format!("-{name}") };
            }
        }
        format!("({})", axis.map(|part| crate::number::coarse(part, 1.0)).join(", "))
    }
}

fn normal(spatial: &Spatial, notices: &mut Notices) -> Option<Vector> {
    let of = |kind| spatial.joints.iter().filter(move |joint| joint.kind == kind);
    let slides: Vec<_> = of(Kind::Prismatic).collect();
    let crossed = || {
        let first = slides.first()?;
        slides.iter().find_map(|slide| {
            unit(cross(first.axis, slide.axis)).filter(|_| norm(cross(first.axis, slide.axis)) > PARALLEL)
        })
    };
    let first = of(Kind::Revolute).next();
    let upright = |axis: Vector| unit(cross(axis, spatial.gravity));
    let normal = first
        .map(|hinge| hinge.axis)
        .or_else(crossed)
        .or_else(|| slides.first().and_then(|slide| upright(slide.axis)))
        .or_else(|| slides.first().and_then(|slide| unit(cross(slide.axis, [1.0, 0.0, 0.0]))))
        .unwrap_or([0.0, -1.0, 0.0]);
    let mut is_planar = true;
    for hinge in of(Kind::Revolute).filter(|hinge| norm(cross(hinge.axis, normal)) > PARALLEL) {
        let of_first = first.map_or("", |first| first.name.as_str());
        notices.error(
            &hinge.place,
            format!(
                "the axis of hinge `{}` is not parallel to that of `{of_first}`: the mechanism is not planar",
                hinge.name
            ),
        );
        is_planar = false;
    }
    for slide in slides.iter().filter(|slide| dot(slide.axis, normal).abs() > PARALLEL) {
        notices.error(
            &slide.place,
            format!(
                "slide `{}` leads out of the plane of the hinges: the mechanism is not planar",
                slide.name
            ),
        );
        is_planar = false;
    }
    is_planar.then_some(normal)
}
