//! Watt's straight line: the middle of a coupler between two levers runs along an eight, whose middle is almost straight.
//!
//! Source: J. Watt, patent 1432, 1784; the curve: `r^2 = b^2 - (a sin w + sqrt(c^2 - a^2 cos^2 w))^2` about the middle of the
//! pivots, from their line (J. D. Lawrence, A Catalog of Special Plane Curves, 1972). The lengths are our own:
//!
//! | levers b | coupler 2c | pivots 2a |
//! |---|---|---|
//! | 300 mm | 200 mm | 2 sqrt(300^2 + 100^2) mm |
//!
//! Nothing drives it and nothing pulls: once moved it goes round the whole curve, with constant energy.

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// Watt's linkage, which turns by itself.
    pub Watt {
        ground { port left: (-300, 100) mm; port right: (300, -100) mm; }
        body lever {
            mass: 1 kg; inertia: rod(1 kg, 0.3 m); centre: (150, 0) mm;
            port pivot: (0, 0) mm; port pin: (300, 0) mm;
            start x: -300 mm; start y: 100 mm; start angle: 0 deg, locked; start omega: 1 rad/s, locked;
        }
        body coupler {
            mass: 0.5 kg; inertia: rod(0.5 kg, 0.2 m);
            port top: (0, 100) mm; port middle: (0, 0) mm; port bottom: (0, -100) mm;
        }
        body other {
            mass: 1 kg; inertia: rod(1 kg, 0.3 m); centre: (-150, 0) mm;
            port pivot: (0, 0) mm; port pin: (-300, 0) mm;
            start x: 300 mm; start y: -100 mm;
        }
        revolute left(ground.left, lever.pivot);
        revolute top(lever.pin, coupler.top);
        revolute bottom(coupler.bottom, other.pin);
        revolute right(ground.right, other.pivot);
        output coupler.middle.position;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Watt::new()).until(7.2).every(0.018).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Watt::new()).until(7.2).every(0.018).with(options)
}
