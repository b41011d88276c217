//! How far is a press off at 60 deg of its crank, if its lengths are off by their tolerances?
use std::error::Error;

use plm::{Dual, Fault, Real};

use super::{Answer, Answers};

plm::mechanism! {
    /// An offset slider-crank.
    pub Press {
        param radius = 40 mm;
        param length = 120 mm;
        param offset = 10 mm;
        param angle = 60 deg;
        ground { port main: (0, 0) mm; port rail: (0 m, offset); }
        body crank { port main: (0, 0) mm; port pin: (radius, 0 m); start angle: angle; }
        body rod { port pin: (0, 0) mm; port end: (length, 0 m); }
        body ram { port end: (0, 0) mm; start x: length; }
        revolute main(ground.main, crank.main);
        revolute pin(crank.pin, rod.pin);
        revolute end(rod.end, ram.end);
        prismatic rail(ground.rail, ram.end);
        constraint hold: crank.angle = angle;
        output ram.x;
    }
}

/// The place of the ram, m, in numbers of any kind.
fn place<S: Real>([radius, length, offset, angle]: [S; 4]) -> Result<S, Fault> {
    let mut press = Press::<S>::of();
    (press.radius, press.length, press.offset, press.angle) = (radius, length, offset, angle);
    Ok(press.start()?.ram_x())
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // In m and rad; a tolerance is three standard deviations.
    let nominal = [0.04, 0.12, 0.01, 60_f64.to_radians()];
    let tolerances = [0.02e-3, 0.05e-3, 0.05e-3, 0.1_f64.to_radians()];
    let Dual { value, tangents } = place(std::array::from_fn(|k| Dual::<f64, 4>::variable(nominal[k], k)))?;
    let parts: [f64; 4] = std::array::from_fn(|k| tangents[k] * tolerances[k]);
    // A thousand presses. Twelve equally likely numbers (Park and Miller's generator) have a sum that is as good as normal.
    let mut seed = 1_u64;
    let mut uniform = || {
        seed = seed * 16807 % 2_147_483_647;
        seed as f64 / 2_147_483_647.0
    };
    let mut normal = || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    let mut squares = 0.0;
    for _ in 0..1000 {
        let off = place(std::array::from_fn(|k| nominal[k] + normal() * tolerances[k] / 3.0))? - value;
        squares += off * off / 1000.0;
    }
    let deviations = parts.iter().map(|part| part * part).sum::<f64>().sqrt();
    Ok(vec![
        Answer::new("place of the ram", value * 1e3, "mm"),
        Answer::new("all tolerances at their worst", parts.map(f64::abs).iter().sum::<f64>() * 1e3, "mm"),
        Answer::new("three deviations, by gradients", deviations * 1e3, "mm"),
        Answer::new("three deviations of 1000 presses", 3.0 * squares.sqrt() * 1e3, "mm"),
    ])
}
