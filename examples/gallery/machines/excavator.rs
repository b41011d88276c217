//! An excavator: boom, arm, and bucket with its four-bar, on three cylinders.
//!
//! Source: lengths and masses are our own, near those of a machine of 20 t: boom 5.0 m, arm 2.6 m, rocker 0.5 m, link 0.45 m. Oil is a stiff
//! spring on which a flow acts, so that each cylinder holds what statics asks for: its force times its lever about a pivot is the moment of
//! all weights beyond that pivot. The pump has a limit: where it does not suffice all valves open less, by one factor.

use std::error::Error;

use plm::Stabilise;
use plm::view::{Options, Program};

plm::mechanism! {
    /// A cylinder whose oil is stiff. A valve leads it along its way, with a share of the speed that it wants.
    part ram(a: frame, b: frame) {
        param free_length: m; input way: m; input lever: m/s; input share: 1;
        state place: m = 0; state force: kN = 0;
        let want = rate(way) + (way - place)/(0.3 s);
        let speed = share*(want + lever);
        rate place = share*want;
        rate force = 2e7 N/m*(speed - cylinder.speed);
        jack cylinder(a, b) {
            free_length: free_length; piston_diameter: 0.16 m; rod_diameter: 0.1 m;
            drive: force + 4e5 N*s/m*(speed - cylinder.speed);
        }
        output force, needs = pi/4*(0.16 m)^2*abs(want + lever);
    }
    /// An excavator that digs; each lever of the driver is an input.
    pub Excavator {
        gravity: 9.81 m/s^2;
        input boom_lever: m/s = 0; input arm_lever: m/s = 0; input bucket_lever: m/s = 0; param pump_flow: L/min = 500 L/min;
        let needs = boom_ram.needs + arm_ram.needs + bucket_ram.needs;
        let share = min(1, pump_flow/max(needs, 1 L/min));
        let boom_way = smooth_table(t, (0 s, 0 m), (2 s, -0.42 m), (5 s, -0.38 m), (7.5 s, 0.1 m), (10 s, 0.1 m), (12 s, 0 m));
        let arm_way = smooth_table(t, (0 s, 0 m), (2 s, -0.1 m), (5 s, 0.6 m), (7.5 s, 0.55 m), (9.5 s, 0 m), (12 s, 0 m));
        let bucket_way = smooth_table(t, (0 s, 0 m), (2.5 s, 0 m), (5.5 s, 0.3 m), (8 s, 0.32 m), (9.5 s, 0 m), (12 s, 0 m));
        ground { port track: (0, 0) m; }
        body machine {
            mass: 15000 kg; inertia: 3e4 kg*m^2; port track: (0, 0) m; port foot: (0.2, 1.55) m; port ram: (0.75, 1.15) m; depth: -0.3 m;
            contour: (-3.4, 0.45), (-3, 0), (0.9, 0), (1.3, 0.45), (1, 0.9), (0, 0.95), (0, 1.05), (0.95, 1.05), (0.95, 1.3), (0.45, 1.8), (0.3, 2.9),
                (-1, 2.9), (-1.05, 2.1), (-2.9, 2), (-3.2, 1.8), (-3.2, 1.05), (-1.6, 1.05), (-1.6, 0.95), (-3, 0.9) m;
        }
        body boom {
            mass: 1500 kg; inertia: 4000 kg*m^2; centre: (2.4, 0.7) m; port foot: (0, 0) m; port tip: (5, 0) m; port ram: (2.1, 0.75) m; port arm: (2.9, 1.35) m;
            contour: (-0.2, -0.1), (0, -0.22), (2.2, 0.6), (2.7, 0.65), (4.9, -0.2), (5.2, -0.1), (5.15, 0.15), (3.1, 1.3), (2.9, 1.5), (2.7, 1.3), (2.1, 1.2), (-0.15, 0.2) m;
            start x: 0.2 m; start y: 1.55 m; start angle: 30 deg, locked;
        }
        body arm {
            mass: 800 kg; inertia: 900 kg*m^2; centre: (0.8, 0.1) m; port pivot: (0, 0) m; port ram: (-0.75, 0.25) m; port bucket_ram: (0.15, 0.5) m;
            port rocker: (2.2, 0) m; port tip: (2.6, 0) m;
            contour: (-0.9, 0.2), (-0.75, 0.4), (0.1, 0.62), (0.3, 0.4), (2.7, 0.1), (2.75, -0.1), (2.5, -0.15), (0.2, -0.3), (-0.2, -0.25) m;
            start x: 4.53 m; start y: 4.05 m; start angle: -65 deg, locked;
        }
        body bucket {
            mass: 900 kg; inertia: 200 kg*m^2; centre: (0.6, 0.1) m; port pivot: (0, 0) m; port link: (0.18, 0.34) m; port teeth: (1.35, -0.5) m;
            contour: (-0.12, 0), (0.1, 0.45), (0.55, 0.55), (0.95, 0.4), (1.2, 0), (1.35, -0.5), (1.05, -0.3), (0, -0.22) m;
            start x: 5.63 m; start y: 1.7 m; start angle: -65 deg, locked;
        }
        body rocker { mass: 60 kg; inertia: 3 kg*m^2; port arm: (0, 0) m; port link: (0.503, 0) m; start x: 5.4 m; start y: 2 m; start angle: 8 deg; }
        body link { mass: 60 kg; inertia: 3 kg*m^2; port rocker: (0, 0) m; port bucket: (0.452, 0) m; start x: 6 m; start y: 2 m; start angle: -83 deg; }
        weld stands(ground.track, machine.track);
        revolute foot(machine.foot, boom.foot);
        revolute pivot(boom.tip, arm.pivot);
        revolute wrist(arm.tip, bucket.pivot);
        revolute a(arm.rocker, rocker.arm);
        revolute b(rocker.link, link.rocker);
        revolute c(link.bucket, bucket.link);
        ram boom_ram(machine.ram, boom.ram) { free_length: 1.5 m; way: boom_way; lever: boom_lever; share: share; }
        ram arm_ram(boom.arm, arm.ram) { free_length: 1.9 m; way: arm_way; lever: arm_lever; share: share; }
        ram bucket_ram(arm.bucket_ram, rocker.link) { free_length: 1.7 m; way: bucket_way; lever: bucket_lever; share: share; }
        observe boom, arm, rocker, link, bucket;
        output boom_ram.force in kN, arm_ram.force in kN, bucket_ram.force in kN, bucket.teeth.position, flow = share*needs in L/min;
    }
}

/// At rest: the forces of the cylinders that hold it.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    let held = Excavator::new().stabilise()?.balanced()?.mechanism;
    Program::new(held).until(12.0).every(0.02).with(options)
}
