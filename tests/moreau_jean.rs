//! The time stepping of Moreau and Jean in declarations: beside the event-driven run, as an ordered step, and in every formulation.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

#[path = "support/beside_text.rs"]
mod beside_text;

use plm::runtime::{Moment, Vector};
use plm::{Dop853, Fault, MoreauJean};

/// A four-bar whose rocker moves between two limits, with friction in a pin by its reaction.
macro_rules! four_bar {
    ($name:ident, $formulation:ident) => {
        plm::mechanism! {
            $name {
                gravity: 9.81 m/s^2;
                formulation: $formulation;
                emit: step(moreau_jean);
                input push: N*m = 0;
                discrete strikes: 1 = 0;
                ground { port o: (0, 0) m; port p: (1, 0) m; }
                body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.15, 0) m; port b: (0.15, 0) m; start angle: 60 deg, locked; start omega: 5 rad/s, locked; }
                body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (-0.45, 0) m; port c: (0.45, 0) m; }
                body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
                revolute o(ground.o, crank.a) { drive: 4 N*m*cos(8 rad/s*t) + push; }
                revolute b(crank.b, coupler.b);
                revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
                revolute p(ground.p, rocker.p);
                unilateral low: rocker.angle >= 85 deg { restitution: 0.4; }
                unilateral high: rocker.angle <= 110 deg;
                friction rub: rate(rocker.angle) within 0.2*(0.02 m)*norm(p.force);
                friction seat: rate(coupler.angle) within 0.02*reaction(high) { static: 0.03*reaction(high); }
                when not is_open(high) { strikes = strikes + 1; }
                output strikes, push = reaction(high);
            }
        }
    };
}

four_bar!(FourBar, loops);
four_bar!(Absolute, absolute);

plm::mechanism! {
    /// A mass on a belt; a block that slides from its table onto the floor; a ball that bounces; a latch that lets go of a load.
    Bench {
        allow(W0002);
        gravity: 9.81 m/s^2;
        emit: step(moreau_jean);
        param bounce = 0.5;
        param speed: m/s = 0.1 m/s;
        input push: N = 0;
        discrete holds: 1 = 1;
        discrete torn: s = 0;
        body mass { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start vx: speed; }
        constraint level: mass.angle = 0;
        constraint height: mass.y = 0;
        force spring(mass.p) { x: -(100 N/m)*mass.x; }
        friction belt: rate(mass.x - speed*t) within 2.4525 N { static: 3.924 N; }
        body block { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start y: 0.8 m; start vx: 2 m/s; }
        force pushed(block.p) { x: push; }
        unilateral table: block.y >= 0.8 m { when: block.x < 0.5 m; }
        friction rub: rate(block.x) within 0.1*reaction(table) { when: block.x < 0.5 m; }
        unilateral floor: block.y >= 0 m;
        friction drag: rate(block.x) within 0.5*reaction(floor);
        body ball { mass: 2 kg; inertia: 1 kg*m^2; start y: 1 m; }
        unilateral ground_: ball.y >= 0 m { restitution: bounce; }
        body load { mass: 1 kg; inertia: 1 kg*m^2; port p: (0, 0) m; start y: -1 m; }
        force pull(load.p) { y: -(20 N/s)*t; }
        unilateral hook: load.y >= -1 m { when: holds > 0.5; }
        when reaction(hook) > 20 N { holds = 0; torn = t; }
        output torn, push = reaction(hook);
    }
}

fn bits<X: Vector<f64>>(x: &X) -> Vec<u64> {
    (0..X::LEN).map(|i| x.at(i).to_bits()).collect()
}

