//! Mechanisms that are drawn by the places of their joints; lengths follow.

use super::Draft;
use crate::mechanisms::{bars, groups, six_bars, trees};
use crate::random::{Numbers as _, Random, round};
use crate::scene::{Frame, Kind, Scene, Shape};

/// Joints at random places, at least so far apart, m.
const APART: f64 = 0.2;

pub fn tree(random: &mut Random) -> Option<Draft> {
    let shapes: [&'static Shape; 4] =
        [&trees::tree_2::SHAPE, &trees::tree_3::SHAPE, &trees::tree_4::SHAPE, &trees::tree_5::SHAPE];
    let shape = *random.one_of(&shapes);
    place(shape, random, false)
}

pub fn four_bar(random: &mut Random) -> Option<Draft> {
    place(&bars::four_bar::SHAPE, random, true)
}

pub fn slider_crank(random: &mut Random) -> Option<Draft> {
    place(&bars::slider_crank::SHAPE, random, true)
}

pub fn shaper(random: &mut Random) -> Option<Draft> {
    place(&bars::shaper::SHAPE, random, true)
}

pub fn watt(random: &mut Random) -> Option<Draft> {
    let shape = if random.chance(0.5) { &six_bars::watt_1::SHAPE } else { &six_bars::watt_2::SHAPE };
    place(shape, random, true)
}

pub fn stephenson(random: &mut Random) -> Option<Draft> {
    let shapes: [&'static Shape; 3] =
        [&six_bars::stephenson_1::SHAPE, &six_bars::stephenson_2::SHAPE, &six_bars::stephenson_3::SHAPE];
    let shape = *random.one_of(&shapes);
    place(shape, random, true)
}

pub fn group(random: &mut Random) -> Option<Draft> {
    let butterfly = random.chance(0.5);
    let shape = if butterfly { &groups::butterfly::SHAPE } else { &groups::platform::SHAPE };
    place(shape, random, butterfly)
}

/// Draws places of all frames, then poses of all bodies, and puts ports where they belong.
fn place(shape: &'static Shape, random: &mut Random, driven: bool) -> Option<Draft> {
    let mut scene = Scene::of(shape);
    let mut places: Vec<(Frame, [f64; 3])> = Vec::new();
    let mut used: Vec<[f64; 2]> = Vec::new();
    for joint in shape.joints {
        let (a, b) = (scene.frame(joint.a), scene.frame(joint.b));
        let known = |frame: Frame| places.iter().find(|(other, _)| *other == frame).map(|(_, place)| *place);
        let there = known(b).or(known(a));
        let [x, y, _] = match there {
            Some(there) => there,
            None => somewhere(random, &mut used)?,
        };
        let (of_a, of_b) = if joint.kind == Kind::Revolute {
            ([x, y, 0.0], [x, y, 0.0])
        } else {
            let axis = random.between(-3.0, 3.0);
            let slide = random.between(-0.4, 0.4);
            ([x - slide * axis.cos(), y - slide * axis.sin(), axis], [x, y, axis])
        };
        for (frame, place) in [(a, of_a), (b, of_b)] {
            match places.iter_mut().find(|(other, _)| *other == frame) {
                // A port of two joints has one place; it takes the axis of the one that needs it.
                Some((_, known)) if joint.kind != Kind::Revolute => known[2] = place[2],
                Some(_) => {}
                None => places.push((frame, place)),
            }
        }
    }
    let mut q = Vec::new();
    for body in 0..scene.bodies.len() {
        let own: Vec<&[f64; 3]> =
            places.iter().filter(|((of, _), _)| *of == Some(body)).map(|(_, place)| place).collect();
        let count = own.len() as f64;
        let mean = [0, 1].map(|k| own.iter().map(|place| place[k]).sum::<f64>() / count);
        q.extend(mean.map(|place| place + random.between(-0.15, 0.15)));
        q.push(random.single(-3.0, 3.0));
    }
    for (frame, [x, y, axis]) in places {
        let [gx, gy, turn] = frame.0.map_or([0.0; 3], |body| [0, 1, 2].map(|k| q[3 * body + k]));
        let (s, c) = turn.sin_cos();
        let (dx, dy) = (x - gx, y - gy);
        *scene.port_mut(frame) = [c * dx + s * dy, c * dy - s * dx, axis - turn].map(round);
    }
    // Where a joint is a revolute its ports have no axis of their own.
    for joint in shape.joints.iter().filter(|joint| joint.kind == Kind::Revolute) {
        for frame in [joint.a, joint.b] {
            let slides = |other: &&crate::scene::JointShape| {
                other.kind != Kind::Revolute && (other.a == frame || other.b == frame)
            };
            if !shape.joints.iter().any(|other| slides(&other)) {
                let frame = scene.frame(frame);
                scene.port_mut(frame)[2] = 0.0;
            }
        }
    }
    let driver = scene.frame(shape.joints[0].b).0.map(|body| 3 * body + 2);
    Some(Draft { scene, q, driver: driver.filter(|_| driven), offset: None, flat: None })
}

/// A place that is not next to another.
fn somewhere(random: &mut Random, used: &mut Vec<[f64; 2]>) -> Option<[f64; 3]> {
    for _ in 0..100 {
        let place = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        if used.iter().all(|other| (place[0] - other[0]).hypot(place[1] - other[1]) > APART) {
            used.push(place);
            return Some([place[0], place[1], 0.0]);
        }
    }
    None
}
