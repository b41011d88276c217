//! Texts that find places where nothing else is.

use super::paper::{Paper, Point, beside};
use crate::svg::text_width;

/// Half the height of a line of text, in pixels.
const HALF_LINE: f64 = 8.0;
/// Cost of an overlap with another text; a covered dot of a shape costs 4.
const OF_A_TEXT: f64 = 40.0;
/// Directions that are tried, rad, the usual ones first.
const AROUND: [f64; 8] = [0.25, 0.75, 1.75, 1.25, 0.0, 1.0, 0.5, 1.5];
/// Distances between a text and its object that are tried, in pixels.
const BLANKS: [f64; 4] = [3.0, 10.0, 20.0, 32.0];

/// A text that is farther from its object has a line to it.
const NEAR: f64 = 15.0;

/// A text that belongs to a place.
#[derive(Clone, Debug)]
pub(super) struct Label {
    pub(super) text: String,
    pub(super) class: &'static str,
    pub(super) at: Point,
    /// Radius of its object, in pixels.
    pub(super) reach: f64,
}

/// Bounding box of a text.
#[derive(Clone, Copy, Debug)]
struct Place {
    middle: Point,
    half: Point,
    /// Line from the object to the box.
    lead: [Point; 2],
}

impl Place {
    fn holds(&self, dot: Point) -> bool {
        (0..2).all(|axis| (dot[axis] - self.middle[axis]).abs() < self.half[axis])
    }

    fn meets(&self, other: &Place) -> bool {
        (0..2).all(|k| (self.middle[k] - other.middle[k]).abs() < self.half[k] + other.half[k])
    }
}

/// Draws texts in their order, each at the place around what it names that covers the least; none goes left or right of
/// `edges`. A text that was written at the same place before is left out.
pub(super) fn draw(labels: &[Label], paper: &mut Paper, edges: [f64; 2]) {
    let mut taken: Vec<Place> = Vec::new();
    let mut written: Vec<&Label> = Vec::new();
    let shapes = paper.dots.clone();
    for label in labels {
        let apart = |other: &&Label| (0..2).map(|k| (other.at[k] - label.at[k]).abs()).sum::<f64>();
        if written.iter().any(|other| other.text == label.text && apart(other) < 12.0) {
            continue;
        }
        let place = best(label, &taken, &shapes, edges);
        let [from, to] = place.lead;
        if (to[0] - from[0]).hypot(to[1] - from[1]) > NEAR {
            paper.line("axis back", &place.lead);
        }
        paper.text(label.class, place.middle, &label.text);
        let corners = [[-1.0, -1.0], [1.0, 1.0]];
        paper.dots.extend(corners.map(|side| [0, 1].map(|k| place.middle[k] + side[k] * place.half[k])));
        taken.push(place);
        written.push(label);
    }
}

fn best(label: &Label, taken: &[Place], shapes: &[Point], edges: [f64; 2]) -> Place {
    let half = [0.5 * text_width(&label.text, size(label.class)) + 2.0, HALF_LINE];
    let places = BLANKS.iter().enumerate().flat_map(|(far, blank)| {
        AROUND.iter().enumerate().map(move |(turn, halves)| {
            let (angle, room) = (halves * std::f64::consts::PI, label.reach + blank);
            let edge = beside(label.at, angle, room);
            let (sin, cos) = angle.sin_cos();
            let middle = [edge[0] + outward(cos) * half[0], edge[1] - outward(sin) * half[1]];
            let lead = [beside(label.at, angle, label.reach), edge];
            (Place { middle, half, lead }, 6.0 * far as f64 + 0.3 * turn as f64)
        })
    });
    let cost = |place: &Place, habit: f64| {
        let covered = shapes.iter().filter(|dot| place.holds(**dot)).count() as f64;
        let texts = taken.iter().filter(|other| place.meets(other)).count() as f64;
        let beyond = (edges[0] - place.middle[0] + half[0]).max(place.middle[0] + half[0] - edges[1]);
        habit + 4.0 * covered + OF_A_TEXT * texts + 10.0 * beyond.max(0.0)
    };
    let mut found = (f64::INFINITY, Place { middle: label.at, half, lead: [label.at; 2] });
    for (place, habit) in places {
        let cost = cost(&place, habit);
        if cost < found.0 {
            found = (cost, place);
        }
    }
    found.1
}

/// Side of its point on which a box lies: 1 or -1 fully to a side, 0 centred.
fn outward(part: f64) -> f64 {
    if part.abs() < 0.1 { 0.0 } else { part.signum() }
}

/// Height of the letters of a class, in pixels.
pub(super) fn size(class: &str) -> f64 {
    if class.contains("small") { 11.0 } else { 13.0 }
}
