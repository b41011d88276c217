//! LuGre's bristles.

use plm::{Dop853, Mechanism as _};

use crate::declared::Bristles;
use crate::joints::near;
use crate::scene::{Given as _, Named as _};

/// Without Stribeck's fall and damping the bristles bend by z = Fc/s0 (1 - exp(-s0 x/Fc)): Dahl's curve, a spring at first.
#[test]
fn bristles_bend_before_they_slip() {
    let mut sim =
        Bristles::new().with("sticking", 1.0).with("viscous", 0.0).start_with(Dop853::new(1e-11)).unwrap();
    for k in 1..=20 {
        let time = 0.05 * f64::from(k);
        sim.step_to(time).unwrap();
        let x = 1e-4 * time;
        near(sim.state_of("driven").x, x, 1e-15);
        near(sim.value_of("pad.force"), -(1.0 - (-1e5 * x).exp()), 1e-9);
    }
}

/// At a constant speed the friction is Fc + (Fs - Fc) exp(-(v/vs)^2) + s2 v.
#[test]
fn a_steady_slip_has_stribecks_friction() {
    for speed in [5e-4, 1e-3, 3e-3, 0.1] {
        let mut sim = Bristles::new().with("speed", speed).start_with(Dop853::new(1e-11)).unwrap();
        sim.step_to(2.0).unwrap();
        let friction = 1.0 + 0.5 * (-(speed / 1e-3).powi(2)).exp() + 0.4 * speed;
        near(sim.value_of("pad.force"), -friction, 1e-9);
    }
}

/// A mass of 1 kg with the paper's parameters (table 1) is pushed by a force that grows with 1 N/s. Until it breaks away it is held near the
/// static friction of 1.5 N; a small fixed step of the three equations, written here, gives the course.
#[test]
fn a_mass_breaks_away_as_by_small_steps() {
    let (s0, s1, s2) = (1e5, 1e5_f64.sqrt(), 0.4);
    let rate = |t: f64, [_, v, z]: [f64; 3]| {
        let most = 1.0 + 0.5 * (-(v / 1e-3_f64).powi(2)).exp();
        let bending = v - s0 * v.abs() / most * z;
        [v, t - s0 * z - s1 * bending - s2 * v, bending]
    };
    let mut sim = Bristles::new().start_with(Dop853::new(1e-10)).unwrap();
    let (h, mut s) = (2e-5, [0.0; 3]);
    let (mut largest, mut held) = (0.0_f64, 0.0_f64);
    for k in 0..80_000 {
        let t = h * f64::from(k);
        let along = |d: [f64; 3], h: f64| core::array::from_fn(|i| s[i] + h * d[i]);
        let a = rate(t, s);
        let b = rate(t + 0.5 * h, along(a, 0.5 * h));
        let c = rate(t + 0.5 * h, along(b, 0.5 * h));
        let d = rate(t + h, along(c, h));
        s = core::array::from_fn(|i| s[i] + h / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
        if k % 2000 == 1999 {
            sim.step_to(h * f64::from(k + 1)).unwrap();
            near(sim.state_of("pushed").x, s[0], 1e-8);
            near(sim.state_of("pushed").vx, s[1], 1e-6);
            largest = largest.max(-sim.value_of("brake.force"));
            if t < 1.3 {
                held = held.max(sim.state_of("pushed").x);
            }
        }
    }
    assert!(held < 1e-4, "{held}");
    assert!(largest > 1.4 && largest < 1.5, "{largest}");
    assert!(sim.state_of("pushed").vx > 0.05, "{:?}", sim.state_of("pushed"));
}

/// A disc with 1 rad/s is braked evenly by 3 N m once the bristles are bent; they give back their last bend, and it comes to rest.
#[test]
fn bristles_brake_a_disc() {
    let mut sim = Bristles::new().start_with(Dop853::new(1e-10)).unwrap();
    sim.step_to(0.3).unwrap();
    near(sim.value_of("bearing.torque"), -3.0, 1e-12);
    near(sim.value_of("bearing.lost"), 3.0 * sim.state_of("disc").omega, 1e-11);
    let omega = sim.state_of("disc").omega;
    sim.step_to(0.5).unwrap();
    near(sim.state_of("disc").omega, omega - 1.5 * 0.2, 1e-10);
}
