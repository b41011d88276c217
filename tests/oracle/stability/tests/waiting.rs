//! Mechanisms that wait and are then moved smoothly.

use plm_runtime::described::by_number;
use plm_runtime::method::RadauIia5;
use plm_runtime::{Moment as _, Rk4};

use crate::scenes::waiting::{apart, momentum, pushed, pushed_at_once, turned, turntable};
use crate::text::By as _;

#[test]
fn a_four_bar_moves_alike_however_long_it_has_rested() {
    for push in [0.5, -0.3, 0.05] {
        let at_once = pushed_at_once(push).unwrap();
        for wait in [0.0, 1.0, 20.0, 1000.0] {
            let trace = pushed(wait, push).unwrap();
            assert!(
                trace.survived() && trace.rows.len() == at_once.rows.len(),
                "{push}, {wait}: {:?}",
                trace.end
            );
            let off = apart(&trace, &at_once).into_iter().map(|(_, off)| off).fold(0.0, f64::max);
            assert!(off < 1e-7, "{push} N m after {wait} s: {off:e} rad");
        }
    }
}

#[test]
fn a_four_bar_on_a_turntable_turns_with_it_however_long_it_has_rested() {
    for wait in [0.5, 50.0] {
        let table = turntable(wait);
        let traces = [
            (turned(&mut table.begin().unwrap()), 1e-8),
            (turned(&mut table.by(RadauIia5::new(1e-6)).unwrap()), 2e-5),
        ];
        for (trace, tolerance) in traces {
            assert!(trace.survived(), "{wait} s: {:?}", trace.end);
            assert!(trace.largest(1) < tolerance, "{wait} s: {:e} kg m^2/s", trace.largest(1));
        }
    }
    // Forces that are polynomials of the time: what is left is rounding.
    let trace = turned(&mut turntable(0.5).by(Rk4::new(1e-3)).unwrap());
    assert!(trace.survived() && trace.largest(1) < 1e-13, "{:?} {:e}", trace.end, trace.largest(1));
}

/// The same torque from Rust: an input that changes at once after a rest.
#[test]
fn an_input_moves_what_has_rested() {
    for wait in [1e-3, 5.0, 50.0] {
        let mut sim = turntable(1e9).begin().unwrap();
        sim.step(wait).unwrap();
        assert!(by_number::set_input(&mut sim, 0, 0.5));
        let start = sim.time();
        sim.step(10.0).unwrap();
        let pushed = sim.time() - start;
        let off = momentum(&sim) - 0.5 * pushed;
        assert!(off.abs() < 1e-12, "{wait} s: {off:e} kg m^2/s");
    }
}
