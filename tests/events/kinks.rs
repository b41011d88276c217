//! Kinks of forces that depend on the state: knots of tables, `max`.

use plm::{Dop853, Dopri5, Mechanism as _, Method, Moment as _, RadauIia5, Stats};

use crate::scene::{Named as _, Scene};

/// A puck that passes a hat of 1 J in a table of its place, 0.1 m wide and less.
macro_rules! gate {
    ($name:ident, $half:literal) => {
        scene! {
            pub $name {
                allow(W0002);
                body puck { mass: 1 kg; inertia: 0.01 kg*m^2; port o: (0, 0) m; start vx: 1 m/s, locked; start x: 0 m, locked; start y: 0 m, locked; start angle: 0 deg, locked; start omega: 0 rad/s, locked; start vy: 0 m/s, locked; }
                force push(puck.o) { x: table(puck.x, (1 m, 0 N), (1 m + $half m, 1 J/($half m)), (1 m + 2*$half m, 0 N)); }
            }
        }
    };
}
gate!(Wide, 0.05);
gate!(Narrow, 0.005);

fn speed<I: Method<Scene>>(gate: Scene, method: I, interval: f64) -> (f64, Stats) {
    let mut sim = gate.start_with(method).unwrap();
    while sim.time() < 10.0 {
        sim.step(interval.min(10.0 - sim.time())).unwrap();
    }
    (sim.state_of("puck").vx, sim.stats())
}

#[test]
fn a_hat_in_a_table_does_its_work_whatever_interval_is_asked_for() {
    // 1 J on 1 kg at 1 m/s: the root of 3.
    let known = 3.0_f64.sqrt();
    for interval in [10.0, 3.0, 1.0, 0.1, 0.01] {
        for (speed, stats) in [
            speed(Wide::new(), Dop853::new(1e-9), interval),
            speed(Wide::new(), Dopri5::new(1e-9), interval),
            speed(Wide::new(), RadauIia5::new(1e-9), interval),
            speed(Narrow::new(), Dop853::new(1e-9), interval),
            speed(Narrow::new(), Dopri5::new(1e-9), interval),
        ] {
            assert!((speed - known).abs() < 1e-7, "{interval}: {speed} {known} {stats:?}");
            assert!(stats.steps < 250 + (10.0 / interval) as u64, "{interval}: {stats:?}");
        }
    }
}

/// A ball on a spring that only pushes.
macro_rules! bounce {
    ($name:ident, $($spring:tt)*) => {
        scene! {
            pub $name {
                ground { port o: (0, 0) m, axis: 90 deg; }
                body ball { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; start y: 1 m; }
                prismatic rail(ground.o, ball.o);
                force floor(ball.o) { y: $($spring)* - 2 N; }
            }
        }
    };
}
bounce!(ByMax, 1e4 N/m*max(-ball.y, 0));
bounce!(ByIf, (if ball.y < 0 m then -1e4 N/m*ball.y else 0 N));

/// How far off the ball is after 10 s.
fn off<I: Method<Scene>>(bounce: Scene, method: I) -> (f64, Stats) {
    let mut sim = bounce.start_with(method).unwrap();
    sim.step(10.0).unwrap();
    // 1 s down from rest under 2 m/s^2 to 2 m/s; then half a wave of 100 rad/s about -2e-4 m, and up again.
    let (w, v) = (100.0_f64, 2.0_f64);
    let contact = (core::f64::consts::PI + 2.0 * (2.0 / (w * v)).atan()) / w;
    let period = 2.0 + contact;
    let s = 10.0 - 4.0 * period - 1.0 - contact;
    (sim.state_of("ball").y - (v * s - s * s), sim.stats())
}

/// The force is continuous, so that nothing switches: steps end there, and that is all.
#[test]
fn a_kink_ends_a_step_where_it_matters_and_costs_little() {
    for rtol in [1e-6, 1e-9, 1e-12] {
        for (off, stats) in [off(ByMax::new(), Dop853::new(rtol)), off(ByIf::new(), Dop853::new(rtol))] {
            println!("{rtol:e}: {off:e} {stats:?}");
            assert!(off.abs() < 300.0 * rtol, "{rtol:e}: {off:e} {stats:?}");
            assert_eq!(stats.switches, 0, "{rtol:e}: {stats:?}");
        }
    }
}
