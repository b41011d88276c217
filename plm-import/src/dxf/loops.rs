//! Closed outlines of chains that meet at their ends.

use super::entities::Chain;
use crate::notice::Notices;

/// Distance of ends that meet, by the size of the drawing.
const MEETING: f64 = 1e-6;

/// Joins chains at their ends until all are closed; tells of one that stays open.
pub(super) fn closed(chains: Vec<Chain>, notices: &mut Notices) -> Option<Vec<Chain>> {
    let size = chains
        .iter()
        .flat_map(|chain| &chain.points)
        .flatten()
        .fold(0.0_f64, |size, part| size.max(part.abs()));
    let meets = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) <= MEETING * size;
    let (mut done, mut open): (Vec<Chain>, Vec<Chain>) =
        chains.into_iter().partition(|chain| chain.is_closed);
    while let Some(mut chain) = open.pop() {
        while let (Some(&first), Some(&last)) = (chain.points.first(), chain.points.last()) {
            if chain.points.len() > 2 && meets(first, last) {
                chain.points.pop();
                break;
            }
            let next = open.iter().position(|other| {
                other.points.first().is_some_and(|&end| meets(end, last))
                    || other.points.last().is_some_and(|&end| meets(end, last))
            });
            let Some(next) = next else {
                let [x, y] = last.map(crate::number::length);
                notices.error(&chain.place, format!("the outline is open at ({x}, {y})"));
                return None;
            };
            let mut other = open.swap_remove(next);
            if !other.points.first().is_some_and(|&end| meets(end, last)) {
                other.points.reverse();
            }
            chain.points.extend(other.points.into_iter().skip(1));
        }
        done.push(chain);
    }
    done.retain(|chain| chain.points.len() > 2);
    Some(done)
}

/// Does a point lie within a polygon (by crossings of a ray)?
pub(super) fn is_within(at: [f64; 2], polygon: &[[f64; 2]]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(p, q)| {
        (p[1] > at[1]) != (q[1] > at[1]) && at[0] < p[0] + (at[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    });
    crossed.count() % 2 == 1
}
