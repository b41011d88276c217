//! When a double pendulum first turns over, for 100 000 starts from rest: bars of 1 m and 1 kg, no friction, 10 s at most. Made of the
//! times, the picture is a fractal (J. S. Heyl, The double pendulum fractal, 2008).
//!
//! `--shard 3/64` runs a part of it, `--submit slurm --shards 64` hands all of them to a cluster, `--merge fractal.npy` makes one
//! table; `--help` tells the rest. A start with 3 cos a + cos b > 2 has too little energy to turn over; the other column is
//! what the energy of a run has changed by.

use std::f64::consts::PI;
use std::process::ExitCode;

use plm::Sim;
use plm::study::{Points, Study, linear};

plm::mechanism! {
    /// Two bars, hanging from a pivot.
    pub Bars {
        gravity: 9.81 m/s^2;
        ground { port o: (0, 0) m; }
        body upper { mass: 1 kg; inertia: 1 kg*m^2/12; port o: (0, 0.5) m; port p: (0, -0.5) m; start angle: 0, locked; }
        body lower { mass: 1 kg; inertia: 1 kg*m^2/12; port p: (0, 0.5) m; start angle: 0, locked; }
        revolute shoulder(ground.o, upper.o);
        revolute elbow(upper.p, lower.p);
        output upper.angle, lower.angle;
    }
}

/// How long a run is, and how often it is looked at, s.
const UNTIL: f64 = 10.0;
const EVERY: f64 = 0.05;

/// When it has turned over (NaN: it has not), s, and the change of energy, J.
fn first_turn([a, b]: [f64; 2]) -> Result<[f64; 2], plm::Fault> {
    let mut bars = Bars::new();
    bars.start.upper.angle.value = a.to_radians();
    bars.start.lower.angle.value = b.to_radians();
    let mut sim = bars.start()?;
    let energy = sim.kinetic_energy() + sim.gravity_energy();
    let change = |sim: &Sim<Bars>| sim.kinetic_energy() + sim.gravity_energy() - energy;
    for look in 1..=(UNTIL / EVERY).round() as u32 {
        let time = f64::from(look) * EVERY;
        sim.step_to(time)?;
        if sim.upper_angle().abs() > PI || sim.lower_angle().abs() > PI {
            return Ok([time, change(&sim)]);
        }
    }
    Ok([f64::NAN, change(&sim)])
}

fn main() -> ExitCode {
    let angles = |count| linear(-180.0, 180.0, count);
    let points = Points::grid([("a", "deg", angles(400)), ("b", "deg", angles(250))]);
    let columns = [("turns_over", "s"), ("energy_change", "J")];
    Study::new("double_pendulums", points, columns, first_turn).revision("10 s, looked at every 50 ms").main()
}
