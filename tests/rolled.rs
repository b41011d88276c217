//! Code with loops for what repeats itself beside the same code without: the same bits.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use plm::runtime::{Labels, Statics, Vector};
use plm::{Described, Moment, Ros34Pw2};

/// Declares a mechanism with loops and without, and tells every number of a run of each.
macro_rules! both {
    ($module:ident, { $($items:tt)* }) => {
        mod $module {
            pub(super) mod rolled {
                plm::mechanism! { pub Scene { code: rolled; $($items)* } }
            }
            pub(super) mod unrolled {
                plm::mechanism! { pub Scene { code: unrolled; $($items)* } }
            }
        }

        #[test]
        fn $module() {
            let [rolled, unrolled] = [told!($module::rolled::Scene), told!($module::unrolled::Scene)];
            assert!(unrolled.len() > 100, "{} numbers", unrolled.len());
            assert!(unrolled.iter().all(|(_, number)| number.is_finite()));
            for ((of, found), (_, wanted)) in rolled.iter().zip(&unrolled) {
                assert_eq!(found.to_bits(), wanted.to_bits(), "{of}: {found} with loops, {wanted} without");
            }
            assert_eq!(rolled.len(), unrolled.len());
        }
    };
}

/// Start, steps of an explicit and of an implicit method, energies and outputs; with the step that they belong to.
macro_rules! told {
    ($scene:ty) => {{
        let mut told: Vec<(String, f64)> = Vec::new();
        let mut tell =
            |of: &str, values: &[f64]| told.extend(values.iter().map(|value| (of.to_owned(), *value)));
        let mut sim = <$scene>::new().start().unwrap();
        for step in 0..20 {
            let x: Vec<f64> = (0..sim.state().x().len()).map(|k| Vector::at(sim.state().x(), k)).collect();
            tell(&format!("x after {step} steps"), &x);
            tell(&format!("energies after {step} steps"), &[sim.kinetic_energy(), sim.gravity_energy()]);
            tell(&format!("outputs after {step} steps"), &sim.outputs());
            sim.step(0.01).unwrap();
        }
        let mut sim = <$scene>::new().start_with(Ros34Pw2::new(1e-3)).unwrap();
        for step in 0..5 {
            sim.step(1e-3).unwrap();
            tell(&format!("x after {step} implicit steps"), &sim.state().x()[..]);
        }
        told
    }};
}

// Bars of different masses, springs of different stiffness, a force on every third; parameters and an input.
both! { a_chain_of_bars, {
    gravity: 9.81 m/s^2;
    param damping: N*m*s/rad = 0.02 N*m*s/rad;
    param heavy: kg = 0.4 kg;
    input wind: N = 0.3 N;
    ground { port o: (0, 0) m; }
    repeat i in 0..16 {
        body bar[i] {
            mass: 0.1 kg + i*0.01 kg; inertia: 2e-4 kg*m^2 + i*1e-5 kg*m^2;
            port a: (-0.05, 0) m; port b: (0.05 m + i*0.001 m, 0.01 m);
            start angle: 20 deg - i*3 deg, locked; start omega: 0.1 rad/s*i, locked;
        }
    }
    body load { mass: heavy; inertia: 0.01 kg*m^2; port a: (0, 0) m; }
    revolute pin[0](ground.o, bar[0].a) { damping: damping; }
    repeat i in 1..16 {
        revolute pin[i](bar[i - 1].b, bar[i].a) { stiffness: 2 N*m/rad + i*0.1 N*m/rad; damping: damping; }
    }
    revolute hook(bar[15].b, load.a);
    repeat i in 0..5 { force blow[i](bar[3*i].b) { x: wind*sin(t*1 rad/s); } }
    output pin[3].force, load.x, hook.force;
    repeat i in 0..16 { output tilt[i] = bar[i].angle; }
} }

