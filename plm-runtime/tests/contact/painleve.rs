//! Painlevé's rod: where its slip takes the uniqueness of accelerations away.

use plm_runtime::contact::{self, Mode, Modes};
use plm_runtime::{Cause, Dop853, Dopri5, Mechanism, Rk4};

use crate::bodies::{Body, GRAVITY};

/// A uniform rod of 1 m and 1 kg over the ground: its lower tip slides to the left with a speed, pushed.
fn rod(degrees: f64, friction: f64, (speed, spin): (f64, f64)) -> Body {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Body {
        inertia: 1.0 / 12.0,
        points: [[-0.5, 0.0], [0.5, 0.0]],
        friction,
        restitution: 0.0,
        start: (
            [0.5 * cos, 0.5 * sin, degrees.to_radians()],
            [-speed - 0.5 * spin * sin, 0.5 * spin * cos, spin],
        ),
    }
}

/// p of the rod: 1 + 3 cos^2 th - 3 mu sin th cos th, where D_nn = 1 + 3 cos^2 th.
fn left(angle: f64, friction: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    1.0 + 3.0 * cos * cos - 3.0 * friction * sin * cos
}

/// Case C20: between these angles its tip has no push that satisfies the laws, or two motions.
#[test]
fn a_rod_that_digs_in_is_named() {
    for (degrees, is_regular) in [(50.6, true), (50.7, false), (60.0, false), (73.0, false), (73.1, true)] {
        match rod(degrees, 1.5, (1.0, 0.0)).start_with(Dop853::new(1e-12)) {
            Ok(sim) => assert!(is_regular && sim.held.of[0] == Mode::Closed, "{degrees}: {:?}", sim.held),
            Err(fault) => {
                let Cause::NoMode { touching: 1, p } = fault.cause else { panic!("{degrees}: {fault}") };
                let angle = f64::to_radians(degrees);
                let share = left(angle, 1.5) / (1.0 + 3.0 * angle.cos().powi(2));
                assert!(!is_regular && (p - share).abs() < 1e-12, "{degrees}: {fault}");
                assert!(fault.to_string().contains("Painleve"), "{fault}");
            }
        }
    }
}

/// Where it turns so fast that its tip would lift off, it may slide on as well: more than one motion satisfies the laws.
#[test]
fn a_rod_with_two_motions_is_ambiguous() {
    let critical = (2.0 * GRAVITY / 60.0_f64.to_radians().sin()).sqrt();
    for (spin, is_ambiguous) in [(1.01 * critical, true), (-1.01 * critical, true), (0.99 * critical, false)]
    {
        let scene = rod(60.0, 1.5, (10.0, spin));
        let ([q, v], mut u) = ([scene.start.0, scene.start.1], Modes::open());
        let mut x = [q[0], q[1], q[2], v[0], v[1], v[2]];
        match contact::begin::<_, 4>(&scene, 0.0, &mut u, &mut x) {
            Ok(outcome) => assert!(is_ambiguous && outcome.is_ambiguous, "{spin}"),
            Err(fault) => assert!(!is_ambiguous && matches!(fault.cause, Cause::NoMode { .. }), "{fault}"),
        }
    }
}

/// The time at which the rod comes to p = 0. In a time s with dt = p ds its equations have no pole; p falls exponentially there.
fn comes_to_zero(friction: f64, mut y: [f64; 3]) -> f64 {
    let rate = |y: [f64; 3]| {
        let [_, angle, spin] = y;
        let (sin, cos) = angle.sin_cos();
        let (p, pressed) = (left(angle, friction), GRAVITY - 0.5 * spin * spin * sin);
        [p, p * spin, 6.0 * (friction * sin - cos) * pressed]
    };
    let along = |y: [f64; 3], k: [f64; 3], h: f64| core::array::from_fn(|i| y[i] + h * k[i]);
    let h = 1e-4;
    while left(y[1], friction) > 1e-9 {
        let a = rate(y);
        let b = rate(along(y, a, 0.5 * h));
        let c = rate(along(y, b, 0.5 * h));
        let d = rate(along(y, c, h));
        y = along(y, core::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0), h);
    }
    y[0]
}

/// It turns to tan th = (3 mu - sqrt(9 mu^2 - 16))/2, where p is zero, pushed more and more; there the run ends, and says so.
#[test]
fn a_rod_that_slides_to_the_paradox_is_stopped_there() {
    for (degrees, friction, spin) in [(20.0, 2.0, 2.0), (30.0, 2.0, 3.0), (10.0, 2.0, 5.0), (10.0, 3.0, 3.0)]
    {
        let scene = rod(degrees, friction, (30.0, spin));
        let root = (9.0_f64 * friction * friction - 16.0).sqrt();
        let angle = (0.5 * (3.0 * friction - root)).atan();
        let time = comes_to_zero(friction, [0.0, degrees.to_radians(), spin]);
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let mut sim = scene.start_with(Dop853::new(tolerance)).unwrap();
            let fault = sim.step(1.0).unwrap_err();
            let Cause::NotUnique { p } = fault.cause else { panic!("{fault}") };
            assert!(p.abs() < 1e-8, "{fault}");
            assert!((sim.x[2] - angle).abs() < 1e-8, "{} {angle}", sim.x[2]);
            assert!((fault.time - time).abs() < 1e-9 + tolerance, "{fault} {time}");
            assert!(sim.stats().steps < 200, "{:?}", sim.stats());
            assert!(fault.to_string().contains("no unique acceleration"), "{fault}");
        }
        let faults = [
            scene.start_with(Dopri5::new(1e-8)).unwrap().step(1.0).unwrap_err(),
            scene.start_with(Rk4::new(1e-4)).unwrap().step(1.0).unwrap_err(),
        ];
        for fault in faults {
            println!("{fault}");
            let is_named = matches!(fault.cause, Cause::NotUnique { .. } | Cause::NoMode { .. });
            assert!(is_named && (fault.time - time).abs() < 2e-4, "{fault} {time}");
        }
    }
}
