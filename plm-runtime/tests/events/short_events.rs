//! Conditions that last shorter than a step: whatever is asked for, they are found.

use core::f64::consts::PI;

use plm_runtime::method::{Dopri5, Method, RadauIia5};
use plm_runtime::{
    Cause, Constraints, Dop853, Dual, Enclosed, Events, Fault, Health, Labels, Linear, Mechanism, Rate, Real,
    Rk4, Scalar, SemiImplicitEuler, Sim,
};

use crate::linkage::At;
use crate::random::Random;

/// A thing that moves at the speed `rate` and is counted while its guard is not positive: state [place, speed, seconds].
#[derive(Clone, Copy, Debug)]
struct Gate<S> {
    guard: Guard,
    rate: S,
    /// Where it is (or when), or the angle at the start.
    at: S,
    /// How wide it is, or how deep.
    wide: S,
    must_hold: bool,
}

/// Guards that can be written down: how often they are passed, and how long each time, is known.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Guard {
    /// (x - at)^2 > wide^2.
    Parabola,
    /// sqrt((x - at)^2 + wide^2) > sqrt(2) wide.
    Distance,
    /// exp(-((x - at) / wide)^2) < 1/e.
    Bell,
    /// sin(x + at) < cos(wide), by the state.
    Turn,
    /// sin(rate t + at) < cos(wide), by the time alone.
    Time,
    /// 1 / (1 + ((x - at) / wide)^2) < 1/2.
    Quotient,
    /// (x - at) (x - at - wide) > 0, as two factors that are not bounded together.
    Product,
}

const GUARDS: [Guard; 7] = [
    Guard::Parabola,
    Guard::Distance,
    Guard::Bell,
    Guard::Turn,
    Guard::Time,
    Guard::Quotient,
    Guard::Product,
];

/// 1 - cos(wide) without cancellation is 2 sin(wide/2)^2.
fn guard<S: Scalar>(gate: &Gate<S>, t: S, x: S) -> S {
    let (one, two) = (S::lit(1.0), S::lit(2.0));
    let (off, wide) = (x - gate.at, gate.wide);
    let crest = |angle: S| {
        let (low, half) = ((S::lit(0.5) * (angle - S::lit(PI / 2.0))).sin(), (S::lit(0.5) * wide).sin());
        two * (low * low - half * half)
    };
    match gate.guard {
        Guard::Parabola => off * off - wide * wide,
        Guard::Distance => (off * off + wide * wide).sqrt() - two.sqrt() * wide,
        Guard::Bell => S::lit((-1.0_f64).exp()) - (-(off / wide).powi(2)).exp(),
        Guard::Turn => crest(x + gate.at),
        Guard::Time => crest(gate.rate * t + gate.at),
        Guard::Quotient => S::lit(0.5) - one / (one + (off / wide).powi(2)),
        Guard::Product => off * (off - wide),
    }
}

impl<S: Real> Rate for Gate<S> {
    type S = S;
    type X = [S; 3];
    type U = S;
    const NQ: usize = 1;

    fn rate(&self, _t: S, side: &S, x: &[S; 3], dx: &mut [S; 3]) -> Health<S> {
        let inside = *side < S::ZERO;
        *dx = [x[1], S::ZERO, if inside { S::lit(1.0) } else { S::ZERO }];
        Health::perfect()
    }
}

impl<S: Real> Constraints for Gate<S> {}

impl<S: Real> Events for Gate<S> {
    type G = [S; 1];
    fn guards(&self, t: S, side: &S, x: &[S; 3], g: &mut [S; 1]) {
        *g = [*side * guard(self, t, x[0])];
    }
    fn guards_within(
        &self,
        t: Enclosed<S>,
        side: &S,
        x: &impl Fn(usize) -> Enclosed<S>,
        each: &mut impl FnMut(usize, Enclosed<S>),
    ) -> bool {
        let constant = Enclosed::constant;
        let gate = Gate {
            guard: self.guard,
            rate: constant(self.rate),
            at: constant(self.at),
            wide: constant(self.wide),
            must_hold: self.must_hold,
        };
        each(0, constant(*side) * guard(&gate, t, x(0)));
        true
    }
    fn switch(&self, _t: S, side: &mut S, _x: &mut [S; 3], _index: usize) -> Result<(), Fault> {
        *side = -*side;
        Ok(())
    }
    fn must_hold(&self, _index: usize) -> bool {
        self.must_hold
    }
}

impl<S: Real> Labels for Gate<S> {
    fn guard_name(&self, _index: usize) -> &'static str {
        "gate"
    }
}

impl<S: Real> Linear for Gate<S> {
    type Lifted<const K: usize> = Gate<Dual<S, K>>;
    type In<T: Real> = Gate<T>;
    type Derivatives = [[S; 3]; 3];

    fn lift<const K: usize>(&self, side: &S) -> (Gate<Dual<S, K>>, Dual<S, K>) {
        self.in_numbers(side, Dual::constant)
    }

