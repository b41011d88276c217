//! Runs over grids: order, threads, and runs that fail.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod study;

use plm::batch::{self, Failure};
use plm::{Cause, Dop853, Fault, Mechanism, Moment, Sim};

plm::mechanism! {
    /// A four-bar that cannot be closed where the coupler is too short.
    pub FourBar {
        gravity: 9.81 m/s^2;
        param coupler: m = 0.8 m;
        param turned: deg = 60 deg;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (-0.1, 0) m; port b: (0.1, 0) m; start angle: turned, locked; }
        body bar { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-coupler/2, 0); port c: (coupler/2, 0); start angle: 20 deg; }
        body rocker { mass: 1 kg; inertia: 0.05 kg*m^2; port d: (-0.3, 0) m; port c: (0.3, 0) m; start angle: 90 deg; }
        revolute pa(ground.a, crank.a);
        revolute pb(crank.b, bar.b);
        revolute pc(bar.c, rocker.c);
        revolute pd(ground.d, rocker.d);
        output rocker.angle;
    }
}

fn angle((coupler, turned): (f64, f64)) -> Result<f64, Fault> {
    let mut sim = FourBar { coupler, turned, ..FourBar::new() }.start()?;
    sim.step(0.5)?;
    Ok(sim.rocker_angle())
}

/// The second coupler is too short to be assembled.
const COUPLERS: [f64; 3] = [0.8, 0.05, 0.9];
const TURNED: [f64; 4] = [0.9, 1.0, 1.1, 1.2];

#[test]
fn results_stand_in_the_order_of_the_grid() {
    let runs = batch::grid(&COUPLERS, &TURNED).quiet().run(angle);
    assert_eq!(runs.len(), 12);
    for (k, run) in runs.iter().enumerate() {
        let point = (COUPLERS[k / 4], TURNED[k % 4]);
        assert_eq!((run.index, run.parameters), (k, point));
        assert_eq!(run.result.clone().ok(), angle(point).ok());
    }
    let sums = batch::grid3(&[1, 2], &[10, 20], &[100, 200]).quiet().run(|(a, b, c)| Ok(a + b + c));
    assert_eq!(sums.all(), Ok(vec![111, 211, 121, 221, 112, 212, 122, 222]));
}

#[test]
fn threads_do_not_change_a_bit() {
    let bits = |threads| {
        let runs = batch::grid(&COUPLERS, &TURNED).quiet().threads(threads).run(angle);
        runs.iter().map(|run| run.result.as_ref().ok().map(|x| x.to_bits())).collect::<Vec<_>>()
    };
    let one = bits(1);
    assert_eq!(one.iter().flatten().count(), 8);
    assert_eq!(one, bits(2));
    assert_eq!(one, bits(5));
}

#[test]
fn a_point_that_cannot_be_assembled_is_told_and_the_others_are_kept() {
    let runs = batch::grid(&COUPLERS, &TURNED).quiet().run(angle);
    assert_eq!(runs.values().count(), 8);
    let failed: Vec<usize> = runs.failed().map(|run| run.index).collect();
    assert_eq!(failed, [4, 5, 6, 7]);
    for run in runs.failed() {
        let Err(Failure::Fault(fault)) = &run.result else { panic!("{run:?}") };
        assert!(matches!(fault.cause, Cause::Open { .. }), "{fault}");
    }
    let told = runs.to_string();
    assert!(told.starts_with("4 of 12 runs failed\nrun 4, (0.05, 0.9): "), "{told}");
    assert!(matches!(runs.all(), Err(Failure::Fault(_))));
}

plm::mechanism! {
    /// A pendulum that a spring catches beyond an angle, where its torque has a corner.
    pub Caught {
        gravity: 9.81 m/s^2;
        param length: m = 1 m;
        ground { port o: (0, 0) m; }
        body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, length); start angle: 60 deg, locked; }
        revolute hinge(ground.o, bob.o) { drive: 40 N*m * max(-0.3 rad - bob.angle, 0 rad)/(1 rad); }
        output bob.angle, bob.omega;
    }
}

/// A run to 0.5 s by itself.
fn alone<M: Mechanism<S = f64>, T>(
    sim: Result<Sim<M, Dop853<M>>, Fault>,
    result: impl Fn(&Sim<M, Dop853<M>>) -> T,
) -> Option<T> {
    let mut sim = sim.ok()?;
    let left = 0.5 - sim.state().time();
    sim.step(left).ok()?;
    Some(result(&sim))
}

