//! Bounds of frictions that become negative within a motion.

use plm::runtime::Method;
use plm::{Dop853, Mechanism as _, Rk4};

use crate::near;
use crate::scene::{Given as _, Scene};

scene! {
    /// Blocks that slide, each with a bound of another kind, and one that rests.
    pub Fading {
        part push(on: body) {
            input force: N = 0 N;
            force on on: (0 N, -force);
        }
        param by_place: N/m = 0 N/m;
        param by_time: N/s = 0 N/s;
        param by_push: 1 = 0;
        param swing: N = 1 N;
        body sliding { mass: 1 kg; inertia: 1 kg*m^2; start vx: 2 m/s; }
        body resting { mass: 1 kg; inertia: 1 kg*m^2; start y: 1 m; }
        body pressed { mass: 1 kg; inertia: 1 kg*m^2; start y: 2 m; start vx: 1 m/s; }
        body swung { mass: 1 kg; inertia: 1 kg*m^2; start y: 3 m; start vx: 1 m/s; }
        constraint level: sliding.y = 0;
        constraint even: resting.y = 1 m;
        constraint flat: swung.y = 3 m;
        unilateral floor: pressed.y >= 2 m;
        push weight(pressed) { force: 2 N; }
        friction place: rate(sliding.x) within 1 N - by_place*sliding.x;
        friction time: rate(resting.x) within 1 N - by_time*t;
        friction lean: rate(pressed.x) within (0.3 - by_push*pressed.x/(1 m))*reaction(floor);
        friction sway: rate(swung.x) within swing*(1 - sin(t/(1 s)));
    }
}

fn fault(fading: Scene, method: impl Method<Scene>) -> (String, f64, String) {
    let mut sim = fading.start_with(method).unwrap();
    let fault = sim.step_to(5.0).unwrap_err();
    (fault.part.to_owned(), fault.time, fault.to_string())
}

/// x'' = x - 1 from 2 m/s comes to 1 m at ln(3)/2; a bound by the time is zero at its own time while the block rests; a coefficient of
/// friction that falls by its place is zero where x'' = -0.6 + 0.8 x has x = 3/8, and one that touches zero is none that falls.
#[test]
fn a_bound_that_falls_below_zero_ends_the_run_at_once() {
    let (part, time, text) = fault(Fading::new().with("by_place", 1.0), Dop853::new(1e-12));
    assert_eq!(part, "place");
    near(time, 0.5 * 3.0_f64.ln(), 1e-9);
    assert!(
        text.contains("the bound of friction, which falls below zero, must be finite and not negative"),
        "{text}"
    );

    let (part, time, _) = fault(Fading::new().with("by_time", 0.5), Dop853::new(1e-12));
    assert_eq!(part, "time");
    near(time, 2.0, 1e-9);

    // With w^2 = 1.6 and s = 3/8 - x: s'' = w^2 s, s = 3/8 cosh(w t) - sinh(w t)/w.
    let (part, time, _) = fault(Fading::new().with("by_push", 0.8), Dop853::new(1e-12));
    let w = 1.6_f64.sqrt();
    assert_eq!(part, "lean");
    near(time, (0.375 * w).atanh() / w, 1e-9);

    let mut sim = Fading::new().start_with(Dop853::new(1e-12)).unwrap();
    sim.step_to(5.0).unwrap();

    // Steps that end after it tell of it at their end.
    let (part, time, _) = fault(Fading::new().with("by_time", 0.5), Rk4::new(0.03));
    assert!(part == "time" && (2.0..2.03 + 1e-12).contains(&time), "{time}");
}

#[test]
fn a_bound_that_is_negative_at_the_start_is_a_fault_there() {
    let fading = Fading::new().with("by_place", 1.0).with_start("sliding.x", 1.0);
    let fault = fading.start_with(Dop853::new(1e-9)).map(|_| ()).unwrap_err();
    assert_eq!((fault.part.to_owned(), fault.time), ("place".to_owned(), 0.0));
    let fading = fading.with_start("sliding.x", 1.5);
    let fault = fading.start_with(Dop853::new(1e-9)).map(|_| ()).unwrap_err();
    assert!(fault.to_string().contains("found -0.5 N or N m"), "{fault}");
}
