//! A live mechanism whose parameters are turned to what cannot be assembled, and back.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use plm::live::Live;
use plm::runtime::described::by_number;
use plm::runtime::{StartValues, Statics};

plm::mechanism! {
    /// A slider-crank that swings by its weight and a torque.
    pub Free {
        gravity: 9.81 m/s^2;
        param rod_length: mm = 350 mm;
        param torque: N*m = 2 N*m;
        ground { port o: (0, 0) m; port rail: (0, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (100, 0) mm; start angle: 60 deg; }
        body rod { mass: 1 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; port c: (rod_length, 0); centre: (rod_length/2, 0); start angle: -10 deg; }
        body piston { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start x: 0.4 m; }
        revolute main(ground.o, crank.a) { drive: torque; }
        revolute big_end(crank.b, rod.b);
        revolute small_end(rod.c, piston.c);
        prismatic guide(ground.rail, piston.c);
    }
}

plm::mechanism! {
    /// The same with a crank that is turned.
    pub Driven {
        param rod_length: mm = 350 mm;
        param speed: rad/s = 6 rad/s;
        ground { port o: (0, 0) m; port rail: (0, 0) m; }
        body crank { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; port b: (100, 0) mm; start angle: 0 deg; }
        body rod { mass: 1 kg; inertia: 0.01 kg*m^2; port b: (0, 0) m; port c: (rod_length, 0); centre: (rod_length/2, 0); start angle: 0 deg; }
        body piston { mass: 1 kg; inertia: 0.01 kg*m^2; port c: (0, 0) m; start x: 0.45 m; }
        revolute main(ground.o, crank.a);
        revolute big_end(crank.b, rod.b);
        revolute small_end(rod.c, piston.c);
        prismatic guide(ground.rail, piston.c);
        constraint motor: crank.angle = speed*t;
    }
}

plm::mechanism! {
    pub FourBar {
        gravity: 9.81 m/s^2;
        param reach: mm = 900 mm;
        param torque: N*m = 5 N*m;
        ground { port o: (0, 0) m; port p: (1, 0) m; }
        body crank { mass: 1 kg; inertia: 0.02 kg*m^2; port a: (0, 0) m; port b: (0.3, 0) m; start angle: 60 deg, locked; }
        body coupler { mass: 2 kg; inertia: 0.2 kg*m^2; port b: (0, 0) m; port c: (reach, 0); centre: (reach/2, 0.1 m); }
        body rocker { mass: 1.5 kg; inertia: 0.1 kg*m^2; port c: (0.4, 0) m; port p: (-0.4, 0) m; start angle: 100 deg; }
        revolute o(ground.o, crank.a) { drive: torque; }
        revolute b(crank.b, coupler.b);
        revolute c(coupler.c, rocker.c) { damping: 0.5 N*m*s/rad; }
        revolute p(ground.p, rocker.p);
    }
}

plm::mechanism! {
    /// More start values than are compared in one pass.
    pub Row {
        param gap: m = 1 m;
        ground { port o: (0, 0) m; }
        repeat i in 0..12 {
            body block[i] { mass: 1 kg; inertia: 0.01 kg*m^2; port a: (0, 0) m; start x: i*gap; start vx: i*0.1 m/s; }
            prismatic rail[i](ground.o, block[i].a);
        }
    }
}

#[test]
fn every_start_follows_a_parameter_unless_it_was_set_by_hand() {
    let mut row = Row::new();
    row.starts_mut().each(&mut |name, start| {
        if name == "block[10].x" {
            start.value = 7.0;
        }
    });
    assert!(by_number::set_parameter(&mut row, 0, 2.0));
    assert!(!by_number::set_parameter(&mut row, 1, 2.0));
    let mut seen = Vec::new();
    row.starts_mut().each(&mut |name, start| {
        if name.split('.').next_back() == Some("x") {
            seen.push(start.value);
        }
    });
    let expected: Vec<f64> = (0..12).map(|i| if i == 10 { 7.0 } else { 2.0 * f64::from(i) }).collect();
    assert_eq!(seen, expected);
}

/// Whatever a parameter is turned to, and whenever, the old value goes on; a step that is not made changes nothing.
macro_rules! goes_on {
    ($name:ident, $impossible:expr, $usual:expr) => {
        for tries in 1..8 {
            let mut live = Live::new(<$name>::new());
            for _ in 0..13 * tries {
                assert!(live.step(0.01));
            }
            let now = live.read().to_vec();
            live.set_parameter(0, $impossible);
            let mut steps = 0;
            while steps < 30 && live.step(0.01) {
                steps += 1;
            }
            if steps == 0 {
                let error = live.error().unwrap().clone();
                assert!(
                    error.gap > 1e-3 || error.gap.is_nan() && !error.text.contains("not a number"),
                    "{error:?}"
                );
                assert_eq!(live.read(), now, "nothing has changed");
            }
            live.set_parameter(0, $usual);
            for step in 0..50 {
                assert!(
                    live.step(0.01),
                    "{}, {tries}: {steps} steps, {step} steps after: {:?}",
                    stringify!($name),
                    live.error()
                );
            }
            assert!(live.error().is_none() && live.read().iter().all(|number| number.is_finite()));
        }
    };
}

#[test]
fn a_free_slider_crank_goes_on_with_the_old_rod() {
    goes_on!(Free, 0.08, 0.35);
}

#[test]
fn a_four_bar_goes_on_with_the_old_coupler() {
    goes_on!(FourBar, 0.3, 0.9);
    // As far as bars cannot reach at all.
    goes_on!(FourBar, 3.0, 0.9);
}

/// The crank is turned through 90 deg when the rod becomes 20 mm too short: no step is made, the joint and what it lacks are told, and
/// the old rod goes on as if nothing had been.
#[test]
fn a_rod_that_is_too_short_is_told_at_its_joint() {
    let mut live = Live::new(Driven::new());
    let mut undisturbed = Live::new(Driven::new());
    for live in [&mut live, &mut undisturbed] {
        assert!(live.step(std::f64::consts::FRAC_PI_2 / 6.0));
    }
    let now = live.read().to_vec();
    live.set_parameter(0, 0.08);
    // At once, before any step.
    assert_eq!(live.error().unwrap().part, "small_end");
    for _ in 0..3 {
        assert!(!live.step(0.01));
        let error = live.error().unwrap();
        assert_eq!(error.part, "small_end");
        assert!((error.gap - 0.02).abs() < 1e-6, "{error:?}");
        assert_eq!(live.read(), now);
    }
    live.set_parameter(0, 0.35);
    assert!(live.error().is_none());
    for _ in 0..20 {
        assert!(live.step(0.01) && undisturbed.step(0.01));
        assert_eq!(live.read(), undisturbed.read());
    }
}
