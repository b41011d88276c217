//! Runs by what was found: feed-forward, computed torque; poses that are wanted.

use plm::dynamic::Small;
use plm::inverse::{Gains, Inverse, Unsolved, Wanted};
use plm::{Moment, Sim};

use super::{angle, near, set, started};

/// Torques that change over a period as a parabola: at its beginning, slope, curvature.
const ARM: &str = "pub Arm {
    gravity: 9.81 m/s^2;
    input at: s = 0;
    input lift: N*m = 0;
    input lift1: N*m/s = 0;
    input lift2: N*m/s^2 = 0;
    input bend: N*m = 0;
    input bend1: N*m/s = 0;
    input bend2: N*m/s^2 = 0;
    let since = t - at;
    ground { port base: (0, 0) m; }
    body upper {
        mass: 5 kg; inertia: rod(5 kg, 0.5 m); port shoulder: (-0.25, 0) m; port elbow: (0.25, 0) m;
        start angle: -1 rad, locked;
    }
    body lower {
        mass: 3 kg; inertia: rod(3 kg, 0.4 m); port elbow: (-0.2, 0) m; port hand: (0.2, 0) m;
        start angle: 0.5 rad, locked;
    }
    revolute shoulder(ground.base, upper.shoulder) { drive: lift + lift1*since + lift2*since^2; }
    revolute elbow(upper.elbow, lower.elbow) { drive: bend + bend1*since + bend2*since^2; }
}";

const DRIVES: [&str; 2] = ["lift", "bend"];

/// From rest to rest in 1 s: -1 to 0.6 rad and 0.5 to -0.8 rad, by the motion of least jerk.
fn motion(t: f64) -> Wanted<f64, 2> {
    let s = t.clamp(0.0, 1.0);
    let place = s.powi(3) * (10.0 - 15.0 * s + 6.0 * s * s);
    let velocity = 30.0 * s * s * (1.0 - s).powi(2);
    let acceleration = 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s);
    let along = |way: f64| move |number: f64| way * number;
    let [up, down] = [along(1.6), along(-1.3)];
    Wanted {
        place: [up(place) - 1.0, down(place) + 0.5],
        velocity: [up(velocity), down(velocity)],
        acceleration: [up(acceleration), down(acceleration)],
    }
}

fn arm() -> (Sim<Small>, Inverse<'static, f64, 2, 2>) {
    let sim = started(ARM);
    let inverse = Inverse::new(sim.state().mechanism(), ["upper.angle", "lower.angle"], DRIVES).unwrap();
    (sim, inverse)
}

/// The largest deviation at the end of periods of a run by feed-forward: torques are held, or follow a parabola.
fn deviation(periods: u32, parabola: bool) -> f64 {
    let (mut sim, inverse) = arm();
    let (h, mut torques) = (1.0 / f64::from(periods), Vec::new());
    let times = (0..=2 * periods).map(|k| 0.5 * h * f64::from(k));
    inverse.over(&sim, times, motion, |_, inputs| torques.push(inputs)).unwrap();
    let mut worst = 0.0_f64;
    for k in 0..periods {
        let [first, middle, last] = [0, 1, 2].map(|part| torques[2 * k as usize + part]);
        set(&mut sim, "at", f64::from(k) * h);
        for (j, name) in DRIVES.into_iter().enumerate() {
            let (u, v, w) = (first[j], middle[j], last[j]);
            let parts = if parabola {
                [u, (4.0 * v - 3.0 * u - w) / h, 2.0 * (u - 2.0 * v + w) / (h * h)]
            } else {
                [v, 0.0, 0.0]
            };
            set(&mut sim, name, parts[0]);
            set(&mut sim, &format!("{name}1"), parts[1]);
            set(&mut sim, &format!("{name}2"), parts[2]);
        }
        sim.step_to(f64::from(k + 1) * h).unwrap();
        let wanted = motion(f64::from(k + 1) * h);
        for (name, place) in ["upper", "lower"].into_iter().zip(wanted.place) {
            worst = worst.max((angle(sim.state(), name)[0] - place).abs());
        }
    }
    worst
}

/// A torque that is held from the middle of its period errs by h^2, a parabola through three torques by h^4.
#[test]
fn a_run_by_feed_forward_follows_its_trajectory() {
    let (coarse, fine) = (deviation(20, false), deviation(40, false));
    assert!(fine < 3e-2 && (coarse / fine - 4.0).abs() < 0.3, "{coarse:e} {fine:e}");
    let (coarse, fine) = (deviation(20, true), deviation(40, true));
    assert!(coarse < 1e-4 && fine < 1e-5 && coarse / fine > 12.0, "{coarse:e} {fine:e}");
}

/// Deviations decay as (1 + w t) exp(-w t), but for what a period leaves out.
#[test]
fn deviations_decay_by_computed_torque() {
    let (mut sim, inverse) = arm();
    let gains = Gains::critical(10.0);
    let off = |t: f64| {
        let mut wanted = motion(t);
        wanted.place[0] += 0.2;
        wanted
    };
    let h = 4e-4;
    for k in 0..500 {
        let t = f64::from(k) * h;
        let inputs = inverse.track(&sim, &off(t), gains).unwrap();
        for (name, input) in DRIVES.into_iter().zip(inputs) {
            set(&mut sim, name, input);
        }
        sim.step(h).unwrap();
    }
    let t: f64 = 0.2;
    let known = 0.2 * (1.0 + 10.0 * t) * (-10.0 * t).exp();
    near(off(t).place[0] - angle(sim.state(), "upper")[0], known, 1e-3);
    near(off(t).place[1] - angle(sim.state(), "lower")[0], 0.0, 1e-3);
}

#[test]
fn poses_that_are_not_there_and_freedoms_that_are_left() {
    let (sim, inverse) = arm();
    let alone = Inverse::new(sim.state().mechanism(), ["upper.angle"], DRIVES).unwrap();
    let wanted = Wanted { place: [-0.9], velocity: [0.3], acceleration: [0.0] };
    let placed = alone.place(sim.state(), 0.0, &wanted).unwrap();
    near(angle(&placed, "upper")[0], -0.9, 1e-14);
    near(angle(&placed, "upper")[1], 0.3, 1e-14);
    near(angle(&placed, "lower")[0], 0.5, 1e-14);
    let refused = alone.over(&sim, [0.0], |_| wanted, |_, _| ()).unwrap_err();
    assert_eq!(refused, Unsolved::Free { time: 0.0, freedoms: 1 });
    // The hand is on a circle of at most 0.9 m; 0.25 m and 0.5 m along their bars the centres are.
    let by_place = Inverse::new(sim.state().mechanism(), ["lower.x", "lower.y"], DRIVES).unwrap();
    let wanted = |x| Wanted { place: [x, -0.2], velocity: [0.0; 2], acceleration: [0.0; 2] };
    let placed = by_place.place(sim.state(), 0.0, &wanted(0.5)).unwrap();
    let [upper, lower] = ["upper", "lower"].map(|name| angle(&placed, name)[0]);
    near(0.5 * upper.cos() + 0.2 * lower.cos(), 0.5, 1e-13);
    let refused = by_place.place(sim.state(), 0.0, &wanted(0.9)).unwrap_err();
    assert!(matches!(refused, Unsolved::NotReached { .. }), "{refused}");
    let _ = inverse;
}
