//! Random cases: a mechanism with numbers, a start, loads, a method, and the way in which intervals are asked for.

mod linkages;
mod placed;
mod ruler;

use plm_runtime::Start;

use crate::mechanisms::{ENTRIES, Entry};
use crate::random::{Numbers as _, Random};
use crate::reference::dd::Dd;
use crate::reference::{Begin, assemble};
use crate::run::{By, EVERY, Pace};
use crate::scene::Scene;

/// Geometry that was drawn, not yet closed.
struct Draft {
    scene: Scene,
    /// Guessed poses, 3 numbers a body.
    q: Vec<f64>,
    /// The angle that drives, which is locked; none where there are more freedoms.
    driver: Option<usize>,
    /// By how much a length misses one with which bars lie in a line, as a fraction of the size.
    offset: Option<f64>,
    /// How far from such a pose it starts, rad.
    flat: Option<f64>,
}

/// A kind of case: its name, its share in a hundred, and how it is drawn.
pub struct Kind {
    pub name: &'static str,
    share: usize,
    draw: fn(&mut Random) -> Option<Draft>,
}

/// All kinds: those of lengths that `f64` has, whose shares add up to a hundred, and those of decimals, which are cases of their own.
pub const KINDS: [Kind; 17] = [
    Kind { name: "tree", share: 11, draw: placed::tree },
    Kind { name: "four-bar", share: 9, draw: placed::four_bar },
    Kind { name: "neutral four-bar", share: 11, draw: linkages::neutral_four_bar },
    Kind { name: "nearly neutral four-bar", share: 16, draw: linkages::nearly_neutral_four_bar },
    Kind { name: "slider-crank", share: 5, draw: placed::slider_crank },
    Kind { name: "slider-crank, r near l", share: 11, draw: linkages::slider_crank },
    Kind { name: "shaper", share: 4, draw: placed::shaper },
    Kind { name: "Watt six-bar", share: 7, draw: placed::watt },
    Kind { name: "Stephenson six-bar", share: 9, draw: placed::stephenson },
    Kind { name: "Newton group", share: 5, draw: placed::group },
    Kind { name: "ladder", share: 4, draw: linkages::ladder },
    Kind { name: "nearly neutral ladder", share: 4, draw: linkages::nearly_neutral_ladder },
    Kind { name: "third crank", share: 4, draw: linkages::third_crank },
    Kind { name: "decimal four-bar", share: 8, draw: linkages::decimal_four_bar },
    Kind { name: "decimal slider-crank", share: 3, draw: linkages::decimal_slider_crank },
    Kind { name: "decimal ladder", share: 3, draw: linkages::decimal_ladder },
    Kind { name: "decimal third crank", share: 2, draw: linkages::decimal_third_crank },
];

/// From this number on cases have lengths of plain decimals.
pub const DECIMALS: u64 = 1 << 32;

impl Kind {
    fn share(&self, decimal: bool) -> usize {
        if self.name.starts_with("decimal") == decimal { self.share } else { 0 }
    }
}

/// A case, complete.
pub struct Case {
    pub seed: u64,
    pub number: u64,
    pub kind: usize,
    pub entry: &'static Entry,
    pub scene: Scene,
    /// Rounded from the assembled state; what is locked is as it was drawn.
    pub begin: Begin,
    pub offset: Option<f64>,
    pub flat: Option<f64>,
    pub samples: usize,
    pub by: By,
    pub pace: Pace,
    /// The assembled state of the reference.
    pub state: (Vec<Dd>, Vec<Dd>),
}

impl Case {
    /// Case number so-and-so of a seed. Drafts that do not close are drawn again.
    pub fn new(seed: u64, number: u64) -> Self {
        let mut random = Random::new(seed, number);
        let kind = Self::kind_of(number);
        loop {
            let drawn = (KINDS[kind].draw)(&mut random);
            if let Some(case) =
                drawn.and_then(|draft| Self::complete((seed, number, kind), draft, &mut random))
            {
                return case;
            }
        }
    }

    /// The kind of a case, by its number alone. 37 has no divisor in common with
    /// the sum of their shares: kinds take turns.
    pub fn kind_of(number: u64) -> usize {
        let decimal = number >= DECIMALS;
        let shares = KINDS.iter().map(|kind| kind.share(decimal));
        let all: usize = shares.clone().sum();
        let place = (number % all as u64) as usize * 37 % all;
        let ends = shares.scan(0, |end, share| {
            *end += share;
            Some(*end)
        });
        ends.take_while(|end| *end <= place).count()
    }

