//! Prescribed drives of linkages with decimal lengths beside their closed forms: where they can go no further, and where they are
//! until then.
//!
//! A crank `r1` at the origin is driven at a constant rate; a dyad of the bars `r2` and `r3`, or of `r2` and a guide, follows. The
//! circles about both ends of the dyad meet while the distance of its ends is between the difference and the sum of its bars.

use std::f64::consts::PI;

use plm::{Cause, Dop853, Fault, Mechanism, Method, RadauIia5, Rk4, Sim};

use crate::random::Random;

macro_rules! linkages {
    ($module:ident, $formulation:ident) => {
        pub mod $module {
            plm::mechanism! {
                pub FourBar {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param r3: m = 0.3 m;
                    param span: m = 0.4 m;
                    param from: rad = 1 rad;
                    param rate: rad/s = 1 rad/s;
                    ground { port a: (0, 0) m; port d: (span, 0 m); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); start angle: from; }
                    body coupler { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); }
                    body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (r3, 0 m); start x: span; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, coupler.b);
                    revolute jc(coupler.c, rocker.c);
                    revolute jd(ground.d, rocker.d);
                    constraint motor: crank.angle = from + rate*t;
                }
            }
            plm::mechanism! {
                pub SliderCrank {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param rail: m = 0.05 m;
                    param from: rad = 0 rad;
                    param rate: rad/s = 1 rad/s;
                    ground { port a: (0, 0) m; port g: (0 m, rail); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); start angle: from; }
                    body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); start x: r1; }
                    body slider { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start y: rail; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, rod.b);
                    revolute jc(rod.c, slider.c);
                    prismatic guide(ground.g, slider.c);
                    constraint motor: crank.angle = from + rate*t;
                }
            }
            plm::mechanism! {
                pub Pushed {
                    formulation: $formulation;
                    allow(W0001);
                    param r1: m = 0.1 m;
                    param r2: m = 0.3 m;
                    param rail: m = 0.05 m;
                    param from: m = 0.3 m;
                    param rate: m/s = 0.1 m/s;
                    ground { port a: (0, 0) m; port g: (0 m, rail); }
                    body crank { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (r1, 0 m); }
                    body rod { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (r2, 0 m); }
                    body slider { mass: 1 kg; inertia: 0.1 kg*m^2; port c: (0, 0) m; start x: from; start y: rail; }
                    revolute ja(ground.a, crank.a);
                    revolute jb(crank.b, rod.b);
                    revolute jc(rod.c, slider.c);
                    prismatic guide(ground.g, slider.c);
                    constraint motor: slider.x = from + rate*t;
                }
            }
        }
    };
}

linkages!(loops, loops);
linkages!(absolute, absolute);

/// Runs last so long, s.
const LENGTH: f64 = 2.0;
/// A lock-up is told so exactly, s and rad or m.
const EXACT: f64 = 1e-8;
/// Within so many evaluations behind the last step.
const AT_ONCE: u64 = 200;

/// A drive: what is held at a time, and by how much the dyad's ends are too near or too far, m: `reach` changes its sign at a lock-up.
#[derive(Clone, Copy, Debug)]
struct Drive {
    kind: usize,
    bars: [f64; 4],
    from: f64,
    rate: f64,
    left: bool,
}