    fn in_numbers<T: Real>(&self, side: &S, number: impl Fn(S) -> T) -> (Gate<T>, T) {
        let gate = Gate {
            guard: self.guard,
            rate: number(self.rate),
            at: number(self.at),
            wide: number(self.wide),
            must_hold: self.must_hold,
        };
        (gate, number(*side))
    }
}

impl<S: Real> Mechanism for Gate<S> {
    type Rescue = plm_runtime::singular::Never<Self>;
    type State = At<Self>;

    fn start_state(&self, t: S) -> Result<(S, [S; 3]), Fault> {
        let x = [S::ZERO, self.rate, S::ZERO];
        let mut g = [S::ZERO];
        self.guards(t, &S::lit(1.0), &x, &mut g);
        Ok((if g[0] < S::ZERO { S::lit(-1.0) } else { S::lit(1.0) }, x))
    }
}

/// Length of the runs, s.
const RUN: f64 = 10.0;

/// Runs to the end in intervals of `interval`.
fn run<I: Method<Gate<f64>>>(gate: Gate<f64>, method: I, interval: f64) -> Result<Sim<Gate<f64>, I>, Fault> {
    let mut sim = gate.start_with(method)?;
    while sim.time < RUN {
        sim.step(interval.min(RUN - sim.time))?;
    }
    Ok(sim)
}

/// A random gate, how often its edges are passed, and how long it lasts in all.
fn random_gate(random: &mut Random) -> (Gate<f64>, u64, f64) {
    let mut unit = || 0.5 + 0.5 * random.unit();
    let guard = GUARDS[(unit() * GUARDS.len() as f64) as usize];
    // From the shortest that is promised to a tenth of the run.
    let duration = 1.05e-6 * RUN * 1e5_f64.powf(unit());
    let rate = 0.1 * 100.0_f64.powf(unit());
    // The middle of the first pass is so far from the ends that none is cut there.
    let first = duration + (RUN - 2.0 * duration) * unit();
    let gate = |at, wide| Gate { guard, rate, at, wide, must_hold: false };
    match guard {
        Guard::Parabola | Guard::Bell | Guard::Quotient | Guard::Distance => {
            (gate(rate * first, 0.5 * rate * duration), 2, duration)
        }
        Guard::Product => (gate(rate * (first - 0.5 * duration), rate * duration), 2, duration),
        Guard::Turn | Guard::Time => {
            let period = 2.0 * PI / rate;
            let duration = duration.min(0.4 * period);
            let (gate, half) = (gate(PI / 2.0 - rate * first, 0.5 * rate * duration), 0.5 * duration);
            let (mut switches, mut seconds) = (0, 0.0);
            let before = (first / period).floor() + 1.0;
            for k in 0..(RUN / period) as u32 + 3 {
                let crest = first + (f64::from(k) - before) * period;
                let (from, to) = (crest - half, crest + half);
                switches += u64::from(from > 0.0 && from < RUN) + u64::from(to > 0.0 && to < RUN);
                seconds += (to.min(RUN) - from.max(0.0)).max(0.0);
            }
            (gate, switches, seconds)
        }
    }
}

/// The number of random gates: `PLM_EVENTS`, else a thousand.
fn gates() -> usize {
    std::env::var("PLM_EVENTS").ok().and_then(|text| text.parse().ok()).unwrap_or(1000)
}

#[test]
fn random_conditions_of_a_millionth_of_the_run_are_found_whatever_interval_is_asked_for() {
    let seed = 20_260_914;
    let mut random = Random(seed);
    for case in 0..gates() {
        let (gate, switches, known) = random_gate(&mut random);
        let chosen = RUN * 1e-3_f64.powf(0.5 + 0.5 * random.unit());
        for interval in [RUN, chosen] {
            let found = [
                run(gate, Dop853::new(1e-9), interval).map(|sim| (sim.x[2], sim.stats())),
                run(gate, Dopri5::new(1e-8), interval).map(|sim| (sim.x[2], sim.stats())),
                run(gate, RadauIia5::new(1e-8), interval).map(|sim| (sim.x[2], sim.stats())),
            ];
            for (method, found) in ["Dop853", "Dopri5", "RadauIia5"].iter().zip(found) {
                let what = format!("seed {seed}, case {case}: {gate:?}, {method}, intervals of {interval} s");
                let (seconds, stats) = found.unwrap_or_else(|fault| panic!("{what}: {fault}"));
                assert_eq!(stats.switches, switches, "{what}: {seconds} s of {known}");
                // Where a guard is as shallow as a millionth makes it, 1e-13, its root is known to about a thousandth.
                assert!((seconds - known).abs() < 1e-2 * known, "{what}: {seconds} s of {known}");
            }
        }
    }
}

