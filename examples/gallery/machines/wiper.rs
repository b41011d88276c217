//! Two windscreen wipers on one motor: a crank and rocker, and a parallel rod that takes the second wiper along.
//!
//! Source: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980, on the crank and rocker. It turns back where crank and rod
//! lie in line, at the angles `acos((k^2 + c^2 - (p ± r)^2)/(2 k c))` from the line of its pivot and the motor. The lengths are our own:
//!
//! | crank r | rod p | levers c | motor to pivot k | pivots |
//! |---|---|---|---|---|
//! | 45 mm | 297 mm | 60 mm | 300 mm | 550 mm |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A motor and two wipers.
    pub Wiper {
        param speed: rev/min = 40 rev/min;
        param crank_length: m = 45 mm;
        let lever = turn((60, 0) mm, -5 deg);
        ground { port motor: (300, -160) mm; port left: (0, -160) mm; port right: (550, -160) mm; }
        body crank {
            mass: 0.3 kg; inertia: 2e-3 kg*m^2; port o: (0, 0) mm; port pin: (crank_length, 0 m); depth: -12 mm;
            start x: 300 mm; start y: -160 mm; start angle: 0 deg, locked; start omega: speed, locked;
        }
        body rod {
            mass: 0.2 kg; inertia: rod(0.2 kg, 0.297 m); centre: (-148, 0) mm; port pin: (0, 0) mm; port end: (-297, 0) mm; depth: -18 mm;
            start x: 345 mm; start y: -160 mm; start angle: 10 deg;
        }
        body left {
            mass: 0.5 kg; inertia: rod(0.5 kg, 0.5 m); port pivot: (0, 0) mm; port pin: lever; port tip: (470, 0) mm;
            contour: (-14, -10), (14, -10), (120, -5), (120, -9), (490, -9), (490, 9), (120, 9), (120, 5), (14, 10), (-14, 10) mm;
            start y: -160 mm; start angle: 95 deg;
        }
        body right {
            mass: 0.5 kg; inertia: rod(0.5 kg, 0.5 m); port pivot: (0, 0) mm; port pin: lever; port tip: (470, 0) mm;
            contour: (-14, -10), (14, -10), (120, -5), (120, -9), (490, -9), (490, 9), (120, 9), (120, 5), (14, 10), (-14, 10) mm;
            start x: 550 mm; start y: -160 mm; start angle: 95 deg;
        }
        body tie { mass: 0.3 kg; inertia: rod(0.3 kg, 0.55 m); port left: (-275, 0) mm; port right: (275, 0) mm; start x: 0.3 m; depth: -24 mm; }
        revolute motor(ground.motor, crank.o) { drive: 5 N*m*s/rad*(speed - motor.speed); }
        revolute pin(crank.pin, rod.pin);
        revolute end(rod.end, left.pin);
        revolute pivot_left(ground.left, left.pivot);
        revolute pivot_right(ground.right, right.pivot);
        revolute tie_left(left.pin, tie.left);
        revolute tie_right(tie.right, right.pin);
        output left.angle in deg, right.angle in deg;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Wiper::new()).until(3.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Wiper::new()).until(3.0).every(0.01).with(options)
}
