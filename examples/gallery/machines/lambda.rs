//! Chebyshev's lambda: a four-bar whose coupler draws a line over half a turn of the crank.
//!
//! Source: P. L. Chebyshev, Théorie des mécanismes connus sous le nom de parallélogrammes, 1854, and his walking machine of
//! 1878. The pin of the rocker is the middle between crank pin A and point P, so that the angle at its pivot C is right, and
//! `P = C + R(-90 deg)(A - C) sqrt(25 r^2 - |A - C|^2)/|A - C|`.
//!
//! | crank r | pivots | rocker | coupler |
//! |---|---|---|---|
//! | 100 mm | 200 mm | 250 mm | 250 + 250 mm |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// Chebyshev's lambda on a motor.
    pub Lambda {
        param speed: rev/min = 15 rev/min;
        ground { port o: (0, 0) mm; port c: (200, 0) mm; }
        body crank {
            mass: 5 kg; inertia: disc(5 kg, 0.1 m); port o: (0, 0) mm; port a: (100, 0) mm;
            start angle: 0 deg, locked; start omega: speed, locked;
        }
        body coupler {
            mass: 0.5 kg; inertia: rod(0.5 kg, 0.5 m);
            port a: (-250, 0) mm; port b: (0, 0) mm; port p: (250, 0) mm; start angle: 78 deg;
        }
        body rocker {
            mass: 0.3 kg; inertia: rod(0.3 kg, 0.25 m); centre: (125, 0) mm;
            port c: (0, 0) mm; port b: (250, 0) mm; start x: 200 mm; start angle: 102 deg;
        }
        revolute main(ground.o, crank.o) { drive: 20 N*m*s/rad*(speed - main.speed); }
        revolute pin(crank.a, coupler.a);
        revolute middle(coupler.b, rocker.b);
        revolute pivot(ground.c, rocker.c);
        output coupler.p.position;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Lambda::new()).until(4.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Lambda::new()).until(4.0).every(0.01).with(options)
}
