//! Prescribed motions and constraints that change their side: what is smooth enough, what is an event, what cannot be.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, unreachable_pub, reason = "tests")]

#[macro_use]
#[path = "support/scene.rs"]
mod scene;

use plm::{Cause, Dop853, Dopri5, Fault, Mechanism as _, Moment as _, Rk4};

use scene::{Given as _, Named as _};

/// A cart whose place is prescribed, with a bob hanging on it: in the least formulation and in absolute coordinates.
macro_rules! cart {
    ($least:ident, $absolute:ident, $place:tt) => {
        cart!($least, {}, $place);
        cart!($absolute, { formulation: absolute; }, $place);
    };
    ($name:ident, { $($formulation:tt)* }, { $($place:tt)* }) => {
        scene! {
            pub $name {
                $($formulation)*
                allow(W0007);
                param from: s = 1 s;
                param speed: m/s = 0;
                param place: m = 0;
                ground { port rail: (0, 0) m; }
                body cart { mass: 1 kg; inertia: 1 kg*m^2; port rail: (0, 0) m; port pin: (0, 0) m; }
                body bob { mass: 1 kg; inertia: 0.01 kg*m^2; port pin: (0, 1) m; }
                prismatic rail(ground.rail, cart.rail);
                revolute pin(cart.pin, bob.pin);
                constraint drive: cart.x = $($place)*;
                output cart.ax, bob.alpha;
            }
        }
    };
}

cart!(Late, LateAbsolute, { if t < from then 0 m else place + speed*(t - from) });
cart!(Pushed, PushedAbsolute, { if t < from then 0 m else 0.5*3 m/s^2*(t - from)^2 });
cart!(Led, LedAbsolute, { smooth_table(t, (0.2 s, 0 m), (0.5 s, 0.3 m), (1.3 s, place), (1.9 s, 1 m)) });

/// What a run of two seconds over a boundary at 1.1 s ends with.
fn jump(outcome: Result<(), Fault>) -> Option<(f64, &'static str, f64, bool)> {
    match outcome {
        Ok(()) => None,
        Err(Fault { time, part, cause: Cause::Jump { by, speed, .. } }) => Some((time, part, by, speed)),
        Err(other) => panic!("{other}"),
    }
}

macro_rules! late {
    ($name:ident, $cart:ident) => {
        #[test]
        fn $name() {
            for (place, speed) in [(0.0, 2.0), (0.0, -1e-3), (2.0, 0.0), (-1e-3, 3.0)] {
                let cart = $cart::new().with("from", 1.1).with("place", place).with("speed", speed);
                let expected = if place == 0.0 { (speed.abs(), true) } else { (place.abs(), false) };
                let outcomes = [
                    cart.start().unwrap().step(2.0),
                    cart.start().unwrap().run(2.0, 0.3, |_| ()),
                    cart.start_with(Dopri5::new(1e-6)).unwrap().step(2.0),
                    cart.start_with(Rk4::new(0.03)).unwrap().step(2.0),
                ];
                for outcome in outcomes {
                    let (time, part, by, of_speed) = jump(outcome).unwrap();
                    assert_eq!((part, of_speed), ("drive", expected.1), "{place} {speed}");
                    assert!((time - 1.1).abs() < 1e-6, "{time}");
                    assert!((by - expected.0).abs() < 1e-6, "{place} {speed}: {by}");
                }
            }
            // One that stands still goes on.
            assert_eq!(jump($cart::new().start().unwrap().step(2.0)), None);
        }
    };
}

late!(a_place_or_speed_that_jumps_ends_the_run, Late);
late!(a_place_or_speed_that_jumps_ends_the_run_in_absolute_coordinates, LateAbsolute);