both! { a_chain_in_absolute_coordinates, {
    formulation: absolute;
    gravity: 9.81 m/s^2;
    ground { port o: (0, 0) m; }
    repeat i in 0..12 {
        body bar[i] {
            mass: 0.1 kg; inertia: 2e-4 kg*m^2; port a: (-0.05, 0) m; port b: (0.05, 0) m;
            start x: 0.05 m + i*0.1 m; start angle: i*2 deg;
        }
    }
    revolute pin[0](ground.o, bar[0].a);
    repeat i in 1..12 { revolute pin[i](bar[i - 1].b, bar[i].a) { damping: 1e-3 N*m*s/rad; } }
    output pin[0].force, pin[7].force;
} }

both! { a_ladder_of_four_bars, {
    gravity: 9.81 m/s^2;
    ground { port f0: (0, 0) m; port f1: (1, 0) m; port f2: (2, 0) m; port f3: (3, 0) m; port f4: (4, 0) m;
        port f5: (5, 0) m; port f6: (6, 0) m; port f7: (7, 0) m; port f8: (8, 0) m; port f9: (9, 0) m; port f10: (10, 0) m; }
    repeat i in 0..11 { body up[i] { mass: 1 kg; inertia: 1 kg*m^2/12; port low: (-0.5, 0) m; port high: (0.5, 0) m;
        start x: i*1 m; start y: 0.5 m; start angle: 80 deg; } }
    repeat i in 1..11 { body top[i] { mass: 1 kg; inertia: 1 kg*m^2/12; port a: (-0.5, 0) m; port b: (0.5, 0) m;
        start x: (i - 0.5)*1 m; start y: 1 m; }
        revolute left[i](up[i - 1].high, top[i].a); revolute right[i](top[i].b, up[i].high); }
    revolute foot0(ground.f0, up[0].low); revolute foot1(ground.f1, up[1].low);
    revolute foot2(ground.f2, up[2].low); revolute foot3(ground.f3, up[3].low);
    revolute foot4(ground.f4, up[4].low); revolute foot5(ground.f5, up[5].low);
    revolute foot6(ground.f6, up[6].low); revolute foot7(ground.f7, up[7].low);
    revolute foot8(ground.f8, up[8].low); revolute foot9(ground.f9, up[9].low);
    revolute foot10(ground.f10, up[10].low);
    output foot0.force, up[10].angle;
} }

both! { a_scissor_lift, {
    gravity: 9.81 m/s^2;
    emit: step(rk4);
    ground { port o: (0, 0) m; }
    repeat i in 0..12 {
        body l[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port lo: (-0.25, 0) m; port mid: (0, 0) m; port hi: (0.25, 0) m;
            start angle: 40 deg; start x: 0.19 m; start y: (i + 0.5)*0.32 m; }
        body r[i] { mass: 1 kg; inertia: 0.02 kg*m^2; port lo: (-0.25, 0) m; port mid: (0, 0) m; port hi: (0.25, 0) m;
            start angle: 140 deg; start x: 0.19 m; start y: (i + 0.5)*0.32 m; }
        revolute cross[i](l[i].mid, r[i].mid);
    }
    repeat i in 1..12 { revolute left[i](r[i - 1].hi, l[i].lo); revolute right[i](l[i - 1].hi, r[i].lo); }
    revolute foot(ground.o, l[0].lo);
    pin_slot slide(ground.o, r[0].lo) { damping: 20 N*s/m; }
    output l[11].y, foot.force;
} }

mod long {
    plm::mechanism! {
        pub Chain {
            gravity: 9.81 m/s^2;
            code: rolled;
            param reach: m = 0.05 m;
            ground { port o: (0, 0) m; }
            repeat i in 0..110 {
                body bar[i] {
                    mass: 0.1 kg + i*0.01 kg; inertia: 2e-4 kg*m^2; centre: (0.01, 0) m;
                    port a: (-reach, 0 m); port b: (0.05, 0) m;
                    start angle: 20 deg - i*1 deg; start omega: 0.1 rad/s*i, locked;
                }
            }
            revolute pin[0](ground.o, bar[0].a);
            repeat i in 1..110 { revolute pin[i](bar[i - 1].b, bar[i].a) { damping: 1e-3 N*m*s/rad; } }
        }
    }
}

