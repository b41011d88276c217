//! An excavator: boom, arm, and bucket with its four-bar, on three cylinders.
//!
//! Source: lengths and masses are our own, near those of a machine of 20 t: boom 5.0 m, arm 2.6 m, rocker 0.5 m, link 0.45 m. Each cylinder
//! holds what statics asks for: its force times its lever about a pivot is the moment of all weights beyond that pivot. One pump with a
//! swash plate feeds three proportional valves. It keeps its pressure above that of the heaviest load (load sensing), delivers no more
//! than its displacement times its speed, and takes no more than a power: where that does not suffice all cylinders are slower.

use std::error::Error;

use plm::Stabilise;
use plm::view::{Options, Program};

plm::mechanism! {
    /// A cylinder behind a proportional valve, whose spool follows a way. Oil comes back from the drain where a load runs ahead.
    part ram(a: frame, b: frame, supply: oil, drain: oil) {
        param free_length: m; param begin: m; param stroke: m; input way: m; input lever: m/s;
        state moved: m = 0; rate moved = lever;
        let target = begin + way + moved;
        jack tube(a, b) { free_length: free_length; piston_diameter: 0.16 m; rod_diameter: 0.1 m; }
        cylinder oil(tube.slider) { piston_diameter: 0.16 m; rod_diameter: 0.1 m; stroke: stroke; dead_volume: 6 L; friction: 3e4 N/(m/s);
            chamber2.pressure: 30 bar, locked; chamber1.pressure: 80 bar; }
        // What the load shakes by is taken off the speed: it damps the mass on its oil.
        state settled: kN = 0; rate settled = (oil.force - settled)/(0.3 s);
        let wanted = rate(target) + 2.5/(1 s)*(target - tube.displacement) - 2.5e-7 m/s/(1 N)*(oil.force - settled);
        let command = clamp(wanted/(0.45 m/s), -1, 1);
        proportional_valve valve(supply, oil.port1, oil.port2, drain) {
            signal: command; overlap: 0.03; rated_flow: 400 L/min; rated_drop: 20 bar; transition: 3 bar; frequency: 15 Hz; }
        check_valve fill1(drain, oil.port1) { rated_flow: 400 L/min; rated_drop: 5 bar; transition: 3 bar; rise: 2 bar; }
        check_valve fill2(drain, oil.port2) { rated_flow: 400 L/min; rated_drop: 5 bar; transition: 3 bar; rise: 2 bar; }
        output force = oil.force, load = clamp(20*valve.opening, 0, 1)*oil.pressure1 + clamp(-20*valve.opening, 0, 1)*oil.pressure2;
    }
    /// An engine whose governor keeps its speed.
    part diesel() { param speed: rad/s; node shaft: shaft = speed*t; }
    /// An excavator that digs; each lever of the driver is an input.
    pub Excavator {
        gravity: 9.81 m/s^2;
        input boom_lever: m/s = 0; input arm_lever: m/s = 0; input bucket_lever: m/s = 0;
        param pump_flow: L/min = 430 L/min; param pump_power: kW = 90 kW;
        let boom_way = smooth_table(t, (0 s, 0 m), (2 s, -0.42 m), (5 s, -0.38 m), (7.5 s, 0.1 m), (10 s, 0.1 m), (12 s, 0 m));
        let arm_way = smooth_table(t, (0 s, 0 m), (2 s, -0.1 m), (5 s, 0.6 m), (7.5 s, 0.55 m), (9.5 s, 0 m), (12 s, 0 m));
        let bucket_way = smooth_table(t, (0 s, 0 m), (2.5 s, 0 m), (5.5 s, 0.3 m), (8 s, 0.32 m), (9.5 s, 0 m), (12 s, 0 m));
        diesel engine() { speed: 1800 rev/min; } oil_tank tank() { pressure: 5 bar; } chamber line() { dead_volume: 8 L; pressure: 30 bar; }
        let load = max(boom_ram.load, arm_ram.load, bucket_ram.load); let wanted = clamp((load + 30 bar - line.pressure)/(20 bar), 0, 1);
        lag swash() { signal: wanted; time_constant: 30 ms; } let most = pump_power/(pump_flow*max(line.pressure - 5 bar, 1 bar));
        pump main(engine.shaft, tank.port, line.port) { displacement: pump_flow/(1800 rev/min); setting: min(swash.value, most); }
        relief_valve safety(line.port, tank.port) { cracking: 340 bar; rise: 20 bar; rated_flow: 430 L/min; rated_drop: 340 bar; transition: 3 bar; }
        ground { port track: (0, 0) m; }
        body machine { mass: 15000 kg; inertia: 3e4 kg*m^2; port track: (0, 0) m; port foot: (0.2, 1.55) m; port ram: (0.75, 1.15) m; depth: -0.3 m;
            contour: (-3.4, 0.45), (-3, 0), (0.9, 0), (1.3, 0.45), (1, 0.9), (0, 0.95), (0, 1.05), (0.95, 1.05), (0.95, 1.3), (0.45, 1.8), (0.3, 2.9),
                (-1, 2.9), (-1.05, 2.1), (-2.9, 2), (-3.2, 1.8), (-3.2, 1.05), (-1.6, 1.05), (-1.6, 0.95), (-3, 0.9) m; }
        body boom { mass: 1500 kg; inertia: 4000 kg*m^2; centre: (2.4, 0.7) m; port foot: (0, 0) m; port tip: (5, 0) m; port ram: (2.1, 0.75) m; port arm: (2.9, 1.35) m;
            contour: (-0.2, -0.1), (0, -0.22), (2.2, 0.6), (2.7, 0.65), (4.9, -0.2), (5.2, -0.1), (5.15, 0.15), (3.1, 1.3), (2.9, 1.5), (2.7, 1.3), (2.1, 1.2), (-0.15, 0.2) m;
            start x: 0.2 m; start y: 1.55 m; start angle: 30 deg, locked; }
        body arm { mass: 800 kg; inertia: 900 kg*m^2; centre: (0.8, 0.1) m; port pivot: (0, 0) m; port ram: (-0.75, 0.25) m; port bucket_ram: (0.15, 0.5) m;
            port rocker: (2.2, 0) m; port tip: (2.6, 0) m;
            contour: (-0.9, 0.2), (-0.75, 0.4), (0.1, 0.62), (0.3, 0.4), (2.7, 0.1), (2.75, -0.1), (2.5, -0.15), (0.2, -0.3), (-0.2, -0.25) m;
            start x: 4.53 m; start y: 4.05 m; start angle: -65 deg, locked; }
        body bucket { mass: 900 kg; inertia: 200 kg*m^2; centre: (0.6, 0.1) m; port pivot: (0, 0) m; port link: (0.18, 0.34) m; port teeth: (1.35, -0.5) m;
            contour: (-0.12, 0), (0.1, 0.45), (0.55, 0.55), (0.95, 0.4), (1.2, 0), (1.35, -0.5), (1.05, -0.3), (0, -0.22) m;
            start x: 5.63 m; start y: 1.7 m; start angle: -65 deg, locked; }
        body rocker { mass: 60 kg; inertia: 3 kg*m^2; port arm: (0, 0) m; port link: (0.503, 0) m; start x: 5.4 m; start y: 2 m; start angle: 8 deg; }
        body link { mass: 60 kg; inertia: 3 kg*m^2; port rocker: (0, 0) m; port bucket: (0.452, 0) m; start x: 6 m; start y: 2 m; start angle: -83 deg; }
        weld stands(ground.track, machine.track); revolute foot(machine.foot, boom.foot);
        revolute pivot(boom.tip, arm.pivot); revolute wrist(arm.tip, bucket.pivot);
        revolute a(arm.rocker, rocker.arm); revolute b(rocker.link, link.rocker); revolute c(link.bucket, bucket.link);
        ram boom_ram(machine.ram, boom.ram, line.port, tank.port) { free_length: 1.5 m; begin: 0.7818 m; stroke: 1.2 m; way: boom_way; lever: boom_lever; }
        ram arm_ram(boom.arm, arm.ram, line.port, tank.port) { free_length: 1.9 m; begin: 0.594 m; stroke: 1.4 m; way: arm_way; lever: arm_lever; }
        ram bucket_ram(arm.bucket_ram, rocker.link, line.port, tank.port) { free_length: 1.5 m; begin: 0.7003 m; stroke: 1.1 m; way: bucket_way; lever: bucket_lever; }
        observe boom, arm, rocker, link, bucket; output main.flow in L/min, main.power in kW, line.pressure in bar;
        output boom_ram.force in kN, arm_ram.force in kN, bucket_ram.force in kN, bucket.teeth.position;
    }
}

/// At rest: the forces of the cylinders that hold it.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    let held = Excavator::new().stabilise()?.balanced()?.mechanism;
    Program::new(held).until(12.0).every(0.02).with(options)
}
