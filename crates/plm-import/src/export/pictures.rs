//! Pictures of bodies as boxes, which both formats have.

use plm_compiler::AssembledBody;

use super::frames::{add, sub, turned};

/// A box in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bar {
    /// Its middle, from G, in the axes of the body, m.
    pub(super) at: [f64; 2],
    /// The angle of its length, rad.
    pub(super) angle: f64,
    /// Half its length, width and depth, m.
    pub(super) half: [f64; 3],
}

/// Share of the size of a body that is the width of a bar.
const WIDTH: f64 = 0.04;

/// The boxes of a body: its outline where that is a rectangle, else the edges of the outline; without outline bars between its ports.
pub(super) fn bars(body: &AssembledBody) -> Vec<Bar> {
    if let Some(plate) = rectangle(&body.contour) {
        return vec![plate];
    }
    let ports: Vec<[f64; 2]> = body.ports.iter().map(|port| [port.place[0], port.place[1]]).collect();
    let contour = &body.contour;
    let ends: Vec<[[f64; 2]; 2]> = match (&contour[..], &ports[..]) {
        ([first, ..], _) => {
            let next = contour.iter().skip(1).chain([first]);
            contour.iter().zip(next).map(|(a, b)| [*a, *b]).collect()
        }
        ([], [first, others @ ..]) if !others.is_empty() => {
            others.iter().map(|port| [*first, *port]).collect()
        }
        ([], ports) => ports.iter().map(|port| [*port, [0.0; 2]]).collect(),
    };
    let size = ends.iter().map(|[a, b]| norm(sub(*b, *a))).fold(0.0, f64::max);
    let width = if size > 0.0 { WIDTH * size } else { WIDTH };
    let share = if contour.is_empty() { 1.0 } else { 0.25 };
    ends.into_iter().map(|[a, b]| bar(a, b, share * width)).collect()
}

fn norm([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// The box around the line from one point to another, with a width.
fn bar(a: [f64; 2], b: [f64; 2], width: f64) -> Bar {
    let along = sub(b, a);
    let middle = add(a, along.map(|part| part / 2.0));
    let half = [norm(along) / 2.0 + width / 2.0, width / 2.0, width / 2.0];
    Bar { at: middle, angle: along[1].atan2(along[0]), half }
}

/// The box of an outline that is a rectangle.
fn rectangle(contour: &[[f64; 2]]) -> Option<Bar> {
    let &[a, b, c, d] = contour else { return None };
    let (long, short) = (sub(b, a), sub(d, a));
    let [length, width] = [long, short].map(norm);
    let closes = norm(sub(add(b, short), c));
    let skew = long[0] * short[0] + long[1] * short[1];
    let is_right = closes < 1e-9 * (length + width) && skew.abs() < 1e-9 * length * width;
    let angle = long[1].atan2(long[0]);
    let middle = add(a, turned([length / 2.0, width / 2.0], angle));
    // The outline may go round to the right.
    let middle = if long[0] * short[1] > long[1] * short[0] {
        middle
    } else {
        add(a, turned([length / 2.0, -width / 2.0], angle))
    };
    (is_right && width > 0.0).then_some(Bar {
        at: middle,
        angle,
        half: [length / 2.0, width / 2.0, length.min(width) / 4.0],
    })
}
