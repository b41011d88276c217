//! Generated equations in numbers of twice the precision.

use plm::runtime::lanes::Pack;
use plm::runtime::{DoubleDouble, Health, Rate};
use plm::{Moment, Scalar};

mod loops {
    plm::mechanism! {
        pub FourBar {
            formulation: loops;
            gravity: 9.81 m/s^2;
            param crank: m = 0.3 m;
            param coupler: m = 0.9 m;
            param rocker: m = 0.7 m;
            input drive: N*m = 2 N*m;
            ground { port a: (0, 0) m; port d: (1, 0) m; }
            body one { mass: 1 kg; inertia: 0.05 kg*m^2; port a: (-crank/2, 0 m); port b: (crank/2, 0 m); start angle: 60 deg, locked; start omega: 3 rad/s, locked; }
            body two { mass: 2 kg; inertia: 0.1 kg*m^2; port b: (-coupler/2, 0.1 m); port c: (coupler/2, 0 m); start x: 0.5 m; start y: 0.4 m; start angle: 30 deg; }
            body three { mass: 1.5 kg; inertia: 0.05 kg*m^2; port d: (-rocker/2, 0 m); port c: (rocker/2, 0 m); start x: 1 m; start y: 0.3 m; start angle: 95 deg; }
            revolute p(ground.a, one.a) { drive: drive; }
            revolute q(one.b, two.b);
            revolute r(two.c, three.c) { stiffness: 3 N*m/rad; damping: 0.1 N*m*s/rad; }
            revolute s(ground.d, three.d);
        }
    }
}
use loops::FourBar;

/// The rate of a mechanism at one moment in numbers of another type; and its health.
fn rate<T: Scalar>(
    mechanism: &FourBar<f64>,
    state: &loops::four_bar::State<f64>,
    number: impl Fn(f64) -> T,
) -> (Vec<T>, Health<T>) {
    let one = |[s]: [f64; 1]| number(s);
    let held = state.held();
    let packed = mechanism.pack([mechanism], one);
    let held = FourBar::pack_held(&held, [&held], one);
    let x = state.x().map(&number);
    let mut dx = x;
    let health = Rate::rate(&packed, number(state.time()), &held, &x, &mut dx);
    (dx.to_vec(), health)
}

#[test]
fn a_four_bar_evaluates_in_all_precisions() {
    let mechanism = FourBar::new();
    let mut sim = mechanism.start().unwrap();
    let (mut plain_error, mut single_error): (f64, f64) = (0.0, 0.0);
    for _ in 0..100 {
        let state = sim.state();
        let (plain, _) = rate(&mechanism, state, |s| s);
        let (double, health) = rate(&mechanism, state, DoubleDouble::<f64>::of);
        let (single, _) = rate(&mechanism, state, DoubleDouble::<f32>::lit);
        assert!(health.0.to_f64() > 0.01, "{health:?}");
        let size = plain.iter().fold(0.0, |size: f64, rate| size.max(rate.abs()));
        assert!(size > 1.0);
        for k in 0..plain.len() {
            let exact = double[k];
            plain_error = plain_error.max((DoubleDouble::of(plain[k]) - exact).to_f64().abs() / size);
            let [high, low] = [single[k].high(), single[k].low()].map(f64::from);
            single_error = single_error.max((DoubleDouble::sum(high, low) - exact).to_f64().abs() / size);
        }
        sim.step(0.013).unwrap();
    }
    println!("f64 {plain_error:e}, two of f32 {single_error:e}");
    // Some hundred roundings of f64 are there, in a mechanism that is nowhere near a flat pose.
    assert!(plain_error > 1e-17 && plain_error < 1e-14, "{plain_error:e}");
    // 2^-46 is 1.4e-14.
    assert!(single_error > 1e-17 && single_error < 1e-11, "{single_error:e}");
}
