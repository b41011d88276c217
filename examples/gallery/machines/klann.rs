//! Klann's linkage: a pair of legs on one crank in place of a wheel.
//!
//! Source: J. Klann, Walking Device, US patent 6 260 862, 2001, with the numbers of its figure 2: 29 is the crank pin, 27 the elbow, 35 the
//! knee, 37 the hip, 33 the foot; 9 and 11 are the axles of the rockers, 15 the crank. The stride is the unit of its lengths, in metres here:
//!
//! | 15-29 | 29-27 | 27-35 | 29-35 | 11-27 | 9-37 | 35-37 | 35-33 | 37-33 | 9 | 11 | 15 |
//! |---|---|---|---|---|---|---|---|---|---|---|---|
//! | 0.268 | 0.590 | 0.5221 | 1.1051 | 0.3206 | 0.5177 | 0.8966 | 0.8966 | 1.732 | (1.366, 1.366) | (1.009, 0.574) | (1.599, 0.750) |

use std::error::Error;

use plm::view::{Options, Program};

plm::mechanism! {
    /// A pair of Klann's legs, half a turn apart; the frame is held.
    pub Klann {
        param speed: rev/min = 15 rev/min;
        ground {
            port o: (0, 0) m;
            port high[0]: (-0.233, 0.616) m; port high[1]: (0.233, 0.616) m;
            port deep[0]: (-0.590, -0.176) m; port deep[1]: (0.590, -0.176) m;
        }
        body crank {
            mass: 5 kg; inertia: disc(5 kg, 0.3 m); port o: (0, 0) m; port pin[0]: (0.268, 0) m; port pin[1]: (-0.268, 0) m;
            start angle: 0 deg, locked; start omega: speed, locked;
        }
        revolute main(ground.o, crank.o) { drive: 200 N*m*s/rad*(speed - main.speed); }
        let bend = acos((0.590^2 + 1.1051^2 - 0.5221^2)/(2*0.590*1.1051));
        let knee = acos((0.8966^2 + 0.8966^2 - 1.732^2)/(2*0.8966*0.8966));
        repeat s in 0..2 {
            // The right side is the image of the left: angles from the other side, and y of the body turned over.
            let side = 1 - 2*s;
            let flip = s*180 deg;
            body rod[s] {
                mass: 1 kg; inertia: 0.1 kg*m^2; port pin: (0, 0) m; port elbow: (0.590, 0) m;
                port knee: (1.1051*cos(bend), -1.1051*side*sin(bend)) m; start angle: flip + side*180 deg;
            }
            body low[s] {
                mass: 0.3 kg; inertia: rod(0.3 kg, 0.32 m); port axle: (0, 0) m; port elbow: (0.3206, 0) m;
                start x: -0.59 m*side; start y: -0.176 m; start angle: flip + side*33 deg;
            }
            body high[s] {
                mass: 0.5 kg; inertia: rod(0.5 kg, 0.52 m); port axle: (0, 0) m; port hip: (0.5177, 0) m;
                start x: -0.233 m*side; start y: 0.616 m; start angle: flip + side*135 deg;
            }
            body leg[s] {
                mass: 1 kg; inertia: 0.2 kg*m^2; port knee: (0, 0) m; port hip: (0.8966, 0) m;
                port foot: (0.8966*cos(knee), -0.8966*side*sin(knee)) m; start x: -0.83 m*side; start angle: flip + side*75 deg;
            }
            revolute a[s](crank.pin[s], rod[s].pin);
            revolute b[s](ground.deep[s], low[s].axle);
            revolute c[s](rod[s].elbow, low[s].elbow);
            revolute d[s](ground.high[s], high[s].axle);
            revolute e[s](rod[s].knee, leg[s].knee);
            revolute f[s](high[s].hip, leg[s].hip);
        }
        output leg[0].foot.position, leg[1].foot.position;
    }
}

/// A run as the command line asks for it; as a program of its own: `Program::new(Klann::new()).until(4.0).every(0.01).main()`.
pub fn program(options: &Options) -> Result<(), Box<dyn Error>> {
    Program::new(Klann::new()).until(4.0).every(0.01).with(options)
}
