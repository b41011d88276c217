//! The spanning tree of a mechanism, and the joints that close its loops.

use plm_compiler::Assembled;
use plm_compiler::span::Span;

use super::Export;
use super::frames::{Posed, sub, turned};
use super::pairs::{Acting, Kind, Pair};

/// A body in the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub(super) body: usize,
    /// The body that holds it; the ground where there is none.
    pub(super) parent: Option<usize>,
    /// The pair that holds it, and whether the body is the second one of it; none of a free body.
    pub(super) pair: Option<(usize, bool)>,
}

/// A spanning tree: parents stand in front of their children.
#[derive(Debug, Default)]
pub(super) struct Tree {
    pub(super) links: Vec<Link>,
    /// Pairs that close loops.
    pub(super) loops: Vec<usize>,
}

/// Motion of a joint with one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Motion {
    /// About the axis of the file that is −y, or the other way round.
    Hinge { sign: f64 },
    /// Along a direction of the plane.
    Slide { along: [f64; 2] },
}

/// A joint with one coordinate, from the parent to the child.
pub(super) struct Joint<'a> {
    pub(super) name: String,
    /// The pair that it belongs to.
    pub(super) label: &'a str,
    pub(super) span: Span,
    pub(super) motion: Motion,
    /// A point of its axis in the plane.
    pub(super) at: [f64; 2],
    /// Its coordinate in this pose.
    pub(super) coordinate: f64,
    pub(super) acting: &'a Acting,
}

impl Tree {
    /// A tree of all bodies but those that joints carry. A loop is closed by a revolute in which nothing acts, where it has one.
    pub(super) fn new(mechanism: &Assembled, pairs: &[Pair], carried: &[usize]) -> Tree {
        let mut order: Vec<usize> = (0..pairs.len()).collect();
        order.sort_by_key(|&k| match pairs[k].kind {
            Kind::Weld => 0,
            Kind::Prismatic => 1,
            Kind::PinSlot => 2,
            Kind::Revolute if !pairs[k].is_plain() => 3,
            Kind::Revolute => 4,
        });
        // The ground is behind the bodies.
        let ground = mechanism.bodies.len();
        let mut groups: Vec<usize> = (0..=ground).collect();
        let (mut branches, mut loops) = (vec![false; pairs.len()], Vec::new());
        for k in order {
            let [a, b] = pairs[k].frames.map(|frame| groups[frame.body.unwrap_or(ground)]);
            if a == b {
                loops.push(k);
                continue;
            }
            branches[k] = true;
            groups.iter_mut().filter(|group| **group == b).for_each(|group| *group = a);
        }
        loops.sort_unstable();
        let mut tree = Tree { links: Vec::new(), loops };
        tree.grow(None, pairs, &branches);
        for body in 0..ground {
            if tree.links.iter().all(|link| link.body != body) && !carried.contains(&body) {
                tree.links.push(Link { body, parent: None, pair: None });
                tree.grow(Some(body), pairs, &branches);
            }
        }
        tree
    }

    /// Adds all that hangs on a body, or on the ground.
    fn grow(&mut self, from: Option<usize>, pairs: &[Pair], branches: &[bool]) {
        let mut waiting = vec![from];
        while let Some(parent) = waiting.pop() {
            for (k, pair) in pairs.iter().enumerate().filter(|(k, _)| branches[*k]) {
                let ends = pair.frames.map(|frame| frame.body);
                let child = match ends {
                    [a, Some(b)] if a == parent => Some((b, true)),
                    [Some(a), b] if b == parent => Some((a, false)),
                    _ => None,
                };
                let is_known =
                    |body: usize| from == Some(body) || self.links.iter().any(|link| link.body == body);
                let Some((body, is_second)) = child.filter(|(body, _)| !is_known(*body)) else { continue };
                self.links.push(Link { body, parent, pair: Some((k, is_second)) });
                waiting.push(Some(body));
            }
        }
    }

