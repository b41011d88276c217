//! Andrews' squeezing mechanism: seven bodies of millimetres and grams, which a constant torque moves.
//!
//! Source: W. Schiehlen (ed.), Multibody Systems Handbook, 1990; E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 1996, section
//! VII.7, whose figure of the bodies and lengths these are. The angles after 0.03 s were computed in quadruple precision.

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// Andrews' squeezing mechanism; ports stand from the centre of gravity.
    pub Andrews {
        param motor: N*m = 0.033 N*m;
        ground { port o: (0, 0) mm; port a: (-69.34, -2.27) mm; port b: (-36.35, 32.73) mm; port c: (14, 72) mm; }
        body k1 {
            mass: 43.25e-3 kg; inertia: 2.194e-6 kg*m^2; port o: (-0.92, 0) mm; port f: (6.08, 0) mm;
            start x: 0.92 mm; start angle: -0.0617138900142764496 rad, locked;
        }
        body k2 { mass: 3.65e-3 kg; inertia: 4.41e-7 kg*m^2; port f: (11.5, 0) mm; port e: (-16.5, 0) mm; start x: -4.5 mm; start angle: -0.06 rad; }
        body k3 {
            mass: 23.73e-3 kg; inertia: 5.255e-6 kg*m^2; port e: (-10.43, -16.26) mm; port b: (-10.43, 18.74) mm; port d: (9.57, 0.74) mm;
            start x: -18.7 mm; start y: 20.5 mm; start angle: 0.455 rad;
        }
        body k4 { mass: 7.06e-3 kg; inertia: 5.667e-7 kg*m^2; port e: (0, -14.21) mm; port g: (0, 5.79) mm; start x: -30.2 mm; start y: 12.1 mm; start angle: 0.71 rad; }
        body k5 {
            mass: 70.5e-3 kg; inertia: 1.169e-5 kg*m^2; port g: (16.92, -9.16) mm; port a: (-23.08, -9.16) mm;
            start x: -53.2 mm; start y: 16.6 mm; start angle: 0.487 rad;
        }
        body k6 { mass: 7.06e-3 kg; inertia: 5.667e-7 kg*m^2; port e: (14.21, 0) mm; port h: (-5.79, 0) mm; start x: -28.5 mm; start y: -10.7 mm; start angle: 1.01 rad; }
        body k7 {
            mass: 54.98e-3 kg; inertia: 1.912e-5 kg*m^2; port h: (-12.28, -35.51) mm; port a: (-12.28, 4.49) mm;
            start x: -61 mm; start y: 7.8 mm; start angle: 1.23 rad;
        }
        revolute o(ground.o, k1.o) { drive: motor; }
        revolute f(k1.f, k2.f);
        revolute e3(k2.e, k3.e);
        revolute b(ground.b, k3.b);
        revolute e4(k2.e, k4.e);
        revolute g(k4.g, k5.g);
        revolute a5(ground.a, k5.a);
        revolute e6(k2.e, k6.e);
        revolute h(k6.h, k7.h);
        revolute a7(ground.a, k7.a);
        spring squeeze(ground.c, k3.d) { stiffness: 4530 N/m; free_length: 77.85 mm; }
        output k1.angle in rad, k3.angle in rad, k5.angle in rad;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Andrews::new()).until(0.03).every(1e-4).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Andrews::new()).until(0.03).every(1e-4).with(options)
}