#[test]
fn tables_of_many_bodies_are_complete() {
    let tables = long::Chain::<f64>::TABLES;
    let mechanism = long::Chain::new();
    assert_eq!((tables.bodies.len(), tables.parts.len()), (110, 110));
    for (k, (body, part)) in tables.bodies.iter().zip(tables.parts).enumerate() {
        assert_eq!((body.name, body.ports), (&*format!("bar[{k}]"), &["a", "b"][..]));
        assert_eq!((part.name, part.kind), (&*format!("pin[{k}]"), "revolute"));
        let frames = part.frames.iter().map(|frame| (frame.argument, frame.body, frame.port));
        let first = if k == 0 { ("a", None, 0) } else { ("a", Some(k - 1), 1) };
        assert_eq!(frames.collect::<Vec<_>>(), [first, ("b", Some(k), 0)]);
        assert!((mechanism.mass(k).unwrap() - (0.1 + 0.01 * k as f64)).abs() < 1e-12);
        // From G, which is 0.01 m from O.
        assert_eq!(mechanism.port(k, 0).unwrap().x, -0.05 - 0.01);
    }
    let names: Vec<&str> = (0..220).map(|k| Labels::name_of_state(&mechanism, k)).collect();
    assert_eq!(
        (names[0], names[109], names[110], names[219]),
        ("bar[0].angle", "bar[109].angle", "bar[0].omega", "bar[109].omega")
    );
    assert_eq!((mechanism.part_of_state(37), mechanism.part_of_state(147)), ("bar[37]", "bar[37]"));
    let [coordinates, rows] = [long::Chain::<f64>::COORDINATES, long::Chain::<f64>::ROWS];
    assert_eq!(
        (coordinates.len(), coordinates[329], rows.len(), rows[219]),
        (330, "bar[109].angle", 220, "pin[109].y")
    );
}

#[test]
fn many_bodies_start_where_they_are_told() {
    let mut mechanism = long::Chain::new();
    let angle = |k: u32| (20.0 - f64::from(k)).to_radians();
    let start = mechanism.start.bar_57;
    assert!((start.angle.value - angle(57)).abs() < 1e-12 && (start.omega.value - 5.7).abs() < 1e-12);
    assert!(start.omega.locked && !start.angle.locked);
    mechanism.start.bar_57.angle = plm::Start::locked(0.5);
    let sim = mechanism.start().unwrap();
    assert_eq!(sim.bar_57().angle, 0.5);
    for (k, own) in [(0, sim.bar_0()), (57, sim.bar_57()), (109, sim.bar_109())] {
        assert_eq!(sim.bar(k), Some(own));
    }
    assert!(sim.bar(110).is_none());
    let branches = sim.branches();
    assert_eq!((branches.len(), branches[108].0), (109, "pin[109]"));
    assert!((branches[56].1 - (0.5 - sim.bar_56().angle)).abs() < 1e-12);
    // O is 0.01 m after G.
    let starts = sim.starts();
    let (o, g) = (starts.bar_57, sim.bar_57());
    assert!((o.x.value - (g.x - 0.01 * g.angle.cos())).abs() < 1e-12 && o.angle.locked);
    let lines: Vec<String> = starts.to_string().lines().map(str::to_owned).collect();
    assert_eq!((lines.len(), &*lines[6 * 57 + 2]), (660, "bar[57].angle = 0.5"));
    assert!(lines[659].starts_with("bar[109].omega = "));
}

#[test]
fn implicit_steps_of_many_bodies_follow_explicit_ones() {
    let mut explicit = long::Chain::new().start().unwrap();
    let mut implicit = long::Chain::new().start_with(Ros34Pw2::new(1e-4)).unwrap();
    explicit.step(1e-4).unwrap();
    implicit.step(1e-4).unwrap();
    for k in 0..110 {
        let (explicit, implicit) = (explicit.bar(k).unwrap().angle, implicit.bar(k).unwrap().angle);
        assert!((explicit - implicit).abs() < 1e-6, "bar {k}: {explicit}, {implicit}");
    }
}
