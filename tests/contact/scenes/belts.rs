//! A mass on a belt whose friction falls with the slip.

use plm::{Dop853, Mechanism as _};

use crate::near;
use crate::scene::{Given as _, Named as _};

scene! {
    /// R. Stribeck's curve: 0.4 at rest, 0.25 at great slips.
    pub Stribeck {
        part spring(on: body) {
            param damping: N*s/m;
            force on on: (-(100 N/m)*on.x - damping*on.vx, 0 N);
        }
        param damping: N*s/m = 3 N*s/m;
        body mass { mass: 1 kg; inertia: 1 kg*m^2; start vx: 0.1 m/s; }
        constraint level: mass.angle = 0;
        constraint height: mass.y = 0;
        spring spring(mass) { damping: damping; }
        friction slip: rate(mass.x - 0.1 m/s*t) within (9.81 N)*(0.25 + 0.15*exp(-abs(mass.vx - 0.1 m/s)/(0.1 m/s))) { static: (9.81 N)*0.4; }
    }
}

/// The same by steps of the classical method of Runge and Kutta, which end where the mass sticks and where it breaks away.
struct ByHand {
    damping: f64,
    time: f64,
    x: f64,
    v: f64,
    sticks: bool,
    changes: u32,
}

impl ByHand {
    const BELT: f64 = 0.1;
    const LOAD: f64 = 9.81;

    fn curve(slip: f64) -> f64 {
        Self::LOAD * (0.25 + 0.15 * (-slip / 0.1).exp())
    }

    fn step(&self, h: f64) -> [f64; 2] {
        let rate = |[x, v]: [f64; 2]| [v, -100.0 * x - self.damping * v + Self::curve(Self::BELT - v)];
        let at = |h: f64, [a, b]: [f64; 2]| [self.x + h * a, self.v + h * b];
        let a = rate([self.x, self.v]);
        let b = rate(at(0.5 * h, a));
        let c = rate(at(0.5 * h, b));
        let d = rate(at(h, c));
        at(h / 6.0, core::array::from_fn(|i| a[i] + 2.0 * (b[i] + c[i]) + d[i]))
    }

    fn run(&mut self, end: f64) {
        while self.time < end {
            if self.sticks {
                let breaks = (0.4 * Self::LOAD - self.damping * Self::BELT) / 100.0;
                let until = (self.time + (breaks - self.x) / Self::BELT).min(end);
                self.x += Self::BELT * (until - self.time);
                (self.time, self.v) = (until, Self::BELT);
                self.sticks = self.x < breaks - 1e-15;
                self.changes += u32::from(!self.sticks);
                continue;
            }
            let h = (end - self.time).min(1e-4);
            let holds = |h: f64| self.step(h)[1] < Self::BELT;
            let mut high = h;
            if !holds(h) && self.v < Self::BELT {
                let mut low = 0.0;
                for _ in 0..60 {
                    let half = 0.5 * (low + high);
                    *(if holds(half) { &mut low } else { &mut high }) = half;
                }
                self.sticks = true;
                self.changes += 1;
            }
            [self.x, self.v] = self.step(high);
            self.time += high;
        }
    }
}

/// Its slope at the speed of the belt is -9.81 0.15/(0.1 m/s) exp(-1) = -5.41 N s/m: with less damping it squeals, with more it comes
/// to rest beside the belt.
#[test]
fn a_belt_squeals_with_little_damping() {
    for (damping, squeals) in [(3.0, true), (6.0, false)] {
        let rest = ByHand::curve(0.1) / 100.0;
        let belt = Stribeck::new().with("damping", damping);
        let (x, v) = (rest + 1e-3, 0.0);
        let belt = belt.with_start("mass.x", x).with_start("mass.vx", v);
        let mut sim = belt.start_with(Dop853::new(1e-11)).unwrap();
        let mut known = ByHand { damping, time: 0.0, x, v, sticks: false, changes: 0 };
        for k in 1..=10 {
            let t = f64::from(k);
            sim.step_to(t).unwrap();
            known.run(t);
            near(sim.state_of("mass").x, known.x, 1e-10);
            near(sim.state_of("mass").vx, known.v, 1e-9);
        }
        assert_eq!(known.changes > 10, squeals);
        assert_eq!(sim.stats().switches, u64::from(known.changes));
    }
}
