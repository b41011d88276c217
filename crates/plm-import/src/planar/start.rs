//! Starts: the poses at the coordinates that the file gives, and which of them are locked.

use super::{Host, Pair, PairKind, Planar};
use crate::spatial::Spatial;

/// A displacement of the plane: a turn about the origin, then a shift.
#[derive(Clone, Copy, Debug)]
struct Shift {
    angle: f64,
    by: [f64; 2],
}

impl Shift {
    const NONE: Shift = Shift { angle: 0.0, by: [0.0; 2] };

    /// A turn about a point.
    fn about(at: [f64; 2], angle: f64) -> Shift {
        let turned = Shift { angle, by: [0.0; 2] }.point(at);
        Shift { angle, by: [at[0] - turned[0], at[1] - turned[1]] }
    }

    fn point(&self, at: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        [cos * at[0] - sin * at[1] + self.by[0], sin * at[0] + cos * at[1] + self.by[1]]
    }

    /// This after `first`.
    fn after(&self, first: &Shift) -> Shift {
        Shift { angle: self.angle + first.angle, by: self.point(first.by) }
    }

    fn inverse(&self) -> Shift {
        let back = Shift { angle: -self.angle, by: [0.0; 2] };
        let by = back.point(self.by);
        Shift { angle: -self.angle, by: [-by[0], -by[1]] }
    }
}

/// Sets the starts of all bodies. In a tree the coordinate of each joint is locked; where there are loops nothing is, and the
/// positions are given too, so that assembly begins with the pose that is drawn. Gives the first body of each group that no joint holds.
pub(super) fn set(planar: &mut Planar, spatial: &Spatial) -> Vec<usize> {
    let mut free = Vec::new();
    let mut shifts: Vec<Option<Shift>> = vec![None; planar.bodies.len()];
    // Slides that only act hold nothing.
    let mut used: Vec<bool> = planar.pairs.iter().map(|pair| pair.kind == PairKind::Slide).collect();
    loop {
        let before = used.iter().filter(|used| **used).count();
        for k in 0..planar.pairs.len() {
            reach(planar, spatial, k, &mut shifts, &mut used);
        }
        if used.iter().filter(|used| **used).count() > before {
            continue;
        }
        // A group that nothing joins to the ground begins with its first body.
        let Some(next) = shifts.iter().position(Option::is_none) else { break };
        shifts[next] = Some(Shift::NONE);
        planar.bodies[next].locked = [true; 3];
        planar.bodies[next].given = [true; 3];
        planar.floats = true;
        free.push(next);
    }
    let is_tree = used.iter().all(|used| *used) && spatial.couplings.is_empty();
    for (body, shift) in planar.bodies.iter_mut().zip(shifts) {
        let shift = shift.unwrap_or(Shift::NONE);
        let [x, y] = shift.point([body.drawn[0], body.drawn[1]]);
        body.start = [x, y, body.drawn[2] + shift.angle];
        if !is_tree {
            (body.given, body.locked) = ([true; 3], [false; 3]);
        }
    }
    free
}

/// Sets the shift of one body of a pair from that of the other one, if only one of them has a shift.
fn reach(planar: &mut Planar, spatial: &Spatial, k: usize, shifts: &mut [Option<Shift>], used: &mut [bool]) {
    let pair = &planar.pairs[k];
    if used[k] {
        return;
    }
    let shift = |host: Host| match host {
        Host::Ground => Some(Shift::NONE),
        Host::Body(body) => shifts[body],
    };
    // In the direction from a to b, whatever the file calls parent.
    let step = step(planar, spatial, pair);
    let (new, made) = match (shift(pair.a.host), shift(pair.b.host), pair.a.host, pair.b.host) {
        (Some(of), None, _, Host::Body(new)) => (new, of.after(&step)),
        (None, Some(of), Host::Body(new), _) => (new, of.after(&step.inverse())),
        _ => return,
    };
    used[k] = true;
    shifts[new] = Some(made);
    let along = direction(planar, pair, made.angle);
    let body = &mut planar.bodies[new];
    let larger = usize::from(along[1].abs() > along[0].abs());
    match pair.kind {
        PairKind::Revolute => body.locked[2] = true,
        PairKind::Weld | PairKind::Slide => {}
        PairKind::Prismatic => {
            body.locked[larger] = true;
            body.given = [true; 3];
        }
        PairKind::Slot => {
            body.locked = [larger == 0, larger == 1, true];
            body.given = [true; 3];
        }
        PairKind::Upright => (body.locked, body.given) = ([true, true, false], [true; 3]),
    }
}

/// The displacement of `b` against `a`, in the pose that is drawn.
fn step(planar: &Planar, spatial: &Spatial, pair: &Pair) -> Shift {
    let joint = &spatial.joints[pair.joint];
    let q = joint.start - joint.drawn;
    match pair.kind {
        PairKind::Revolute if q != 0.0 => Shift::about(planar.plane.flat(joint.at), q),
        PairKind::Prismatic if q != 0.0 => {
            let axis = planar.plane.flat(joint.axis);
            Shift { angle: 0.0, by: [q * axis[0], q * axis[1]] }
        }
        _ => Shift::NONE,
    }
}

/// The direction of a slide in the plane, after a turn.
fn direction(planar: &Planar, pair: &Pair, turn: f64) -> [f64; 2] {
    let angle = planar.pose(pair.a.host)[2] + planar.port(pair.a).angle + turn;
    let (sin, cos) = angle.sin_cos();
    [cos, sin]
}
