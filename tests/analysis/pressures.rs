//! Equilibria of pressures against statics and the manual's figures.

use plm::{Stabilise, What};

use super::stabilise::{assert_close, value};
use crate::scene::{Given as _, Named as _};

scene! {
    /// The manual's 3.2.1: an arm on a jack with two chambers, each with a line to a closed valve.
    pub Arm {
        gravity: 9.81 m/s^2;
        param bore: m^2 = pi/4*(0.05 m)^2;
        param annulus: m^2 = pi/4*((0.05 m)^2 - (0.03 m)^2);
        param bulk: Pa = 17000 bar;
        param conductance: m^3/s/Pa = 1e-9 m^3/s/Pa;
        ground { port o: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 10 kg*m^2;
            port tip: (0.2, 0) m;
            port jack: (-0.5, 0) m;
            port pivot: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute pivot(ground.o, arm.pivot);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; drive: p1*bore - p2*annulus; }
        state p1: Pa = 0;
        state p2: Pa = 5 bar;
        state line1: Pa = 0;
        state line2: Pa = 0;
        let q1 = conductance*(line1 - p1);
        let q2 = conductance*(line2 - p2);
        rate p1 = bulk/(50e-6 m^3 + bore*ram.displacement)*(q1 - bore*ram.speed);
        rate p2 = bulk/(50e-6 m^3 + annulus*(0.35 m - ram.displacement))*(q2 + annulus*ram.speed);
        rate line1 = -bulk/0.5e-3 m^3*q1;
        rate line2 = -bulk/0.5e-3 m^3*q2;
        output ram.force, ram.displacement;
    }
}

#[test]
fn one_locked_pressure_settles_the_others() {
    let arm = Arm::new().with_lock("p2", 5e5);
    let found = arm.stabilise().unwrap().balanced().unwrap();
    // tests/manual/numbers.json, ConnectPlmHyd: "p1", "F jack", exact.
    assert_close(value(&found, "p1") / 1e5, 27.258_755_030_885_03, 1e-10);
    assert_close(value(&found, "line1"), value(&found, "p1"), 1e-12);
    assert_eq!(value(&found, "p2"), 5e5);
    assert_close(value(&found, "line2"), 5e5, 1e-12);
    assert!(found.free.is_empty(), "{:?}", found.free);
    let mut sim = found.start().unwrap();
    assert_close(sim.value_of("ram.force"), 4_723.925_503_721_555, 1e-10);
    let angle = sim.state_of("arm").angle;
    sim.step(0.5).unwrap();
    assert_close(sim.state_of("arm").angle, angle, 1e-10);
}

#[test]
fn pressures_that_can_be_elsewhere_are_named() {
    let found = Arm::new().stabilise().unwrap().balanced().unwrap();
    let [freedom] = &found.free[..] else { panic!("{:?}", found.free) };
    assert_eq!((freedom.count, &freedom.names[..]), (1, &["p1", "p2", "line1", "line2"][..]));
    assert_eq!(freedom.to_string(), "lock one of p1, p2, line1, line2");
    // Nearest: from (0, 5, 0, 0) bar to a p1 - b p2 = F with the lines alike, min 2 (p1)^2 + (p2 - 5)^2 + p2^2.
    let (bore, annulus, force) =
        (0.05_f64.powi(2), 0.05_f64.powi(2) - 0.03_f64.powi(2), 4_723.925_503_721_555);
    let quarter = core::f64::consts::FRAC_PI_4;
    let (a, b) = (quarter * bore * 1e5, quarter * annulus * 1e5);
    let multiplier = (force + 2.5 * b) / (a * a + b * b);
    assert_close(value(&found, "p1") / 1e5, a * multiplier, 1e-9);
    assert_close(value(&found, "p2") / 1e5, 2.5 - b * multiplier, 1e-9);
}

scene! {
    /// A tank whose oil runs through a chamber to where there is no pressure.
    pub Leak {
        ground { port o: (0, 0) m; }
        body wheel { mass: 1 kg; inertia: 1 kg*m^2; port o: (0, 0) m; }
        revolute o(ground.o, wheel.o) { stiffness: 10 N*m/rad; rest: 0.2 rad; }
        state tank: Pa = 6 bar;
        state chamber: Pa = 0;
        rate tank = (chamber - tank)*3/1 s;
        rate chamber = (5*(tank - chamber) - 10*chamber)/1 s;
    }
}