/// Starts of acceleration are hit: with a constant one the place is a polynomial, which no step errs at.
macro_rules! pushed {
    ($name:ident, $cart:ident) => {
        #[test]
        fn $name() {
            for from in [1.0, 0.777] {
                let mut sim = $cart::new().with("from", from).start_with(Dop853::new(1e-11)).unwrap();
                let mut before = f64::NAN;
                sim.run(from, from, |state| before = state.value_of("cart.ax")).unwrap();
                assert_eq!((sim.stats().switches, before), (1, 0.0));
                sim.step(0.5).unwrap();
                assert!((sim.state_of("cart").vx - 1.5).abs() < 1e-10, "{}", sim.state_of("cart").vx);
                // Seen from the cart a steady -3 m/s^2 acts on the bob from rest: (I + m l^2) w^2/2 = -m a l sin(angle).
                let (angle, omega) = (sim.state_of("bob").angle, sim.state_of("bob").omega);
                let swing = 0.5 * 1.01 * omega * omega + 3.0 * angle.sin();
                assert!(swing.abs() < 1e-9 && omega.abs() > 1.0, "{swing:e} {omega}");
            }
        }
    };
}

pushed!(an_acceleration_that_jumps_is_hit, Pushed);
pushed!(an_acceleration_that_jumps_is_hit_in_absolute_coordinates, PushedAbsolute);

macro_rules! led {
    ($name:ident, $cart:ident) => {
        #[test]
        fn $name() {
            let rows = |step: f64| {
                let cart = $cart::new().with("place", 0.4);
                let mut rows = Vec::new();
                let mut sim = cart.start_with(Dop853::new(1e-11)).unwrap();
                sim.run(2.2, step, |state| {
                    rows.push([
                        state.state_of("cart").x,
                        state.state_of("cart").vx,
                        state.value_of("cart.ax"),
                    ])
                })
                .unwrap();
                rows
            };
            let fine = rows(1e-3);
            // It goes through its points.
            for (time, place) in [(0.0, 0.0), (0.2, 0.0), (0.5, 0.3), (1.3, 0.4), (1.9, 1.0), (2.2, 1.0)] {
                let row = fine[(time / 1e-3 + 0.5) as usize];
                assert!((row[0] - place).abs() < 1e-9, "{time}: {row:?}");
            }
            assert!(fine[200][1].abs() < 1e-9 && fine[1900][1].abs() < 1e-9);
            // Differences of places and speeds are speeds and accelerations, and the acceleration is continuous: what they
            // are off by goes with the square of the step, where the third derivative jumps with the step itself.
            let off = |step: f64| {
                let (mut worst, rows) = ([0.0_f64; 3], rows(step));
                for w in rows.windows(3) {
                    let central = |j: usize| (w[2][j] - w[0][j]) / (2.0 * step) - w[1][j + 1];
                    let now = [central(0), central(1), w[2][2] - w[1][2]];
                    worst = [0, 1, 2].map(|j| worst[j].max(now[j].abs()));
                }
                worst
            };
            let (rough, fine) = (off(2e-3), off(1e-3));
            for (j, least) in [3.5, 1.8, 1.8].into_iter().enumerate() {
                assert!(rough[j] > least * fine[j], "{rough:?} {fine:?}");
            }
        }
    };
}

led!(a_smooth_table_has_a_speed_and_a_continuous_acceleration, Led);
led!(a_smooth_table_has_a_speed_and_a_continuous_acceleration_in_absolute_coordinates, LedAbsolute);

