//! Loops under extreme data: masses, speeds.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

use plm::{Fault, Method, Stats};

use super::theory;

plm::mechanism! {
    /// A beam of 1 kg that swings on two bars of 1 m, from 45 deg; the mass of the bars is a parameter.
    pub Swing {
        param bars: kg = 1 kg;
        gravity: 9.81 m/s^2;
        ground { port a: (0, 0) m; port d: (1, 0) m; }
        body left {
            mass: bars;
            inertia: bars*(1 m)^2/12;
            port high: (-0.5, 0) m;
            port low: (0.5, 0) m;
            start angle: -45 deg, locked;
            start omega: 0, locked;
        }
        body right {
            mass: bars;
            inertia: bars*(1 m)^2/12;
            port high: (-0.5, 0) m;
            port low: (0.5, 0) m;
            start x: 1 m;
            start angle: -45 deg;
        }
        body beam {
            mass: 1 kg;
            inertia: 1 kg*m^2/12;
            port a: (-0.5, 0) m;
            port b: (0.5, 0) m;
            start x: 1.2 m;
            start y: -0.7 m;
        }
        revolute hinge_a(ground.a, left.high);
        revolute hinge_d(ground.d, right.high);
        revolute pin_a(left.low, beam.a);
        revolute pin_b(right.low, beam.b);
    }
}

plm::mechanism! {
    /// The slider-crank S6 without gravity and torque: it runs freely at the speed that it starts with.
    pub FastCrank {
        ground { port o: (0, 0) m; }
        body crank {
            mass: 0.2 kg;
            inertia: 0.2 kg*(0.2 m)^2/12;
            port o: (-0.1, 0) m;
            port pin: (0.1, 0) m;
            start angle: 60 deg, locked;
            start omega: 1e4 rad/s, locked;
        }
        body rod {
            mass: 0.6 kg;
            inertia: 0.018 kg*m^2;
            port pin: (-0.3, 0) m;
            port wrist: (0.3, 0) m;
            start angle: -17 deg;
        }
        body slider { mass: 0.5 kg; inertia: 0.001 kg*m^2; port wrist: (0, 0) m; start x: 0.67 m; }
        revolute drive(ground.o, crank.o);
        revolute crank_pin(crank.pin, rod.pin);
        revolute wrist_pin(rod.wrist, slider.wrist);
        prismatic guide(ground.o, slider.wrist);
    }
}

/// Angle of the swing (rad) from the vertical after 5/4 periods; the known value is 0. And what was done.
pub fn swung<I: Method<Swing>>(bars: f64, method: I) -> Result<(f64, Stats), Fault> {
    let mut sim = Swing { bars, ..Swing::new() }.start_with(method)?;
    sim.step(1.25 * theory::swing_period(bars))?;
    Ok((sim.left().angle + FRAC_PI_2, sim.stats()))
}

/// Angle of a crank that starts at a speed (rad/s), less that of so many whole turns, rad; and relative change of the energy.
pub fn whirled<I: Method<FastCrank>>(speed: f64, turns: u32, method: I) -> Result<[f64; 2], Fault> {
    let mut mechanism = FastCrank::new();
    mechanism.start.crank.omega.value = speed;
    let mut sim = mechanism.start_with(method)?;
    let energy = sim.kinetic_energy();
    sim.step(f64::from(turns) * theory::slider_crank_turn(speed, FRAC_PI_3))?;
    Ok([sim.crank().angle - FRAC_PI_3 - f64::from(turns) * TAU, sim.kinetic_energy() / energy - 1.0])
}
