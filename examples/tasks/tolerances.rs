//! How far is a press off at 60 deg of its crank, if its lengths are off by their tolerances?
use std::error::Error;

use plm::Real;
use plm::synthesis::tolerance::{Dimension, Distribution, Quantity, monte_carlo, stack};

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
struct Place;

impl Quantity<4> for Place {
    fn value<S: Real>(&self, [radius, length, offset, angle]: [S; 4]) -> Option<S> {
        let mut press = Press::<S>::of();
        (press.radius, press.length, press.offset, press.angle) = (radius, length, offset, angle);
        Some(press.start().ok()?.ram_x())
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // In m and rad; a tolerance is three standard deviations.
    let dimension =
        |name, nominal, tolerance| Dimension { name, nominal, tolerance, distribution: Distribution::Normal };
    let dimensions = [
        dimension("radius", 40e-3, 0.02e-3),
        dimension("length", 120e-3, 0.05e-3),
        dimension("offset", 10e-3, 0.05e-3),
        dimension("angle", 60_f64.to_radians(), 0.1_f64.to_radians()),
    ];
    let stack = stack(&Place, &dimensions).ok_or("the press does not close")?;
    let squares: f64 = stack.contributions.iter().map(|part| part.worst * part.worst).sum();
    let presses = monte_carlo(&Place, &dimensions, 1000, 1);
    Ok(vec![
        Answer::new("place of the ram", stack.nominal * 1e3, "mm"),
        Answer::new("all tolerances at their worst", stack.worst * 1e3, "mm"),
        Answer::new("three deviations, by gradients", squares.sqrt() * 1e3, "mm"),
        Answer::new("three deviations of 1000 presses", 3.0 * presses.deviation * 1e3, "mm"),
    ])
}