scene! {
    pub Two {
        ground { port o: (0, 0) m; }
        body b { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        prismatic rail(ground.o, b.o);
        constraint drive: b.x = smooth_table(t, (0 s, 0 m), (2 s, 1 m));
        output linear = table(t, (0 s, 0 m), (2 s, 1 m));
    }
}

#[test]
fn two_points_are_joined_by_the_motion_of_least_jerk() {
    // N. Hogan, T. Flash, The coordination of arm movements, J. Neurosci. 5, 1985: 10 s^3 - 15 s^4 + 6 s^5.
    let mut sim = Two::new().start().unwrap();
    sim.run(3.0, 0.125, |state| {
        let s = (state.time() / 2.0).min(1.0);
        let expected = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
        assert!((state.state_of("b").x - expected).abs() < 1e-12, "{} {expected}", state.state_of("b").x);
        let speed = s * s * 30.0 * (1.0 + s * (-2.0 + s)) / 2.0;
        assert!((state.state_of("b").vx - speed).abs() < 1e-12, "{} {speed}", state.state_of("b").vx);
    })
    .unwrap();
}

/// A Geneva wheel: locked, then led by the pin in its slot, then locked; the crank turns freely.
macro_rules! geneva {
    ($name:ident, { $($formulation:tt)* }, { $($index:tt)* }) => {
        scene! {
            pub $name {
                $($formulation)*
                allow(W0007);
                param c: m = 0.1 m;
                let r = c*sin(45 deg);
                ground { port o: (0, 0) m; port w: (c, 0 m); }
                body crank { mass: 1 kg; inertia: 1e-3 kg*m^2; port o: (0, 0) m; start angle: -90 deg, locked; start omega: 3 rad/s, locked; }
                body wheel { mass: 1 kg; inertia: 2e-3 kg*m^2; port o: (0, 0) m; start x: c; }
                revolute o(ground.o, crank.o);
                revolute w(ground.w, wheel.o);
                constraint index: wheel.angle = $($index)*;
            }
        }
    };
}

geneva!(GenevaFree, {}, { if crank.angle < -45 deg then 45 deg else if crank.angle > 45 deg then -45 deg else -atan2(r*sin(crank.angle), c - r*cos(crank.angle)) });
geneva!(GenevaAbsolute, { formulation: absolute; }, { if crank.angle < -45 deg then 45 deg else if crank.angle > 45 deg then -45 deg else -atan2(r*sin(crank.angle), c - r*cos(crank.angle)) });
geneva!(Clamped, {}, { -max(crank.angle, 0)*max(crank.angle, 0)/1 rad });
geneva!(ClampedAbsolute, { formulation: absolute; }, { -max(crank.angle, 0)*max(crank.angle, 0)/1 rad });
geneva!(Broken, {}, { if crank.angle < 0.5 rad then 0 deg else crank.angle });
geneva!(BrokenAbsolute, { formulation: absolute; }, { if crank.angle < 0.5 rad then 0 deg else crank.angle });
geneva!(Folded, {}, { abs(crank.angle) });
geneva!(FoldedAbsolute, { formulation: absolute; }, { abs(crank.angle) });

macro_rules! keeps_energy {
    ($name:ident, $geneva:ident, $switches:expr) => {
        #[test]
        fn $name() {
            for rtol in [1e-6, 1e-9, 1e-12] {
                let mut sim = $geneva::new().start_with(Dop853::new(rtol)).unwrap();
                let energy = sim.kinetic_energy();
                let mut worst = 0.0_f64;
                sim.run(2.0, 0.01, |state| worst = worst.max((state.kinetic_energy() / energy - 1.0).abs()))
                    .unwrap();
                // A step errs by rtol (1 rad/s + w) at most in w = 3 rad/s and less, which the energy sees twice.
                let limit = 3.0 * rtol * sim.stats().steps as f64;
                assert!(worst < limit, "{rtol:e}: {worst:e} of {limit:e}");
                assert_eq!(sim.stats().switches, $switches, "{rtol:e}");
            }
        }
    };
}

keeps_energy!(a_kink_inside_a_constraint_is_hit, GenevaFree, 2);
keeps_energy!(a_kink_inside_a_constraint_is_hit_in_absolute_coordinates, GenevaAbsolute, 2);
keeps_energy!(a_maximum_inside_a_constraint_is_hit, Clamped, 1);
keeps_energy!(a_maximum_inside_a_constraint_is_hit_in_absolute_coordinates, ClampedAbsolute, 1);

macro_rules! breaks {
    ($name:ident, $geneva:ident, $at:expr, $by:expr, $of_speed:expr) => {
        #[test]
        fn $name() {
            let fixed = $geneva::new().start_with(Rk4::new(1e-3)).unwrap().step(2.0);
            for (outcome, near) in [
                ($geneva::new().start().unwrap().step(2.0), 1e-6),
                ($geneva::new().start().unwrap().run(2.0, 0.1, |_| ()), 1e-6),
                (fixed, 2e-3),
            ] {
                let (time, part, by, of_speed) = jump(outcome).unwrap();
                assert_eq!((part, of_speed), ("index", $of_speed));
                assert!((time - $at).abs() < near, "{time}");
                assert!((by - $by).abs() < 1e-3, "{by}");
            }
        }
    };
}

// The crank alone keeps its 3 rad/s from -90 deg on; folded, both bodies have the same speed on either side.
breaks!(sides_that_differ_end_the_run, Broken, (0.5 + std::f64::consts::FRAC_PI_2) / 3.0, 0.5, false);
breaks!(
    sides_that_differ_end_the_run_in_absolute_coordinates,
    BrokenAbsolute,
    (0.5 + std::f64::consts::FRAC_PI_2) / 3.0,
    0.5,
    false
);
breaks!(a_fold_ends_the_run, Folded, std::f64::consts::FRAC_PI_2 / 3.0, 6.0, true);
breaks!(
    a_fold_ends_the_run_in_absolute_coordinates,
    FoldedAbsolute,
    std::f64::consts::FRAC_PI_2 / 3.0,
    6.0,
    true
);

macro_rules! linkage {
    ($name:ident, { $($formulation:tt)* }) => {
        scene! {
            /// A four-bar that is led from pose to pose, with a pendulum on its coupler, and with a spring that is slack at first.
            pub $name {
                $($formulation)*
                gravity: 9.81 m/s^2;
                ground { port a: (0, 0) m; port d: (1.5, 0) m; }
                body crank  { mass: 1 kg; inertia: 0.1 kg*m^2; port a: (0, 0) m; port b: (0.5, 0) m; start angle: 60 deg; }
                body bar    { mass: 1 kg; inertia: 0.1 kg*m^2; port b: (0, 0) m; port c: (1.5, 0) m; port e: (0.7, 0) m; start x: 0.25 m; start y: 0.43 m; }
                body rocker { mass: 1 kg; inertia: 0.1 kg*m^2; port d: (0, 0) m; port c: (1, 0) m; start x: 1.5 m; start angle: 80 deg; }
                body bob    { mass: 1 kg; inertia: 0.1 kg*m^2; port e: (0, 0.5) m; }
                revolute a(ground.a, crank.a);
                revolute b(crank.b, bar.b);
                revolute c(bar.c, rocker.c);
                revolute d(ground.d, rocker.d);
                revolute e(bar.e, bob.e) { damping: 0.01 N*m*s/rad; }
                constraint drive: crank.angle = 60 deg + smooth_table(t, (0.1 s, 0 deg), (0.6 s, 40 deg), (0.9 s, 20 deg));
                force push(bob.e) { x: if t < 0.45 s then 0 N else 3 N; }
            }
        }
    };
}

linkage!(Linkage, {});
linkage!(LinkageAbsolute, { formulation: absolute; });

#[test]
fn a_linkage_is_led_by_a_smooth_table_in_any_formulation() {
    let mut least = Linkage::new().start_with(Dop853::new(1e-11)).unwrap();
    let mut absolute = LinkageAbsolute::new().start_with(Dop853::new(1e-11)).unwrap();
    for _ in 0..12 {
        least.step(0.1).unwrap();
        absolute.step(0.1).unwrap();
        let off = [
            least.state_of("bob").angle - absolute.state_of("bob").angle,
            least.state_of("rocker").angle - absolute.state_of("rocker").angle,
        ];
        assert!(off.iter().all(|off| off.abs() < 1e-8), "{}: {off:?}", least.time());
        assert!(least.drift().phi < 1e-12, "{:?}", least.drift());
    }
    assert!((least.state_of("crank").angle - 80_f64.to_radians()).abs() < 1e-12);
    assert_eq!((least.stats().switches, absolute.stats().switches), (4, 4));
}
