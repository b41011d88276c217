//! Jansen's walker: four legs on one crank, 26 bodies, which walk by contact and friction of their feet. `k` counts pins, `s` sides.
//!
//! Source: T. Jansen, The Great Pretender, 2007, whose "holy numbers" these are, in cm here:
//!
//! | a | b | c | d | e | f | g | h | i | j | k | l | m |
//! |---|---|---|---|---|---|---|---|---|---|---|---|---|
//! | 38.0 | 41.5 | 39.3 | 40.1 | 55.8 | 39.4 | 36.7 | 65.7 | 49.0 | 50.0 | 61.9 | 7.8 | 15.0 |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A contact of a foot with the ground y = 0, with smooth friction.
    part floor(a: frame) {
        let push = if a.y < 0 m then -4e4 N/m*a.y*max(1 - 1 s/m*rate(a.y), 0) else 0 N;
        force on a: (-0.8*push*a.velocity.x/sqrt(a.velocity.x^2 + (0.01 m/s)^2), push);
    }

    /// Jansen's walker.
    pub Jansen {
        param speed: rev/min = -20 rev/min;
        gravity: 9.81 m/s^2;
        body chassis {
            mass: 20 kg; inertia: 2 kg*m^2; port axle: (0, 0) cm; port hip[0]: (-38, -7.8) cm; port hip[1]: (38, -7.8) cm;
            contour: (-42, -12), (42, -12), (42, -4), (8, 6), (-8, 6), (-42, -4) cm; start x: 0 cm, locked; start y: 90.3 cm, locked; start angle: 0 deg, locked;
        }
        body crank {
            mass: 5 kg; inertia: 0.1 kg*m^2; port o: (0, 0) cm; port pin[0]: (15, 0) cm; port pin[1]: (-15, 0) cm;
            start y: 90.3 cm; start angle: 90 deg, locked; start omega: speed, locked;
        }
        revolute axle(chassis.axle, crank.o) { drive: 200 N*m*s/rad*(speed - axle.speed); }
        let hip = acos((41.5^2 + 40.1^2 - 55.8^2)/(2*41.5*40.1));
        let ankle = acos((36.7^2 + 49.0^2 - 65.7^2)/(2*36.7*49.0));
        repeat k in 0..2 {
            repeat s in 0..2 {
                let side = 1 - 2*s; // the right side is the image of the left
                let flip = s*180 deg;
                body thigh[k][s] {
                    mass: 0.8 kg; inertia: 0.02 kg*m^2; port hip: (0, 0) cm; port knee: (41.5, 0) cm;
                    port end: (40.1*cos(hip), 40.1*side*sin(hip)) cm; start x: -38 cm*side; start y: 82.5 cm;
                    start angle: flip + side*(if k < 1 then 102 deg else 66 deg);
                }
                body upper[k][s] {
                    mass: 0.4 kg; inertia: 0.01 kg*m^2; port pin: (0, 0) cm; port knee: (50, 0) cm;
                    start y: 90.3 cm; start angle: flip + side*(if k < 1 then 159 deg else 115 deg);
                }
                body lower[k][s] {
                    mass: 0.4 kg; inertia: 0.01 kg*m^2; port pin: (0, 0) cm; port ankle: (61.9, 0) cm;
                    start y: 90.3 cm; start angle: flip - side*(if k < 1 then 110 deg else 153 deg);
                }
                body strut[k][s] {
                    mass: 0.4 kg; inertia: 0.005 kg*m^2; port hip: (0, 0) cm; port ankle: (39.3, 0) cm;
                    start x: -38 cm*side; start y: 82.5 cm; start angle: flip - side*(if k < 1 then 64 deg else 116 deg);
                }
                body calf[k][s] {
                    mass: 0.4 kg; inertia: 0.005 kg*m^2; port end: (0, 0) cm; port heel: (39.4, 0) cm;
                    start x: -76 cm*side; start y: 82.5 cm; start angle: flip - side*(if k < 1 then 59 deg else 111 deg);
                }
                body foot[k][s] {
                    mass: 0.8 kg; inertia: 0.02 kg*m^2; port ankle: (0, 0) cm; port heel: (36.7, 0) cm;
                    port toe: (49*cos(ankle), 49*side*sin(ankle)) cm; start x: -57 cm*side; start y: 45 cm;
                    start angle: flip + side*(if k < 1 then -173 deg else 152 deg);
                }
                revolute a[k][s](chassis.hip[s], thigh[k][s].hip); revolute b[k][s](chassis.hip[s], strut[k][s].hip);
                revolute c[k][s](crank.pin[k], upper[k][s].pin); revolute d[k][s](crank.pin[k], lower[k][s].pin);
                revolute e[k][s](upper[k][s].knee, thigh[k][s].knee); revolute f[k][s](lower[k][s].ankle, strut[k][s].ankle);
                revolute g[k][s](lower[k][s].ankle, foot[k][s].ankle); floor step[k][s](foot[k][s].toe);
                revolute h[k][s](thigh[k][s].end, calf[k][s].end); revolute i[k][s](calf[k][s].heel, foot[k][s].heel);
            }
        }
        output chassis.position, toe = to_relative(foot[0][0].toe.position, chassis.position, chassis.angle);
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Jansen::new()).until(6.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Jansen::new()).until(6.0).every(0.01).with(options)
}