#[test]
fn runs_to_a_time_have_the_bits_of_runs_alone() {
    let closed = |(coupler, turned): (f64, f64)| {
        FourBar { coupler, turned, ..FourBar::new() }.start_with(Dop853::new(1e-10))
    };
    let seen = |sim: &Sim<FourBar, Dop853<FourBar>>| (sim.rocker_angle().to_bits(), sim.stats());
    // More points than a thread takes at once; every third cannot be assembled.
    let turned: Vec<f64> = (0..50).map(|k| 0.5 + 0.02 * f64::from(k)).collect();
    for threads in [1, 3] {
        let runs = batch::grid(&COUPLERS, &turned).quiet().threads(threads).run_to(0.5, closed, seen);
        assert_eq!(runs.len(), 150);
        for (k, run) in runs.iter().enumerate() {
            let point = (COUPLERS[k / 50], turned[k % 50]);
            assert_eq!((run.index, run.parameters), (k, point));
            assert_eq!(run.result.clone().ok(), alone(closed(point), seen), "{point:?}");
        }
        assert_eq!(runs.failed().count(), 50);
    }
    // Conditions go alone, as does a run that begins later than the others.
    let caught = |length: f64| {
        let mechanism = Caught { length, ..Caught::new() };
        let (held, x) = mechanism.start_state(0.0)?;
        let time = if length > 1.2 { 0.1 } else { 0.0 };
        Ok(Sim::new(Moment::new(mechanism, held, time, x), Dop853::new(1e-10)))
    };
    let seen = |sim: &Sim<Caught, Dop853<Caught>>| [sim.bob_angle(), sim.bob_omega()].map(f64::to_bits);
    let lengths: Vec<f64> = (0..20).map(|k| 0.5 + 0.05 * f64::from(k)).collect();
    let runs = batch::points(lengths).quiet().run_to(0.5, caught, seen);
    for run in &*runs {
        assert_eq!(run.result.clone().ok(), alone(caught(run.parameters), seen), "{}", run.parameters);
    }
    assert_eq!(runs.failed().count(), 0, "{runs}");
}

#[test]
fn a_result_that_panics_loses_nothing_else() {
    let start = |turned: f64| FourBar { turned, ..FourBar::new() }.start_with(Dop853::new(1e-8));
    let runs = batch::points(TURNED).quiet().run_to(0.1, start, |sim| {
        assert!(sim.mechanism.turned != 1.1, "no 1.1");
        sim.rocker_angle()
    });
    assert_eq!(runs.to_string(), "1 of 4 runs failed\nrun 2, 1.1: panic: no 1.1");
    assert!(batch::points([]).quiet().run_to(0.1, start, |_| ()).is_empty());
}

#[test]
fn a_panic_loses_nothing_else() {
    let runs = batch::points(0..6).quiet().threads(2).run(|k| {
        assert!(k != 3, "no three");
        Ok(10 * k)
    });
    let values: Vec<i32> = runs.values().map(|(_, value)| *value).collect();
    assert_eq!(values, [0, 10, 20, 40, 50]);
    assert_eq!(runs[3].result, Err(Failure::Panic("no three".to_owned())));
    assert_eq!(runs.to_string(), "1 of 6 runs failed\nrun 3, 3: panic: no three");
}

#[test]
fn nothing_to_run_is_no_mistake() {
    let runs = batch::grid::<f64, f64>(&[], &TURNED).run(angle);
    assert!(runs.is_empty());
    assert_eq!(runs.to_string(), "0 of 0 runs failed");
}

/// Takes so many KiB of the stack.
fn takes<const KIB: usize>(point: usize) -> usize {
    let room = [[point; 1024 / size_of::<usize>()]; KIB];
    std::hint::black_box(&room)[KIB - 1][0]
}

#[test]
fn threads_have_the_stack_that_large_mechanisms_need() {
    // A stack that overflows ends this program. Threads have 2 MiB where nothing is said.
    assert_eq!(batch::points([3, 4]).quiet().run(|point| Ok(takes::<6144>(point))).all(), Ok(vec![3, 4]));
    assert_eq!(
        batch::points([5]).quiet().stack(24 << 20).run(|point| Ok(takes::<20480>(point))).all(),
        Ok(vec![5])
    );
}