impl Drive {
    fn draw(random: &mut Random) -> Option<Self> {
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

    fn held(&self, time: f64) -> f64 {
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
    fn lock(&self) -> Option<f64> {
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
    fn is_plain(&self) -> bool {
        let after = |time: f64| self.reach(self.held(time + 1e-3)) < -1e-6;
        let lock = self.lock();
        let ends =
            lock.map_or(self.reach(self.held(LENGTH)) > 1e-6, |lock| after(lock) && LENGTH - lock > 1e-6);
        ends && !self.touches(lock.unwrap_or(LENGTH))
    }

    /// Places of the dyad's two ends and of its middle joint.
    fn places(&self, time: f64, left: bool) -> [[f64; 2]; 3] {
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

/// Where two circles meet, to the left of the line from the first centre to the second, or to the right.
fn meet(a: [f64; 2], ra: f64, b: [f64; 2], rb: f64, left: bool) -> [f64; 2] {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let square = dx * dx + dy * dy;
    let along = 0.5 * (square + (ra - rb) * (ra + rb)) / square;
    let across = (ra * ra / square - along * along).max(0.0).sqrt() * if left { 1.0 } else { -1.0 };
    [a[0] + along * dx - across * dy, a[1] + along * dy + across * dx]
}

/// What came of a run: its end, the places of what the dyad joins, and evaluations.
struct Run {
    end: Result<(), Fault>,
    time: f64,
    places: [[f64; 2]; 2],
    evaluations: u64,
}

/// By a pace: intervals of this length; one that is not positive is the whole run at once.
fn run<M: Mechanism<S = f64>, I: Method<M>>(
    mut sim: Sim<M, I>,
    (until, pace): (f64, f64),
    places: impl Fn(&M::State) -> [[f64; 2]; 2],
) -> Run {
    use plm::Moment as _;
    let mut end = Ok(());
    if pace > 0.0 {
        let count = (until / pace).ceil() as u64;
        for k in 1..=count {
            let to = (k as f64 * pace).min(until);
            end = sim.step_to(to);
            if end.is_err() {
                break;
            }
        }
    } else {
        end = sim.step_to(until);
    }
    Run { end, time: sim.state().time(), places: places(sim.state()), evaluations: sim.stats().evaluations }
}

macro_rules! start {
    ($module:ident, $drive:expr, $method:expr, $how:expr) => {{
        let Drive { kind, bars: [r1, r2, r3, span], from, rate, left } = *$drive;
        let [b, c, _] = $drive.places(0.0, left);
        let angle = |from: [f64; 2], to: [f64; 2]| plm::Start::free((to[1] - from[1]).atan2(to[0] - from[0]));
        let (x, y) = (plm::Start::free(b[0]), plm::Start::free(b[1]));
        match kind {
            0 => {
                let mut m = $module::FourBar { r1, r2, r3, span, from, rate, ..$module::FourBar::new() };
                (m.start.crank.angle, m.start.coupler.x, m.start.coupler.y) = (plm::Start::free(from), x, y);
                m.start.coupler.angle = angle(b, c);
                m.start.rocker.x = plm::Start::free(span);
                m.start.rocker.angle = angle([span, 0.0], c);
                m.start_with($method).map(|sim| {
                    run(sim, $how, |s| {
                        let body = s.coupler();
                        [[body.x, body.y], [body.x + r2 * body.angle.cos(), body.y + r2 * body.angle.sin()]]
                    })
                })
            }
            1 => {
                let mut m =
                    $module::SliderCrank { r1, r2, rail: span, from, rate, ..$module::SliderCrank::new() };
                (m.start.crank.angle, m.start.rod.x, m.start.rod.y) = (plm::Start::free(from), x, y);
                m.start.rod.angle = angle(b, c);
                (m.start.slider.x, m.start.slider.y) = (plm::Start::free(c[0]), plm::Start::free(c[1]));
                m.start_with($method)
                    .map(|sim| run(sim, $how, |s| [[s.rod().x, s.rod().y], [s.slider().x, s.slider().y]]))
            }
            _ => {
                let mut m = $module::Pushed { r1, r2, rail: span, from, rate, ..$module::Pushed::new() };
                (m.start.crank.angle, m.start.rod.x, m.start.rod.y) = (angle([0.0, 0.0], b), x, y);
                m.start.rod.angle = angle(b, c);
                (m.start.slider.x, m.start.slider.y) = (plm::Start::free(c[0]), plm::Start::free(c[1]));
                m.start_with($method)
                    .map(|sim| run(sim, $how, |s| [[s.rod().x, s.rod().y], [s.slider().x, s.slider().y]]))
            }
        }
    }};
}

/// What is wrong with a case, if anything is.
fn judge(drive: &Drive, by: usize, pace: f64, absolute: bool) -> Option<String> {
    let lock = drive.lock();
    let go = |until: f64| {
        macro_rules! with {
            ($method:expr) => {
                if absolute {
                    start!(absolute, drive, $method, (until, pace))
                } else {
                    start!(loops, drive, $method, (until, pace))
                }
            };
        }
        match by {
            0 => with!(Dop853::default()),
            1 => with!(RadauIia5::new(1e-8)),
            _ => with!(Rk4::new(1e-3)),
        }
    };
    let run = match go(LENGTH) {
        Ok(run) => run,
        Err(fault) => return Some(format!("not started: {fault}")),
    };
    let known = drive.places(run.time, drive.left);
    let off = (0..2).fold(0.0_f64, |off, k| {
        off.max((run.places[k][0] - known[k][0]).abs()).max((run.places[k][1] - known[k][1]).abs())
    });
    // Next to the lock-up places have the root of the time's rounding.
    if !(off < 1e-5) {
        return Some(format!("off by {off:.1e} m at {} s", run.time));
    }
    match (lock, run.end) {
        (None, Ok(())) => None,
        (None, Err(fault)) => Some(format!("stopped, {fault}")),
        (Some(lock), Ok(())) => Some(format!("went on past {lock}")),
        (Some(lock), Err(fault)) => {
            let Cause::LockedAt { row, value, .. } = fault.cause else {
                return Some(format!("{fault}, known {lock} s"));
            };
            let whole = if drive.kind == 2 {
                value
            } else {
                value + ((drive.held(lock) - value) / (2.0 * PI)).round() * 2.0 * PI
            };
            let told = row.starts_with("motor")
                && (fault.time - lock).abs() < EXACT
                && (whole - drive.held(lock)).abs() < EXACT;
            if !told || lock - run.time > 0.02 {
                return Some(format!("{fault}, known {lock} s, stopped at {} s", run.time));
            }
            let before = go(run.time).map_or(0, |before| before.evaluations);
            let behind = run.evaluations.saturating_sub(before);
            (behind > AT_ONCE).then(|| format!("{behind} evaluations behind the last step"))
        }
    }
}

/// So many drives of a seed; whether all are right.
pub fn sweep(seed: u64, count: u64, verbose: bool) -> bool {
    let points = plm::batch::points((0..count).collect::<Vec<u64>>()).quiet();
    let runs = points.run(|number| {
        let mut random = Random::new(seed ^ 0x5eed, number);
        let drive = loop {
            if let Some(drive) = Drive::draw(&mut random).filter(Drive::is_plain) {
                break drive;
            }
        };
        let (by, pace) = (random.below(3), *random.one_of(&[0.0, 0.1, 0.01, 0.001]));
        let absolute = random.chance(0.5);
        let locks = drive.lock().is_some();
        Ok((
            locks,
            judge(&drive, by, pace, absolute)
                .map(|what| format!("{drive:?}, method {by}, {pace} s, absolute {absolute}: {what}")),
        ))
    });
    let (mut wrong, mut locks) = (0, 0);
    for (number, (locked, told)) in runs.values() {
        locks += u64::from(*locked);
        wrong += u64::from(told.is_some());
        if let Some(told) = told.as_ref().filter(|_| verbose) {
            println!("--seed {seed} drive {number}  {told}");
        }
    }
    println!("{count} prescribed drives, {locks} lock up, {wrong} wrong");
    wrong == 0
}
