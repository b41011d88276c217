//! Layers of links: those that meet while the mechanism moves lie in different ones.

use super::region::Region;
use super::{Joint, Link};
use crate::export::frames::{add, turned};

/// Overlaps that are narrower than this are contacts, m.
const TOUCH: f64 = 1e-6;

/// A pin that passes through the layer of a link that it meets.
pub(super) struct Blocked {
    /// The joint, by number.
    pub(super) joint: usize,
    /// The link, by number.
    pub(super) link: usize,
}

/// The links of a mechanism while it moves.
pub(super) struct Motion<'a> {
    pub(super) links: &'a [Link],
    /// Of each moment the poses of all bodies.
    pub(super) poses: &'a [Vec<[f64; 3]>],
}

impl Motion<'_> {
    /// The layer of each link, from 1: the first one in which nothing is that it meets.
    pub(super) fn layers(&self) -> Vec<usize> {
        let mut layers: Vec<usize> = Vec::new();
        for (k, link) in self.links.iter().enumerate() {
            let met: Vec<usize> = (0..k)
                .filter(|&other| self.meet(link, &self.links[other]))
                .map(|other| layers[other])
                .collect();
            layers.push((1..=k).find(|layer| !met.contains(layer)).unwrap_or(k + 1));
        }
        layers
    }

    /// Do two links meet at any moment?
    fn meet(&self, a: &Link, b: &Link) -> bool {
        self.poses.iter().any(|poses| {
            let [of_a, of_b] = [a, b].map(|link| placed(&link.outline, poses[link.body]));
            are_near(&of_a, &of_b) && of_a.apart(&of_b) < -TOUCH
        })
    }

    /// Pins between layers that are no neighbours, and the links that they meet there. The ground lies in layer 0.
    pub(super) fn blocked(&self, joints: &[Joint], radius: f64) -> Vec<Blocked> {
        let mut found = Vec::new();
        for (number, joint) in joints.iter().enumerate() {
            let ends = joint.bodies.map(|body| self.layer_of(body));
            let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
            let Some((body, at)) = joint.at else { continue };
            let between =
                self.links.iter().enumerate().filter(|(_, link)| low < link.layer && link.layer < high);
            for (number_of_link, link) in between {
                let pin = Region { corners: vec![at], radius };
                let is_met = self.poses.iter().any(|poses| {
                    placed(&pin, poses[body]).apart(&placed(&link.outline, poses[link.body])) < -TOUCH
                });
                if is_met {
                    found.push(Blocked { joint: number, link: number_of_link });
                }
            }
        }
        found
    }

    fn layer_of(&self, body: Option<usize>) -> usize {
        self.links.iter().find(|link| Some(link.body) == body).map_or(0, |link| link.layer)
    }
}

/// A region of a body in the plane.
fn placed(region: &Region, [x, y, angle]: [f64; 3]) -> Region {
    region.moved(|at| add([x, y], turned(at, angle)))
}

/// Do the boxes round two regions meet?
fn are_near(a: &Region, b: &Region) -> bool {
    let [[low, high], [from, to]] = [a.bounds(), b.bounds()];
    (0..2).all(|k| low[k] <= to[k] && from[k] <= high[k])
}
