//! Linkages of bars whose lengths are whole numbers of a unit: those that lie flat somewhere, and those that miss it by little.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Draft;
use super::ruler::Ruler;
use crate::mechanisms::{bars, ladders, redundant};
use crate::random::{Numbers as _, Random, round};
use crate::scene::{Scene, Shape};

/// Offsets are spread over these.
const OFFSETS: (f64, f64) = (1e-15, 1e-2);
/// Starts next to flat are spread over these, rad.
const FLAT: (f64, f64) = (1e-9, 1e-1);

/// Intersection of two circles, to the left of the line from the first centre to the second, or to the right.
fn meet(a: [f64; 2], ra: f64, b: [f64; 2], rb: f64, left: bool) -> Option<[f64; 2]> {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = 0.5 * (square + (ra - rb) * (ra + rb)) / square;
    let rest = ra * ra / square - along * along;
    // Rounding may take a flat pose a little beyond the reach.
    if !(rest > -1e-12) {
        return None;
    }
    let across = rest.max(0.0).sqrt() * if left { 1.0 } else { -1.0 };
    Some([a[0] + along * dx - across * dy, a[1] + along * dy + across * dx])
}

/// A bar along the x axis of its body, from `-back` to `length - back` units; the far end misses by `offset`, m. Its length, m.
fn bar(scene: &mut Scene, body: usize, [back, length]: [f64; 2], offset: f64, ruler: Ruler) -> f64 {
    let ends = [-back, length - back].map(|units| ruler.metres(units));
    for (port, [place, rest]) in ends.into_iter().enumerate() {
        let place = if port == 1 { place + offset } else { place };
        scene.set_along((Some(body), port), [place, rest]);
    }
    let ports = &scene.bodies[body].ports;
    ports[1][0] - ports[0][0]
}

/// Pose of a bar from its ends.
fn pose(q: &mut Vec<f64>, from: [f64; 2], to: [f64; 2], back: f64) {
    let angle = (to[1] - from[1]).atan2(to[0] - from[0]);
    q.extend([from[0] + back * angle.cos(), from[1] + back * angle.sin(), angle]);
}

/// An angle of the crank: anywhere, or next to one at which bars lie flat.
fn angle(random: &mut Random, flat: f64) -> (f64, Option<f64>) {
    if random.chance(0.7) {
        return (random.single(-3.0, 3.0), None);
    }
    let off = random.logarithmic(FLAT.0, FLAT.1);
    (if flat == 0.0 { round(off) } else { flat + off }, Some(off))
}

pub fn neutral_four_bar(random: &mut Random) -> Option<Draft> {
    four_bar(random, 0.0, Ruler::Dyadic)
}

pub fn nearly_neutral_four_bar(random: &mut Random) -> Option<Draft> {
    let offset = random.logarithmic(OFFSETS.0, OFFSETS.1);
    four_bar(random, offset, Ruler::Dyadic)
}

pub fn decimal_four_bar(random: &mut Random) -> Option<Draft> {
    let ruler = Ruler::decimal(random);
    four_bar(random, 0.0, ruler)
}

