//! A slider with clearance beside time stepping: that of others, which is published, and one of J. J. Moreau.

use plm::{Dop853, Mechanism as _};

use super::clearance::{Clearance, Flores};
use crate::near;
use crate::scene::{Given as _, Named as _};

/// Turns of the crank and its rate, rad/s, by the references of Siconos for this mechanism without friction, with steps of 0.1 ms and
/// projection onto the guides at each iteration (siconos-tutorials, examples/mechanics/SliderCrank, SliderCrankMoreauJeanCombinedProjectionOSI).
const SICONOS: [(f64, f64, f64); 8] = [
    (0.001, 0.023_254, 139.23),
    (0.0025, 0.053_224, 112.79),
    (0.01, 0.151_62, 68.089),
    (0.02, 0.258_91, 73.051),
    (0.03, 0.412_68, 132.62),
    (0.04, 0.635_17, 111.44),
    (0.05, 0.770_41, 68.781),
    (0.06, 0.878_46, 74.500),
];

/// Without friction both corners of a side strike at once, first at 2.7 ms. Steps of 0.1 ms err by 0.4 % of the rate until then, and find each
/// impact up to a step late: they are ahead by up to a hundredth of a turn after 35 impacts.
#[test]
fn a_slider_with_clearance_goes_as_published() {
    let mut sim = Clearance::new().with("friction", 0.0).start_with(Dop853::new(1e-10)).unwrap();
    for (time, turns, omega) in SICONOS {
        sim.step_to(time).unwrap();
        let within = if time < 0.0027 { [1e-4, 4e-3] } else { [0.01, 0.06] };
        near(sim.state_of("crank").angle / std::f64::consts::TAU, turns, within[0]);
        near(sim.state_of("crank").omega / omega, 1.0, within[1]);
    }
}

/// A time step of J. J. Moreau's midpoint rule (the paper's section 6): corners that have sunk in at the midpoint leave with e = 0.4 times
/// their approach or faster, and rub with 0.01 of their impulses. Impulses by sweeps of C. F. Gauss and L. Seidel.
fn step(q: [f64; 3], v: [f64; 3], h: f64) -> ([f64; 3], [f64; 3]) {
    let middle: [f64; 3] = core::array::from_fn(|i| q[i] + 0.5 * h * v[i]);
    let a = Flores::acceleration(middle, v);
    let mut after: [f64; 3] = core::array::from_fn(|i| v[i] + h * a[i]);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let corners = Flores::corners(middle).into_iter().zip(Flores::slides(middle));
    let touching: Vec<_> = corners
        .filter(|((gap, _), _)| *gap <= 0.0)
        .map(|((_, up), along)| [up, along].map(|w| (w, Flores::divided(middle, w))))
        .collect();
    let mut impulses = vec![[0.0; 2]; touching.len()];
    let mut change = f64::INFINITY;
    while !touching.is_empty() && change > 1e-15 {
        change = 0.0;
        for (contact, impulse) in touching.iter().zip(&mut impulses) {
            for (i, (w, response)) in contact.iter().enumerate() {
                let rate = dot(*w, after) + if i == 0 { 0.4 * dot(*w, v) } else { 0.0 };
                let free = impulse[i] - rate / dot(*w, *response);
                let most = 0.01 * impulse[0];
                let next = if i == 0 { free.max(0.0) } else { free.clamp(-most, most) };
                let added = next - impulse[i];
                after = core::array::from_fn(|k| after[k] + response[k] * added);
                change = change.max(added.abs());
                impulse[i] = next;
            }
        }
    }
    (core::array::from_fn(|i| middle[i] + 0.5 * h * after[i]), after)
}

/// States at these times by steps of the length `h`.
fn steps(times: &[f64], h: f64) -> Vec<[f64; 6]> {
    let (mut q, mut v, mut done) = ([0.0; 3], [150.0, -75.0, 0.0], 0);
    let state = |time: &f64| {
        let until = (time / h).round() as usize;
        for _ in done..until {
            (q, v) = step(q, v, h);
        }
        done = until;
        [q[0], q[1], q[2], v[0], v[1], v[2]]
    };
    times.iter().map(state).collect()
}

/// With friction too, for half a turn with 29 impacts: time steps come to the run in proportion to their length, and L. F. Richardson's
/// extrapolation of two lengths is as near as impacts allow that are found in different steps.
#[test]
fn a_slider_with_friction_goes_as_small_steps_do() {
    let mut sim = Clearance::new().start_with(Dop853::new(1e-11)).unwrap();
    let times = [0.0024, 0.004, 0.01, 0.02, 0.04];
    let [coarse, fine] = [8e-6, 4e-6].map(|h| steps(&times, h));
    for (k, time) in times.into_iter().enumerate() {
        sim.step_to(time).unwrap();
        let (crank, rod, slider) = (sim.state_of("crank"), sim.state_of("rod"), sim.state_of("slider"));
        let found = [crank.angle, rod.angle, slider.angle, crank.omega, rod.omega, slider.omega];
        for i in 0..6 {
            let known = 2.0 * fine[k][i] - coarse[k][i];
            near(found[i], known, if i < 3 { 1e-4 } else { 0.05 });
            // Half of the length has about half of the error.
            let [whole, half] = [coarse[k][i], fine[k][i]].map(|x| (x - found[i]).abs());
            assert!(half <= 0.6 * whole + 1e-3, "{time} s, {i}: {whole:e} {half:e}");
        }
    }
    assert_eq!(sim.contact_stats().impacts, 29);
}
