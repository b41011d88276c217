//! Linkages of a crank and dyads in closed form: where their points are, and up to which angle of the crank they close.

use crate::draw::Draw;

/// A point of the plane, m.
pub(super) type Point = [f64; 2];

/// Two bars between two points that stand already; they meet to the left of the line from the first to the second, or to the right.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dyad {
    pub(super) ends: [usize; 2],
    pub(super) bars: [f64; 2],
    pub(super) left: bool,
}

/// A crank at the origin with its dyads. The points are those of the ground, the tip of the crank, and the pin of each dyad.
#[derive(Clone, Debug)]
pub(super) struct Linkage {
    pub(super) family: &'static str,
    pub(super) ground: Vec<Point>,
    pub(super) crank: (usize, f64),
    pub(super) dyads: Vec<Dyad>,
    /// By how much one of the dyads that are to be flat at once is longer than that, m.
    pub(super) off: f64,
}

impl Linkage {
    /// The place of the crank's tip among the points.
    pub(super) fn tip(&self) -> usize {
        self.ground.len()
    }

    /// Points at an angle of the crank; `None` from the first dyad on that does not close.
    pub(super) fn points(&self, angle: f64) -> Vec<Option<Point>> {
        let mut points: Vec<Option<Point>> = self.ground.iter().copied().map(Some).collect();
        let (at, length) = self.crank;
        let foot = self.ground[at];
        points.push(Some([foot[0] + length * angle.cos(), foot[1] + length * angle.sin()]));
        for dyad in &self.dyads {
            let pin = points[dyad.ends[0]].zip(points[dyad.ends[1]]).and_then(|(a, b)| dyad.pin(a, b));
            points.push(pin);
        }
        points
    }

    /// How far the dyad that is nearest to flat is from that, m; negative where one does not close.
    pub(super) fn reach(&self, angle: f64) -> f64 {
        let points = self.points(angle);
        let mut least = f64::INFINITY;
        for dyad in &self.dyads {
            let Some((a, b)) = points[dyad.ends[0]].zip(points[dyad.ends[1]]) else { break };
            least = least.min(dyad.reach(a, b));
        }
        least
    }

    /// The first angle on the way from `from` by `way` at which a dyad is flat: fine parts, then halves.
    pub(super) fn lock(&self, from: f64, way: f64) -> Option<f64> {
        let parts = 20_000;
        let angle = |k: f64| from + way * (k / f64::from(parts));
        let first = (1..=parts).map(f64::from).find(|k| self.reach(angle(*k)) < 0.0)?;
        let (mut low, mut high) = (first - 1.0, first);
        for _ in 0..80 {
            let half = 0.5 * (low + high);
            if self.reach(angle(half)) < 0.0 { high = half } else { low = half }
        }
        Some(angle(low))
    }

    /// The least reach up to an angle, at places where it is a minimum: there a dyad is touched, and its other branch may follow.
    pub(super) fn touched(&self, from: f64, way: f64) -> f64 {
        let reach: Vec<f64> =
            (0..=20_000).map(|k| self.reach(from + way * (f64::from(k) / 20_000.0))).collect();
        let lowest = reach.windows(3).filter(|of| of[1] <= of[0] && of[1] <= of[2]).map(|of| of[1]);
        lowest.fold(f64::INFINITY, f64::min)
    }
}

impl Dyad {
    /// The pin between its bars.
    fn pin(&self, a: Point, b: Point) -> Option<Point> {
        let ([ra, rb], [dx, dy]) = (self.bars, [b[0] - a[0], b[1] - a[1]]);
        let square = dx * dx + dy * dy;
        let along = 0.5 * (square + (ra - rb) * (ra + rb)) / square;
        let across = ra * ra / square - along * along;
        let across = if across >= 0.0 { across.sqrt() } else { return None };
        let across = if self.left { across } else { -across };
        Some([a[0] + along * dx - across * dy, a[1] + along * dy + across * dx])
    }

    fn reach(&self, a: Point, b: Point) -> f64 {
        let apart = (b[0] - a[0]).hypot(b[1] - a[1]);
        let [ra, rb] = self.bars;
        (ra + rb - apart).min(apart - (ra - rb).abs())
    }
}

/// A linkage whose dyads become flat one by one, or several at once.
pub(super) fn draw(draw: &mut Draw) -> Linkage {
    let crank = draw.number(0.05, 0.3, &[0.1, 0.06]);
    let off = *draw.one_of(&[0.0, 0.0, 0.0, 1e-12, 1e-9, 1e-6, 1e-3, -1e-9, -1e-6]);
    match draw.below(6) {
        0 => mirrored(draw, crank, off, false),
        1 => mirrored(draw, crank, off, true),
        2 => inversor(draw),
        3 => at_once(draw, crank, off),
        4 => copies(draw, crank, off),
        _ => chain(draw, crank),
    }
}

