//! Whitworth's quick return: the ram of a shaping machine goes back faster than it cuts.
//!
//! Source: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980. The
//! slotted lever's pivot lies within the circle of the crank pin, e below its centre. The ram rests where the lever is level,
//! and the crank has turned by `180 deg + 2 asin(e/r)` and by the rest of a turn between. The lengths are our own:
//!
//! | crank r | pivot below e | lever | rod |
//! |---|---|---|---|
//! | 100 mm | 50 mm | 80 mm | 300 mm |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// Whitworth's quick return on a motor.
    pub Whitworth {
        param speed: rev/min = 15 rev/min;
        ground { port o: (0, 0) mm; port pivot: (0, -50) mm; port rail: (380, -50) mm; }
        body crank {
            mass: 10 kg; inertia: disc(10 kg, 0.12 m); port o: (0, 0) mm; port pin: (100, 0) mm; depth: -20 mm;
            start angle: 90 deg, locked; start omega: speed, locked;
        }
        body lever {
            mass: 2 kg; inertia: rod(2 kg, 0.26 m); port slot: (0, 0) mm; port end: (-80, 0) mm;
            contour: (-95, -15), (165, -15), (165, 15), (-95, 15) mm;
            start y: -50 mm; start angle: 90 deg;
        }
        body link {
            mass: 1 kg; inertia: rod(1 kg, 0.3 m); centre: (150, 0) mm; depth: 20 mm;
            port end: (0, 0) mm; port ram: (300, 0) mm; start y: -130 mm; start angle: 15 deg;
        }
        body ram {
            mass: 8 kg; inertia: plate(8 kg, 0.3 m, 0.05 m); port pin: (0, 0) mm; port tool: (210, -50) mm;
            contour: (-25, -20), (190, -20), (200, -55), (220, -55), (220, 25), (-25, 25) mm;
            start x: 290 mm; start y: -50 mm;
        }
        revolute main(ground.o, crank.o) { drive: 400 N*m*s/rad*(speed - main.speed); }
        revolute pivot(ground.pivot, lever.slot);
        pin_slot block(lever.slot, crank.pin);
        revolute end(lever.end, link.end);
        revolute pin(link.ram, ram.pin);
        prismatic guide(ground.rail, ram.pin);
        output guide.displacement in mm, guide.speed;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Whitworth::new()).until(4.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Whitworth::new()).until(4.0).every(0.01).with(options)
}