/// Emitted steps are those of a run, to the bit, with their modes and counts.
#[test]
fn ordered_steps_have_the_bits_of_a_run() {
    let h = 1.0 / 1024.0;
    macro_rules! same {
        ($mechanism:ident, $count:literal, $theta:expr, $step:ident $(, $evaluations:literal)?) => {{
            let method = MoreauJean::new(h).with_theta($theta)$(.with_evaluations::<$evaluations>())?;
            let mut sim = $mechanism::new().start_with(method).unwrap();
            let mut state = *$mechanism::new().start().unwrap().state();
            for k in 0..$count {
                sim.step(h).unwrap();
                let solution = state.$step$(::<$evaluations>)?(h, $theta).unwrap();
                assert_eq!(bits(sim.state().x()), bits(state.x()), "{k}");
                assert_eq!(solution.residual, sim.method().residual(), "{k}");
            }
            assert_eq!(sim.state().held(), state.held());
            // A condition that has set something asks for the rate after it.
            // An impact takes one more, and those of its rest; several of the step without its rows.
            let (stats, each) = (sim.stats(), 1 $(* $evaluations)?);
            let (own, impacts) = (each * $count, sim.contact_stats().impacts);
            let most = own + stats.switches + (2 * each + 1) * impacts;
            assert!((own + 2 * impacts..=most).contains(&stats.evaluations), "{stats:?}");
        }};
    }
    for theta in [0.5, 1.0] {
        same!(FourBar, 300, theta, step_moreau_jean_with);
        same!(Absolute, 100, theta, step_moreau_jean_with);
        same!(Bench, 450, theta, step_moreau_jean_with);
    }
    same!(FourBar, 300, 0.5, step_moreau_jean_evaluated, 2);
}

/// Steps over contact of mechanisms from text have the bits of compiled ones.
#[test]
fn mechanisms_from_text_have_the_bits_of_compiled_ones() {
    let method = || (MoreauJean::new(2e-3), "MoreauJean:2e-3");
    beside_text::same_bits(FourBar::new(), method(), (4, 0.1));
    beside_text::same_bits(Absolute::new(), method(), (4, 0.03));
    beside_text::same_bits(Bench::new(), method(), (4, 0.25));
}

/// The error of an angle of the four-bar beside the event-driven run falls with the step, in joint and in absolute coordinates.
#[test]
fn a_four_bar_with_limits_converges() {
    let samples = |sim: &mut dyn FnMut() -> f64| (0..30).map(|_| sim()).collect::<Vec<f64>>();
    let mut known = FourBar::new().start_with(Dop853::new(1e-7)).unwrap();
    let angles = samples(&mut || {
        known.step(0.03).unwrap();
        known.crank().angle
    });
    let turned = angles.iter().fold(0.0_f64, |most, angle| most.max((angle - angles[0]).abs()));
    assert!(turned > 0.3 && known.contact_stats().impacts >= 2, "{turned} {:?}", known.contact_stats());
    for theta in [0.5, 1.0] {
        for h in [3e-3, 1e-3] {
            let method = MoreauJean::new(h).with_theta(theta);
            let mut joint = FourBar::new().start_with(method).unwrap();
            let mut absolute = Absolute::new().start_with(method).unwrap();
            let all = [
                samples(&mut || {
                    joint.step(0.03).unwrap();
                    joint.crank().angle
                }),
                samples(&mut || {
                    absolute.step(0.03).unwrap();
                    absolute.crank().angle
                }),
            ];
            let errors = all.map(|found| {
                found
                    .iter()
                    .zip(&angles)
                    .fold(0.0_f64, |most, (found, known)| most.max((found - known).abs()))
            });
            println!("{theta} {h}: {errors:?}");
            assert!(errors.iter().all(|error| *error < 1.5 * h), "{theta} {h}: {errors:?}");
            let residuals = [joint.method().largest_residual(), absolute.method().largest_residual()];
            assert!(residuals.iter().all(|residual| *residual < 1e-5), "{theta} {h}: {residuals:?}");
        }
    }
    // Two evaluations are of order 2 until the rocker strikes.
    let errors = |h: f64| {
        let method = MoreauJean::new(h).with_evaluations::<2>();
        let mut joint = FourBar::new().start_with(method).unwrap();
        let mut absolute = Absolute::new().start_with(method).unwrap();
        joint.step(0.12).unwrap();
        absolute.step(0.12).unwrap();
        [joint.crank().angle, absolute.crank().angle].map(|angle| angle - angles[3])
    };
    let [long, short] = [3e-3, 1.5e-3].map(errors);
    for (long, short) in long.into_iter().zip(short) {
        let order = (long / short).log2();
        assert!((order - 2.0).abs() < 0.1 && short.abs() < 2e-6, "{long:e} {short:e}");
    }
}