#[test]
fn a_locked_pressure_that_leaks_names_its_rate() {
    let leak = Leak::new().with_lock("tank", 6e5);
    let found = leak.stabilise().unwrap();
    // Of 6 bar a third is left: 5 (6 - p) = 10 p.
    assert_close(value(&found, "chamber"), 2e5, 1e-12);
    assert_close(value(&found, "wheel.angle"), 0.2, 1e-12);
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("tank", What::LockedState));
    assert_close(residual.value, -12e5, 1e-12);
    // Without the lock it runs dry.
    let dry = Leak::new().stabilise().unwrap().balanced().unwrap();
    assert!(value(&dry, "tank").abs() < 1e-6 && value(&dry, "chamber").abs() < 1e-6);
}

scene! {
    /// A mass on a column of oil: p' = -B s'/s.
    pub Column {
        gravity: 9.81 m/s^2;
        param area: m^2 = 1e-3 m^2;
        param bulk: Pa = 20 bar;
        ground { port rail: (0, 0) m, axis: 90 deg; }
        body mass { mass: 200 kg; inertia: 1 kg*m^2; port rail: (0, 0) m, angle: 90 deg; start y: 0.8 m; }
        prismatic guide(ground.rail, mass.rail) { drive: pressure*area; }
        state pressure: Pa = 3 bar;
        rate pressure = -bulk*guide.speed/guide.displacement;
    }
}

#[test]
fn a_closed_chamber_is_compressed_from_where_it_was() {
    let found = Column::new().stabilise().unwrap().balanced().unwrap();
    let pressure = 200.0 * 9.81 / 1e-3;
    assert_close(value(&found, "pressure"), pressure, 1e-9);
    // p - p0 = B ln(s0/s), whatever the way.
    assert_close(value(&found, "mass.y"), 0.8 * f64::exp(-(pressure - 3e5) / 20e5), 1e-9);
    assert!(found.free.is_empty());
}

scene! {
    /// The manual's 3.3: an arm on a jack, and a second one that slides on it, held by another jack.
    pub DoubleArm {
        gravity: 9.81 m/s^2;
        param bore: m^2 = pi/4*(0.05 m)^2;
        param annulus: m^2 = pi/4*((0.05 m)^2 - (0.03 m)^2);
        ground { port o: (0, 0) m; port foot: (0, -0.25) m; }
        /// A jack's two chambers, each closed by a narrow gap.
        part chambers(on: slider) {
            param bore: m^2;
            param annulus: m^2;
            state p1: Pa = 0;
            state p2: Pa = 5 bar;
            state line1: Pa = 0;
            state line2: Pa = 0;
            rate p1 = (line1 - p1)/1e-3 s - 3e10 Pa/m*rate(on.position);
            rate p2 = (line2 - p2)/1e-3 s + 2e10 Pa/m*rate(on.position);
            rate line1 = (p1 - line1)/2e-3 s;
            rate line2 = (p2 - line2)/2e-3 s;
            force on on: p1*bore - p2*annulus;
        }
        body arm {
            mass: 100 kg;
            inertia: 10 kg*m^2;
            port pivot: (-0.4, 0) m;
            port jack: (-0.1, 0) m;
            port rail: (0, 0) m;
            start angle: 20 deg, locked;
        }
        body boom {
            mass: 100 kg;
            inertia: 10 kg*m^2;
            port rail: (0, 0) m;
            start x: 0.9 m, locked;
            start angle: 20 deg;
        }
        revolute pivot(ground.o, arm.pivot);
        prismatic rail(arm.rail, boom.rail);
        jack lift(ground.foot, arm.jack);
        chambers below(lift.slider) { bore: bore; annulus: annulus; p2: 5 bar, locked; }
        chambers inside(rail.slider) { bore: bore; annulus: annulus; p2: 5 bar, locked; }
        output lift.force, rail.drive_force;
    }
}