    /// The poses with all joints at zero: the frames of each pair coincide. A free body stands at its start.
    pub(super) fn zero(&self, mechanism: &Assembled, pairs: &[Pair]) -> Vec<[f64; 3]> {
        let mut poses: Vec<[f64; 3]> = mechanism.bodies.iter().map(|body| body.pose).collect();
        for link in &self.links {
            let Some((pair, is_second)) = link.pair else { continue };
            let [a, b] = pairs[pair].frames;
            let (outer, own) = if is_second { (a, b) } else { (b, a) };
            let posed = Posed { mechanism, poses: &poses };
            let ([x, y, angle], [along, across, turn]) = (posed.frame(outer), posed.port(own));
            let angle = angle - turn;
            let [x, y] = sub([x, y], turned([along, across], angle));
            poses[link.body] = [x, y, angle];
        }
        poses
    }

    /// A sum of angles of bodies as a sum of angles of hinges, by the numbers of their pairs; none where a free body is in it.
    pub(super) fn in_hinges(&self, angles: &[(usize, f64)], pairs: &[Pair]) -> Option<Vec<(usize, f64)>> {
        let mut factors = angles.to_vec();
        let mut hinges = Vec::new();
        // Children come first: the angle of a body is that of its parent, and of its hinge.
        for link in self.links.iter().rev() {
            let factor: f64 =
                factors.iter().filter(|(body, _)| *body == link.body).map(|(_, factor)| factor).sum();
            if factor == 0.0 {
                continue;
            }
            let (pair, is_second) = link.pair?;
            if matches!(pairs[pair].kind, Kind::Revolute | Kind::PinSlot) {
                hinges.push((pair, if is_second { factor } else { -factor }));
            }
            factors.extend(link.parent.map(|parent| (parent, factor)));
        }
        Some(hinges)
    }

    /// All joints with a coordinate, at the start.
    pub(super) fn joints<'a>(&self, export: &'a Export) -> Vec<Joint<'a>> {
        let poses: Vec<[f64; 3]> = export.mechanism.bodies.iter().map(|body| body.pose).collect();
        let posed = Posed { mechanism: export.mechanism, poses: &poses };
        self.links.iter().flat_map(|link| link.joints(&export.pairs, posed)).collect()
    }
}

impl Link {
    /// The joints from its parent to it, at these poses; none of a weld and of a free body.
    pub(super) fn joints<'a>(&self, pairs: &'a [Pair], posed: Posed) -> Vec<Joint<'a>> {
        let Some((pair, is_second)) = self.pair else { return Vec::new() };
        let pair = &pairs[pair];
        let [a, b] = pair.frames.map(|frame| posed.frame(frame));
        let (sin, cos) = a[2].sin_cos();
        let between = [b[0] - a[0], b[1] - a[1]];
        // The first body of a pair rotates and slides against the second one in the opposite direction.
        let sign = if is_second { 1.0 } else { -1.0 };
        let joint = |name: String, motion, coordinate, acting| Joint {
            name,
            label: &pair.name,
            span: pair.span,
            motion,
            at: [b[0], b[1]],
            coordinate,
            acting,
        };
        let hinge = |name: String| joint(name, Motion::Hinge { sign }, b[2] - a[2], &pair.hinge);
        let along = Motion::Slide { along: [sign * cos, sign * sin] };
        let slide = |name: String| joint(name, along, cos * between[0] + sin * between[1], &pair.slide);
        let name = pair.name.clone();
        match pair.kind {
            Kind::Weld => Vec::new(),
            Kind::Prismatic => vec![slide(name)],
            Kind::Revolute => vec![hinge(name)],
            Kind::PinSlot if is_second => vec![slide(format!("{name}_slide")), hinge(name)],
            Kind::PinSlot => vec![hinge(format!("{name}_turn")), slide(name)],
        }
    }
}
