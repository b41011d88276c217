//! A drive in closed form: where the dyad is, and when it can go no further.

use plm_runtime::Start;

use super::LENGTH;
use crate::random::Random;

/// A drive: what is held at a time, and by how much the dyad's ends are too near or too far, m: `reach` changes its sign at a lock-up.
#[derive(Clone, Copy, Debug)]
pub struct Drive {
    pub kind: usize,
    pub bars: [f64; 4],
    pub from: f64,
    pub rate: f64,
    pub left: bool,
}

impl Drive {
    pub fn draw(random: &mut Random) -> Option<Self> {
        let digits = 10_f64.powi(1 + random.below(3) as i32);
        let mut decimal = |low: f64, high: f64| (random.between(low, high) * digits).round() / digits;
        let bars = [decimal(0.1, 0.6), decimal(0.1, 0.8), decimal(0.1, 0.8), decimal(0.1, 0.9)];
        let rail = decimal(-0.3, 0.3);
        let (from, speed) = (decimal(-3.0, 3.0), decimal(0.2, 2.0));
        let place = decimal(0.1, 1.0);
        let kind = random.below(3);
        let rate = if random.chance(0.5) { speed } else { -speed };
        let (from, bars) = match kind {
            0 => (from, bars),
            1 => (from, [bars[0], bars[1], 0.0, rail]),
            _ => (place, [bars[0], bars[1], 0.0, rail]),
        };
        let drive = Self { kind, bars, from, rate, left: random.chance(0.5) };
        // The start is away from a lock-up.
        (drive.reach(from) > 1e-3 && bars[0] > 0.05 && bars[1] > 0.05).then_some(drive)
    }

    /// Parameters in the order of its declaration.
    pub fn numbers(&self) -> Vec<f64> {
        let Self { kind, bars: [r1, r2, r3, span], from, rate, .. } = *self;
        if kind == 0 { vec![r1, r2, r3, span, from, rate] } else { vec![r1, r2, span, from, rate] }
    }

    /// Start values of its three bodies: x, y, angle, vx, vy, omega of each.
    pub fn starts(&self) -> [Start<f64>; 18] {
        let [b, c, d] = self.places(0.0, self.left);
        let angle = |from: [f64; 2], to: [f64; 2]| (to[1] - from[1]).atan2(to[0] - from[0]);
        let crank = if self.kind == 2 { angle([0.0, 0.0], b) } else { self.from };
        let last = if self.kind == 0 { [d[0], 0.0, angle(d, c)] } else { [c[0], c[1], 0.0] };
        let mut starts = [Start::free(0.0); 18];
        for (body, pose) in [[0.0, 0.0, crank], [b[0], b[1], angle(b, c)], last].into_iter().enumerate() {
            starts[6 * body..6 * body + 3].copy_from_slice(&pose.map(Start::free));
        }
        starts
    }

    pub fn held(&self, time: f64) -> f64 {
        self.from + self.rate * time
    }

    /// How far the dyad is from where it lies in one line, m.
    fn reach(&self, held: f64) -> f64 {
        let [r1, r2, r3, span] = self.bars;
        match self.kind {
            0 => {
                let apart = (r1 * held.cos() - span).hypot(r1 * held.sin());
                (r2 + r3 - apart).min(apart - (r2 - r3).abs())
            }
            1 => r2 - (r1 * held.sin() - span).abs(),
            _ => (r1 + r2 - held.hypot(span)).min(held.hypot(span) - (r1 - r2).abs()),
        }
    }

    /// The time at which it can go no further; none within the run. Fine steps, then halves.
    pub fn lock(&self) -> Option<f64> {
        let (steps, reach) = (4_000, |time: f64| self.reach(self.held(time)));
        let mut low = 0.0;
        for k in 1..=steps {
            let high = LENGTH * f64::from(k) / f64::from(steps);
            if reach(high) < 0.0 {
                let mut high = high;
                for _ in 0..80 {
                    let half = 0.5 * (low + high);
                    if reach(half) < 0.0 { high = half } else { low = half }
                }
                return Some(low);
            }
            low = high;
        }
        None
    }

    /// It touches a pose in which the dyad lies in one line, or nearly so: another check's matter.
    fn touches(&self, until: f64) -> bool {
        let steps = 20_000;
        let reach = |k: i32| self.reach(self.held(until * f64::from(k) / f64::from(steps)));
        (1..steps).any(|k| reach(k) < 1e-4 && reach(k) <= reach(k - 1) && reach(k) <= reach(k + 1))
    }

    /// A lock-up stands neither at the end of the run, where rounding decides, nor is one that the drive would only touch.
    pub fn is_plain(&self) -> bool {
        let after = |time: f64| self.reach(self.held(time + 1e-3)) < -1e-6;
        let lock = self.lock();
        let ends =
            lock.map_or(self.reach(self.held(LENGTH)) > 1e-6, |lock| after(lock) && LENGTH - lock > 1e-6);
        ends && !self.touches(lock.unwrap_or(LENGTH))
    }

    /// Places of the dyad's two ends and of its middle joint.
    pub fn places(&self, time: f64, left: bool) -> [[f64; 2]; 3] {
        let ([r1, r2, r3, span], held) = (self.bars, self.held(time));
        let b = [r1 * held.cos(), r1 * held.sin()];
        match self.kind {
            0 => {
                let d = [span, 0.0];
                [b, meet(b, r2, d, r3, left), d]
            }
            1 => {
                let along = (r2 * r2 - (b[1] - span).powi(2)).max(0.0).sqrt();
                let c = [b[0] + if left { along } else { -along }, span];
                [b, c, c]
            }
            _ => {
                let c = [held, span];
                [meet([0.0, 0.0], r1, c, r2, left), c, c]
            }
        }
    }
}

/// Intersection of two circles, to the left of the line from the first centre to the second, or to the right.
fn meet(a: [f64; 2], ra: f64, b: [f64; 2], rb: f64, left: bool) -> [f64; 2] {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = 0.5 * (square + (ra - rb) * (ra + rb)) / square;
    let across = (ra * ra / square - along * along).max(0.0).sqrt() * if left { 1.0 } else { -1.0 };
    [a[0] + along * dx - across * dy, a[1] + along * dy + across * dx]
}
