//! A pumpjack: crank, pitman and walking beam lift the rod of an oil well.
//!
//! Source: letters as in API Specification 11E, Pumping Units; the lengths are our own. The beam turns back where crank and pitman lie in
//! line, at the angles `acos((K^2 + C^2 - (P ± R)^2)/(2 K C))`, and the rope runs on the circle A of the horse head.
//!
//! | beam, front A | beam, rear C | pitman P | crank R | crank from the saddle K |
//! |---|---|---|---|---|
//! | 3.0 m | 2.4 m | 2.8 m | 0.9 m | sqrt(2.6^2 + 2.8^2) m |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// The rope on the head: what the beam turns, the rod rises. It leaves the head at a place that rests.
    joint rope(leaves: frame, rod: frame, beam: frame) {
        param radius: m;
        param rest: m;
        param rod_diameter: m = 30 mm;
        param piston_diameter: m = 50 mm;
        picture rod_diameter, piston_diameter;
        constraint length: rod.y + radius*beam.angle = rest;
        output tension = reaction(length);
    }

    /// A pumpjack with its counterweight, on a motor that slips.
    pub Pumpjack {
        param speed: rev/min = 12 rev/min;
        param weight: kg = 1600 kg;
        gravity: 9.81 m/s^2;
        ground { port skid: (0, 0) m; port well: (-3, 0) m, axis: 90 deg; port leaves: (-3, 4.2) m; }
        body frame {
            mass: 5000 kg; inertia: 1e4 kg*m^2; port skid: (0, 0) m; port saddle: (0, 4.2) m; port shaft: (2.6, 1.4) m; depth: -0.4 m;
            contour: (-1.3, 0), (-1.3, -0.2), (3.6, -0.2), (3.6, 0), (3.1, 0), (2.75, 1.5), (2.45, 1.5), (2.1, 0), (1.1, 0), (0.12, 4.3), (-0.12, 4.3), (-1.1, 0),
                (-0.85, 0), (0, 3.7), (0.85, 0) m;
        }
        weld stands(ground.skid, frame.skid);
        body crank {
            mass: weight; inertia: 800 kg*m^2; centre: (1.0, 0) m; port o: (0, 0) m; port pin: (0.9, 0) m;
            contour: (-0.2, -0.2), (0.6, -0.2), (0.75, -0.55), (1.4, -0.55), (1.5, 0), (1.4, 0.55), (0.75, 0.55), (0.6, 0.2), (-0.2, 0.2) m;
            start x: 2.6 m; start y: 1.4 m; start angle: 0 deg, locked; start omega: speed, locked;
        }
        body pitman {
            mass: 150 kg; inertia: rod(150 kg, 2.8 m); port pin: (-1.4, 0) m; port tail: (1.4, 0) m; depth: 0.1 m;
            start x: 3 m; start y: 2.8 m; start angle: 110 deg;
        }
        body beam {
            mass: 900 kg; inertia: 2500 kg*m^2; centre: (-0.6, 0) m; port saddle: (0, 0) m; port tail: (2.4, 0) m; port head: (-3, 0) m;
            contour: (2.5, 0.14), (-2.35, 0.2), (-2.6, 1.35), (-2.72, 1.27), (-2.86, 0.9), (-2.97, 0.45), (-3, 0), (-2.97, -0.45), (-2.86, -0.9),
                (-2.72, -1.27), (-2.6, -1.35), (-2.35, -0.2), (2.5, -0.14) m;
            start y: 4.2 m; start angle: 5 deg;
        }
        body rod {
            mass: 1200 kg; inertia: 100 kg*m^2; port clamp: (0, 0) m, angle: 90 deg;
            contour: (-0.03, -3), (0.03, -3), (0.03, 0), (0.2, 0), (0.2, 0.1), (-0.2, 0.1), (-0.2, 0), (-0.03, 0) m;
            start x: -3 m; start y: 1.7 m;
        }
        revolute shaft(frame.shaft, crank.o) { drive: 2e5 N*m*s/rad*(speed - shaft.speed); }
        revolute pin(crank.pin, pitman.pin);
        revolute tail(pitman.tail, beam.tail);
        revolute saddle(frame.saddle, beam.saddle);
        prismatic well(ground.well, rod.clamp);
        rope bridle(ground.leaves, rod.clamp, beam.saddle) { radius: 3 m; rest: 1.6 m; }
        output rod.clamp.y, shaft.torque in kN*m, bridle.tension in kN;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Pumpjack::new()).until(5.0).every(0.0125).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Pumpjack::new()).until(5.0).every(0.0125).with(options)
}
