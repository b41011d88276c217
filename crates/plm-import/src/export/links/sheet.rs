//! A sheet: links side by side, each with its first port at the origin and its farthest one to the right.

use super::region::{Path, Point, Region, add, sub};
use super::{Cutting, Link};
use crate::export::frames::turned;

/// Between two links, mm.
const GAP: f64 = 5.0;
/// Letters, mm.
const LETTERS: f64 = 4.0;

/// A link on a sheet, in mm.
pub(super) struct Placed {
    pub(super) name: String,
    pub(super) layer: usize,
    /// The outline, and holes.
    pub(super) paths: Vec<Path>,
    /// The middle of its name, and its height.
    pub(super) text: (Point, f64),
}

/// Links on a sheet, in mm.
pub(super) struct Sheet {
    /// Lowest and highest coordinates.
    pub(super) bounds: [Point; 2],
    pub(super) links: Vec<Placed>,
}

/// The place of a port of a link on its own sheet, mm.
pub(super) fn own_place(link: &Link, at: Point) -> Point {
    let origin = link.ports.first().map_or([0.0; 2], |(_, at)| *at);
    let far = |at: &Point| sub(*at, origin)[0].hypot(sub(*at, origin)[1]);
    let farthest = link.ports.iter().map(|(_, at)| *at).max_by(|a, b| far(a).total_cmp(&far(b)));
    let along = farthest.filter(|at| far(at) > 0.0).map_or(0.0, |at| {
        let [x, y] = sub(at, origin);
        y.atan2(x)
    });
    turned(sub(at, origin), -along).map(|part| 1e3 * part)
}

impl Sheet {
    /// A link alone, at its own place.
    pub(super) fn single(link: &Link, cutting: &Cutting) -> Sheet {
        let bounds = bounds(link, cutting);
        Sheet { bounds, links: vec![placed(link, [0.0; 2], cutting)] }
    }

    /// All links in rows, in their order.
    pub(super) fn all(links: &[Link], cutting: &Cutting) -> Sheet {
        let boxes: Vec<[Point; 2]> = links.iter().map(|link| bounds(link, cutting)).collect();
        let sizes = || boxes.iter().map(|[low, high]| sub(*high, *low));
        let area: f64 = sizes().map(|[width, height]| (width + GAP) * (height + GAP)).sum();
        let widest = sizes().map(|[width, _]| width).fold(1.5 * area.sqrt(), f64::max);
        let ([mut x, mut y], mut row, mut right) = ([0.0, 0.0], 0.0_f64, 0.0_f64);
        let mut on_sheet = Vec::new();
        for (link, [low, high]) in links.iter().zip(&boxes) {
            let [width, height] = sub(*high, *low);
            if x > 0.0 && x + width > widest {
                (x, y, row) = (0.0, y + row + GAP, 0.0);
            }
            on_sheet.push(placed(link, sub([x, y], *low), cutting));
            right = right.max(x + width);
            (x, row) = (x + width + GAP, row.max(height));
        }
        Sheet { bounds: [[0.0; 2], [right, y + row]], links: on_sheet }
    }
}

/// A region of a link on its own sheet, mm.
fn own(link: &Link, region: &Region) -> Region {
    Region { radius: 1e3 * region.radius, ..region.moved(|at| own_place(link, at)) }
}

fn bounds(link: &Link, cutting: &Cutting) -> [Point; 2] {
    let [low, high] = own(link, &link.outline).bounds();
    let cut = 1e3 * cutting.kerf / 2.0;
    [low.map(|part| part - cut), high.map(|part| part + cut)]
}

fn placed(link: &Link, by: Point, cutting: &Cutting) -> Placed {
    let cut = 1e3 * cutting.kerf / 2.0;
    let path = |region: &Region, by_cut: f64| own(link, region).moved(|at| add(at, by)).path(by_cut);
    let holes = link.holes.iter().map(|hole| path(hole, -cut));
    let [low, high] = bounds(link, cutting);
    let height = LETTERS.min((high[1] - low[1]) / 4.0);
    Placed {
        name: link.name.clone(),
        layer: link.layer,
        paths: [path(&link.outline, cut)].into_iter().chain(holes).collect(),
        text: (add(own(link, &link.outline).middle(), by), height),
    }
}