fn bars(draw: &mut Draw) -> [f64; 2] {
    let first = draw.number(0.1, 0.5, &[0.2, 0.3]);
    let second = if draw.chance(0.2) { first } else { draw.number(0.1, 0.5, &[0.25, 0.3]) };
    [first, second]
}

/// Two dyads of the same lengths on both sides of a line; a third one may join their pins.
fn mirrored(draw: &mut Draw, crank: f64, off: f64, joined: bool) -> Linkage {
    let far = draw.number(0.2, 0.5, &[0.4, 0.3]);
    let [first, second] = bars(draw);
    let mut dyads = vec![
        Dyad { ends: [1, 2], bars: [first, second], left: true },
        Dyad { ends: [1, 2], bars: [first, second + off], left: false },
    ];
    if joined {
        let side = draw.number(0.1, 0.5, &[second, 0.3]);
        let other = if draw.chance(0.7) { side } else { draw.number(0.1, 0.5, &[first]) };
        dyads.push(Dyad { ends: [3, 4], bars: [side, other], left: draw.chance(0.5) });
    }
    let family = if joined { "mirrored, joined" } else { "mirrored" };
    Linkage { family, ground: vec![[0.0, 0.0], [far, 0.0]], crank: (0, crank), dyads, off }
}

/// Peaucellier's: arms from a pin on the crank's circle, and a rhombus.
fn inversor(draw: &mut Draw) -> Linkage {
    let crank = draw.number(0.04, 0.08, &[0.06, 0.05]);
    let arm = draw.number(0.15, 0.25, &[0.2, 0.18]);
    let side = draw.number(0.08, 0.14, &[0.1, 0.12]);
    let dyads = vec![
        Dyad { ends: [0, 2], bars: [arm, side], left: true },
        Dyad { ends: [0, 2], bars: [arm, side], left: false },
        Dyad { ends: [3, 4], bars: [side, side], left: true },
    ];
    Linkage { family: "inversor", ground: vec![[0.0, 0.0], [crank, 0.0]], crank: (1, crank), dyads, off: 0.0 }
}

/// Dyads to several pins that are flat at one angle of the crank: one of the bars is what is left to the pin.
fn at_once(draw: &mut Draw, crank: f64, off: f64) -> Linkage {
    let count = 2 + draw.below(2);
    let angle = draw.number(0.3, 2.8, &[1.0, 0.5 * std::f64::consts::PI]);
    let tip = [crank * angle.cos(), crank * angle.sin()];
    let (mut ground, mut dyads) = (vec![[0.0, 0.0]], Vec::new());
    for k in 0..count {
        let pin = [draw.number(-0.5, 0.5, &[0.4, -0.4]), draw.number(-0.4, 0.4, &[0.0, 0.0, 0.3])];
        let apart = (pin[0] - tip[0]).hypot(pin[1] - tip[1]);
        let first = apart * draw.number(0.2, 0.8, &[0.5]);
        let stretched = draw.chance(0.7);
        let second = if stretched { apart - first } else { apart + first };
        let longer = if k == 0 { off } else { 0.0 };
        ground.push(pin);
        dyads.push(Dyad { ends: [count + 1, k + 1], bars: [first, second + longer], left: draw.chance(0.5) });
    }
    Linkage { family: "at once", ground, crank: (0, crank), dyads, off }
}

/// Two or three equal four-bars on one crank.
fn copies(draw: &mut Draw, crank: f64, off: f64) -> Linkage {
    let far = draw.number(0.2, 0.5, &[0.4, 0.3]);
    let [first, second] = bars(draw);
    let count = 2 + draw.below(2);
    let left = draw.chance(0.5);
    let dyads = (0..count).map(|k| {
        let longer = if k == 0 { off } else { 0.0 };
        Dyad { ends: [2, 1], bars: [first, second + longer], left }
    });
    Linkage {
        family: "copies",
        ground: vec![[0.0, 0.0], [far, 0.0]],
        crank: (0, crank),
        dyads: dyads.collect(),
        off,
    }
}

/// Dyads one after the other, each on the pin before it and the ground.
fn chain(draw: &mut Draw, crank: f64) -> Linkage {
    let count = 1 + draw.below(3);
    let ground: Vec<Point> = std::iter::once([0.0, 0.0])
        .chain((0..count).map(|k| [0.4 + 0.3 * k as f64, draw.number(-0.2, 0.2, &[0.0, 0.0])]))
        .collect();
    let dyads = (0..count)
        .map(|k| Dyad { ends: [count + 1 + k, k + 1], bars: bars(draw), left: draw.chance(0.5) })
        .collect();
    Linkage { family: "chain", ground, crank: (0, crank), dyads, off: 0.0 }
}
