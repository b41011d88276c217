//! Closed outlines of chains that meet at their ends.

use super::entities::Chain;
use crate::notice::Notices;
use crate::number::length;

/// Distance of ends that meet, by the size of the drawing.
const MEETING: f64 = 1e-6;

/// Joins chains at their ends, which may be apart by `gap`, until all are closed. A chain that stays open is reported: as an error if it
/// is wider than all closed ones (a contour with a gap), else as a warning (a line beside them, as an axis).
pub(super) fn closed(chains: Vec<Chain>, gap: f64, notices: &mut Notices) -> Option<Vec<Chain>> {
    let size = chains
        .iter()
        .flat_map(|chain| &chain.points)
        .flatten()
        .fold(0.0_f64, |size, part| size.max(part.abs()));
    let (mut done, mut open): (Vec<Chain>, Vec<Chain>) =
        chains.into_iter().filter(|chain| !chain.points.is_empty()).partition(|chain| chain.is_closed);
    let mut left = Vec::new();
    while let Some(chain) = open.pop() {
        match joined(chain, &mut open, gap.max(MEETING * size)) {
            Ok(chain) => done.push(chain),
            Err(chain) => left.push(chain),
        }
    }
    done.retain(|chain| chain.points.len() > 2);
    let widest = done.iter().map(extent).fold(0.0, f64::max);
    let mut is_closed = true;
    for chain in &left {
        let message = told(chain, &left);
        if extent(chain) > widest || done.is_empty() {
            notices.error(&chain.place, message);
            is_closed = false;
        } else {
            notices.warn(&chain.place, format!("{message}; it is left out"));
        }
    }
    is_closed.then_some(done)
}

/// A chain with all that meets its ends; closed, or as far as it comes.
fn joined(mut chain: Chain, open: &mut Vec<Chain>, gap: f64) -> Result<Chain, Chain> {
    let mut is_turned = false;
    loop {
        let (Some(&first), Some(&last)) = (chain.points.first(), chain.points.last()) else {
            return Err(chain);
        };
        if chain.points.len() > 2 && distance(first, last) <= gap {
            chain.points.pop();
            return Ok(chain);
        }
        let away = |other: &Chain| {
            let ends = [other.points.first(), other.points.last()];
            ends.into_iter().flatten().map(|&end| distance(end, last)).fold(f64::INFINITY, f64::min)
        };
        // The nearest: with a gap several may be near enough.
        let next = (0..open.len()).min_by(|&a, &b| away(&open[a]).total_cmp(&away(&open[b])));
        let Some(next) = next.filter(|&next| away(&open[next]) <= gap) else {
            if is_turned {
                return Err(chain);
            }
            // It may go on at its other end.
            chain.points.reverse();
            is_turned = true;
            continue;
        };
        let mut other = open.swap_remove(next);
        let starts = other.points.first().is_some_and(|&end| distance(end, last) <= away_of(&other, last));
        if !starts {
            other.points.reverse();
        }
        let meets =
            other.points.first().is_some_and(|&end| distance(end, last) <= MEETING * (1.0 + norm(last)));
        chain.points.extend(other.points.into_iter().skip(usize::from(meets)));
    }
}

/// The distance of the nearer end.
fn away_of(chain: &Chain, at: [f64; 2]) -> f64 {
    let ends = [chain.points.first(), chain.points.last()];
    ends.into_iter().flatten().map(|&end| distance(end, at)).fold(f64::INFINITY, f64::min)
}

/// Text for an open chain: its end, and the distance to the nearest other end.
fn told(chain: &Chain, all: &[Chain]) -> String {
    let (first, last) = (chain.points[0], chain.points[chain.points.len() - 1]);
    let others = all.iter().filter(|other| !std::ptr::eq(*other, chain)).map(|other| away_of(other, last));
    let own = if chain.points.len() > 2 { distance(first, last) } else { f64::INFINITY };
    let nearest = others.fold(own, f64::min);
    let [x, y] = last.map(length);
    let help = if nearest.is_finite() {
        // A little more, so that rounding does not keep it open.
        format!("; the next end is {} away: `--gap {}` closes it", short(nearest), short(1.01 * nearest))
    } else {
        String::new()
    };
    format!("the outline is open at ({x}, {y}){help}")
}

/// Three digits.
fn short(number: f64) -> String {
    crate::number::coarse(number, number)
}

/// The area of the box around a chain.
fn extent(chain: &Chain) -> f64 {
    let range = |k: usize| {
        let parts = || chain.points.iter().map(move |point| point[k]);
        parts().fold(f64::NEG_INFINITY, f64::max) - parts().fold(f64::INFINITY, f64::min)
    };
    range(0) * range(1)
}

fn norm(a: [f64; 2]) -> f64 {
    a[0].hypot(a[1])
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Does a point lie within a polygon (by crossings of a ray)?
pub(super) fn is_within(at: [f64; 2], polygon: &[[f64; 2]]) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(p, q)| {
        (p[1] > at[1]) != (q[1] > at[1]) && at[0] < p[0] + (at[1] - p[1]) / (q[1] - p[1]) * (q[0] - p[0])
    });
    crossed.count() % 2 == 1
}
