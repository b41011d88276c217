//! Which four-bar turns the dial of a pressure into that of a flow, its square root, and how far is it off?
use std::error::Error;

use plm::synthesis::function::{Pair, Scales, chebyshev, generators};

use super::{Answer, Answers};

plm::mechanism! {
    /// A four-bar linkage on a base of 100 mm.
    pub Dials {
        param crank = 60 mm;
        param coupler = 150 mm;
        param rocker = 70 mm;
        param angle = 100 deg;
        ground { port pressure: (0, 0) mm; port flow: (100, 0) mm; }
        body input { port axle: (0, 0) mm; port pin: (crank, 0 mm); start angle: 100 deg; }
        body link { port pin: (0, 0) mm; port wrist: (coupler, 0 mm); }
        body pointer { port axle: (0, 0) mm; port wrist: (rocker, 0 mm); start x: 100 mm; start angle: 50 deg; }
        revolute pressure(ground.pressure, input.axle);
        revolute pin(input.pin, link.pin);
        revolute wrist(link.wrist, pointer.wrist);
        revolute flow(ground.flow, pointer.axle);
        constraint dial: input.angle = angle;
    }
}

/// Angles of both dials, rad, for a pressure between 1/4 and 1 of its greatest: 60 deg each.
fn dials(pressure: f64) -> Pair {
    Pair {
        crank: (70.0 + 80.0 * (pressure - 0.25)).to_radians(),
        rocker: (20.0 + 120.0 * (pressure.sqrt() - 0.5)).to_radians(),
    }
}

pub fn run() -> Result<Answers, Box<dyn Error>> {
    // Exact at three points in Chebyshev's spacing (Freudenstein).
    let points = chebyshev(3, 0.25, 1.0);
    let pairs: Vec<Pair> = points.iter().copied().map(dials).collect();
    let found = generators(&pairs, 0.1, Scales::Given)?.swap_remove(0);
    let [_, crank, coupler, rocker] = found.four_bar.lengths();

    let error = |pressure: f64| -> Result<f64, plm::Fault> {
        let Pair { crank: angle, rocker: pointer } = dials(pressure);
        let sim = Dials { crank, coupler, rocker, angle, ..Dials::new() }.start()?;
        Ok((sim.pointer().angle - pointer).abs().to_degrees())
    };
    let largest = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let at_points = points.into_iter().map(error).collect::<Result<Vec<_>, _>>()?;
    let between =
        (25..=100).map(|percent| error(f64::from(percent) / 100.0)).collect::<Result<Vec<_>, _>>()?;
    Ok(vec![
        Answer::new("length of the crank", crank * 1e3, "mm"),
        Answer::new("length of the coupler", coupler * 1e3, "mm"),
        Answer::new("length of the pointer", rocker * 1e3, "mm"),
        Answer::new("error at the three points", largest(&at_points), "deg"),
        Answer::new("greatest error between", largest(&between), "deg"),
    ])
}