#[test]
fn a_wave_in_time_switches_as_often_as_it_does() {
    // sin(2 pi 10 t) > 0: 199 switches within ten seconds, and one at the beginning that is the start.
    let gate = Gate { guard: Guard::Time, rate: 20.0 * PI, at: 0.0, wide: PI / 2.0, must_hold: false };
    for interval in [10.0, 1.0, 0.1, 0.01] {
        let mut sim = gate.start_with(Dop853::new(1e-9)).unwrap();
        for _ in 0..(10.0 / interval) as u32 {
            sim.step(interval).unwrap();
        }
        assert!((sim.x[2] - 5.0).abs() < 1e-9, "{interval}: {}", sim.x[2]);
        assert_eq!(sim.stats().switches, 199, "{interval}");
    }
}

#[test]
fn a_requirement_is_looked_at_between_the_ends_of_steps_too() {
    let gate = Gate { guard: Guard::Parabola, rate: 1.0, at: 3.456, wide: 1e-5, must_hold: true };
    let fault = run(gate, Dop853::new(1e-9), RUN).map(|_| ()).unwrap_err();
    assert!((fault.time - (3.456 - 1e-5)).abs() < 1e-9, "{fault}");
    assert_eq!((fault.part, fault.cause), ("gate", Cause::Required));
    // Steps of equal length end after it.
    for fault in [
        run(gate, Rk4::new(0.3), RUN).map(|_| ()).unwrap_err(),
        run(gate, SemiImplicitEuler::new(0.3), RUN).map(|_| ()).unwrap_err(),
    ] {
        assert!((fault.time - 3.6).abs() < 0.1, "{fault}");
        assert_eq!((fault.part, fault.cause), ("gate", Cause::Required));
    }
}

#[test]
fn steps_of_equal_length_count_what_they_pass_over() {
    let gate = Gate { guard: Guard::Parabola, rate: 1.0, at: 3.456, wide: 1e-5, must_hold: false };
    let sim = run(gate, Rk4::new(0.3), RUN).unwrap();
    assert_eq!((sim.stats().switches, sim.stats().passed_over), (0, 1));
    assert!(sim.notice().is_some());
    // What lasts longer than a step is not passed over.
    let sim = run(Gate { wide: 0.5, ..gate }, Rk4::new(0.3), RUN).unwrap();
    assert_eq!((sim.stats().switches, sim.stats().passed_over), (2, 0));
    assert!(sim.notice().is_none());
}

/// Each edge that is passed switches, or comes to nothing together with the next one within the same step; far from edges
/// most steps have no look at guards.
#[test]
fn steps_of_equal_length_account_for_every_edge() {
    let seed = 20_261_123;
    let mut random = Random(seed);
    for case in 0..gates() / 4 {
        let (gate, edges, _) = random_gate(&mut random);
        // Shorter than every period.
        let h = 0.3 * 1e-2_f64.powf(0.5 + 0.5 * random.unit());
        for interval in [RUN, h] {
            let what =
                format!("seed {seed}, case {case}: {gate:?}, steps of {h} s, intervals of {interval} s");
            let sim = run(gate, Rk4::new(h), interval).unwrap_or_else(|fault| panic!("{what}: {fault}"));
            let stats = sim.stats();
            assert_eq!(stats.switches + 2 * stats.passed_over, edges, "{what}: {stats:?}");
        }
    }
}

#[test]
fn what_touches_its_boundary_ends_no_run() {
    // At its crest the sine comes as near to the threshold as rounding goes, or passes it by as little.
    for deep in [0.0, 1e-9, -1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4] {
        let gate = Gate { guard: Guard::Turn, rate: 1.0, at: 0.3, wide: deep, must_hold: false };
        for interval in [10.0, 0.1, 1e-3] {
            let sim = run(gate, Dop853::new(1e-9), interval).unwrap();
            let (switches, evaluations) = (sim.stats().switches, sim.stats().evaluations);
            assert!(switches % 2 == 0 && switches <= 4, "{deep:e}, {interval}: {switches}");
            assert!(evaluations < 20 * (RUN / interval) as u64 + 2000, "{deep:e}: {evaluations}");
        }
    }
}

#[test]
fn single_precision_finds_what_it_can_resolve() {
    let gate = Gate { guard: Guard::Parabola, rate: 1.0_f32, at: 3.456, wide: 1e-3, must_hold: false };
    for interval in [10.0_f32, 1.0, 0.1] {
        let mut sim = gate.start_with(Dop853::new(1e-5).with_longest_step(1.0)).unwrap();
        for _ in 0..(10.0 / interval).round() as u32 {
            sim.step(interval).unwrap();
        }
        assert_eq!(sim.stats().switches, 2, "{interval}");
        // Coefficients of the dense output are sums of terms up to 500, so that it knows a place to 1e-4 of a step.
        assert!((sim.x[2] - 2e-3).abs() < 2e-4 * interval.min(1.0), "{interval}: {}", sim.x[2]);
    }
}
