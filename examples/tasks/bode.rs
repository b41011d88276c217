//! Where is the resonance of a drive with an elastic coupling, how large is it, and where does its motor stand still?
use std::error::Error;
use std::f64::consts::TAU;

use super::{Answer, Answers};

plm::mechanism! {
    /// A motor, a coupling that gives way, and what it drives.
    pub Drive {
        input torque: N*m = 0;
        rotor motor() { inertia: 0.02 kg*m^2; drive: torque; }
        rotor load() { inertia: 0.1 kg*m^2; }
        shaft_spring coupling(motor.shaft, load.shaft) { stiffness: 500 N*m/rad; damping: 0.2 N*m*s; }
        output motor.speed;
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    let system = plm::linearise(&Drive::new().start()?)?;
    // 1 to 100 Hz in steps of 0.1 %: gain and phase of all of them are the curves that `bode` gives.
    let (mut peak, mut notch) = ((0.0, 0.0), (0.0, f64::INFINITY));
    let mut frequency = 1.0;
    while frequency < 100.0 {
        let gain = system.response("torque", "motor.speed", TAU * frequency)?.norm();
        peak = if gain > peak.1 { (frequency, gain) } else { peak };
        notch = if gain < notch.1 { (frequency, gain) } else { notch };
        frequency *= 1.001;
    }
    let slow = system.response("torque", "motor.speed", TAU)?;
    Ok(vec![
        Answer::new("gain at 1 Hz", slow.norm(), "rad/s/(N*m)"),
        Answer::new("phase at 1 Hz", slow.arg().to_degrees(), "deg"),
        Answer::new("the motor stands still at", notch.0, "Hz"),
        Answer::new("resonance at", peak.0, "Hz"),
        Answer::new("gain there", peak.1, "rad/s/(N*m)"),
        Answer::new("damping ratio of the mode", system.modes()[3].damping, ""),
    ])
}