/// Closed forms of the bench at steps of 1 ms: within some steps of the time or what the speed makes of it.
#[test]
fn a_bench_of_rows_follows_closed_forms() -> Result<(), Fault> {
    let (g, h) = (9.81_f64, 1e-3);
    let mut sim = Bench::new().start_with(MoreauJean::new(h))?;
    let leaves = (4.0 - 2.0 * 0.1 * g * 0.5).sqrt();
    let edge = (2.0 - leaves) / (0.1 * g);
    sim.step(0.39)?;
    assert!(
        (sim.mass().vx - 0.1).abs() < 1e-9 && (sim.block().vx - leaves).abs() < 0.1 * g * h,
        "{}",
        sim.block().vx
    );
    // The pull and the weight reach 20 N at 0.5095 s.
    sim.step(0.41)?;
    assert!((sim.torn() - (20.0 - g) / 20.0).abs() < 2.0 * h, "{}", sim.torn());
    let fall = (2.0 * 0.8 / g).sqrt();
    sim.step(1.2)?;
    assert!((sim.block().x - (0.5 + leaves * fall)).abs() < 3.0 * h * leaves, "{} {edge}", sim.block().x);
    assert!(sim.ball().y.abs() < 1e-15 && sim.ball().vy.abs() < 1e-15, "{}", sim.ball().y);
    let mut known = Bench::new().start_with(Dop853::new(1e-8))?;
    known.step(2.0)?;
    assert!((sim.mass().x - known.mass().x).abs() < h * 0.5, "{} {}", sim.mass().x, known.mass().x);
    assert!(sim.method().largest_residual() < 1e-12, "{:e}", sim.method().largest_residual());
    let place = sim.block().x;
    sim.step(1.0)?;
    assert!((sim.block().x - place).abs() < 1e-15);
    Ok(())
}

/// Eight at a time have the bits of eight that run alone: states, modes, counts, residuals and faults.
#[cfg(feature = "lanes")]
mod lanes {
    use super::{Absolute, Bench, FourBar, bits};
    use plm::runtime::lanes::Pack;
    use plm::{Batch, Cause, Fault, Moment, MoreauJean, Sim};

    const AROUND: [f64; 8] = [0.0, 0.3, -0.2, 0.45, -0.4, 0.1, -0.05, 0.22];

    type Lane<M> = Sim<M, MoreauJean<f64>>;

    /// Runs eight in a batch and alone, `before` changing each before each interval; what the last interval gave. They are in modes of their
    /// own at some end of an interval.
    fn agree<M: Pack<S = f64, U: std::fmt::Debug>>(
        mut alone: [Lane<M>; 8],
        intervals: &[f64],
        before: impl Fn(usize, usize, &mut Lane<M>),
    ) -> ([Result<(), Fault>; 8], [Lane<M>; 8]) {
        let (mut batch, mut last, mut are_apart) = (Batch::new(alone), [Ok(()); 8], false);
        for (interval, dt) in intervals.iter().enumerate() {
            for lane in 0..8 {
                before(interval, lane, &mut batch[lane]);
                before(interval, lane, &mut alone[lane]);
            }
            let expected = alone.each_mut().map(|sim| sim.step(*dt));
            last = batch.step(*dt);
            assert_eq!(last, expected, "interval {interval}");
            let modes = batch
                .each_ref()
                .map(|sim| [0, 1, 2, 3].map(|row| M::contacts(&sim.state().held()).mode(row)));
            are_apart |= modes.iter().any(|of| *of != modes[0]);
            for (lane, (one, other)) in batch.iter().zip(&alone).enumerate() {
                let of = |sim: &Lane<M>| (bits(sim.state().x()), sim.state().time().to_bits(), sim.stats());
                assert_eq!(of(one), of(other), "lane {lane}, interval {interval}");
                assert_eq!(one.state().held(), other.state().held(), "lane {lane}, interval {interval}");
                assert_eq!(one.contact_stats(), other.contact_stats(), "lane {lane}, interval {interval}");
                let residuals = |sim: &Lane<M>| (sim.method().residual(), sim.method().largest_residual());
                assert_eq!(residuals(one), residuals(other), "lane {lane}, interval {interval}");
            }
        }
        assert!(are_apart);
        (last, alone)
    }

