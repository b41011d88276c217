//! Runs over grids: order, threads, and runs that fail.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

mod study;

use plm::batch::{self, Failure};
use plm::{Cause, Fault};

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
