//! How long does a disc brake take to stop a flywheel, how warm does it get, and how much faster is a drum brake?
use std::error::Error;

use super::{Answer, Answers};

plm::mechanism! {
    /// Two equal flywheels: linings press on a disc, and shoes with the same force on a drum.
    pub Brakes {
        param force = 2 kN;
        rotor first() { inertia: 4 kg*m^2; start_speed: 1500 rev/min; }
        brake disc(first.shaft) { force: force; friction: 0.35; radius: 110 mm; }
        rotor second() { inertia: 4 kg*m^2; start_speed: 1500 rev/min; }
        drum_brake drum(second.shaft) {
            force: force; radius: 150 mm; pivot_radius: 120 mm; arm: 220 mm;
            begin: 20 deg; end: 130 deg; friction: 0.35;
        }
        state heat: J = 0;
        rate heat = disc.lost;
        discrete first_stops: s = 0;
        discrete second_stops: s = 0;
        when first.speed <= 0 { first_stops = t; }
        when second.speed <= 0 { second_stops = t; }
        // Steel, 3 kg, that keeps all heat.
        output first_stops, second_stops, first.angle, drum.torque, heat, warmer = heat/(3 kg*470 J/(kg*K));
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let mut sim = Brakes::new().start()?;
    let torque = sim.drum_torque();
    sim.step(10.0)?;
    Ok(vec![
        Answer::new("the disc brake stops after", sim.first_stops(), "s"),
        Answer::new("turns until then", sim.first_angle() / std::f64::consts::TAU, "rev"),
        Answer::new("heat", sim.heat(), "J"),
        Answer::new("the disc gets warmer by", sim.warmer(), "K"),
        Answer::new("torque of the drum brake", -torque, "N*m"),
        Answer::new("the drum brake stops after", sim.second_stops(), "s"),
    ])
}
