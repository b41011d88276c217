//! A cart swings its pole up with the least effort, by the numbers of M. Kelly (An Introduction to Trajectory Optimization, SIAM Review 59,
//! 2017, section 6).

use std::error::Error;
use std::f64::consts::PI;

use plm::Fault;
use plm::optimise::{Control, Optimum};
use plm_view::{Axis, Chart, Series};

plm::mechanism! {
    /// A cart with a pole that hangs.
    pub CartPole {
        input push: N = 0 N;
        gravity: 9.81 m/s^2;
        ground { port rail: (0, 0) m; }
        body cart { mass: 1 kg; inertia: 1 kg*m^2; port rail: (0, 0) m; port pin: (0, 0) m; start x: 0 m, locked; start vx: 0 m/s, locked; }
        body pole {
            mass: 0.3 kg; inertia: 1e-9 kg*m^2; port pin: (0, 0.5) m;
            start angle: 0 rad, locked; start omega: 0 rad/s, locked;
        }
        prismatic rail(ground.rail, cart.rail) { drive: push; }
        revolute pin(cart.pin, pole.pin);
        output cart.x, cart.vx, pole.angle in deg, pole.omega;
    }
}

pub fn best() -> Result<Optimum, Box<dyn Error>> {
    let best = Control::new(CartPole::new(), 20)
        .duration(2.0)
        .input("push", -20.0, 20.0)
        .effort("push", 1.0)
        .within("cart.x", -2.0, 2.0)
        .at_end("cart.x", 1.0)
        .at_end("cart.vx", 0.0)
        .at_end("pole.angle", PI)
        .at_end("pole.omega", 0.0)
        .run()?;
    Ok(best)
}

/// The forces that [`best`] finds, N.
pub const FORCES: [f64; 20] = [
    -4.9143, -0.1159, 4.3085, 7.5602, 8.6706, 6.4516, 2.7381, 0.1170, -1.7711, -4.7301, -9.9607, -12.4212,
    -4.7251, 2.2982, 4.5246, 4.1976, 2.8952, 1.0947, -1.3317, -4.8860,
];

/// Place and angle over time with these forces, by a run of its own.
fn motion() -> Result<[Vec<(f64, f64)>; 2], Fault> {
    let mut sim = CartPole::new().start()?;
    let [mut places, mut angles] = [vec![(0.0, 0.0)], vec![(0.0, 0.0)]];
    for (k, force) in FORCES.into_iter().enumerate() {
        sim.input.push = force;
        for part in 1..=5 {
            sim.step_to(0.1 * (k as f64 + 0.2 * f64::from(part)))?;
            places.push((sim.time(), sim.cart_x()));
            angles.push((sim.time(), sim.pole_angle().to_degrees()));
        }
    }
    Ok([places, angles])
}

pub fn picture() -> Result<String, Box<dyn Error>> {
    let [places, angles] = motion()?;
    let forces = FORCES.into_iter().enumerate();
    let forces = forces.flat_map(|(k, force)| [0, 1].map(|end| (0.1 * (k + end) as f64, force)));
    let chart = Chart::rows(Axis::linear("time", "s").tight())
        .titled("Swing-up of a pole in 2 s with the least effort")
        .below(Axis::linear("push", "N"))
        .with(Series::new("push", forces))
        .below(Axis::linear("cart.x", "m"))
        .with(Series::new("cart.x", places))
        .below(Axis::linear("pole.angle", "deg"))
        .with(Series::new("pole.angle", angles));
    Ok(chart.to_svg())
}