fn four_bar(random: &mut Random, offset: f64, ruler: Ruler) -> Option<Draft> {
    let mut scene = Scene::of(&bars::four_bar::SHAPE);
    let [crank, coupler] = [0.25, 0.5].map(|least| ruler.draw(random, least, 1.5));
    let (rocker, span) = match random.below(6) {
        0..=2 => (crank, coupler),
        3 => (coupler, crank),
        4 => {
            let span = ruler.draw(random, 0.25, 1.5);
            (crank + span - coupler, span)
        }
        _ => {
            let span = ruler.draw(random, 0.25, 1.5);
            (crank + coupler - span, span)
        }
    };
    // Twins of more than one kind lie flat everywhere, or fold into a point.
    if !(0.2..=2.0).contains(&ruler.metres(rocker)[0]) || (crank == coupler && rocker == span) {
        return None;
    }
    let lengths = [crank, coupler, rocker];
    let backs = lengths.map(|length| Ruler::part(random, length, 0.2, 0.8));
    let missed = random.below(4);
    let long = [0, 1, 2].map(|body| {
        let offset = if missed == body { offset } else { 0.0 };
        bar(&mut scene, body, [backs[body], lengths[body]], offset, ruler)
    });
    let [span, rest] = ruler.metres(span);
    let span = if missed == 3 { span + offset } else { span };
    scene.set_along((None, 1), [span, rest]);
    let backs = backs.map(|back| ruler.metres(back)[0]);
    let (theta, flat) = angle(random, 0.0);
    let (a, d) = ([0.0, 0.0], [span, 0.0]);
    let b = [long[0] * theta.cos(), long[0] * theta.sin()];
    let c = meet(b, long[1], d, long[2], random.chance(0.5))?;
    let mut q = Vec::new();
    pose(&mut q, a, b, backs[0]);
    q[2] = theta;
    pose(&mut q, b, c, backs[1]);
    pose(&mut q, d, c, backs[2]);
    Some(Draft { scene, q, driver: Some(2), offset: (offset != 0.0).then_some(offset), flat })
}

/// A slider-crank whose rod is as long as its crank, or misses that; a third of the offsets are exactly zero.
pub fn slider_crank(random: &mut Random) -> Option<Draft> {
    let offset = if random.chance(0.3) { 0.0 } else { random.logarithmic(OFFSETS.0, OFFSETS.1) };
    slider_crank_of(random, offset, Ruler::Dyadic)
}

pub fn decimal_slider_crank(random: &mut Random) -> Option<Draft> {
    let ruler = Ruler::decimal(random);
    slider_crank_of(random, 0.0, ruler)
}

fn slider_crank_of(random: &mut Random, offset: f64, ruler: Ruler) -> Option<Draft> {
    let mut scene = Scene::of(&bars::slider_crank::SHAPE);
    let length = ruler.draw(random, 0.25, 1.0);
    let back = [0.0; 2].map(|_| Ruler::part(random, length, 0.2, 0.8));
    let missed = random.below(3);
    let [crank, rod] = [0, 1].map(|body| {
        let offset = if missed == body { offset } else { 0.0 };
        bar(&mut scene, body, [back[body], length], offset, ruler)
    });
    let back = back.map(|back| ruler.metres(back)[0]);
    let rail = if missed == 2 { offset } else { 0.0 };
    scene.ground[1] = [0.0, rail, 0.0];
    let (theta, flat) = angle(random, FRAC_PI_2);
    let b = [crank * theta.cos(), crank * theta.sin()];
    let reach = rod * rod - (b[1] - rail) * (b[1] - rail);
    if !(reach > -1e-12) {
        return None;
    }
    let side = if random.chance(0.5) { 1.0 } else { -1.0 };
    let c = [b[0] + side * reach.max(0.0).sqrt(), rail];
    let mut q = Vec::new();
    pose(&mut q, [0.0, 0.0], b, back[0]);
    q[2] = theta;
    pose(&mut q, b, c, back[1]);
    q.extend([c[0], c[1], 0.0]);
    Some(Draft { scene, q, driver: Some(2), offset: (offset != 0.0).then_some(offset), flat })
}

pub fn ladder(random: &mut Random) -> Option<Draft> {
    rungs(random, 0.0, Ruler::Dyadic)
}

pub fn nearly_neutral_ladder(random: &mut Random) -> Option<Draft> {
    let offset = random.logarithmic(OFFSETS.0, OFFSETS.1);
    rungs(random, offset, Ruler::Dyadic)
}

pub fn decimal_ladder(random: &mut Random) -> Option<Draft> {
    let ruler = Ruler::decimal(random);
    rungs(random, 0.0, ruler)
}

