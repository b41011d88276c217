//! Hardware in the loop, in small: a program of the user's own holds a pendulum upright by a motor, against the clock, and serves
//! the page that shows it.
//!
//! ```sh
//! cargo run --release --example served                   # prints the address of the page
//! cargo run --release --example served -- --serve=8765   # at a port of choice, which the page finds again
//! cargo run --release --example served -- --gain 4       # a controller that is too weak
//! ```
//!
//! The mechanism stands for the hardware: the controller reads its angle every 5 ms and sets its motor. The sliders of the page
//! set the angle that is asked for, and the load, while it runs. In place of the simulation could be a board that sends what it
//! measures; in place of the controller one that is tested.

use std::error::Error;

use plm::view::{Known, Options, Server};

plm::mechanism! {
    /// A pendulum with a motor, which holds it at the angle that is asked for.
    pub Upright {
        gravity: 9.81 m/s^2;
        /// The mass of the rod with what it carries.
        param load: kg = 1 kg;
        /// The angle that is asked for, from the vertical.
        input wanted: deg = 0;
        /// What the motor does: the controller sets it.
        input motor: N*m = 0;
        ground { port o: (0, 0) m; }
        body rod {
            mass: load;
            inertia: 0.02 kg*m^2;
            port pivot: (0, -0.5) m;
            port tip: (0, 0.2) m;
            start angle: 20 deg, locked;
        }
        revolute hinge(ground.o, rod.pivot) { drive: motor; damping: 0.05 N*m*s/rad; }
        output rod.angle in deg, motor, wanted in deg;
    }
}

/// The controller reads and sets so often, s.
const TURN: f64 = 0.005;
/// More the motor cannot give, N*m.
const STRONGEST: f64 = 15.0;

/// A controller with a proportional and a derivative part.
struct Controller {
    gain: f64,
}

impl Controller {
    /// The torque of the motor, N*m, at an angle and its rate, rad and rad/s.
    fn torque(&self, wanted: f64, angle: f64, omega: f64) -> f64 {
        (self.gain * (wanted - angle) - 0.15 * self.gain * omega).clamp(-STRONGEST, STRONGEST)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let gain = Known::value("gain", "NUMBER", "of the controller, N*m/rad; 60 if nothing is said");
    let other = ["view", "live", "out", "csv", "svg", "every", "method"];
    let options = Options::table().without(&other).with(&[gain]).from_args()?;
    if let Some(help) = &options.help {
        println!("{help}");
        return Ok(());
    }
    let controller = Controller { gain: options.own.number("gain")?.unwrap_or(60.0) };
    let mut mechanism = Upright::new();
    options.apply(&mut mechanism)?;
    let mut sim = mechanism.start()?;
    options.apply_inputs(&mut sim)?;
    let mut server = Server::start(&sim, options.serve.unwrap_or(0))?;
    println!("serving {} (Ctrl+C ends it)", server.url());
    while sim.time() < options.until.unwrap_or(f64::INFINITY) {
        server.obey(&mut sim);
        if server.wait_for_step(TURN) {
            let rod = sim.rod();
            sim.input.motor = controller.torque(sim.input.wanted, rod.angle, rod.omega);
            match sim.step(TURN) {
                Ok(()) => server.show(&sim),
                Err(fault) => server.stop(&fault),
            }
        }
    }
    Ok(())
}