#[test]
fn the_double_arm_has_the_pressures_of_the_manual() {
    let found = DoubleArm::new().stabilise().unwrap().balanced().unwrap();
    assert!(found.free.is_empty(), "{:?}", found.free);
    // tests/manual/numbers.json, DoubleArm: exact values at 9.81 m/s^2.
    assert_close(value(&found, "below.p1") / 1e5, 44.032_518_894_917_23, 1e-9);
    assert_close(value(&found, "inside.p1") / 1e5, 4.908_798_294_872_963, 1e-9);
    let sim = found.start().unwrap();
    assert_close(sim.value_of("rail.drive_force"), 335.521_760_602_479, 1e-9);
    assert!((sim.value_of("lift.force") - 8017.446).abs() < 1e-3);
    // The printed force belongs to g = 9.80665.
    let share = 9.80665 / 9.81;
    assert_close(sim.value_of("lift.force") * share, 8_014.708_472_802_279, 1e-9);
}

scene! {
    /// The manual's 3.2.1 with the library's cylinder, lines and servo-valve, and integrals that nothing reads.
    pub ServoArm {
        gravity: 9.81 m/s^2;
        param leak: 1 = 0;
        ground { port o0: (0, 0) m; port foot: (0, -0.25) m; }
        body arm {
            mass: 100 kg;
            inertia: 0.01 kg*m^2;
            port jack: (-0.5, 0) m;
            port o0: (-0.8, 0) m;
            start angle: 20 deg, locked;
        }
        revolute hinge(ground.o0, arm.o0);
        jack ram(ground.foot, arm.jack) { free_length: 0.22 m; }
        cylinder press(ram.slider) {
            piston_diameter: 50 mm;
            rod_diameter: 30 mm;
            stroke: 0.35 m;
            friction: 1000 N/(m/s);
            chamber2.pressure: 5 bar, locked;
        }
        oil_line line1(press.port1);
        oil_line line2(press.port2) { inlet.pressure: 5 bar; }
        servo_valve valve(pump.port, line1.port, line2.port, tank.port) { frequency: 20 Hz; }
        oil_source pump() { pressure: 30 bar; }
        oil_tank tank() { pressure: 5 bar; }
        // Past everything, from the pump to the tank.
        orifice past(pump.port, tank.port) { opening: leak; }
        state drawn: L = 0;
        rate drawn = pump.flow;
        output press.force, press.pressure1 in bar;
    }
}

#[test]
fn the_parts_of_the_library_come_to_rest() {
    let found = ServoArm::new().stabilise().unwrap().balanced().unwrap();
    assert!(found.free.is_empty(), "{:?}", found.free);
    assert_close(value(&found, "press.chamber1.pressure") / 1e5, 27.258_755_030_885_03, 1e-9);
    let mut sim = found.start().unwrap();
    assert_close(sim.value_of("press.force"), 4_723.925_503_721_555, 1e-9);
    sim.step(0.2).unwrap();
    assert!((sim.state_of("arm").angle - 20_f64.to_radians()).abs() < 1e-9);
    // Nothing locked: one level of pressure, and the height that goes with it.
    let free = ServoArm::new().released("press.chamber2.pressure");
    let found = free.stabilise().unwrap().balanced().unwrap();
    let [freedom] = &found.free[..] else { panic!("{:?}", found.free) };
    let names = [
        "press.chamber1.pressure",
        "press.chamber2.pressure",
        "line1.inlet.pressure",
        "line2.inlet.pressure",
    ];
    assert_eq!((freedom.count, &freedom.names[..]), (1, &names[..]));
}

#[test]
fn an_integral_that_never_rests_is_told_and_changes_nothing() {
    let found = ServoArm::new().with("leak", 1.0).stabilise().unwrap();
    assert_close(value(&found, "press.chamber1.pressure") / 1e5, 27.258_755_030_885_03, 1e-9);
    let [residual] = &found.residuals[..] else { panic!("{:?}", found.residuals) };
    assert_eq!((residual.name.as_str(), residual.what), ("drawn", What::State));
    // 20 L/min at 1 bar, by the root of 25 bar.
    assert_close(residual.value, 5.0 * 20e-3 / 60.0, 1e-4);
}