/// A ladder of two to five windows, each a rectangle; one post misses its length.
#[allow(clippy::unnecessary_wraps, reason = "kinds are drawn by functions of one type")]
fn rungs(random: &mut Random, offset: f64, ruler: Ruler) -> Option<Draft> {
    let shapes: [&'static Shape; 4] = [
        &ladders::ladder_2::SHAPE,
        &ladders::ladder_3::SHAPE,
        &ladders::ladder_4::SHAPE,
        &ladders::ladder_5::SHAPE,
    ];
    let windows = random.below(4) + 2;
    let mut scene = Scene::of(shapes[windows - 2]);
    let one = ruler.units(1.0);
    let [high, wide] = [(); 2].map(|()| if random.chance(0.5) { one } else { ruler.draw(random, 0.5, 1.5) });
    let missed = 1 + random.below(windows);
    for post in 0..=windows {
        let offset = if post == missed { offset } else { 0.0 };
        bar(&mut scene, post, [0.5 * high, high], offset, ruler);
        scene.set_along((None, post), ruler.metres(post as f64 * wide));
    }
    for rung in 1..=windows {
        bar(&mut scene, windows + rung, [0.5 * wide, wide], 0.0, ruler);
    }
    let [high, wide] = [high, wide].map(|units| ruler.metres(units)[0]);
    let theta = random.single(0.2, 2.9) * if random.chance(0.5) { 1.0 } else { -1.0 };
    let foot = |post: usize| [post as f64 * wide, 0.0];
    let top = |post: usize| [foot(post)[0] + high * theta.cos(), high * theta.sin()];
    let mut q = Vec::new();
    for post in 0..=windows {
        pose(&mut q, foot(post), top(post), 0.5 * high);
    }
    q[2] = theta;
    for rung in 1..=windows {
        pose(&mut q, top(rung - 1), top(rung), 0.5 * wide);
    }
    Some(Draft { scene, q, driver: Some(2), offset: (offset != 0.0).then_some(offset), flat: None })
}

pub fn third_crank(random: &mut Random) -> Option<Draft> {
    cranks(random, Ruler::Dyadic)
}

pub fn decimal_third_crank(random: &mut Random) -> Option<Draft> {
    let ruler = Ruler::decimal(random);
    cranks(random, ruler)
}

/// Three parallel cranks: what the third says, the first two say already.
#[allow(clippy::unnecessary_wraps, reason = "kinds are drawn by functions of one type")]
fn cranks(random: &mut Random, ruler: Ruler) -> Option<Draft> {
    let mut scene = Scene::of(&redundant::third_crank::SHAPE);
    let [length, beam] = [0.25, 0.5].map(|least| ruler.draw(random, least, 1.5));
    let (third, rise) = (ruler.draw(random, 0.1, 2.0), ruler.draw(random, -0.5, 0.5));
    for body in [0, 2, 3] {
        bar(&mut scene, body, [0.5 * length, length], 0.0, ruler);
    }
    let back = 0.5 * beam;
    bar(&mut scene, 1, [back, beam], 0.0, ruler);
    scene.set_along((Some(1), 2), ruler.metres(third - back));
    scene.bodies[1].ports[2][1] = ruler.metres(rise)[0];
    let feet = [[0.0, 0.0], [beam, 0.0], [third, rise]];
    for (port, foot) in feet.into_iter().enumerate() {
        scene.set_along((None, port), ruler.metres(foot[0]));
        scene.ground[port][1] = ruler.metres(foot[1])[0];
    }
    let feet = feet.map(|foot| foot.map(|units| ruler.metres(units)[0]));
    let [length, back] = [length, back].map(|units| ruler.metres(units)[0]);
    // Three feet in a line leave it flat twice a turn; else it is regular everywhere.
    let (theta, flat) = if rise == 0.0 { angle(random, 0.0) } else { (random.single(-PI, PI), None) };
    let top = |foot: [f64; 2]| [foot[0] + length * theta.cos(), foot[1] + length * theta.sin()];
    let mut q = Vec::new();
    pose(&mut q, feet[0], top(feet[0]), 0.5 * length);
    q[2] = theta;
    pose(&mut q, top(feet[0]), top(feet[1]), back);
    pose(&mut q, feet[1], top(feet[1]), 0.5 * length);
    pose(&mut q, feet[2], top(feet[2]), 0.5 * length);
    Some(Draft { scene, q, driver: Some(2), offset: None, flat })
}