    fn complete((seed, number, kind): (u64, u64, usize), draft: Draft, random: &mut Random) -> Option<Self> {
        let Draft { mut scene, q, driver, offset, flat } = draft;
        let entry = ENTRIES.iter().find(|entry| entry.shape.name == scene.shape.name)?;
        // Each near miss costs the reference a hundred steps.
        let lengths: &[f64] = if offset.is_some() { &[0.5, 1.0] } else { &[0.5, 1.0, 1.0, 1.5, 2.0] };
        let length = *random.one_of(lengths);
        let samples = (length / EVERY).round() as usize;
        let rests = random.chance(0.35);
        burden(&mut scene, random, length, &q);
        let speed = if rests { 0.0 } else { random.single(-8.0, 8.0) };
        let mut v = vec![0.0; q.len()];
        match driver {
            Some(driver) => v[driver] = speed,
            None if rests => {}
            None => v.iter_mut().for_each(|v| *v = random.single(-3.0, 3.0)),
        }
        let locked: Vec<usize> = driver.into_iter().collect();
        let state = assemble(&scene, &Begin { q: q.clone(), v: v.clone(), locked: locked.clone() }).ok()?;
        // A start that is thrown far by what was drawn is not the pose that was meant.
        let moved = state.0.iter().zip(&q).fold(0.0_f64, |moved, (new, old)| moved.max((new.hi - old).abs()));
        let fastest = state.1.iter().fold(0.0_f64, |fastest, v| fastest.max(v.hi.abs()));
        if moved > 0.05 || fastest > 60.0 {
            return None;
        }
        let rounded = |of: &[Dd]| of.iter().map(|value| value.hi).collect();
        let begin = Begin { q: rounded(&state.0), v: rounded(&state.1), locked };
        let by =
            if entry.every_method() && random.chance(0.5) { *random.one_of(&By::ALL) } else { By::Dop853 };
        let pace = *random.one_of(if number < DECIMALS { &Pace::ALL[..4] } else { &Pace::ALL });
        Some(Self { seed, number, kind, entry, scene, begin, offset, flat, samples, by, pace, state })
    }

    /// Start values for a declaration: of each body x, y, angle, vx, vy, omega.
    pub fn starts(&self) -> Vec<Start<f64>> {
        let Begin { q, v, locked } = &self.begin;
        let mut all = Vec::new();
        for body in 0..q.len() / 3 {
            for values in [q, v] {
                all.extend((3 * body..3 * body + 3).map(|i| {
                    if locked.contains(&i) { Start::locked(values[i]) } else { Start::free(values[i]) }
                }));
            }
        }
        all
    }

    /// True if numbers of this precision can tell which motion it is; `epsilon` is their unit in the last place of 1.
    pub fn decidable(&self, epsilon: f64) -> bool {
        // Lengths of 1.5 m that differ by four units in their last place are not equal, nor what a sum of four of them is off by.
        let least = 8.0 * epsilon;
        let offset = self.offset.unwrap_or(0.0).abs();
        // Near a flat pose images differ by the square of the angle, or by what the lengths differ. A start has the rounding of its
        // numbers: 1e-13 of the lengths in f64; in f32 by as many units in the last place.
        let apart = self.flat.map_or(1.0, |angle| offset + angle * angle);
        (offset == 0.0 || offset >= least) && apart >= 1e-13 * (epsilon / f64::EPSILON)
    }

    /// All that is needed to see what it is.
    pub fn describe(&self) -> String {
        let Self { seed, number, scene, begin, .. } = self;
        let mut text = format!(
            "--seed {seed} --case {number}: {} ({}), {:?}, {:?}, {} s, offset {:?}, flat {:?}, gravity {}, {:?}\n  ground {:?}",
            KINDS[self.kind].name,
            scene.shape.name,
            self.by,
            self.pace,
            self.samples as f64 * EVERY,
            self.offset,
            self.flat,
            scene.gravity,
            scene.load,
            scene.ground
        );
        for ((body, (name, _)), i) in scene.bodies.iter().zip(scene.shape.bodies).zip((0..).step_by(3)) {
            let (q, v) = (&begin.q[i..i + 3], &begin.v[i..i + 3]);
            text.extend([format!("\n  {name} {body:?} at {q:?} moves {v:?}")]);
        }
        for (joint, shape) in scene.joints.iter().zip(scene.shape.joints) {
            text.extend([format!("\n  {} {joint:?}", shape.name)]);
        }
        text
    }
}

/// Masses, springs, dampers, gravity, and a load that waits, begins and reverses.
fn burden(scene: &mut Scene, random: &mut Random, length: f64, q: &[f64]) {
    for body in &mut scene.bodies {
        body.mass = random.single(0.3, 3.0);
        body.inertia = crate::random::round(body.mass * random.between(0.02, 0.2));
    }
    scene.gravity = if random.chance(0.7) { 9.75 } else { 0.0 };
    let shape = scene.shape;
    for index in 0..scene.joints.len() {
        if random.chance(0.8) {
            continue;
        }
        let frames = [shape.joints[index].a, shape.joints[index].b].map(|frame| scene.frame(frame));
        let angle =
            |(body, port)| scene.port((body, port))[2] + body.map_or(0.0, |body: usize| q[3 * body + 2]);
        let turn = angle(frames[1]) - angle(frames[0]);
        let joint = &mut scene.joints[index];
        joint.stiffness = random.single(0.0, 20.0);
        joint.damping = if random.chance(0.5) { random.single(0.0, 0.3) } else { 0.0 };
        joint.rest = match shape.joints[index].kind {
            crate::scene::Kind::Revolute => crate::random::round(turn + random.between(-1.0, 1.0)),
            _ => random.single(-0.3, 0.3),
        };
    }
    if random.chance(0.5) {
        scene.load.push = random.single(-5.0, 5.0);
        scene.load.begin = if random.chance(0.3) { 0.0 } else { random.single(0.0, 0.5 * length) };
        scene.load.rise = random.single(0.05, 0.4 * length);
        scene.load.turn = random.single(0.2 * length, 0.9 * length);
        scene.load.fall = random.single(0.05, 0.4 * length);
        if random.chance(0.4) {
            // It rests until the load begins.
            scene.gravity = 0.0;
            scene.joints.iter_mut().for_each(|joint| joint.stiffness = 0.0);
        }
    }
}
