//! Which of the mirror images of a loop assembly took.

use plm_cas::Expr;

use super::Assembly;
use crate::model::{FrameRef, Model, Pair, Part};

/// One line per revolute between two bodies: to which side the second body turns from the first.
///
/// The first body is seen from its other joint (or its G) to the pivot, the second from the pivot to its other joint
/// (or its G).
pub(crate) fn branches(model: &Model, found: &Assembly, at: &dyn Fn(Expr) -> f64) -> Vec<String> {
    let pose = Pose { model, found, at };
    model.parts.iter().filter_map(|part| pose.branch(part)).collect()
}

/// The assembled mechanism.
struct Pose<'a> {
    model: &'a Model,
    found: &'a Assembly,
    /// Value of a dimension.
    at: &'a dyn Fn(Expr) -> f64,
}

impl Pose<'_> {
    fn branch(&self, part: &Part) -> Option<String> {
        let &[a, b] = part.frames.as_slice() else { return None };
        let (first, second) = (a.body?, b.body?);
        if part.pair != Some(Pair::Revolute) {
            return None;
        }
        let pivot = self.point(a)?;
        let before = self.far_point(part, first);
        let after = self.far_point(part, second);
        let (ux, uy) = (pivot[0] - before[0], pivot[1] - before[1]);
        let (wx, wy) = (after[0] - pivot[0], after[1] - pivot[1]);
        let (cross, dot) = (ux * wy - uy * wx, ux * wx + uy * wy);
        let turn = plm_math::f64::atan2(cross, dot) * 180.0 / std::f64::consts::PI;
        let side = if cross >= 0.0 { "left" } else { "right" };
        let (first, second) = (&self.model.bodies[first].name.text, &self.model.bodies[second].name.text);
        Some(format!(
            "branch: at `{}`, `{second}` turns {side} from `{first}` by {:.2} deg",
            part.name.text,
            turn.abs()
        ))
    }

    /// The port of another joint on the body, or its G.
    fn far_point(&self, joint: &Part, body: usize) -> [f64; 2] {
        let others = self.model.parts.iter().filter(|other| other.pair.is_some() && other.name != joint.name);
        let frames = others.flat_map(|other| &other.frames);
        let other = frames.copied().find(|frame| frame.body == Some(body));
        let centre = [self.found.q[3 * body], self.found.q[3 * body + 1]];
        other.and_then(|frame| self.point(frame)).unwrap_or(centre)
    }

    /// Absolute position of a port of a body with literal dimensions.
    fn point(&self, frame: FrameRef) -> Option<[f64; 2]> {
        let body = frame.body?;
        let port = self.model.bodies[body].ports.get(frame.port)?;
        let [x, y] = port.at.map(|component| (self.at)(component));
        let [gx, gy, angle] =
            [self.found.q[3 * body], self.found.q[3 * body + 1], self.found.q[3 * body + 2]];
        let (sin, cos) = plm_math::f64::sin_cos(angle);
        Some([gx + cos * x - sin * y, gy + sin * x + cos * y])
    }
}