    fn unchanged<M: Pack<S = f64>>(_interval: usize, _lane: usize, _sim: &mut Lane<M>) {}

    /// One of eight pushes so that nothing can move with it, in the third interval.
    fn push(interval: usize, lane: usize) -> f64 {
        if interval == 2 && lane == 5 { f64::INFINITY } else { 2.0 * lane as f64 }
    }

    /// All have come to the end but the one that has failed.
    fn stays_after<M: Pack<S = f64>>(lanes: &[Lane<M>; 8], end: f64) {
        let times = lanes.each_ref().map(|sim| sim.state().time());
        let is_there = |(lane, time): (usize, &f64)| ((time - end).abs() < 1e-9) == (lane != 5);
        assert!(times.iter().enumerate().all(is_there), "{times:?}");
    }

    /// Rockers that strike their limits at times of their own, in joint and in absolute coordinates.
    #[test]
    fn four_bars_with_limits() {
        macro_rules! bars {
            ($mechanism:ident, $intervals:expr) => {
                let bars = AROUND.map(|turn| {
                    let mut mechanism = $mechanism::new();
                    mechanism.start.crank.angle.value += 0.2 * turn;
                    mechanism.start.crank.omega.value += 6.0 * turn;
                    mechanism.start_with(MoreauJean::new(1e-3)).unwrap()
                });
                let (_, lanes) = agree(bars, $intervals, unchanged);
                let counts = lanes.each_ref().map(|sim| sim.contact_stats());
                assert!(counts.iter().all(|counts| counts.closures > 0), "{counts:?}");
            };
        }
        let bars = [FourBar::new().start_with(MoreauJean::new(1e-3)).unwrap(); 8];
        let (_, lanes) = agree(bars, &[0.1, 0.08, 0.05, 0.1], |interval, lane, sim| {
            sim.input.push = push(interval, lane);
        });
        stays_after(&lanes, 0.33);
        bars!(FourBar, &[0.1, 0.08, 0.0005, 0.07, 0.1, 0.1]);
        bars!(Absolute, &[0.08; 5]);
    }

    /// Lanes that stick, slip, bounce and let go at times of their own, with steps and shares of steps of their own. One fails, and stays
    /// after; it goes on when its cause is gone.
    #[test]
    fn benches_in_modes_of_their_own() {
        let mut lane = 0..8;
        let benches = AROUND.map(|s| {
            let k = lane.next().unwrap();
            let method = MoreauJean::new(if k % 4 == 3 { 4e-4 } else { 1e-3 });
            let bench = Bench { bounce: 0.5 + s, speed: 0.1 + 0.1 * s, ..Bench::new() };
            bench.start_with(if k == 6 { method.with_theta(0.8) } else { method }).unwrap()
        });
        let (last, lanes) = agree(benches, &[0.2, 0.35, 0.25, 1.2], |interval, lane, sim| {
            sim.input.push = push(interval, lane);
        });
        assert!(last.iter().all(Result::is_ok));
        stays_after(&lanes, 2.0);

        let mut batch = Batch::start(&[Bench::new(); 8], MoreauJean::new(1e-3)).unwrap();
        batch[2].input.push = f64::INFINITY;
        let failed =
            batch.step(0.1).map(|outcome| outcome.is_err_and(|fault| fault.cause == Cause::NotFinite));
        assert_eq!(failed, [false, false, true, false, false, false, false, false]);
    }
}
