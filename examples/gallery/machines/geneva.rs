//! A Geneva drive with four slots: a turn of the driver becomes a quarter of a turn of the cross, and a rest.
//!
//! Source: J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms, 1980. The pin enters a slot along its
//! direction if `r = d sin(pi/n)`; in the middle the cross turns `r/(d - r)` times as fast as the driver. The lengths are our own:
//!
//! | slots n | between the centres d | pin r |
//! |---|---|---|
//! | 4 | 100 mm | 100 sin(45 deg) mm |
//!
//! There is no contact here: the pin in its slot, and the disc that holds the cross between, are one row, which is exact.

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A driver and a Maltese cross.
    pub Geneva {
        param speed: rev/min = 30 rev/min;
        let distance = 100 mm;
        let pin = distance*sin(45 deg);
        ground { port driver: (0, 0) mm; port cross: (100, 0) mm; }
        body driver {
            mass: 1 kg; inertia: disc(1 kg, 54 mm); port hub: (0, 0) mm; port pin: (pin, 0 m); depth: -10 mm;
            contour: (36, 40), (17, 51), (-6, 54), (-27, 47), (-44, 32), (-53, 11), (-53, -11), (-44, -32), (-27, -47),
                (-6, -54), (17, -51), (36, -40), (24, -26), (40, -9), (71, -8), (76, -6), (78, 0), (76, 6), (71, 8), (40, 9), (24, 26) mm;
        }
        body cross {
            mass: 1 kg; inertia: disc(1 kg, 60 mm); port hub: (0, 0) mm; start x: 100 mm;
            contour: (24, 6), (69, 6), (63, 15), (46, 20), (31, 31), (20, 46), (15, 63), (6, 69), (6, 24),
                (-6, 24), (-6, 69), (-15, 63), (-20, 46), (-31, 31), (-46, 20), (-63, 15), (-69, 6), (-24, 6),
                (-24, -6), (-69, -6), (-63, -15), (-46, -20), (-31, -31), (-20, -46), (-15, -63), (-6, -69), (-6, -24),
                (6, -24), (6, -69), (15, -63), (20, -46), (31, -31), (46, -20), (63, -15), (69, -6), (24, -6) mm;
        }
        revolute main(ground.driver, driver.hub);
        revolute axle(ground.cross, cross.hub);
        constraint drive: driver.angle = speed*t;
        // The angle since the pin was between the centres, from -180 to 180 deg, and that while the pin is in a slot.
        let phase = atan2(sin(driver.angle), cos(driver.angle));
        let within = clamp(phase, -45 deg, 45 deg);
        let turns = (driver.angle - phase)/(2*pi);
        constraint slot: cross.angle = -90 deg*turns - atan2(pin*sin(within), distance - pin*cos(within));
        output cross.angle in deg, ratio = cross.omega/driver.omega;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Geneva::new()).until(8.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Geneva::new()).until(8.0).every(0.01).with(options)
}
